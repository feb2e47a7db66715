//! Draws the figures and builds the book; `--help` lists the commands.

mod cli;
mod command;
mod guard;
mod language;
mod paper;
mod preprocess;
mod site;

use clap::Parser as _;
use std::process::ExitCode;

/// Writes a line to standard output. A reader that went away (`| head`) is no reason to stop, nor to
/// complain: the work goes on.
macro_rules! say {
    ($($arg:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stdout().lock(), $($arg)*);
    }};
}
pub(crate) use say;

/// Writes a line to standard error.
macro_rules! complain {
    ($($arg:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr().lock(), $($arg)*);
    }};
}
pub(crate) use complain;

fn main() -> ExitCode {
    match cli::run(cli::Cli::parse()) {
        Ok(code) => code,
        Err(reason) => {
            complain!("error: {reason}");
            ExitCode::FAILURE
        }
    }
}
