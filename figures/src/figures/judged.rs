//! What the judge finds in the recorded engines.

use super::{Drawing, Picture};
use crate::draw::{Canvas, Fill, Label, Pen, Plot, Scale};
use crate::ink::Ink;
use nalgebra::Vector3;

const VERDICTS: &str = include_str!("../../../tests/data/engines/judged.tsv");

/// How each grade is drawn: its word, its sign.
const GRADES: [(&str, &str); 8] = [
    ("kept to rounding", ""),
    ("bounded", "b"),
    ("random walk", "w"),
    ("linear", "1"),
    ("faster than linear", "2"),
    ("exponential", "e"),
    ("grew, then stayed", "g"),
    ("not judged", "–"),
];

/// Records, and what the figure calls them.
const ENGINES: [(&str, &str); 8] = [
    ("mujoco-4.0.0-euler", "MuJoCo 4.0.0, Euler"),
    ("bullet-3.2.7-multibody", "Bullet 3.2.7, multibody"),
    ("bullet-3.2.7-multibody-1e9", "the same, limit raised"),
    ("rapier3d-f64-0.36.1", "Rapier 0.36.1"),
    ("bullet-3.2.7-rigid", "Bullet 3.2.7, rigid body"),
    ("mujoco-4.0.0-implicitfast", "MuJoCo 4.0.0, implicitfast"),
    ("mujoco-4.0.0-rk4", "MuJoCo 4.0.0, RK4"),
    ("mujoco-3.17.0-rk4", "MuJoCo 3.17.0, RK4"),
];

const STORIES: [(&str, &str); 6] = [
    ("box-middle", "box"),
    ("middle", "middle"),
    ("major", "largest"),
    ("minor", "smallest"),
    ("fast", "fast"),
    ("wound", "faster"),
];

const LAWS: [(&str, &str); 4] =
    [("energy", "E"), ("momentum", "$|L|$"), ("direction", "$∠L$"), ("separatrix", "s")];

/// The most that a law may be off.
const ALLOWED: f64 = 0.01;

const LEFT: f64 = 182.0;
const RIGHT: f64 = 674.0;
const ROW: f64 = 27.0;
const TOP: f64 = 66.0;
const GAP: f64 = 8.0;

struct Judged {
    grade: usize,
    most: f64,
}

fn judged(engine: &str, story: &str, law: &str) -> Option<Judged> {
    let record = format!("{engine}--{story}");
    VERDICTS.lines().find_map(|line| {
        let mut fields = line.split('\t');
        if fields.next()? != record || fields.nth(1)? != law {
            return None;
        }
        let grade = fields.next()?;
        let grade = GRADES.iter().position(|known| known.0 == grade)?;
        Some(Judged { grade, most: fields.next()?.parse().ok()? })
    })
}

