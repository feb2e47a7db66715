//! What a record says: its rows, its comments, and how its numbers are meant.

pub(crate) mod clock;
pub(crate) mod columns;
pub(crate) mod comment;
pub(crate) mod derived;
pub(crate) mod digits;
pub(crate) mod fit;
pub(crate) mod grid;
pub(crate) mod known;
pub(crate) mod note;
pub(crate) mod reading;
pub(crate) mod rounding;
pub(crate) mod rows;
pub(crate) mod sample;
pub(crate) mod source;
pub(crate) mod state;
pub(crate) mod units;
