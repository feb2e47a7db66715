//! Error against run time with a torque: the heavy top by every method and by published programs.

use super::work::{Ladder, circumstances, column, committed, curves, line};
use super::{Drawing, NARROW, raised};
use crate::draw::{Canvas, Ink, Label, Pen, Plot, Scale};
use tumbling_measure::contestant::Group;
use tumbling_measure::verdict::{DIGITS, kind, seconds_at};

/// The programs named on the heavy top, and what they are called.
const WITH_TORQUE: [(&str, &str); 5] = [
    ("adaptive", "adaptive"),
    ("Taylor series (heyoka)", "heyoka"),
    ("DOP853 (differential-equations)", "DOP853"),
    ("Tsit45 (diffsol)", "diffsol"),
    ("DOP853 (SciPy)", "SciPy"),
];

/// Everyone on the heavy top: the attitude at the end.
pub(super) fn draw() -> Drawing {
    let record = committed()?;
    let kind = kind("attitude").ok_or("no such error")?;
    let canvas = Canvas::sized(NARROW, 520);
    let (top, bottom) = (52.0, 448.0);
    let (across, up) = (Scale::log(5e-6..1.0), Scale::log(1e-15..10.0));
    let plot = Plot::new(&canvas, [62.0, top, 380.0, bottom], across, up);
    let times = [(1e-5, "10 µs"), (1e-3, "1 ms"), (1e-1, "0.1 s")];
    plot.x_axis(times.map(|(t, text)| (t, text.to_owned())), "time of a run");
    plot.y_axis([-12, -8, -4, 0].map(|n| (10_f64.powi(n), raised(n))), "");
    canvas.label((16.0, 28.0), &Label::new("error of a heavy top's attitude after 16 s (rad)"));
    let curves = curves(&record.rows, "heavy top", kind);
    let named = |curve: &Ladder<'_>| WITH_TORQUE.iter().find(|(name, _)| *name == curve.name);
    for curve in curves.iter().filter(|curve| named(curve).is_none()) {
        line(&plot, curve, Pen::new(Ink::Faint, 0.8).opacity(0.7))?;
    }
    let (mut ends, mut sentences) = (Vec::new(), Vec::new());
    for (curve, (name, words)) in curves.iter().filter_map(|curve| Some((curve, named(curve)?))) {
        let ours = curve.group != Group::Peer;
        let pen = if ours { Pen::new(Ink::Text, 4.0) } else { Pen::new(Ink::Text, 1.6).dashed() };
        line(&plot, curve, pen)?;
        if let Some(&(x, y)) = curve.right.last() {
            ends.push((plot.at(x, y), (*words).to_owned(), pen));
        }
        for error in DIGITS {
            if let Some(seconds) = seconds_at(&record.rows, "heavy top", name, kind, error) {
                sentences.push(format!("{words} comes below {error:.0e} in {:.3} ms", seconds * 1e3));
            }
        }
    }
    column(&canvas, 396.0, top, bottom, ends);
    canvas.described(format!(
        "Time of a run across, error of the attitude up, both logarithmic. Each grey curve is a method at ever finer steps, dashed \
         ones are published programs, the bold one is the library's run within a tolerance. {}. {}",
        sentences.join(", "),
        circumstances(&record)
    ))
}
