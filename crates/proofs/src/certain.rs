//! How certain a number is, seen by the type that it is computed with.
//!
//! What is asserted of [`exactly`] is a statement about exact fractions or whole numbers, computed without
//! rounding; what is asserted of [`enclosed`], about real numbers. That the computation is the one that a
//! text speaks of, neither shows. Both give back what they are given: they are there so that the compiler
//! refuses a float, and so that a reader, the book's guard too, sees on what an assertion rests.
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

/// An exact number, as it is.
pub fn exactly<T: Exact>(number: T) -> T {
    number
}

/// An interval, as it is.
#[must_use]
pub fn enclosed(number: Interval) -> Interval {
    number
}

/// A number that is given, exactly as it is written: `given!(0.1)` is one tenth, which no float is. Of the
/// type that its place asks for, or of one that is named: `given!(Interval: 0.1)`.
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
