//! A logarithm for choosing steps: by rounded operations alone, so that every machine takes the same steps.

use crate::number::power_of_two::{exponent, times_power_of_two};
use core::f64::consts::{LN_2, SQRT_2};

/// The natural logarithm of a number not below zero, to 1e-5; of zero minus infinity.
pub(super) fn logarithm(x: f64) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 { f64::NEG_INFINITY } else { x };
    }
    let whole = exponent(x);
    let m = times_power_of_two(x, -whole);
    let z = (m - SQRT_2) / (m + SQRT_2);
    let square = z * z;
    (f64::from(whole) + 0.5) * LN_2 + 2.0 * z * (1.0 + square * (1.0 / 3.0 + square * 0.2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_logarithm_of_a_power_of_e_is_its_exponent() {
        for x in [-700.0, -36.0, -1.5, 0.0, 0.3, 2.0, 700.0] {
            assert!((logarithm(f64::exp(x)) - x).abs() < 1e-5, "{x}: {}", logarithm(f64::exp(x)));
        }
        assert_eq!(logarithm(0.0), f64::NEG_INFINITY);
        assert!(logarithm(f64::NAN).is_nan());
    }
}
