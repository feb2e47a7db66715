//! How the spin of neighbouring motions differs: the closed form differentiated.
//!
//! With the spin `A_X cn u`, `A_M sn u`, `A_C dn u`, every neighbour differs by its amplitudes, its modulus and where
//! it stands. The last two are one number, a shift of the phase at a fixed angle: of `u = F(phi, m)` it is
//! `du - (dF/dm) dm`, and `dF/dm` is an integral of one sign, Carlson's `R_D` ([DLMF](crate::references) 19.25). At the start the shift is known from
//! the spin; from there it grows with the change of the rate, and with that of the modulus by the difference of the
//! integral. All that is small, near the separatrix or in a small wobble, is carried times powers of two, as in the
//! motion itself; on the separatrix `m' = 0` the same formulas hold as they are.

use super::{Elliptic, Form};
use crate::elliptic::{Values, rd};
use crate::error::Error;
use crate::exact::sensitivity::Change;
use crate::scale::times_power_of_two;
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// Beyond this argument of the separatrix the motion no longer knows how far it is from its end.
const REST: f64 = 700.0;

impl Elliptic {
    /// Jacobi's argument run through in `time`.
    pub(crate) fn elapsed(&self, time: f64) -> f64 {
        self.constants.rate.value() * time
    }

    /// Jacobi's functions at `time` (`cn` and `dn` scaled) and the half turns there.
    fn place(&self, time: f64) -> (Values, f64) {
        match &self.form {
            Form::Trigonometric { spin, start, turns, .. } => {
                let (sin, cos) = super::advanced(start, *turns * time);
                let values = spin.at(sin, cos);
                let at_start = crate::double::Double::from(start[0].atan2(start[1]) / TAU);
                let (whole, left) = ((*turns * time + at_start) * 2.0).split();
                // Between two half turns the sign of the cosine decides.
                let even = whole - 2.0 * (0.5 * whole).round_ties_even() == 0.0;
                let halves = if even == (values.cn > 0.0) { whole } else { whole + 1_f64.copysign(left) };
                (values, halves)
            }
            Form::Hyperbolic { spin, way, .. } => {
                let place = way.at(time);
                (place.spin(spin), place.halves)
            }
        }
    }

