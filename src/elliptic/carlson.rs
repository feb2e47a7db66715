//! Carlson's symmetric integral of the first kind [Car95](crate::references), by duplication.

/// `R_F(x², y², z²)` for three numbers not below zero, at most one of them zero (two zeros give infinity).
///
/// Takes the roots, so that 1e-200 and its like come through: the first duplication uses them as they are.
pub(crate) fn rf_of_roots(x: f64, y: f64, z: f64) -> f64 {
    let shared = x * y + y * z + z * x;
    if shared == 0.0 {
        return f64::INFINITY;
    }
    let mut v = [x, y, z].map(|a| 0.25 * (a * a + shared));
    // Each step divides the differences by four, from where the numbers are of one size; from numbers
    // hundreds of orders apart, ten steps lead there.
    for _ in 0..40 {
        let mean = (v[0] + v[1] + v[2]) / 3.0;
        let spread = v.iter().map(|a| (a - mean).abs()).fold(0.0, f64::max);
        if spread <= 3e-3 * mean {
            break;
        }
        let [a, b, c] = v.map(f64::sqrt);
        let shared = a * b + b * c + c * a;
        v = v.map(|a| 0.25 * (a + shared));
    }
    let mean = (v[0] + v[1] + v[2]) / 3.0;
    let [a, b] = [0, 1].map(|i| 1.0 - v[i] / mean);
    let c = -a - b;
    let (e2, e3) = (a * b - c * c, a * b * c);
    // The series of [Car95] to the terms of seventh order.
    let series = -e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0 - 5.0 * e2 * e2 * e2 / 208.0
        + 3.0 * e3 * e3 / 104.0
        + e2 * e2 * e3 / 16.0;
    (1.0 + series) / mean.sqrt()
}
