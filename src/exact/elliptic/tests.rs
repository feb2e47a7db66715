//! The sums of elliptic functions and Carlson's integral against tables of many digits.

use super::*;
use crate::number::{exponent, times_power_of_two};
use core::f64::consts::TAU;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;
use proptest::prelude::*;
use serde_json::Value;

/// Half a unit in the last place, relative: the rounding of one number.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// `R_F(x, y, z)`, homogeneous of degree -1/2: with the largest brought near 1.
fn carlson_rf(x: f64, y: f64, z: f64) -> f64 {
    let half = exponent(x.max(y).max(z)) / 2;
    let root = |a: f64| times_power_of_two(a, -2 * half).sqrt();
    times_power_of_two(rf_of_roots(root(x), root(y), root(z)), -half)
}

#[test]
fn carlsons_integral_agrees_with_the_table() {
    let file: Value = serde_json::from_str(include_str!("../../../tests/data/carlson.json")).unwrap();
    let number = |x: &Value| x.as_str().unwrap().parse::<f64>().unwrap();
    for row in file.as_array().unwrap() {
        let [x, y, z, truth] = [0, 1, 2, 3].map(|k| number(&row[k]));
        assert!((carlson_rf(x, y, z) / truth - 1.0).abs() <= 6.0 * ROUNDING, "{row}");
    }
    // R_F(x, x, x) = 1/sqrt(x), to the ends of the range.
    for x in [f64::MAX, 1e300, 1e-300, 5e-324] {
        assert!((carlson_rf(x, x, x) * x.sqrt() - 1.0).abs() < 1e-15, "{x:e}");
    }
}

proptest! {
    // Independent: the platform's own sine and cosine.
    #[test]
    fn sine_and_cosine_of_turns_are_those_of_the_angle(turns in -0.6_f64..0.6) {
        let (sin, cos) = sin_cos_of_turns(DoubleDouble::from(turns));
        let (s, c) = (turns * TAU).sin_cos();
        prop_assert!((sin - s).abs() < 1e-15 && (cos - c).abs() < 1e-15, "{sin} {s} {cos} {c}");
    }

    #[test]
    fn whole_turns_change_nothing(turns in -0.5_f64..0.5, whole in -(1_i64 << 40)..(1 << 40)) {
        let many = DoubleDouble::sum(whole as f64, turns);
        prop_assert_eq!(sin_cos_of_turns(many), sin_cos_of_turns(DoubleDouble::from(turns)));
    }
}

#[test]
fn quarter_turns_are_exact_and_their_neighbours_keep_all_digits() {
    assert_eq!(sin_cos_of_turns(DoubleDouble::from(0.25)), (1.0, 0.0));
    assert_eq!(sin_cos_of_turns(DoubleDouble::from(-0.25)), (-1.0, 0.0));
    assert_eq!(sin_cos_of_turns(DoubleDouble::from(7.5)).1, -1.0);
    let beyond = 2_f64.powi(-50);
    let (_, cos) = sin_cos_of_turns(DoubleDouble::sum(1e6 + 0.25, beyond));
    assert!((cos / (-TAU * beyond) - 1.0).abs() < 1e-15, "{cos}");
}
