//! Judges how an engine turns a free body: `cargo run -p tumbling-judge -- run.csv`.

use clap::Parser;
use std::process::ExitCode;
use tumbling_judge::Arguments;

/// Judges an engine by its record of a free body
#[derive(Parser)]
#[command(version)]
struct Judge {
    #[command(flatten)]
    arguments: Arguments,
}

fn main() -> ExitCode {
    Judge::parse().arguments.run(|_| Ok(String::new()))
}
