//! Roots of a cubic that all are real, each to its own digits however small it is.

use crate::number::double_double::DoubleDouble;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The coefficients of 1, x, x² and x³: real roots only, one of which may be at infinity, and a value at zero
/// that is not negative.
pub(super) struct Cubic(pub(super) [DoubleDouble; 4]);

impl Cubic {
    /// The first root at zero or above.
    pub(super) fn above(&self) -> DoubleDouble {
        let root = self.near();
        if root == 0.0 {
            return DoubleDouble::ZERO;
        }
        // Newton's method doubles the digits; what is left over is formed in twice the precision.
        let mut x = DoubleDouble::from(root);
        for _ in 0..2 {
            let (value, derivative) = self.value_and_derivative(x);
            let step = value.hi() / derivative;
            if step.is_finite() {
                x = x - DoubleDouble::from(step);
            }
        }
        x
    }

    /// The distance from zero to the first root at zero or below.
    pub(super) fn below(&self) -> DoubleDouble {
        let [a, b, c, d] = self.0;
        Self([a, -b, c, -d]).above()
    }

    fn value_and_derivative(&self, x: DoubleDouble) -> (DoubleDouble, f64) {
        let [a, b, c, d] = self.0;
        let value = ((d * x + c) * x + b) * x + a;
        let at = x.hi();
        (value, (3.0 * d.hi() * at + 2.0 * c.hi()) * at + b.hi())
    }

    /// To rounding, by Laguerre's method: where all roots are real it never steps past the next one.
    fn near(&self) -> f64 {
        let [a, b, c, d] = self.0.map(DoubleDouble::hi);
        if a == 0.0 && (b < 0.0 || (b == 0.0 && c <= 0.0)) {
            return 0.0;
        }
        // With a rising start the value comes down to the one at zero where the rest has its first root.
        let mut x = if b > 0.0 { first_root(b, c, d) } else { 0.0 };
        for _ in 0..80 {
            let value = ((d * x + c) * x + b) * x + a;
            let derivative = (3.0 * d * x + 2.0 * c) * x + b;
            let second = 6.0 * d * x + 2.0 * c;
            let radicand = (4.0 * derivative * derivative - 6.0 * value * second).max(0.0);
            let step = 3.0 * value / (radicand.sqrt() - derivative);
            if !(step > 1e-15 * x && step.is_finite()) {
                break;
            }
            x += step;
        }
        x
    }
}

/// The first root above zero of `b + c x + d x²`, with `b` above zero.
fn first_root(b: f64, c: f64, d: f64) -> f64 {
    let root = (c * c - 4.0 * b * d).max(0.0).sqrt();
    let x = if c <= 0.0 { 2.0 * b / (root - c) } else { -0.5 * (root + c) / d };
    if x.is_finite() { x } else { 0.0 }
}
