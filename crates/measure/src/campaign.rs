//! All of it in one go: errors, times, long runs, and the two files.

use crate::contestant::Contestant;
use crate::measure::{Effort, measure};
use crate::record::Record;
use crate::{AnyError, long, setup, story, verdict};
use std::fs;
use std::path::Path;

const WORK: &[(&str, &str)] = &[
    ("what", "error against work: one contestant on one story at one setting a line"),
    (
        "phase",
        "how early or late the last change of sign of the spin along the middle axis; share of the time between two",
    ),
    ("attitude", "angle to the true attitude at the end; rad"),
    (
        "energy; momentum; direction",
        "relative error of energy and |L|; angle between L in the world and the true one in rad: the largest \
         at any step where it is a constant of the motion; else at the end",
    ),
    (
        "seconds",
        "median time of a run; taken in turns over all contestants; spread is the longest over the shortest",
    ),
];

const LONG: &[(&str, &str)] = &[
    (
        "what",
        "long runs: the box from three spins or fewer; 20 steps a turn; errors over the window since the turn before",
    ),
    (
        "mean",
        "mean of the relative error of the energy over the window; its size; root mean square over the starts",
    ),
    (
        "largest; momentum",
        "largest relative error of energy and |L| in the window; root mean square over the starts",
    ),
];

/// Measures, writes `work.csv` and `long.csv` into a folder, and returns their contents. The heads contain
/// the versions of the peers; `progress` is called with the progress so far.
///
/// # Errors
/// A story that cannot be prepared, or a folder that cannot be written to.
pub fn write(
    contestants: &[Box<dyn Contestant>],
    effort: Effort,
    peers: &[String],
    folder: &Path,
    progress: &mut dyn FnMut(&str),
) -> Result<String, AnyError> {
    let head = |what| {
        let mut head = setup::head(what);
        if !peers.is_empty() {
            head.push(("peers".into(), peers.join("; ")));
        }
        head.push(("effort".into(), if effort == Effort::FULL { "full" } else { "less than full" }.into()));
        head
    };
    fs::create_dir_all(folder)?;
    let work = Record { head: head(WORK), rows: measure(contestants, &story::all()?, effort, progress) };
    fs::write(folder.join("work.csv"), work.write()?)?;
    let long = Record { head: head(LONG), rows: long::all(contestants, effort, progress) };
    fs::write(folder.join("long.csv"), long.write()?)?;
    progress("done");
    Ok(verdict::text(&work.rows, &long.rows))
}
