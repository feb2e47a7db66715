//! The judge's findings on the recorded engines.

use super::{Drawing, NARROW};
use crate::draw::{Canvas, Fill, Ink, Label, Pen, Plot, Scale};
use tumbling_engines::{RECORDED, table};

/// Rules as the figure calls them, by how the judge's names of them begin.
const RULES: [(&str, &str); 5] = [
    ("Runge-Kutta", "the Runge-Kutta rule"),
    ("linearised", "one implicit step"),
    ("explicit gyroscopic", "an explicit step"),
    ("no gyroscopic", "no gyroscopic term"),
    ("none known", "a rule that the judge does not know"),
];

/// The rule that the figure groups an engine by.
fn rule(name: &str) -> &'static str {
    RULES.iter().find(|rule| name.starts_with(rule.0)).map_or("an explicit step, rescaled", |rule| rule.1)
}

const TITLE: f64 = 30.0;
const ROW: f64 = 25.0;
/// Where the bars begin, and the length of one of 1200 steps.
const BARS: [f64; 2] = [212.0, 250.0];

/// Where a bar ends after this number of steps.
fn end(steps: usize) -> f64 {
    BARS[0] + BARS[1] * (steps as f64).ln() / 1200_f64.ln()
}

pub(super) fn grades() -> Drawing {
    let lines: Vec<_> = table().collect();
    let titles = lines.chunk_by(|a, b| rule(a.rule) == rule(b.rule)).count();
    let top = 74.0;
    let bottom = top + ROW * lines.len() as f64 + TITLE * titles as f64;
    let canvas = Canvas::sized(NARROW, (bottom + 44.0) as u32);
    canvas.label((12.0, 24.0), &Label::new("steps of 1/60 s until the energy, the momentum").size(16.0));
    canvas
        .label((12.0, 44.0), &Label::new("or a flip is wrong; upper bar: the box, which flips;").size(16.0));
    canvas.label((12.0, 64.0), &Label::new("lower bar: a stable spin about the largest axis").size(16.0));
    for (steps, text) in [(1, "1"), (10, "10"), (100, "100"), (1200, "1200")] {
        canvas.line((end(steps), top), (end(steps), bottom + 8.0), Pen::new(Ink::Faint, 0.8));
        canvas.label((end(steps), bottom + 28.0), &Label::new(text).size(15.5).middle());
    }
    let (mut y, mut said, mut before) = (top, Vec::new(), "");
    for line in &lines {
        let mut lead = String::new();
        if rule(line.rule) != before {
            before = rule(line.rule);
            lead = format!("{before}: ");
            y += TITLE;
            canvas.label((12.0, y - 6.0), &Label::new(before).size(15.5).bold().halo(Ink::Paper));
        }
        canvas.label((20.0, y + 17.0), &Label::new(line.name).size(15.5));
        for (steps, y) in line.steps.into_iter().zip([y + 4.0, y + 13.0]) {
            let ink = if steps.is_some() { Ink::Wrong } else { Ink::Text };
            canvas.tiles(&[[BARS[0], y, end(steps.unwrap_or(1200)), y + 7.0]], Fill::new(ink), None);
        }
        y += ROW;
        let [of_box, largest] =
            line.steps.map(|step| step.map_or("never".to_owned(), |step| step.to_string()));
        said.push(format!("{lead}{} {of_box}, {largest}", line.name));
    }
    canvas.described(format!(
        "A row for each of {} recorded engines, grouped by rule, with two bars on a scale of powers: after how many of 1200 steps the \
         energy or the momentum of the box is off by more than 1 in 100, or a flip is missing, and the same of a stable spin. Box, \
         then stable spin: {}.",
        lines.len(),
        said.join("; ")
    ))
}

