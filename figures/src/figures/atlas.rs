//! The atlas: what becomes of each method on each hard case, read from the record.

use super::{Drawing, Picture};
use crate::draw::{Canvas, Fill, Label, Pen};
use crate::ink::Ink;

const RECORD: &str = include_str!("../../../measure/record/atlas.tsv");

/// How each fate is drawn: its word, a sign that says it without colour, and how dark.
const FATES: [(&str, &str, f64); 9] = [
    ("right", "", 0.0),
    ("late", "l", 0.13),
    ("worn", "w", 0.22),
    ("miscounted", "m", 0.38),
    ("gained", "+", 0.62),
    ("lost", "−", 0.62),
    ("reversed", "r", 0.85),
    ("refused", "e", 0.0),
    ("not finite", "×", 1.0),
];

/// The sizes of the sheet, in points.
const LEFT: f64 = 196.0;
const RIGHT: f64 = 672.0;
const ROW: f64 = 17.0;
const GAP: f64 = 14.0;

struct Chart {
    name: &'static str,
    title: &'static str,
    swept: &'static str,
}

struct Place<'a> {
    chart: &'a str,
    case: &'a str,
    runner: &'a str,
    single: bool,
    fate: usize,
}

fn places() -> Result<Vec<Place<'static>>, Box<dyn std::error::Error>> {
    let rows = RECORD.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|line| {
        let fields: Vec<&str> = line.split('\t').collect();
        let [chart, case, runner, precision, fate] = fields[..] else {
            return Err(format!("not a line of the atlas: {line}").into());
        };
        let fate = FATES.iter().position(|known| known.0 == fate).ok_or("an unknown fate")?;
        Ok(Place { chart, case, runner, single: precision == "f32", fate })
    })
    .collect()
}

/// Different values in the order in which they first come.
fn distinct<'a>(values: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut seen = Vec::new();
    for value in values {
        if !seen.contains(&value) {
            seen.push(value);
        }
    }
    seen
}

/// One sheet: charts side by side, a row for each method.
fn sheet(charts: &[Chart], keyed: bool) -> Drawing {
    let all = places()?;
    let runners = distinct(all.iter().map(|place| place.runner));
    let columns: Vec<Vec<&str>> = charts
        .iter()
        .map(|chart| distinct(all.iter().filter(|p| p.chart == chart.name).map(|p| p.case)))
        .collect();
    let count: usize = columns.iter().map(Vec::len).sum();
    #[allow(clippy::cast_precision_loss)] // a few dozen
    let number = |n: usize| n as f64;
    let wide = (RIGHT - LEFT - GAP * number(charts.len() - 1)) / number(count);
    let top = 62.0;
    let bottom = top + ROW * number(runners.len());
    let keys = if keyed { columns[0].len().div_ceil(2) } else { 0 };
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a page's height
    let canvas = Canvas::new((bottom + 118.0 + 19.0 * number(keys)) as u32);
    let mut said = Vec::new();
    for (row, runner) in runners.iter().enumerate() {
        let y = top + ROW * number(row);
        canvas.label((LEFT - 8.0, y + 0.76 * ROW), &Label::new(*runner).size(13.5).end());
    }
    let mut x = LEFT;
    for (chart, cases) in charts.iter().zip(&columns) {
        let middle = x + 0.5 * wide * number(cases.len());
        canvas.label((middle, 22.0), &Label::new(chart.title).size(15.5).bold().middle());
        let mut right = Vec::new();
        for (column, case) in cases.iter().enumerate() {
            let left = x + wide * number(column);
            let title = if keyed { (column + 1).to_string() } else { short(case) };
            canvas.label((left + 0.5 * wide, top - 7.0), &Label::new(title).size(12.0).middle());
            for (row, runner) in runners.iter().enumerate() {
                let y = top + ROW * number(row);
                let fate = |single: bool| {
                    let place = all.iter().find(|p| {
                        p.chart == chart.name && p.case == *case && p.runner == *runner && p.single == single
                    });
                    place.map(|place| place.fate)
                };
                let (double, single) = (fate(false), fate(true));
                if let Some(fate) = double {
                    cell(&canvas, [left, y, left + wide, y + ROW], fate, true);
                }
                if let (Some(double), Some(single)) = (double, single)
                    && double != single
                {
                    let side = 0.42 * ROW;
                    let (ex, ey) = (left + wide - 0.8, y + ROW - 0.8);
                    cell(&canvas, [ex - side, ey - side, ex, ey], single, false);
                }
            }
        }
        for runner in &runners {
            let kept = cases.iter().filter(|case| {
                all.iter().any(|p| {
                    p.chart == chart.name
                        && p.case == **case
                        && p.runner == *runner
                        && !p.single
                        && p.fate == 0
                })
            });
            right.push(format!("{runner} {}", kept.count()));
        }
        canvas.label((middle, bottom + 20.0), &Label::new(chart.swept).size(14.0).middle());
        said.push(format!(
            "{} ({}), {} cases from {} to {}; right in f64: {}.",
            chart.title,
            chart.swept,
            cases.len(),
            cases.first().copied().unwrap_or_default(),
            cases.last().copied().unwrap_or_default(),
            right.join(", ")
        ));
        x += wide * number(cases.len()) + GAP;
    }
    let mut y = bottom + 50.0;
    if keyed {
        for (index, case) in columns[0].iter().enumerate() {
            let (column, row) = (index / keys, index % keys);
            let at = (24.0 + 340.0 * number(column), y + 19.0 * number(row));
            canvas.label(at, &Label::new(format!("{}  {case}", index + 1)).size(14.0));
        }
        y += 19.0 * number(keys) + 6.0;
    }
    legend(&canvas, y);
    Ok(Picture {
        canvas,
        description: format!(
            "A table of squares, a row for each method, a column for each case. An empty square is right; marks and darkness say what \
             went wrong, a small square at the corner what single precision does if that differs. {}",
            said.join(" ")
        ),
    })
}

