//! Intervals with float ends, rounded outward: their results about real numbers are theorems.
//!
//! An [`Interval`] stands for one real number in it. The result of every operation contains the exact result
//! for any numbers in the operands. So the library's generic laws, run on intervals, enclose their results in
//! exact arithmetic. Square roots, sines and elliptic functions are enclosed by series with a bound on the
//! remainder.
//!
//! A float does not convert into an interval. A number enters as a literal ([`given!`](crate::given)) or as
//! an exact fraction, and a float becomes a fraction only by an explicit `of_f64`. Printed to some digits, an
//! interval shows the digits of the number if they are certain, and otherwise its two ends.
//!
//! ```
//! use tumbling_proofs::{Interval, given};
//! let root = given!(Interval: 2).sqrt();
//! assert_eq!(format!("{root:.10}"), "1.4142135624");
//! let coarse = given!(Interval: 0.14).hull(given!(0.16));
//! assert_eq!(format!("{coarse:.1}"), "[0.1, 0.2]");
//! ```

mod arithmetic;
pub mod elliptic;
pub mod forward;
pub mod frozen;
mod functions;
pub mod geometry;
pub mod motion;
pub(crate) mod paths;
mod real;
pub(crate) mod rounded;

use crate::Rational;
use std::cmp::Ordering;
use std::fmt;

/// A closed interval of real numbers, see [`interval`](self). If nothing is known, it contains all of them.
#[derive(Debug, Clone, Copy)]
pub struct Interval {
    low: f64,
    high: f64,
}

impl Interval {
    /// All real numbers: the quotient by an interval that contains zero.
    pub const ALL: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// No number: the result of contradictory bounds, and of every computation from it. It prints no digits,
    /// and it is neither equal to any number nor ordered relative to one.
    const NONE: Self = Self { low: f64::NAN, high: f64::NAN };

    /// The ratio of a circle to its diameter, between two neighbouring floats.
    ///
    /// ```
    /// use tumbling_proofs::Interval;
    /// // Machin: pi/4 = 4 arctan(1/5) - arctan(1/239).
    /// use tumbling_proofs::given;
    /// let [a, b]: [Interval; 2] = [given!(0.2), Interval::from(tumbling_proofs::Rational::new(1, 239))];
    /// let four = given!(Interval: 4);
    /// assert!((four * (four * a.atan() - b.atan()) - Interval::PI).has_zero());
    /// ```
    pub const PI: Self = Self { low: std::f64::consts::PI, high: std::f64::consts::PI.next_up() };

    /// The lower end.
    #[must_use]
    pub const fn low(self) -> f64 {
        self.low
    }

    /// The upper end.
    #[must_use]
    pub const fn high(self) -> f64 {
        self.high
    }

    /// The difference of the ends.
    #[must_use]
    pub fn width(self) -> f64 {
        self.high - self.low
    }

    /// Whether one of these has contradictory bounds.
    fn none(of: [Self; 2]) -> bool {
        of.iter().any(|x| x.low.is_nan())
    }

    /// Whether zero lies in it.
    #[must_use]
    pub fn has_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    /// Whether this exact number lies in it.
    #[must_use]
    pub fn contains(self, number: &Rational) -> bool {
        let above = self.low == f64::NEG_INFINITY || Rational::of_f64(self.low) <= *number;
        above && (self.high == f64::INFINITY || Rational::of_f64(self.high) >= *number)
    }

    /// The smallest interval that contains both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        if Self::none([self, other]) {
            return Self::NONE;
        }
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The smaller of the two numbers.
    pub fn min_of(self, other: Self) -> Self {
        if Self::none([self, other]) {
            return Self::NONE;
        }
        Self { low: self.low.min(other.low), high: self.high.min(other.high) }
    }

    /// The part between these bounds, of a number that is known to be there; no number if that contradicts
    /// what is known of it.
    pub fn clamped(self, low: f64, high: f64) -> Self {
        if self.low.is_nan() || self.high < low || self.low > high {
            return Self::NONE;
        }
        Self { low: self.low.max(low), high: self.high.min(high) }
    }

    /// The part that is not negative, of a number that is known not to be.
    #[must_use]
    pub fn not_negative(self) -> Self {
        self.clamped(0.0, f64::INFINITY)
    }

    /// Without its sign.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.low >= 0.0 || self.low.is_nan() {
            self
        } else if self.high <= 0.0 {
            -self
        } else {
            Self { low: 0.0, high: self.high.max(-self.low) }
        }
    }

    /// The float in it, if it contains only one number.
    fn point(self) -> Option<f64> {
        (self.low == self.high).then_some(self.low)
    }
}

/// The exact fraction if a float has its value, and otherwise the two floats around it.
impl From<Rational> for Interval {
    fn from(number: Rational) -> Self {
        let near = number.to_f64();
        if !near.is_finite() {
            return Self::ALL;
        }
        let (mut low, mut high) = (near, near);
        while low > f64::NEG_INFINITY && Rational::of_f64(low) > number {
            low = low.next_down();
        }
        while high < f64::INFINITY && Rational::of_f64(high) < number {
            high = high.next_up();
        }
        Self { low, high }
    }
}

/// Whether equality is certain: two intervals are equal if both contain only one number, and the same.
impl PartialEq for Interval {
    fn eq(&self, other: &Self) -> bool {
        self.point().is_some() && self.point() == other.point()
    }
}

/// The order of any two numbers in them, if it is certain; `None` where they overlap.
impl PartialOrd for Interval {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if self.high < other.low {
            Some(Ordering::Less)
        } else if self.low > other.high {
            Some(Ordering::Greater)
        } else {
            (self == other).then_some(Ordering::Equal)
        }
    }
}

/// A number that a float holds.
fn whole(number: impl Into<f64>) -> Interval {
    let number = number.into();
    Interval { low: number, high: number }
}

/// The digits to which all numbers in it round, or the two ends.
fn certain(f: &mut fmt::Formatter<'_>, low: &str, high: &str) -> fmt::Result {
    // Zero has no sign, from whichever side it is rounded.
    let plain = |end: &str| {
        let zero = end.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
        end.trim_start_matches(|c| zero && c == '-').to_owned()
    };
    let (low, high) = (plain(low), plain(high));
    if low == high { f.write_str(&low) } else { write!(f, "[{low}, {high}]") }
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let print = |end: f64| match f.precision() {
            Some(digits) => format!("{end:.digits$}"),
            None => end.to_string(),
        };
        certain(f, &print(self.low), &print(self.high))
    }
}

impl fmt::LowerExp for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let print = |end: f64| match f.precision() {
            Some(digits) => format!("{end:.digits$e}"),
            None => format!("{end:e}"),
        };
        certain(f, &print(self.low), &print(self.high))
    }
}
