//! States a second against the number of bodies, from the committed record.

use super::{Drawing, NARROW, Picture, power_of_ten};
use crate::draw::{Canvas, Label, Pen, Plot, Scale};
use crate::ink::Ink;
use tumbling_measure::scale::{self, best, ratio};

/// Each curve: build, crowd, lanes, threads, how it looks and what it is called.
const CURVES: [(&str, &str, u32, u32, Ink, bool, &str); 6] = [
    ("native", "spin", 4, 1, Ink::Omega, false, "spin alone"),
    ("native", "spin and attitude", 4, 2, Ink::Text, false, "attitude, two threads"),
    ("native", "spin and attitude", 4, 1, Ink::Text, false, "spin and attitude"),
    ("default", "spin and attitude", 4, 1, Ink::Text, true, "for any machine"),
    ("native", "spin and attitude", 1, 1, Ink::Faint, false, "one by one"),
    ("native", "Rapier", 1, 1, Ink::Faint, true, "steps of Rapier"),
];

pub(super) fn draw() -> Drawing {
    let record = scale::committed()?;
    let rows = &record.rows;
    let canvas = Canvas::sized(NARROW, 480);
    let (low, high) = (1e6, 3e8);
    let plot = Plot::new(&canvas, 62.0, 50.0, 296.0, 410.0, Scale::log(70.0..1.5e7), Scale::log(low..high));
    plot.x_axis((2..=7).map(|n| (10_f64.powi(n), power_of_ten(n))), "bodies");
    plot.y_axis((6..=8).map(|n| (10_f64.powi(n), power_of_ten(n))), "");
    canvas.label((20.0, 28.0), &Label::new("results a second").bold());
    let mut ends = Vec::new();
    for (build, crowd, lanes, threads, ink, dashed, name) in CURVES {
        let points: Vec<(f64, f64)> = scale::of(rows, build, crowd, lanes, threads)
            .map(|row| (row.bodies as f64, row.rate().clamp(low, high)))
            .collect();
        if points.is_empty() {
            continue;
        }
        let pen = Pen::new(ink, 2.0);
        let pen = if dashed { pen.dashed() } else { pen };
        plot.curve(points.iter().copied(), pen)?;
        plot.dots(points.iter().copied(), 2.6, ink)?;
        if let Some(&(x, y)) = points.last() {
            ends.push((plot.at(x, y), name.to_owned(), pen));
        }
    }
    super::work::column(&canvas, 318.0, 56.0, 410.0, ends);
    let both = ("spin and attitude", 4, 1);
    let mut sentences = Vec::new();
    if let Some(rate) = best(rows, "native", both.0, 4, 1) {
        sentences.push(format!(
            "In four lanes on one thread {:.0} million spins with attitude a second at best",
            rate / 1e6
        ));
    }
    let against = [
        ((both.0, 1, 1), "those of one lane"),
        (("Rapier", 1, 1), "the steps that Rapier does of as many bodies"),
    ];
    for (other, words) in against {
        if let Some(ratio) = ratio(rows, "native", both, other) {
            sentences.push(format!("{ratio:.1} times {words}"));
        }
    }
    if let Some(ratio) = ratio(rows, "native", (both.0, 4, 2), both) {
        sentences.push(format!("on two threads {ratio:.1} times those of one"));
    }
    let said = |key: &str| record.said(key).unwrap_or("unknown").to_owned();
    Ok(Picture {
        canvas,
        description: format!(
            "The number of bodies across, from a hundred to ten million, results a second up, both logarithmic. The curves of the exact motion \
             run nearly level. {}. Measured on {} ({}).",
            sentences.join("; "),
            said("machine"),
            said("compiler")
        ),
    })
}
