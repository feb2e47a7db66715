//! The cost of a state for each request, from the committed record.

use super::{Drawing, NARROW, raised};
use crate::draw::{Canvas, Fill, Ink, Label, Pen, Plot, Scale};
use tumbling_measure::costs::{self, GENERAL};

/// The label of a row of the record, and whether the attitude is requested too.
const ROWS: [(&str, &str, bool); 8] = [
    ("ball; spin alone", "a ball", false),
    ("two equal moments; spin alone", "a coin", false),
    ("three moments; spin alone", "the box", false),
    ("ball", "a ball", true),
    ("two equal moments", "a coin", true),
    (GENERAL, "the box", true),
    ("three moments and a weight; to 1e-2", "weighted, two digits", true),
    ("three moments and a weight; to 1e-8", "weighted, eight digits", true),
];

pub(super) fn draw() -> Drawing {
    let rows = costs::recorded()?.rows;
    let canvas = Canvas::sized(NARROW, 420);
    let (top, apart) = (20.0, 38.0);
    let bottom = top + apart * ROWS.len() as f64;
    let plot = Plot::new(&canvas, [206.0, top, 484.0, bottom], Scale::log(50.0..3e5), 0.0..1.0);
    plot.x_axis((2..=5).map(|n| (10_f64.powi(n), raised(n))), "processor instructions for a state");
    let mut sentences = Vec::new();
    for (k, (row, words, attitude)) in ROWS.into_iter().enumerate() {
        let count = costs::of(&rows, row)?.state;
        let y = top + apart * (k as f64 + 0.5);
        let (from, to) = (plot.at(50.0, 0.5).0, plot.at(count, 0.5).0);
        let fill = if attitude { Ink::Paper } else { Ink::Text };
        canvas.line((from, y), (to, y), Pen::new(Ink::Faint, 1.4).dotted());
        canvas.disc((to, y), 6.5, Fill::new(fill), Some(Pen::new(Ink::Text, 2.2)));
        canvas.label((198.0, y + 5.5), &Label::new(words).end());
        canvas.label((to + 13.0, y + 5.5), &Label::new(grouped(count)).halo(Ink::Paper));
        let asked = if attitude { "spin and attitude" } else { "spin" };
        sentences.push(format!("{words}, {asked}: {}", grouped(count)));
    }
    canvas.described(format!(
        "The instructions that one state takes, by what is asked, as dots on an axis where each power of ten takes the same room. {}.",
        sentences.join("; ")
    ))
}

/// With a thin space before the last three digits.
fn grouped(count: f64) -> String {
    let digits = format!("{count:.0}");
    match digits.len().checked_sub(3) {
        Some(at) if at > 1 => format!("{}\u{202f}{}", &digits[..at], &digits[at..]),
        _ => digits,
    }
}
