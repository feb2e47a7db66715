//! Sums, products and quotients, each end rounded outward.
//!
//! A float operation rounds to nearest. Its error, which is itself a float (two-sum; a fused product) unless
//! something underflows, shows on which side the exact result lies. Where this is not certain, the next float
//! on either side is used.

use super::Interval;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

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
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (low, e, known) = sum(self.low, other.low);
        let (high, f, sure) = sum(self.high, other.high);
        if low.is_nan() || high.is_nan() {
            return Self::NONE;
        }
        Self { low: below(low, e, known), high: above(high, f, sure) }
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.corners(other, product)
    }
}

/// All numbers where the divisor may be zero.
impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.has_zero() && !self.low.is_nan() { Self::ALL } else { self.corners(other, quotient) }
    }
}

macro_rules! assigning {
    ($($Op:ident $op:ident $by:tt),*) => {$(
        impl $Op for Interval {
            fn $op(&mut self, other: Self) {
                *self = *self $by other;
            }
        }
    )*};
}
assigning!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /);

impl Zero for Interval {
    fn zero() -> Self {
        Self { low: 0.0, high: 0.0 }
    }
    /// Whether it is zero for certain.
    fn is_zero(&self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }
}

impl One for Interval {
    fn one() -> Self {
        Self { low: 1.0, high: 1.0 }
    }
}
