//! How a record keeps each law.

use crate::law::LawName;
use crate::laws::Growth;
use serde::Serialize;

/// How a law was kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// Which.
    pub name: LawName,
    /// How its error grew.
    pub growth: Growth,
    /// The greatest error.
    pub most: f64,
    /// The last error, with its sign.
    pub last: f64,
}

/// Flips counted, in the record and in the exact motion.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct FlipCount {
    /// In the record: changes of sign of the spin along the middle axis.
    pub found: u64,
    /// In the exact motion, in the same time.
    pub exact: u64,
    /// The time of the first in the record, s from its start.
    pub first: Option<f64>,
    /// The time of the first of the exact motion, s from the start.
    pub first_exact: Option<f64>,
    /// The greatest difference in time between flips of the same number, s.
    pub apart: f64,
    /// The times of the first 512 in the record, s from its start.
    pub times: Vec<f64>,
    /// When the spin along the axis that it circles first changes sign, s from the start. In the exact motion
    /// it never does.
    pub turned_over: Option<f64>,
}
