//! Derivatives of the closed form by the products of inertia.
//!
//! The product `I_ij` turns the principal axes `i` and `j` about the third, `k`, by `1/d` with `d = I_i -
//! I_j`, and with `u` along `k` the derivative of the spin is `(u x w - F (u x w_0))/d`, where `F` is that by
//! the spin at the start. Where `d` is small and `k` is the axis circled, `u x w` is along `w'`, which `F`
//! takes to itself, but for a multiple of `d`: with `s = (I_k - I_i)/I_j` it is `w'/(s w_k) + d g`, and `w_k`
//! is constant but for a multiple of `d`, since `2E I_i - L²` is.

use super::SpinDerivatives;
use super::series::{factors, triangle_excess};
use crate::exact::elliptic_motion::EllipticMotion;
use nalgebra::Vector3;

/// Up to this modulus the spin along the axis circled stays away from zero.
const SMALL_MODULUS: f64 = 0.7;

/// Adds the derivatives by the products to those by the spin at the start, and the integrals of `2 w_i w_j`.
pub(super) fn add(
    motion: &EllipticMotion,
    moments: &[f64; 3],
    start: &[f64; 3],
    now: &Vector3<f64>,
    time: f64,
    found: &mut SpinDerivatives,
) {
    let start = Vector3::from(*start);
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let d = moments[i] - moments[j];
        let lone = d.abs() < (moments[k] - moments[i]).abs().min((moments[k] - moments[j]).abs());
        let (column, integral) = if lone && k == motion.axes[2] && motion.modulus() < SMALL_MODULUS {
            nearly_equal(moments, k, &start, now, found)
        } else {
            let turned = |w: &Vector3<f64>| Vector3::ith(k, 1.0).cross(w);
            // (C43)
            let column = (turned(now) - found.spin * turned(&start)) / d;
            (column, moments[k] * ((now[k] - start[k]) / d))
        };
        found.by_tensor.set_column(3 + k, &column);
        found.energy[3 + k] = 2.0 * (integral - time * start[i] * start[j]);
    }
}

/// For the product of the axes other than the circled one, `k`; and the integral of `w_i w_j`.
fn nearly_equal(
    moments: &[f64; 3],
    k: usize,
    start: &Vector3<f64>,
    now: &Vector3<f64>,
    found: &SpinDerivatives,
) -> (Vector3<f64>, f64) {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let factors = factors(moments);
    let s = factors[j];
    let shape = triangle_excess(moments, k) / (moments[i] * moments[j]);
    let g = |w: &Vector3<f64>| {
        Vector3::ith(i, w[j] * shape / s) - Vector3::ith(k, w[i] * w[j] / (moments[k] * s * w[k]))
    };
    // The change of w_k over d.
    let squares = (now[j] - start[j]) * (now[j] + start[j]);
    let slower = -moments[j] * squares / (moments[k] * (moments[i] - moments[k]) * (now[k] + start[k]));
    let rate = Vector3::from([0, 1, 2].map(|a| factors[a] * now[(a + 1) % 3] * now[(a + 2) % 3]));
    let column = g(now) - found.spin * g(start) - rate * (slower / (s * now[k] * start[k]));
    (column, moments[k] * slower)
}

/// Completes the derivatives by the products after half periods that took `time`: where an odd number of them
/// has changed `signs`, the axes in which it did are turned too. `end` is the spin.
pub(super) fn after_half_periods(
    moments: &[f64; 3],
    start: &[f64; 3],
    end: &Vector3<f64>,
    signs: &Vector3<f64>,
    [whole, rest]: [f64; 2],
    found: &mut SpinDerivatives,
) {
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let product = start[i] * start[j];
        let energy = &mut found.energy[3 + k];
        *energy = signs[k] * *energy + 2.0 * ((signs[k] - 1.0) * product * rest - product * whole);
        if signs[k] < 0.0 {
            let d = moments[i] - moments[j];
            *energy -= 4.0 * moments[k] * (start[k] / d);
            let turned = Vector3::ith(k, 2.0).cross(end) / d;
            let mut column = found.by_tensor.column_mut(3 + k);
            column += turned;
        }
    }
}
