//! The complex numbers of a top's motion: each is a theta function of the phase times a steady rotation.
//!
//! With `alpha = w + i z` and `beta = x + i y` of the attitude's quaternion, `|alpha|² = (1 + u)/2` and
//! `|beta|² = (1 - u)/2`, where `u` is the cosine of the lean, that has a period. So both are theta functions
//! whose zeros lie where `u` is -1 and 1, over the one where `u` has its poles, times an exponential of the
//! time ([KS97](crate::references)), (T12); so is the spin across the axis, whose square is linear in `u`:
//!
//! ```text
//! alpha ~ theta_1(z - i B)/theta_4(z),   beta, omega ~ theta_2(z - i B)/theta_4(z)
//! ```

use crate::exact::cayley_klein::{conjugate, phase_factor, times};
use crate::exact::elliptic_motion::Exponentials;
use crate::number::DoubleDouble;
use crate::number::functions::{exp, exp_and_exp_m1, hypot, powi, sin_cos};
use core::f64::consts::{FRAC_PI_2, PI};

/// The parameters of one of the three numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shape {
    /// Whether it is largest at the highest position of the axis: then it is `theta_1`, otherwise `theta_2`.
    pub(super) first: bool,
    /// The position of the zero, as an imaginary argument of Jacobi's functions, and its distance below the
    /// quarter period.
    pub(super) depths: [f64; 2],
    /// 1 or -1: the sign of the rate at which its argument turns as it passes the zero.
    pub(super) sense: f64,
    /// Where it is largest: its length, and the rate of its argument (rad per unit of time) (T11).
    pub(super) size: f64,
    pub(super) rate: DoubleDouble,
    /// Its value at the start; where that is zero, its rate of change matters.
    pub(super) start: [f64; 2],
    pub(super) start_rate: [f64; 2],
}

impl Shape {
    /// Its size at the start, relative to its largest size.
    pub(super) fn share(&self) -> f64 {
        hypot(self.start[0], self.start[1]) / self.size
    }

    /// The factor that rotates `found`, the function at the start, to the direction of the start, and scales
    /// `largest`, the function where it is largest, to the size there.
    fn fitting(&self, found: [f64; 2], largest: [f64; 2], denominator: f64) -> [f64; 2] {
        let amplitude = self.size * denominator / hypot(largest[0], largest[1]);
        let unit = |x: [f64; 2]| {
            let length = hypot(x[0], x[1]);
            (length > 0.0).then(|| x.map(|x| x / length))
        };
        // Whether the function increases or decreases through its zero.
        let growing = [if self.first { 1.0 } else { -1.0 }, 0.0];
        let direction = match (unit(self.start), unit(found)) {
            (Some(start), Some(found)) => times(start, conjugate(found)),
            _ => unit(self.start_rate).map_or([1.0, 0.0], |rate| times(rate, growing)),
        };
        direction.map(|x| amplitude * x)
    }
}

/// The steady rotation that multiplies one of the three theta functions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Carrier {
    pub(super) start: [f64; 2],
    /// In turns: the rate per unit of time, and the increment in each half period.
    pub(super) drift: DoubleDouble,
    step: f64,
    /// The scale of the rounding of the drift.
    terms: f64,
    /// The largest size of the number.
    pub(super) greatest: f64,
}

impl Carrier {
    #[inline(always)]
    pub(super) fn at(&self, time: f64, halves: DoubleDouble) -> [f64; 2] {
        times(self.start, phase_factor(self.drift * time + halves * self.step))
    }
}

