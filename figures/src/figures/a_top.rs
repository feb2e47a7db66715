use super::Drawing;
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, View};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;
use tumbling::PrincipalMoments;
use tumbling::exact::LagrangeTop;

/// The lean at which the top is let go, degrees, and its spin, rad/s.
const LEAN: f64 = 30.0;
const SPIN: f64 = 200.0;

/// Points at an angle from the vertical, all round it.
fn round(angle: f64) -> impl Iterator<Item = Vector3<f64>> {
    (0..=96).map(move |i| {
        let (sin, cos) = (TAU * f64::from(i) / 96.0).sin_cos();
        Vector3::new(angle.sin() * cos, angle.sin() * sin, angle.cos())
    })
}

pub(super) fn draw() -> Drawing {
    // The top of the chapter.
    let moments = PrincipalMoments::new(2e-4, 2e-4, 5e-5)?;
    let leaning = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), -LEAN.to_radians());
    let (spin, arm) = (Vector3::new(0.0, 0.0, SPIN), Vector3::new(0.0, 0.0, 0.04));
    let top = LagrangeTop::new(moments, leaning, &spin, &arm, 1.0)?;
    let [highest, lowest] = top.lean();
    let seconds = TAU / top.precession_rate();

    let canvas = Canvas::sized(500, 400);
    let view = View::new((240.0, 360.0), 350.0, 8.0, 30.0);
    let place = |p: &Vector3<f64>| view.at(p);
    for angle in [highest, lowest] {
        let ring: Vec<P> = round(angle).map(|p| place(&p)).collect();
        canvas.path(&ring, Pen::new(Ink::Text, 1.2).dashed());
    }
    let axis = |t: f64| top.attitude(t).map(|attitude| attitude * Vector3::z());
    // It ends on the way down, between two cusps and short of a whole round.
    let period = top.period()?.unwrap_or(seconds);
    let whole = ((seconds / period).floor() - 0.6) * period;
    let path = (0..=600).map(|i| Ok(place(&axis(whole * f64::from(i) / 600.0)?)));
    let path = path.collect::<Result<Vec<P>, tumbling::Error>>()?;
    // The axis of its smallest moment. It ends with an arrow, so that one sees which way it goes round.
    canvas.arrow_along(&path, Pen::new(Ink::AxisMin, 2.6));
    let (origin, tip) = (place(&Vector3::zeros()), place(&axis(0.0)?));
    canvas.arrow(origin, tip, Pen::new(Ink::Text, 3.4));
    canvas.disc(origin, 4.5, Fill::new(Ink::Text), None);
    canvas.label((tip.0 - 96.0, tip.1 - 12.0), &Label::new("let go here"));
    canvas.label((origin.0 + 14.0, origin.1 + 4.0), &Label::new("the point stands still"));
    let nods = (whole / period).ceil();
    canvas.described(format!(
        "The axis of a top as an arrow from the point on which it stands, leaning by {LEAN:.0}°. From there its tip goes round \
         the vertical, on a path with about {nods:.0} arches that hang between cusps: each touches a lower dashed circle, at \
         {:.0}°, and returns to the upper one, at which the top was let go.",
        lowest.to_degrees()
    ))
}
