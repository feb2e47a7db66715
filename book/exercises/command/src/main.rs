//! Runs exercises of the book from the files that the reader edits: `cargo exercise NAME`.
//!
//! A program and not `cargo test` alone, for that calls a name that does not exist a success, and a file that
//! was emptied; and it tells one good sentence among ten lines of its own.

use std::io::{self, Write as _};
use std::process::ExitCode;
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
             `cargo run -- exercises` lists them all and says which are done."
            .into());
    }
    for name in names {
        if all.iter().all(|exercise| exercise.name != *name) {
            let near = nearest(name, &all).map_or(String::new(), |near| format!(" Did you mean `{near}`?"));
            return Err(format!(
                "There is no exercise `{name}`.{near} `cargo run -- exercises` lists them all."
            ));
        }
    }
    let folder = exercises::stubs();
    exercises::lay_out(&all, &folder)?;
    exercises::readable(&all, &folder)?;
    for exercise in all.iter().filter(|exercise| names.contains(&exercise.name)) {
        if let Some(fault) = exercises::fault(exercise, &exercises::file(exercise, &folder)?) {
            let _ = writeln!(io::stderr(), "{fault}");
            return Ok(ExitCode::FAILURE);
        }
    }
    let mut waiting = false;
    let output = exercises::run(names, |line| {
        if !waiting && line.trim_start().starts_with("Compiling ") {
            waiting = true;
            let _ = writeln!(io::stderr(), "Compiling once, about a minute ...");
        } else if line.contains("waiting for file lock") {
            let _ = writeln!(io::stderr(), "{}", line.trim());
        }
    })?;
    match exercises::verdict(names, &output) {
        Err(why) => {
            let _ = writeln!(io::stderr(), "{why}");
            Ok(ExitCode::FAILURE)
        }
        Ok(()) => {
            let _ = writeln!(
                io::stdout(),
                "Solved: {}. `cargo run -- exercises next` names the next.",
                names.join(", ")
            );
            Ok(ExitCode::SUCCESS)
        }
    }
}

/// The exercise whose name comes nearest to one that does not exist, if any is like it.
fn nearest<'a>(wrong: &str, all: &'a [exercises::Exercise]) -> Option<&'a str> {
    let like =
        |exercise: &'a exercises::Exercise| (strsim::jaro(wrong, &exercise.name), exercise.name.as_str());
    let near = all.iter().map(like).max_by(|a, b| a.0.total_cmp(&b.0));
    near.filter(|(likeness, _)| *likeness > 0.7).map(|(_, name)| name)
}
