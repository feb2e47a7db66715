//! Tensors, from numbers, shapes and meshes.

use crate::arrays::{Array, Numbers, array, row, slice};
use crate::error::{Answer, Refused};
use nalgebra::{Matrix3, Vector3};
use numpy::PyUntypedArrayMethods;
use pyo3::prelude::*;
use tumbling::MassProperties;
use tumbling::solid::{
    Ball, Capsule, Cone, Cuboid, Cylinder, Ellipsoid, Mesh, Solid, ThinDisk, ThinPlate, ThinRod,
};

/// The inertia tensor of a body, kg m², along its own axes: from three moments, or from a 3 x 3 matrix whose
/// products have the sign for which L = I w.
///
/// Tensors made from a shape or a mesh are about the centre of mass, and have `mass` and `centre`. Every
/// argument `inertia` also accepts plain numbers.
///
/// Raises `Error` for a tensor that no distribution of mass has.
///
/// >>> import numpy as np, tumbling
/// >>> box = tumbling.Inertia.cuboid(2, 1, 3, mass=12)
/// >>> assert np.array_equal(box.tensor, np.diag([10, 13, 5]))
/// >>> assert np.array_equal(box.moments, [5, 10, 13]) and box.mass == 12
#[pyclass(frozen, module = "tumbling")]
pub struct Inertia {
    tensor: tumbling::Inertia,
    whole: Option<MassProperties>,
}

impl Inertia {
    fn of(whole: MassProperties) -> Self {
        Self { tensor: whole.inertia(), whole: Some(whole) }
    }

    fn filled(solid: &impl Solid, mass: Option<f64>, density: Option<f64>) -> Answer<Self> {
        match (mass, density) {
            (Some(mass), None) => Ok(Self::of(solid.with_mass(mass)?)),
            (None, Some(density)) => Ok(Self::of(solid.with_density(density)?)),
            _ => Err(Refused::new("Undefined", "the mass", "give either the mass or the density".into())),
        }
    }
}

fn tensor(numbers: &Numbers<'_>) -> Answer<tumbling::Inertia> {
    if numbers.shape() == [3, 3] {
        return Ok(Matrix3::from_row_slice(&slice(numbers)).try_into()?);
    }
    let [a, b, c] = row("inertia", numbers)?;
    Ok(tumbling::Inertia::from_moments(a, b, c)?)
}

/// A tensor argument: an `Inertia` or its numbers.
pub struct Given(pub tumbling::Inertia);

impl<'a, 'py> FromPyObject<'a, 'py> for Given {
    type Error = PyErr;

    fn extract(given: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(inertia) = given.cast::<Inertia>() {
            return Ok(Self(inertia.get().tensor));
        }
        Ok(Self(tensor(&given.extract()?)?))
    }
}

#[pymethods]
impl Inertia {
    #[new]
    fn new(inertia: Given) -> Self {
        Self { tensor: inertia.0, whole: None }
    }

    /// A closed mesh of uniform density: vertices (n, 3) in m; faces (m, 3), each with the indices of three
    /// vertices from 0, counter-clockwise seen from outside; mass in kg, or density in kg/m³.
    ///
    /// Raises `Error` if the faces do not bound a solid.
    ///
    /// >>> import tumbling
    /// >>> corner = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 6]]
    /// >>> faces = [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]]
    /// >>> assert list(tumbling.Inertia.mesh(corner, faces, mass=2).centre) == [1, 1, 1.5]
    #[staticmethod]
    #[pyo3(signature = (vertices, faces, *, mass=None, density=None))]
    fn mesh(
        vertices: Numbers<'_>,
        faces: Numbers<'_>,
        mass: Option<f64>,
        density: Option<f64>,
    ) -> Answer<Self> {
        let (vertices, _) = crate::arrays::rows::<3>("vertices", &vertices)?;
        let vertices: Vec<_> = vertices.into_iter().map(Vector3::from).collect();
        let (faces, _) = crate::arrays::rows::<3>("faces", &faces)?;
        if let Some(bad) = faces.iter().flatten().find(|i| i.fract() != 0.0 || **i < 0.0) {
            return Err(Refused::new("Undefined", "faces", format!("{bad} is no vertex's number")));
        }
        let faces: Vec<_> = faces.into_iter().map(|face| face.map(|i| i as usize)).collect();
        Self::filled(&Mesh::new(&vertices, &faces)?, mass, density)
    }

