use super::{BOX_EDGES, Drawing};
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_2;
use tumbling::body::named::NamedBody;

/// How far the long edge is from the vertical, degrees.
const SLANT: f64 = 45.0;
const CENTRE: P = (200.0, 265.0);

/// Seen along x: y to the right, z upwards.
fn at(v: &Vector3<f64>, scale: f64) -> P {
    (CENTRE.0 + scale * v.y, CENTRE.1 - scale * v.z)
}

pub(super) fn draw() -> Drawing {
    let askew = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), SLANT.to_radians());
    let tensor = NamedBody::TheBox.properties()?.turned(askew)?.inertia();
    let torque = Vector3::z();
    let acceleration = tensor.inverse()? * torque;
    let off = acceleration.angle(&torque);

    let canvas = Canvas::sized(500, 400);
    let [_, b, c] = BOX_EDGES.map(|edge| 0.5 * edge);
    let corner = |y: f64, z: f64| at(&(askew * Vector3::new(0.0, y, z)), 80.0);
    let corners = [corner(-b, -c), corner(b, -c), corner(b, c), corner(-b, c)];
    canvas.area(&corners, Fill::new(Ink::Surface), Some(Pen::new(Ink::Text, 1.3)));
    canvas.line(corner(0.0, -c), corner(0.0, c), Pen::new(Ink::Faint, 1.2).dash_dotted());
    let (tip, turn) = (at(&torque, 215.0), at(&acceleration.normalize(), 215.0));
    canvas.arc(CENTRE, 150.0, FRAC_PI_2, FRAC_PI_2 + off, Pen::new(Ink::Text, 2.0));
    canvas.arrow(CENTRE, tip, Pen::new(Ink::Momentum, 3.6));
    canvas.arrow(CENTRE, turn, Pen::new(Ink::Omega, 3.6));
    canvas.disc(CENTRE, 4.5, Fill::new(Ink::Text), None);
    canvas.label((CENTRE.0 + 14.0, 62.0), &Label::new("the torque $!τ$,").ink(Ink::Momentum));
    canvas.label((CENTRE.0 + 14.0, 84.0), &Label::new("and the momentum it gives").ink(Ink::Momentum));
    canvas.label((10.0, 36.0), &Label::new("the spin it gives").ink(Ink::Omega));
    let gap = format!("{:.1}°", off.to_degrees());
    canvas.label((CENTRE.0 - 34.0, CENTRE.1 - 160.0), &Label::new(gap.clone()).bold().middle());
    canvas.label((corners[1].0 - 30.0, corners[1].1 - 78.0), &Label::new("the box, at rest"));
    canvas.described(format!(
        "The box, seen along its x edge, its long edge {SLANT:.0}° from the vertical. A torque about the vertical, an orange arrow \
         upwards, gives momentum along itself. The spin that it gives, a blue arrow, is {gap} off, toward the long edge, \
         about which the box turns most easily."
    ))
}
