//! Runs exercises of the book from the files that the reader edits: `cargo exercise NAME`.
//!
//! A program and not `cargo test` alone, for that calls a name that does not exist a success.

#[path = "../../src/nearest.rs"]
mod nearest;

use std::io::{self, Write as _};
use std::process::{Command, ExitCode};
use tumbling_exercises as exercises;

fn main() -> ExitCode {
    match run(&std::env::args().skip(1).collect::<Vec<_>>()) {
        Ok(code) => code,
        Err(why) => {
            let _ = writeln!(io::stderr(), "{why}");
            ExitCode::from(2)
        }
    }
}

fn run(names: &[String]) -> Result<ExitCode, String> {
    let all = exercises::all()?;
    if names.is_empty() || names.iter().any(|name| name.starts_with('-')) {
        return Err("usage: cargo exercise NAME, such as `cargo exercise two_arrows_1`\n\
             `cargo run --release -- exercises` lists them all and says which are done."
            .into());
    }
    for name in names {
        if all.iter().all(|exercise| exercise.name != *name) {
            let near = nearest::perhaps(name, all.iter().map(|exercise| exercise.name.as_str()));
            return Err(format!(
                "There is no exercise `{name}`.{near} `cargo run --release -- exercises` lists them all."
            ));
        }
    }
    let status = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["test", "--quiet", "--package", "tumbling-exercises", "--doc", "--features", "mine", "--"])
        .args(names)
        // What is read is the assertion's message, not the way there.
        .env("RUST_BACKTRACE", "0")
        .status()
        .map_err(|error| format!("cargo did not start: {error}"))?;
    if !status.success() {
        return Ok(ExitCode::FAILURE);
    }
    let _ = writeln!(
        io::stdout(),
        "Solved: {}. `cargo run --release -- exercises next` names the next.",
        names.join(", ")
    );
    Ok(ExitCode::SUCCESS)
}
