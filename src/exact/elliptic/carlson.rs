//! Carlson's symmetric integrals of the first and second kind [Car95](crate::references), by duplication.

use crate::number::{Field, Real, splat};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Where the relative distance of the numbers from their mean is at most this, the series is summed.
const NEAR: [f64; 2] = [3e-3, 5e-3];

/// `R_F(x², y², z²)` for three numbers not below zero, at most one of them zero (two zeros give infinity).
///
/// Accepts the roots, so that values such as 1e-200 do not underflow: the first duplication uses the roots
/// directly.
pub(crate) fn rf_of_roots<T: Real>(x: T, y: T, z: T) -> T {
    let shared = x * y + y * z + z * x;
    if shared == T::zero() {
        return splat(f64::INFINITY);
    }
    let mean = |v: &[T; 3]| (v[0] + v[1] + v[2]) / splat(3.0);
    let mut v = [x, y, z].map(|a| (a * a + shared) * 0.25);
    // Each step divides the differences by four once the numbers are of the same order; numbers that are
    // hundreds of orders apart need ten more steps before that.
    for _ in 0..40 {
        let mean = mean(&v);
        if v.iter().all(|a| (*a - mean).abs() <= mean * NEAR[0]) {
            break;
        }
        // (C46)
        let [a, b, c] = v.map(T::sqrt);
        let shared = a * b + b * c + c * a;
        v = v.map(|a| (a + shared) * 0.25);
    }
    let mean = mean(&v);
    let [a, b] = [0, 1].map(|i| splat::<T>(1.0) - v[i] / mean);
    let c = -a - b;
    let (e2, e3) = (a * b - c * c, a * b * c);
    let sum = (first_series(e2, e3) + 1.0).up_to(|| first_rest(a.abs() + b.abs()));
    sum / mean.sqrt()
}

/// A bound on the terms omitted from the series of the first kind, for numbers whose distances from their
/// mean are at most this one: the term of order `n` is below a fifth of its power.
fn first_rest<T: Real>(most: T) -> T {
    let square = most * most;
    let fourth = square * square;
    if most < splat(0.5) { fourth * fourth * 0.4 } else { splat(f64::INFINITY) }
}

/// The series of [Car95](crate::references) to the terms of seventh order, without its first term.
fn first_series<T: Field>(e2: T, e3: T) -> T {
    let (n, e2, e3) = (T::integer, || e2.clone(), || e3.clone());
    // (C47)
    -e2() / n(10) + e3() / n(14) + e2() * e2() / n(24)
        - n(3) * e2() * e3() / n(44)
        - n(5) * e2() * e2() * e2() / n(208)
        + n(3) * e3() * e3() / n(104)
        + e2() * e2() * e3() / n(16)
}

/// `R_D(x, y, z)`, three halves of the integral of `1/((t+z) sqrt((t+x)(t+y)(t+z)))` over positive `t`, for
/// three positive numbers.
pub(crate) fn rd(numbers: [f64; 3]) -> f64 {
    let mut v = numbers;
    let (mut sum, mut part) = (0.0, 1.0);
    let mean = |v: &[f64; 3]| (v[0] + v[1] + 3.0 * v[2]) / 5.0;
    for _ in 0..60 {
        let middle = mean(&v);
        if v.iter().all(|a| (a - middle).abs() <= NEAR[1] * middle) {
            break;
        }
        // (C46)
        let [a, b, c] = v.map(f64::sqrt);
        let shared = a * b + b * c + c * a;
        sum += part / (c * (v[2] + shared));
        part *= 0.25;
        v = v.map(|a| 0.25 * (a + shared));
    }
    let middle = mean(&v);
    let [a, b] = [0, 1].map(|i| 1.0 - v[i] / middle);
    let c = -(a + b) / 3.0;
    let (ab, c2) = (a * b, c * c);
    let sums = [ab - 6.0 * c2, (3.0 * ab - 8.0 * c2) * c, 3.0 * (ab - c2) * c2, ab * c2 * c];
    part * (1.0 + second_series(sums)) / (middle * middle.sqrt()) + 3.0 * sum
}

/// The series of [DLMF](crate::references) 19.36.2, to the terms of seventh order, without its first term.
fn second_series([e2, e3, e4, e5]: [f64; 4]) -> f64 {
    // (C48)
    -3.0 / 14.0 * e2 + e3 / 6.0 + 9.0 / 88.0 * e2 * e2 - 3.0 / 22.0 * e4 - 9.0 / 52.0 * e2 * e3
        + 3.0 / 26.0 * e5
        - e2 * e2 * e2 / 16.0
        + 3.0 / 40.0 * e3 * e3
        + 3.0 / 20.0 * e2 * e4
        + 45.0 / 272.0 * e2 * e2 * e3
        - 9.0 / 68.0 * (e3 * e4 + e2 * e5)
}

