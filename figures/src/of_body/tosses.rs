//! Three tosses, drawn after each turn.

use super::{Kind, NAMES, Subject};
use crate::draw::{Canvas, Ink, Label, P, View, solid};
use crate::motion;
use crate::picture::{Drawing, ink_of};
use nalgebra::{Matrix3, Vector3};
use std::error::Error;
use tumbling::Axis;
use tumbling::exact::FreeMotion;

/// The push, rad; the spin is a turn in each second.
const PUSH: f64 = 0.02;
/// How many turns are drawn after the throw.
const TURNS: usize = 4;

/// Principal axes to world, at the throw and after each turn about an axis.
fn after_each_turn(subject: &Subject<'_>, about: usize) -> Result<Vec<Matrix3<f64>>, Box<dyn Error>> {
    let motion = FreeMotion::of(&motion::tossed(subject.inertia()?, about, PUSH)?)?;
    let attitude =
        |step: u32| Ok(motion.attitude(f64::from(step) * 0.005)?.to_rotation_matrix().into_inner());
    // Not the side that is seen: it would be toward the viewer after each turn.
    let watched = if about == 0 { 2 } else { 0 };
    motion::after_each_turn((0..=12_000).map(attitude), about, watched, TURNS)
}

pub(crate) fn draw(subject: &Subject<'_>) -> Drawing {
    let canvas = Canvas::sized(500, 500);
    canvas.label((14.0, 24.0), &Label::new(subject.name()).bold());
    // In the principal axes, the smallest upright and the largest toward the viewer.
    let upright = Matrix3::new(0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0);
    let to_axes = subject.frame.transpose();
    let drawn: Vec<_> = subject.model.drawn().iter().map(|s| s.mapped(|p| to_axes * p)).collect();
    let mark = -Vector3::z();
    let mut said = Vec::new();
    for (row, axis) in [Axis::Smallest, Axis::Largest, Axis::Middle].into_iter().enumerate() {
        let top = 54.0 + 138.0 * row as f64;
        let words = format!("about the axis of the {} moment", NAMES[axis as usize]);
        canvas.label((14.0, top), &Label::new(words).ink(ink_of(axis)).bold().size(15.5));
        let mut sides = Vec::new();
        for (turn, rotation) in after_each_turn(subject, axis as usize)?.into_iter().enumerate() {
            let centre: P = (58.0 + 96.0 * turn as f64, top + 68.0);
            let view = View::new(centre, 45.0 / subject.model.reach(), -90.0 + 22.0, 18.0);
            let seen = upright * rotation;
            solid(&canvas, &view, &drawn, &seen, Some((&mark, Ink::Text)));
            sides.push(if (seen * mark).dot(&view.toward()) > 0.0 { "dark" } else { "light" });
        }
        said.push(format!("{}: {}", NAMES[axis as usize], sides.join(", ")));
    }
    for turn in 0..=TURNS {
        canvas.label((58.0 + 96.0 * turn as f64, 466.0), &Label::new(turn.to_string()).middle());
    }
    canvas.label((250.0, 490.0), &Label::new("turns since the throw").middle());
    let end = match subject.kind {
        Kind::Three => "Only the toss about the middle axis can turn it over.",
        _ => "Moments are equal: no toss turns it over by a flip.",
    };
    canvas.described(format!(
        "Three tosses of {}, each with a slip of {PUSH} rad to the side, drawn at the throw and after each of {TURNS} turns. One side \
         is dark; the side that is seen: {}. {end}",
        subject.name(),
        said.join("; ")
    ))
}