/// As a power of ten where that is shorter.
fn short(case: &str) -> String {
    match case.parse::<f64>() {
        Ok(value) if value >= 100.0 || value < 0.01 || case.contains('e') => {
            let power = value.log10().round();
            if power == 0.0 { "1".to_owned() } else { format!("$10^{{{power}}}$") }
        }
        _ => case.to_owned(),
    }
}

fn cell(canvas: &Canvas, [left, top, right, bottom]: [f64; 4], fate: usize, large: bool) {
    let (word, sign, dark) = FATES[fate];
    let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
    let edge = Pen::new(Ink::Faint, if large { 0.6 } else { 0.8 });
    if !large {
        canvas.area(&corners, Fill::new(Ink::Paper), None);
    }
    let ink = if word == "refused" { Ink::Faint } else { Ink::Wrong };
    let dark = if word == "refused" { 0.35 } else { dark };
    canvas.area(&corners, Fill::new(ink).opacity(dark), Some(edge));
    if large && !sign.is_empty() {
        let ink = if dark > 0.5 { Ink::Paper } else { Ink::Text };
        let at = (0.5 * (left + right), bottom - 0.26 * (bottom - top));
        canvas.label(at, &Label::new(sign).size(13.0).ink(ink).middle());
    }
}

fn legend(canvas: &Canvas, y: f64) {
    let mut x = 24.0;
    let mut y = y;
    for (index, (word, _, _)) in FATES.iter().enumerate() {
        if x > 560.0 {
            (x, y) = (24.0, y + 24.0);
        }
        cell(canvas, [x, y - 13.0, x + 22.0, y + 4.0], index, true);
        canvas.label((x + 28.0, y), &Label::new(*word).size(14.0));
        x += 44.0 + 8.2 * word.len() as f64;
    }
    canvas.label((x + 6.0, y), &Label::new("corner: single precision").size(14.0));
}

pub(super) fn steps() -> Drawing {
    sheet(
        &[
            Chart { name: "steady spin", title: "a stable spin", swept: "turn in a step, rad" },
            Chart { name: "flipping", title: "a body that flips", swept: "turn in a step, rad" },
        ],
        false,
    )
}

pub(super) fn stiff() -> Drawing {
    sheet(
        &[
            Chart { name: "needles", title: "needles", swept: "largest over smallest moment" },
            Chart { name: "damping", title: "damping", swept: "damping times step over inertia" },
        ],
        false,
    )
}

pub(super) fn pushes() -> Drawing {
    sheet(&[Chart { name: "pushes", title: "three flips after a push", swept: "push, rad/s" }], false)
}

pub(super) fn named() -> Drawing {
    sheet(&[Chart { name: "named", title: "cases that users met", swept: "number in the list below" }], true)
}
