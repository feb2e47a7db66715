//! Error against run time, from the committed record: every method on the box, and on every body.

use super::{Drawing, NARROW, power_of_ten, raised};
use crate::draw::{Canvas, Ink, Label, P, Pen, Plot, Scale};
use tumbling_measure::contestant::Group;
use tumbling_measure::record::{self, Record, Work};
use tumbling_measure::story;
use tumbling_measure::verdict::{Kind, contestants, kind, seconds_at};

/// How a group's curves look.
fn pen(group: Group) -> Pen {
    match group {
        Group::Exact => Pen::new(Ink::Text, 3.0),
        Group::Both => Pen::new(Ink::Text, 2.2),
        Group::Momentum => Pen::new(Ink::Text, 0.9),
        Group::Neither => Pen::new(Ink::Faint, 1.6),
        Group::Peer => Pen::new(Ink::Text, 1.8).dashed(),
        Group::Wrong => Pen::new(Ink::Wrong, 1.6),
    }
}

/// The description of a group in the key.
fn words(group: Group) -> &'static str {
    match group {
        Group::Exact => "the exact motion",
        Group::Both => "keeps energy and momentum",
        Group::Momentum => "keeps the length of momentum",
        Group::Neither => "keeps neither",
        Group::Peer => "published programs",
        Group::Wrong => "another law",
    }
}

/// The smallest error that is drawn; smaller errors are drawn at this value.
const FLOOR: f64 = 1e-16;
/// Larger errors are drawn at this value.
const CEILING: f64 = 10.0;
const SHORTEST: f64 = 5e-8;
const LONGEST: f64 = 1.0;

/// One curve, and where it failed.
pub(super) struct Ladder<'a> {
    pub(super) name: &'a str,
    pub(super) group: Group,
    /// Time (s) and error of the runs without a failure.
    pub(super) right: Vec<(f64, f64)>,
    /// The runs with a wrong number of flips, and those that broke down: at the upper edge, at the time that
    /// a run with that number of steps would take.
    wrong: Vec<(f64, f64)>,
}

fn curve<'a>(rows: &'a [Work], story: &str, name: &'a str, group: Group, kind: &Kind) -> Ladder<'a> {
    let ladder: Vec<&Work> = rows.iter().filter(|r| r.story == story && r.contestant == name).collect();
    // Seconds per step, from the finest run that succeeded.
    let pace = ladder.iter().rev().find_map(|row| Some(row.seconds? / row.equal_steps()? as f64));
    let (mut right, mut wrong) = (Vec::new(), Vec::new());
    for row in ladder {
        let by_pace = pace.zip(row.equal_steps()).map(|(pace, steps)| pace * steps as f64);
        let Some(seconds) = row.seconds.or(by_pace) else { continue };
        match ((kind.of)(row), row.right()) {
            (Some(error), true) => right.push((seconds, error.clamp(FLOOR, CEILING))),
            // If the story has no such error, a missing value is not a failure.
            (None, true) => {}
            (Some(error), _) => wrong.push((seconds, error.clamp(FLOOR, CEILING))),
            (None, _) => wrong.push((seconds, CEILING)),
        }
    }
    Ladder { name, group, right, wrong }
}

pub(super) fn curves<'a>(rows: &'a [Work], story: &str, kind: &Kind) -> Vec<Ladder<'a>> {
    contestants(rows).into_iter().map(|(name, group)| curve(rows, story, name, group, kind)).collect()
}

/// A plot of time and error with its axes.
fn plot(canvas: &Canvas, corner: P, size: P, every: i32, title: &str) -> Plot {
    let (left, top) = corner;
    let (across, up) = (Scale::log(SHORTEST..LONGEST), Scale::log(FLOOR..CEILING));
    let plot = Plot::new(canvas, [left, top, left + size.0, top + size.1], across, up);
    let times = [(1e-6, "1 µs"), (1e-3, "1 ms"), (1.0, "1 s")];
    plot.x_axis(times.map(|(t, text)| (t, text.to_owned())), title);
    plot.y_axis((-16..=0).filter(|n| n % every == 0).map(|n| (10_f64.powi(n), power_of_ten(n))), "");
    plot
}