/// Makes the rotations of the three numbers (`alpha`, `beta` and the spin across the axis) consistent. At the
/// lowest position of the axis, the spin across it is parallel to the vertical's part across it, `i
/// conj(alpha) beta` times a real number. So over each half period the spin turns as much as `conj(alpha)
/// beta`, except for half a turn from the signs of the theta functions (T18); otherwise the momentum about
/// the vertical would drift. The largest correction goes to the number with the most uncertain drift and the
/// least weight relative to `sizes`.
pub(super) fn turn_together(carriers: &mut [Carrier; 3], sizes: [f64; 3], half_periods: DoubleDouble) {
    let in_half_period = |k: usize| carriers[k].drift / half_periods + DoubleDouble::from(carriers[k].step);
    let [alpha, beta, across] = [0, 1, 2].map(in_half_period);
    let (_, off) = (beta - alpha - across - DoubleDouble::from(0.5)).split();
    let shares = [0, 1, 2].map(|k| carriers[k].terms * (sizes[k] / carriers[k].greatest)).map(|x| x * x);
    let total: f64 = shares.iter().sum();
    // Next to the separatrix, where rounding loses the zeros of the theta functions, the steps contain no
    // information; no time reaches the end of a half period there.
    if !(total > 0.0 && total.is_finite()) || off.abs() > 1e-9 {
        return;
    }
    for ((carrier, share), sign) in carriers.iter_mut().zip(shares).zip([1.0, -1.0, 1.0]) {
        carrier.drift = carrier.drift + half_periods * (sign * off * (share / total));
    }
}

/// Replaces the carrier of the number `weakest` by the one that follows from the other two, whose directions
/// at the start are more accurate. Next to a zero of its theta function, the direction of a number at the
/// start, or of the theta function, is only rounding. At the time `lowest`, at the lowest position of the
/// axis, the theta functions of the three numbers are positive multiples of `-i sense`, 1 and 1; `sign` is
/// the sign of the real number of [`turn_together`] times `-sense`.
pub(super) fn align_weakest(carriers: &mut [Carrier; 3], weakest: usize, sign: f64, lowest: f64) {
    let [alpha, beta, across] = carriers.map(|Carrier { start: [re, im], drift, .. }| {
        times([re, im].map(|x| x / hypot(re, im)), phase_factor(drift * lowest))
    });
    let there = match weakest {
        0 => times(beta, conjugate(across)),
        1 => times(alpha, across),
        _ => times(conjugate(alpha), beta),
    };
    let carrier = &mut carriers[weakest % 3];
    let length = sign * hypot(carrier.start[0], carrier.start[1]);
    carrier.start = times(there, phase_factor(-(carrier.drift * lowest))).map(|x| x * length);
}

/// The form in the nome.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Direct {
    first: bool,
    /// Polynomials in `cos 2z`.
    along_cos: [f64; 4],
    along_sin: [f64; 4],
}

/// `theta_4` in `cos 2z`.
pub(super) fn denominator(q: f64) -> [f64; 4] {
    let (q4, q9) = (powi(q, 4), powi(q, 9));
    [1.0 - 2.0 * q4, -2.0 * q + 6.0 * q9, 4.0 * q4, -8.0 * q9]
}

/// A cubic polynomial.
#[inline(always)]
pub(super) fn cubic(p: &[f64; 4], x: f64) -> f64 {
    (p[0] + p[1] * x) + (x * x) * (p[2] + p[3] * x)
}

/// `exp(-2B)`, that minus 1, `q exp(2B)`, and 1 minus the square of the third. Each is computed from another,
/// so that the product of the first and the third is `q`.
fn fall_and_rise(q: f64, [depth, rest]: [f64; 2]) -> [f64; 4] {
    if depth >= rest || q == 0.0 {
        let (fall, less) = exp_and_exp_m1(depth);
        let rise = if q == 0.0 { 0.0 } else { (q / fall).min(1.0) };
        return [fall, less, rise, 1.0 - rise * rise];
    }
    let rise = exp(rest);
    let fall = q / rise;
    [fall, fall - 1.0, rise, -exp_and_exp_m1(2.0 * rest).1]
}

