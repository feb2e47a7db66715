//! The complete integral by the arithmetic-geometric mean [Gau99](crate::references).

use crate::double::Double;
use std::f64::consts::FRAC_PI_2;

/// `K` in twice the precision, from the complementary modulus and its root, which must be above zero.
///
/// The root is asked for by itself since it has all its digits where the complement is subnormal.
pub(crate) fn quarter_period_from_root(complement: Double, root: Double) -> Double {
    let (mut a, mut g) = ((Double::ONE + complement) * 0.5, root);
    // Each step doubles the digits, once the first ten at most have brought 1e-162 up to where that sets in.
    for _ in 0..24 {
        let difference = (a - g).value();
        let mean = (a + g) * 0.5;
        if difference.abs() <= 1e-8 * a.value() {
            // What the next step would take off, but for its square.
            a = mean - Double::from(difference * difference / (16.0 * mean.value()));
            break;
        }
        g = (a * g).sqrt();
        a = mean;
    }
    Double::PI * 0.5 / a
}

/// The same in `f64`: `pi / (2 agm(1, complement))`; infinite for 0.
pub(crate) fn quarter_period(complement: f64) -> f64 {
    if complement == 0.0 {
        return f64::INFINITY;
    }
    let (mut a, mut g) = (1.0, complement);
    for _ in 0..24 {
        // The next mean of two this close is right to rounding.
        if (a - g).abs() <= 1e-8 * a {
            break;
        }
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    FRAC_PI_2 / (0.5 * (a + g))
}
