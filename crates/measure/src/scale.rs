//! Many bodies: exact states a second against the number of bodies, in lanes and alone, on one thread and
//! two, compared with an engine that steps as many. The record, and what it says; [`crowd`] measures.

pub mod crowd;

use crate::fields::row;
use crate::record::{Record, Wrong};
use crate::setup;
use crowd::Effort;

row! {
    /// One crowd of one size.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Scale {
        /// How the program was built: `default` or `native`.
        pub build: String,
        /// Who.
        pub crowd: String,
        /// Numbers side by side.
        pub lanes: u32,
        /// Threads.
        pub threads: u32,
        /// Bodies.
        pub bodies: u64,
        /// Instants (or steps) of each body in a pass.
        pub instants: u32,
        /// Least time of a pass, s.
        pub seconds: f64,
        /// The longest of the times over the least.
        pub spread: f64,
        /// What a prepared body weighs, bytes, where that is known.
        pub bytes: Option<f64>,
        /// Preparing a body, s, where it was timed.
        pub preparing: Option<f64>,
    }
}

impl Scale {
    /// States a second.
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.bodies as f64 * f64::from(self.instants) / self.seconds
    }
}

/// The committed record.
///
/// # Errors
/// A record that cannot be read.
pub fn committed() -> Result<Record<Scale>, Wrong> {
    Record::read(include_str!("../record/scale.csv"))
}

const HEAD: &[(&str, &str)] = &[
    ("what", "many bodies: states a second; each crowd at each number of bodies a line"),
    (
        "crowd",
        "what is asked of each body: 16 instants in a pass; once is one; a scene is planned anew in each pass, the others are prepared before; Rapier does one step of a sixtieth of a second",
    ),
    ("build", "default is for any machine of the kind; native for this one: RUSTFLAGS=-C target-cpu=native"),
    (
        "seconds",
        "least time of a pass; passes taken in turns below a million bodies; spread is the longest over it",
    ),
    ("bytes; preparing", "what a prepared body holds; seconds to prepare one; on all threads there are"),
];

/// The record of these rows.
#[must_use]
pub fn record(rows: Vec<Scale>, more: &[(String, String)], effort: Effort) -> Record<Scale> {
    let mut head: Vec<(String, String)> =
        HEAD.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
    head.extend(setup::describe());
    head.extend_from_slice(more);
    head.push(("effort".into(), if effort == Effort::FULL { "full" } else { "less than full" }.into()));
    Record { head, rows }
}

/// Rows of one build, crowd, lanes and threads, by the number of bodies.
pub fn of<'a>(
    rows: &'a [Scale],
    build: &'a str,
    crowd: &'a str,
    lanes: u32,
    threads: u32,
) -> impl Iterator<Item = &'a Scale> {
    rows.iter().filter(move |row| {
        row.build == build && row.crowd == crowd && row.lanes == lanes && row.threads == threads
    })
}

/// The most states a second of one of the curves.
#[must_use]
pub fn best(rows: &[Scale], build: &str, crowd: &str, lanes: u32, threads: u32) -> Option<f64> {
    of(rows, build, crowd, lanes, threads).map(Scale::rate).reduce(f64::max)
}

/// How many times as long a state takes at its slowest as at its quickest, over all numbers of bodies from
/// `least` on.
#[must_use]
pub fn unevenness(
    rows: &[Scale],
    build: &str,
    crowd: &str,
    lanes: u32,
    threads: u32,
    least: u64,
) -> Option<f64> {
    let rates: Vec<f64> =
        of(rows, build, crowd, lanes, threads).filter(|row| row.bodies >= least).map(Scale::rate).collect();
    Some(rates.iter().copied().reduce(f64::max)? / rates.iter().copied().reduce(f64::min)?)
}

/// The middle, over the numbers of bodies that both have (a thousand or more), of how many times the one's
/// rate is the other's: each is given by crowd, lanes and threads.
#[must_use]
pub fn ratio(rows: &[Scale], build: &str, one: (&str, u32, u32), other: (&str, u32, u32)) -> Option<f64> {
    let mut ratios: Vec<f64> = of(rows, build, one.0, one.1, one.2)
        .filter(|row| row.bodies >= 1000)
        .filter_map(|row| {
            let same = |peer: &&Scale| peer.bodies == row.bodies;
            Some(row.rate() / of(rows, build, other.0, other.1, other.2).find(same)?.rate())
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    ratios.get(ratios.len() / 2).copied()
}

/// What the record says, in words.
#[must_use]
pub fn text(record: &Record<Scale>) -> String {
    let rows = &record.rows;
    let mut lines = Vec::new();
    let both = ("spin and attitude", 4, 1);
    for build in ["default", "native"] {
        let mut line = |what: &str, value: Option<f64>| {
            if let Some(value) = value {
                lines.push(format!("{build:<8} {what:<58} {value:>10.3}"));
            }
        };
        let ns = |crowd, lanes, threads| best(rows, build, crowd, lanes, threads).map(|rate| 1e9 / rate);
        line("spin and attitude, four lanes, ns a state at best", ns(both.0, 4, 1));
        line("the same, one lane", ns(both.0, 1, 1));
        line("spin alone, four lanes", ns("spin", 4, 1));
        line("spin alone, one lane", ns("spin", 1, 1));
        line("Rapier, ns a step at best", ns("Rapier", 1, 1));
        line("four lanes over one, spin and attitude", ratio(rows, build, both, (both.0, 1, 1)));
        line("four lanes over one, spin", ratio(rows, build, ("spin", 4, 1), ("spin", 1, 1)));
        line("spin over spin and attitude, four lanes", ratio(rows, build, ("spin", 4, 1), both));
        line("two threads over one", ratio(rows, build, (both.0, 4, 2), both));
        line("states over Rapier's steps, one thread", ratio(rows, build, both, ("Rapier", 1, 1)));
        line("slowest over quickest, 10 000 bodies or more", unevenness(rows, build, both.0, 4, 1, 10_000));
        line("the same, asked once a pass", unevenness(rows, build, "spin and attitude once", 4, 1, 10_000));
        let weight = of(rows, build, both.0, 4, 1).last().and_then(|row| row.bytes);
        line("bytes that a prepared body holds", weight);
        line("the same, spin alone", of(rows, build, "spin", 4, 1).last().and_then(|row| row.bytes));
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::crowd::{Run, measure, ours};
    use super::*;

    #[test]
    fn a_quick_run_is_written_and_reads_back() {
        let alone: &Run<'_> = &|pass| pass();
        let effort = Effort { most: 1000, repeats: 1, least: 0.0, together: 1000 };
        let rows = measure("default", &ours(alone, Some(alone)), effort, &mut |_| {});
        assert_eq!(rows.len(), 16);
        let record = record(rows, &[], effort);
        let back = Record::<Scale>::read(&record.write()).unwrap();
        assert_eq!(back.write(), record.write());
        assert!(back.rows.iter().all(|row| row.rate() > 0.0 && row.spread >= 1.0));
        assert!(text(&back).contains("four lanes over one"));
    }
}
