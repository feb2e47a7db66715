//! How a run ended: where, or why not.

use tumbling::step::State;
use tumbling::{Error, ErrorKind};

/// Where a run ended, and what it took.
#[derive(Debug, Clone, PartialEq)]
pub struct Ended {
    /// Attitude, and momentum in body axes.
    pub motion: State<f64>,
    /// Steps done.
    pub steps: u64,
    /// How often the law was evaluated, where that was counted.
    pub evaluations: Option<u64>,
    /// The time it took by its own clock, s, where it runs in another process.
    pub seconds: Option<f64>,
}

/// Why a run did not come to its end.
#[derive(Debug, Clone, PartialEq)]
pub enum Failure {
    /// The motion left what an `f64` holds.
    NotFinite,
    /// It says so itself, in these words.
    Refused(String),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        match error.kind() {
            ErrorKind::Unrepresentable | ErrorKind::NotFinite => Self::NotFinite,
            _ => Self::Refused(error.to_string()),
        }
    }
}
