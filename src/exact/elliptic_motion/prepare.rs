//! The constants of an elliptic motion, from what stays the same in it and the spin at the start.

use super::axes::Axes;
use super::range_reduction::Reduction;
use super::{ComplementaryAttitude, ComplementarySpin, Constants, DirectAttitude, DirectSpin};
use super::{EllipticMotion, Form};
use crate::dynamics::invariants::Asymmetric;
use crate::error::{Error, Refusal, Subject};
use crate::exact::cayley_klein::{ComplementaryPair, DirectPair, Pair, Shape};
use crate::exact::elliptic::{self, ComplementarySeries, DirectSeries, NOME_RATIO};
use crate::exact::period::quarter_period;
use crate::inertia::Axis;
use crate::number::double_double::DoubleDouble;
use crate::number::functions::{atan2, exp, sin_cos};
use crate::number::power_of_two::times_power_of_two;
use core::f64::consts::{FRAC_PI_2, PI};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Up to this power of two the spin's components come out in one product with their amplitudes, with all
/// digits: the rest of the exponent's range is room for what is small relative to the largest.
const ONE_PRODUCT: i32 = 600;

/// The motion in scaled units: everything that both series are prepared from. Triples go across, middle,
/// circled.
struct Preparation<'a> {
    motion: &'a Asymmetric,
    modulus: f64,
    complement: f64,
    /// `K`, and `K'`.
    quarter: DoubleDouble,
    other: f64,
    direct: bool,
    /// Powers of two taken into cn, dn and the complement, and into sn and cn.
    shift: i32,
    lift: i32,
    scaled_complement: f64,
    /// The first two times `2^lift`.
    amplitudes: [DoubleDouble; 3],
    /// The spin at the start, in the units of the series.
    omega: [f64; 3],
    /// The rate of Jacobi's argument, with its sign.
    rate: DoubleDouble,
    /// 1 where the spin along the circled axis is positive, otherwise -1.
    sign: f64,
    /// Whether across, middle and circled follow each other in cyclic order.
    cyclic: bool,
    /// `2E` and `L`.
    twice_energy: DoubleDouble,
    momentum: DoubleDouble,
}

/// What both series have in common.
struct Prepared {
    form: Form,
    argument: DoubleDouble,
    /// Corrected so that the start comes out as it was given.
    amplitudes: [f64; 3],
}

impl EllipticMotion {
    /// Refuses a push so small relative to the spin that no `f64` holds their ratio even when it is scaled
    /// up: 1e-570.
    pub(crate) fn new(motion: &Asymmetric, omega: &[f64; 3]) -> Result<Self, Error> {
        let preparation = Preparation::new(motion, omega)?;
        let Preparation { modulus, complement, scaled_complement, quarter, rate, .. } = preparation;
        let shares = preparation.shares();
        let Prepared { form, argument, amplitudes } =
            if preparation.direct { preparation.direct(shares) } else { preparation.complementary(shares) };
        let about = if motion.moments[motion.around] > motion.moments[motion.middle] {
            Axis::Largest
        } else {
            Axis::Smallest
        };
        let lifts = preparation.lifts();
        Ok(Self {
            axes: preparation.axes(),
            amplitudes,
            unscale: preparation.unscale(),
            greatest: preparation.greatest(),
            form,
            constants: Constants {
                about,
                modulus,
                complement,
                scaled_complement,
                lifts,
                rate,
                quarter,
                argument,
                shares,
            },
        })
    }
}

