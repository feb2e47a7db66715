//! Solutions of the variational equations of a steady spin and of a body with two equal moments: sines,
//! exponentials, powers of time.

use super::series::{Forcing, factors};
use super::{ByTensor, SpinDerivatives};
use crate::exact::cayley_klein::times;
use crate::exact::elliptic::sin_cos_of_turns;
use crate::number::DoubleDouble;
use crate::number::functions::{cosh, sinh};
use core::f64::consts::TAU;
use nalgebra::{Matrix3, Vector3};

/// About the principal axis number `axis`: that component's error stays, the other two grow or turn together.
/// The moments have no effect; a product of inertia acts on them as a constant torque.
pub(super) fn principal(moments: &[f64; 3], axis: usize, spin: f64, time: f64) -> SpinDerivatives {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let factors = factors(moments);
    let difference = |a: usize, b: usize| DoubleDouble::sum(moments[a], -moments[b]);
    // The square of the rate, with its sign: positive about the middle axis.
    let squared = difference(j, axis) / DoubleDouble::from(moments[i])
        * (difference(axis, i) / DoubleDouble::from(moments[j]));
    let rate = squared.abs().sqrt() * spin.abs();
    let phase = rate * time;
    // Even and odd solution, and the integral of the odd one.
    let half = 0.5 * phase.hi();
    let (even, odd, sum) = if phase.hi() == 0.0 {
        (1.0, time, 0.5 * time * time)
    } else if squared.hi() < 0.0 {
        let (sin, cos) = sin_cos_of_turns(phase / (DoubleDouble::PI * 2.0));
        let (sin_of_half, _) = sin_cos_of_turns(phase / (DoubleDouble::PI * 4.0));
        let quotient = sin_of_half / rate.hi();
        (cos, sin / rate.hi(), 2.0 * quotient * quotient)
    } else {
        let (main, rest) = (phase.hi(), phase.lo());
        let quotient = sinh(half) / rate.hi();
        (
            cosh(main) + sinh(main) * rest,
            (sinh(main) + cosh(main) * rest) / rate.hi(),
            2.0 * quotient * quotient,
        )
    };
    let mut derivatives = Matrix3::zeros();
    derivatives[(axis, axis)] = 1.0;
    (derivatives[(i, i)], derivatives[(j, j)]) = (even, even);
    derivatives[(j, i)] = factors[j] * spin * odd;
    derivatives[(i, j)] = factors[i] * spin * odd;
    let mut omega = [0.0; 3];
    omega[axis] = spin;
    let forcing = Forcing::new(moments).at(&omega);
    let mut by_tensor = ByTensor::zeros();
    for column in 0..6 {
        let [f, g] = [i, j].map(|k| forcing[(k, column)]);
        by_tensor[(i, column)] = odd * f + factors[i] * spin * sum * g;
        by_tensor[(j, column)] = odd * g + factors[j] * spin * sum * f;
    }
    SpinDerivatives { spin: derivatives, by_tensor, energy: [0.0; 6] }
}

type Complex = [f64; 2];

