//! Counts what scenes cost by what is requested; needs valgrind. Renews `crates/measure/record/scenes.csv`.
//!
//! ```sh
//! cargo run --release -p tumbling-measure --example scene_costs [-- --check]
//! ```
//!
//! With `--check` it writes nothing, and fails where the record says otherwise. The counts are those of this
//! program, compiled for release: it runs itself again under valgrind.

mod counted_scenes;

use counted_scenes::{STATES, scenes};
use std::hint::black_box;
use std::process::Command;
use tumbling_measure::AnyError;
use tumbling_measure::costs::{self, Cost};

/// By how much a count may differ from the recorded one: another compiler produces other instructions.
const ROOM: f64 = 0.25;

fn main() -> Result<(), AnyError> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["scene", name, plans, rounds] => watched(name, plans.parse()?, rounds.parse()?),
        ["--check"] => {
            let (counted, recorded) = (counts()?, costs::recorded()?.rows);
            for cost in &counted {
                let old = costs::of(&recorded, &cost.scene)?;
                for (now, then) in [(cost.plan, old.plan), (cost.state, old.state)] {
                    if (now - then).abs() > ROOM * then + 50.0 {
                        return Err(format!("{}: {now} where the record has {then}", cost.scene).into());
                    }
                }
            }
            println!("The counts of {} scenes are those of the record.", counted.len());
            Ok(())
        }
        [] => {
            let file = concat!(env!("CARGO_MANIFEST_DIR"), "/record/scenes.csv");
            std::fs::write(file, costs::record(counts()?).write()?)?;
            println!("The record is in {file}");
            Ok(())
        }
        _ => Err("it takes nothing, or `--check`".into()),
    }
}

/// The work that valgrind counts: a number of plans of the scene with this name, and for each plan all states
/// a number of times.
fn watched(name: &str, plans: u64, rounds: u64) -> Result<(), AnyError> {
    let scenes = scenes()?;
    let (_, scene) = scenes.iter().find(|(known, _)| *known == name).ok_or("no scene has that name")?;
    for _ in 0..plans {
        let plan = black_box(scene).plan(0)?;
        for _ in 0..rounds {
            for state in black_box(&plan).states() {
                black_box(state)?;
            }
        }
        black_box(&plan);
    }
    Ok(())
}

/// The costs as differences of runs, so that the start of the program cancels.
fn counts() -> Result<Vec<Cost>, AnyError> {
    let cost = |(name, _)| {
        eprintln!("instructions of {name}");
        let (planned, states) = (counted(name, 1, 0)?, 3.0 * f64::from(STATES));
        let state = ((counted(name, 1, 3)? - planned) / states).round();
        Ok(Cost { scene: name.to_owned(), plan: ((counted(name, 3, 0)? - planned) / 2.0).round(), state })
    };
    scenes()?.into_iter().map(cost).collect()
}

/// Instructions of this program run again.
fn counted(name: &str, plans: u32, rounds: u32) -> Result<f64, AnyError> {
    let output = Command::new("valgrind")
        .args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"])
        .arg(std::env::current_exe()?)
        .args(["scene", name, &plans.to_string(), &rounds.to_string()])
        .output()
        .map_err(|error| format!("valgrind is needed: {error}"))?;
    let said = String::from_utf8_lossy(&output.stderr);
    // "==1234== I refs:        170,592"
    let line = said.lines().find(|line| line.contains("I refs") || line.contains("I   refs"));
    let count = line.and_then(|line| line.rsplit(':').next()).filter(|_| output.status.success());
    Ok(count.ok_or_else(|| format!("valgrind did not count: {said}"))?.trim().replace(',', "").parse()?)
}
