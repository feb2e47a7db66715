//! What is wrong with a tensor or its principal moments.

use super::{Error, Margin, Subject};
use alloc::boxed::Box;
use core::fmt;

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum TensorRefusal {
    /// `printed`: the difference is small enough to come from digits that were rounded.
    Asymmetric {
        row: usize,
        column: usize,
        value: f64,
        mirrored: f64,
        tolerance: f64,
        printed: bool,
    },
    /// A moment of inertia below zero by more than rounding. `printed` as above.
    NegativeMoment {
        what: Subject,
        value: f64,
        printed: bool,
    },
    /// Moments smallest first. `printed` as above.
    TriangleInequality {
        moments: [f64; 3],
        excess: f64,
        tolerance: f64,
        printed: bool,
    },
    /// The nearest possible tensor or moments lie farther away than the stated tolerance, both relative to
    /// the largest moment.
    TooFar {
        moved: f64,
        tolerance: f64,
    },
    /// A tensor about a point that leaves none about the centre of mass, `distance` away.
    OffCentre {
        mass: f64,
        distance: f64,
        source: Box<Error>,
    },
    Singular {
        smallest: f64,
        largest: f64,
    },
}

impl TensorRefusal {
    pub(super) fn subject(&self) -> Subject {
        match self {
            Self::NegativeMoment { what, .. } => *what,
            Self::Asymmetric { .. } | Self::TooFar { .. } | Self::OffCentre { .. } => Subject::Tensor,
            Self::TriangleInequality { .. } => Subject::PrincipalMoments,
            Self::Singular { .. } => Subject::SmallestMoment,
        }
    }
}

/// The way out where a refusal may be due to rounded digits.
fn hint(printed: bool) -> &'static str {
    if printed {
        "; if its digits were rounded, `within` takes a tolerance and gives the nearest possible body"
    } else {
        ""
    }
}

impl fmt::Display for TensorRefusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Asymmetric { row, column, value, mirrored, tolerance, printed } => write!(
                f,
                "the tensor is not symmetric: entry ({row}, {column}) is {value:?}, entry ({column}, {row}) is \
                 {mirrored:?}; they differ by {}, more than rounding ({}){}",
                Margin((value - mirrored).abs()),
                Margin(*tolerance),
                hint(*printed)
            ),
            Self::NegativeMoment { what, value, printed } => {
                write!(f, "{what} is {value:?}: it must not be below zero{}", hint(*printed))
            }
            // The two smaller in either order name the same rule; the larger of them first reads best.
            Self::TriangleInequality { moments: [a, b, c], excess, tolerance, printed } => write!(
                f,
                "no body has principal moments {a}, {b}, {c}: the triangle inequality {b} + {a} >= {c} fails \
                 by {excess}, more than rounding ({}){}",
                Margin(*tolerance),
                hint(*printed)
            ),
            Self::TooFar { moved, tolerance } => write!(
                f,
                "no body has this tensor: the nearest one that a body has is {} of the largest moment away, \
                 more than the tolerance of {tolerance:e}",
                Margin(*moved)
            ),
            Self::OffCentre { mass, distance, source } => write!(
                f,
                "no body of {mass:?} kg with its centre of mass {distance:?} m away has this tensor: about that centre, {source}"
            ),
            Self::Singular { smallest, largest } => write!(
                f,
                "the smallest principal moment, {smallest:?}, is zero relative to the largest, {largest:?}: the tensor \
                 has no inverse, so momentum does not determine spin"
            ),
        }
    }
}
