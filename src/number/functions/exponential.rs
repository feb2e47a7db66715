//! The exponential and its hyperbolic functions.

use super::{inverse_factorials, polynomial};
use crate::number::{DoubleDouble, Lane, times_power_of_two};
use core::f64::consts::LOG2_E;

/// The logarithm of 2 in two parts; the first has 42 bits, so that an exponent times it is exact.
const LN_2: [f64; 2] = [0.693_147_180_559_890_3, 5.497_923_018_708_371e-14];

/// `(e^x - 1 - x - x²/2) / x³` as a series: where the exponential takes it, the first term left out is below
/// 2^-63 of the sum.
const TAIL: [f64; 12] = inverse_factorials(3, 1, 1.0);

/// `(sinh x / x - 1) / x²` as a series in `x²`, likewise.
const SINH: [f64; 8] = inverse_factorials(3, 2, 1.0);

/// From here on, both ways, an exponential is infinite or zero.
const FAR: f64 = 746.0;

/// `k` and `p` with `e^x = 2^k (1 + p)` and `|p|` below 0.42, for a finite `x` of at most 746.
fn halvings(x: f64) -> (i32, DoubleDouble) {
    let k = Lane::round_ties_even(x * LOG2_E);
    let r = DoubleDouble::sum(x - k * LN_2[0], -(k * LN_2[1]));
    let (x, rest) = (r.hi(), r.lo());
    let square = DoubleDouble::product(x, x);
    let sum = DoubleDouble::sum(x, 0.5 * square.hi());
    let small = 0.5 * square.lo() + rest * (1.0 + x) + x * square.hi() * polynomial(&TAIL, x);
    (k as i32, DoubleDouble::sum(sum.hi(), sum.lo() + small))
}

/// `x 2^exponent` for an `x` near 1, rounded once, below the smallest normal number too.
fn scaled(x: f64, exponent: i32) -> f64 {
    times_power_of_two(times_power_of_two(x, exponent / 2), exponent - exponent / 2)
}

/// The exponential, and the exponential less 1.
pub(crate) fn exp_and_exp_m1(x: f64) -> (f64, f64) {
    if x.is_nan() {
        return (x, x);
    }
    if x < -45.0 {
        return (exp(x), -1.0);
    }
    let (k, part) = halvings(x.min(FAR));
    let whole = DoubleDouble::sum(1.0, -times_power_of_two(1.0, -k));
    let less_1 = if x.abs() < 1e-17 { x } else { scaled((part + whole).hi(), k) };
    (scaled((part + DoubleDouble::ONE).hi(), k), less_1)
}

/// The exponential.
pub(crate) fn exp(x: f64) -> f64 {
    if x.is_nan() {
        return x;
    }
    let (k, part) = halvings(x.clamp(-FAR, FAR));
    scaled((part + DoubleDouble::ONE).hi(), k)
}

/// `(e^x ± e^-x) / 2` for `x` not below 0.
fn half_sum(x: f64, sign: f64) -> f64 {
    let (k, part) = halvings(x.min(FAR));
    let rising = part + DoubleDouble::ONE;
    let falling = (DoubleDouble::ONE / rising).scaled(-2 * k);
    scaled((rising + falling * sign).hi(), k - 1)
}

/// The hyperbolic cosine.
pub(crate) fn cosh(x: f64) -> f64 {
    if x.is_nan() { x } else { half_sum(x.abs(), 1.0) }
}

/// The hyperbolic sine.
pub(crate) fn sinh(x: f64) -> f64 {
    if x.is_nan() || x.abs() < 1e-9 {
        return x;
    }
    let square = x * x;
    if x.abs() < 0.35 {
        x + x * square * polynomial(&SINH, square)
    } else {
        half_sum(x.abs(), -1.0).copysign(x)
    }
}
