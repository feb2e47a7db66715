use super::*;
use crate::number::ulp;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Values computed with 600 digits by `tests/data/elementary-functions.py`: `function,arguments,value,rest`
/// with bits in hexadecimal, and in units in the last place what the value's rounding left off.
const TABLE: &str = include_str!("../../../tests/data/elementary-functions.csv");

type Function = fn(f64, f64) -> f64;

/// By how many units in the last place each function may be off here: a little more than the worst of 100,000
/// random arguments.
const BOUNDS: [(&str, f64, Function); 10] = [
    ("sin", 0.74, |x, _| sin_cos(x).0),
    ("cos", 0.70, |x, _| sin_cos(x).1),
    ("cos_of_root", 0.98, |x, _| cos_sinc_of_root(x).0),
    ("sinc_of_root", 1.25, |x, _| cos_sinc_of_root(x).1),
    ("exp", 0.55, |x, _| exp(x)),
    ("expm1", 0.57, |x, _| exp_and_exp_m1(x).1),
    ("sinh", 0.55, |x, _| sinh(x)),
    ("cosh", 0.52, |x, _| cosh(x)),
    ("atan2", 0.501, atan2),
    ("hypot", 0.501, hypot),
];

#[test]
fn every_function_is_within_its_bound_of_values_computed_with_many_digits() {
    let bits = |field: &str| f64::from_bits(u64::from_str_radix(field, 16).unwrap());
    let mut lines = [0; BOUNDS.len()];
    for line in TABLE.lines() {
        let fields: Vec<&str> = line.split(',').collect();
        let [name, x, .., value, rest] = fields[..] else { panic!("{line}") };
        let number = BOUNDS.iter().position(|(function, ..)| *function == name).unwrap();
        let (_, bound, function) = BOUNDS[number];
        let (ours, value) = (function(bits(x), bits(fields[2])), bits(value));
        let off = if ours == value { 0.0 } else { (ours - value) / ulp(value) };
        let error = (off - rest.parse::<f64>().unwrap()).abs();
        assert!(error <= bound, "{line}: {error}");
        lines[number] += 1;
    }
    assert!(lines.iter().all(|&count| count > 30), "{lines:?}");
}

/// The table has no zeros, infinities or NaN: what IEEE 754, section 9.2.1, has for them.
#[test]
fn zeros_keep_their_signs_and_infinities_their_limits() {
    const INF: f64 = f64::INFINITY;
    let same = |ours: f64, expected: f64| assert_eq!(ours.to_bits(), expected.to_bits(), "{ours} {expected}");
    for zero in [0.0, -0.0] {
        same(sin_cos(zero).0, zero);
        same(sin_cos(zero).1, 1.0);
        same(exp_and_exp_m1(zero).1, zero);
        same(sinh(zero), zero);
        same(cosh(zero), 1.0);
        same(exp(zero), 1.0);
        same(hypot(zero, -0.0), 0.0);
        same(atan2(zero, 1.0), zero);
        same(atan2(zero, 0.0), zero);
        same(atan2(zero, -0.0), PI.copysign(zero));
        same(atan2(zero, -INF), PI.copysign(zero));
        same(atan2(1.0, zero), FRAC_PI_2);
        assert_eq!(cos_sinc_of_root(zero), (1.0, 1.0));
    }
    for (y, x, angle) in [
        (INF, 1.0, FRAC_PI_2),
        (-INF, -1.0, -FRAC_PI_2),
        (INF, INF, FRAC_PI_4),
        (-INF, -INF, -3.0 * FRAC_PI_4),
        (2.0, INF, 0.0),
        (-2.0, INF, -0.0),
        (-2.0, -INF, -PI),
    ] {
        same(atan2(y, x), angle);
    }
    assert_eq!([INF, -INF].map(exp_and_exp_m1), [(INF, INF), (0.0, -1.0)]);
    assert_eq!([INF, -INF].map(exp), [INF, 0.0]);
    assert_eq!((sinh(-INF), cosh(-INF), hypot(f64::NAN, -INF)), (-INF, INF, INF));
    let nan = f64::NAN;
    let functions = BOUNDS.map(|(name, _, function)| (name, function));
    for (name, function) in functions {
        assert!(function(nan, nan).is_nan() && function(nan, 1.0).is_nan(), "{name}");
    }
    for undefined in [sin_cos(INF).0, sin_cos(-INF).1, cos_sinc_of_root(-1.0).0, hypot(1.0, nan)] {
        assert!(undefined.is_nan());
    }
}

#[test]
fn a_whole_power_is_a_product_of_squares() {
    assert_eq!([powi(3.0, 0), powi(-3.0, 3), powi(2.0, -3), powi(10.0, -400)], [1.0, -27.0, 0.125, 0.0]);
    assert_eq!(powi(0.1, 6), (0.1 * 0.1) * ((0.1 * 0.1) * (0.1 * 0.1)));
}

#[test]
fn cosine_and_sinc_of_a_root_are_those_of_the_angle_on_either_side_of_where_the_series_ends() {
    for step in 1..=400 {
        let square = 0.02 * f64::from(step);
        let root = square.sqrt();
        let ((cosine, sinc), (sine, expected)) = (super::cos_sinc_of_root(square), super::sin_cos(root));
        // A rounding of the root moves the cosine by half of it times the sine's share.
        assert!((cosine - expected).abs() <= 2.0 * f64::EPSILON, "{square}: {cosine} {expected}");
        assert!((sinc - sine / root).abs() <= 2.0 * f64::EPSILON, "{square}: {sinc}");
    }
}
