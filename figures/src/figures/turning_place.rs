use super::Drawing;
use crate::draw::{Canvas, Fill, Ink, Label, Pen, View};
use nalgebra::Vector3;

/// Where the point is, m: its distance from the axis, its height, and its angle round it.
const RADIUS: f64 = 1.0;
const HEIGHT: f64 = 0.75;
const ANGLE: f64 = -0.35;

pub(super) fn draw() -> Drawing {
    let canvas = Canvas::sized(500, 360);
    let view = View::new((215.0, 255.0), 135.0, 0.0, 22.0);
    let circle = view.ring(RADIUS.atan2(HEIGHT), RADIUS.hypot(HEIGHT));
    canvas.area(&circle, Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 1.2)));
    let spin = Vector3::new(0.0, 0.0, 1.0);
    let place = Vector3::new(RADIUS * ANGLE.cos(), RADIUS * ANGLE.sin(), HEIGHT);
    let velocity = spin.cross(&place);
    let origin = Vector3::zeros();
    let foot = spin * HEIGHT;
    canvas.line(view.at(&(spin * -0.35)), view.at(&(spin * 1.6)), Pen::new(Ink::Faint, 1.2).dash_dotted());
    canvas.line(view.at(&foot), view.at(&place), Pen::new(Ink::Text, 1.2).dashed());
    canvas.arrow(view.at(&origin), view.at(&(spin * 1.55)), Pen::new(Ink::Omega, 3.6));
    canvas.arrow(view.at(&origin), view.at(&place), Pen::new(Ink::Text, 2.2));
    canvas.arrow(view.at(&place), view.at(&(place + velocity)), Pen::new(Ink::Text, 3.6));
    canvas.disc(view.at(&place), 5.0, Fill::new(Ink::Text), None);
    canvas.disc(view.at(&origin), 3.5, Fill::new(Ink::Text), None);
    let near = |p: &Vector3<f64>, dx: f64, dy: f64| {
        let at = view.at(p);
        (at.0 + dx, at.1 + dy)
    };
    canvas.label(near(&(spin * 1.55), 14.0, 12.0), &Label::new("spin $!ω$").ink(Ink::Omega));
    canvas.label(near(&(place * 0.5), -28.0, 18.0), &Label::new("$!r$"));
    canvas.label(near(&(place + velocity), 10.0, 16.0), &Label::new("velocity"));
    canvas.label(near(&(place + velocity), 10.0, 38.0), &Label::new("$!v$ = $!ω$ × $!r$").bold());
    canvas.label((20.0, 345.0), &Label::new("dashed: the distance from the axis"));
    canvas.described(
        "A point of a turning body. The spin is a blue arrow upwards along the axis, the place of the point an arrow from \
                      the origin. The point goes round the axis on a level circle; its velocity is an arrow that touches the circle, \
                      at a right angle to the spin and to the arrow to the point: the cross product of the two."
    )
}
