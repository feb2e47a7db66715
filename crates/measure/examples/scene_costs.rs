//! Counts what scenes cost by what is requested, and what crates each part brings; needs valgrind.
//! Renews `crates/measure/record/scenes.csv`.
//!
//! ```sh
//! cargo run --release -p tumbling-measure --example scene_costs [-- --check | --builds]
//! ```
//!
//! The counts are those of this program, compiled for release: it runs itself again under valgrind.

use clap::{Parser, Subcommand};
use std::error::Error;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use tumbling_measure::instructions::Again;
use tumbling_measure::record::Record;
use tumbling_measure::{saving, savings};

#[derive(Debug, Parser)]
#[command(args_conflicts_with_subcommands = true)]
struct Arguments {
    /// Write nothing; fail where the record says otherwise
    #[arg(long)]
    check: bool,
    /// Also time the build of each part from nothing, some minutes
    #[arg(long, conflicts_with = "check")]
    builds: bool,
    #[command(subcommand)]
    what: Option<What>,
}

#[derive(Debug, Subcommand)]
enum What {
    /// A scene for valgrind to watch
    #[command(hide = true)]
    Scene { name: String, plans: u64, rounds: u64 },
}

fn main() -> Result<(), Box<dyn Error>> {
    let Arguments { check, builds, what } = Arguments::parse();
    if let Some(What::Scene { name, plans, rounds }) = what {
        return Ok(savings::child(&name, plans, rounds)?);
    }
    let mut progress = |what: &str| eprintln!("{what}");
    let again = Again { program: std::env::current_exe()?.into(), words: vec!["scene".into()] };
    let mut rows = savings::executed(&again, &mut progress)?;
    let old = saving::recorded()?;
    if check {
        let differences = savings::differences(&old.rows, &rows);
        if differences.is_empty() {
            println!("{} counts are those of the record.", rows.len());
            return Ok(());
        }
        return Err(differences.join("\n").into());
    }
    let folder = builds.then(TempDir::new).transpose()?;
    let folder = folder.as_ref().map(TempDir::path);
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    rows.extend(savings::compiled(&repository, folder, &mut progress)?);
    let file = repository.join("crates/measure/record/scenes.csv");
    // The record as it is now, not as it was when this program was compiled.
    let now = fs::read_to_string(&file).ok().and_then(|text| Record::read(&text).ok());
    fs::write(&file, savings::renewed(now.unwrap_or(old), rows).write())
        .map_err(|error| format!("{}: {error}", file.display()))?;
    println!("The record is in {}", file.display());
    Ok(())
}