pub(super) fn grades() -> Drawing {
    let number = |n: usize| f64::from(u32::try_from(n).unwrap_or(0));
    let wide = (RIGHT - LEFT - GAP * number(STORIES.len() - 1)) / number(STORIES.len() * LAWS.len());
    let bottom = TOP + ROW * number(ENGINES.len());
    let canvas = Canvas::new(412);
    let (mut kept, mut off, mut none) = (Vec::new(), Vec::new(), Vec::new());
    let mut signs = Vec::new();
    let mut broken = [0_u32; ENGINES.len()];
    for (column, (story, title)) in STORIES.iter().enumerate() {
        let left = LEFT + number(column) * (wide * number(LAWS.len()) + GAP);
        let middle = left + 0.5 * wide * number(LAWS.len());
        canvas.label((middle, 24.0), &Label::new(*title).size(15.0).bold().middle());
        for (place, (law, head)) in LAWS.iter().enumerate() {
            let x = left + wide * number(place);
            canvas.label((x + 0.5 * wide, TOP - 10.0), &Label::new(*head).size(12.0).middle());
            for (row, (engine, _)) in ENGINES.iter().enumerate() {
                let y = TOP + ROW * number(row);
                let tile = [x, y, x + wide, y + ROW];
                let found = judged(engine, story, law);
                match &found {
                    Some(found) if found.most > ALLOWED => {
                        broken[row] += 1;
                        off.push(tile);
                    }
                    Some(_) => kept.push(tile),
                    None => none.push(tile),
                }
                let (grade, ink) = found.map_or((GRADES.len() - 1, Ink::Text), |found| {
                    (found.grade, if found.most > ALLOWED { Ink::Paper } else { Ink::Text })
                });
                signs.push(((x + 0.5 * wide, y + 18.0), GRADES[grade].1, ink));
            }
        }
    }
    for (row, (_, name)) in ENGINES.iter().enumerate() {
        let y = TOP + ROW * number(row) + 18.0;
        canvas.label((LEFT - 8.0, y), &Label::new(*name).size(13.0).end());
    }
    let outline = Some(Pen::new(Ink::Faint, 0.8));
    canvas.tiles(&kept, Fill::new(Ink::Paper), outline);
    canvas.tiles(&none, Fill::new(Ink::Faint).opacity(0.25), outline);
    canvas.tiles(&off, Fill::new(Ink::Wrong), outline);
    for (at, sign, ink) in signs {
        if !sign.is_empty() {
            canvas.label(at, &Label::new(sign).size(13.5).ink(ink).middle());
        }
    }
    let y = bottom + 32.0;
    let keys =
        [(24.0, &kept, "within 1 in 100"), (196.0, &off, "off by more"), (340.0, &none, "not recorded")];
    for (x, like, word) in keys {
        let tile = [[x, y - 14.0, x + 20.0, y + 4.0]];
        let fill = match like {
            like if std::ptr::eq(like, &raw const off) => Fill::new(Ink::Wrong),
            like if std::ptr::eq(like, &raw const none) => Fill::new(Ink::Faint).opacity(0.25),
            _ => Fill::new(Ink::Paper),
        };
        canvas.tiles(&tile, fill, outline);
        canvas.label((x + 28.0, y), &Label::new(word).size(14.0));
    }
    let words: [&[(f64, &str)]; 3] = [
        &[(24.0, "empty: kept to rounding"), (230.0, "b: bounded"), (346.0, "w: as a random walk")],
        &[
            (24.0, "1: as time"),
            (120.0, "2: faster than that"),
            (270.0, "e: exponentially"),
            (410.0, "g: grew, then stayed"),
        ],
        &[
            (24.0, "E: energy"),
            (130.0, "$|L|$, $∠L$: length and direction of $L$"),
            (440.0, "s: $2EI_2/L^2$"),
        ],
    ];
    for (k, line) in words.iter().enumerate() {
        for (x, text) in line {
            canvas.label((*x, y + 29.0 + 24.0 * number(k)), &Label::new(*text).size(13.5));
        }
    }
    let said: Vec<String> =
        ENGINES.iter().zip(broken).map(|((_, name), count)| format!("{name}: {count}")).collect();
    Ok(Picture {
        canvas,
        description: format!(
            "A table of squares, a row for each recorded engine, four columns for each of six stories: energy, length and direction of the \
             momentum, and the place beside the separatrix. A filled square is off by more than 1 in 100, a sign says how the error \
             grew. Filled squares by engine: {}.",
            said.join("; ")
        ),
    })
}

