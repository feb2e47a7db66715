//! The solids of the library by their names in a file.

use crate::surface::Surface;
use nalgebra::Vector3;
use tumbling::solid::{
    Ball, Capsule, Cone, Cuboid, Cylinder, Ellipsoid, Solid, Tetrahedron, ThinDisk, ThinPlate, ThinRod,
};
use tumbling::{Error, MassProperties};

/// What a shape weighs.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Weight {
    /// kg.
    Mass(f64),
    /// kg/m³; kg/m² of what is thin, kg/m of a thin rod.
    Density(f64),
}

impl Weight {
    pub(crate) fn of(self, solid: &impl Solid) -> Result<MassProperties, Error> {
        match self {
            Self::Mass(mass) => solid.with_mass(mass),
            Self::Density(density) => solid.with_density(density),
        }
    }
}

/// A shape's name, and the fields of its sizes; all but `inner` are needed.
pub(crate) struct Kind {
    pub(crate) name: &'static str,
    pub(crate) all: &'static [&'static str],
}

pub(crate) const KINDS: [Kind; 10] = [
    Kind { name: "box", all: &["sides"] },
    Kind { name: "ball", all: &["radius", "inner"] },
    Kind { name: "capsule", all: &["radius", "length"] },
    Kind { name: "cone", all: &["radius", "height"] },
    Kind { name: "cylinder", all: &["radius", "height", "inner"] },
    Kind { name: "disk", all: &["radius"] },
    Kind { name: "ellipsoid", all: &["semiaxes"] },
    Kind { name: "plate", all: &["sides"] },
    Kind { name: "rod", all: &["length"] },
    Kind { name: "tetrahedron", all: &["vertices"] },
];

/// The sizes that a file has, zero or empty where it has none, m.
#[derive(Debug, Default)]
pub(crate) struct Sizes {
    pub(crate) sides: Vec<f64>,
    pub(crate) radius: f64,
    pub(crate) inner: f64,
    pub(crate) height: f64,
    pub(crate) length: f64,
    pub(crate) semiaxes: [f64; 3],
    pub(crate) vertices: [[f64; 3]; 4],
}

/// How many sides a shape of this name has.
pub(crate) fn sides(name: &str) -> usize {
    if name == "plate" { 2 } else { 3 }
}

/// Mass properties and surface of the shape with this name, one of [`KINDS`].
pub(crate) fn shaped(name: &str, sizes: &Sizes, weight: Weight) -> Result<(MassProperties, Surface), Error> {
    let Sizes { radius, inner, height, length, .. } = *sizes;
    let side = |i: usize| sizes.sides.get(i).copied().unwrap_or_default();
    Ok(match name {
        "ball" if inner == 0.0 => {
            (weight.of(&Ball::new(radius)?)?, Surface::ellipsoid(&Vector3::repeat(radius)))
        }
        "ball" => (weight.of(&Ball::hollow(inner, radius)?)?, Surface::ellipsoid(&Vector3::repeat(radius))),
        "capsule" => (weight.of(&Capsule::new(radius, length)?)?, Surface::capsule(radius, length)),
        "cone" => (weight.of(&Cone::new(radius, height)?)?, Surface::cone(radius, height)),
        "cylinder" if inner == 0.0 => {
            (weight.of(&Cylinder::new(radius, height)?)?, Surface::cylinder(0.0, radius, height))
        }
        "cylinder" => {
            (weight.of(&Cylinder::hollow(inner, radius, height)?)?, Surface::cylinder(inner, radius, height))
        }
        "disk" => (weight.of(&ThinDisk::new(radius)?)?, Surface::disk(radius)),
        "ellipsoid" => {
            let [a, b, c] = sizes.semiaxes;
            (weight.of(&Ellipsoid::new(a, b, c)?)?, Surface::ellipsoid(&sizes.semiaxes.into()))
        }
        "plate" => (weight.of(&ThinPlate::new(side(0), side(1))?)?, Surface::plate(side(0), side(1))),
        "rod" => (weight.of(&ThinRod::new(length)?)?, Surface::line(length)),
        "tetrahedron" => {
            let vertices = sizes.vertices.map(Vector3::from);
            (weight.of(&Tetrahedron::new(vertices)?)?, Surface::tetrahedron(vertices))
        }
        _ => {
            let edges = Vector3::new(side(0), side(1), side(2));
            (weight.of(&Cuboid::new(edges.x, edges.y, edges.z)?)?, Surface::cuboid(&edges))
        }
    })
}
