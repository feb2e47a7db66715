//! Solutions of the variational equations: the closed form of the spin differentiated.
//!
//! With the spin `A_X cn u`, `A_M sn u`, `A_C dn u`, a change of the inputs changes the amplitudes, the
//! modulus and the argument. The last two make one number, a shift of the phase at a fixed angle: of `u =
//! F(phi, m)` it is `du - (dF/dm) dm`, and `dF/dm` is an integral of one sign, Carlson's `R_D`
//! ([DLMF](crate::references) 19.25). At the start the shift is known from the spin; from there it grows with
//! the change of the rate, and with that of the modulus by the difference of the integral. All that is small,
//! near the separatrix or in a small libration, is carried times powers of two, as in the motion itself; on
//! the separatrix `m' = 0` the same formulas hold.

use super::{EllipticMotion, Form};
use crate::error::{Error, Refusal, Subject};
use crate::exact::elementary::Kernel;
use crate::exact::elliptic::rd;
use crate::exact::sensitivity::{ByTensor, SpinDerivatives};
use crate::number::functions::atan2;
use crate::number::{DoubleDouble, Lane, times_power_of_two};
use core::f64::consts::PI;
use nalgebra::Matrix3;

/// Beyond this argument on the separatrix, `f64` cannot represent the distance of the motion from its end.
const REST: f64 = 700.0;

/// One end of the span: the number of half periods there, `dn dF/dm` without them, and the integral of `cn²`
/// as a number of quarter periods and a rest, counted from the flip or the saddle, whichever is nearer.
struct End {
    /// `sn`, `cn`, `dn`.
    values: [f64; 3],
    halves: f64,
    growth: f64,
    quarters: f64,
    share: f64,
}

/// Derivatives of the motion's constants by the spin across, along the middle and circled (each times its
/// power of two) and by the three moments in the same order.
struct Inputs {
    /// Of the three amplitudes, of the logarithm of the rate, and of `m'` times the square of the shift.
    across: [f64; 6],
    middle: [f64; 6],
    around: [f64; 6],
    log_rate: [f64; 6],
    to_separatrix: [f64; 6],
    /// Of the phase at the start.
    phase: [f64; 6],
    /// `A_X²/A_M²`, and `m A_C²/A_M²`.
    ratio: f64,
    steepness: f64,
}

/// A time as a number of half periods and a rest.
pub(crate) struct HalfPeriods {
    pub(crate) count: f64,
    /// The scaled time of the rest, and Jacobi's argument over it.
    pub(crate) time: f64,
    pub(crate) argument: f64,
}

/// From here on the integral equals that of the separatrix to rounding.
const FAR: f64 = 1e100;

impl EllipticMotion {
    /// The half periods nearest to `time`; none on the separatrix.
    pub(crate) fn half_periods(&self, time: f64) -> HalfPeriods {
        let run = self.constants.rate * time;
        let half = self.constants.quarter * 2.0;
        let (count, left) = if half.hi().is_finite() { (run / half).split() } else { (0.0, 0.0) };
        if count == 0.0 {
            return HalfPeriods { count, time, argument: run.hi() };
        }
        let argument = half * left;
        HalfPeriods { count, time: (argument / self.constants.rate).hi(), argument: argument.hi() }
    }

    /// Over `count` half periods: the derivatives of the time by which they end earlier, by the spin at the
    /// start and by the tensor, and the integrals of the squares of the spin less those at the start.
    pub(crate) fn over_half_periods(&self, moments: &[f64; 3], count: f64) -> ([f64; 9], [f64; 3]) {
        let start = self.end(0.0);
        let inputs = self.inputs(moments, &start);
        let (half, complete) = (2.0 * self.constants.quarter.hi(), self.complete());
        let per_argument = count / self.constants.rate.hi();
        let mut earlier = [0.0; 9];
        for k in 0..6 {
            let shift = half * inputs.log_rate[k] + 2.0 * inputs.to_separatrix[k] * complete;
            let up = if k < 3 { self.constants.lifts[k] } else { 0 };
            earlier[self.index(k)] = times_power_of_two(per_argument * shift, up);
        }
        let products = self.half_period_by_products(moments, &start, complete);
        for (axis, product) in self.axes.into_iter().zip(products) {
            earlier[6 + axis] = per_argument * product;
        }
        (earlier, self.squares(&inputs, &start, count * half, 2.0 * count * self.quarter_share()))
    }

