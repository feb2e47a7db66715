use super::{Drawing, document_box, in_principal_axes, ink_of};
use crate::draw::{Canvas, Label, Pen, Plot};
use nalgebra::Vector3;
use std::error::Error;
use tumbling::Axis;
use tumbling::exact::FreeMotion;

/// About the axis of the largest moment at the start, rad/s.
const SPIN: f64 = 10.0;
const SECONDS: f64 = 4.0;

/// One motion: its parameter, its title, its position, and the positions of the labels of its curves.
type Motion = (f64, &'static str, f64, [(f64, f64); 3]);

const WOBBLE: Motion = (0.04, "small parameter: a wobble", 58.0, [(0.06, 3.8), (0.14, -6.6), (0.06, 11.2)]);
const FLIPPING: Motion =
    (0.9998, "parameter near one: it waits, then flips", 318.0, [(0.28, 9.2), (2.02, -10.8), (0.45, 4.0)]);

pub(super) fn draw() -> Drawing {
    let moments = in_principal_axes(&document_box()?)?.principal().moments();
    let canvas = Canvas::sized(500, 560);
    for motion in [WOBBLE, FLIPPING] {
        panel(&canvas, &moments, motion)?;
    }
    canvas.described(format!(
        "The three components of the box's spin against time, {SECONDS:.0} s long. Above, for the parameter {}: the component about the \
         largest axis is nearly constant, dn; the other two are nearly a cosine, cn, and a sine, sn. Below, for {}: the \
         component about the middle axis, sn, stays near one value for long and then changes sign quickly; as it does, the other \
         two rise and fall in pulses, cn to either side by turns, dn always to one.",
        WOBBLE.0, FLIPPING.0
    ))
}

fn panel(
    canvas: &Canvas,
    m: &Vector3<f64>,
    (parameter, words, top, names): Motion,
) -> Result<(), Box<dyn Error>> {
    // With nothing about the middle axis at the start, this ratio of the others has the parameter.
    let ratio = (parameter * (m.z - m.y) * m.z / ((m.y - m.x) * m.x)).sqrt();
    let motion = FreeMotion::new((*m).try_into()?, &Vector3::new(SPIN * ratio, 0.0, SPIN))?;
    canvas.label((14.0, top - 36.0), &Label::new(words).bold());
    let (x, y) = (0.0..SECONDS, -15.0..15.0);
    let plot = Plot::new(canvas, [46.0, top, 488.0, top + 180.0], x, y);
    plot.x_axis((0..=4).map(|s| (f64::from(s), s.to_string())), if top > 100.0 { "time (s)" } else { "" });
    plot.y_axis([-10, 0, 10].map(|w| (f64::from(w), w.to_string().replace('-', "−"))), "spin (rad/s)");
    let texts = ["$ω_1$ = $a_1$ cn", "$ω_2$ = $a_2$ sn", "$ω_3$ = $a_3$ dn"];
    for (i, axis) in Axis::ALL.into_iter().enumerate() {
        let at = |k: i32| SECONDS * f64::from(k) / 800.0;
        let points: Result<Vec<_>, tumbling::Error> =
            (0..=800).map(|k| Ok((at(k), motion.omega(at(k))?[i]))).collect();
        plot.curve(points?, Pen::new(ink_of(axis), 2.6))?;
        let (x, y) = names[i];
        canvas.label(plot.at(x, y), &Label::new(texts[i]).ink(ink_of(axis)).halo(crate::ink::Ink::Paper));
    }
    Ok(())
}
