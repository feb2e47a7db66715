//! The record: files of comma-separated values whose heads state the columns, the date and the machine.

use crate::AnyError;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

/// A record: what its head says, and its rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Record<R> {
    /// Pairs of key and value: what, when, on which machine.
    pub head: Vec<(String, String)>,
    /// In the order of measuring.
    pub rows: Vec<R>,
}

/// One contestant on one story at one setting.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Work {
    /// The name of the story.
    pub story: String,
    /// The name of the contestant.
    pub contestant: String,
    /// The word of its group.
    pub group: String,
    /// What it was set to, as [`Setting`](crate::contestant::Setting) prints it.
    pub setting: String,
    /// Steps done.
    pub steps: Option<u64>,
    /// Median time of a run, s.
    pub seconds: Option<f64>,
    /// The longest of the times measured over the shortest.
    pub spread: Option<f64>,
    /// How early or late the last flip came, as a share of the time between two.
    pub phase: Option<f64>,
    /// The angle between the body's attitude and the true one at the end, rad.
    pub attitude: Option<f64>,
    /// Relative error of the energy.
    pub energy: Option<f64>,
    /// Relative error of the length of the angular momentum.
    pub momentum: Option<f64>,
    /// Error of its direction in the world, rad.
    pub direction: Option<f64>,
    /// How the run ended, as [`Outcome`](crate::errors::Outcome) prints it.
    pub outcome: String,
}

impl Work {
    /// Whether it came to the end with every flip.
    #[must_use]
    pub fn right(&self) -> bool {
        self.outcome == "right"
    }

    /// The number of equal steps that it was set to, if it was set to one.
    #[must_use]
    pub fn equal_steps(&self) -> Option<u64> {
        self.setting.strip_suffix(" steps")?.parse().ok()
    }
}

/// One method after a number of turns of a long run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Long {
    /// The name of the contestant.
    pub contestant: String,
    /// The word of its group.
    pub group: String,
    /// Steps in a turn.
    pub steps: u32,
    /// Turns from the start to the end of the window, which begins at half of them.
    pub turns: u64,
    /// Mean over the window of the relative error of the energy, its size; root mean square over the starts.
    pub mean: f64,
    /// The largest relative error of the energy in the window; root mean square over the starts.
    pub largest: f64,
    /// The largest relative error of the momentum's length; root mean square over the starts.
    pub momentum: f64,
    /// How the run ended, as [`Outcome`](crate::errors::Outcome) prints it.
    pub outcome: String,
}

impl Long {
    /// Whether it came to the end of the window.
    #[must_use]
    pub fn right(&self) -> bool {
        self.outcome == "right"
    }
}

impl<R: Serialize + DeserializeOwned> Record<R> {
    /// As a file has it.
    ///
    /// # Errors
    /// A row that cannot be written to such a file.
    pub fn write(&self) -> Result<String, AnyError> {
        let head: String = self.head.iter().map(|(key, value)| format!("# {key}: {value}\n")).collect();
        let mut rows = csv::Writer::from_writer(Vec::new());
        self.rows.iter().try_for_each(|row| rows.serialize(row))?;
        Ok(head + &String::from_utf8(rows.into_inner()?)?)
    }

    /// Back from a file.
    ///
    /// # Errors
    /// The line that cannot be read, and why.
    pub fn read(text: &str) -> Result<Self, AnyError> {
        let heads = text.lines().map_while(|line| line.strip_prefix("# ")?.split_once(": "));
        let head = heads.map(|(key, value)| (key.to_owned(), value.to_owned())).collect();
        let mut lines = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
        Ok(Self { head, rows: lines.deserialize().collect::<Result<_, _>>()? })
    }

    /// What the head says under a key.
    #[must_use]
    pub fn said(&self, key: &str) -> Option<&str> {
        self.head.iter().find(|(k, _)| k == key).map(|(_, value)| value.as_str())
    }
}

/// A number to four digits, which is what a record keeps of it.
pub fn short(x: f64) -> f64 {
    format!("{x:.3e}").parse().unwrap_or(x)
}

/// The committed record of work.
///
/// # Errors
/// A record that cannot be read.
pub fn work() -> Result<Record<Work>, AnyError> {
    Record::read(include_str!("../record/work.csv"))
}

/// The committed record of long runs.
///
/// # Errors
/// A record that cannot be read.
pub fn long() -> Result<Record<Long>, AnyError> {
    Record::read(include_str!("../record/long.csv"))
}

/// Free motions of bodies from the whole triangle of moments, to 20 digits, in JSON, by `data/errors.py`.
pub const FREE_MOTIONS: &str = include_str!("../record/errors.json");
