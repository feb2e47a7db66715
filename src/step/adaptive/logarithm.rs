//! A logarithm and an exponential for choosing steps: by rounded operations alone, so that every machine
//! takes the same steps.

use crate::number::power_of_two::{exponent, times_power_of_two};
use core::f64::consts::{LN_2, LOG2_E, SQRT_2};

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

/// The exponential, to 2e-5.
pub(super) fn exponential(x: f64) -> f64 {
    if x < -1000.0 {
        return 0.0;
    }
    let twos = x * LOG2_E;
    let whole = twos as i32;
    let y = (twos - f64::from(whole)) * LN_2;
    let terms = [120.0, 24.0, 6.0, 2.0, 1.0, 1.0];
    times_power_of_two(terms.iter().fold(1.0 / 720.0, |sum, below| sum * y + 1.0 / below), whole)
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

    #[test]
    fn the_exponential_undoes_the_logarithm() {
        for x in [1e-300, 3e-8, 0.6, 0.99, 1.0, 1.9, 5e3, 1e300] {
            assert!((exponential(logarithm(x)) / x - 1.0).abs() < 3e-5, "{x}");
        }
        assert_eq!(exponential(f64::NEG_INFINITY), 0.0);
        assert_eq!([exponential(f64::INFINITY), exponential(1e6)], [f64::INFINITY; 2]);
        assert!(exponential(f64::NAN).is_nan());
    }
}
