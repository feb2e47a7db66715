//! Double-double numbers: an `f64` and what its rounding lost, about 106 bits together.
//!
//! For the few places where the answer is a small difference of large terms: the gap between spin
//! and momentum near a principal axis, the inverse of a needle's tensor.
//! The error-free sum and product are Knuth's and Dekker's, see [Dek71](crate::references) in [`references`](crate::references).

use std::ops::{Add, Mul, Neg, Sub};

/// The unevaluated sum `hi + lo`, with `|lo|` at most half a unit in the last place of `hi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Double {
    hi: f64,
    lo: f64,
}

impl Double {
    /// The nearest `f64`.
    pub(crate) fn value(self) -> f64 {
        self.hi
    }
}

impl From<f64> for Double {
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

/// `a + b` without error.
fn two_sum(a: f64, b: f64) -> Double {
    let hi = a + b;
    let part = hi - a;
    let lo = (a - (hi - part)) + (b - part);
    Double { hi, lo }
}

/// `a + b` without error, where `|a| >= |b|` or `a` is zero.
fn quick_two_sum(a: f64, b: f64) -> Double {
    let hi = a + b;
    Double { hi, lo: b - (hi - a) }
}

impl Add for Double {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = two_sum(self.hi, other.hi);
        let low = two_sum(self.lo, other.lo);
        let sum = quick_two_sum(high.hi, high.lo + low.hi);
        quick_two_sum(sum.hi, sum.lo + low.lo)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let hi = self.hi * other.hi;
        let lo = self.hi.mul_add(other.hi, -hi);
        quick_two_sum(hi, lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

/// `a b - c d` as if computed exactly and rounded once (but for underflow).
pub(crate) fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> Double {
    let product = |x: f64, y: f64| Double::from(x) * Double::from(y);
    product(a, b) - product(c, d)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::One as _;
    use proptest::prelude::*;

    proptest! {
        // Independent: the same expression in 128-bit integers, exact by construction.
        #[test]
        fn a_small_difference_of_large_products_is_right_to_the_last_bit(
            a in -(1_i64 << 52)..(1_i64 << 52), b in -(1_i64 << 52)..(1_i64 << 52),
            da in -3_i64..=3, db in -3_i64..=3,
        ) {
            let (c, d) = (a + da, b + db);
            let exact = i128::from(a) * i128::from(b) - i128::from(c) * i128::from(d);
            #[allow(clippy::cast_precision_loss)]
            let ours = difference_of_products(a as f64, b as f64, c as f64, d as f64).value();
            #[allow(clippy::cast_precision_loss)]
            let expected = exact as f64;
            prop_assert!((ours - expected).abs() <= f64::EPSILON * expected.abs(), "{ours} {expected}");
        }
    }

    #[test]
    fn the_low_part_keeps_what_rounding_lost() {
        let tiny = Double::from(f64::one()) + Double::from(1e-25) - Double::from(1.0);
        assert_eq!(tiny.value(), 1e-25);
    }
}