/// A panel of the other figure: the record, its title, where the sheet has it.
struct Panel {
    story: &'static str,
    title: &'static str,
    text: [&'static str; 4],
}

/// A record's energy in parts of the first, and the spin along the middle axis, at each time, s.
fn seen(text: &str, middle: usize) -> Result<Vec<[f64; 3]>, Box<dyn std::error::Error>> {
    let head = text.split_once("moments ").ok_or("no moments")?.1;
    let moments: Result<Vec<f64>, _> = head.split(' ').take(3).map(str::parse).collect();
    let moments = Vector3::from_vec(moments?);
    let mut rows: Vec<[f64; 3]> = Vec::new();
    let mut first = None;
    for line in text.lines().skip(2) {
        let numbers: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
        let numbers = numbers?;
        let [step, .., x, y, z] = numbers[..] else { return Err("a short line".into()) };
        let omega = Vector3::new(x, y, z);
        let energy = omega.dot(&moments.component_mul(&omega));
        if energy == 0.0 {
            break; // put to rest
        }
        let first = *first.get_or_insert(energy);
        rows.push([step / 60.0, energy / first, omega[middle]]);
    }
    Ok(rows)
}

macro_rules! records {
    ($story:literal) => {
        [
            include_str!(concat!("../../../tests/data/engines/mujoco-4.0.0-euler--", $story, ".csv")),
            include_str!(concat!("../../../tests/data/engines/rapier3d-f64-0.36.1--", $story, ".csv")),
            include_str!(concat!("../../../tests/data/engines/bullet-3.2.7-rigid--", $story, ".csv")),
            include_str!(concat!("../../../tests/data/engines/mujoco-4.0.0-rk4--", $story, ".csv")),
        ]
    };
}

pub(super) fn energies() -> Drawing {
    let panels = [
        Panel { story: "box-middle", title: "the box: flips", text: records!("box-middle") },
        Panel { story: "middle", title: "middle axis: flips", text: records!("middle") },
        Panel { story: "major", title: "largest axis: stable", text: records!("major") },
        Panel { story: "minor", title: "smallest axis: stable", text: records!("minor") },
    ];
    let pens = [
        Pen::new(Ink::Wrong, 2.6),
        Pen::new(Ink::Wrong, 2.4).dash_dotted(),
        Pen::new(Ink::Wrong, 2.6).dotted(),
        Pen::new(Ink::Text, 3.2),
    ];
    let names = [
        "MuJoCo, Euler; Bullet, multibody: alike",
        "Rapier",
        "Bullet, rigid body; MuJoCo, implicitfast: alike",
        "MuJoCo, RK4: on the exact line",
    ];
    let canvas = Canvas::new(766);
    let mut said = Vec::new();
    for (k, panel) in panels.iter().enumerate() {
        let (left, top) = (if k % 2 == 0 { 70.0 } else { 394.0 }, if k < 2 { 182.0 } else { 474.0 });
        let plot = Plot::new(
            &canvas,
            left,
            top,
            left + 272.0,
            top + 226.0,
            Scale::linear(0.0..20.0),
            Scale::log(0.2..30.0),
        );
        let times = [0, 5, 10, 15, 20].map(|t| (f64::from(t), t.to_string()));
        plot.x_axis(times, if k < 2 { "" } else { "time $t$ (s)" });
        let ticks = [(0.3, "0.3"), (1.0, "1"), (3.0, "3"), (10.0, "10"), (30.0, "30")];
        plot.y_axis(ticks.map(|(y, text)| (y, text.to_owned())), "");
        canvas.label((left, top - 12.0), &Label::new(panel.title).size(15.5).bold());
        let middle = if panel.story == "box-middle" { 0 } else { 1 };
        let mut last = Vec::new();
        for (text, pen) in panel.text.into_iter().zip(pens) {
            let rows = seen(text, middle)?;
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
        said.push(format!("{}: {}.", panel.title, last.join(", ")));
    }
    for (k, (name, pen)) in names.into_iter().zip(pens).enumerate() {
        let number = f64::from(u32::try_from(k).unwrap_or(0));
        let (x, y) = (24.0, 22.0 + 24.0 * number);
        canvas.line((x, y - 5.0), (x + 34.0, y - 5.0), pen);
        canvas.label((x + 42.0, y), &Label::new(name).size(14.5));
    }
    canvas.label((24.0, 134.0), &Label::new("kinetic energy, in parts of what it was").size(14.5));
    Ok(Picture {
        canvas,
        description: format!(
            "Kinetic energy of four recorded bodies over 20 s, in parts of what it was, on a scale of powers. The exact motion stays at \
             1. In the order {}: {}",
            names.join(", "),
            said.join(" ")
        ),
    })
}
