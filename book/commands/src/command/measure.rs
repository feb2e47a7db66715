//! The commands `measure` and `atlas`: error against run time on this machine, and every method on every hard
//! case.

use clap::{Args, Subcommand};
use std::error::Error;
use std::io::{IsTerminal as _, Write as _};
use std::time::Instant;
use tumbling_measure::measure::Effort;
use tumbling_measure::{atlas as hard, campaign, contestant, setup};
use tumbling_site::docs::cargo;
use tumbling_site::{paths, say};

/// The measurements.
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
}

#[derive(Debug, Subcommand)]
enum What {
    /// Count what scenes cost by their outputs; needs valgrind
    ///
    /// Renews crates/measure/record/scenes.csv.
    Scenes {
        /// Write nothing; fail where the record differs
        #[arg(long)]
        check: bool,
    },
}

/// Carries out the command.
pub(crate) fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    match &arguments.what {
        Some(What::Scenes { check }) => {
            let example =
                ["run", "--release", "--quiet", "-p", "tumbling-measure", "--example", "scene_costs", "--"];
            Ok(cargo(&[&example[..], if *check { &["--check"] } else { &[] }].concat())?)
        }
        None => measure(arguments.quick, arguments.peers),
    }
}

/// Measures the library's methods, or has the peers' own program measure them with the peers.
fn measure(quick: bool, peers: bool) -> Result<(), Box<dyn Error>> {
    if !setup::IS_RELEASE {
        return Err("times of a build for tests say nothing: `cargo run --release -- measure`".into());
    }
    let folder = paths::repository().join("crates/measure").join(if quick { "quick" } else { "record" });
    let start = Instant::now();
    if peers {
        let program =
            ["run", "--release", "--manifest-path", "crates/measure/peers/Cargo.toml", "--", "--into"];
        let folder = folder.to_string_lossy();
        cargo(&[&program[..], &[&*folder], if quick { &["--quick"] } else { &[] }].concat())?;
    } else {
        let effort = if quick { Effort::QUICK } else { Effort::FULL };
        say!("{}", campaign::write(&contestant::ours(), effort, &[], &folder, &mut progress())?);
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

/// Runs every method on every hard case and prints how each ends.
pub(crate) fn atlas() -> Result<(), Box<dyn Error>> {
    let cases = hard::cases()?;
    say!("{}", hard::text(&cases, &hard::fates(&cases)?).trim());
    Ok(())
}

/// On a terminal, one line that changes; otherwise a line for each part of the work.
fn progress() -> impl FnMut(&str) {
    let terminal = std::io::stderr().is_terminal();
    move |what| {
        let mut out = std::io::stderr().lock();
        let _ = if terminal { write!(out, "\r\x1b[K{what}") } else { writeln!(out, "{what}") };
        let _ = out.flush();
    }
}
