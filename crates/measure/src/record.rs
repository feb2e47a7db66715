//! The record: files of comma-separated values whose heads say what, when and on which machine, written and read back.

use crate::contestant::Setting;
use crate::errors::{Errors, Outcome};
use std::fmt::Write as _;
use std::str::FromStr;

/// What went wrong with a record, in words.
pub type Wrong = String;

/// A record: what its head says, and its rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Record<R> {
    /// Pairs of key and value: what, when, on which machine.
    pub head: Vec<(String, String)>,
    /// In the order of measuring.
    pub rows: Vec<R>,
}

/// A row of a record.
pub trait Row: Sized {
    /// The names of its columns.
    const COLUMNS: &'static [&'static str];

    /// Its fields, as many as there are columns, without commas.
    fn fields(&self) -> Vec<String>;

    /// Back from its fields.
    ///
    /// # Errors
    /// What cannot be read.
    fn read(fields: &[&str]) -> Result<Self, Wrong>;
}

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

/// One method after so many turns of a long run.
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
    /// The mean over the window of the relative error of the energy, its size; root mean square over the starts.
    pub mean: f64,
    /// The largest relative error of the energy in the window; root mean square over the starts.
    pub largest: f64,
    /// The same of the length of the momentum.
    pub momentum: f64,
    /// What came of it.
    pub outcome: Outcome,
}

/// A number as the record has it.
pub(crate) fn number(x: f64) -> String {
    format!("{x:.3e}")
}

pub(crate) fn optional(x: Option<f64>) -> String {
    x.map_or_else(String::new, number)
}

pub(crate) fn parsed<T: FromStr>(field: &str) -> Result<T, Wrong> {
    field.parse().map_err(|_| format!("`{field}` cannot be read"))
}

pub(crate) fn perhaps<T: FromStr>(field: &str) -> Result<Option<T>, Wrong> {
    if field.is_empty() { Ok(None) } else { parsed(field).map(Some) }
}

/// In one field, where a comma would begin the next: a semicolon stands for it.
fn plain(text: &str) -> String {
    text.replace(',', ";").replace(['\n', '\r'], " ")
}

/// With its commas again.
fn full(field: &str) -> String {
    field.replace(';', ",")
}

impl Outcome {
    fn field(&self) -> String {
        match self {
            Self::Right => "right".into(),
            Self::Flips(count) => format!("{count} flips"),
            Self::NotFinite => "not finite".into(),
            Self::Refused(why) => plain(&format!("refused: {why}")),
        }
    }

    fn read(field: &str) -> Result<Self, Wrong> {
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
    fn field(self) -> String {
        match self {
            Self::Steps(steps) => format!("{steps} steps"),
            Self::Tolerance(tolerance) => format!("tolerance {tolerance:e}"),
            Self::None => String::new(),
        }
    }

    fn read(field: &str) -> Result<Self, Wrong> {
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

impl Row for Work {
    const COLUMNS: &'static [&'static str] = &[
        "story",
        "contestant",
        "group",
        "order",
        "setting",
        "steps",
        "evaluations",
        "instructions",
        "seconds",
        "spread",
        "phase",
        "attitude",
        "energy",
        "momentum",
        "direction",
        "outcome",
    ];

    fn fields(&self) -> Vec<String> {
        let Errors { phase, attitude, energy, momentum, direction } = self.errors;
        let mut fields = vec![
            plain(&self.story),
            plain(&self.contestant),
            plain(&self.group),
            self.order.to_string(),
            self.setting.field(),
            self.steps.map_or_else(String::new, |n| n.to_string()),
        ];
        let sizes = [self.evaluations, self.instructions, self.seconds, self.spread];
        fields.extend(sizes.into_iter().map(optional));
        fields.extend([phase, attitude, energy, momentum, direction].into_iter().map(optional));
        fields.push(self.outcome.field());
        fields
    }

    fn read(fields: &[&str]) -> Result<Self, Wrong> {
        let &[
            story,
            contestant,
            group,
            order,
            setting,
            steps,
            evaluations,
            instructions,
            seconds,
            spread,
            phase,
            attitude,
            energy,
            momentum,
            direction,
            outcome,
        ] = fields
        else {
            return Err(format!("{} fields", fields.len()));
        };
        Ok(Self {
            story: story.into(),
            contestant: full(contestant),
            group: group.into(),
            order: parsed(order)?,
            setting: Setting::read(setting)?,
            steps: perhaps(steps)?,
            evaluations: perhaps(evaluations)?,
            instructions: perhaps(instructions)?,
            seconds: perhaps(seconds)?,
            spread: perhaps(spread)?,
            errors: Errors {
                phase: perhaps(phase)?,
                attitude: perhaps(attitude)?,
                energy: perhaps(energy)?,
                momentum: perhaps(momentum)?,
                direction: perhaps(direction)?,
            },
            outcome: Outcome::read(outcome)?,
        })
    }
}

impl Row for Long {
    const COLUMNS: &'static [&'static str] =
        &["contestant", "group", "steps", "turns", "mean", "largest", "momentum", "outcome"];

    fn fields(&self) -> Vec<String> {
        vec![
            plain(&self.contestant),
            plain(&self.group),
            self.steps.to_string(),
            self.turns.to_string(),
            number(self.mean),
            number(self.largest),
            number(self.momentum),
            self.outcome.field(),
        ]
    }

    fn read(fields: &[&str]) -> Result<Self, Wrong> {
        let &[contestant, group, steps, turns, mean, largest, momentum, outcome] = fields else {
            return Err(format!("{} fields", fields.len()));
        };
        Ok(Self {
            contestant: full(contestant),
            group: group.into(),
            steps: parsed(steps)?,
            turns: parsed(turns)?,
            mean: parsed(mean)?,
            largest: parsed(largest)?,
            momentum: parsed(momentum)?,
            outcome: Outcome::read(outcome)?,
        })
    }
}

impl<R: Row> Record<R> {
    /// As a file has it.
    #[must_use]
    pub fn write(&self) -> String {
        let mut text = String::new();
        for (key, value) in &self.head {
            let _ = writeln!(text, "# {key}: {}", value.replace('\n', " "));
        }
        let _ = writeln!(text, "{}", R::COLUMNS.join(","));
        for row in &self.rows {
            let _ = writeln!(text, "{}", row.fields().join(","));
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
        let mut columns = false;
        for (at, line) in text.lines().enumerate() {
            if let Some(said) = line.strip_prefix("# ") {
                let (key, value) = said.split_once(": ").unwrap_or((said, ""));
                head.push((key.to_owned(), value.to_owned()));
            } else if !columns {
                if line != R::COLUMNS.join(",") {
                    return Err(format!("line {}: other columns than {}", at + 1, R::COLUMNS.join(",")));
                }
                columns = true;
            } else {
                let fields: Vec<&str> = line.split(',').collect();
                rows.push(R::read(&fields).map_err(|why| format!("line {}: {why}", at + 1))?);
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
