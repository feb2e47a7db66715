//! What a scene costs by its outputs, in processor instructions; and what each part of the workspace adds to
//! a build.
//!
//! Two tables in one record: `executed` (counted by valgrind, the same to a few in every run) and `compiled`
//! (crates, and seconds of a build). Each run renews its own tables and leaves the others as they are.

use crate::instructions::{Again, counted};
use crate::record::{Record, Wrong};
use crate::saving::Saving;
use nalgebra::Vector3;
use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::time::Instant;
use tumbling::step::Torque;
use tumbling_scenes::{Error, InitialState, Outputs, Scene, Times};

/// Instructions for a state.
pub const STATE: &str = "instructions for a state";
/// Instructions for a plan.
pub const PLAN: &str = "instructions for a plan";

/// The number of a table, row and kind.
#[must_use]
pub fn value(rows: &[Saving], table: &str, row: &str, what: &str) -> Option<f64> {
    rows.iter().find(|one| one.table == table && one.row == row && one.what == what).map(|one| one.value)
}

/// How many states each scene has,
const STATES: u32 = 960;
/// and how far apart they are, s.
const APART: f64 = 1.0 / 60.0;

/// A scene whose cost is counted.
#[derive(Debug, Clone)]
pub struct Counted {
    /// What it is called in the record.
    pub name: &'static str,
    /// It.
    pub scene: Scene,
}

/// The scenes, the cheapest first: from nothing that moves to a torque.
///
/// # Errors
/// A scene that the library refuses.
pub fn scenes() -> Result<Vec<Counted>, Error> {
    let uneven = Vector3::new(10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0);
    let (ball, coin) = (Vector3::new(0.4, 0.4, 0.4), Vector3::new(0.5, 0.5, 1.0));
    let (tumbling, along, oblique) =
        (Vector3::new(1.0, 0.01, 0.01), Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.3, 0.2, 1.0));
    let spin = Outputs { spin: true, ..Outputs::NOTHING };
    let both = Outputs { attitude: true, ..spin };
    let kept = Outputs { energy: true, flips: true, ..Outputs::NOTHING };
    let free = [
        ("energy and flips alone", uneven, tumbling, kept),
        ("ball; spin alone", ball, oblique, spin),
        ("principal spin; spin alone", uneven, along, spin),
        ("two equal moments; spin alone", coin, oblique, spin),
        ("three moments; spin alone", uneven, tumbling, spin),
        ("ball", ball, oblique, both),
        ("principal spin", uneven, along, both),
        ("two equal moments", coin, oblique, both),
        ("three moments", uneven, tumbling, both),
    ];
    let end = f64::from(STATES - 1) * APART;
    let times = || Times::every(APART, end);
    let mut scenes = Vec::new();
    for (name, moments, omega, wants) in free {
        let scene =
            Scene::new(vec![InitialState::spinning(moments, omega)], Vec::new(), times(), wants, 1e-9)?;
        scenes.push(Counted { name, scene });
    }
    let weight = || vec![Torque::gravity(&Vector3::new(0.05, 0.0, 0.1), 0.5)];
    for (name, accuracy) in
        [("three moments and a weight; to 1e-2", 1e-2), ("three moments and a weight; to 1e-8", 1e-8)]
    {
        let scene =
            Scene::new(vec![InitialState::spinning(uneven, tumbling)], weight(), times(), both, accuracy)?;
        scenes.push(Counted { name, scene });
    }
    Ok(scenes)
}

/// The scene with nothing left out.
pub const GENERAL: &str = "three moments";

/// What the program does when it is run again under valgrind: a number of plans of the scene of this name,
/// and of each a number of times all states.
///
/// # Errors
/// A name that no scene has, or what the library refuses.
pub fn child(name: &str, plans: u64, rounds: u64) -> Result<(), String> {
    let scenes = scenes().map_err(|error| error.to_string())?;
    let one = scenes.iter().find(|one| one.name == name).ok_or("no scene has that name")?;
    for _ in 0..plans {
        let plan = black_box(&one.scene).plan(0).map_err(|error| error.to_string())?;
        for _ in 0..rounds {
            for state in black_box(&plan).states() {
                black_box(state).map_err(|error| error.to_string())?;
            }
        }
        black_box(&plan);
    }
    Ok(())
}

/// The table of instructions, by differences of runs, so that the start of the program falls out.
///
/// # Errors
/// Where valgrind is not installed or does not get through.
pub fn executed(again: &Again, tell: &mut dyn FnMut(&str)) -> Result<Vec<Saving>, Wrong> {
    let mut rows = Vec::new();
    for one in scenes().map_err(|error| error.to_string())? {
        tell(&format!("instructions of {}", one.name));
        let count = |plans: u64, rounds: u64| {
            let words = [one.name.to_owned(), plans.to_string(), rounds.to_string()];
            counted(again, &words).map(|count| count as f64).ok_or("valgrind is needed, and did not count")
        };
        let state = (count(1, 3)? - count(1, 1)?) / (2.0 * f64::from(STATES));
        let plan = (count(3, 0)? - count(1, 0)?) / 2.0;
        for (what, value) in [(STATE, state), (PLAN, plan)] {
            let value = value.round();
            rows.push(Saving { table: "executed".into(), row: one.name.into(), what: what.into(), value });
        }
    }
    Ok(rows)
}

