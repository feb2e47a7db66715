//! Each way to be refused, with the values that its sentence names.

use super::{Error, ErrorKind};
use alloc::boxed::Box;
use core::fmt;

/// What was wrong, one variant for each sentence. Behind [`Error`], so that a sentence can gain a number
/// without breaking anyone.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Refusal {
    NotFinite {
        what: &'static str,
        value: f64,
    },
    NotPositive {
        what: &'static str,
        value: f64,
    },
    Negative {
        what: &'static str,
        value: f64,
    },
    /// A finite input gives a result that a finite nonzero `f64` cannot hold with all its digits: an
    /// infinity, zero, a subnormal number, or NaN from infinities.
    OutOfRange {
        what: &'static str,
        value: f64,
    },
    NotBelow {
        what: &'static str,
        value: f64,
        limit: f64,
    },
    Order {
        smaller: &'static str,
        small: f64,
        larger: &'static str,
        large: f64,
    },
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
        what: &'static str,
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
    ZeroVector {
        what: &'static str,
    },
    NotUnit {
        norm: f64,
        tolerance: f64,
    },
    TooFew {
        what: &'static str,
        count: usize,
        needed: usize,
    },
    TooMany {
        what: &'static str,
        count: usize,
    },
    NotConverged {
        what: &'static str,
        iterations: usize,
        residual: f64,
    },
    Unfinished {
        what: &'static str,
        steps: usize,
        reached: f64,
        duration: f64,
        why: &'static str,
    },
    BadFace {
        face: usize,
        vertices: [usize; 3],
        count: usize,
    },
    OpenMesh {
        edge: [usize; 2],
        faces: usize,
    },
    /// The edge's two vertices, in the direction that both faces take.
    FlippedFace {
        edge: [usize; 2],
    },
    RepeatedFace {
        face: usize,
        before: usize,
        vertices: [usize; 3],
    },
    NoVolume {
        volume: f64,
        tolerance: f64,
    },
    /// `winding`: how many times the shells together enclose a point next to this one.
    MisplacedShell {
        face: usize,
        volume: f64,
        winding: f64,
    },
    NoSuchAxis {
        axis: usize,
    },
    Part {
        index: usize,
        source: Box<Error>,
    },
    Undefined {
        what: &'static str,
        why: &'static str,
    },
}

impl Refusal {
    pub(super) fn kind(&self) -> ErrorKind {
        match self {
            Self::NotFinite { .. } => ErrorKind::NotFinite,
            Self::NotPositive { .. }
            | Self::Negative { .. }
            | Self::NotBelow { .. }
            | Self::Order { .. }
            | Self::NotUnit { .. }
            | Self::TooFew { .. }
            | Self::NoSuchAxis { .. } => ErrorKind::OutOfBounds,
            Self::Asymmetric { .. }
            | Self::NegativeMoment { .. }
            | Self::TriangleInequality { .. }
            | Self::TooFar { .. }
            | Self::OffCentre { .. } => ErrorKind::Impossible,
            Self::Singular { .. } => ErrorKind::NotInvertible,
            Self::OutOfRange { .. } => ErrorKind::Unrepresentable,
            Self::ZeroVector { .. } | Self::Undefined { .. } => ErrorKind::Undefined,
            Self::TooMany { .. } | Self::Unfinished { .. } => ErrorKind::TooMany,
            Self::NotConverged { .. } => ErrorKind::NotConverged,
            Self::BadFace { .. }
            | Self::OpenMesh { .. }
            | Self::FlippedFace { .. }
            | Self::RepeatedFace { .. }
            | Self::NoVolume { .. }
            | Self::MisplacedShell { .. } => ErrorKind::BadMesh,
            Self::Part { source, .. } => source.kind(),
        }
    }