impl<'a> Preparation<'a> {
    fn new(motion: &'a Asymmetric, omega: &[f64; 3]) -> Result<Self, Error> {
        // (C4)
        let modulus = motion.modulus();
        let complement = motion.complement(0).hi();
        // (C8)
        let quarter = quarter_period(motion);
        let other = elliptic::quarter_period(modulus);
        let direct = !motion.separatrix && other / quarter.hi() >= NOME_RATIO;
        // What is small may be out of range relative to what is not: near the saddle the across and the
        // circled component (with cn, dn and the complement), in a small libration the across and the middle
        // one.
        let shift = if direct || motion.small > -200 { 0 } else { (-motion.small).min(1000) };
        let lift = if direct && motion.off_axis < -200 { -motion.off_axis } else { 0 };
        let scaled_complement = if shift == 0 { complement } else { motion.complement(shift).hi() };
        if !motion.separatrix && !direct && !scaled_complement.is_normal() {
            let what = Subject::ComplementaryModulus;
            return Err(Refusal::OutOfRange { what, value: complement }.into());
        }
        let at_start = |axis: usize, up: i32| times_power_of_two(omega[axis], up - motion.clock);
        let (x, m, c) = (motion.across, motion.middle, motion.around);
        let spin = [at_start(x, shift + lift), at_start(m, lift), at_start(c, shift)];
        let i = motion.moments;
        let sign = if spin[2] > 0.0 { 1.0 } else { -1.0 };
        let cyclic = (x + 1) % 3 == m;
        let direction = if cyclic { 1.0 } else { -1.0 } * sign * if i[c] > i[m] { 1.0 } else { -1.0 };
        // L and 2E in the same units.
        let w = [0, 1, 2].map(|axis| at_start(axis, 0));
        let sum = |f: &dyn Fn(usize) -> DoubleDouble| f(0) + f(1) + f(2);
        let square = |k: usize| DoubleDouble::product(w[k], w[k]);
        Ok(Self {
            motion,
            modulus,
            complement,
            quarter,
            other,
            direct,
            shift,
            lift,
            scaled_complement,
            // (C5), by the sums of (C3)
            amplitudes: motion.amplitudes(lift),
            omega: spin,
            // (C6), with its sign
            rate: motion.rate() * direction,
            sign,
            cyclic,
            // (C1)
            twice_energy: sum(&|k| square(k) * i[k]),
            momentum: sum(&|k| square(k) * DoubleDouble::product(i[k], i[k])).sqrt(),
        })
    }

    fn axes(&self) -> [usize; 3] {
        [self.motion.across, self.motion.middle, self.motion.around]
    }

    /// The three moments.
    fn moments(&self) -> [f64; 3] {
        self.axes().map(|axis| self.motion.moments[axis])
    }

    /// The powers of two taken into the three components.
    fn lifts(&self) -> [i32; 3] {
        [self.shift + self.lift, self.lift, self.shift]
    }

    /// The momentum's greatest shares.
    fn shares(&self) -> [f64; 3] {
        // (C17)
        let [across, middle, circled] = self.amplitudes;
        let [i_x, i_m, i_c] = self.moments();
        let momentum = self.momentum.hi();
        let share =
            |amplitude: DoubleDouble, moment: f64| amplitude.scaled(-self.lift).hi() * moment / momentum;
        [share(across, i_x), share(middle, i_m), circled.hi() * i_c / momentum]
    }

    /// The largest component that the spin ever has, rad/s.
    fn greatest(&self) -> f64 {
        let top = |k: usize, up: i32| times_power_of_two(self.amplitudes[k].hi(), self.motion.clock - up);
        top(0, self.lift).max(top(1, self.lift)).max(top(2, 0))
    }

    /// Whether the amplitudes can be in rad/s.
    fn within_range(&self) -> bool {
        self.lifts() == [0; 3] && self.motion.clock.abs() <= ONE_PRODUCT
    }

    /// The powers of two that take the three components, in the order of the body, to rad/s if the amplitudes
    /// are not.
    fn unscale(&self) -> Option<[[f64; 2]; 3]> {
        if self.within_range() {
            return None;
        }
        let mut powers = [[1.0; 2]; 3];
        for (axis, up) in self.axes().into_iter().zip(self.lifts()) {
            let total = self.motion.clock - up;
            let part = if total < -900 { 600 } else { 0 };
            powers[axis] = [times_power_of_two(1.0, total + part), times_power_of_two(1.0, -part)];
        }
        Some(powers)
    }

    /// The amplitudes as the series take them: in rad/s where that is within range.
    fn in_series(&self, amplitudes: [f64; 3]) -> [f64; 3] {
        let clock = if self.within_range() { self.motion.clock } else { 0 };
        amplitudes.map(|x| times_power_of_two(x, clock))
    }

    /// `sn`, and `cn`, `dn` times `2^shift`, at the start.
    fn values(&self) -> [f64; 3] {
        let [w_x, w_m, w_c] = self.omega;
        let [across, middle, circled] = self.amplitudes.map(DoubleDouble::hi);
        // (C10)
        [w_m / middle, w_x / across, w_c.abs() / circled]
    }

