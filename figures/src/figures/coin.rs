use super::Drawing;
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, View};
use nalgebra::Vector3;
use std::f64::consts::TAU;
use tumbling::solid::{Solid, ThinDisk};

/// Between the momentum and the plate's axis, degrees: more than a good throw has, so that it is seen.
const TILT: f64 = 22.0;

pub(super) fn draw() -> Drawing {
    let moments = ThinDisk::new(1.0)?.with_mass(1.0)?.inertia().matrix().diagonal();
    let tilt = TILT.to_radians();
    // Momentum upwards, the axis leaning to the right; the spin is the momentum over each moment.
    let axis = Vector3::new(0.0, tilt.sin(), tilt.cos());
    let momentum = Vector3::z();
    let along = axis * axis.dot(&momentum);
    let spin = along / moments.z + (momentum - along) / moments.x;
    let beyond = spin.angle(&momentum);

    let canvas = Canvas::sized(500, 400);
    let view = View::new((235.0, 300.0), 170.0, 8.0, 14.0);
    let (u, v) = (Vector3::x(), axis.cross(&Vector3::x()));
    let rim: Vec<P> = (0..96)
        .map(|i| {
            let (sin, cos) = (TAU * f64::from(i) / 96.0).sin_cos();
            view.at(&((u * cos + v * sin) * 1.05))
        })
        .collect();
    canvas.area(&rim, Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 1.4)));
    let origin = view.at(&Vector3::zeros());
    let lengths = (1.25, 1.05, 1.6);
    for (angle, length, ink) in [(tilt, lengths.0, Ink::Text), (beyond, lengths.1, Ink::Omega)] {
        canvas.path(&view.ring(angle, length), Pen::new(ink, 1.4).dashed());
    }
    let tips = [axis * lengths.0, spin.normalize() * lengths.1, momentum * lengths.2].map(|p| view.at(&p));
    canvas.arrow(origin, tips[2], Pen::new(Ink::Momentum, 3.6));
    canvas.arrow(origin, tips[0], Pen::new(Ink::Text, 3.0));
    canvas.arrow(origin, tips[1], Pen::new(Ink::Omega, 3.6));
    canvas.disc(origin, 4.5, Fill::new(Ink::Text), None);
    let momentum = Label::new("momentum $!L$: stands still").ink(Ink::Momentum);
    canvas.label((tips[2].0 + 12.0, tips[2].1 + 10.0), &momentum);
    canvas.label((tips[0].0 + 14.0, tips[0].1 + 4.0), &Label::new("the plate’s axis $!e$"));
    canvas.label((tips[1].0 - 10.0, tips[1].1 + 30.0), &Label::new("spin $!ω$").ink(Ink::Omega).end());
    canvas.described(format!(
        "A flat round plate in flight. Its momentum, an orange arrow upwards, stands still. The axis of the plate leans {TILT:.0}° from \
         it to the right, the spin {:.0}° to the left, in one plane with it. Dashed circles show how the tips of both go round \
         the momentum together.",
        beyond.to_degrees()
    ))
}
