//! A finding of the guard, and its place.

use std::fmt;

/// A place where the book states something without evidence.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Offence {
    /// The file, as the reader of the message would open it.
    pub(crate) file: String,
    /// Its line, counted from one.
    pub(crate) line: usize,
    /// The words at that place.
    pub(crate) found: String,
    /// The right words or evidence.
    pub(crate) expected: String,
}

impl fmt::Display for Offence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: found {}, expected {}", self.file, self.line, self.found, self.expected)
    }
}