    /// How the spin at scaled `time` changes with that at the start and with the moments, and by how much the squares
    /// of the spin, integrated over time, exceed their values at the start. For spans that are not short: there it
    /// cancels.
    ///
    /// Refuses the end of the separatrix, where `f64` does not tell it from rest.
    pub(crate) fn neighbours(&self, moments: &[f64; 3], time: f64) -> Result<Change, Error> {
        let constants = &self.constants;
        let [x, m, c] = self.axes;
        let [i_x, i_m, i_c] = self.axes.map(|axis| moments[axis]);
        let run = self.elapsed(time);
        let resting = constants.quarter.value().is_infinite();
        if resting && (constants.argument + constants.rate * time).value().abs() > REST {
            return Err(Error::OutOfRange {
                what: "how long the spin has rested on the middle axis",
                value: run,
            });
        }
        let [_, lift, shift] = constants.lifts;
        let down = times_power_of_two(1.0, -shift);
        let flat = times_power_of_two(1.0, -lift);
        let (start, halves_at_start) = self.place(0.0);
        let (end, halves) = self.place(time);

        // Ratios of the constants, and their logarithmic derivatives by the moments: A_X² = w_X² + R w_M²,
        // A_C² = w_C² + S w_M², m' A_C² = w_C² - T w_X².
        let [d_cx, d_cm, d_mx] = [i_c - i_x, i_c - i_m, i_m - i_x];
        let r = i_m * d_cm / (i_x * d_cx);
        let s = i_m * d_mx / (i_c * d_cx);
        let t = i_x * d_mx / (i_c * d_cm);
        // By the moments of the across, the middle and the circled axis.
        let (one, by_cx) = (1.0, [-1.0 / d_cx, 0.0, 1.0 / d_cx]);
        let (by_cm, by_mx) = ([0.0, -1.0 / d_cm, 1.0 / d_cm], [-1.0 / d_mx, 1.0 / d_mx, 0.0]);
        let own = [one / i_x, one / i_m, one / i_c];
        let along = |signs: [f64; 3]| [0, 1, 2].map(|k| signs[k] * own[k]);
        let sum =
            |a: [f64; 3], b: [f64; 3], sign: f64, e: [f64; 3]| [0, 1, 2].map(|k| a[k] + sign * b[k] + e[k]);
        let log_r = sum(by_cm, by_cx, -1.0, along([-1.0, 1.0, 0.0]));
        let log_s = sum(by_mx, by_cx, -1.0, along([0.0, 1.0, -1.0]));
        let log_t = sum(by_mx, by_cm, -1.0, along([1.0, 0.0, -1.0]));
        let log_speed = sum(by_cm, by_cx, 1.0, along([-1.0, -1.0, 0.0])).map(|a| 0.5 * a);

        let [a_x, a_m, a_c] = self.amplitudes;
        let (sn, cn, dn) = (start.sn, start.cn, start.dn);
        let (square, modulus, complement) = (sn * sn, constants.modulus, constants.scaled_complement);
        let parameter = modulus * modulus;
        let complement2 = complement * complement;
        let quotient = cn / dn;
        let root_r = r.sqrt();
        // In the order: spin across, middle, circled, then the moments alike. Each spin is taken times its power of two.
        let by_moments =
            |f: &dyn Fn(usize) -> f64, spins: [f64; 3]| [spins[0], spins[1], spins[2], f(0), f(1), f(2)];
        let across = by_moments(&|k| 0.5 * a_x * square * log_r[k], [cn * down, root_r * sn, 0.0]);
        let true_cn2 = (cn * down) * (cn * down);
        let middle = by_moments(&|k| -0.5 * a_m * true_cn2 * log_r[k], [cn * down / root_r, sn, 0.0]);
        let around = by_moments(
            &|k| 0.5 * a_c * parameter * square * log_s[k],
            [0.0, s * (a_m * flat) / a_c * sn * flat, dn * down],
        );
        let shift_at_start =
            by_moments(&|k| 0.5 * sn * quotient * log_r[k], [-sn / (a_x * dn), quotient / a_m, 0.0]);
        // Of m', times the square of the shift.
        let to_separatrix = by_moments(
            &|k| -parameter * (cn * cn * log_t[k] + complement2 * square * log_s[k]),
            [
                -2.0 * t * (a_x * flat) * flat * cn / (a_c * a_c),
                -2.0 * complement2 * s * (a_m * flat) * flat * sn / (a_c * a_c),
                2.0 * parameter * dn / a_c,
            ],
        );
        let folded = |v: &Values| growth(v.sn * v.cn.signum(), v.cn.abs(), v.dn, down);
        let turns = halves - halves_at_start;
        let whole = if turns == 0.0 { 0.0 } else { 2.0 * turns * growth(1.0, 0.0, complement, down) };
        let gained = whole + (folded(&end) - folded(&start));

        let mut spin = [Vector3::zeros(); 6];
        for k in 0..6 {
            let log_rate = around[k] / a_c + if k < 3 { 0.0 } else { log_speed[k - 3] };
            let shift = shift_at_start[k] + run * log_rate + to_separatrix[k] * gained;
            let change = [
                across[k] * end.cn - a_x * end.sn * (end.dn * shift),
                middle[k] * end.sn + a_m * (end.cn * down) * (end.dn * down * shift),
                around[k] * end.dn
                    + a_c
                        * (end.sn * end.sn * (to_separatrix[k] / (2.0 * end.dn))
                            - parameter * end.sn * (end.cn * shift)),
            ];
            let (j, input) = (k % 3, if k < 3 { constants.lifts[k] } else { 0 });
            let column = if k < 3 { self.axes[j] } else { 3 + self.axes[j] };
            for (row, &axis) in self.axes.iter().enumerate() {
                spin[column][axis] = times_power_of_two(change[row], input - constants.lifts[row]);
            }
        }
        // The integral of cn² is 2 m' dF/dm + sn cn/dn.
        let share = 2.0 * complement2 * gained + (end.sn * (end.cn / end.dn) - sn * quotient);
        let true_a_m = a_m * flat;
        let excess = true_a_m * true_a_m * (true_cn2 * run - share) / constants.rate.value();
        let mut squares = [0.0; 3];
        (squares[x], squares[m], squares[c]) = (-r * excess, excess, -s * excess);
        Ok(Change { spin, squares })
    }
}

/// `dF/dm` at fixed angle, up to a quarter turn, over `2^(2 shift)`: from its sine, and cosine and rate times
/// `2^shift`. It is `sin³/6 R_D(cos², 1, rate²)`; the first step of the duplication is taken with the scaled numbers.
fn growth(sn: f64, cn: f64, dn: f64, down: f64) -> f64 {
    let (true_cn, true_dn) = (cn * down, dn * down);
    let shared = true_cn + true_dn + true_cn * true_dn;
    let first = 3.0 / (dn * (dn + cn) * (1.0 + true_dn));
    // What follows is smaller than the first by about this.
    let rest = if shared < 1e-100 {
        0.0
    } else {
        rd([true_cn * true_cn + shared, 1.0 + shared, true_dn * true_dn + shared].map(|a| 0.25 * a)) * 0.25
    };
    sn * sn * sn / 6.0 * (first + rest * down * down)
}
