//! The complete integral by the arithmetic-geometric mean [Gau99](crate::references).

use crate::number::{DoubleDouble, Real, splat};

/// The relative difference of two numbers down to which (C45) is iterated: the error of stopping there is of
/// the fourth order.
const NEAR: f64 = 1e-8;

/// `K` in twice the precision, from the complementary modulus and its square root, which must be positive.
///
/// The square root is a separate parameter, because it keeps full precision where the complement is
/// subnormal.
pub(crate) fn quarter_period_from_root<T: Real>(
    complement: DoubleDouble<T>,
    root: DoubleDouble<T>,
) -> DoubleDouble<T> {
    let half = splat::<T>(0.5);
    let (mut a, mut g) = ((DoubleDouble::from(T::one()) + complement).times_exact(half), root);
    // (C45): each step doubles the number of correct digits, after at most ten steps that bring 1e-162 near
    // enough to 1.
    for _ in 0..24 {
        let difference = (a - g).hi();
        let mean = (a + g).times_exact(half);
        if difference.abs() <= a.hi() * NEAR {
            // The next step would subtract this, up to its square.
            let (square, size) = (difference * difference, mean.hi());
            let taken = (square / (size * 16.0)).up_to(|| square * square / (size * size * size));
            return DoubleDouble::pi().times_exact(half) / (mean - DoubleDouble::from(taken));
        }
        g = (a * g).sqrt();
        a = mean;
    }
    // (C8); the mean lies between the two.
    let between = a.up_to(|| (a - g).hi());
    DoubleDouble::pi().times_exact(half) / between
}

/// In `f64`: `pi / (2 agm(1, complement))`; infinite for 0.
pub(crate) fn quarter_period<T: Real>(complement: T) -> T {
    if complement == T::zero() {
        return splat(f64::INFINITY);
    }
    let (mut a, mut g) = (T::one(), complement);
    for _ in 0..24 {
        // The mean of two numbers this close is correct to rounding.
        if (a - g).abs() <= a * NEAR {
            let mean = ((a + g) * 0.5).up_to(|| (a - g) * (a - g) / a);
            return DoubleDouble::<T>::pi().hi() * 0.5 / mean;
        }
        (a, g) = ((a + g) * 0.5, (a * g).sqrt());
    }
    DoubleDouble::<T>::pi().hi() * 0.5 / ((a + g) * 0.5).up_to(|| a - g)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against mpmath (`ellipk(1 - k'^2)` with 60 digits, as an `f64` and what it leaves out). In the first
    /// three the mean's last step is as long as it may be, and what it takes off largest.
    #[test]
    fn the_quarter_period_has_twice_the_digits() {
        for (complement, high, low) in [
            (0.001_806_763_766_829_984_4, 7.702_517_839_207_246, 3.137_983_515_876_601_7e-16),
            (8.170_943_149_234_408e-7, 15.403_805_669_328_683, -8.253_690_259_785_661e-16),
            (8.183_494_289_289_876e-7, 15.402_270_777_949_303, -7.527_243_954_543_464e-16),
            (0.001, 8.294_051_463_615_44, -8.023_311_253_989_47e-16),
            (0.5, 2.156_515_647_499_643_4, -1.822_784_772_617_928_3e-16),
        ] {
            let root = DoubleDouble::from(complement).sqrt();
            let ours = quarter_period_from_root(DoubleDouble::from(complement), root);
            let off = ((ours - DoubleDouble::from(high)) - DoubleDouble::from(low)).hi();
            assert!(off.abs() < 1e-29 * high, "{complement:e}: {off:e}");
        }
    }

    /// The error of (C45) is the square of the next difference, over sixteen; in `f64`, its own term.
    #[test]
    fn the_last_step_of_the_mean_leaves_out_less_than_rounding() {
        let next = NEAR * NEAR / 8.0;
        assert!(next * next / 4.0 < f64::EPSILON * f64::EPSILON / 8.0);
        const { assert!(NEAR * NEAR / 16.0 < f64::EPSILON / 8.0) };
    }
}
