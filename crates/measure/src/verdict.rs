//! The conclusions from the record, as ratios.

use crate::contestant::Group;
use crate::long::slope;
use crate::record::{Long, Work};
use std::fmt::Write as _;

/// A kind of error: its name in the record, what it is, and where it stands.
#[derive(Clone, Copy)]
pub struct Kind {
    /// One word, as in the record's columns.
    pub name: &'static str,
    /// What it is, with its unit.
    pub title: &'static str,
    /// Where it stands.
    pub of: fn(&Work) -> Option<f64>,
}

/// Each kind of error.
pub const KINDS: [Kind; 5] = [
    Kind { name: "phase", title: "phase: share of the time between flips", of: |row| row.phase },
    Kind { name: "attitude", title: "attitude: angle (rad)", of: |row| row.attitude },
    Kind { name: "energy", title: "energy: relative", of: |row| row.energy },
    Kind { name: "momentum", title: "length of the momentum: relative", of: |row| row.momentum },
    Kind { name: "direction", title: "direction of the momentum: angle (rad)", of: |row| row.direction },
];

/// The kind that is called so in the record.
#[must_use]
pub fn kind(name: &str) -> Option<&'static Kind> {
    KINDS.iter().find(|kind| kind.name == name)
}

/// All kinds of error side by side: a line of a table for each contestant that ran a story in this number of
/// equal steps and came to its end. Where flips were miscounted, their number stands in place of the phase.
#[must_use]
pub fn side_by_side(rows: &[Work], story: &str, steps: u64) -> Vec<String> {
    let here = |row: &&Work| row.story == story && row.equal_steps() == Some(steps) && row.attitude.is_some();
    let line = |row: &Work| {
        let cell = |kind: &Kind| match (kind.of)(row) {
            Some(error) if error == 0.0 || error > 0.095 => format!("{error:.1}").replace(".0", ""),
            Some(error) => format!("{error:.0e}"),
            None => row.outcome.clone(),
        };
        format!("| {} | {} |", row.contestant, KINDS.map(|kind| cell(&kind)).join(" | "))
    };
    rows.iter().filter(here).map(line).collect()
}

/// The least time in which a contestant comes below an error, s: between two neighbouring rungs of its ladder
/// along the line of their logarithms. `None` if no rung comes below it.
#[must_use]
pub fn seconds_at(rows: &[Work], story: &str, contestant: &str, kind: &Kind, error: f64) -> Option<f64> {
    let ladder: Vec<(f64, f64)> = rows
        .iter()
        .filter(|row| row.story == story && row.contestant == contestant)
        .filter_map(|row| {
            let off = (kind.of)(row)?;
            Some((row.seconds?, if row.right() { off } else { f64::INFINITY }))
        })
        .collect();
    let mut best: Option<f64> = None;
    let mut take = |seconds: f64| best = Some(best.map_or(seconds, |b| b.min(seconds)));
    for (at, &(seconds, off)) in ladder.iter().enumerate() {
        if off > error {
            continue;
        }
        match at.checked_sub(1).and_then(|before| ladder.get(before)) {
            Some(&(earlier, more)) if more > error && more.is_finite() && off > 0.0 => {
                let share = (more / error).ln() / (more / off).ln();
                take((earlier.ln() + share * (seconds / earlier).ln()).exp());
            }
            _ => take(seconds),
        }
    }
    best
}

/// Everyone who comes below an error on a story, fastest first.
#[must_use]
pub fn ranking<'a>(rows: &'a [Work], story: &str, kind: &Kind, error: f64) -> Vec<(&'a str, Group, f64)> {
    let mut all: Vec<(&str, Group, f64)> = contestants(rows)
        .into_iter()
        .filter_map(|(name, group)| Some((name, group, seconds_at(rows, story, name, kind, error)?)))
        .collect();
    all.sort_by(|a, b| a.2.total_cmp(&b.2));
    all
}

/// Names and groups in the order of the record.
#[must_use]
pub fn contestants(rows: &[Work]) -> Vec<(&str, Group)> {
    let mut names: Vec<(&str, Group)> = Vec::new();
    for row in rows {
        let group = Group::ALL.into_iter().find(|group| group.word() == row.group);
        if let Some(group) = group.filter(|_| !names.iter().any(|(name, _)| *name == row.contestant)) {
            names.push((&row.contestant, group));
        }
    }
    names
}

/// The errors of the attitude at which the bodies under torques are compared, rad.
pub const DIGITS: [f64; 3] = [1e-4, 1e-8, 1e-12];

/// The bodies under torques as lines of a table: for each of [`DIGITS`], how many times as long as `adaptive`
/// the fastest published program takes, and its name.
#[must_use]
pub fn driven(rows: &[Work]) -> Vec<String> {
    let mut stories: Vec<&str> = rows.iter().filter(|r| r.contestant == OURS).map(|r| &*r.story).collect();
    stories.dedup();
    let cell = |story: &str, error: f64| {
        let ranking = ranking(rows, story, kind("attitude")?, error);
        let (_, _, ours) = ranking.iter().find(|(name, ..)| *name == OURS)?;
        let Some((name, _, peer)) = ranking.iter().find(|(_, group, _)| *group == Group::Peer) else {
            return Some("no other".to_owned());
        };
        // The name of the program, or else that of its method.
        let program = ["heyoka", "DOP853", "diffsol"].into_iter().find(|word| name.contains(word));
        Some(format!("{:.1}, {}", peer / ours, program.unwrap_or(name)))
    };
    let line = |story: &str| {
        let cells = DIGITS.map(|error| cell(story, error).unwrap_or_else(|| "never".to_owned()));
        format!("| {story} | {} |", cells.join(" | "))
    };
    stories.into_iter().map(line).collect()
}

/// The contestant of the library that the bodies under torques are compared by.
const OURS: &str = "adaptive";

/// The slope of the energy's error of a long run against time, in logarithms, from a thousand turns on. One
/// half is a random walk, one a line.
#[must_use]
pub fn drift(rows: &[Long], contestant: &str) -> Option<f64> {
    slope(rows.iter().filter(|row| row.contestant == contestant), 1000, |row| row.mean)
}

/// The whole verdict as lines of text.
#[must_use]
pub fn text(work: &[Work], long: &[Long]) -> String {
    let mut out = String::new();
    let Some(attitude) = kind("attitude") else { return out };
    for error in [1e-2, 1e-8] {
        let _ = writeln!(out, "The box after 100 flips, attitude within {error:.0e} rad:");
        for (name, group, seconds) in ranking(work, "box", attitude, error) {
            let _ = writeln!(out, "  {name:44} {:20} {seconds:>10.2e} s", group.word());
        }
    }
    let _ = writeln!(
        out,
        "How many times as long as adaptive the fastest published program takes, at {DIGITS:?} rad:\n{}",
        driven(work).join("\n")
    );
    for row in long.iter().filter(|row| row.turns == 1) {
        if let Some(slope) = drift(long, &row.contestant) {
            let _ = writeln!(out, "{:46} error of the energy: slope {slope:.2}", row.contestant);
        }
    }
    out
}
