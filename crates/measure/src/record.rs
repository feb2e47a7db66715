//! The record: files of comma-separated values whose heads say what, when and on which machine, written and
//! read back.

use crate::contestant::Setting;
use crate::errors::{Errors, Outcome};
pub use crate::fields::{Fields, Wrong};
use crate::fields::{field, full, parsed, plain, row};
use std::fmt::Write as _;

/// A record: what its head says, and its rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Record<R> {
    /// Pairs of key and value: what, when, on which machine.
    pub head: Vec<(String, String)>,
    /// In the order of measuring.
    pub rows: Vec<R>,
}

row! {
    /// One contestant on one story at one setting.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Work {
        /// The name of the story.
        pub story: String,
        /// The name of the contestant.
        pub contestant: String,
        /// The word of its group.
        pub group: String,
        /// The order it claims, 0 for none.
        pub order: u32,
        /// What it was set to.
        pub setting: Setting,
        /// Steps done.
        pub steps: Option<u64>,
        /// Evaluations of the law, or what the arithmetic was worth in them.
        pub evaluations: Option<f64>,
        /// Processor instructions.
        pub instructions: Option<f64>,
        /// Median time of a run, s.
        pub seconds: Option<f64>,
        /// The longest of the times measured over the shortest.
        pub spread: Option<f64>,
        /// Each kind of error.
        pub errors: Errors,
        /// What came of it.
        pub outcome: Outcome,
    }
}

row! {
    /// One method after a number of turns of a long run.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Long {
        /// The name of the contestant.
        pub contestant: String,
        /// The word of its group.
        pub group: String,
        /// Steps in a turn.
        pub steps: u32,
        /// Turns from the start to the end of the window: from half of them.
        pub turns: u64,
        /// The mean over the window of the relative error of the energy, its size; root mean square over the
        /// starts.
        pub mean: f64,
        /// The largest relative error of the energy in the window; root mean square over the starts.
        pub largest: f64,
        /// The same of the length of the momentum.
        pub momentum: f64,
        /// What came of it.
        pub outcome: Outcome,
    }
}

field!(Outcome, Outcome::field, Outcome::of);
field!(Setting, Setting::field, Setting::of);

impl Outcome {
    fn field(&self) -> String {
        match self {
            Self::Right => "right".into(),
            Self::Flips(count) => format!("{count} flips"),
            Self::NotFinite => "not finite".into(),
            Self::Refused(why) => plain(&format!("refused: {why}")),
        }
    }

    fn of(field: &str) -> Result<Self, Wrong> {
        if let Some(why) = field.strip_prefix("refused: ") {
            return Ok(Self::Refused(full(why)));
        }
        Ok(match field {
            "right" => Self::Right,
            "not finite" => Self::NotFinite,
            other => match other.strip_suffix(" flips") {
                Some(count) => Self::Flips(parsed(count)?),
                None => return Err(format!("`{other}` is no outcome")),
            },
        })
    }
}

impl Setting {
    fn field(&self) -> String {
        match self {
            Self::Steps(steps) => format!("{steps} steps"),
            Self::Tolerance(tolerance) => format!("tolerance {tolerance:e}"),
            Self::None => String::new(),
        }
    }

    fn of(field: &str) -> Result<Self, Wrong> {
        if let Some(steps) = field.strip_suffix(" steps") {
            return Ok(Self::Steps(parsed(steps)?));
        }
        match field.strip_prefix("tolerance ") {
            Some(tolerance) => Ok(Self::Tolerance(parsed(tolerance)?)),
            None if field.is_empty() => Ok(Self::None),
            None => Err(format!("`{field}` is no setting")),
        }
    }
}

impl<R: Fields> Record<R> {
    /// As a file has it.
    #[must_use]
    pub fn write(&self) -> String {
        let mut text = String::new();
        for (key, value) in &self.head {
            let _ = writeln!(text, "# {key}: {}", value.replace('\n', " "));
        }
        let _ = writeln!(text, "{}", R::columns("").join(","));
        for row in &self.rows {
            let mut fields = Vec::new();
            row.write(&mut fields);
            let _ = writeln!(text, "{}", fields.join(","));
        }
        text
    }

    /// Back from a file.
    ///
    /// # Errors
    /// The line that cannot be read, and why.
    pub fn read(text: &str) -> Result<Self, Wrong> {
        let mut head = Vec::new();
        let mut rows = Vec::new();
        let names = R::columns("").join(",");
        let mut columns = false;
        for (at, line) in text.lines().enumerate() {
            if let Some(said) = line.strip_prefix("# ") {
                let (key, value) = said.split_once(": ").unwrap_or((said, ""));
                head.push((key.to_owned(), value.to_owned()));
            } else if !columns {
                if line != names {
                    return Err(format!("line {}: other columns than {names}", at + 1));
                }
                columns = true;
            } else {
                let mut fields = line.split(',');
                rows.push(R::read(&mut fields).map_err(|why| format!("line {}: {why}", at + 1))?);
                if fields.next().is_some() {
                    return Err(format!("line {}: too many fields", at + 1));
                }
            }
        }
        if columns { Ok(Self { head, rows }) } else { Err("there are no columns".into()) }
    }

    /// What the head says under a key.
    #[must_use]
    pub fn said(&self, key: &str) -> Option<&str> {
        self.head.iter().find(|(k, _)| k == key).map(|(_, value)| value.as_str())
    }
}

/// The committed record of work.
///
/// # Errors
/// A record that cannot be read.
pub fn work() -> Result<Record<Work>, Wrong> {
    Record::read(include_str!("../record/work.csv"))
}

/// The committed record of long runs.
///
/// # Errors
/// A record that cannot be read.
pub fn long() -> Result<Record<Long>, Wrong> {
    Record::read(include_str!("../record/long.csv"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back() {
        let base = Work {
            story: "box".into(),
            contestant: "one, or another".into(),
            group: "neither".into(),
            order: 4,
            setting: Setting::Steps(1234),
            steps: Some(1234),
            evaluations: Some(5.125e6),
            instructions: None,
            seconds: Some(1.5e-3),
            spread: Some(1.25),
            errors: Errors { phase: None, attitude: Some(1e-9), ..Errors::default() },
            outcome: Outcome::Right,
        };
        let refused = Outcome::Refused("no, it does not find its end".into());
        let rows = vec![
            base.clone(),
            Work { setting: Setting::Tolerance(1e-8), outcome: Outcome::Flips(99), ..base.clone() },
            Work { setting: Setting::None, seconds: None, outcome: Outcome::NotFinite, ..base.clone() },
            Work { outcome: refused, ..base },
        ];
        let head = vec![("machine".to_owned(), "a machine: two cores".to_owned())];
        let written = Record { head, rows }.write();
        let back = Record::<Work>::read(&written).unwrap();
        assert_eq!(back.write(), written);
        assert_eq!(back.rows[0].contestant, "one, or another");
        assert_eq!(back.said("machine"), Some("a machine: two cores"));
        assert_eq!(back.rows[1].outcome, Outcome::Flips(99));
        assert_eq!(back.rows[3].outcome, Outcome::Refused("no, it does not find its end".into()));
        assert!(Record::<Work>::read(&written.replace("1234 steps", "many steps")).is_err());
        assert!(Record::<Long>::read(&written).is_err());
    }
}
