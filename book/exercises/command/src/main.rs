//! Runs exercises of the book from the files that the reader edits, `cargo exercise NAME`; and, as
//! `cargo run -- exercises`, says which are done and which comes next.
//!
//! A program and not `cargo test` alone, for that calls a name that does not exist a success, and a file that
//! was emptied; and it tells one good sentence among ten lines of its own.

mod progress;

use std::fmt::Display;
use std::io::{self, Write as _};
use std::process::ExitCode;
use tumbling_exercises::{self as exercises, Exercise};

fn main() -> ExitCode {
    let words = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned());
    match run(&words.collect::<Vec<_>>()) {
        Ok(code) => code,
        Err(why) => {
            complain(why);
            ExitCode::from(2)
        }
    }
}

/// Writes a line to standard output.
fn say(line: impl Display) {
    let _ = writeln!(io::stdout(), "{line}");
}

/// Writes a line to standard error.
fn complain(line: impl Display) {
    let _ = writeln!(io::stderr(), "{line}");
}

/// What is no name of an exercise.
const WORDS: [&str; 4] = ["list", "next", "reset", "untouched"];

fn run(words: &[String]) -> Result<ExitCode, String> {
    let all = exercises::all()?;
    let (word, names) = match words.split_first() {
        Some((word, names)) if WORDS.contains(&word.as_str()) => (word.as_str(), names),
        _ => ("", words),
    };
    let named = ["", "reset"].contains(&word);
    if names.is_empty() == named || names.iter().any(|name| name.starts_with('-')) {
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
    exercises::lay_out(&all, &exercises::stubs())?;
    match word {
        "list" => progress::list(&all)?,
        "next" => progress::next(&all)?,
        "reset" => progress::reset(&all, names)?,
        "untouched" => return Ok(progress::untouched(&all)),
        _ => return answered(&all, names),
    }
    Ok(ExitCode::SUCCESS)
}

/// Runs these exercises, and says what came of it.
fn answered(all: &[Exercise], names: &[String]) -> Result<ExitCode, String> {
    let folder = exercises::stubs();
    exercises::readable(all, &folder)?;
    for exercise in all.iter().filter(|exercise| names.contains(&exercise.name)) {
        if let Some(fault) = exercises::fault(exercise, &exercises::file(exercise, &folder)?) {
            complain(fault);
            return Ok(ExitCode::FAILURE);
        }
    }
    let mut waiting = false;
    let output = exercises::run(names, |line| {
        if !waiting && line.trim_start().starts_with("Compiling ") {
            waiting = true;
            complain("Compiling once, about a minute ...");
        } else if line.contains("waiting for file lock") {
            complain(line.trim());
        }
    })?;
    match exercises::verdict(names, &output) {
        Err(why) => {
            complain(why);
            Ok(ExitCode::FAILURE)
        }
        Ok(()) => {
            let names = names.join(", ");
            say(format!("Solved: {names}. `cargo run -- exercises next` names the next."));
            Ok(ExitCode::SUCCESS)
        }
    }
}

/// The exercise, or the other word, that comes nearest to a name that does not exist, if any is like it.
fn nearest<'a>(wrong: &str, all: &'a [Exercise]) -> Option<&'a str> {
    let like = |known: &'a str| (strsim::jaro(wrong, known), known);
    let near = all.iter().map(|exercise| exercise.name.as_str()).chain(WORDS).map(like);
    let near = near.max_by(|a, b| a.0.total_cmp(&b.0));
    near.filter(|(likeness, _)| *likeness > 0.7).map(|(_, name)| name)
}
