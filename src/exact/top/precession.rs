//! The mean rate at which a top's axis turns about the vertical, over a period of its lean.

use super::integrals::Integrals;
use crate::number::DoubleDouble;
use core::f64::consts::FRAC_PI_2;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The two means of (C45) count as equal at this relative difference: the next step changes the result by an
/// eighth of its square.
const EQUAL: f64 = 2e-8;

/// The integral of `(first + r t²)/((1 + r² t²) sqrt((1 + t²)(1 + k'² t²)))` over positive `t` (T21):
/// Legendre's complete one of the third kind by repeated means [Bul69](crate::references), which add only
/// positive numbers. The `root` is `r`, whose square must be in the range of `f64`.
fn third_kind(complement: f64, root: f64, first: f64) -> f64 {
    let (mut a, mut b, mut p) = (first, 1.0, root);
    let (mut e, mut g, mut m) = (complement, complement, 1.0);
    for _ in 0..24 {
        let before = a;
        a += b / p;
        let share = e / p;
        b = 2.0 * (b + before * share);
        p += share;
        let last = m;
        m += g;
        if (last - g).abs() <= EQUAL * last {
            break;
        }
        g = 2.0 * e.sqrt();
        e = g * m;
    }
    FRAC_PI_2 * (b + a * m) / (m * (m + p))
}

impl Integrals {
    /// The mean of `(l - along u)/(1 - u²)` (T20), in radians per unit of time, from the `long` span, the
    /// complementary modulus and the quarter period; on the separatrix, its limit.
    ///
    /// In partial fractions it is half of `at_bottom/(1 + u)` and `at_top/(1 - u)`. If both have one sign,
    /// the sum of their means has no cancellation. If not, the path of integration around the two roots that
    /// bound the motion is moved to the one around the third root and infinity. The residues at -1 and 1 are
    /// half a turn forward and half a turn back, which cancel exactly; and beyond the third root both
    /// fractions have one sign (T22). A passage exactly through a pole counts as no turn.
    pub(super) fn precession(&self, long: DoubleDouble, complement: f64, quarter: f64) -> f64 {
        let sign = |x: DoubleDouble| if x.hi() == 0.0 { 0.0 } else { x.hi().signum() };
        let (bottom, top) = (sign(self.at_bottom), sign(self.at_top));
        let ([low, high], [lowest, highest]) = (self.bottoms, self.tops);
        let beyond = self.third + self.pull * 2.0;
        if !quarter.is_finite() {
            return (self.at_bottom / high).hi() * 0.5;
        }
        // Beyond these bounds the integral is at its limit; within them the squares are in the range of
        // `f64`.
        let root = |x: DoubleDouble, y: DoubleDouble| {
            let root = x.sqrt().hi() / y.sqrt().hi();
            root.clamp(f64::MIN_POSITIVE.sqrt(), f64::MAX.sqrt())
        };
        if bottom * top < 0.0 {
            let part = |x: DoubleDouble, y: DoubleDouble, third: DoubleDouble| {
                x.sqrt().hi() * y.sqrt().hi() * third_kind(complement, root(third, long), 0.0)
            };
            let sum = part(lowest, highest, self.third) + part(low, high, beyond);
            return bottom * 0.5 * (self.pull / long.sqrt()).hi() * (sum / quarter);
        }
        let part = |sign: f64, third: DoubleDouble, x: DoubleDouble, y: DoubleDouble| {
            let root = if sign == 0.0 { 1.0 } else { root(x, y) };
            sign * third.sqrt().hi() * third_kind(complement, root, root)
        };
        let sum = part(bottom, beyond, high, low) + part(top, self.third, highest, lowest);
        0.5 * (sum / quarter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_means_end_where_the_next_step_is_below_rounding() {
        const { assert!(EQUAL * EQUAL / 8.0 < f64::EPSILON / 2.0 && 4.0 * EQUAL * EQUAL > f64::EPSILON) };
    }

    /// With a complement of 1 it is elementary. Else the expected values are sums by mpmath with 40 digits.
    #[test]
    fn the_third_integral_is_elementary_on_a_circle_and_meets_mpmath() {
        for root in [1e-150, 1e-9, 0.3, 1.0, 7.0, 1e9, 1e150] {
            let off = |ours: f64, truth: f64| (ours / truth - 1.0).abs();
            assert!(off(third_kind(1.0, root, 0.0), FRAC_PI_2 / (1.0 + root)) < 1e-15, "{root}");
            assert!(off(third_kind(1.0, root, root), FRAC_PI_2) < 1e-15, "{root}");
        }
        for (complement, root, first, truth) in [
            (0.8, 0.3, 0.0, 1.467_465_961_931_565_5),
            (0.8, 0.3, 0.3, 1.860_620_166_232_450_4),
            (0.001, 0.01, 0.0, 300.806_284_470_958_2),
            (0.001, 5.0, 5.0, 3.000_579_702_882_055_8),
            (0.4, 20.0, 0.0, 0.114_174_553_517_269_84),
            (0.05, 0.0001, 0.0001, 31.376_233_262_524_813),
        ] {
            let ours = third_kind(complement, root, first);
            assert!((ours / truth - 1.0).abs() < 2e-15, "{complement} {root} {first}: {ours}");
        }
    }
}
