//! The command `measure`: error against run time, on this machine.

use crate::say;
use crate::site::paths;
use clap::{Args, Subcommand};
use std::error::Error;
use std::io::{IsTerminal as _, Write as _};
use std::process::Command;
use std::time::Instant;
use tumbling_measure::campaign::{self, Campaign};
use tumbling_measure::instructions::{self, Again};
use tumbling_measure::measure::Effort;
use tumbling_measure::{atlas as places, contestant, story};

/// What to measure.
#[derive(Debug, Args)]
#[command(
    args_conflicts_with_subcommands = true,
    after_help = "`git checkout crates/measure/record` brings the book's own record back."
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    what: Option<What>,
    /// Coarser, in less than a minute, into crates/measure/quick/
    #[arg(long)]
    quick: bool,
    /// Also published solvers and an engine in the same run; compiles some two hundred crates first
    #[arg(long)]
    peers: bool,
    /// A billion turns by one method alone, a quarter of an hour or more
    #[arg(long, value_name = "METHOD", conflicts_with_all = ["quick", "peers"])]
    long: Option<String>,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Count what scenes cost by what is requested, and what crates each part brings; needs valgrind
    ///
    /// Renews crates/measure/record/scenes.csv.
    Scenes {
        /// Write nothing; fail where the record says otherwise
        #[arg(long)]
        check: bool,
        /// Also time the build of each part from nothing, some minutes
        #[arg(long, conflicts_with = "check")]
        builds: bool,
    },
    /// Move a hundred to ten million bodies, and an engine's too, some minutes
    ///
    /// Renews crates/measure/record/scale.csv.
    Scale {
        /// Up to a hundred thousand bodies, into crates/measure/quick/
        #[arg(long)]
        quick: bool,
    },
    /// A short run for valgrind to watch
    #[command(hide = true)]
    Count { contestant: String, times: u64 },
}

/// Carries out the command.
pub(crate) fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    match (&arguments.what, &arguments.long) {
        (Some(What::Scenes { check, builds }), _) => scenes(*check, *builds),
        (Some(What::Scale { quick }), _) => scale(*quick),
        (Some(What::Count { contestant, times }), _) => {
            instructions::child(&contestant::ours(), &story::all()?, contestant, *times)?;
            Ok(())
        }
        (None, Some(method)) => {
            let folder = paths::repository().join("crates/measure/record");
            say!("{}", campaign::longest(method, campaign::LONGEST, &folder)?);
            Ok(())
        }
        (None, None) => measure(arguments.quick, arguments.peers),
    }
}

/// Measures the library's methods, or has the peers' own program measure them with the peers.
fn measure(quick: bool, peers: bool) -> Result<(), Box<dyn Error>> {
    if cfg!(debug_assertions) {
        return Err("times of a build for tests say nothing: `cargo run --release -- measure`".into());
    }
    let folder = paths::repository().join("crates/measure").join(if quick { "quick" } else { "record" });
    let start = Instant::now();
    if peers {
        let mut cargo = peers_program();
        cargo.args(["--", "--into"]).arg(&folder);
        if quick {
            cargo.arg("--quick");
        }
        through(cargo, "the program of the peers")?;
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
            "Draw its figures with `cargo run`. The book's own record: `git checkout crates/measure/record`."
        );
    }
    Ok(())
}

fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// How the program of the peers is run.
fn peers_program() -> Command {
    let mut cargo = cargo();
    let manifest = paths::repository().join("crates/measure/peers/Cargo.toml");
    cargo.args(["run", "--release", "--manifest-path"]).arg(manifest);
    cargo
}

fn through(mut cargo: Command, what: &str) -> Result<(), Box<dyn Error>> {
    if cargo.status()?.success() { Ok(()) } else { Err(format!("{what} failed").into()) }
}

/// Many bodies, beside Rapier: by a build for any machine, then by one for this machine.
fn scale(quick: bool) -> Result<(), Box<dyn Error>> {
    let measure = paths::repository().join("crates/measure");
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
    through(asked("default", false), "the program of the peers")?;
    through(asked("native", true), "the program of the peers")?;
    say!("Measured in {:.0} s. The record is in", start.elapsed().as_secs_f64());
    say!("{}", folder.join("scale.csv").display());
    Ok(())
}

/// Runs every method on every hard case, prints what became of each and renews the record of it.
pub(crate) fn atlas() -> Result<(), Box<dyn Error>> {
    let places = places::atlas()?;
    say!("{}", places::table(&places));
    let file = paths::repository().join("crates/measure/record/atlas.tsv");
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

/// Has the program that counts what scenes cost compiled for release, and run.
fn scenes(check: bool, builds: bool) -> Result<(), Box<dyn Error>> {
    let mut cargo = cargo();
    cargo.args(["run", "--release", "--quiet", "-p", "tumbling-measure", "--example", "scene_costs"]);
    cargo.current_dir(paths::repository()).arg("--");
    cargo.args(check.then_some("--check")).args(builds.then_some("--builds"));
    through(cargo, "the count of what scenes cost")
}