    /// The derivatives of the half period, in Jacobi's argument, by the products of inertia of the axes other
    /// than the across, the middle and the circled one, with the opposite sign.
    ///
    /// A product turns the principal axes, which the half period knows of by energy and momentum alone: its
    /// derivative by a component `w_a` of the spin is `I_a (e + l I_a) w_a`, and that by a product `(e + l
    /// (I_a + I_b)) w_a w_b`.
    fn half_period_by_products(&self, moments: &[f64; 3], start: &End, complete: f64) -> [f64; 3] {
        let [i_x, i_m, i_c] = self.axes.map(|axis| moments[axis]);
        let [d_cx, d_cm] = [i_c - i_x, i_c - i_m];
        let [a_x, a_m, a_c] = self.amplitudes;
        let [sn, cn, dn] = start.values;
        let down2 = self.down() * self.down();
        let half = 2.0 * self.constants.quarter.hi() * down2;
        let parameter = self.constants.modulus * self.constants.modulus;
        let complement2 = self.constants.scaled_complement * self.constants.scaled_complement;
        let slower = half + 4.0 * parameter * complete;
        let across = 4.0 * complete * i_x / (i_c * d_cm);
        let with_middle = i_m / (i_c * d_cx) * (half - 4.0 * complete * complement2 * down2) + across;
        let with_circled = (slower + across * (i_m - i_x)) / d_cx;
        let both = (slower / i_c * (i_c + i_m - i_x) + across * (i_m - i_x) * i_m / i_x) / d_cx;
        let (square, [first, second, third]) = (a_c * a_c, self.constants.lifts);
        let part = |factor: f64, one: f64, other: f64, lifts: i32| {
            times_power_of_two(factor / square * one * other, 2 * third - lifts)
        };
        [
            part(both, a_m * sn, a_c * dn, second + third),
            part(with_circled, a_x * cn, a_c * dn, first + third),
            part(with_middle, a_x * cn, a_m * sn, first + second),
        ]
    }

    /// The derivatives of the spin at scaled `time` by the spin at the start and, if requested, by the three
    /// moments, with the integrals of the squares of the spin less those at the start. Not for the
    /// neighbourhood of whole half periods: there it cancels.
    ///
    /// Refuses times on the separatrix at which the spin is constant in `f64`.
    pub(crate) fn derivatives(
        &self,
        moments: &[f64; 3],
        time: f64,
        tensor: bool,
    ) -> Result<SpinDerivatives, Error> {
        let run = self.constants.rate * time;
        let back = !self.returns() && (self.constants.argument + run).hi().abs() > REST;
        Refusal::OutOfRange { what: Subject::Derivative, value: f64::INFINITY }.when(back)?;
        let run = run.hi();
        let (start, end) = (self.end(0.0), self.end(time));
        let inputs = self.inputs(moments, &start);
        let down = self.down();
        let turns = end.halves - start.halves;
        let whole = if turns == 0.0 { 0.0 } else { 2.0 * turns * self.complete() };
        let before = whole - start.growth / start.values[2];
        let [sn, cn, dn] = end.values;
        let [a_x, a_m, a_c] = self.amplitudes;
        let parameter = self.constants.modulus * self.constants.modulus;
        let mut spin = Matrix3::zeros();
        let mut by_tensor = ByTensor::zeros();
        for k in 0..if tensor { 6 } else { 3 } {
            let to_separatrix = inputs.to_separatrix[k];
            // The shift of the phase times dn: far out on the separatrix it has no size of its own.
            let shift = dn * (inputs.phase[k] + run * inputs.log_rate[k] + to_separatrix * before)
                + to_separatrix * end.growth;
            let change = [
                inputs.across[k] * cn - a_x * sn * shift,
                inputs.middle[k] * sn + a_m * (cn * down) * (shift * down),
                inputs.around[k] * dn
                    + a_c * sn * (sn * (to_separatrix / (2.0 * dn)) - parameter * (cn / dn) * shift),
            ];
            let up = if k < 3 { self.constants.lifts[k] } else { 0 };
            for (row, &axis) in self.axes.iter().enumerate() {
                let change = times_power_of_two(change[row], up - self.constants.lifts[row]);
                match self.index(k) {
                    column @ 0..3 => spin[(axis, column)] = change,
                    column => by_tensor[(axis, column - 3)] = change,
                }
            }
        }
        let mut energy = [0.0; 6];
        if tensor {
            let quarters = end.quarters - start.quarters;
            let whole = if quarters == 0.0 { 0.0 } else { quarters * self.quarter_share() };
            let squares = self.squares(&inputs, &start, run, whole + (end.share - start.share));
            energy[..3].copy_from_slice(&squares);
        }
        Ok(SpinDerivatives { spin, by_tensor, energy })
    }

