//! The command `measure`: error against run time, on this machine.

use crate::{paths, say};
use std::error::Error;
use std::io::{IsTerminal as _, Write as _};
use std::process::Command;
use std::time::Instant;
use tumbling_measure::campaign::{self, Campaign};
use tumbling_measure::instructions::{self, Again};
use tumbling_measure::measure::Effort;
use tumbling_measure::record::{self, Record};
use tumbling_measure::{atlas as places, contestant, savings, story};

/// Measures the library's methods, or has the peers' own program measure them with the peers.
pub(crate) fn measure(quick: bool, peers: bool) -> Result<(), Box<dyn Error>> {
    let folder = paths::repository().join("measure").join(if quick { "quick" } else { "record" });
    let start = Instant::now();
    if peers {
        let mut cargo = peers_program();
        cargo.args(["--", "--into"]).arg(&folder);
        if quick {
            cargo.arg("--quick");
        }
        through(cargo)?;
    } else {
        let contestants = contestant::ours();
        let effort = if quick { Effort::QUICK } else { Effort::FULL };
        let words = ["measure", "count"].map(Into::into).to_vec();
        let again = Again { program: std::env::current_exe()?.into(), words };
        let campaign = Campaign { contestants: &contestants, effort, again: Some(again), head: Vec::new() };
        say!("{}", campaign::write(&campaign, &folder, &mut progress())?);
    }
    say!("Measured in {:.0} s. The record is in", start.elapsed().as_secs_f64());
    say!("{}", folder.display());
    if !quick {
        say!(
            "Draw its figures with `cargo run --release`. The book's own record: `git checkout measure/record`."
        );
    }
    Ok(())
}

/// How the program of the peers is run.
fn peers_program() -> Command {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    let manifest = paths::repository().join("measure/peers/Cargo.toml");
    cargo.args(["run", "--release", "--manifest-path"]).arg(manifest);
    cargo
}

fn through(mut cargo: Command) -> Result<(), Box<dyn Error>> {
    if cargo.status()?.success() {
        Ok(())
    } else {
        Err("the program of the peers did not get through".into())
    }
}

/// Many bodies, beside Rapier: by a build for any machine, then by one for this machine.
pub(crate) fn scale(quick: bool) -> Result<(), Box<dyn Error>> {
    let measure = paths::repository().join("measure");
    let folder = measure.join(if quick { "quick" } else { "record" });
    let start = Instant::now();
    let asked = |build: &str, native: bool| {
        let mut cargo = peers_program();
        cargo.args(["--no-default-features", "--", "scale", build, "--into"]).arg(&folder);
        if quick {
            cargo.arg("--quick");
        }
        if native {
            // Where it is not in the way of the other build.
            let target = measure.join("peers/target/native");
            cargo.env("RUSTFLAGS", "-C target-cpu=native").env("CARGO_TARGET_DIR", target);
            cargo.arg("--after").arg(folder.join("scale.csv"));
        } else {
            cargo.env_remove("RUSTFLAGS");
        }
        cargo
    };
    through(asked("default", false))?;
    through(asked("native", true))?;
    say!("Measured in {:.0} s. The record is in", start.elapsed().as_secs_f64());
    say!("{}", folder.join("scale.csv").display());
    Ok(())
}

/// Runs every method on every hard case, prints what became of each and renews the record of it.
pub(crate) fn atlas() -> Result<(), Box<dyn Error>> {
    let places = places::atlas()?;
    say!("{}", places::table(&places));
    let file = paths::repository().join("measure/record/atlas.tsv");
    std::fs::write(&file, places::written(&places))
        .map_err(|error| format!("{}: {error}", file.display()))?;
    say!("The record is in {}", file.display());
    Ok(())
}

/// On a terminal one line that changes, else a line for each piece of work.
fn progress() -> impl FnMut(&str) {
    let terminal = std::io::stderr().is_terminal();
    move |what| {
        let mut out = std::io::stderr().lock();
        let _ = if terminal { write!(out, "\r\x1b[K{what}") } else { writeln!(out, "{what}") };
        let _ = out.flush();
    }
}

/// The longest run.
pub(crate) fn longest(method: &str) -> Result<(), Box<dyn Error>> {
    let folder = paths::repository().join("measure/record");
    say!("{}", campaign::longest(method, campaign::LONGEST, &folder)?);
    Ok(())
}

/// A short run, so many times: what valgrind watches.
pub(crate) fn count(name: &str, times: u64) -> Result<(), Box<dyn Error>> {
    instructions::child(&contestant::ours(), &story::all()?, name, times)?;
    Ok(())
}

/// Counts what scenes cost; renews the record with that and with what each part brings to a build, or holds the record to it.
pub(crate) fn scenes(check: bool, builds: bool) -> Result<(), Box<dyn Error>> {
    let words = ["measure", "scene"].map(Into::into).to_vec();
    let again = Again { program: std::env::current_exe()?.into(), words };
    let mut rows = savings::executed(&again, &mut progress())?;
    let old = record::scenes()?;
    if check {
        let told = savings::differences(&old.rows, &rows);
        if told.is_empty() {
            say!("{} counts are those of the record.", rows.len());
            return Ok(());
        }
        return Err(told.join("\n").into());
    }
    let folder = std::env::temp_dir().join(format!("tumbling-builds-{}", std::process::id()));
    let built = savings::compiled(paths::repository(), builds.then_some(folder.as_path()), &mut progress());
    // What cannot be removed is the system's to remove.
    let _ = std::fs::remove_dir_all(&folder);
    rows.extend(built?);
    let file = paths::repository().join("measure/record/scenes.csv");
    // The record as it is now, not as it was when this program was compiled.
    let now = std::fs::read_to_string(&file).ok().and_then(|text| Record::read(&text).ok());
    std::fs::write(&file, savings::renewed(now.unwrap_or(old), rows).write())
        .map_err(|error| format!("{}: {error}", file.display()))?;
    say!("The record is in {}", file.display());
    Ok(())
}

/// A scene, so many times: what valgrind watches.
pub(crate) fn count_scene(name: &str, plans: u64, rounds: u64) -> Result<(), Box<dyn Error>> {
    Ok(savings::child(name, plans, rounds)?)
}
