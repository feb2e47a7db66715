//! Why an engine takes no step, or a record is none.

use std::fmt;

/// Why an engine takes no step, or a record is none.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// The library does not accept the body or its motion.
    Body(tumbling::Error),
    /// The engine resets the body to its start instead of taking the step.
    StartsAnew {
        /// A component of the spin or of its rate, rad/s or rad/s².
        value: f64,
        /// The largest value that the engine accepts.
        most: f64,
    },
    /// A line of a record that cannot be read.
    Line(usize),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Body(error) => error.fmt(f),
            Self::StartsAnew { value, most } => write!(
                f,
                "the engine resets the body: the spin or its rate is {value:e}, and must be at most {most:e}"
            ),
            Self::Line(line) => write!(f, "line {line} of the record cannot be read"),
        }
    }
}

impl std::error::Error for Error {}

impl From<tumbling::Error> for Error {
    fn from(error: tumbling::Error) -> Self {
        Self::Body(error)
    }
}
