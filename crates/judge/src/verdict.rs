//! The verdict, built once, and its words for terminal, page and program.

pub(crate) mod end;
pub(crate) mod faults;
pub(crate) mod finding;
pub(crate) mod json;
pub(crate) mod outcome;
pub(crate) mod plain;
pub(crate) mod text;
pub(crate) mod words;
