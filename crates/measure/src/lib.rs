//! Error against run time: every stepper of the library on the same bodies, against the truth.
//!
//! A [`Contestant`](contestant::Contestant) (a [`Method`](tumbling::step::Method), the exact motion, or a
//! peer that another crate brings) runs a [`Story`](story::Story), a body with a start, at one setting: a
//! step, or a tolerance. Its final state is compared with the [truth](story::Truth): the exact motion, or a
//! table of many digits if a torque acts. It is never compared with the method itself at a smaller step.
//!
//! [`campaign`] does that for all of them and writes the [`record`]: files of comma-separated values, whose
//! heads say what, when, on which machine. The book's figures and chapters are made from those files.
//! [`costs`] is the record of the cost of a scene for different outputs.
//!
//! The [`atlas`] measures no time. It shows the result of each method on each hard case under torques.
#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

pub mod atlas;
pub mod campaign;
pub mod contestant;
pub mod costs;
pub mod drive;
pub mod errors;
pub mod long;
pub mod measure;
pub mod record;
pub mod setup;
pub mod story;
pub mod verdict;

/// What went wrong, in words.
pub type AnyError = Box<dyn std::error::Error>;
