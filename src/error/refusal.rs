//! Each way to be refused, with the values that its sentence names.

use super::mesh_refusal::MeshRefusal;
use super::tensor_refusal::TensorRefusal;
use super::{Error, ErrorKind, Margin, Subject};
use alloc::boxed::Box;
use core::fmt;

/// What was wrong, one variant for each sentence. Behind [`Error`], so that a sentence can gain a number
/// without breaking anyone.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Refusal {
    NotFinite {
        what: Subject,
        value: f64,
    },
    NotPositive {
        what: Subject,
        value: f64,
    },
    Negative {
        what: Subject,
        value: f64,
    },
    /// A finite input gives a result that a finite nonzero number of its type cannot hold with all its
    /// digits: an infinity, zero, a subnormal number, or NaN from infinities.
    OutOfRange {
        what: Subject,
        value: f64,
    },
    NotBelow {
        what: Subject,
        value: f64,
        limit: f64,
    },
    /// `least` is `meaning`.
    TooSmall {
        what: Subject,
        value: f64,
        least: f64,
        meaning: &'static str,
    },
    /// Not zero, and so small that products with it lose digits.
    Underflow {
        what: Subject,
        value: f64,
        least: f64,
    },
    Order {
        smaller: Subject,
        small: f64,
        larger: &'static str,
        large: f64,
    },
    ZeroVector {
        what: Subject,
    },
    NotUnitVector {
        what: Subject,
        length: f64,
        tolerance: f64,
    },
    NotUnit {
        norm: f64,
        tolerance: f64,
    },
    TooFew {
        what: Subject,
        count: usize,
        needed: usize,
    },
    TooMany {
        what: Subject,
        count: usize,
    },
    NotConverged {
        what: Subject,
        iterations: usize,
        residual: f64,
    },
    /// `shortest`: the last length of a step, s; NaN where the rates are beyond the numbers.
    NoStep {
        tried: usize,
        reached: f64,
        shortest: f64,
    },
    Unfinished {
        what: Subject,
        steps: usize,
        reached: f64,
        duration: f64,
        why: &'static str,
    },
    Part {
        index: usize,
        source: Box<Error>,
    },
    Undefined {
        what: Subject,
        why: &'static str,
    },
    Tensor(TensorRefusal),
    Mesh(MeshRefusal),
}

impl Refusal {
    pub(super) fn kind(&self) -> ErrorKind {
        match self {
            Self::NotFinite { .. } => ErrorKind::NotFinite,
            Self::NotPositive { .. }
            | Self::Negative { .. }
            | Self::NotBelow { .. }
            | Self::TooSmall { .. }
            | Self::Order { .. }
            | Self::NotUnit { .. }
            | Self::NotUnitVector { .. }
            | Self::TooFew { .. } => ErrorKind::OutOfBounds,
            Self::OutOfRange { .. } | Self::Underflow { .. } => ErrorKind::Unrepresentable,
            Self::ZeroVector { .. } | Self::Undefined { .. } => ErrorKind::Undefined,
            Self::TooMany { .. }
            | Self::Unfinished { .. }
            | Self::Mesh(MeshRefusal::TooManyShells { .. }) => ErrorKind::TooMany,
            Self::NotConverged { .. } | Self::NoStep { .. } => ErrorKind::NotConverged,
            Self::Tensor(TensorRefusal::Singular { .. }) => ErrorKind::NotInvertible,
            Self::Tensor(_) => ErrorKind::Impossible,
            Self::Mesh(_) => ErrorKind::BadMesh,
            Self::Part { source, .. } => source.kind(),
        }
    }

    pub(super) fn subject(&self) -> Subject {
        match self {
            Self::NotFinite { what, .. }
            | Self::NotPositive { what, .. }
            | Self::Negative { what, .. }
            | Self::OutOfRange { what, .. }
            | Self::NotBelow { what, .. }
            | Self::TooSmall { what, .. }
            | Self::Underflow { what, .. }
            | Self::ZeroVector { what }
            | Self::TooFew { what, .. }
            | Self::TooMany { what, .. }
            | Self::NotUnitVector { what, .. }
            | Self::NotConverged { what, .. }
            | Self::Unfinished { what, .. }
            | Self::Undefined { what, .. }
            | Self::Order { smaller: what, .. } => *what,
            Self::NoStep { .. } => Subject::StepLength,
            Self::NotUnit { .. } => Subject::Attitude,
            Self::Tensor(refusal) => refusal.subject(),
            Self::Mesh(refusal) => refusal.subject(),
            Self::Part { source, .. } => source.subject(),
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { what, value } => {
                write!(f, "{what} is {value}: it must be a finite number")
            }
            Self::NotPositive { what, value } => {
                write!(f, "{what} is {value:?}: it must be above zero")
            }
            Self::Negative { what, value } => {
                write!(f, "{what} is {value:?}: it must not be below zero")
            }
            Self::OutOfRange { what, value } => write!(
                f,
                "{what} comes out as {value:?}: its true value is beyond what a finite, nonzero floating-point number holds in full"
            ),
            Self::Order { smaller, small, larger, large } => {
                write!(f, "{smaller} is {small:?}: it must be at most {larger}, {large:?}")
            }
            Self::NotBelow { what, value, limit } => {
                write!(f, "{what} is {value:?}: it must be below {limit}")
            }
            Self::TooSmall { what, value, least, meaning } => {
                write!(f, "{what} is {value:?}: it must be at least {least:e}, {meaning}")
            }
            Self::Underflow { what, value, least } => write!(
                f,
                "{what} is {value:?}: it must be 0 or at least {least:e}, so that its products keep all their digits"
            ),
            Self::ZeroVector { what } => write!(f, "{what} is the zero vector: it has no direction"),
            Self::NotUnit { norm, tolerance } => write!(
                f,
                "the attitude quaternion has length {norm:?}, off 1 by {}: it must be 1 to within {}",
                Margin((norm - 1.0).abs()),
                Margin(*tolerance)
            ),
            Self::NotUnitVector { what, length, tolerance } => write!(
                f,
                "{what} has length {length:?}, off 1 by {}: it must be 1 to within {}",
                Margin((length - 1.0).abs()),
                Margin(*tolerance)
            ),
            Self::TooFew { what, count, needed } => {
                write!(f, "{count} {what} given: at least {needed} needed")
            }
            Self::TooMany { what, count } => {
                write!(f, "{count} {what} requested: more than there is memory to hold")
            }
            Self::NotConverged { what, iterations, residual } => write!(
                f,
                "{what} was not found in {iterations} rounds: the last still moved by {}, more than rounding",
                Margin(*residual)
            ),
            Self::NoStep { tried, reached, shortest } if shortest.is_finite() => write!(
                f,
                "after {tried} steps, taken or rejected, no step at {reached:e} s meets the tolerance, down to one of \
                 {shortest:e} s"
            ),
            Self::NoStep { tried, reached, .. } => write!(
                f,
                "after {tried} steps, taken or rejected, no step at {reached:e} s meets the tolerance: the rates there \
                 are beyond what a floating-point number holds"
            ),
            Self::Unfinished { what, steps, reached, duration, why } => {
                write!(f, "{what} came to {reached:e} s of {duration:e} s in {steps} steps: {why}")
            }
            Self::Part { index, source } => write!(f, "part {index}: {source}"),
            Self::Undefined { what, why } => write!(f, "{what} is undefined here: {why}"),
            Self::Tensor(refusal) => refusal.fmt(f),
            Self::Mesh(refusal) => refusal.fmt(f),
        }
    }
}
