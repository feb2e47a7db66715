//! What was made of a file besides its rows.

use nalgebra::Vector3;

/// What was made of a file besides its rows.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// A comment seems to name a number, and none is read from it.
    Unread {
        /// Its line.
        line: usize,
        /// What it speaks of.
        word: &'static str,
    },
    /// The record is of this story of the kit.
    Story(String),
    /// The body is at rest before this line: the rows before it are left out.
    Rest {
        /// The line.
        line: usize,
    },
    /// Rounded moments that no body has are taken for those of a flat body.
    Flat {
        /// The largest, as printed, kg m².
        printed: f64,
        /// How much more it is than the others together, kg m².
        missing: f64,
        /// The moments judged, kg m².
        moments: Vector3<f64>,
    },
    /// The header names a step of which each row is a whole number.
    StepsPerRow {
        /// The step named, s.
        named: f64,
        /// The number of such steps from row to row.
        steps: u32,
    },
    /// The header names a step of which the time from row to row is no whole number.
    OtherStep {
        /// The step named, s.
        named: f64,
        /// The time from row to row, s.
        row: f64,
    },
    /// Times of few digits are taken for multiples of one step.
    EvenSteps {
        /// Whether the record names the step.
        named: bool,
        /// The step, as the file counts.
        step: f64,
    },
}