/// Failures.
fn crosses(canvas: &Canvas, plot: &Plot, curves: &[Ladder<'_>]) {
    let points = curves.iter().flat_map(|curve| &curve.wrong);
    let mut places: Vec<P> = Vec::new();
    for place in points.map(|&(x, y)| plot.at(x.clamp(SHORTEST, LONGEST), y)) {
        // One cross stands for all that would overlap.
        if places.iter().all(|p| (p.0 - place.0).hypot(p.1 - place.1) > 4.0) {
            places.push(place);
        }
    }
    canvas.crosses(places, 3.0, Pen::new(Ink::Wrong, 1.2).opacity(0.8));
}

pub(super) fn line(plot: &Plot, curve: &Ladder<'_>, pen: Pen) -> Result<(), Box<dyn std::error::Error>> {
    if let [only] = curve.right.as_slice() {
        plot.dots([*only], if curve.group == Group::Exact { 5.0 } else { 2.5 }, pen.ink())?;
    }
    plot.curve(curve.right.iter().copied(), pen)
}

/// Labels in a column next to the ends of their curves, without overlap.
pub(super) fn column(canvas: &Canvas, x: f64, top: f64, bottom: f64, mut ends: Vec<(P, String, Pen)>) {
    ends.sort_by(|a, b| a.0.1.total_cmp(&b.0.1).then(a.0.0.total_cmp(&b.0.0)));
    let room = bottom - top;
    let apart = (room / ends.len().max(1) as f64).min(19.5);
    let mut places: Vec<f64> = Vec::new();
    for (end, ..) in &ends {
        let least = places.last().map_or(top, |y| y + apart);
        places.push(end.1.max(least));
    }
    // Labels beyond the lower edge move up, and push those above them.
    let mut most = bottom;
    for place in places.iter_mut().rev() {
        *place = place.min(most);
        most = *place - apart;
    }
    for ((end, text, pen), y) in ends.into_iter().zip(places) {
        canvas.line((end.0 + 3.0, end.1), (x - 4.0, y), Pen::new(pen.ink(), 0.8).opacity(0.55));
        canvas.label((x, y + 4.5), &Label::new(text).size(15.5));
    }
}

pub(super) fn committed() -> Result<Record<Work>, Box<dyn std::error::Error>> {
    record::work()
}

/// When and where, for the words.
pub(super) fn circumstances(record: &Record<Work>) -> String {
    let said = |key: &str| record.said(key).unwrap_or("unknown").to_owned();
    format!("Measured on {} ({}).", said("machine"), said("compiler"))
}

/// The methods with labels in the figure of the box, with the labels and their positions.
const NAMED: [(&str, &str, f64, f64); 3] = [
    ("DOP853 (differential-equations)", "DOP853, a general solver", 1.0, 2e-12),
    ("Runge-Kutta 4", "Runge-Kutta 4", 1.0, 2e-8),
    ("three rotations", "three rotations", 1.0, 5e-5),
];

/// The least error that any stepper has within a time, s: the frontier.
fn frontier(curves: &[Ladder<'_>]) -> Vec<(f64, f64)> {
    let steppers = curves.iter().filter(|curve| curve.group != Group::Exact);
    let mut points: Vec<(f64, f64)> = steppers.flat_map(|curve| curve.right.iter().copied()).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut best = f64::INFINITY;
    points.retain(|point| {
        let better = point.1 < best;
        best = best.min(point.1);
        better
    });
    points
}

/// Everyone on the box: the attitude after 100 flips.
pub(super) fn draw_box() -> Drawing {
    let record = committed()?;
    let kind = kind("attitude").ok_or("no such error")?;
    let canvas = Canvas::sized(NARROW, 520);
    let (across, up) = (Scale::log(1e-7..LONGEST), Scale::log(1e-15..CEILING));
    let plot = Plot::new(&canvas, [62.0, 52.0, 474.0, 448.0], across, up);
    let times = [(1e-6, "1 µs"), (1e-4, "0.1 ms"), (1e-2, "10 ms"), (1.0, "1 s")];
    plot.x_axis(times.map(|(t, text)| (t, text.to_owned())), "time of a run");
    plot.y_axis([-12, -8, -4, 0].map(|n| (10_f64.powi(n), raised(n))), "");
    canvas.label((16.0, 28.0), &Label::new("error of the attitude after 100 flips (rad)"));
    let curves = curves(&record.rows, "box", kind);
    for curve in &curves {
        line(&plot, curve, Pen::new(Ink::Faint, 0.8).opacity(0.7))?;
    }
    for (name, ..) in NAMED {
        for curve in curves.iter().filter(|curve| curve.name == name) {
            line(&plot, curve, Pen::new(Ink::Text, 1.6).dashed())?;
        }
    }
    let best = frontier(&curves);
    plot.curve(best.iter().copied(), Pen::new(Ink::Text, 4.0))?;
    for curve in curves.iter().filter(|curve| curve.group == Group::Exact) {
        plot.dots(curve.right.iter().copied(), 5.0, Ink::Text)?;
    }
    let write = |at: (f64, f64), text: &str| {
        canvas.label(plot.at(at.0, at.1), &Label::new(text).halo(Ink::Paper));
    };
    for (_, words, time, error) in NAMED {
        canvas.label(plot.at(time, error), &Label::new(words).halo(Ink::Paper).end());
    }
    write((1.6e-7, 6e-13), "the exact motion");
    write((2.2e-7, 3e-6), "the best at each time:");
    write((2.2e-7, 3e-7), "Moser-Veselov");
    let mut sentences = Vec::new();
    for error in [1e-2, 1e-8] {
        for name in ["fixed rate", NAMED[0].0] {
            if let Some(seconds) = seconds_at(&record.rows, "box", name, kind, error) {
                sentences.push(format!("{name} comes below {error:.0e} in {:.1} ms", seconds * 1e3));
            }
        }
    }
    canvas.described(format!(
        "Time of a run across, error of the attitude up, both logarithmic. Each grey curve is a method at ever finer steps. A bold \
         line is the least error of all steppers for each time. The exact motion is a dot far to the left and at the bottom. {}. {}",
        sentences.join(", "),
        circumstances(&record)
    ))
}

/// The attitude of every body.
pub(super) fn draw_attitude() -> Drawing {
    let (record, stories) = (committed()?, story::all()?);
    let kind = kind("attitude").ok_or("no such error")?;
    // Each row has two figures, and the key is below.
    let rows = u32::try_from(stories.len().div_ceil(2))?;
    let canvas = Canvas::sized(NARROW, 48 + 218 * rows + 176);
    canvas.label((20.0, 28.0), &Label::new(kind.title).bold());
    let place = |at: usize| {
        let (row, column) = (at / 2, at % 2);
        (56.0 + 244.0 * column as f64, 68.0 + 218.0 * row as f64)
    };
    let size = (180.0, 150.0);
    let mut sentences = Vec::new();
    for (at, story) in stories.iter().enumerate() {
        let corner = place(at);
        let plot = plot(&canvas, corner, size, 4, "");
        canvas.label((corner.0, corner.1 - 8.0), &Label::new(story.title).size(15.5));
        let curves = curves(&record.rows, story.name, kind);
        crosses(&canvas, &plot, &curves);
        for group in [Group::Wrong, Group::Neither, Group::Momentum, Group::Peer, Group::Both, Group::Exact] {
            for curve in curves.iter().filter(|curve| curve.group == group) {
                line(&plot, curve, pen(group))?;
            }
        }
        let best = curves.iter().flat_map(|c| c.right.iter().map(move |p| (c.name, p.1)));
        let best =
            best.filter(|(name, _)| !name.starts_with("exact motion")).min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((name, error)) = best {
            sentences.push(format!("{} {error:.0e}, {name}", story.title));
        }
    }
    key(&canvas, (16.0, 48.0 + 218.0 * f64::from(rows)));
    canvas.described(format!(
        "Small plots, one for each body: time of a run across, from a tenth of a microsecond to 1 second, error up, from 1e-16 to 1, \
         both logarithmic. The least error on each body: {}. {}",
        sentences.join("; "),
        circumstances(&record)
    ))
}

/// The key of the pens, its left upper corner here.
fn key(canvas: &Canvas, (left, top): (f64, f64)) {
    for (at, group) in Group::ALL.into_iter().enumerate() {
        let y = top + 12.0 + 24.0 * at as f64;
        let pen = pen(group);
        if group == Group::Exact {
            canvas.disc((left + 15.0, y), 5.0, crate::draw::Fill::new(pen.ink()), None);
        } else {
            canvas.line((left, y), (left + 30.0, y), pen);
        }
        canvas.label((left + 40.0, y + 5.0), &Label::new(words(group)).size(15.5));
    }
    let y = top + 12.0 + 24.0 * 6.0;
    canvas.crosses([(left + 15.0, y)], 4.0, Pen::new(Ink::Wrong, 1.2));
    canvas.label((left + 40.0, y + 5.0), &Label::new("wrong number of flips, or broken").size(15.5));
}

/// Energy after up to a million turns.
pub(super) fn draw_drift() -> Drawing {
    let record = record::long()?;
    let canvas = Canvas::sized(NARROW, 560);
    let (from, to) = (1.0, 2e6);
    let (low, high) = (1e-18, 1.0);
    let plot = Plot::new(&canvas, [62.0, 50.0, 288.0, 490.0], Scale::log(from..to), Scale::log(low..high));
    plot.x_axis((0..=3).map(|n| (100_f64.powi(n), power_of_ten(2 * n))), "turns");
    plot.y_axis((-9..=0).map(|n| (100_f64.powi(n), power_of_ten(2 * n))), "");
    canvas.label((20.0, 28.0), &Label::new("error of the energy, relative, 20 steps a turn"));
    for (slope, start, text) in [(0.5, 3e-17, "slope ½"), (1.0, 3e-7, "slope 1")] {
        let end = 1e6;
        let top: f64 = start * 10_f64.powf(6.0 * slope);
        plot.curve([(1.0, start), (end, top.min(high))], Pen::new(Ink::Text, 5.0).opacity(0.15))?;
        let (x, y) = plot.at(30.0, start * 30_f64.powf(slope));
        canvas.label((x, y - 12.0), &Label::new(text).size(15.5).halo(Ink::Paper));
    }
    let mut names: Vec<(&str, Group)> = Vec::new();
    for row in &record.rows {
        let group = Group::ALL.into_iter().find(|g| g.word() == row.group).ok_or("no such group")?;
        if !names.iter().any(|(name, _)| *name == row.contestant) {
            names.push((&row.contestant, group));
        }
    }
    let (mut ends, mut sentences) = (Vec::new(), Vec::new());
    for (name, group) in names {
        let points: Vec<(f64, f64)> = record
            .rows
            .iter()
            .filter(|row| row.contestant == name && row.right())
            .map(|row| (row.turns as f64, row.mean.clamp(low, high)))
            .collect();
        let pen = pen(group);
        plot.curve(points.iter().copied(), pen)?;
        if let Some(&(x, y)) = points.last() {
            ends.push((plot.at(x, y), name.to_owned(), pen));
        }
        if let Some(slope) = tumbling_measure::verdict::drift(&record.rows, name) {
            sentences.push(format!("{name} {slope:.2}"));
        }
    }
    column(&canvas, 304.0, 50.0, 490.0, ends);
    canvas.described(format!(
        "The error of the energy against the number of turns, both logarithmic, for the methods that keep something, and for \
         the classical Runge-Kutta method. Slopes from a thousand turns on: {}. A random walk has 0.5, a steady drift 1.",
        sentences.join(", ")
    ))
}
