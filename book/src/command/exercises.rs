//! The reader's way through the exercises: what is done, what comes next, and a fresh start.
//!
//! No progress is recorded. A file that equals the book's is open. Any other file is run, and is done if it
//! passes and has no change outside its marks.

use crate::site::files::write_changed;
use crate::{complain, say};
use clap::Subcommand;
use clap::builder::{PossibleValue, PossibleValuesParser, ValueParser};
use std::process::ExitCode;
use tumbling_exercises::{self as exercises, Exercise};

/// Other tasks than listing the exercises.
#[derive(Debug, Clone, PartialEq, Eq, Subcommand)]
pub(crate) enum Command {
    /// Name the next one that is not done, with its file and its command
    Next,
    /// Bring the files of these back as they were
    Reset {
        /// The exercises
        #[arg(value_name = "NAME", required = true, value_parser = name(), hide_possible_values = true)]
        names: Vec<String>,
    },
    /// Fail and name the files that are not as the book has them
    Untouched,
}

/// An exercise's name on the command line. If the exercises cannot be read, any name is accepted, and `run`
/// reports why they cannot be read.
fn name() -> ValueParser {
    let value = |e: Exercise| PossibleValue::new(e.name).help(e.title);
    match exercises::all() {
        Ok(all) => PossibleValuesParser::new(all.into_iter().map(value)).into(),
        Err(_) => ValueParser::string(),
    }
}

/// Carries out a command; without one lists the exercises.
///
/// # Errors
/// What could not be read, written or run.
pub(crate) fn run(command: Option<&Command>) -> Result<ExitCode, String> {
    let all = exercises::all()?;
    exercises::lay_out(&all, &exercises::stubs())?;
    match command {
        None => list(&all)?,
        Some(Command::Next) => say!("{}", next(&all, &standings(&all)?)),
        Some(Command::Reset { names }) => {
            for exercise in all.iter().filter(|e| names.contains(&e.name)) {
                let file = exercises::stubs().join(format!("{}.md", exercise.name));
                write_changed(&file, exercise.stub().as_bytes())?;
                say!("{} is as it was.", shown(exercise));
            }
        }
        Some(Command::Untouched) => {
            let mut code = ExitCode::SUCCESS;
            for exercise in all.iter().filter(|e| before_running(e) != Some(Standing::Open)) {
                complain!("{} is not as the book has it", shown(exercise));
                code = ExitCode::FAILURE;
            }
            return Ok(code);
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// A reader's progress with an exercise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Standing {
    /// As in the book.
    Open,
    /// Changed, and does not pass.
    Begun,
    /// Passes.
    Done,
    /// The file is no text.
    Gone,
}

/// The path of the file that a reader edits, for messages.
fn shown(exercise: &Exercise) -> String {
    format!("book/exercises/stubs/{}.md", exercise.name)
}

/// The standing as far as the file alone shows it: `Begun` where only a run can show whether it is done;
/// `None` where the file cannot be read.
fn before_running(exercise: &Exercise) -> Option<Standing> {
    let text = exercises::file(exercise, &exercises::stubs()).ok()?;
    Some(if text.replace("\r\n", "\n") == exercise.stub() { Standing::Open } else { Standing::Begun })
}

/// The standing of each of these, in their order.
fn standings(all: &[Exercise]) -> Result<Vec<Standing>, String> {
    let mut standings: Vec<Standing> =
        all.iter().map(|e| before_running(e).unwrap_or(Standing::Gone)).collect();
    let mut changed: Vec<&str> = Vec::new();
    for (exercise, _) in all.iter().zip(&standings).filter(|(_, standing)| **standing == Standing::Begun) {
        match exercises::fault(exercise, &exercises::file(exercise, &exercises::stubs())?) {
            Some(fault) => complain!("{fault}"),
            None => changed.push(&exercise.name),
        }
    }
    if changed.is_empty() {
        return Ok(standings);
    }
    exercises::readable(all, &exercises::stubs())?;
    complain!("{}", running(changed.len()));
    let passed = exercises::passed(&exercises::run(&changed, |_| ())?);
    for (exercise, standing) in all.iter().zip(&mut standings) {
        if changed.contains(&exercise.name.as_str()) && passed.get(&exercise.name).copied().unwrap_or(false) {
            *standing = Standing::Done;
        }
    }
    Ok(standings)
}

/// A message for the first run, which shows nothing else for a minute or more.
fn running(changed: usize) -> String {
    let what = if changed == 1 { "the one exercise".into() } else { format!("the {changed} exercises") };
    format!("Running {what} that you have changed. The first run compiles the library, and takes a while.")
}

fn list(all: &[Exercise]) -> Result<(), String> {
    let standings = standings(all)?;
    let width = all.iter().map(|e| e.name.len()).max().unwrap_or(0);
    let mut chapter = String::new();
    for (exercise, standing) in all.iter().zip(&standings) {
        let place = exercise.place().0;
        if place != chapter {
            let of = |done: bool| {
                let here = all.iter().zip(&standings).filter(|(e, _)| e.place().0 == place);
                here.filter(|(_, s)| !done || **s == Standing::Done).count()
            };
            say!("{place}: {} of {}", of(true), of(false));
            chapter = place;
        }
        let standing = format!("{standing:?}").to_lowercase();
        say!("  {standing:5} {:width$}  {}", exercise.name, exercise.title);
    }
    let done = standings.iter().filter(|s| **s == Standing::Done).count();
    say!("{done} of {} done. {}", all.len(), next(all, &standings));
    Ok(())
}

/// The next exercise, with its file and its command.
fn next(all: &[Exercise], standings: &[Standing]) -> String {
    let next = all.iter().zip(standings).find(|(_, standing)| **standing != Standing::Done);
    match next {
        None => "Nothing is left to do.".into(),
        Some((exercise, Standing::Gone)) => format!(
            "Next: {}, whose file cannot be read; this brings it back:\n    cargo run -- exercises reset {}",
            exercise.name, exercise.name
        ),
        Some((exercise, _)) => {
            let (title, file, command) = (&exercise.title, shown(exercise), exercise.command());
            format!("Next: \"{title}\". Edit {file} and run\n    {command}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reader_who_waits_is_told_what_for() {
        for (changed, what) in [(1, "the one exercise"), (3, "the 3 exercises")] {
            assert!(running(changed).contains(&format!("{what} that you have changed. The first run")));
        }
    }

    #[test]
    fn the_next_is_the_first_that_is_not_done() {
        let all = &exercises::all().unwrap()[..3];
        let named = |standings: [Standing; 3]| next(all, &standings);
        use Standing::{Begun, Done, Gone, Open};
        assert!(named([Open, Done, Open]).ends_with("    cargo exercise toss_a_book_1"));
        assert!(named([Done, Begun, Open]).ends_with("    cargo exercise toss_a_book_2"));
        assert!(named([Done, Done, Gone]).ends_with("exercises reset toss_a_book_3"));
        assert_eq!(named([Done; 3]), "Nothing is left to do.");
    }
}
