//! The named bodies of steel: hammer, wing nut, T-handle. Where their sizes come from stands at
//! [`super::NamedBody`].

use super::{Fill, Part, Section};
use nalgebra::Vector3;

/// Density of steel, kg/m³: a textbook value.
const STEEL: f64 = 7850.0;

/// Density of ash wood, kg/m³: a textbook value; real handles differ by a tenth either way.
const ASH: f64 = 680.0;

fn steel(name: &'static str, section: Section, middle: Vector3<f64>, along: Vector3<f64>) -> Part {
    Part::new([name, "steel"], section, middle, along, Fill::Density(STEEL))
}

fn along_x(x: f64) -> Vector3<f64> {
    Vector3::new(x, 0.0, 0.0)
}

fn along_z(z: f64) -> Vector3<f64> {
    Vector3::new(0.0, 0.0, z)
}

pub(super) fn hammer(put: &mut dyn FnMut(Part)) {
    let (handle, side) = (0.290, 0.032);
    let (round, ash) = (Section::Round { radius: 0.0145 }, Fill::Density(ASH));
    put(Part::new(["handle", "ash"], round, along_z(0.5 * handle), along_z(handle), ash));
    let head = Section::Rectangle { wide: 0.100, thick: side };
    put(steel("head", head, along_z(handle + 0.5 * side), along_z(side)));
}

pub(super) fn wing_nut(put: &mut dyn FnMut(Part)) {
    let (radius, height, top, span) = (0.00825, 0.0068, 0.0177, 0.0362);
    let (wing_height, reach) = (0.0118, 0.5 * span - radius);
    let boss = Section::Ring { inner: 0.0045, outer: radius };
    put(steel("boss", boss, along_x(0.5 * height), along_x(height)));
    let wing = Section::Rectangle { wide: wing_height, thick: 0.0033 };
    for side in [1.0, -1.0] {
        let middle = Vector3::new(top - 0.5 * wing_height, 0.0, side * (radius + 0.5 * reach));
        put(steel("wing", wing, middle, along_z(reach)));
    }
}

pub(super) fn t_handle(put: &mut dyn FnMut(Part)) {
    let (radius, stem) = (0.006, 0.050);
    let rod = Section::Round { radius };
    put(steel("crossbar", rod, Vector3::zeros(), along_z(0.100)));
    put(steel("stem", rod, along_x(radius + 0.5 * stem), along_x(stem)));
}
