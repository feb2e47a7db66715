//! The solids of the library by their names in a file.

use crate::file::number;
use crate::surface::Surface;
use crate::table::Table;
use nalgebra::Vector3;
use tumbling::solid::{
    Ball, Capsule, Cone, Cuboid, Cylinder, Ellipsoid, Solid, Tetrahedron, ThinDisk, ThinPlate, ThinRod,
};
use tumbling::{Error, MassProperties};

/// The mass of a shape, or its density.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Weight {
    /// kg.
    Mass(f64),
    /// kg/m³; kg/m² for a thin plate or disk, kg/m for a thin rod.
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

/// Each shape's name, the fields of its sizes (all but `inner` are needed), and what its density is in.
pub(crate) const KINDS: [(&str, &[&str], &str); 10] = [
    ("box", &["sides"], "kg/m³"),
    ("ball", &["radius", "inner"], "kg/m³"),
    ("capsule", &["radius", "length"], "kg/m³"),
    ("cone", &["radius", "height"], "kg/m³"),
    ("cylinder", &["radius", "height", "inner"], "kg/m³"),
    ("disk", &["radius"], "kg/m²"),
    ("ellipsoid", &["semiaxes"], "kg/m³"),
    ("plate", &["sides"], "kg/m²"),
    ("rod", &["length"], "kg/m"),
    ("tetrahedron", &["vertices"], "kg/m³"),
];

/// Mass properties and surface of the shape with this name, one of [`KINDS`], from the sizes in a table.
pub(crate) fn shaped(name: &str, table: &Table, weight: Weight) -> Result<(MassProperties, Surface), Error> {
    let sides = table.sides.as_ref().map_or(&[][..], |sides| sides.get_ref());
    let side = |i: usize| sides.get(i).copied().unwrap_or_default();
    let [radius, inner, height, length] =
        [&table.radius, &table.inner, &table.height, &table.length].map(number);
    Ok(match name {
        "ball" => {
            let ball = if inner == 0.0 { Ball::new(radius) } else { Ball::hollow(inner, radius) }?;
            (weight.of(&ball)?, Surface::ellipsoid(&Vector3::repeat(radius)))
        }
        "capsule" => (weight.of(&Capsule::new(radius, length)?)?, Surface::capsule(radius, length)),
        "cone" => (weight.of(&Cone::new(radius, height)?)?, Surface::cone(radius, height)),
        "cylinder" => {
            let hollow = || Cylinder::hollow(inner, radius, height);
            let cylinder = if inner == 0.0 { Cylinder::new(radius, height) } else { hollow() }?;
            (weight.of(&cylinder)?, Surface::cylinder(inner, radius, height))
        }
        "disk" => (weight.of(&ThinDisk::new(radius)?)?, Surface::disk(radius)),
        "ellipsoid" => {
            let axes = Vector3::from(table.semiaxes.as_ref().map(|axes| *axes.get_ref()).unwrap_or_default());
            (weight.of(&Ellipsoid::new(axes.x, axes.y, axes.z)?)?, Surface::ellipsoid(&axes))
        }
        "plate" => (weight.of(&ThinPlate::new(side(0), side(1))?)?, Surface::plate(side(0), side(1))),
        "rod" => (weight.of(&ThinRod::new(length)?)?, Surface::line(length)),
        "tetrahedron" => {
            let vertices = table.vertices.as_ref().map(|vertices| *vertices.get_ref()).unwrap_or_default();
            let vertices = vertices.map(Vector3::from);
            (weight.of(&Tetrahedron::new(vertices)?)?, Surface::tetrahedron(vertices))
        }
        _ => {
            let edges = Vector3::new(side(0), side(1), side(2));
            (weight.of(&Cuboid::new(edges.x, edges.y, edges.z)?)?, Surface::cuboid(&edges))
        }
    })
}
