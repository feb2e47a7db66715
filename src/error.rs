//! What can be wrong with what you give the library, one kind each.

use alloc::boxed::Box;
use core::fmt;

/// Why a value was refused: what it was, the rule it broke, and by how much.
///
/// ```
/// use tumbling::{Error, Inertia};
/// let error = Inertia::from_moments(1.11, 100.11, 1.01).unwrap_err();
/// assert!(matches!(error, Error::TriangleInequality { .. }));
/// assert!(error.to_string().contains("1.11 + 1.01 >= 100.11 fails by 97.99"), "{error}");
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A value is NaN or infinite.
    NotFinite {
        /// What the value stands for.
        what: &'static str,
        /// The value.
        value: f64,
    },
    /// A mass, size or moment that must be above zero is not.
    NotPositive {
        /// What the value stands for.
        what: &'static str,
        /// The value.
        value: f64,
    },
    /// A value that may be zero is below it, by more than rounding where it was computed.
    Negative {
        /// What the value stands for.
        what: &'static str,
        /// The value.
        value: f64,
    },
    /// A finite input gives a result that a finite nonzero `f64` cannot hold with all its digits.
    OutOfRange {
        /// What the result stands for.
        what: &'static str,
        /// What came out instead (an infinity, zero, a subnormal number, or NaN from infinities).
        value: f64,
    },
    /// A value reaches a limit that it must stay below.
    NotBelow {
        /// What the value stands for.
        what: &'static str,
        /// The value.
        value: f64,
        /// The limit.
        limit: f64,
    },
    /// Two sizes are in the wrong order, such as an inner radius beyond the outer.
    Order {
        /// What must not be larger.
        smaller: &'static str,
        /// Its value.
        small: f64,
        /// What must not be smaller.
        larger: &'static str,
        /// Its value.
        large: f64,
    },
    /// Two entries of a tensor that mirror each other differ by more than rounding.
    Asymmetric {
        /// Row of the entry, from 0.
        row: usize,
        /// Column of the entry, from 0.
        column: usize,
        /// The entry.
        value: f64,
        /// Its mirror image.
        mirrored: f64,
        /// What difference would pass: a few units in the last place of the largest entry.
        tolerance: f64,
    },
    /// The largest moment exceeds the sum of the other two: no distribution of mass does that.
    TriangleInequality {
        /// The principal moments, smallest first.
        moments: [f64; 3],
        /// By how much the largest exceeds the sum of the others.
        excess: f64,
        /// What excess would pass: a few units in the last place of the largest moment.
        tolerance: f64,
    },
    /// The smallest principal moment is zero to rounding: momentum does not determine spin.
    Singular {
        /// The smallest principal moment.
        smallest: f64,
        /// The largest.
        largest: f64,
    },
    /// A direction was asked for, and the vector given has no length.
    ZeroVector {
        /// What the vector stands for.
        what: &'static str,
    },
    /// A quaternion meant as an attitude is not of length 1.
    NotUnit {
        /// Its length.
        norm: f64,
        /// How far from 1 would pass.
        tolerance: f64,
    },
    /// A list that must have members has too few.
    TooFew {
        /// What is listed.
        what: &'static str,
        /// How many there are.
        count: usize,
        /// How many there must be.
        needed: usize,
    },
    /// More of something was asked for than there is memory to hold.
    TooMany {
        /// What was asked for.
        what: &'static str,
        /// How many.
        count: usize,
    },
    /// An iteration did not come to rest.
    NotConverged {
        /// What was sought.
        what: &'static str,
        /// How many rounds it was given.
        iterations: usize,
        /// How far it still moved in the last.
        residual: f64,
    },
    /// A face of a mesh names a vertex that is not there, or one vertex twice.
    BadFace {
        /// Which face, from 0.
        face: usize,
        /// Its vertices.
        vertices: [usize; 3],
        /// How many vertices the mesh has.
        count: usize,
    },
    /// The edge of a mesh belongs to an odd number of faces: there is a hole or a fin.
    OpenMesh {
        /// The edge's two vertices.
        edge: [usize; 2],
        /// How many faces have it.
        faces: usize,
    },
    /// Two faces run along an edge the same way: one of them is turned inside out.
    FlippedFace {
        /// The edge's two vertices, in the direction that both faces take.
        edge: [usize; 2],
    },
    /// The surface is closed but encloses no positive volume: flat to rounding, or inside out.
    NoVolume {
        /// The enclosed volume, by the divergence theorem.
        volume: f64,
        /// How much of it may be rounding: it must be above that.
        tolerance: f64,
    },
    /// A principal axis was asked for by a number that none has.
    NoSuchAxis {
        /// The number.
        axis: usize,
    },
    /// Something is wrong with one part of a whole.
    Part {
        /// Which part, from 0.
        index: usize,
        /// What is wrong with it.
        source: Box<Error>,
    },
    /// Something is wrong with one body of a scene.
    OfBody {
        /// Which body, from 0.
        index: usize,
        /// What is wrong with it.
        source: Box<Error>,
    },
    /// Something is wrong with one torque of a scene.
    OfTorque {
        /// Which torque, from 0.
        index: usize,
        /// What is wrong with it.
        source: Box<Error>,
    },
    /// A scene asks for more digits than can be had.
    Unattainable {
        /// The accuracy asked for.
        asked: f64,
        /// The best that can be had, or that was seen where a torque acts.
        attainable: f64,
    },
    /// No two runs of a scene on trial agreed, in all the steps that are tried.
    Disagreement {
        /// The accuracy asked for.
        asked: f64,
        /// How many steps were taken on trial.
        steps: usize,
    },
    /// Something was asked for that this motion does not have.
    Undefined {
        /// What was asked for.
        what: &'static str,
        /// Why there is none.
        why: &'static str,
    },
    /// A face of a mesh is listed twice, running the same way.
    RepeatedFace {
        /// Which face, from 0.
        face: usize,
        /// The one before that is the same.
        before: usize,
        /// Its vertices.
        vertices: [usize; 3],
    },
    /// A closed shell of a mesh is inside out, or a solid one lies in a solid, or a cavity lies outside.
    MisplacedShell {
        /// The shell's first face, from 0.
        face: usize,
        /// The volume it encloses: negative for a cavity.
        volume: f64,
        /// How many times over all shells together enclose a place beside it: it must be 0 or 1.
        winding: f64,
    },
}

