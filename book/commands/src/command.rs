//! The commands, one per file; the command line itself is in `cli`.

pub(crate) mod body;
pub(crate) mod export;
pub(crate) mod film;
pub(crate) mod measure;
pub(crate) mod report;
