//! The operations that round; an enclosure replaces them by its own.

use super::functions::{decay, sin_cos_near_zero};
use super::{INTEGERS, Lane, splat};
use core::f64::consts::FRAC_PI_2;

/// The operations of the closed form at which `f64` rounds or a series is truncated. A lane uses the defaults
/// (`impl Rounding for Lanes {}`).
///
/// An enclosure of a real number replaces them. It is a single lane, and answers [`lt`](Lane::lt) and
/// [`sign`](Lane::sign) for the number in its middle; the code must be correct for all its numbers with
/// either answer.
pub trait Rounding: Lane {
    /// [`round_ties_even`](Lane::round_ties_even) of a number below 2^51; zero may have either sign.
    #[inline(always)]
    fn nearest(self) -> Self {
        (self + INTEGERS) - INTEGERS
    }

    /// This nearest integer, and what is left, which is exact.
    #[inline(always)]
    fn whole_and_left(self) -> [Self; 2] {
        let whole = self.nearest();
        [whole, self - whole]
    }

    /// `self - other` where the two agree to four units in the last place: without error.
    #[inline(always)]
    fn less_near(self, other: Self) -> Self {
        self - other
    }

    /// `self + other` in two parts, the second what rounding left off the first: without error.
    #[inline(always)]
    fn sum_in_two(self, other: Self) -> [Self; 2] {
        let high = self + other;
        let part = high - self;
        [high, (self - (high - part)) + (other - part)]
    }

    /// [`sum_in_two`](Self::sum_in_two) where `self` is not the smaller of the two, or is zero.
    #[inline(always)]
    fn quick_sum_in_two(self, other: Self) -> [Self; 2] {
        let high = self + other;
        [high, other - (high - self)]
    }

    /// `self * other` in two parts: without error (but for underflow).
    #[inline(always)]
    fn product_in_two(self, other: Self) -> [Self; 2] {
        let high = self * other;
        [high, self.two_product_error(other, high)]
    }

    /// A number in two parts as the nearest single one and the rest.
    #[inline(always)]
    fn in_one(high: Self, low: Self) -> [Self; 2] {
        [high, low]
    }

    /// The number that a quotient or a root is improved from.
    #[inline(always)]
    fn near(self) -> Self {
        self
    }

    /// Whether it is neither infinite nor NaN.
    #[inline(always)]
    fn finite(self) -> Self::Mask {
        self.abs().lt(splat(f64::INFINITY))
    }

    /// A number that only rounding can bring below zero.
    #[inline(always)]
    fn not_below_zero(self) -> Self {
        let zero = splat::<Self>(0.0);
        Self::select(zero.lt(self), self, zero)
    }

    /// Sine and cosine of this part of a quarter turn, a half at most (or a hair more).
    #[inline(always)]
    fn sin_cos_of_quarter(self) -> (Self, Self) {
        // Half the circle's constant is larger by less than that.
        sin_cos_near_zero((self * FRAC_PI_2).up_to(|| self * 6.13e-17))
    }

    /// Sine and cosine of an angle of this whole number of quarter turns and a rest, from those of the rest.
    #[inline(always)]
    fn after_quarters(self, sin: Self, cos: Self) -> (Self, Self) {
        // The last bits of a number that large count the quarters: odd ones exchange the two, and each has
        // its half of the circle below zero.
        let turned = |k: usize, more: u64, this: &Self, other: &Self| {
            let quarters = (self.lane(k) + INTEGERS).to_bits();
            let (this, other) = (this.lane(k).to_bits(), other.lane(k).to_bits());
            let exchanged = this ^ (this ^ other) & (quarters & 1).wrapping_neg();
            f64::from_bits(exchanged ^ (quarters + more) >> 1 << 63)
        };
        (Self::from_lanes(|k| turned(k, 0, &sin, &cos)), Self::from_lanes(|k| turned(k, 1, &cos, &sin)))
    }

    /// `exp(-x)` and `exp(-x) - 1` of `x = self + rest >= 0`.
    #[inline(always)]
    fn decay(self, rest: Self) -> [Self; 2] {
        decay(self, rest)
    }
}