impl Direct {
    /// The function and its carrier. `q` is the nome and `quarter` the quarter period; the phase advances by
    /// `turns` per unit of time, from the phase with the sine and cosine `start`.
    pub(super) fn new(
        q: f64,
        quarter: f64,
        turns: DoubleDouble,
        start: [f64; 2],
        shape: &Shape,
    ) -> (Self, Carrier) {
        let [fall, less, rise, left] = fall_and_rise(q, shape.depths.map(|depth| -PI * (depth / quarter)));
        let size = [1.0, rise * q, rise * rise * powi(q, 4), powi(rise, 3) * powi(q, 9)];
        let falls = [fall, powi(fall, 3), powi(fall, 5), powi(fall, 7)];
        let c = [0, 1, 2, 3].map(|n| size[n] * (1.0 + falls[n]));
        let mut s = [0, 1, 2, 3].map(|n| size[n] * (1.0 - falls[n]));
        s[0] = -less;
        // (T17) The rate of the argument with respect to the phase where it is largest, and 1 minus that.
        let odd = [1.0, 3.0, 5.0, 7.0];
        let total = c[0] + c[1] + c[2] + c[3];
        let (turning, rounded) = if fall > 0.5 {
            let turning = [0, 1, 2, 3].map(|n| odd[n] * s[n]).iter().sum::<f64>() / total;
            (DoubleDouble::from(turning), turning)
        } else {
            // Sums of pairs of terms that cancel where the zero is next to the pole.
            let r2 = rise * rise;
            let (once, twice) = (1.0 + r2, 1.0 + r2 + r2 * r2);
            let [f2, f3] = [fall * fall, falls[1]];
            let short = 2.0 * fall + 4.0 * (q * q) * f2 * once + 6.0 * powi(q, 6) * f3 * twice;
            let short = short * left / total;
            (DoubleDouble::ONE - DoubleDouble::from(short), short)
        };
        let rate = shape.rate / (DoubleDouble::PI * 2.0);
        let drift = rate - turns * turning * shape.sense;
        let terms = rate.hi().abs() + (turns.hi() * rounded).abs();
        let direct = Self {
            first: shape.first,
            along_cos: [
                c[0] - c[1] - c[2] + c[3],
                2.0 * c[1] - 2.0 * c[2] - 4.0 * c[3],
                4.0 * c[2] - 4.0 * c[3],
                8.0 * c[3],
            ],
            along_sin: [
                s[0] + s[1] - s[2] - s[3],
                2.0 * s[1] + 2.0 * s[2] - 4.0 * s[3],
                4.0 * s[2] + 4.0 * s[3],
                8.0 * s[3],
            ]
            .map(|x| x * shape.sense),
        };
        let largest = if shape.first { [1.0, 0.0] } else { [0.0, 1.0] };
        let c = if shape.first { -1.0 } else { 1.0 };
        let start = shape.fitting(direct.at(start), direct.at(largest), cubic(&denominator(q), c));
        (direct, Carrier { start, drift, step: 0.0, terms, greatest: shape.size })
    }

    /// Times `theta_4`, without its carrier; from sine and cosine of the phase.
    #[inline(always)]
    pub(super) fn at(&self, [sin, cos]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = if self.first { (-cos, sin) } else { (sin, cos) };
        let c = (cos - sin) * (cos + sin);
        [cos * cubic(&self.along_cos, c), sin * cubic(&self.along_sin, c)]
    }
}

/// The form in the complementary nome (T19).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Complementary {
    first: bool,
    /// Cosines and sines of the multiples of the zero's argument, with all constant factors.
    cos: [f64; 4],
    sin: [f64; 4],
    /// `1 - cos 2Y`.
    off_one: f64,
    /// The complementary nome.
    nome: f64,
}

/// `theta_4` over `exp X`.
#[inline(always)]
pub(super) fn complementary_denominator(nome: f64, exponentials: &Exponentials) -> f64 {
    let (e, r) = (exponentials.falling * exponentials.falling, exponentials.rising * exponentials.rising);
    let (p, cube) = (nome, e * e * e);
    let p3 = p * p * p;
    (1.0 + e) + p * r * ((1.0 + cube) + p3 * r * ((1.0 + e * e * cube) + p3 * p * p * r))
}

