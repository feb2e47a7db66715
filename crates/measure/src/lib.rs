//! Error against run time: every stepper of the library on the same bodies, against the truth.
//!
//! A [`Contestant`](contestant::Contestant) (a [`Method`](tumbling::step::Method), the exact motion, or a
//! peer that another crate brings) runs a [`Story`](story::Story), a body let go in some way, at one setting:
//! a step, or a tolerance. What it ends with is held against the [truth](story::Truth): the exact motion, or
//! a table of many digits where a torque acts. Never against the method itself at a smaller step.
//!
//! [`measure`](measure::measure) does that for all of them, and [`record`] keeps what came out: two files of
//! comma-separated values, whose heads say what, when, on which machine. The figures and the chapter of the
//! book are made from those files.
//!
//! How many bodies a second, and what is left of that when there are millions, [`scale`] measures.
//! [`savings`] counts what a [scene](tumbling_scenes::Scene) costs by its outputs.
//!
//! The [`atlas`] asks another question, without a clock: what becomes of each method on each hard case.
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod atlas;
pub mod campaign;
pub mod contestant;
pub mod drive;
pub mod ended;
pub mod errors;
mod fields;
pub mod instructions;
pub mod long;
pub mod measure;
pub mod operations;
pub mod record;
pub mod saving;
pub mod savings;
pub mod scale;
pub mod setup;
pub mod story;
pub mod verdict;
