//! Stills of what moves in the pages, for paper: a body in flight, at equal instants.

use crate::draw::{Canvas, Ink, Label, P, Pen, View};
use crate::figures::three_tosses::draw_book;
use nalgebra::{UnitQuaternion, Vector3};
use std::error::Error;
use std::f64::consts::TAU;
use tumbling::body::named::{BOOK, NamedBody, PHONE};
use tumbling::{Axis, Body, exact::FreeMotion};

/// Turns a second.
const TURNS: f64 = 2.0;
const COLUMNS: usize = 6;

/// The still for this widget, as a complete SVG document, if it has one of its own.
///
/// # Errors
/// What the library or the drawing reported.
#[must_use]
pub fn still(widget: &str) -> Option<Result<String, Box<dyn Error>>> {
    Some(match widget {
        "toss" => toss(widget, (NamedBody::Book, "a book"), BOOK.sizes, [0.05, 0.1, 280.0]),
        "tumble" => toss(widget, (NamedBody::Phone, "a phone"), PHONE.sizes, [0.01, 0.15, 400.0]),
        _ => return None,
    })
}

/// A throw about the middle axis of a flat body, with its width along x, its thickness along y and its height
/// along z. The other arguments are the spin about each of the other axes as a fraction of the main spin, the
/// seconds between two pictures, and the points per metre.
fn toss(
    widget: &str,
    (body, words): (NamedBody, &str),
    sizes: [f64; 3],
    [push, step, scale]: [f64; 3],
) -> Result<String, Box<dyn Error>> {
    let inertia = body.properties()?.inertia();
    let [easy, middle, hard] = Axis::ALL.map(|axis| inertia.principal().axis(axis));
    let omega = (middle + (easy + hard) * push) * (TURNS * TAU);
    // The momentum lies level, to the right.
    let level = UnitQuaternion::rotation_between(&inertia.momentum(&omega), &Vector3::x());
    let start = Body::spinning(inertia, level.ok_or("a momentum to the left")?, &omega)?;
    let motion = FreeMotion::of(&start)?;
    let flip = motion.next_flip(0.0)?.ok_or("a toss without a flip")?;
    let canvas = Canvas::sized(500, 300);
    for row in 0..2 {
        for column in 0..COLUMNS {
            let time = step * (row * COLUMNS + column) as f64;
            let state = motion.at(time)?;
            let centre: P = (44.0 + 82.0 * column as f64, 62.0 + 132.0 * row as f64);
            let view = View::new(centre, scale, -90.0 + 22.0, 18.0);
            draw_book(&canvas, &view, &sizes.into(), state.attitude.to_rotation_matrix().into_inner());
            let tip = |v: Vector3<f64>| view.at(&(v.normalize() * (44.0 / scale)));
            canvas.arrow(centre, tip(Vector3::x()), Pen::new(Ink::Momentum, 3.4));
            canvas.arrow(centre, tip(state.attitude * state.omega), Pen::new(Ink::Omega, 1.8));
            canvas.label((centre.0, centre.1 + 66.0), &Label::new(format!("{time:.2} s")).middle());
        }
    }
    canvas.label((14.0, 290.0), &Label::new("spin $!ω$").ink(Ink::Omega));
    canvas.label((100.0, 290.0), &Label::new("momentum $!L$").ink(Ink::Momentum));
    canvas.label((486.0, 290.0), &Label::new(format!("first flip after {flip:.2} s")).end());
    Ok(canvas.finish(
        &format!("still-{widget}"),
        &format!("{words} tossed about its middle axis, at equal instants"),
        &format!(
            "{words} with {:.0} turns a second about its middle axis and {} of that about each other axis, drawn every {} s. The \
             momentum, an orange arrow, stays; the spin, a blue one, sways about it. After {flip:.2} s the other face is up.",
            TURNS, push, step
        ),
    ))
}