    /// Which column the input number `k` is, in the body's order.
    fn index(&self, k: usize) -> usize {
        if k < 3 { self.axes[k] } else { 3 + self.axes[k - 3] }
    }

    /// `2^-shift`.
    fn down(&self) -> f64 {
        times_power_of_two(1.0, -self.constants.lifts[2])
    }

    /// `dK/dm` over `2^(2 shift)`.
    fn complete(&self) -> f64 {
        let complement = self.constants.scaled_complement;
        growth(1.0, 0.0, complement, self.down()) / complement
    }

    /// The integral of `cn²` over a quarter period: `2 m' dK/dm`; on the separatrix that of `sech²`.
    fn quarter_share(&self) -> f64 {
        let complement = self.constants.scaled_complement;
        if complement == 0.0 { 1.0 } else { 2.0 * complement * complement * self.complete() }
    }

    fn end(&self, time: f64) -> End {
        let (values, halves) = match &self.form {
            Form::Direct { spin, .. } => {
                let [sin, cos] = spin.phase(&spin.reduced(time));
                let values = spin.series.values(sin, cos);
                let angle = atan2(spin.start[0], spin.start[1]);
                let (whole, left) = (spin.quarters * time * 0.5 + DoubleDouble::from(angle / PI)).split();
                // Between two half turns the sign of the cosine decides.
                let even = whole - 2.0 * Lane::round_ties_even(0.5 * whole) == 0.0;
                let halves =
                    if even == values[1].is_sign_positive() { whole } else { whole + 1_f64.copysign(left) };
                (values, halves)
            }
            Form::Complementary { spin, .. } => {
                let argument = spin.reduction.argument(time);
                (argument.values(&spin.series), argument.passage.halves.hi())
            }
        };
        let down = self.down();
        let [sn, cn, dn] = values;
        let (sn, cn) = (sn * cn.signum(), cn.abs());
        let growth = growth(sn, cn, dn, down);
        let complement = self.constants.scaled_complement;
        let sign = sn.signum();
        let true_cn2 = (cn * down) * (cn * down);
        let (quarters, share) = if sn * sn < 0.5 {
            (0.0, 2.0 * complement * (complement / dn) * growth + sn * (cn / dn))
        } else {
            // What is left to the saddle: an integral of the same form in the complementary angle.
            let quotient = dn / complement;
            let left = if quotient < FAR {
                true_cn2 * (cn / complement) * rd([sn * sn, quotient * quotient, 1.0]) / 3.0
            } else {
                true_cn2 * (cn / dn) / (1.0 + sn.abs())
            };
            (sign, -sign * left)
        };
        End { values, halves, growth, quarters: 2.0 * halves + quarters, share }
    }

    /// The integrals over time of the squares of the spin less those at the start, from Jacobi's argument
    /// `run` and the integral of `cn²` over it; of the three the energy and the momentum leave one.
    fn squares(&self, inputs: &Inputs, start: &End, run: f64, share: f64) -> [f64; 3] {
        let amplitude = times_power_of_two(self.amplitudes[1], -self.constants.lifts[1]);
        let cn = start.values[1] * self.down();
        let excess = amplitude * amplitude * (cn * cn * run - share) / self.constants.rate.hi();
        let [x, m, c] = self.axes;
        let mut squares = [0.0; 3];
        squares[x] = -inputs.ratio * excess;
        squares[m] = excess;
        squares[c] = -inputs.steepness * excess;
        squares
    }

