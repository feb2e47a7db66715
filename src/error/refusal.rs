//! Every reason for an error: its values, kind, subject and message.

use super::{Error, ErrorKind, Margin, Subject};
use alloc::boxed::Box;
use core::fmt;

macro_rules! refusals {
    ($(
        $(#[$meta:meta])*
        $Name:ident { $($field:ident: $Type:ty),* } $kind:expr, $subject:expr,
            $sentence:literal $(, $part:expr)*;
    )*) => {
        /// What was wrong, one variant for each message. It is private to [`Error`], so that a message can
        /// gain a number without breaking callers.
        #[derive(Debug, Clone, PartialEq)]
        pub(crate) enum Refusal {
            $($(#[$meta])* $Name { $($field: $Type),* },)*
        }

        impl Refusal {
            /// Passes on kind, subject and message. The message is not formatted yet, so that reading kind
            /// and subject costs nothing.
            fn explained<R>(&self, give: impl FnOnce(ErrorKind, Subject, fmt::Arguments<'_>) -> R) -> R {
                match self {
                    $(Self::$Name { $($field),* } => {
                        give($kind, $subject, format_args!($sentence $(, $part)*))
                    })*
                }
            }
        }
    };
}

refusals! {
    NotFinite { what: Subject, value: f64 } ErrorKind::NotFinite, *what,
        "{what} is {value}: it must be a finite number";

    NotPositive { what: Subject, value: f64 } ErrorKind::OutOfBounds, *what,
        "{what} is {value:?}: it must be above zero";

    Negative { what: Subject, value: f64 } ErrorKind::OutOfBounds, *what,
        "{what} is {value:?}: it must not be below zero";

    NotBelow { what: Subject, value: f64, limit: f64 } ErrorKind::OutOfBounds, *what,
        "{what} is {value:?}: it must be below {limit}";

    /// `least` is `meaning`.
    TooSmall { what: Subject, value: f64, least: f64, meaning: &'static str } ErrorKind::OutOfBounds, *what,
        "{what} is {value:?}: it must be at least {least:e}, {meaning}";

    Order { smaller: Subject, small: f64, larger: &'static str, large: f64 } ErrorKind::OutOfBounds, *smaller,
        "{smaller} is {small:?}: it must be at most {larger}, {large:?}";

    NotUnit { what: Subject, length: f64, tolerance: f64 } ErrorKind::OutOfBounds, *what,
        "{what} has length {length:?}, off 1 by {}: it must be 1 to within {}",
        Margin((length - 1.0).abs()), Margin(*tolerance);

    TooFew { what: Subject, count: usize, needed: usize } ErrorKind::OutOfBounds, *what,
        "{count} {what} given: at least {needed} needed";

    /// A finite input gives a result that a finite nonzero number of its type cannot hold with all its
    /// digits: an infinity, zero, a subnormal number, or NaN from infinities.
    OutOfRange { what: Subject, value: f64 } ErrorKind::Unrepresentable, *what,
        "{what} comes out as {value:?}: its true value is beyond what a finite, nonzero floating-point number \
         holds in full";

    /// Not zero, and so small that products with it lose digits.
    Underflow { what: Subject, value: f64, least: f64 } ErrorKind::Unrepresentable, *what,
        "{what} is {value:?}: it must be 0 or at least {least:e}, so that its products keep all their digits";

    ZeroVector { what: Subject } ErrorKind::Undefined, *what,
        "{what} is the zero vector: it has no direction";

    Undefined { what: Subject, why: &'static str } ErrorKind::Undefined, *what,
        "{what} is undefined here: {why}";

    TooMany { what: Subject, count: usize } ErrorKind::TooMany, *what,
        "{count} {what} requested: more than there is memory to hold";

    Unfinished { what: Subject, steps: usize, reached: f64, duration: f64, why: &'static str }
        ErrorKind::TooMany, *what,
        "{what} came to {reached:e} s of {duration:e} s in {steps} steps: {why}";

    NotConverged { what: Subject, iterations: usize, residual: f64 } ErrorKind::NotConverged, *what,
        "{what} was not found in {iterations} rounds: the last still moved by {}, more than rounding",
        Margin(*residual);

    /// `shortest`: the last length of a step, s; NaN where the rates are beyond the numbers.
    NoStep { tried: usize, reached: f64, shortest: f64 } ErrorKind::NotConverged, Subject::StepLength,
        "after {tried} steps, taken or rejected, no step at {reached:e} s meets the tolerance{}",
        Shortest(*shortest);

    Part { index: usize, source: Box<Error> } source.kind(), source.subject(),
        "part {index}: {source}";

    /// `printed`: the difference is small enough to come from digits that were rounded.
    Asymmetric { row: usize, column: usize, value: f64, mirrored: f64, tolerance: f64, printed: bool }
        ErrorKind::Impossible, Subject::Tensor,
        "the tensor is not symmetric: entry ({row}, {column}) is {value:?}, entry ({column}, {row}) is \
         {mirrored:?}; they differ by {}, more than rounding ({}){}",
        Margin((value - mirrored).abs()), Margin(*tolerance), hint(*printed);

    /// A moment of inertia below zero by more than rounding. `printed` as in `Asymmetric`.
    NegativeMoment { what: Subject, value: f64, printed: bool } ErrorKind::Impossible, *what,
        "{what} is {value:?}: it must not be below zero{}", hint(*printed);

    /// Moments smallest first. `printed` as in `Asymmetric`.
    TriangleInequality { moments: [f64; 3], excess: f64, tolerance: f64, printed: bool }
        ErrorKind::Impossible, Subject::PrincipalMoments,
        // The two smaller in either order name one rule; the larger of them first reads best.
        "no body has principal moments {0}, {1}, {2}: the triangle inequality {1} + {0} >= {2} fails by \
         {excess:?}, more than rounding ({3}){4}",
        moments[0], moments[1], moments[2], Margin(*tolerance), hint(*printed);

    /// The nearest possible tensor or moments lie farther away than the stated tolerance, both relative to
    /// the largest moment.
    TooFar { moved: f64, tolerance: f64 } ErrorKind::Impossible, Subject::Tensor,
        "no body has this tensor: the nearest one that a body has is {} of the largest moment away, more than \
         the tolerance of {tolerance:e}", Margin(*moved);

    Singular { smallest: f64, largest: f64 } ErrorKind::NotInvertible, Subject::SmallestMoment,
        "the smallest principal moment, {smallest:?}, is zero relative to the largest, {largest:?}: the tensor \
         has no inverse, so momentum does not determine spin";

    BadFace { face: usize, vertices: [usize; 3], count: usize } ErrorKind::BadMesh, Subject::Face,
        "face {face} is ({}, {}, {}): it must name three different vertices below {count}",
        vertices[0], vertices[1], vertices[2];

    RepeatedFace { face: usize, before: usize, vertices: [usize; 3] } ErrorKind::BadMesh, Subject::Face,
        "face {face}, ({}, {}, {}), is face {before} again: each must be listed once",
        vertices[0], vertices[1], vertices[2];

    OpenMesh { edge: [usize; 2], faces: usize } ErrorKind::BadMesh, Subject::MeshEdge,
        "the edge from vertex {} to vertex {} belongs to {faces} face(s): in a closed surface it is 2, or 4 \
         where parts touch", edge[0], edge[1];

    /// The edge's two vertices, in the direction that both faces take.
    FlippedFace { edge: [usize; 2] } ErrorKind::BadMesh, Subject::Face,
        "two faces run from vertex {} to vertex {}: one of them is turned inside out", edge[0], edge[1];

    NoVolume { volume: f64, tolerance: f64 } ErrorKind::BadMesh, Subject::Volume,
        "the volume comes out as {volume:?}, not above zero by more than rounding ({}): the solid is flat, or \
         its faces do not run counter-clockwise seen from outside", Margin(*tolerance);

    /// More shells in one another than can be looked at.
    TooManyShells { shells: usize, most: usize } ErrorKind::TooMany, Subject::Shell,
        "the {shells} shells lie so deep in one another that to tell inside from outside would take more than \
         {most} views of a face";

    /// `winding`: how many times the shells together enclose a point next to this one.
    MisplacedShell { face: usize, volume: f64, winding: f64 } ErrorKind::BadMesh, Subject::Shell,
        "the shell that face {face} belongs to, of volume {volume:?}, is turned or placed wrongly: next to it \
         the shells enclose a point {winding} times, and it must be 0 (outside the solid) or 1 (inside); a \
         shell of negative volume is a cavity and must lie in the solid";
}

impl Refusal {
    /// This refusal where the rule is broken.
    #[inline]
    pub(crate) fn when(self, broken: bool) -> Result<(), Error> {
        if broken { Err(self.into()) } else { Ok(()) }
    }

    pub(super) fn kind(&self) -> ErrorKind {
        self.explained(|kind, _, _| kind)
    }

    pub(super) fn subject(&self) -> Subject {
        self.explained(|_, subject, _| subject)
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.explained(|_, _, sentence| f.write_fmt(sentence))
    }
}

/// Advice where the error may be due to rounded digits.
fn hint(printed: bool) -> &'static str {
    if printed {
        "; if its digits were rounded, `within` takes a tolerance and gives the nearest possible body"
    } else {
        ""
    }
}

/// The end of the sentence about a step that was not found.
struct Shortest(f64);

impl fmt::Display for Shortest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_finite() {
            write!(f, ", down to one of {:e} s", self.0)
        } else {
            f.write_str(": the rates there are beyond what a floating-point number holds")
        }
    }
}
