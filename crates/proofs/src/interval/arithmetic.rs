//! Sums, products and quotients, each end rounded outward.
//!
//! A float operation rounds to nearest. Its error, which is itself a float (two-sum; a fused product) unless
//! something underflows, shows on which side the exact result lies. Where this is not certain, the next float
//! on either side is used.

use super::{Interval, whole};
use crate::field;

/// Between these sizes the error of a product is a float.
pub(super) fn safe(x: f64) -> bool {
    (1e-250..1e250).contains(&x.abs())
}

/// A float not above the exact result, which is `rounded` plus something with the sign of `error`.
fn below(rounded: f64, error: f64, known: bool) -> f64 {
    if rounded.is_nan() {
        f64::NEG_INFINITY
    } else if known && error >= 0.0 {
        rounded
    } else {
        rounded.next_down()
    }
}

fn above(rounded: f64, error: f64, known: bool) -> f64 {
    -below(-rounded, -error, known)
}

/// Sum and error, and whether the error is known.
fn sum(a: f64, b: f64) -> (f64, f64, bool) {
    let s = a + b;
    let part = s - a;
    (s, (a - (s - part)) + (b - part), s.is_finite())
}

pub(super) fn product(a: f64, b: f64) -> (f64, f64, bool) {
    if a == 0.0 || b == 0.0 {
        return (0.0, 0.0, true);
    }
    let p = a * b;
    (p, a.mul_add(b, -p), safe(p))
}

fn quotient(a: f64, b: f64) -> (f64, f64, bool) {
    if a == 0.0 {
        return (0.0, 0.0, true);
    }
    let q = a / b;
    let left = (-q).mul_add(b, a);
    (q, if b < 0.0 { -left } else { left }, safe(q) && safe(a) && safe(b))
}

/// The root of a number that is not negative, rounded outward.
pub(super) fn root(x: f64) -> (f64, f64) {
    let r = x.sqrt();
    let known = x == 0.0 || (safe(x) && safe(r));
    let error = (-r).mul_add(r, x);
    (below(r, error, known).max(0.0), above(r, error, known))
}

type Rounding = fn(f64, f64) -> (f64, f64, bool);

impl Interval {
    /// From the four results for the ends, of an operation that is monotone in each operand.
    fn corners(self, other: Self, operation: Rounding) -> Self {
        if Self::none([self, other]) {
            return Self::NONE;
        }
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for a in [self.low, self.high] {
            for b in [other.low, other.high] {
                let (rounded, error, known) = operation(a, b);
                if rounded.is_nan() {
                    return Self::ALL;
                }
                low = low.min(below(rounded, error, known));
                high = high.max(above(rounded, error, known));
            }
        }
        Self { low, high }
    }

    /// Its product with itself, which is not negative.
    #[must_use]
    pub fn square(self) -> Self {
        let size = self.abs();
        (size * size).not_negative()
    }

    fn plus(self, other: Self) -> Self {
        let (low, e, known) = sum(self.low, other.low);
        let (high, f, sure) = sum(self.high, other.high);
        if low.is_nan() || high.is_nan() {
            return Self::NONE;
        }
        Self { low: below(low, e, known), high: above(high, f, sure) }
    }
    fn minus(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
    fn times(self, other: Self) -> Self {
        self.corners(other, product)
    }
    /// All numbers where the divisor may be zero.
    fn over(self, other: Self) -> Self {
        if other.has_zero() && !self.low.is_nan() { Self::ALL } else { self.corners(other, quotient) }
    }
    fn zero_for_certain(&self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }
}

// Not with floats, which convert into no interval.
field!(Interval, whole);