    fn inputs(&self, moments: &[f64; 3], start: &End) -> Inputs {
        let [i_x, i_m, i_c] = self.axes.map(|axis| moments[axis]);
        let [d_cx, d_cm, d_mx] = [i_c - i_x, i_c - i_m, i_m - i_x];
        // (C39), (C40)
        // A_X² = w_X² + R w_M², A_C² = w_C² + S w_M², m' A_C² = w_C² - T w_X².
        let r = i_m * d_cm / (i_x * d_cx);
        let s = i_m * d_mx / (i_c * d_cx);
        let t = i_x * d_mx / (i_c * d_cm);
        // The logarithmic derivatives of differences, moments and their ratios.
        let (by_cx, by_cm, by_mx) =
            ([-1.0 / d_cx, 0.0, 1.0 / d_cx], [0.0, -1.0 / d_cm, 1.0 / d_cm], [-1.0 / d_mx, 1.0 / d_mx, 0.0]);
        let inverse = [1.0 / i_x, 1.0 / i_m, 1.0 / i_c];
        let ratio = |above: [f64; 3], below: [f64; 3], signs: [f64; 3]| {
            [0, 1, 2].map(|k| above[k] - below[k] + signs[k] * inverse[k])
        };
        let log_r = ratio(by_cm, by_cx, [-1.0, 1.0, 0.0]);
        let log_s = ratio(by_mx, by_cx, [0.0, 1.0, -1.0]);
        let log_t = ratio(by_mx, by_cm, [1.0, 0.0, -1.0]);

        let [_, lift, shift] = self.constants.lifts;
        let (down, flat) = (times_power_of_two(1.0, -shift), times_power_of_two(1.0, -lift));
        let [a_x, a_m, a_c] = self.amplitudes;
        let [sn, cn, dn] = start.values;
        let (square, quotient) = (sn * sn, cn / dn);
        let parameter = self.constants.modulus * self.constants.modulus;
        let complement2 = self.constants.scaled_complement * self.constants.scaled_complement;
        let true_cn2 = (cn * down) * (cn * down);
        let root_r = Lane::sqrt(r);
        let all = |spins: [f64; 3], moment: &dyn Fn(usize) -> f64| {
            [spins[0], spins[1], spins[2], moment(0), moment(1), moment(2)]
        };
        let around = all([0.0, s * (a_m * flat) / a_c * sn * flat, dn * down * down], &|k| {
            0.5 * a_c * parameter * square * log_s[k]
        });
        Inputs {
            across: all([cn * down * down, root_r * sn, 0.0], &|k| 0.5 * a_x * square * log_r[k]),
            middle: all([cn * down * down / root_r, sn, 0.0], &|k| -0.5 * a_m * true_cn2 * log_r[k]),
            around,
            log_rate: [0, 1, 2, 3, 4, 5].map(|k| {
                let own = |k: usize| 0.5 * (by_cm[k] + by_cx[k] - if k < 2 { inverse[k] } else { 0.0 });
                around[k] / a_c + if k < 3 { 0.0 } else { own(k - 3) }
            }),
            to_separatrix: all(
                [
                    -2.0 * t * (a_x * flat) * flat * cn / (a_c * a_c),
                    -2.0 * complement2 * s * (a_m * flat) * flat * sn / (a_c * a_c),
                    2.0 * parameter * dn / a_c,
                ],
                &|k| -parameter * (cn * cn * log_t[k] + complement2 * square * log_s[k]),
            ),
            phase: all([-sn / (a_x * dn), quotient / a_m, 0.0], &|k| 0.5 * sn * quotient * log_r[k]),
            ratio: r,
            steepness: s,
        }
    }
}

/// `dn dF/dm` at fixed angle, up to a quarter turn, over `2^shift`: from its sine, and cosine and rate times
/// `2^shift`. The derivative is `sin³/6 R_D(cos², 1, rate²)`; the first step of the duplication is taken with
/// the scaled numbers.
fn growth(sn: f64, cn: f64, dn: f64, down: f64) -> f64 {
    let (true_cn, true_dn) = (cn * down, dn * down);
    let shared = true_cn + true_dn + true_cn * true_dn;
    let first = 3.0 / ((dn + cn) * (1.0 + true_dn));
    // What follows is smaller than the first by about this.
    let rest = if shared < 1e-100 {
        0.0
    } else {
        rd([true_cn * true_cn + shared, 1.0 + shared, true_dn * true_dn + shared].map(|a| 0.25 * a)) * 0.25
    };
    // (C41)
    sn * sn * sn / 6.0 * (first + rest * down * true_dn)
}