#[cfg(test)]
mod tests {
    use super::{NEAR, first_series, rd, second_series};
    use proptest::prelude::*;

    /// The terms of the binomial series of `(1 + e_2 h² - e_3 h³ + e_4 h⁴ - e_5 h⁵)^(-1/2)` by their powers
    /// of `h`, through the seventh.
    fn binomial(e: [f64; 4]) -> [f64; 8] {
        let (mut term, mut sum) = ([0.0; 8], [0.0; 8]);
        term[0] = 1.0;
        for k in 0..4 {
            sum = core::array::from_fn(|n| sum[n] + term[n]);
            let factor = -(f64::from(k) + 0.5) / f64::from(k + 1);
            let signed = [e[0], -e[1], e[2], -e[3]];
            let times = |n: usize, m: usize| if n < m { 0.0 } else { term[n - m] * signed[m - 2] };
            term = core::array::from_fn(|n| factor * (2..6).map(|m| times(n, m)).sum::<f64>());
        }
        sum
    }

    /// Each power of `h` is the integral of a power of `t`: `t^(-3/2 - n)/2`, and `3 t^(-5/2 - n)/2`.
    #[test]
    fn the_coefficients_are_those_of_the_binomial_series() {
        for e in [[0.3, -0.7, 0.0, 0.0], [-0.4, 0.6, 0.9, -0.8], [0.9, 0.2, -0.5, 0.7], [0.1, 0.0, 0.3, 1.1]]
        {
            let first = (0..).zip(binomial([e[0], e[1], 0.0, 0.0])).map(|(n, x)| x / f64::from(2 * n + 1));
            assert!((1.0 + first_series(e[0], e[1]) - first.sum::<f64>()).abs() < 1e-15, "{e:?}");
            let second = (0..).zip(binomial(e)).map(|(n, x)| 3.0 * x / f64::from(2 * n + 3));
            assert!((1.0 + second_series(e) - second.sum::<f64>()).abs() < 1e-15, "{e:?}");
        }
    }

    /// The term of eighth order is at most what it is where all distances have one sign and size: the
    /// binomial coefficient of as many halves as there are distances.
    #[test]
    fn what_the_series_leave_out_is_below_rounding() {
        for (near, distances, weight) in [(NEAR[0], 3.0, 1.0 / 17.0), (NEAR[1], 5.0, 3.0 / 19.0)] {
            let coefficient: f64 =
                (0..8).map(|k| (0.5 * distances + f64::from(k)) / f64::from(k + 1)).product();
            assert!(coefficient * weight * near.powi(8) < f64::EPSILON / 8.0);
        }
    }

    #[test]
    fn the_second_kind_agrees_with_the_published_values_and_elementary_cases() {
        // [Car95](crate::references), section 3.
        assert!((rd([2.0, 3.0, 4.0]) / 0.165_105_272_942_61 - 1.0).abs() < 1e-13);
        // R_D(x, x, x) = x^(-3/2); and with two equal, an elementary integral: of x = y = 1, z = 1/4.
        assert!((rd([9.0; 3]) * 27.0 - 1.0).abs() < 1e-15);
        let z: f64 = 0.25;
        let angle = z.sqrt().acos();
        let expected = 3.0 / (1.0 - z) * (1.0 / z.sqrt() - angle / (1.0 - z).sqrt());
        assert!((rd([1.0, 1.0, z]) / expected - 1.0).abs() < 1e-14);
    }

    proptest! {
        // The law of the three places: R_D(y,z,x) + R_D(z,x,y) + R_D(x,y,z) = 3/sqrt(xyz).
        #[test]
        fn the_three_integrals_of_the_second_kind_add_up(x in -30.0..30.0_f64, y in -30.0..30.0_f64, z in -30.0..30.0_f64) {
            let [x, y, z] = [x, y, z].map(|e| 10_f64.powf(e));
            let sum = rd([y, z, x]) + rd([z, x, y]) + rd([x, y, z]);
            prop_assert!((sum * (x * y).sqrt() * z.sqrt() / 3.0 - 1.0).abs() < 3e-15, "{x} {y} {z}");
        }
    }
}