impl fmt::Display for Error {
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
                write!(f, "{smaller} is {small:?}, larger than {larger}, {large:?}: it must not be")
            }
            Self::NotBelow { what, value, limit } => {
                write!(f, "{what} is {value:?}: it must be below {limit}")
            }
            Self::Asymmetric { row, column, value, mirrored, tolerance } => write!(
                f,
                "the tensor is not symmetric: entry ({row}, {column}) is {value:?}, entry ({column}, {row}) is \
                 {mirrored:?}; they differ by {:.3e}, more than rounding ({tolerance:.1e})",
                (value - mirrored).abs()
            ),
            Self::TriangleInequality { moments: [a, b, c], excess, tolerance } => {
                // The two smaller in either order name the same rule; the larger of them first reads best.
                write!(
                    f,
                    "no body has principal moments {a}, {b}, {c}: the triangle inequality {b} + {a} >= {c} fails \
                     by {excess}, more than rounding ({tolerance:.1e})"
                )
            }
            Self::Singular { smallest, largest } => write!(
                f,
                "the smallest principal moment, {smallest:?}, is zero beside the largest, {largest:?}: the tensor \
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
                write!(f, "{count} {what} asked for: more than there is memory to hold")
            }
            Self::NotConverged { what, iterations, residual } => write!(
                f,
                "{what} was not found in {iterations} rounds: the last still moved by {residual:.3e}, more than rounding"
            ),
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
            Self::OfBody { index, source } => write!(f, "body {index}: {source}"),
            Self::OfTorque { index, source } => write!(f, "torque {index}: {source}"),
            Self::Unattainable { asked, attainable } => write!(
                f,
                "an accuracy of {asked:e} is asked for, {:.1e} times finer than what can be had: {attainable:.1e}",
                attainable / asked
            ),
            Self::Disagreement { asked, steps } => write!(
                f,
                "an accuracy of {asked:e} is asked for, but in {steps} steps on trial no two runs agreed to any digit"
            ),
            Self::Undefined { what, why } => write!(f, "{what} is asked for, but {why}"),
            Self::RepeatedFace { face, before, vertices: [a, b, c] } => {
                write!(f, "face {face}, ({a}, {b}, {c}), is face {before} again: each must be listed once")
            }
            Self::MisplacedShell { face, volume, winding } => write!(
                f,
                "the shell that face {face} belongs to, of volume {volume:?}, is turned or placed wrongly: beside it \
                 the shells enclose a point {winding} times, and it must be 0 (outside the solid) or 1 (inside); a \
                 shell of negative volume is a cavity and must lie in the solid"
            ),
        }
    }
}

impl core::error::Error for Error {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Part { source, .. } | Self::OfBody { source, .. } | Self::OfTorque { source, .. } => {
                Some(source.as_ref())
            }
            _ => None,
        }
    }
}

/// `value` if it is finite.
pub(crate) fn finite(what: &'static str, value: f64) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(Error::NotFinite { what, value }) }
}

/// `value` if it is finite and above zero.
pub(crate) fn positive(what: &'static str, value: f64) -> Result<f64, Error> {
    if finite(what, value)? > 0.0 { Ok(value) } else { Err(Error::NotPositive { what, value }) }
}

/// `value` if it is finite and not below zero.
pub(crate) fn not_negative(what: &'static str, value: f64) -> Result<f64, Error> {
    if finite(what, value)? >= 0.0 { Ok(value) } else { Err(Error::Negative { what, value }) }
}

/// `vector` if its three components are finite.
pub(crate) fn finite_vector(what: &'static str, vector: &nalgebra::Vector3<f64>) -> Result<(), Error> {
    vector.iter().try_for_each(|&x| finite(what, x).map(drop))
}
