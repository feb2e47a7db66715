//! The exercises of the book.
//!
//! Each is one file, `whole/NAME.md`: the task, a Rust block with a place left open, hints, what to put
//! there, and wrong answers. All else is made of it: the page's folds, the file that a reader edits
//! (`stubs/NAME.md`, made by the first `cargo exercise NAME`, the program in `command/`, which runs its
//! block as a doc-test of its own), and the program of `tests/proof.rs`, which runs every block open,
//! solved and answered wrongly.
//!
//! The reader's files are tested only with the feature `mine`: `cargo test` proves the exercises and stays
//! green, however far the reader has come.

mod answer;
mod exercise;
mod run;

pub use answer::fault;
pub use exercise::{BEGIN, END, Exercise, Wrong};
pub use run::{passed, run, verdict};

use std::collections::BTreeSet;
use std::fs;
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};

/// Where the whole exercises are.
#[must_use]
pub fn whole() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("whole")
}

/// Where the files are that a reader edits.
#[must_use]
pub fn stubs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("stubs")
}

/// The chapters, in the order of the book, by the names of their files.
#[must_use]
pub fn chapters() -> Vec<String> {
    include_str!("../../chapters/SUMMARY.md")
        .lines()
        .filter_map(|line| {
            Some(line.trim_start().strip_prefix("- [")?.split_once("](")?.1.strip_suffix(".md)")?.to_owned())
        })
        .collect()
}

/// All exercises, in the order of the book.
///
/// # Errors
/// What cannot be read, with its file and line; or what the files as a whole lack.
pub fn all() -> Result<Vec<Exercise>, String> {
    let exercises = exercise::read_all(&whole())?;
    let chapters = chapters();
    let names: BTreeSet<&str> = exercises.iter().map(|e| e.name.as_str()).collect();
    let mut ordered = Vec::new();
    for chapter in &chapters {
        for number in 1.. {
            let name = format!("{}_{number}", chapter.replace('-', "_"));
            let Some(exercise) = exercises.iter().find(|e| e.name == name) else {
                break;
            };
            ordered.push(exercise.clone());
        }
    }
    if let Some(lost) = names.iter().find(|name| ordered.iter().all(|e| e.name != **name)) {
        return Err(format!(
            "book/exercises/whole/{lost}.md: an exercise is named after its chapter in SUMMARY.md, and counted from 1 \
             without a gap"
        ));
    }
    // The command chooses by a part of the name.
    for name in &names {
        if let Some(other) = names.iter().find(|other| *other != name && other.contains(name)) {
            return Err(format!("`{name}` is a part of `{other}`: its command would run both"));
        }
    }
    Ok(ordered)
}

/// Makes the files that a reader edits where there are none yet, each with its place open.
///
/// # Errors
/// What cannot be written.
pub fn lay_out(exercises: &[Exercise], folder: &Path) -> Result<(), String> {
    let cannot = |e: std::io::Error| format!("cannot write to {}: {e}", folder.display());
    fs::create_dir_all(folder).map_err(cannot)?;
    for exercise in exercises {
        match fs::File::create_new(folder.join(format!("{}.md", exercise.name))) {
            Ok(mut file) => file.write_all(exercise.stub().as_bytes()).map_err(cannot)?,
            Err(e) if e.kind() == ErrorKind::AlreadyExists => {}
            Err(e) => return Err(cannot(e)),
        }
    }
    Ok(())
}

/// The text of the file in this folder that the reader edits.
///
/// # Errors
/// If it is no text, with what brings it back.
pub fn file(exercise: &Exercise, folder: &Path) -> Result<String, String> {
    let name = &exercise.name;
    fs::read_to_string(folder.join(format!("{name}.md"))).map_err(|e| {
        let why = match e.kind() {
            ErrorKind::InvalidData => "is no text in UTF-8".into(),
            _ => format!("cannot be read: {e}"),
        };
        format!(
            "book/exercises/stubs/{name}.md {why}, and no exercise runs without it. This brings it back, with its \
             place open:\n    cargo run -- exercises reset {name}"
        )
    })
}

/// Whether all files that readers edit are there to be compiled: they are one program, which any of them
/// stops.
///
/// # Errors
/// The first that is not, with what brings it back.
pub fn readable(exercises: &[Exercise], folder: &Path) -> Result<(), String> {
    exercises.iter().try_for_each(|exercise| file(exercise, folder).map(drop))
}

#[cfg(all(doctest, feature = "mine"))]
mod mine {
    include!(concat!(env!("OUT_DIR"), "/mine.rs"));
}
