//! Judges how well an engine turns a rigid body that nothing touches: a trajectory in, a verdict out.
//!
//! [`judge`] reads a record row by row and holds it against the exact motion from its first row. The
//! [`Verdict`] says how each law of free motion is kept, what is wrong with the file if its numbers are not
//! what their names say, and which rule made it: each rule known to the library takes the recorded rows one
//! step further, and is held against the next row.
//!
//! Its memory does not grow with the record.
#![cfg_attr(doctest, doc = include_str!("../README.md"))]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod accuracy;
mod advice;
mod candidates;
mod clock;
mod columns;
mod comment;
mod confidence;
mod curve;
mod derived;
mod diagnosis;
mod digits;
mod drift;
mod engine_step;
mod engines;
mod error;
mod faults;
mod finding;
mod findings;
mod fit;
mod fitted;
mod grid;
mod hints;
mod json;
mod judge;
mod jumps;
mod kit;
mod law;
mod laws;
mod memory;
mod names;
mod plain;
mod points;
mod reading;
pub mod records;
mod rounding;
mod rows;
mod rules;
mod sample;
mod source;
mod state;
mod text;
mod thresholds;
mod trial;
mod units;
mod verdict;
mod words;

pub use accuracy::Accuracy;
pub use advice::Advice;
pub use confidence::Confidence;
pub use curve::Growth;
pub use diagnosis::{Diagnosis, Explanation};
pub use engine_step::{Limits, PhysicsEngine};
pub use engines::PHYSICS_ENGINES;
pub use error::Error;
pub use findings::{Complaint, Hint, Note};
pub use fit::Fit;
pub use judge::judge;
pub use kit::{Answer, Story};
pub use law::{FlipCount, Law, LawName};
pub use memory::{Precision, Row, judge_in_memory};
pub use plain::plain_number;
pub use points::Point;
pub use reading::FileMistake;
pub use rules::{Alteration, Base, Rule, Spin, Steps, When};
pub use verdict::{Gaps, Options, Outcome, Recording, Reset, Verdict};
