//! Stills of what moves in the pages, for paper: a body in flight, at equal instants.

use crate::draw::{Canvas, Ink, Label, P, Pen, View};
use crate::figures::three_tosses::draw_book;
use nalgebra::{UnitQuaternion, Vector3};
use std::error::Error;
use std::f64::consts::TAU;
use tumbling::body::named::{BOOK, NamedBody, PHONE};
use tumbling::{Axis, Body, exact::FreeMotion};

/// A toss about the middle axis of a flat body: its width along x, its thickness along y, its height along z.
struct Flight {
    body: NamedBody,
    sizes: [f64; 3],
    /// What it is called.
    words: &'static str,
    /// The spin about each of the other axes, as a part of the one about the middle axis.
    push: f64,
    /// Seconds from one picture to the next.
    step: f64,
    /// Points to the metre.
    scale: f64,
}

/// Turns a second.
const TURNS: f64 = 2.0;
const ROWS: usize = 2;
const COLUMNS: usize = 6;

/// The still for this widget, as a complete SVG document, if it has one of its own.
///
/// # Errors
/// What the library or the drawing reported.
#[must_use]
pub fn still(widget: &str) -> Option<Result<String, Box<dyn Error>>> {
    let flight = |body, sizes, words, push, step, scale| Flight { body, sizes, words, push, step, scale };
    let toss = match widget {
        "toss" => flight(NamedBody::Book, BOOK.sizes, "a book", 0.05, 0.1, 280.0),
        "tumble" => flight(NamedBody::Phone, PHONE.sizes, "a phone", 0.01, 0.15, 400.0),
        _ => return None,
    };
    Some(drawn(widget, &toss))
}

fn drawn(widget: &str, toss: &Flight) -> Result<String, Box<dyn Error>> {
    let inertia = toss.body.properties()?.inertia();
    let axes = inertia.principal();
    let [easy, middle, hard] = Axis::ALL.map(|axis| axes.axis(axis));
    let omega = (middle + (easy + hard) * toss.push) * (TURNS * TAU);
    // The momentum lies level, to the right.
    let level = UnitQuaternion::rotation_between(&inertia.momentum(&omega), &Vector3::x());
    let start = Body::spinning(inertia, level.ok_or("a momentum to the left")?, &omega)?;
    let motion = FreeMotion::of(&start)?;
    let flip = motion.next_flip(0.0)?.ok_or("a toss without a flip")?;
    let canvas = Canvas::sized(500, 300);
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let time = toss.step * (row * COLUMNS + column) as f64;
            let state = motion.at(time)?;
            let centre: P = (44.0 + 82.0 * column as f64, 62.0 + 132.0 * row as f64);
            let view = View::new(centre, toss.scale, -90.0 + 22.0, 18.0);
            draw_book(&canvas, &view, &toss.sizes.into(), state.attitude.to_rotation_matrix().into_inner());
            let tip = |v: Vector3<f64>| view.at(&(v.normalize() * (44.0 / toss.scale)));
            canvas.arrow(centre, tip(Vector3::x()), Pen::new(Ink::Momentum, 3.4));
            canvas.arrow(centre, tip(state.attitude * state.omega), Pen::new(Ink::Omega, 1.8));
            canvas.label((centre.0, centre.1 + 66.0), &Label::new(format!("{time:.2} s")).middle());
        }
    }
    canvas.label((14.0, 290.0), &Label::new("spin $!ω$").ink(Ink::Omega));
    canvas.label((100.0, 290.0), &Label::new("momentum $!L$").ink(Ink::Momentum));
    canvas.label((486.0, 290.0), &Label::new(format!("first flip after {flip:.2} s")).end());
    let words = toss.words;
    Ok(canvas.finish(
        &format!("still-{widget}"),
        &format!("{words} tossed about its middle axis, at equal instants"),
        &format!(
            "{words} with {:.0} turns a second about its middle axis and {} of that about each other axis, drawn every {} s. The \
             momentum, an orange arrow, stays; the spin, a blue one, sways about it. After {flip:.2} s the other face is up.",
            TURNS, toss.push, toss.step
        ),
    ))
}