/// The moments about the two axes after `axis` are equal, and the spin turns about `axis` by `nutation` turns
/// per unit of time. The two across are one complex number `W = W_0 exp(i r t)`, and so are their changes
/// `exp(i r t) z`, where `z' = i s W_0 c + exp(-i r t) f` with the change `c` of the spin along the axis and
/// the forcing `f`, both trigonometric.
pub(super) fn top(
    moments: &[f64; 3],
    axis: usize,
    omega: &[f64; 3],
    nutation: DoubleDouble,
    time: f64,
) -> SpinDerivatives {
    let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
    let (w, along, equal) = ([omega[a], omega[b]], omega[axis], moments[a]);
    let (s, by_moments) = (factors(moments)[b], Forcing::new(moments).by_moments);
    let (sin, cos) = sin_cos_of_turns(nutation * time);
    let turned = [cos, sin];
    let rate = TAU * nutation.hi();
    // The integrals of exp(i r t) and exp(2 i r t), and the integrals of these.
    let [first, first_sum] = integrals(rate, turned, time);
    let [second, second_sum] = integrals(2.0 * rate, times(turned, turned), time);
    let (square, half_size) = (times(w, w), 0.5 * (w[0] * w[0] + w[1] * w[1]));
    // `c`, its integral, and what else `z` consists of.
    let column = |c: f64, sum: f64, [x, y]: Complex| {
        let [x, y] = times(turned, [x - s * sum * w[1], y + s * sum * w[0]]);
        let mut column = Vector3::zeros();
        (column[axis], column[a], column[b]) = (c, x, y);
        column
    };
    let (mut spin, mut by_tensor) = (Matrix3::zeros(), ByTensor::zeros());
    spin.set_column(axis, &column(1.0, time, [0.0; 2]));
    spin.set_column(a, &column(0.0, 0.0, [1.0, 0.0]));
    spin.set_column(b, &column(0.0, 0.0, [0.0, 1.0]));
    let mirrored = times([w[0], -w[1]], [second[0], -second[1]]);
    #[expect(clippy::needless_range_loop, reason = "three rows at once")]
    for k in 0..3 {
        let gain = 0.5 * by_moments[axis][k];
        let less = 0.5 * along * (by_moments[b][k] - by_moments[a][k]) * time;
        let more = 0.5 * along * (by_moments[b][k] + by_moments[a][k]);
        let rest = [-(less * w[1] + more * mirrored[1]), less * w[0] + more * mirrored[0]];
        let [c, sum] = [second, second_sum].map(|x| gain * times(square, x)[1]);
        by_tensor.set_column(k, &column(c, sum, rest));
    }
    let [c, sum] = [second, second_sum].map(|x| -times(square, x)[0] / moments[axis]);
    let by_own = along * (1.0 - s) / equal;
    by_tensor.set_column(3 + axis, &column(c, sum, mirrored.map(|x| by_own * x)));
    let (constant, [x, y]) = (along * along - half_size, times(square, first).map(|x| 0.5 * x / equal));
    let [u, v] = [constant * first[0] / equal, -constant * first[1] / equal];
    let [c, sum] = [first, first_sum].map(|x| -along * times(w, x)[0] / equal);
    by_tensor.set_column(3 + a, &column(c, sum, [u + x, v + y]));
    let [c, sum] = [first, first_sum].map(|x| along * times(w, x)[1] / equal);
    by_tensor.set_column(3 + b, &column(c, sum, [v - y, x - u]));
    // Of the integral of exp(i r t) less the time, which is i r times the second integral.
    let excess = |w: Complex, rate: f64, [x, y]: Complex| times(w, [-rate * y, rate * x]);
    let (squares, products) = (excess(square, 2.0 * rate, second_sum), excess(w, rate, first_sum));
    let mut energy = [0.0; 6];
    (energy[a], energy[b], energy[3 + axis]) = (0.5 * squares[0], -0.5 * squares[0], squares[1]);
    (energy[3 + b], energy[3 + a]) = (2.0 * along * products[0], 2.0 * along * products[1]);
    SpinDerivatives { spin, by_tensor, energy }
}

/// The integral of `exp(i rate s)` from 0 to `time` and the integral of that, given `exp(i rate time)`.
fn integrals(rate: f64, end: Complex, time: f64) -> [Complex; 2] {
    let angle = rate * time;
    if angle.abs() < 1.0 {
        // Sums of (i angle)^n/(n+1)! and /(n+2)!; what is left out is below 1e-18.
        let (mut once, mut twice) = ([0.0; 2], [0.0; 2]);
        let mut term = [1.0, 0.0];
        for n in 0..19 {
            let n = f64::from(n);
            for k in 0..2 {
                once[k] += term[k] / (n + 1.0);
                twice[k] += term[k] / ((n + 1.0) * (n + 2.0));
            }
            term = times(term, [0.0, angle / (n + 1.0)]);
        }
        return [once.map(|x| x * time), twice.map(|x| x * time * time)];
    }
    let once = [end[1] / rate, (1.0 - end[0]) / rate];
    [once, [once[1] / rate, (time - once[0]) / rate]]
}
