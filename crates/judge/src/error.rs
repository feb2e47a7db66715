//! Errors in a record, with their places.

use crate::law::LawName;
use std::fmt;

/// Why a record could not be judged.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// The source itself failed.
    Read {
        /// The line that was being read, from 1; 0 where it could not be opened.
        line: usize,
        /// The system's error.
        source: std::io::Error,
    },
    /// No line except comments.
    Empty,
    /// No row.
    NoRows,
    /// One row: nothing to compare it with.
    OneRow,
    /// A field that cannot be used.
    Field {
        /// Its line, from 1.
        line: usize,
        /// Its column, from 1.
        column: usize,
        /// Its column's name.
        name: String,
        /// What is wrong with it.
        problem: String,
    },
    /// A row in memory that cannot be used.
    Row {
        /// The row, from 1.
        row: usize,
        /// What is wrong with it.
        problem: String,
    },
    /// A line that cannot be used as a whole.
    Line {
        /// The line, from 1.
        line: usize,
        /// What is wrong with it.
        problem: String,
    },
    /// The library does not accept the body or its motion.
    Body(tumbling::Error),
    /// The engine resets the body to its start instead of taking the step.
    StartsAnew {
        /// A component of the spin or of its rate, rad/s or rad/s².
        value: f64,
        /// The largest value that the engine accepts.
        most: f64,
    },
    /// Neither a header nor the caller gives the moments.
    NoMoments,
    /// Records that cannot be compared.
    Compared {
        /// Why not.
        problem: String,
    },
    /// A threshold that is no number above zero.
    Threshold {
        /// The law that it is for; all laws, where there is none.
        law: Option<LawName>,
        /// The threshold.
        value: f64,
    },
    /// No start could be fitted to the first rows.
    Fit {
        /// How many rows were to be fitted.
        rows: usize,
        /// Why not.
        problem: String,
    },
}

/// What is wrong with a time, s, that is not after the last.
pub(crate) fn not_later(time: f64, last: f64) -> String {
    let digits = if time == last { ", and times with all their digits" } else { "" };
    format!(
        "time does not increase: {time} s after {last} s. Write each instant once, in the order of time{digits}"
    )
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read { line: 0, source } => write!(f, "{source}"),
            Self::Read { line, source } => write!(f, "line {line}: {source}"),
            Self::Empty => f.write_str("the file is empty: it needs a line of column names, then rows of numbers"),
            Self::NoRows => f.write_str("there are no rows: a motion needs at least two"),
            Self::OneRow => f.write_str("there is one row: a motion needs at least two"),
            Self::Line { line, problem } => write!(f, "line {line}: {problem}"),
            Self::Row { row, problem } => write!(f, "row {row}: {problem}"),
            Self::Compared { problem } => f.write_str(problem),
            Self::Field { line, column, name, problem } => {
                write!(f, "line {line}, column {column} (`{name}`): {problem}")
            }
            Self::Body(error) => write!(f, "{error}"),
            Self::StartsAnew { value, most } => {
                write!(f, "the engine resets the body: the spin or its rate is {value:e}, and must be at most {most:e}")
            }
            Self::Threshold { law, value } => {
                let law = law.map_or("every law", LawName::words);
                write!(f, "the threshold for {law} is {value}: it must be a number above zero")
            }
            Self::Fit { rows, problem } => write!(f, "a fit over the first {rows} rows: {problem}"),
            Self::NoMoments => f.write_str(
                "the principal moments are not known: write them into the record as a comment line `# inertia: A B C`, or give them with it. They are about the body's x, y and z, which must be its principal axes",
            ),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Read { source, .. } => Some(source),
            Self::Body(error) => Some(error),
            _ => None,
        }
    }
}

impl From<tumbling::Error> for Error {
    fn from(error: tumbling::Error) -> Self {
        Self::Body(error)
    }
}