    /// The 3 x 3 matrix, kg m².
    #[getter]
    fn tensor<'py>(&self, py: Python<'py>) -> Answer<Array<'py>> {
        array(py, self.tensor.matrix().as_slice().to_vec(), &[3, 3], &[])
    }

    /// The principal moments, kg m², in ascending order.
    #[getter]
    fn moments<'py>(&self, py: Python<'py>) -> Answer<Array<'py>> {
        array(py, self.tensor.principal().moments().as_slice().to_vec(), &[3], &[])
    }

    /// The principal axes in body axes: the columns of a 3 x 3 rotation matrix, in the order of the moments.
    #[getter]
    fn axes<'py>(&self, py: Python<'py>) -> Answer<Array<'py>> {
        array(py, self.tensor.principal().frame().transpose().as_slice().to_vec(), &[3, 3], &[])
    }

    /// The mass, kg; None if the tensor was given by its numbers.
    #[getter]
    fn mass(&self) -> Option<f64> {
        self.whole.map(|whole| whole.mass())
    }

    /// The centre of mass, m, in the axes of the shape; None if the tensor was given by its numbers.
    #[getter]
    fn centre<'py>(&self, py: Python<'py>) -> Answer<Option<Array<'py>>> {
        self.whole.map(|whole| array(py, whole.centre().as_slice().to_vec(), &[3], &[])).transpose()
    }

    /// The tensor about another point (m, in the axes of the shape), for example that of a top about its tip.
    ///
    /// Raises `Error` if the mass is not known.
    ///
    /// >>> import tumbling
    /// >>> rod = tumbling.Inertia.rod(3, mass=2).about([0, 0, 1.5])
    /// >>> assert list(rod.tensor.diagonal()) == [6, 6, 0]
    fn about(&self, point: Numbers<'_>) -> Answer<Self> {
        let Some(whole) = self.whole else {
            let sentence = "the mass is not known: the tensor was given by its numbers".into();
            return Err(Refused::new("Undefined", "the mass", sentence));
        };
        Ok(Self { tensor: whole.about(&row("point", &point)?.into())?, whole: None })
    }

    fn __repr__(&self) -> String {
        let m = self.tensor.matrix();
        let rows = [0, 1, 2].map(|i| format!("[{:?}, {:?}, {:?}]", m[(i, 0)], m[(i, 1)], m[(i, 2)]));
        format!("Inertia([{}])", rows.join(", "))
    }
}

/// A static method for each shape.
macro_rules! shapes {
    ($($(#[$doc:meta])* $name:ident($($size:ident),*) = $make:path;)*) => {
        #[pymethods]
        impl Inertia {
            $($(#[$doc])*
            #[staticmethod]
            #[pyo3(signature = ($($size,)* *, mass=None, density=None))]
            fn $name($($size: f64,)* mass: Option<f64>, density: Option<f64>) -> Answer<Self> {
                Self::filled(&$make($($size),*)?, mass, density)
            })*
        }
    };
}

shapes! {
    /// A box by its edges along x, y and z, m; mass in kg, or density in kg/m³.
    cuboid(a, b, c) = Cuboid::new;
    /// A ball by its radius, m; mass in kg, or density in kg/m³.
    ball(radius) = Ball::new;
    /// A hollow ball by its radii, m; mass in kg, or density in kg/m³.
    hollow_ball(inner, outer) = Ball::hollow;
    /// A cylinder about z, m; mass in kg, or density in kg/m³.
    cylinder(radius, height) = Cylinder::new;
    /// A hollow cylinder about z, m; mass in kg, or density in kg/m³.
    hollow_cylinder(inner, outer, height) = Cylinder::hollow;
    /// A cone about z with its base in the plane z = 0, m; mass in kg, or density in kg/m³.
    cone(radius, height) = Cone::new;
    /// A capsule about z by its radius and the length of its cylinder, m; mass in kg, or density in kg/m³.
    capsule(radius, length) = Capsule::new;
    /// An ellipsoid by its semi-axes along x, y and z, m; mass in kg, or density in kg/m³.
    ellipsoid(a, b, c) = Ellipsoid::new;
    /// A thin rod along z, m; mass in kg, or density in kg/m.
    rod(length) = ThinRod::new;
    /// A thin plate in the plane of x and y, m; mass in kg, or density in kg/m².
    plate(a, b) = ThinPlate::new;
    /// A thin disk about z, m; mass in kg, or density in kg/m².
    disk(radius) = ThinDisk::new;
}