/// The labels of the curves and their positions: time, s, and energy.
type Names = [(&'static str, f64, f64); 3];

/// A record's energy relative to the first, and the spin along the middle axis, at each time, s.
fn seen(engine: &str, story: &str, middle: usize) -> Result<Vec<[f64; 3]>, Box<dyn std::error::Error>> {
    let run = RECORDED.iter().find(|run| (run.engine, run.story) == (engine, story));
    let run = run.ok_or_else(|| format!("{engine} is not recorded in {story}"))?.read()?;
    let mut rows: Vec<[f64; 3]> = Vec::new();
    let mut first = None;
    for row in &run.rows {
        let energy = row.omega.dot(&run.moments.component_mul(&row.omega));
        if energy == 0.0 {
            break; // put to rest
        }
        let first = *first.get_or_insert(energy);
        rows.push([row.step as f64 / 60.0, energy / first, row.omega[middle]]);
    }
    Ok(rows)
}

/// An engine, and what draws its curve.
type DrawnEngine = (&'static str, fn() -> Pen);

/// The engines drawn.
const DRAWN: [DrawnEngine; 4] = [
    ("mujoco-4.0.0-euler", || Pen::new(Ink::Wrong, 2.6)),
    ("rapier3d-f64-0.36.1", || Pen::new(Ink::Wrong, 2.4).dash_dotted()),
    ("bullet-3.2.7-rigid", || Pen::new(Ink::Wrong, 2.6).dotted()),
    ("mujoco-4.0.0-rk4", || Pen::new(Ink::Text, 3.2)),
];

const FLIPS: Names = [("explicit", 2.0, 7.0), ("implicit", 1.0, 0.3), ("RK4, Rapier", 9.0, 1.18)];
const LARGEST: Names = [("explicit", 6.5, 15.0), ("Rapier", 9.5, 1.75), ("RK4, implicit", 6.0, 0.62)];
const SMALLEST: Names = [("explicit", 1.5, 12.0), ("Rapier", 10.0, 0.52), ("RK4, implicit", 7.4, 1.18)];

/// The stories drawn, their titles, and the names of their curves.
const PANELS: [(&str, &str, Names); 4] = [
    ("box-middle", "the box: flips", FLIPS),
    ("middle", "middle axis: flips", FLIPS),
    ("major", "largest axis: stable", LARGEST),
    ("minor", "smallest axis: stable", SMALLEST),
];

/// One story, with its upper left corner at the point; returns a sentence on the end of each engine.
fn panel(
    canvas: &Canvas,
    (story, title, names): (&str, &str, Names),
    (left, top): (f64, f64),
    last_row: bool,
) -> Result<String, Box<dyn std::error::Error>> {
    let (across, up) = (0.0..20.0, Scale::log(0.2..30.0));
    let plot = Plot::new(canvas, [left, top, left + 176.0, top + 226.0], across, up);
    let times = [0, 10, 20].map(|t| (f64::from(t), t.to_string()));
    plot.x_axis(times, if last_row { "time $t$ (s)" } else { "" });
    let ticks = [(0.3, "0.3"), (1.0, "1"), (3.0, "3"), (10.0, "10"), (30.0, "30")];
    plot.y_axis(ticks.map(|(y, text)| (y, text.to_owned())), "");
    canvas.label((left - 8.0, top - 12.0), &Label::new(title).size(16.0).bold());
    let middle = if story == "box-middle" { 0 } else { 1 };
    let mut last = Vec::new();
    for (engine, pen) in DRAWN {
        let (rows, pen) = (seen(engine, story, middle)?, pen());
        // Out of the top: up to where the line leaves.
        let inside = rows.iter().position(|row| row[1] > 30.0).unwrap_or(rows.len());
        plot.curve(rows[..inside].iter().map(|row| (row[0], row[1])), pen)?;
        if inside < rows.len() {
            let at = plot.at(rows[inside - 1][0], rows[inside - 1][1]);
            canvas.line(at, (at.0 + 1.5, plot.at(0.0, 30.0).1), pen);
            last.push(format!("leaves the sheet at {:.1} s", rows[inside - 1][0]));
        } else {
            last.push(format!("ends at {:.2}", rows[rows.len() - 1][1]));
        }
    }
    for (name, t, energy) in names {
        let ink = if name.starts_with("RK4") { Ink::Text } else { Ink::Wrong };
        canvas.label(plot.at(t, energy), &Label::new(name).size(15.5).ink(ink).halo(Ink::Paper));
    }
    Ok(format!("{}: {}.", title, last.join(", ")))
}

pub(super) fn energies() -> Drawing {
    let canvas = Canvas::sized(NARROW, 660);
    let mut said = Vec::new();
    for (k, story) in PANELS.into_iter().enumerate() {
        let corner = (if k % 2 == 0 { 56.0 } else { 304.0 }, if k < 2 { 86.0 } else { 372.0 });
        said.push(panel(&canvas, story, corner, k >= 2)?);
    }
    canvas.label((24.0, 26.0), &Label::new("kinetic energy, relative to the start"));
    canvas.described(format!(
        "Kinetic energy of four recorded bodies over 20 s, in parts of what it was, on a scale of powers. The exact motion stays at \
         1. In the order {}: {}",
        "MuJoCo's Euler, Rapier, Bullet's rigid body, MuJoCo's RK4",
        said.join(" ")
    ))
}
