//! All of it in one go: errors, times, instructions, long runs, and the two files.

use crate::contestant::{Contestant, Ours};
use crate::instructions::{self, Again};
use crate::measure::{Effort, measure};
use crate::record::{Record, Work};
use crate::story::{self, Wrong};
use crate::{long, setup, verdict};
use std::fs;
use std::path::Path;
use tumbling::step::Method;

/// What to do.
#[derive(Debug)]
pub struct Campaign<'a> {
    /// Who takes part.
    pub contestants: &'a [Box<dyn Contestant>],
    /// How much of it.
    pub effort: Effort,
    /// How to run this program again, for counting instructions; `None` counts none.
    pub again: Option<Again>,
    /// Lines for the head besides those of every record: versions of peers.
    pub head: Vec<(String, String)>,
}

impl std::fmt::Debug for dyn Contestant {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

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
    (
        "evaluations",
        "of the law: what the arithmetic of our methods is worth in evaluations; calls of the law for peers",
    ),
    ("instructions", "counted by valgrind for a step at 0.1 rad or a tolerance of 1e-8; times the steps"),
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

fn head(what: &[(&str, &str)], more: &[(String, String)], effort: Effort) -> Vec<(String, String)> {
    let mut head: Vec<(String, String)> =
        what.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    head.extend(setup::describe());
    head.extend_from_slice(more);
    head.push((
        "effort".to_owned(),
        if effort == Effort::FULL { "full" } else { "less than full" }.to_owned(),
    ));
    head
}

/// Errors, times and counts. `tell` hears how far it is.
fn work(campaign: &Campaign<'_>, tell: &mut dyn FnMut(&str)) -> Result<Record<Work>, Wrong> {
    let stories = story::all()?;
    let Campaign { contestants, effort, again, head: more } = campaign;
    let mut rows = measure(contestants, &stories, *effort, tell)?;
    if let Some(again) = again {
        for contestant in *contestants {
            tell(&format!("instructions of {}", contestant.name()));
            if let Some(each) = instructions::of_step(again, contestant.as_ref(), &stories) {
                instructions::fill(&mut rows, contestant.as_ref(), &stories, each);
            }
        }
    }
    Ok(Record { head: head(WORK, more, *effort), rows })
}

/// Measures, and writes `work.csv` and `long.csv` into a folder. The verdict.
///
/// # Errors
/// A story that cannot be prepared, or a folder that cannot be written to.
pub fn write(campaign: &Campaign<'_>, folder: &Path, tell: &mut dyn FnMut(&str)) -> Result<String, Wrong> {
    fs::create_dir_all(folder)?;
    let work = work(campaign, tell)?;
    fs::write(folder.join("work.csv"), work.write())?;
    let rows = long::all(campaign.contestants, campaign.effort, tell);
    let long = Record { head: head(LONG, &campaign.head, campaign.effort), rows };
    fs::write(folder.join("long.csv"), long.write())?;
    tell("done");
    Ok(verdict::text(&work, &long))
}

/// How many turns the longest run has.
pub const LONGEST: u64 = 1_000_000_000;

/// The longest run, of one method of the library from one start, written to `billion.csv` in a folder.
///
/// # Errors
/// A name that no method has, or a folder that cannot be written to.
pub fn longest(name: &str, turns: u64, folder: &Path) -> Result<String, Wrong> {
    let method = Method::ALL.iter().copied().find(|method| method.info().name == name);
    let Some(method) = method else {
        let names: Vec<&str> = Method::ALL.iter().map(|method| method.info().name).collect();
        return Err(format!("There is no method `{name}`. There are: {}.", names.join(", ")).into());
    };
    fs::create_dir_all(folder)?;
    let rows = long::run(method, Ours(method).about().group.word(), turns, 1);
    let record = Record { head: head(LONG, &[], Effort { turns, starts: 1, ..Effort::FULL }), rows };
    fs::write(folder.join("billion.csv"), record.write())?;
    let empty = Record { head: Vec::new(), rows: Vec::new() };
    Ok(verdict::text(&empty, &record))
}
