//! The sizes of the named bodies. [`super::NamedBody`] states their sources.

use super::{Fill, Part, Section};
use crate::number::functions::sin_cos;
use core::f64::consts::TAU;
use nalgebra::Vector3;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// A body of one shape, evenly filled, about the origin: the shape's sizes in the order of its
/// [law](crate::solid::Shape), m, and the mass, kg.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::body::named::THE_BOX;
/// use tumbling::solid::{Cuboid, Shape};
/// let moments = Cuboid::moments(&THE_BOX.mass, THE_BOX.sizes.each_ref());
/// assert!((moments * 12.0 - Vector3::new(10.0, 13.0, 5.0)).amax() < 1e-14);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Even<const N: usize> {
    /// m.
    pub sizes: [f64; N],
    /// kg.
    pub mass: f64,
}

/// The edges along x, y and z of [the box](super::NamedBody::TheBox).
pub const THE_BOX: Even<3> = Even { sizes: [2.0, 1.0, 3.0], mass: 1.0 };

/// The edges along x, y and z of [the book](super::NamedBody::Book).
pub const BOOK: Even<3> = Even { sizes: [0.129, 0.020, 0.198], mass: 0.340 };

/// The edges along x, y and z of [the phone](super::NamedBody::Phone).
pub const PHONE: Even<3> = Even { sizes: [0.0716, 0.0078, 0.1476], mass: 0.171 };

pub(super) const REMOTE_CONTROL: Even<3> = Even { sizes: [0.035, 0.00925, 0.136], mass: 0.063 };

impl Even<3> {
    /// The box as the only part of a body.
    pub(super) fn part(&self, name: &'static str, material: &'static str) -> Part {
        let [wide, thick, length] = self.sizes;
        let (section, along) = (Section::Rectangle { wide, thick }, Vector3::new(0.0, 0.0, length));
        Part::new([name, material], section, Vector3::zeros(), along, Fill::Mass(self.mass))
    }
}

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

/// A thin bar from one `[x, z]` to another.
fn bar(name: &'static str, material: &'static str, mass: f64, from: [f64; 2], to: [f64; 2]) -> Part {
    let middle = Vector3::new(0.5 * (from[0] + to[0]), 0.0, 0.5 * (from[1] + to[1]));
    let along = Vector3::new(to[0] - from[0], 0.0, to[1] - from[1]);
    Part::new([name, material], Section::Line, middle, along, Fill::Mass(mass))
}

/// A tennis racket.
pub(super) fn racket(put: &mut dyn FnMut(Part)) {
    // The hoop, as 48 straight bars of the same mass; its middle is 520 mm from the butt.
    let (wide, long, middle) = (0.122, 0.165, 0.520);
    let corner = |i: u32| {
        let (sin, cos) = sin_cos(TAU * f64::from(i) / 48.0);
        [wide * cos, middle + long * sin]
    };
    for i in 0..48 {
        put(bar("hoop", "frame", 0.150 / 48.0, corner(i), corner(i + 1)));
    }
    // The strings, mains along z and crosses along x, 17 g shared out by their lengths.
    let half_chord = |at: f64| (1.0 - at * at).sqrt();
    let places = |count: u32| (1..=count).map(move |i| f64::from(2 * i) / f64::from(count + 1) - 1.0);
    let chords = |count: u32, half: f64| places(count).map(half_chord).sum::<f64>() * 2.0 * half;
    let per_metre = 0.017 / (chords(16, long) + chords(19, wide));
    for at in places(16) {
        let (half, x) = (long * half_chord(at), wide * at);
        put(bar("main string", "string", per_metre * 2.0 * half, [x, middle - half], [x, middle + half]));
    }
    for at in places(19) {
        let (half, z) = (wide * half_chord(at), middle + long * at);
        put(bar("cross string", "string", per_metre * 2.0 * half, [-half, z], [half, z]));
    }
    for side in [-1.0, 1.0] {
        put(bar("throat bar", "frame", 0.025, [side * 0.012, 0.190], [side * 0.080, 0.395]));
    }
    let (middle, along) = (Vector3::new(0.0, 0.0, 0.095), Vector3::new(0.0, 0.0, 0.190));
    let section = Section::Rectangle { wide: 0.034, thick: 0.029 };
    put(Part::new(["handle", "grip"], section, middle, along, Fill::Mass(0.110)));
}