    /// What the attitude's theta functions are made from, with their zero at `depth` per argument.
    fn shape(&self, shares: [f64; 3], per_argument: f64) -> Shape {
        let Asymmetric { d_cx, d_cm, d_mx, .. } = self.motion;
        let [d_cx, d_cm, d_mx] = [d_cx, d_cm, d_mx].map(|d| d.hi());
        let [i_x, i_m, i_c] = self.moments();
        // (C18)
        // The zero: y = rho^(-1/2) R_F((rho-1)/rho, (rho-1+m)/rho, 1).
        let over_rho = d_cm * i_x / (d_cx * i_m);
        let excess = d_mx * i_c / (d_cx * i_m);
        let shifted = (excess + self.modulus * self.modulus * over_rho).sqrt();
        // (C19)
        let depth = over_rho.sqrt() * elliptic::rf_of_roots(excess.sqrt(), shifted, 1.0);
        Shape {
            cyclic: self.cyclic,
            forward: self.sign > 0.0,
            // (C24)
            tilt: shares[1] / (1.0 + shares[2] * self.complement),
            // (C21), (C31)
            depth: PI * depth / per_argument,
        }
    }

    /// By the series of the nome.
    fn direct(&self, shares: [f64; 3]) -> Prepared {
        let quarter = self.quarter.hi();
        // (C9)
        let exponent = -PI * (self.other / quarter);
        let nome = exp(exponent);
        let series = DirectSeries::new(nome);
        let pair = DirectPair::new(nome, &self.shape(shares, quarter));
        // (C13)
        let turns = self.rate / (self.quarter * 4.0);
        let turns_per_argument = 0.25 / quarter;
        let [sin, cos] = phase_at_start(self.values(), self.complement, quarter);
        let (amplitudes, shift) = self.meeting_the_start(series.values(sin, cos));
        let angle = 2.0 * PI * turns_per_argument * shift;
        let start @ [sin, cos] = [sin - cos * angle, cos + sin * angle];
        // Steady rate: that of the smooth phase about L where the across component is largest, less what
        // the theta function turns there.
        let (circled, [_, _, i_c]) = (self.amplitudes[2], self.moments());
        // (C20)
        let about = (self.twice_energy + self.momentum * circled) / (self.momentum + circled * i_c);
        // (C25)
        let drift = about * self.sign * 0.5 / (DoubleDouble::PI * 2.0) - turns * pair.turning_at_zero();
        let amplitudes_in_series = self.in_series(amplitudes);
        let axes = Axes::new(self.axes());
        let spin = DirectSpin { series, start, turns, amplitudes: amplitudes_in_series, axes };
        let attitude = DirectAttitude { pair, start: of_length_one(pair.raw(sin, cos)), drift };
        // From the nearest flip, where it has all its digits.
        let angle = atan2(sin, cos.abs());
        let argument = DoubleDouble::from(angle.copysign(sin * cos) / (2.0 * PI * turns_per_argument));
        Prepared { form: Form::Direct { spin, attitude }, argument, amplitudes }
    }

    /// By the series of the complementary nome.
    fn complementary(&self, shares: [f64; 3]) -> Prepared {
        let Self { rate, quarter, other, .. } = *self;
        let values = self.values();
        let start = argument_at_start(values, self.scaled_complement, quarter, self.shift);
        let turn = if values[1] < 0.0 { -1.0 } else { 1.0 };
        // (C27)
        let mut reduction = Reduction::new(start, rate, quarter, other, turn);
        let Reduction { nome_root, stretch, .. } = reduction;
        let series = ComplementarySeries::new(nome_root * nome_root, self.scaled_complement, self.shift);
        let pair = ComplementaryPair::new(nome_root, &self.shape(shares, 4.0 * other));
        let (angle, turning) = pair.angle_and_turning_at_saddle();
        let (amplitudes, shift) = self.meeting_the_start(reduction.argument(0.0).values(&series));
        reduction.start = reduction.start - DoubleDouble::from(shift);
        let start = of_length_one(reduction.argument(0.0).pair(&pair));
        let drift =
            (self.rate_about_momentum() * 0.5 - rate * (stretch * turning)) / (DoubleDouble::PI * 2.0);
        let axes = Axes::new(self.axes());
        let spin = ComplementarySpin { series, reduction, amplitudes: self.in_series(amplitudes), axes };
        // (C33)
        let attitude = ComplementaryAttitude { pair, start, drift, step: 2.0 * angle / (2.0 * PI) };
        Prepared { form: Form::Complementary { spin, attitude }, argument: reduction.start, amplitudes }
    }

