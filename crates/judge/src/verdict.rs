//! The verdict, built once, and its words for terminal, page and program.

mod end;
mod finding;
mod outcome;
mod report;
mod words;

pub(crate) use end::verdict;
pub(crate) use finding::{capital, sentence};
pub(crate) use outcome::VERSION;
pub use outcome::{Outcome, Recording, Verdict};
pub(crate) use report::COLUMNS;
pub use report::Section;
pub use words::{Complaint, Seen};
pub(crate) use words::{plain_number, too_far};
