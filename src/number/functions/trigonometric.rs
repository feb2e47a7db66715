//! Sine and cosine.

use super::reduction::quarters;
use super::{inverse_factorials, polynomial};
use core::f64::consts::FRAC_PI_4;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// `(1 - sin x / x) / x²` as a series in `x²`. Up to an eighth of a turn the first term left out is below
/// 2^-66.
const SINE: [f64; 8] = inverse_factorials(3, 2, -1.0);

/// `(cos x - 1 + x²/2) / x⁴` as one.
const COSINE: [f64; 8] = inverse_factorials(4, 2, -1.0);

/// Sine and cosine of an angle in radians; NaN of one that is not finite.
#[inline]
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    let size = x.abs();
    if size <= FRAC_PI_4 {
        // So small an angle is its own sine; zero keeps its sign.
        return if size < 1e-8 { (x, 1.0) } else { near_zero(x, 0.0) };
    }
    if size.is_finite() { beyond(x) } else { (f64::NAN, f64::NAN) }
}

/// `cos(r)` and `sin(r)/r` of the root `r` of a number; NaN below zero.
#[inline]
pub(crate) fn cos_sinc_of_root(square: f64) -> (f64, f64) {
    if (0.0..=0.6).contains(&square) {
        return (cosine(square, 0.0), 1.0 - square * polynomial(&SINE, square));
    }
    let root = square.sqrt();
    let (sine, cosine) = sin_cos(root);
    (cosine, sine / root)
}

/// Both of an angle up to an eighth of a turn, given with what its rounding lost.
#[inline(always)]
fn near_zero(angle: f64, rest: f64) -> (f64, f64) {
    let square = angle * angle;
    let moved = rest * (1.0 - 0.5 * square);
    (angle + (moved - angle * square * polynomial(&SINE, square)), cosine(square, angle * rest))
}

/// The cosine of an angle with this square, less `moved`.
#[inline(always)]
fn cosine(square: f64, moved: f64) -> f64 {
    let half = 0.5 * square;
    let near = 1.0 - half;
    // What the subtraction rounded off goes back in.
    near + (((1.0 - near) - half) + (square * square * polynomial(&COSINE, square) - moved))
}

/// Sine and cosine of a finite angle beyond an eighth of a turn.
fn beyond(x: f64) -> (f64, f64) {
    let (quadrant, left) = quarters(x.abs());
    let (sin, cos) = near_zero(left.hi(), left.lo());
    let (sin, cos) = match quadrant % 4 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    };
    (if x < 0.0 { -sin } else { sin }, cos)
}