    pub(super) fn subject(&self) -> &'static str {
        match self {
            Self::NotFinite { what, .. }
            | Self::NotPositive { what, .. }
            | Self::Negative { what, .. }
            | Self::OutOfRange { what, .. }
            | Self::NotBelow { what, .. }
            | Self::NegativeMoment { what, .. }
            | Self::ZeroVector { what }
            | Self::TooFew { what, .. }
            | Self::TooMany { what, .. }
            | Self::NotConverged { what, .. }
            | Self::Unfinished { what, .. }
            | Self::Undefined { what, .. }
            | Self::Order { smaller: what, .. } => what,
            Self::Asymmetric { .. } | Self::TooFar { .. } | Self::OffCentre { .. } => "the inertia tensor",
            Self::TriangleInequality { .. } => "the principal moments",
            Self::Singular { .. } => "the smallest principal moment",
            Self::NotUnit { .. } => "the attitude quaternion",
            Self::NoSuchAxis { .. } => "the principal axis",
            Self::BadFace { .. } | Self::FlippedFace { .. } | Self::RepeatedFace { .. } => "a face",
            Self::OpenMesh { .. } => "an edge",
            Self::NoVolume { .. } => "the volume",
            Self::MisplacedShell { .. } => "a shell",
            Self::Part { source, .. } => source.subject(),
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
                "{what} comes out as {value:?}: its true value is beyond what a finite, nonzero f64 holds in full"
            ),
            Self::Order { smaller, small, larger, large } => {
                write!(f, "{smaller} is {small:?}: it must be at most {larger}, {large:?}")
            }
            Self::NotBelow { what, value, limit } => {
                write!(f, "{what} is {value:?}: it must be below {limit}")
            }
            Self::Asymmetric { row, column, value, mirrored, tolerance, printed } => write!(
                f,
                "the tensor is not symmetric: entry ({row}, {column}) is {value:?}, entry ({column}, {row}) is \
                 {mirrored:?}; they differ by {:.3e}, more than rounding ({tolerance:.1e}){}",
                (value - mirrored).abs(),
                hint(*printed)
            ),
            Self::NegativeMoment { what, value, printed } => {
                write!(f, "{what} is {value:?}: it must not be below zero{}", hint(*printed))
            }
            // The two smaller in either order name the same rule; the larger of them first reads best.
            Self::TriangleInequality { moments: [a, b, c], excess, tolerance, printed } => write!(
                f,
                "no body has principal moments {a}, {b}, {c}: the triangle inequality {b} + {a} >= {c} fails \
                 by {excess}, more than rounding ({tolerance:.1e}){}",
                hint(*printed)
            ),
            Self::TooFar { moved, tolerance } => write!(
                f,
                "no body has this tensor: the nearest one that a body has is {moved:.3e} of the largest moment away, \
                 more than the tolerance of {tolerance:e}"
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
            Self::ZeroVector { what } => write!(f, "{what} is the zero vector: it has no direction"),
            Self::NotUnit { norm, tolerance } => write!(
                f,
                "the attitude quaternion has length {norm:?}, off 1 by {:.3e}: it must be 1 to within {tolerance:.1e}",
                (norm - 1.0).abs()
            ),
            Self::NoSuchAxis { axis } => {
                write!(f, "there is no principal axis number {axis}: they are numbered 0, 1 and 2")
            }
            Self::TooFew { what, count, needed } => {
                write!(f, "{count} {what} given: at least {needed} needed")
            }
            Self::TooMany { what, count } => {
                write!(f, "{count} {what} requested: more than there is memory to hold")
            }
            Self::NotConverged { what, iterations, residual } => write!(
                f,
                "{what} was not found in {iterations} rounds: the last still moved by {residual:.3e}, more than rounding"
            ),
            Self::Unfinished { what, steps, reached, duration, why } => {
                write!(f, "{what} came to {reached:e} s of {duration:e} s in {steps} steps: {why}")
            }
            Self::BadFace { face, vertices: [a, b, c], count } => write!(
                f,
                "face {face} is ({a}, {b}, {c}): it must name three different vertices below {count}"
            ),
            Self::OpenMesh { edge: [a, b], faces } => write!(
                f,
                "the edge from vertex {a} to vertex {b} belongs to {faces} face(s): in a closed surface it is 2, \
                 or 4 where parts touch"
            ),
            Self::FlippedFace { edge: [a, b] } => {
                write!(f, "two faces run from vertex {a} to vertex {b}: one of them is turned inside out")
            }
            Self::NoVolume { volume, tolerance } => write!(
                f,
                "the volume comes out as {volume:?}, not above zero by more than rounding ({tolerance:.1e}): the solid \
                 is flat, or its faces do not run counter-clockwise seen from outside"
            ),
            Self::Part { index, source } => write!(f, "part {index}: {source}"),
            Self::Undefined { what, why } => write!(f, "{what} is undefined here: {why}"),
            Self::RepeatedFace { face, before, vertices: [a, b, c] } => {
                write!(f, "face {face}, ({a}, {b}, {c}), is face {before} again: each must be listed once")
            }
            Self::MisplacedShell { face, volume, winding } => write!(
                f,
                "the shell that face {face} belongs to, of volume {volume:?}, is turned or placed wrongly: next to it \
                 the shells enclose a point {winding} times, and it must be 0 (outside the solid) or 1 (inside); a \
                 shell of negative volume is a cavity and must lie in the solid"
            ),
        }
    }
}
