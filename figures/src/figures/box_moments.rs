use super::{BOX_EDGES, Drawing, Picture, document_box};
use crate::draw::{Canvas, Cuboid, Label, Pen, View};
use crate::ink::Ink;
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::TAU;
use tumbling::Axis;

/// The ink of a principal axis.
fn ink(axis: Axis) -> Ink {
    match axis {
        Axis::Smallest => Ink::AxisMin,
        Axis::Middle => Ink::AxisMid,
        Axis::Largest => Ink::AxisMax,
    }
}

pub(super) fn draw() -> Drawing {
    let inertia = document_box()?;
    let principal = inertia.principal();
    let canvas = Canvas::new(520);
    let view = View::new((300.0, 285.0), 82.0, 35.0, 22.0);
    let solid = Cuboid { rotation: Matrix3::identity(), half: Vector3::from(BOX_EDGES.map(|x| 0.5 * x)) };
    solid.draw(&canvas, &view, Some(Pen::new(Ink::Faint, 1.0).dashed()), Pen::new(Ink::Text, 1.4));
    let mut said = Vec::new();
    for (axis, letter) in [(Axis::Largest, "y"), (Axis::Middle, "x"), (Axis::Smallest, "z")] {
        let along = principal.axis(axis);
        let moment = principal.moment(axis);
        let half = along.component_mul(&solid.half).norm();
        let pen = Pen::new(ink(axis), 2.6);
        let reach = half + 0.95;
        canvas.line(view.at(&Vector3::zeros()), view.at(&(along * half)), Pen::new(ink(axis), 1.4).dashed());
        canvas.arrow(view.at(&(along * half)), view.at(&(along * reach)), pen);
        let ring: Vec<_> = (0..=60)
            .map(|i| {
                let turn = TAU * (0.12 + 0.76 * f64::from(i) / 60.0);
                let side = principal.axis(if axis == Axis::Smallest { Axis::Middle } else { Axis::Smallest });
                let other = along.cross(&side);
                view.at(&(along * (half + 0.45) + (side * turn.cos() + other * turn.sin()) * 0.3))
            })
            .collect();
        canvas.arrow_along(&ring, Pen::new(ink(axis), 1.8));
        let tip = view.at(&(along * (reach + 0.1)));
        canvas.label(tip, &Label::new(format!("$I_{{{letter}{letter}}}$ = {moment:.3} kg m²")).ink(ink(axis)).middle());
        said.push(format!("{moment:.3} about {letter}"));
    }
    Ok(Picture { canvas, description: format!("A solid box with edges 2, 1 and 3 m. Moments: {}.", said.join(", ")) })
}
