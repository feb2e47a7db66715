//! Errors in a record, with their places.

use crate::law::LawName;

/// Why a record could not be judged.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The source itself failed.
    #[error("{}{source}", place(*.line))]
    Read {
        /// The line that was being read, from 1; 0 where it could not be opened.
        line: usize,
        /// The system's error.
        source: std::io::Error,
    },
    /// No line except comments.
    #[error("the file is empty: it needs a line of column names, then rows of numbers")]
    Empty,
    /// No row.
    #[error("there are no rows: a motion needs at least two")]
    NoRows,
    /// One row: nothing to compare it with.
    #[error("there is one row: a motion needs at least two")]
    OneRow,
    /// A field that cannot be used.
    #[error("line {line}, column {column} (`{name}`): {problem}")]
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
    #[error("row {row}: {problem}")]
    Row {
        /// The row, from 1.
        row: usize,
        /// What is wrong with it.
        problem: String,
    },
    /// A line that cannot be used as a whole.
    #[error("line {line}: {problem}")]
    Line {
        /// The line, from 1.
        line: usize,
        /// What is wrong with it.
        problem: String,
    },
    /// The library does not accept the body or its motion.
    #[error("{0}")]
    Body(#[from] tumbling::Error),
    /// An engine of the list takes no step.
    #[error("{0}")]
    Engine(#[from] tumbling_engines::Error),
    /// Neither a header nor the caller gives the moments.
    #[error(
        "the principal moments are not known: write them into the record as a comment line `# inertia: A B C`, or give them with it. They are about the body's x, y and z, which must be its principal axes"
    )]
    NoMoments,
    /// Records that cannot be compared.
    #[error("{problem}")]
    Compared {
        /// Why not.
        problem: String,
    },
    /// A threshold that is no number above zero.
    #[error("the threshold for {} is {value}: it must be a number above zero", .law.map_or("every law", LawName::words))]
    Threshold {
        /// The law that it is for; all laws, where there is none.
        law: Option<LawName>,
        /// The threshold.
        value: f64,
    },
    /// No start could be fitted to the first rows.
    #[error("a fit over the first {rows} rows: {problem}")]
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

/// The line before an error of the system; nothing where the source could not be opened.
fn place(line: usize) -> String {
    if line == 0 { String::new() } else { format!("line {line}: ") }
}
