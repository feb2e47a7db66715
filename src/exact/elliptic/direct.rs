//! Jacobi's functions away from the separatrix: theta sums in sines and cosines.

use crate::number::functions::powi;
use crate::number::{Gather, Rounding, Series, gather_fields};

/// Jacobi's four theta functions as sums in the nome, which must be at most 0.09: then four terms of each
/// reach rounding. They are polynomials in `cos 2z`, with even and odd halves apart, because each pair of
/// sums shares these halves.
///
/// ```
/// use tumbling::laws::DirectSeries;
/// // At z = 0, with a nome of 0.01.
/// let [third, fourth, ..] = DirectSeries::new(0.01).thetas(1.0);
/// assert!((third - 1.020_000_02_f64).abs() < 1e-15 && (fourth - 0.980_000_02_f64).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DirectSeries<T = f64> {
    /// `theta_3, theta_4 = even ± odd`.
    outer: [T; 4],
    /// `theta_2 / (2 q^(1/4) cos z)` and `theta_1 / (2 q^(1/4) sin z) = even ± odd`.
    inner: [T; 4],
    /// The factors that give `sn`, `cn` and `dn` from the quotients by `theta_4`.
    pub(super) factors: [T; 3],
}

gather_fields!(DirectSeries { outer, inner, factors });

impl<T: Series> DirectSeries<T> {
    /// From the nome.
    pub fn new(q: T) -> Self {
        let n = T::integer;
        let power = |k| powi(q.clone(), k);
        let [q2, q4, q6, q9] = [power(2), power(4), power(6), power(9)];
        let q12 = q6.clone() * q6.clone();
        // (C14)
        let outer = [
            (n(1) - n(2) * q4.clone()).up_to(|| n(3) * power(16)),
            n(4) * q4,
            n(2) * q.clone() - n(6) * q9.clone(),
            n(8) * q9,
        ];
        // (C15)
        let inner = [
            (n(1) - q2.clone() - q6.clone() + q12.clone()).up_to(|| n(10) * power(20)),
            n(4) * q6.clone() - n(4) * q12.clone(),
            n(2) * q2 - n(2) * q6 - n(4) * q12.clone(),
            n(8) * q12,
        ];
        let mut sums = Self { outer, inner, factors: [n(1), n(1), n(1)] };
        let [third, fourth, second, _] = sums.thetas(n(1));
        sums.factors = [third.clone() / second.clone(), fourth.clone() / second, fourth / third];
        sums
    }

    /// `theta_3`, `theta_4`, and `theta_2`, `theta_1` without their first factors, from `cos 2z`.
    #[inline(always)]
    pub fn thetas(&self, c: T) -> [T; 4] {
        let square = c.clone() * c.clone();
        let halves = |[a, b, d, e]: [T; 4]| (a + b * square.clone(), c.clone() * (d + e * square.clone()));
        // Not by an array's `map`, which the compiler may leave a function of its own, for any processor.
        let ((even, odd), (inner_even, inner_odd)) = (halves(self.outer.clone()), halves(self.inner.clone()));
        [
            even.clone() + odd.clone(),
            even - odd,
            inner_even.clone() + inner_odd.clone(),
            inner_even - inner_odd,
        ]
    }

    /// `sn`, `cn`, `dn` from those four and sine and cosine of `z`.
    #[inline(always)]
    pub fn quotients(&self, [third, fourth, second, first]: [T; 4], [sin, cos]: [T; 2]) -> [T; 3] {
        let [s, c, d] = self.factors.clone();
        // (C16)
        let inverse = T::one() / fourth;
        [s * (sin * first) * inverse.clone(), c * (cos * second) * inverse.clone(), d * third * inverse]
    }
}

impl<T: Rounding> DirectSeries<T> {
    /// `sn`, `cn`, `dn` from sine and cosine of `z`.
    #[inline(always)]
    pub(crate) fn values(&self, sin: T, cos: T) -> [T; 3] {
        self.quotients(self.thetas((cos - sin) * (cos + sin)), [sin, cos])
    }
}
