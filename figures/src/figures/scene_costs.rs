//! What a state costs by the outputs requested, from the committed record.

use super::{Drawing, Picture, power_of_ten};
use crate::draw::{Canvas, Fill, Label, Pen, Plot, Scale};
use crate::ink::Ink;
use tumbling_measure::saving;
use tumbling_measure::savings::{GENERAL, STATE, value};

/// What a row of the record is called here, and its colour.
const ROWS: [(&str, &str, Ink); 11] = [
    ("energy and flips alone", "its energy", Ink::Faint),
    ("ball; spin alone", "a ball: spin", Ink::Omega),
    ("principal spin; spin alone", "about a principal axis: spin", Ink::Omega),
    ("two equal moments; spin alone", "two equal moments: spin", Ink::Omega),
    ("three moments; spin alone", "three moments: spin", Ink::Omega),
    ("ball", "a ball: attitude", Ink::Text),
    ("principal spin", "about a principal axis: attitude", Ink::Text),
    ("two equal moments", "two equal moments: attitude", Ink::Text),
    (GENERAL, "three moments: attitude", Ink::Text),
    ("three moments and a weight; to 1e-2", "with a weight, to two digits", Ink::Momentum),
    ("three moments and a weight; to 1e-8", "with a weight, to eight digits", Ink::Momentum),
];

pub(super) fn draw() -> Drawing {
    let rows = saving::recorded()?.rows;
    let canvas = Canvas::new(480);
    let (top, apart) = (22.0, 34.0);
    let bottom = top + apart * ROWS.len() as f64;
    let plot = Plot::new(&canvas, 262.0, top, 646.0, bottom, Scale::log(10.0..1e5), Scale::linear(0.0..1.0));
    plot.x_axis((1..=5).map(|n| (10_f64.powi(n), power_of_ten(n))), "processor instructions for a state");
    let mut told = Vec::new();
    for (k, (row, words, ink)) in ROWS.into_iter().enumerate() {
        let count = value(&rows, "executed", row, STATE).ok_or_else(|| format!("no count of {row}"))?;
        let y = top + apart * (k as f64 + 0.5);
        let (from, to) = (plot.at(10.0, 0.5).0, plot.at(count, 0.5).0);
        canvas.line((from, y), (to, y), Pen::new(ink, 1.4).dotted());
        canvas.disc((to, y), 6.0, Fill::new(ink), None);
        canvas.label((250.0, y + 5.5), &Label::new(words).size(15.5).end());
        canvas.label((to + 12.0, y + 5.5), &Label::new(grouped(count)).size(15.5).halo(Ink::Paper));
        told.push(format!("{words}: {}", grouped(count)));
    }
    Ok(Picture {
        canvas,
        description: format!(
            "The instructions that one state takes, by what is asked, as dots on an axis where each power of ten takes the same room. {}.",
            told.join("; ")
        ),
    })
}

/// With a thin space before the last three digits.
fn grouped(count: f64) -> String {
    let digits = format!("{count:.0}");
    match digits.len().checked_sub(3) {
        Some(at) if at > 1 => format!("{}\u{202f}{}", &digits[..at], &digits[at..]),
        _ => digits,
    }
}