/// What is built, each after those before it: its name, and cargo's arguments.
const BUILDS: [(&str, &[&str]); 10] = [
    ("the library", &["-p", "tumbling"]),
    ("scenes", &["-p", "tumbling-scenes", "--no-default-features"]),
    ("scenes from files", &["-p", "tumbling-scenes"]),
    ("scenes on all threads", &["-p", "tumbling-scenes", "--features", "threads"]),
    ("measuring", &["-p", "tumbling-measure"]),
    ("the judge", &["-p", "tumbling-judge"]),
    ("the proofs", &["-p", "tumbling-proofs"]),
    ("the figures", &["-p", "tumbling-figures"]),
    ("the book", &["-p", "tumbling-book"]),
    ("the peers (in no default build)", &["--manifest-path", "crates/measure/peers/Cargo.toml"]),
];

/// Crates of the table `compiled`.
pub const CRATES: &str = "crates";
/// Crates that none before it needed.
pub const MORE: &str = "crates more";
/// Seconds that the build took after the builds before it.
pub const SECONDS: &str = "seconds more";

/// The table of builds: with `time`, each is built in a fresh folder after those before it.
///
/// # Errors
/// Where cargo does not get through.
pub fn compiled(root: &Path, time: Option<&Path>, tell: &mut dyn FnMut(&str)) -> Result<Vec<Saving>, Wrong> {
    let cargo = || {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.current_dir(root);
        cargo
    };
    let tree = |arguments: &[&str]| -> Result<Vec<String>, Wrong> {
        let output = cargo()
            .args(["tree", "-e", "normal,build", "--prefix", "none", "--no-dedupe", "--locked"])
            .args(arguments)
            .output()
            .map_err(|error| error.to_string())?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into_owned());
        }
        let text = String::from_utf8_lossy(&output.stdout);
        let mut crates: Vec<String> =
            text.lines().map(|line| line.split_whitespace().take(2).collect::<Vec<_>>().join(" ")).collect();
        crates.retain(|name| !name.is_empty());
        crates.sort();
        crates.dedup();
        Ok(crates)
    };
    let mut rows = Vec::new();
    let mut add = |row: &str, what: &str, value: f64| {
        rows.push(Saving { table: "compiled".into(), row: row.into(), what: what.into(), value });
    };
    let mut before: Vec<String> = Vec::new();
    for (name, arguments) in BUILDS {
        tell(&format!("the build of {name}"));
        let crates = tree(arguments)?;
        let more = crates.iter().filter(|one| !before.contains(one)).count();
        add(name, CRATES, crates.len() as f64);
        add(name, MORE, more as f64);
        before.extend(crates);
        if let Some(folder) = time {
            let start = Instant::now();
            let done = cargo()
                .args(["build", "--release", "--quiet", "--locked", "--target-dir"])
                .arg(folder)
                .args(arguments)
                .status()
                .map_err(|error| error.to_string())?;
            if !done.success() {
                return Err(format!("{name} was not built"));
            }
            add(name, SECONDS, (10.0 * start.elapsed().as_secs_f64()).round() / 10.0);
        }
    }
    Ok(rows)
}

/// What the head of the record says.
#[must_use]
pub fn head() -> Vec<(String, String)> {
    let what = [
        ("what", "what a scene costs by what is asked; and a build by what is in it"),
        ("executed", "processor instructions, counted by valgrind: for a plan, and for each of its states"),
        (
            "compiled",
            "crates, with build programs; those that none before needed; seconds of the release build after those before",
        ),
    ];
    let mut head: Vec<(String, String)> =
        what.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    head.extend(crate::setup::describe());
    head
}

/// The record with new rows in place of the old ones of the same tables.
#[must_use]
pub fn renewed(old: Record<Saving>, rows: Vec<Saving>) -> Record<Saving> {
    // Seconds are kept until they are measured again: that takes minutes of a machine that does nothing else.
    let timed = rows.iter().any(|row| row.what == SECONDS);
    let kept = old
        .rows
        .into_iter()
        .filter(|row| rows.iter().all(|new| new.table != row.table) || (row.what == SECONDS && !timed));
    let mut all: Vec<Saving> = rows.iter().cloned().chain(kept).collect();
    let order = |row: &Saving| ["executed", "compiled"].iter().position(|table| *table == row.table);
    all.sort_by_key(|row| order(row).unwrap_or(usize::MAX));
    Record { head: head(), rows: all }
}

/// By how much a count may differ from the recorded one: another compiler orders the work otherwise.
const ROOM: f64 = 0.25;

/// Where counts are not those of the record.
#[must_use]
pub fn differences(recorded: &[Saving], counted: &[Saving]) -> Vec<String> {
    let mut lines = Vec::new();
    for new in counted {
        match value(recorded, &new.table, &new.row, &new.what) {
            Some(old) if (new.value - old).abs() <= ROOM * old + 50.0 => {}
            Some(old) => {
                lines.push(format!("{}, {}: {} where the record has {old}", new.row, new.what, new.value))
            }
            None => lines.push(format!("{}, {}: not in the record", new.row, new.what)),
        }
    }
    lines
}
