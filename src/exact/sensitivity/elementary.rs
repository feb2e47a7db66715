//! The change of a steady spin and of that of a body with two equal moments: sines, exponentials, powers of time.

use super::Change;
use super::series::Ratios;
use crate::exact::elliptic::sin_cos_of_turns;
use crate::number::double_double::DoubleDouble;
use crate::number::functions::{cosh, sinh};
use nalgebra::Vector3;

/// About the principal axis number `axis`: that part of the change stays, the other two grow or turn together, and a
/// change of the moments changes nothing.
pub(super) fn principal(moments: &[f64; 3], axis: usize, spin: f64, time: f64) -> Change {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let ratios = Ratios::new(moments);
    let gap = |a: usize, b: usize| DoubleDouble::sum(moments[a], -moments[b]);
    // The square of the rate, with its sign: positive about the middle axis.
    let squared =
        gap(j, axis) / DoubleDouble::from(moments[i]) * (gap(axis, i) / DoubleDouble::from(moments[j]));
    let rate = squared.abs().sqrt() * spin.abs();
    let phase = rate * time;
    let (even, odd) = if phase.hi() == 0.0 {
        (1.0, time)
    } else if squared.hi() < 0.0 {
        let (sin, cos) = sin_cos_of_turns(phase / (DoubleDouble::PI * 2.0));
        (cos, sin / rate.hi())
    } else {
        let (main, rest) = (phase.hi(), phase.lo());
        (cosh(main) + sinh(main) * rest, (sinh(main) + cosh(main) * rest) / rate.hi())
    };
    let mut change = Change { spin: [Vector3::zeros(); 6], squares: [0.0; 3] };
    change.spin[axis][axis] = 1.0;
    change.spin[i][i] = even;
    change.spin[j][j] = even;
    change.spin[j][i] = ratios.factor[i] * spin * odd;
    change.spin[i][j] = ratios.factor[j] * spin * odd;
    change
}

type Complex = [f64; 2];

fn times(x: Complex, y: Complex) -> Complex {
    [x[0] * y[0] - x[1] * y[1], x[0] * y[1] + x[1] * y[0]]
}

/// The moments about the two axes after `axis` are equal, and the spin turns about `axis` by `wobble` turns per unit of
/// time. The two across are one complex number `W`, and so are their changes `z`, seen from where they turn along.
pub(super) fn top(
    moments: &[f64; 3],
    axis: usize,
    omega: &[f64; 3],
    wobble: DoubleDouble,
    time: f64,
) -> Change {
    let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
    let Ratios { factor, by_moments } = Ratios::new(moments);
    let (w, along) = ([omega[a], omega[b]], omega[axis]);
    let (sin, cos) = sin_cos_of_turns(wobble * time);
    let turned = [cos, sin];
    let [once, twice] = integrals(2.0 * core::f64::consts::TAU * wobble.hi(), times(turned, turned), time);
    let square = times(w, w);
    let mut change = Change { spin: [Vector3::zeros(); 6], squares: [0.0; 3] };
    for column in 0..6 {
        let start = |k: usize| if column == k { 1.0 } else { 0.0 };
        let ratio = |k: usize| if column < 3 { 0.0 } else { by_moments[k][column - 3] };
        // Of the spin along the axis, and its integral.
        let gain = 0.5 * ratio(axis);
        let around = start(axis) + gain * times(square, once)[1];
        let advance = factor[b] * (start(axis) * time + gain * times(square, twice)[1]);
        let (less, more) = (0.5 * along * (ratio(b) - ratio(a)), 0.5 * along * (ratio(b) + ratio(a)));
        let mirrored = times([w[0], -w[1]], [once[0], -once[1]]);
        let by_turning = advance + less * time;
        // i (by_turning W + more conj(W) integral) beside the change at the start.
        let z = [
            start(a) - (by_turning * w[1] + more * mirrored[1]),
            start(b) + by_turning * w[0] + more * mirrored[0],
        ];
        let z = times(turned, z);
        (change.spin[column][a], change.spin[column][b], change.spin[column][axis]) = (z[0], z[1], around);
    }
    // Of the integral of exp(2 i k t) less the time, which is 2 i k times the second integral.
    let rate = 2.0 * core::f64::consts::TAU * wobble.hi();
    let excess = 0.5 * times(square, [-rate * twice[1], rate * twice[0]])[0];
    (change.squares[a], change.squares[b]) = (excess, -excess);
    change
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
