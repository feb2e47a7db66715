//! The code of the chapters, run by `cargo test`: one module for each chapter, in the order of the
//! book. A chapter's code may use `tumbling` and `nalgebra`.
//!
//! Edition 2024 lets rustdoc build all of it as one program; a block fenced `rust,standalone_crate`
//! gets one of its own.

#[cfg(doctest)]
#[doc = include_str!("introduction.md")]
mod introduction {}
