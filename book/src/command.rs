//! The commands, one per file; the command line itself is in `cli`.

pub(crate) mod docs;
pub(crate) mod draw;
pub(crate) mod exercises;
pub(crate) mod export;
pub(crate) mod film;
pub(crate) mod measure;
pub(crate) mod report;