    /// How fast the smooth phase about the momentum runs at the saddle: as `L/I_M` but for terms that vanish
    /// with the complement.
    fn rate_about_momentum(&self) -> DoubleDouble {
        let [_, i_m, i_c] = self.moments();
        let slow = self.amplitudes[2].hi() * self.complement;
        let lead = self.momentum / DoubleDouble::from(i_m);
        // (C34), with the discriminant of (C2)
        let sign = if i_c > i_m { 1.0 } else { -1.0 };
        let signed_distance = sign * self.motion.distance_from_separatrix();
        let l = self.momentum.hi();
        let rest = -(signed_distance + l * slow * (i_c - i_m)) / (i_m * (l + i_c * slow));
        (lead + DoubleDouble::from(rest)) * self.sign
    }

    /// The amplitudes scaled, and Jacobi's argument at the start shifted back, by roundings, so that the
    /// start comes out as it was given; from the functions as the series give them there.
    ///
    /// Of the relative errors of the across and middle components, what they differ by is the phase's; what
    /// they share, weighed so that the one near zero does not count, is the amplitude's.
    fn meeting_the_start(&self, [sn, cn, dn]: [f64; 3]) -> ([f64; 3], f64) {
        let [across, middle, circled] = self.amplitudes.map(DoubleDouble::hi);
        let mut amplitudes = [across, middle, self.sign * circled];
        let found = [cn, sn, dn];
        let off = [0, 1, 2].map(|k| {
            let off = amplitudes[k] * found[k] / self.omega[k] - 1.0;
            if off.abs() < 1e-6 { off } else { 0.0 }
        });
        // (C12)
        let square = sn * sn;
        let shared = off[1] * square + off[0] * (1.0 - square);
        let quotient = sn * (cn / dn);
        let shift = (off[1] - off[0]) * quotient;
        amplitudes[0] *= 1.0 - shared;
        amplitudes[1] *= 1.0 - shared;
        amplitudes[2] *= 1.0 - (off[2] + shift * self.modulus * self.modulus * quotient);
        (amplitudes, shift)
    }
}

fn of_length_one(pair: Pair) -> Pair {
    pair.scaled(1.0 / pair.length())
}

/// Sine and cosine of the phase `pi u/(2K)` at the start; from whichever end is nearer, so that both keep
/// their digits.
pub(crate) fn phase_at_start([sn, cn, dn]: [f64; 3], complement: f64, quarter: f64) -> [f64; 2] {
    // (C11)
    let (sin, cos) = if sn.abs() <= cn.abs() {
        let u = sn.abs() * elliptic::rf_of_roots(cn.abs(), dn, 1.0);
        sin_cos(FRAC_PI_2 * u / quarter)
    } else {
        let u = cn.abs() * elliptic::rf_of_roots(complement * sn.abs(), complement, dn);
        let (cos, sin) = sin_cos(FRAC_PI_2 * u / quarter);
        (sin, cos)
    };
    [sin.copysign(sn), cos.copysign(cn)]
}

/// Jacobi's argument at the start, between the saddles (`cn` taken as positive); `cn`, `dn` and the
/// complement are times `2^shift`.
pub(crate) fn argument_at_start(
    [sn, cn, dn]: [f64; 3],
    complement: f64,
    quarter: DoubleDouble,
    shift: i32,
) -> DoubleDouble {
    let from_flip = if cn < 0.0 { -sn } else { sn };
    let cn = cn.abs();
    let [true_cn, true_dn] = [cn, dn].map(|x| times_power_of_two(x, -shift));
    // (C11)
    let near = sn.abs() <= true_cn || quarter.hi().is_infinite();
    let size = if near {
        DoubleDouble::from(sn.abs() * elliptic::rf_of_roots(true_cn, true_dn, 1.0))
    } else {
        let root = complement / dn;
        quarter - DoubleDouble::from(cn / dn * elliptic::rf_of_roots(root * sn.abs(), root, 1.0))
    };
    if from_flip < 0.0 { -size } else { size }
}
