//! Measures published integrators and a whole engine beside the tumbling library, in one run.
//!
//! ```text
//! cargo run --release --manifest-path crates/measure/peers/Cargo.toml -- [--quick] --into FOLDER
//! cargo run --release --manifest-path crates/measure/peers/Cargo.toml -- trials COUNT SEED [--more]
//! ```

#[cfg(feature = "solvers")]
mod dop853;
#[cfg(feature = "solvers")]
mod law;
mod python;
mod rapier;
mod scale;
#[cfg(feature = "solvers")]
mod trials;
#[cfg(feature = "solvers")]
mod tsit45;

use std::io::{IsTerminal as _, Write as _};
use std::path::PathBuf;
use std::process::ExitCode;
use tumbling_measure::campaign::{self, Campaign};
use tumbling_measure::contestant::{self, Contestant};
use tumbling_measure::instructions::{self, Again};
use tumbling_measure::measure::Effort;
use tumbling_measure::scale::crowd as crowds;
use tumbling_measure::story::{self, Wrong};

/// The peers with their versions, as the lock file has them.
const LOCKED: &str = include_str!("../Cargo.lock");
const PEERS: &[&str] = if cfg!(feature = "solvers") {
    &["differential-equations", "diffsol", "rapier3d-f64"]
} else {
    &["rapier3d-f64"]
};

fn version(package: &str) -> Option<&'static str> {
    let (_, after) = LOCKED.split_once(&format!("name = \"{package}\"\nversion = \""))?;
    after.split('"').next()
}

fn versions() -> Vec<String> {
    let named = |name: &&str| format!("{name} {}", version(name).unwrap_or("of no known version"));
    PEERS.iter().map(named).collect()
}

fn all() -> Vec<Box<dyn Contestant>> {
    let mut all = contestant::ours();
    #[cfg(feature = "solvers")]
    {
        all.push(Box::new(dop853::Dop853));
        all.push(Box::new(tsit45::Tsit45));
    }
    all.push(Box::new(rapier::Rapier));
    all
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(wrong) => {
            eprintln!("error: {wrong}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Wrong> {
    let mut words = std::env::args().skip(1);
    let (mut effort, mut folder) = (Effort::FULL, None);
    let (mut build, mut with) = (None, None);
    while let Some(word) = words.next() {
        match word.as_str() {
            // How it runs itself again under valgrind.
            "count" => {
                let name = words.next().ok_or("whose steps?")?;
                let times = words.next().ok_or("how many runs?")?.parse()?;
                instructions::child(&all(), &story::all()?, &name, times)?;
                return Ok(());
            }
            // Random scenes under torques: how many, from which seed, and whether torques may depend on the
            // time.
            #[cfg(feature = "solvers")]
            "trials" => {
                let mut number =
                    || -> Result<u64, Wrong> { Ok(words.next().ok_or("a number is missing")?.parse()?) };
                let (count, seed) = (number()?, number()?);
                let more = words.next().is_some_and(|word| word == "--more");
                println!("{}", trials::run(count, seed, more)?);
                return Ok(());
            }
            "--quick" => effort = Effort::QUICK,
            // Many bodies, by a build of this name, after what another build has written.
            "scale" => build = Some(words.next().ok_or("which build?")?),
            "--after" => with = words.next().map(PathBuf::from),
            "--into" => folder = words.next().map(PathBuf::from),
            other => return Err(format!("`{other}` is not understood").into()),
        }
    }
    let folder = folder.ok_or("it needs `--into FOLDER`")?;
    let (mut contestants, mut versions) = (all(), versions());
    if build.is_none() {
        let (found, named) = python::found()?;
        contestants.extend(found);
        versions.extend(named);
    }
    let head = [("peers".to_owned(), versions.join("; "))];
    let terminal = std::io::stderr().is_terminal();
    let mut tell = |what: &str| {
        let mut out = std::io::stderr().lock();
        let _ = if terminal { write!(out, "\r\x1b[K{what}") } else { writeln!(out, "{what}") };
        let _ = out.flush();
    };
    if let Some(build) = build {
        let effort = if effort == Effort::QUICK { crowds::Effort::QUICK } else { crowds::Effort::FULL };
        println!("{}", scale::write(&build, effort, with.as_deref(), &folder, &head, &mut tell)?);
        return Ok(());
    }
    let campaign = Campaign {
        contestants: &contestants,
        effort,
        again: Some(Again { program: std::env::current_exe()?.into(), words: vec!["count".into()] }),
        head: head.to_vec(),
    };
    println!("{}", campaign::write(&campaign, &folder, &mut tell)?);
    Ok(())
}
