//! Why a value was refused.

mod refusal;
mod subject;

pub(crate) use refusal::Refusal;
pub use subject::Subject;

use alloc::boxed::Box;
use core::fmt;

/// Why a value was refused. The message names the value, the rule that it breaks, and by how much; programs
/// can match on the [kind](Self::kind).
///
/// ```
/// use tumbling::{ErrorKind, Inertia};
/// let error = Inertia::from_moments(1.11, 100.11, 1.01).unwrap_err();
/// assert_eq!(error.kind(), ErrorKind::Impossible);
/// assert!(error.to_string().contains("1.11 + 1.01 >= 100.11 fails by 97.99"), "{error}");
/// // So does what `main` and `unwrap` print.
/// assert_eq!(format!("{error:?}"), error.to_string());
/// ```
#[derive(Clone, PartialEq)]
pub struct Error {
    refusal: Refusal,
}

/// The kinds of [`Error`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ErrorKind {
    /// A value given is NaN or infinite.
    NotFinite,
    /// A given value violates a bound on its sign, size, order, length or count.
    OutOfBounds,
    /// No distribution of mass has this tensor or these moments.
    Impossible,
    /// A principal moment is zero to rounding: momentum does not determine spin.
    NotInvertible,
    /// A finite, nonzero number of the type cannot hold the result with all its digits.
    Unrepresentable,
    /// The input does not determine the result: for example, the direction of a vector of length zero.
    Undefined,
    /// An iteration did not converge.
    NotConverged,
    /// The result needs more memory than there is, or more steps than are allowed.
    TooMany,
    /// The faces of a mesh do not bound a solid.
    BadMesh,
}

/// A margin to three digits, without zeros at their end: `0.5`, `7e-6`.
struct Margin(f64);

impl fmt::Display for Margin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rounded = alloc::format!("{:.2e}", self.0).parse().unwrap_or(self.0);
        let plain = (1e-3..1e3).contains(&self.0.abs()) || self.0 == 0.0;
        if plain { write!(f, "{rounded}") } else { write!(f, "{rounded:e}") }
    }
}

impl Error {
    /// The kind of the error. For an error in a part of a whole, it is the kind of error in that part.
    #[must_use]
    pub fn kind(&self) -> ErrorKind {
        self.refusal.kind()
    }

    /// The quantity that was refused. For an error in a part of a whole, it is the quantity of that part.
    #[must_use]
    pub fn subject(&self) -> Subject {
        self.refusal.subject()
    }

    /// As the error of part `index` (from 0) of a whole.
    pub(crate) fn of_part(self, index: usize) -> Self {
        Refusal::Part { index, source: Box::new(self) }.into()
    }
}

impl From<Refusal> for Error {
    fn from(refusal: Refusal) -> Self {
        Self { refusal }
    }
}

/// Includes the message, since `main` and `unwrap` print this form.
impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.refusal.fmt(f)
    }
}

impl core::error::Error for Error {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match &self.refusal {
            Refusal::Part { source, .. } => Some(source.as_ref()),
            _ => None,
        }
    }
}

/// `value` if it is finite.
pub(crate) fn finite(what: Subject, value: f64) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(Refusal::NotFinite { what, value }.into()) }
}

/// `value` if it is finite and above zero.
pub(crate) fn positive(what: Subject, value: f64) -> Result<f64, Error> {
    if finite(what, value)? > 0.0 { Ok(value) } else { Err(Refusal::NotPositive { what, value }.into()) }
}

/// `value` if it is finite and not below zero.
pub(crate) fn not_negative(what: Subject, value: f64) -> Result<f64, Error> {
    if finite(what, value)? >= 0.0 { Ok(value) } else { Err(Refusal::Negative { what, value }.into()) }
}

/// `vector` if its three components are finite.
pub(crate) fn finite_vector(what: Subject, vector: &nalgebra::Vector3<f64>) -> Result<(), Error> {
    vector.iter().try_for_each(|&x| finite(what, x).map(drop))
}

/// That the numbers of a result are finite.
#[inline]
pub(crate) fn representable(what: Subject, values: &[f64]) -> Result<(), Error> {
    match values.iter().find(|x| !x.is_finite()) {
        Some(&value) => Err(Refusal::OutOfRange { what, value }.into()),
        None => Ok(()),
    }
}
