#![doc = include_str!("references.md")]
//!
//! The book prints the same list, so that a key means one thing everywhere.
