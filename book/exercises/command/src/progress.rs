//! The reader's way through the exercises: what is done, what comes next, and a fresh start.
//!
//! No progress is recorded. A file that equals the book's is open. Any other file is run, and is done if it
//! passes and has no change outside its marks.

use crate::{complain, say};
use std::fs;
use std::process::ExitCode;
use tumbling_exercises::{self as exercises, Exercise};

/// Brings the files of these exercises back as they were.
///
/// # Errors
/// A file that cannot be written.
pub(crate) fn reset(all: &[Exercise], names: &[String]) -> Result<(), String> {
    for exercise in all.iter().filter(|e| names.contains(&e.name)) {
        let file = exercises::stubs().join(format!("{}.md", exercise.name));
        fs::write(&file, exercise.stub()).map_err(|e| format!("cannot write {}: {e}", file.display()))?;
        say(format!("{} is as it was.", shown(exercise)));
    }
    Ok(())
}

/// Fails and names the files that are not as the book has them.
pub(crate) fn untouched(all: &[Exercise]) -> ExitCode {
    let mut code = ExitCode::SUCCESS;
    for exercise in all.iter().filter(|e| before_running(e) != Some(Standing::Open)) {
        complain(format!("{} is not as the book has it", shown(exercise)));
        code = ExitCode::FAILURE;
    }
    code
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
            Some(fault) => complain(fault),
            None => changed.push(&exercise.name),
        }
    }
    if changed.is_empty() {
        return Ok(standings);
    }
    exercises::readable(all, &exercises::stubs())?;
    complain(running(changed.len()));
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

/// Prints all, by chapter, with the standing of each, and the next.
///
/// # Errors
/// What could not be read or run.
pub(crate) fn list(all: &[Exercise]) -> Result<(), String> {
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
            say(format!("{place}: {} of {}", of(true), of(false)));
            chapter = place;
        }
        let standing = format!("{standing:?}").to_lowercase();
        say(format!("  {standing:5} {:width$}  {}", exercise.name, exercise.title));
    }
    let done = standings.iter().filter(|s| **s == Standing::Done).count();
    say(format!("{done} of {} done. {}", all.len(), following(all, &standings)));
    Ok(())
}

/// Names the next exercise that is not done, with its file and its command.
///
/// # Errors
/// What could not be read or run.
pub(crate) fn next(all: &[Exercise]) -> Result<(), String> {
    say(following(all, &standings(all)?));
    Ok(())
}

fn following(all: &[Exercise], standings: &[Standing]) -> String {
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
        let named = |standings: [Standing; 3]| following(all, &standings);
        use Standing::{Begun, Done, Gone, Open};
        assert!(named([Open, Done, Open]).ends_with("    cargo exercise toss_a_book_1"));
        assert!(named([Done, Begun, Open]).ends_with("    cargo exercise toss_a_book_2"));
        assert!(named([Done, Done, Gone]).ends_with("exercises reset toss_a_book_3"));
        assert_eq!(named([Done; 3]), "Nothing is left to do.");
    }
}
