use super::{BOX_EDGES, Drawing, document_box, ink_of};
use crate::draw::{Canvas, Cuboid, Ink, Label, P, Pen, View};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::TAU;
use tumbling::{Axis, PrincipalAxes};

pub(super) fn draw() -> Drawing {
    let inertia = document_box()?;
    let principal = inertia.principal();
    let canvas = Canvas::sized(500, 500);
    let view = View::new((250.0, 276.0), 88.0, 42.0, 24.0);
    let solid = Cuboid { rotation: Matrix3::identity(), half: Vector3::from(BOX_EDGES.map(|x| 0.5 * x)) };
    solid.draw(&canvas, &view, Some(Pen::new(Ink::Faint, 1.1).dashed()), Pen::new(Ink::Text, 1.4));
    let mut said = Vec::new();
    for (axis, letter) in [(Axis::Largest, "y"), (Axis::Middle, "x"), (Axis::Smallest, "z")] {
        let (along, moment, pen) =
            (principal.axis(axis), principal.moment(axis), Pen::new(ink_of(axis), 2.8));
        let half = along.dot(&solid.half);
        let edge = view.at(&(along * half));
        canvas.line(view.at(&Vector3::zeros()), edge, Pen::new(ink_of(axis), 1.4).dashed());
        canvas.arrow(edge, view.at(&(along * (half + REACH))), pen);
        canvas.arrow_along(&ring(&view, &principal, axis, half + 0.7 * REACH), Pen::new(ink_of(axis), 2.0));
        let tip = view.at(&(along * (half + REACH)));
        let text = Label::new(format!("$I_{{{letter}{letter}}}$ = {moment:.3} kg m²")).ink(ink_of(axis));
        match axis {
            Axis::Smallest => canvas.label((tip.0 + 16.0, tip.1 + 12.0), &text),
            Axis::Middle => canvas.label((6.0, tip.1 + 36.0), &text),
            Axis::Largest => canvas.label((494.0, tip.1 + 32.0), &text.end()),
        }
        said.push(format!("{moment:.3} kg m² about {letter}"));
    }
    // The length of each edge, next to one edge of this direction.
    let [a, b, c] = BOX_EDGES;
    let edge = |x: f64, y: f64, z: f64, dx: f64, dy: f64, text: String| {
        let p = view.at(&solid.point(x, y, z));
        canvas.label((p.0 + dx, p.1 + dy), &Label::new(text).middle());
    };
    edge(0.0, 1.0, -1.0, 34.0, 26.0, format!("$a$ = {a:.0} m"));
    edge(1.0, 0.0, -1.0, -34.0, 26.0, format!("$b$ = {b:.0} m"));
    edge(-1.0, 1.0, 0.25, 46.0, 6.0, format!("$c$ = {c:.0} m"));
    canvas.described(format!(
        "A solid box of 1 kg with edges of {a:.0} m along x, {b:.0} m along y and {c:.0} m along z. An arrow along each edge direction, with a turn about it, carries the moment of inertia about it: {}.",
        said.join(", ")
    ))
}

/// How far the arrows stand out, m.
const REACH: f64 = 1.15;

/// Most of a turn round an axis, at this distance from the centre.
fn ring(view: &View, principal: &PrincipalAxes, axis: Axis, out: f64) -> Vec<P> {
    let along = principal.axis(axis);
    let side = principal.axis(if axis == Axis::Smallest { Axis::Middle } else { Axis::Smallest });
    let other = along.cross(&side);
    // Begun where its two ends leave the arrow free.
    let start = if axis == Axis::Middle { 0.21 } else { 0.10 };
    (0..=60)
        .map(|i| {
            let (s, c) = (TAU * (start + 0.78 * f64::from(i) / 60.0)).sin_cos();
            view.at(&(along * out + (side * c + other * s) * 0.26))
        })
        .collect()
}
