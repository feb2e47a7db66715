//! Judges how well an engine turns a rigid body that nothing touches: a trajectory in, a verdict out.
//!
//! [`judge`] reads a record row by row and compares it with the exact motion from its first row. The
//! [`Verdict`] says how each law of free motion is kept, what is wrong with the file if its numbers are not
//! what their names say, and which rule made it: each rule known to the library takes the recorded rows one
//! step further, and is compared with the next row.
//!
//! Its memory does not grow with the record.
#![cfg_attr(doctest, doc = include_str!("../README.md"))]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]
#![recursion_limit = "256"]

mod compared;
mod error;
mod gyroscope;
mod judge;
mod kit;
mod law;
mod laws;
mod memory;
mod options;
mod read;
mod rule;
mod thresholds;
mod verdict;

pub use compared::{Apart, Comparison, Motion, Off, compare};
pub use error::Error;
pub use gyroscope::{FittedInertia, fit_inertia};
pub use judge::judge;
pub use kit::{Answer, Story};
pub use law::LawName;
pub use laws::{FlipCount, Gaps, Growth, Law, Point, Reset};
pub use memory::{Description, Precision, Row, judge_described, judge_in_memory};
pub use options::Options;
pub use read::{FileMistake, Kind, Note};
pub use rule::{Advice, Alteration, Base, Confidence, Diagnosis, Explanation, Jump, Rule, Steps, Turn, When};
pub use tumbling_engines::{Limits, PHYSICS_ENGINES, PhysicsEngine};
pub use verdict::{Complaint, Outcome, Recording, Section, Seen, Verdict};
