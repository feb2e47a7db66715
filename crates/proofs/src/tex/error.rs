//! The error for TeX that cannot be read.

use std::fmt;

/// TeX that is not read: where, and what could have stood there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TexError {
    /// The place, in bytes from the start.
    pub at: usize,
    /// What could have stood there.
    pub expected: &'static str,
}

impl TexError {
    pub(super) fn new(at: usize, expected: &'static str) -> Self {
        Self { at, expected }
    }
}

impl fmt::Display for TexError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "expected {} at byte {}", self.expected, self.at)
    }
}

impl std::error::Error for TexError {}
