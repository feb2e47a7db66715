//! How certain a number is, shown by the type with which it is computed.
//!
//! An assertion about [`exactly`] is about exact fractions or whole numbers, computed without rounding; an
//! assertion about [`enclosed`] is about real numbers. Neither shows that the computation is the one that a
//! text describes. Both return their argument. They exist so that the compiler refuses a float, and so that a
//! reader, or the book's guard, sees on what an assertion rests.
//!
//! ```
//! use tumbling_proofs::{Interval, Rational, enclosed, exactly, given};
//! let third = given!(Rational: 1) / given!(Rational: 3);
//! assert_eq!(format!("{:.3} kg", exactly(third)), "0.333 kg");
//! assert_eq!(format!("{:.3} rad", enclosed(given!(Interval: 3).sqrt())), "1.732 rad");
//! ```
//!
//! ```compile_fail
//! let computed = 3_f64.sqrt();
//! tumbling_proofs::exactly(computed);
//! ```

use crate::counted::Cost;
use crate::{Fraction, Interval, Rational};

mod sealed {
    pub trait Sealed {}
}

/// Numbers that no operation rounds.
pub trait Exact: sealed::Sealed {}

macro_rules! exact {
    ($($T:ty),*) => {$(
        impl sealed::Sealed for $T {}
        impl Exact for $T {}
    )*};
}
exact!(Rational, Fraction, Cost);

/// Returns an exact number unchanged.
pub fn exactly<T: Exact>(number: T) -> T {
    number
}

/// Returns an interval unchanged.
#[must_use]
pub fn enclosed(number: Interval) -> Interval {
    number
}

/// A number exactly as it is written: `given!(0.1)` is one tenth, which no float is. Its type follows from
/// the context, or is named: `given!(Interval: 0.1)`.
///
/// ```
/// use tumbling_proofs::{Interval, Rational, given};
/// assert_eq!(given!(Rational: 0.129), Rational::new(129, 1000));
/// assert!(given!(Interval: 0.1).contains(&Rational::new(1, 10)));
/// assert!(!given!(Interval: 0.1).contains(&Rational::of_f64(0.1)) || given!(Interval: 0.1).width() > 0.0);
/// ```
#[macro_export]
macro_rules! given {
    ($number:literal) => {
        ::core::convert::From::from($crate::Rational::of_literal(::core::stringify!($number)))
    };
    ($T:ty: $number:literal) => {
        <$T as ::core::convert::From<$crate::Rational>>::from($crate::Rational::of_literal(
            ::core::stringify!($number),
        ))
    };
}