impl Complementary {
    /// The function and its carrier. `stretched = pi/(2K')`; the argument's own rate is `rate`.
    pub(super) fn new(
        nome: f64,
        stretched: f64,
        rate: DoubleDouble,
        start: &Exponentials,
        shape: &Shape,
    ) -> (Self, Carrier) {
        let [depth, rest] = shape.depths.map(|depth| stretched * depth);
        // The smaller has the smaller error.
        let near_pole = rest < depth;
        let (depth, rest) = if near_pole { (FRAC_PI_2 - rest, rest) } else { (depth, FRAC_PI_2 - depth) };
        let weights = if shape.first { [1.0, 3.0, 5.0, 7.0] } else { [0.0, 2.0, 4.0, 6.0] };
        // Sines and cosines of the multiples, with alternating signs.
        let signs = [1.0, -1.0, 1.0, -1.0];
        let waves = [0, 1, 2, 3].map(|n| match (near_pole, sin_cos(weights[n] * depth.min(rest))) {
            (false, (sin, cos)) => (signs[n] * sin, signs[n] * cos),
            (true, (sin, cos)) if shape.first => (cos, sin),
            (true, (sin, cos)) => (-sin, cos),
        });
        let sin_depth = if near_pole { sin_cos(rest).1 } else { sin_cos(depth).0 };
        let new = Self {
            first: shape.first,
            cos: waves.map(|(_, cos)| cos),
            sin: waves.map(|(sin, _)| -shape.sense * sin),
            off_one: 2.0 * sin_depth * sin_depth,
            nome,
        };
        let largest = if shape.first { Exponentials::at_saddle(nome) } else { Exponentials::at_flip(nome) };
        let denominator = complementary_denominator(nome, &largest);
        let turning = rate * (stretched * new.turning());
        let carrier = Carrier {
            start: shape.fitting(new.at(start), new.at(&largest), denominator),
            drift: (shape.rate - turning) / (DoubleDouble::PI * 2.0),
            step: shape.sense * if shape.first { -depth } else { rest } / PI,
            terms: shape.rate.hi().abs() + turning.hi().abs(),
            greatest: shape.size,
        };
        (new, carrier)
    }

    /// The rate of the argument with respect to `X` where it is largest.
    fn turning(&self) -> f64 {
        let p = self.nome;
        let powers = [1.0, p, powi(p, 4), powi(p, 9)];
        let sum = |f: &dyn Fn(usize) -> f64| [0, 1, 2, 3].map(f).iter().sum::<f64>();
        if self.first {
            let odd = [1.0, 3.0, 5.0, 7.0];
            let falls = [p, powi(p, 3), powi(p, 5), powi(p, 7)];
            let re = sum(&|n| powers[n] * self.cos[n] * (1.0 - falls[n]));
            let im = sum(&|n| powers[n] * self.sin[n] * (1.0 + falls[n]));
            let re_change = sum(&|n| odd[n] * powers[n] * self.cos[n] * (1.0 + falls[n]));
            let im_change = sum(&|n| odd[n] * powers[n] * self.sin[n] * (1.0 - falls[n]));
            return (re * im_change - im * re_change) / (re * re + im * im);
        }
        let even = [0.0, 4.0, 8.0, 12.0];
        let twice = [1.0, 2.0, 2.0, 2.0];
        sum(&|n| even[n] * powers[n] * self.sin[n]) / sum(&|n| twice[n] * powers[n] * self.cos[n])
    }

    /// Times `theta_4`, over `exp X`, without its carrier.
    #[inline(always)]
    pub(super) fn at(&self, exponentials: &Exponentials) -> [f64; 2] {
        let p = self.nome;
        let (e, r) = (exponentials.falling * exponentials.falling, exponentials.rising * exponentials.rising);
        let [from_flip, from_saddle] = exponentials.short_of_one;
        let (c, s) = (&self.cos, &self.sin);
        let (e2, p3) = (e * e, p * p * p);
        if self.first {
            let (cube, fifth) = (e * e2, e2 * e2 * e);
            let (first, second, third) = (p * r, p3 * r, p3 * p * p * r);
            let less = from_flip * c[0]
                + first
                    * (from_flip * (1.0 + e + e2) * c[1] + second * ((1.0 - fifth) * c[2] + third * c[3]));
            let more = (1.0 + e) * s[0]
                + first * ((1.0 + cube) * s[1] + second * ((1.0 + fifth) * s[2] + third * s[3]));
            return [exponentials.turn * exponentials.sign * less, exponentials.turn * more];
        }
        // 1 - r cos 2Y, with all its digits where both are small.
        let (pe, pe2) = (p * e, p * p * e2);
        let near = from_saddle + r * self.off_one + pe * c[1];
        let p2 = p * p;
        let re = near + p2 * ((r * r + pe2) * c[2] + p2 * p2 * r * r * r * c[3]);
        let im = (r - pe) * s[1] + p2 * ((r * r - pe2) * s[2] + p2 * p2 * r * r * r * s[3]);
        [exponentials.falling * re, exponentials.sign * exponentials.falling * im]
    }
}
