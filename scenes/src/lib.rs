//! Scenes: what a file asks for, answered in the cheapest way that is accurate enough, for one body or for millions.
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod crowd;
#[cfg(feature = "file")]
pub mod file;
pub mod many;
