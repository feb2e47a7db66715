//! Jacobi's functions away from the separatrix: theta sums in sines and cosines.

use crate::number::functions::powi;
use crate::number::{Gather, Lane, gather_fields, splat};

/// The sums for a nome of at most 0.09: four terms each reach rounding. Written as polynomials in
/// `cos 2z`, their even and odd halves apart, since each pair of sums shares them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DirectSeries<T = f64> {
    /// `theta_3, theta_4 = even ± odd`.
    outer: [T; 4],
    /// `theta_2 / (2 q^(1/4) cos z)` and `theta_1 / (2 q^(1/4) sin z) = even ± odd`.
    inner: [T; 4],
    /// What makes `sn`, `cn` and `dn` of the quotients by `theta_4`.
    pub(super) factors: [T; 3],
}

gather_fields!(DirectSeries { outer, inner, factors });

impl DirectSeries {
    pub(crate) fn new(q: f64) -> Self {
        let (q2, q4, q6, q9) = (q * q, powi(q, 4), powi(q, 6), powi(q, 9));
        let q12 = q6 * q6;
        // (C14)
        let outer = [1.0 - 2.0 * q4, 4.0 * q4, 2.0 * q - 6.0 * q9, 8.0 * q9];
        // (C15)
        let inner = [1.0 - q2 - q6 + q12, 4.0 * q6 - 4.0 * q12, 2.0 * q2 - 2.0 * q6 - 4.0 * q12, 8.0 * q12];
        let mut sums = Self { outer, inner, factors: [1.0; 3] };
        let [third, fourth, second, _] = sums.thetas(1.0);
        sums.factors = [third / second, fourth / second, fourth / third];
        sums
    }
}

impl<T: Lane> DirectSeries<T> {
    /// `theta_3`, `theta_4`, and `theta_2`, `theta_1` without their first factors, from `cos 2z`.
    #[inline(always)]
    pub(super) fn thetas(&self, c: T) -> [T; 4] {
        let square = c * c;
        let [a, b, d, e] = self.outer;
        let (even, odd) = (a + b * square, c * (d + e * square));
        let [a, b, d, e] = self.inner;
        let (inner_even, inner_odd) = (a + b * square, c * (d + e * square));
        [even + odd, even - odd, inner_even + inner_odd, inner_even - inner_odd]
    }

    /// `sn`, `cn`, `dn` from sine and cosine of `z`.
    #[inline(always)]
    pub(crate) fn values(&self, sin: T, cos: T) -> [T; 3] {
        let [third, fourth, second, first] = self.thetas((cos - sin) * (cos + sin));
        let [s, c, d] = self.factors;
        // (C16)
        let inverse = splat::<T>(1.0) / fourth;
        [s * (sin * first) * inverse, c * (cos * second) * inverse, d * third * inverse]
    }
}
