//! The library and its judge for Python. Nothing is computed here.
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod arrays;
mod batch;
mod error;
mod fit;
mod inertia;
mod judge;
mod motion;
mod picture;
mod stepper;
mod story;
mod top;
mod torque;

/// The contents of the package `tumbling`.
#[pyo3::pymodule]
mod _tumbling {
    #[pymodule_export]
    use super::{
        batch::Batch, error::Error, fit::FittedInertia, fit::fit_inertia, inertia::Inertia,
        judge::Comparison, judge::Verdict, judge::compare, judge::judge, motion::FreeMotion,
        stepper::Stepper, story::Story, top::LagrangeTop, torque::Torque,
    };
    /// The library's version.
    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "Python's name")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
