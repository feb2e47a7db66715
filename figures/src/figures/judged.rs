//! What the judge finds in the recorded engines.

use super::{Drawing, NARROW};
use crate::draw::{Canvas, Fill, Ink, Label, P, Pen, Plot, Scale};
use tumbling_judge::LawName;
use tumbling_judge::records::{RECORDED, judged};

/// Records, and what the figure calls them, in the order of the chapter's tables.
const ENGINES: [(&str, &str); 6] = [
    ("mujoco-4.0.0-rk4", "MuJoCo, RK4"),
    ("mujoco-4.0.0-implicitfast", "MuJoCo, implicitfast"),
    ("bullet-3.2.7-rigid", "Bullet, rigid body"),
    ("rapier3d-f64-0.36.1", "Rapier (default)"),
    ("mujoco-4.0.0-euler", "MuJoCo, Euler (default)"),
    ("bullet-3.2.7-multibody", "Bullet, multibody (pybullet)"),
];

const STORIES: [(&str, &str); 6] = [
    ("box-middle", "the box"),
    ("middle", "middle"),
    ("major", "largest"),
    ("minor", "smallest"),
    ("fast", "fast"),
    ("wound", "faster"),
];

/// Laws, and what the figure calls them.
const LAWS: [(LawName, &str); 3] = [
    (LawName::Energy, "energy"),
    (LawName::Momentum, "length of $L$"),
    (LawName::Direction, "direction of $L$"),
];

/// The most that a law may be off.
const ALLOWED: f64 = 0.01;

const LEFT: f64 = 16.0;
const COLUMN: f64 = 110.0;
const MARK: f64 = 33.0;
const ROW: f64 = 76.0;
const TOP: f64 = 128.0;

/// The greatest error in a law of a record. `None` where there is no such record.
fn greatest(engine: &str, story: &str, law: LawName) -> Option<f64> {
    let record = format!("{engine}--{story}");
    judged().find(|of| of.record == record && of.law == law).map(|of| of.most)
}

/// A law's mark: a disc, a square, a triangle, filled where the law is broken.
fn mark(canvas: &Canvas, law: usize, (x, y): P, broken: bool) {
    let (fill, pen) = if broken {
        (Fill::new(Ink::Wrong), Pen::new(Ink::Wrong, 2.0))
    } else {
        (Fill::new(Ink::Paper), Pen::new(Ink::Faint, 2.0))
    };
    match law {
        0 => canvas.disc((x, y), 10.5, fill, Some(pen)),
        1 => canvas.tiles(&[[x - 9.5, y - 9.5, x + 9.5, y + 9.5]], fill, Some(pen)),
        _ => canvas.area(&[(x - 11.5, y + 10.0), (x, y - 11.0), (x + 11.5, y + 10.0)], fill, Some(pen)),
    }
}

pub(super) fn grades() -> Drawing {
    let canvas = Canvas::new(588);
    let mut x = LEFT;
    for (law, (_, name)) in LAWS.iter().enumerate() {
        mark(&canvas, law, (x + 12.0, 20.0), false);
        canvas.label((x + 32.0, 27.0), &Label::new(*name).size(21.0));
        x += [150.0, 190.0, 0.0][law];
    }
    for (law, x) in [12.0, 44.0, 76.0].into_iter().enumerate() {
        mark(&canvas, law, (LEFT + x, 58.0), true);
    }
    let key = Label::new("filled: off by more than 1 % (direction: 0.01 rad)").size(21.0);
    canvas.label((LEFT + 100.0, 65.0), &key);
    for (column, (_, title)) in STORIES.iter().enumerate() {
        let x = LEFT + COLUMN * column as f64;
        canvas.label((x + 12.0 + MARK, TOP - 18.0), &Label::new(*title).size(21.0).bold().middle());
    }
    let mut said = Vec::new();
    for (row, (engine, name)) in ENGINES.iter().enumerate() {
        let y = TOP + ROW * row as f64;
        canvas.line((LEFT, y - 6.0), (LEFT + 6.0 * COLUMN - 8.0, y - 6.0), Pen::new(Ink::Faint, 0.8));
        canvas.label((LEFT, y + 18.0), &Label::new(*name).size(21.0));
        let mut broken = [0_u32; LAWS.len()];
        for (column, (story, _)) in STORIES.iter().enumerate() {
            let x = LEFT + COLUMN * column as f64;
            for (place, (law, _)) in LAWS.iter().enumerate() {
                if let Some(most) = greatest(engine, story, *law) {
                    broken[place] += u32::from(most > ALLOWED);
                    mark(&canvas, place, (x + 12.0 + MARK * place as f64, y + 42.0), most > ALLOWED);
                }
            }
        }
        let [energy, length, direction] = broken;
        said.push(format!("{name}: {energy}, {length}, {direction}"));
    }
    canvas.described(format!(
        "A row for each recorded engine, six stories in it, three marks for each story: a disc for the energy, a square for the \
         momentum's length, a triangle for its direction. A filled mark is off by more than 1 in 100. Stories in which energy, length \
         and direction are off, by engine: {}.",
        said.join("; ")
    ))
}

/// Names of curves and where each stands: time, s, and energy.
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

/// One story, its upper left corner here; says how each engine ends.
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
