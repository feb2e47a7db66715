//! Roots and powers.

use crate::number::double_double::DoubleDouble;
use crate::number::power_of_two::{exponent, times_power_of_two};

/// The length of the vector `(a, b)`.
pub(crate) fn hypot(a: f64, b: f64) -> f64 {
    let [a, b] = [a.abs(), b.abs()];
    if a.is_infinite() || b.is_infinite() {
        return f64::INFINITY;
    }
    let largest = if a > b { a } else { b };
    if (1e-60..1e60).contains(&largest) {
        return (DoubleDouble::product(a, a) + DoubleDouble::product(b, b)).sqrt().hi();
    }
    let scale = exponent(largest);
    let [a, b] = [a, b].map(|x| times_power_of_two(x, -scale));
    times_power_of_two((DoubleDouble::product(a, a) + DoubleDouble::product(b, b)).sqrt().hi(), scale)
}

/// The fifth root; NaN below zero.
pub(crate) fn fifth_root(x: f64) -> f64 {
    if x == 0.0 || x == f64::INFINITY {
        return x;
    }
    if x.is_nan() || x < 0.0 {
        return f64::NAN;
    }
    let scale = exponent(x).div_euclid(5);
    let m = times_power_of_two(x, -5 * scale);
    // Halley's rule triples the digits of a guess within 20 % each time.
    let mut y = 1.0 + (m - 1.0) * (1.0 / 31.0);
    for _ in 0..3 {
        let power = (y * y) * (y * y) * y;
        y *= (2.0 * power + 3.0 * m) / (3.0 * power + 2.0 * m);
    }
    let square = DoubleDouble::product(y, y);
    let fourth = square * square;
    let miss = (DoubleDouble::from(m) - fourth * y).hi();
    times_power_of_two(y + miss / (5.0 * fourth.hi()), scale)
}

/// `x` to a whole power, by squares from the lowest bit of the exponent up.
pub(crate) fn powi(x: f64, exponent: i32) -> f64 {
    let (mut power, mut square, mut bits) = (1.0, x, exponent.unsigned_abs());
    while bits > 0 {
        if bits % 2 == 1 {
            power *= square;
        }
        bits /= 2;
        if bits > 0 {
            square *= square;
        }
    }
    if exponent < 0 { 1.0 / power } else { power }
}
