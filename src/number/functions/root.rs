//! Roots and powers.

use crate::number::{DoubleDouble, Field, exponent, times_power_of_two};

/// The length of the vector `(a, b)`.
pub(crate) fn hypot(a: f64, b: f64) -> f64 {
    let [a, b] = [a.abs(), b.abs()];
    if a.is_infinite() || b.is_infinite() {
        return f64::INFINITY;
    }
    let largest = if a > b { a } else { b };
    let scale = if (1e-60..1e60).contains(&largest) { 0 } else { exponent(largest) };
    let [a, b] = [a, b].map(|x| times_power_of_two(x, -scale));
    times_power_of_two((DoubleDouble::product(a, a) + DoubleDouble::product(b, b)).sqrt().hi(), scale)
}

/// `x` to a whole power, by squares from the lowest bit of the exponent up.
pub(crate) fn powi<T: Field>(x: T, exponent: i32) -> T {
    let (mut power, mut square, mut bits) = (T::one(), x, exponent.unsigned_abs());
    while bits > 0 {
        if bits % 2 == 1 {
            power *= square.clone();
        }
        bits /= 2;
        if bits > 0 {
            square *= square.clone();
        }
    }
    if exponent < 0 { T::one() / power } else { power }
}
