//! Double-double numbers: an `f64` and its rounding error, about 106 bits together.
//!
//! For the few places where the answer is a small difference of large terms: the angle between spin
//! and momentum near a principal axis, the inverse of a needle's tensor, the phase after a billion flips.
//! The error-free sum and product are Knuth's and Dekker's, see [Dek71](crate::references).

use crate::number::{Gather, Real, Rounding, gather_fields, splat};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The unevaluated sum `hi + lo`, with `|lo|` at most half a unit in the last place of `hi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DoubleDouble<T = f64> {
    hi: T,
    lo: T,
}

gather_fields!(DoubleDouble { hi, lo });

impl DoubleDouble {
    pub(crate) const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    pub(crate) const ONE: Self = Self { hi: 1.0, lo: 0.0 };
    /// The circle's constant to 107 bits.
    pub(crate) const PI: Self = Self { hi: core::f64::consts::PI, lo: 1.224_646_799_147_353_2e-16 };
}

impl<T: Real> DoubleDouble<T> {
    /// The circle's constant.
    pub(crate) fn pi() -> Self {
        let [hi, lo] = T::pi_in_two();
        Self { hi, lo }
    }

    /// The square root of a number that is not negative, to about 104 bits.
    pub(crate) fn sqrt(self) -> Self {
        let root = self.hi.sqrt().near();
        if root == T::zero() || !root.finite() {
            return Self::from(self.hi().sqrt());
        }
        let rest = self.less_near(Self::product(root, root)) / (root + self.hi().sqrt());
        quick_two_sum(root, rest)
    }

    /// `self * 2^exponent`.
    pub(crate) fn scaled(self, exponent: i32) -> Self {
        Self { hi: self.hi.times_power_of_two(exponent), lo: self.lo.times_power_of_two(exponent) }
    }

    /// Without its sign, which must be known.
    pub(crate) fn abs(self) -> Self {
        if self.hi.lt(splat(0.0)) { -self } else { self }
    }
}

impl<T: Rounding> DoubleDouble<T> {
    /// The sum of a number and of one that is at most half a unit in its last place.
    pub(crate) fn new(hi: T, lo: T) -> Self {
        Self { hi, lo }
    }

    /// The nearest single number.
    #[inline(always)]
    pub(crate) fn hi(self) -> T {
        T::in_one(self.hi, self.lo)[0]
    }

    /// What the nearest single number leaves out.
    #[inline(always)]
    pub(crate) fn lo(self) -> T {
        T::in_one(self.hi, self.lo)[1]
    }

    /// `a + b` without error.
    #[inline(always)]
    pub(crate) fn sum(a: T, b: T) -> Self {
        let [hi, lo] = a.sum_in_two(b);
        Self { hi, lo }
    }

    /// `a b` without error (but for underflow).
    #[inline(always)]
    pub(crate) fn product(a: T, b: T) -> Self {
        let [hi, lo] = a.product_in_two(b);
        Self { hi, lo }
    }

    /// `self - other` in one number, where the two agree to some units in the last place, so that the
    /// difference of the high parts is exact.
    fn less_near(self, other: Self) -> T {
        self.hi.less_near(other.hi) + (self.lo - other.lo)
    }

    /// The sum to all the digits of the larger part and a little less than twice that of the rest: half the
    /// work.
    #[inline(always)]
    pub(crate) fn plus(self, other: Self) -> Self {
        let sum = DoubleDouble::sum(self.hi, other.hi);
        Self { hi: sum.hi, lo: sum.lo + (self.lo + other.lo) }
    }

    /// The number as a truncated sum whose omitted terms amount to at most `rest`.
    pub(crate) fn up_to(self, rest: impl FnOnce() -> T) -> Self {
        Self { lo: self.lo.up_to(rest), ..self }
    }

    /// `self * other` as one part of a sum, or for [`whole_and_rest`](Self::whole_and_rest): its low part may
    /// be more than half a unit in the last place of the high one.
    #[inline(always)]
    pub(crate) fn times_loosely(self, other: T) -> Self {
        let [hi, lo] = self.hi.product_in_two(other);
        Self { hi, lo: lo + self.lo * other }
    }

    /// Times 1, -1 or a power of two, which rounds nothing.
    #[inline(always)]
    pub(crate) fn times_exact(self, factor: T) -> Self {
        Self { hi: self.hi * factor, lo: self.lo * factor }
    }

    /// The nearest integer, which beyond 2^53 may take both parts; one below 2^50 that differs from it by a
    /// multiple of four; and what is left: at most a half.
    ///
    /// For a number too large to have a fraction, or not finite, the remainder is zero.
    #[inline(always)]
    pub(crate) fn whole_and_rest(self) -> (Self, T, Self) {
        // NaN too is not within.
        let beyond = T::select(self.hi.abs().lt(splat(LARGE)), T::zero(), T::one());
        if T::any(T::zero().lt(beyond)) {
            // Taken apart: what is passed on whole would be kept in memory in all cases.
            let (Self { hi: a, lo: b }, c, Self { hi, lo }) = far_whole_and_rest(self.hi, self.lo);
            return (Self { hi: a, lo: b }, c, Self { hi, lo });
        }
        let [whole, near] = self.hi.whole_and_left();
        // The low part can carry it just past the half.
        let rest = quick_two_sum(near, self.lo);
        let [more, left] = rest.hi.whole_and_left();
        let whole = whole + more;
        (Self::from(whole), whole, Self { hi: left, lo: rest.lo })
    }

    /// [`whole_and_rest`](Self::whole_and_rest) with what is left in one number that has all its digits.
    #[inline(always)]
    pub(crate) fn split(self) -> (T, T) {
        let (whole, _, rest) = self.whole_and_rest();
        (whole.hi, rest.hi())
    }
}

#[cold]
#[inline(never)]
fn far_whole_and_rest<T: Rounding>(high: T, low: T) -> (DoubleDouble<T>, T, DoubleDouble<T>) {
    let whole = high.round_ties_even();
    let rest = quick_two_sum(high - whole, low);
    let more = rest.hi.round_ties_even();
    let (left, zero) = (rest.hi - more, splat::<T>(0.0));
    let finite = left.finite();
    let [whole, more] = [whole, more].map(|x| T::select(finite, x, zero));
    let below_four = |x: T| x - (x * 0.25).round_ties_even() * 4.0;
    let rest = DoubleDouble { hi: T::select(finite, left, zero), lo: T::select(finite, rest.lo, zero) };
    (DoubleDouble::sum(whole, more), below_four(whole) + below_four(more), rest)
}

/// 2^49: twice a number below it is one for [`Rounding::nearest`].
const LARGE: f64 = 562_949_953_421_312.0;

impl<T: Rounding> From<T> for DoubleDouble<T> {
    fn from(hi: T) -> Self {
        Self { hi, lo: T::zero() }
    }
}

/// `a + b` without error, where `|a| >= |b|` or `a` is zero.
#[inline(always)]
fn quick_two_sum<T: Rounding>(a: T, b: T) -> DoubleDouble<T> {
    let [hi, lo] = a.quick_sum_in_two(b);
    DoubleDouble { hi, lo }
}

impl<T: Rounding> Add for DoubleDouble<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let high = DoubleDouble::sum(self.hi, other.hi);
        let low = DoubleDouble::sum(self.lo, other.lo);
        let sum = quick_two_sum(high.hi, high.lo + low.hi);
        quick_two_sum(sum.hi, sum.lo + low.lo)
    }
}

impl<T: Rounding> Neg for DoubleDouble<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl<T: Rounding> Sub for DoubleDouble<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Rounding> Mul for DoubleDouble<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let [hi, lo] = self.hi.product_in_two(other.hi);
        let lo = lo + (self.hi * other.lo + self.lo * other.hi);
        quick_two_sum(hi, lo.up_to(|| self.lo * other.lo))
    }
}

impl<T: Rounding> Mul<T> for DoubleDouble<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: T) -> Self {
        let Self { hi, lo } = self.times_loosely(other);
        quick_two_sum(hi, lo)
    }
}

impl<T: Real> Div for DoubleDouble<T> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = (self.hi / other.hi).near();
        if !first.finite() {
            return Self::from(first);
        }
        quick_two_sum(first, self.less_near(other * first) / other.hi())
    }
}

/// The sum of any terms, exact before it is rounded to twice the precision: an expansion grown term by term
/// [She97](crate::references).
pub(crate) fn exact_sum<const N: usize>(terms: [f64; N]) -> DoubleDouble {
    let mut expansion = [0.0; N];
    for (count, term) in terms.into_iter().enumerate() {
        let mut carried = term;
        // The first free part stores the carry from the others.
        for part in expansion.iter_mut().take(count) {
            let sum = DoubleDouble::sum(*part, carried);
            (*part, carried) = (sum.lo, sum.hi);
        }
        if let Some(free) = expansion.get_mut(count) {
            *free = carried;
        }
    }
    // Parts do not overlap, the largest last.
    expansion.iter().fold(DoubleDouble::ZERO, |sum, &part| sum + DoubleDouble::from(part))
}

/// Every term multiplied by `factor`, without error: two for each.
pub(crate) fn exact_products(terms: impl Iterator<Item = f64>, factor: f64) -> impl Iterator<Item = f64> {
    terms.flat_map(move |term| {
        let product = DoubleDouble::product(term, factor);
        [product.lo, product.hi]
    })
}

/// `a b - c d`: both products exact (but for underflow), their difference in twice the precision.
pub(crate) fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> DoubleDouble {
    DoubleDouble::product(a, b) - DoubleDouble::product(c, d)
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
            let ours = difference_of_products(a as f64, b as f64, c as f64, d as f64).hi();
            let expected = exact as f64;
            prop_assert!((ours - expected).abs() <= f64::EPSILON * expected.abs(), "{ours} {expected}");
        }
    }

    #[test]
    fn an_exact_sum_finds_what_is_left_hundreds_of_bits_down() {
        let tiny = 2_f64.powi(-300);
        let sum = exact_sum([1.0, 1e10, tiny, -1e10, 2_f64.powi(-100), -1.0, -2_f64.powi(-100)]);
        assert_eq!(sum.hi(), tiny);
        assert_eq!(exact_sum([0.1, -0.1]), DoubleDouble::ZERO);
    }

    #[test]
    fn the_low_part_keeps_what_rounding_lost() {
        let tiny = DoubleDouble::from(f64::one()) + DoubleDouble::from(1e-25) - DoubleDouble::from(1.0);
        assert_eq!(tiny.hi(), 1e-25);
    }
}
