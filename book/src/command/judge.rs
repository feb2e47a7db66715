//! The command `judge`: that of the judge, with a picture of the verdict and the chapter that says more.

use crate::site::chapters::chapter;
use clap::Args;
use std::path::PathBuf;
use std::process::ExitCode;
use tumbling_judge::Verdict;

/// How a record is judged.
#[derive(Debug, Args)]
#[group(skip)]
pub(crate) struct Arguments {
    #[command(flatten)]
    record: tumbling_judge::Arguments,
    /// Draw the verdict into this file
    #[arg(long, value_name = "OUT")]
    svg: Option<PathBuf>,
}

/// Judges a record and prints the verdict, and where the book says more of what it advises.
pub(crate) fn run(arguments: &Arguments) -> ExitCode {
    arguments.record.run(|verdict| {
        if let Some(out) = &arguments.svg {
            let draw = || -> Result<(), Box<dyn std::error::Error>> {
                Ok(std::fs::write(out, tumbling_figures::verdict(verdict)?)?)
            };
            draw().map_err(|wrong| format!("{}: {wrong}", out.display()))?;
        }
        Ok(more(verdict).unwrap_or_default())
    })
}

fn more(verdict: &Verdict) -> Option<String> {
    let advice = verdict.diagnosis.as_ref()?.advice;
    Some(format!("More about it: chapter {}.\n", chapter(advice)?))
}
