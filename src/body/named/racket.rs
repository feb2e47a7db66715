//! The tennis racket. Where its sizes come from stands at [`super::NamedBody::TennisRacket`].

use super::{Fill, Part, Section};
use crate::number::functions::sin_cos;
use core::f64::consts::TAU;
use nalgebra::Vector3;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// A thin bar from one `[x, z]` to another.
fn bar(name: &'static str, material: &'static str, mass: f64, from: [f64; 2], to: [f64; 2]) -> Part {
    let middle = Vector3::new(0.5 * (from[0] + to[0]), 0.0, 0.5 * (from[1] + to[1]));
    let along = Vector3::new(to[0] - from[0], 0.0, to[1] - from[1]);
    Part::new([name, material], Section::Line, middle, along, Fill::Mass(mass))
}

pub(super) fn parts(put: &mut dyn FnMut(Part)) {
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
