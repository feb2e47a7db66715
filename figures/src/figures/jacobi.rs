use super::{Drawing, Picture, document_box, in_principal_axes, ink_of};
use crate::draw::{Canvas, Label, Pen, Plot, Scale};
use nalgebra::Vector3;
use std::error::Error;
use tumbling::Axis;
use tumbling::exact::FreeMotion;

/// About the axis of the largest moment at the start, rad/s.
const SPIN: f64 = 10.0;
const SECONDS: f64 = 4.0;

/// One motion: its parameter, where it is drawn, and where its curves are named.
struct Panel {
    parameter: f64,
    words: &'static str,
    top: f64,
    names: [(f64, f64); 3],
}

const PANELS: [Panel; 2] = [
    Panel {
        parameter: 0.04,
        words: "small parameter: a wobble",
        top: 58.0,
        names: [(0.06, 3.8), (0.14, -6.6), (0.06, 11.2)],
    },
    Panel {
        parameter: 0.9998,
        words: "parameter near one: it waits, then flips",
        top: 318.0,
        names: [(0.28, 9.2), (2.02, -10.8), (0.45, 4.0)],
    },
];

pub(super) fn draw() -> Drawing {
    let moments = in_principal_axes(&document_box()?)?.principal().moments();
    let canvas = Canvas::sized(500, 560);
    for panel in &PANELS {
        draw_panel(&canvas, &moments, panel)?;
    }
    Ok(Picture {
        canvas,
        description: format!(
            "The three components of the box's spin against time, {SECONDS:.0} s long. Above, for the parameter {}: the component about the \
             largest axis is nearly constant, dn; the other two are nearly a cosine, cn, and a sine, sn. Below, for {}: the \
             component about the middle axis, sn, stays near one value for long and then changes sign quickly; as it does, the other \
             two rise and fall in pulses, cn to either side by turns, dn always to one.",
            PANELS[0].parameter, PANELS[1].parameter
        ),
    })
}

fn draw_panel(canvas: &Canvas, moments: &Vector3<f64>, panel: &Panel) -> Result<(), Box<dyn Error>> {
    let m = moments;
    // With nothing about the middle axis at the start, this ratio of the others has the parameter.
    let ratio = (panel.parameter * (m.z - m.y) * m.z / ((m.y - m.x) * m.x)).sqrt();
    let motion = FreeMotion::new((*m).try_into()?, &Vector3::new(SPIN * ratio, 0.0, SPIN))?;
    let top = panel.top;
    canvas.label((14.0, top - 36.0), &Label::new(panel.words).bold());
    let (x, y) = (Scale::linear(0.0..SECONDS), Scale::linear(-15.0..15.0));
    let plot = Plot::new(canvas, 46.0, top, 488.0, top + 180.0, x, y);
    let title = if top > 100.0 { "time (s)" } else { "" };
    plot.x_axis((0..=4).map(|s| (f64::from(s), s.to_string())), title);
    plot.y_axis([-10, 0, 10].map(|w| (f64::from(w), w.to_string().replace('-', "−"))), "spin (rad/s)");
    let names = ["$ω_1$ = $a_1$ cn", "$ω_2$ = $a_2$ sn", "$ω_3$ = $a_3$ dn"];
    for (i, axis) in Axis::ALL.into_iter().enumerate() {
        let at = |k: i32| SECONDS * f64::from(k) / 800.0;
        let points: Result<Vec<_>, tumbling::Error> =
            (0..=800).map(|k| Ok((at(k), motion.omega(at(k))?[i]))).collect();
        plot.curve(points?, Pen::new(ink_of(axis), 2.6))?;
        let (x, y) = panel.names[i];
        canvas.label(plot.at(x, y), &Label::new(names[i]).ink(ink_of(axis)).halo(crate::ink::Ink::Paper));
    }
    Ok(())
}
