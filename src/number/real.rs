//! Real numbers: the roots, exponentials and angles from which a motion is prepared.

use super::power_of_two;
use super::{Rounding, functions};
use core::f64::consts::PI;

/// A number from which a motion in closed form can be prepared: an `f64`, or an enclosure of a real number.
///
/// For enclosures, `==`, `<` and other comparisons are true only where they are true for all numbers in them.
pub trait Real: Rounding<Mask = bool> + PartialOrd {
    /// The circle's constant in two parts, to 107 bits.
    fn pi_in_two() -> [Self; 2];

    /// `self * 2^exponent`.
    fn times_power_of_two(self, exponent: i32) -> Self;

    /// The largest exponent of two whose power is at most its size; 0 for zero.
    fn exponent(self) -> i32;

    /// The exponential of a number that is not positive, and the exponential minus 1.
    fn exp_and_exp_m1(self) -> (Self, Self);

    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);

    /// The angle of the point `(x, self)` from the first axis, in radians.
    fn atan2(self, x: Self) -> Self;

    /// The length of the vector `(self, other)`.
    fn hypot(self, other: Self) -> Self;

    /// A number that only rounding can bring beyond 1.
    fn at_most_one(self) -> Self;

    /// Its size with the sign of another; of an enclosure with both signs, with either.
    fn with_sign(self, of: Self) -> Self;

    /// Itself; of an enclosure with both signs all numbers, since what follows holds for one sign only.
    fn of_one_sign(self) -> Self {
        self
    }

    /// What is zero but for rounding: itself if it is small enough for that, otherwise zero.
    fn but_for_rounding(self) -> Self;

    /// Whether it is far enough from zero to have all its digits.
    fn has_all_digits(self) -> bool;
}

impl Real for f64 {
    fn pi_in_two() -> [Self; 2] {
        [PI, 1.224_646_799_147_353_2e-16]
    }
    fn times_power_of_two(self, exponent: i32) -> Self {
        power_of_two::times_power_of_two(self, exponent)
    }
    fn exponent(self) -> i32 {
        power_of_two::exponent(self)
    }
    fn exp_and_exp_m1(self) -> (Self, Self) {
        functions::exp_and_exp_m1(self)
    }
    fn sin_cos(self) -> (Self, Self) {
        functions::sin_cos(self)
    }
    fn atan2(self, x: Self) -> Self {
        functions::atan2(self, x)
    }
    fn hypot(self, other: Self) -> Self {
        functions::hypot(self, other)
    }
    fn at_most_one(self) -> Self {
        self.min(1.0)
    }
    fn with_sign(self, of: Self) -> Self {
        self.copysign(of)
    }
    fn but_for_rounding(self) -> Self {
        if self.abs() < 1e-6 { self } else { 0.0 }
    }
    fn has_all_digits(self) -> bool {
        self.is_normal()
    }
}
