//! The verdict, built once, and its words for terminal, page and program.

mod end;
mod finding;
mod json;
mod outcome;
mod plain;
mod report;
mod words;

pub(crate) use end::verdict;
pub(crate) use finding::{capital, sentence};
pub(crate) use json::VERSION;
pub use outcome::{Outcome, Recording, Verdict};
pub(crate) use plain::plain_number;
pub(crate) use report::COLUMNS;
pub use report::Section;
pub(crate) use words::too_far;
