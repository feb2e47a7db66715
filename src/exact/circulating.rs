//! The motion of a body with three different moments, about its largest or smallest axis or between.

mod abreast;
mod neighbours;
mod way;

use crate::number::functions::{atan2, exp, sin_cos};
pub(super) use abreast::{Going, Lingering, LingeringTurn, Waving, WavingTurn};
pub(super) use neighbours::Halves;

use super::Regime;
use super::flips::Clock;
use super::klein::{self, HyperbolicPair, Pair, Shape, TrigonometricPair, phase};
use crate::dynamics::regime::Asymmetric;
use crate::error::Error;
use crate::exact::elliptic::{self, Hyperbolic, TURNING_RATIO, Trigonometric};
use crate::inertia::Axis;
use crate::number::Lane;
use crate::number::double_double::DoubleDouble;
use crate::number::power_of_two::times_power_of_two;
use core::f64::consts::{FRAC_PI_2, PI};
use nalgebra::{Quaternion, Vector3};
use way::Way;

/// All that an instant needs, in units where the largest spin is near 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Elliptic {
    /// Body indices of the axis across, the middle, the axis circled.
    axes: [usize; 3],
    /// Amplitudes of the spin along them, with their signs.
    amplitudes: [f64; 3],
    /// The same in rad/s where that is well within the range of `f64`, and otherwise with two powers of two each
    /// that take the three components to rad/s; together one would not do.
    grand: [f64; 3],
    unscale: [[f64; 2]; 3],
    /// The largest component that the spin ever has, rad/s.
    greatest: f64,
    form: Form,
    start: Pair,
    /// Turns of the common phase, which is half the angle about the momentum, per unit of time.
    drift: DoubleDouble,
    constants: Constants,
}

/// Up to this power of two the spin's components come out in one product with their amplitudes, with all digits: the rest of
/// the exponent's range is room for what is small beside the largest.
const ONE_PRODUCT: i32 = 600;

/// What belongs to the whole motion rather than to an instant, in the same units.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Constants {
    about: Axis,
    modulus: f64,
    complement: f64,
    /// The same times `2^shift`, and the powers of two taken into the three components: `[shift + lift, lift,
    /// shift]`. One of the two is 0.
    scaled_complement: f64,
    lifts: [i32; 3],
    /// With its sign, per unit of time.
    rate: DoubleDouble,
    /// Infinite on the separatrix.
    quarter: DoubleDouble,
    /// Jacobi's argument at the start.
    argument: DoubleDouble,
    /// The greatest share of the momentum along each of the three axes.
    shares: [f64; 3],
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Form {
    Trigonometric {
        spin: Trigonometric,
        pair: TrigonometricPair,
        /// Sine and cosine of the phase at the start, and turns of it per unit of time.
        start: [f64; 2],
        turns: DoubleDouble,
        turns_per_argument: f64,
    },
    Hyperbolic {
        spin: Hyperbolic,
        pair: HyperbolicPair,
        way: Way,
        /// Turns of the common phase at each half turn of Jacobi's argument.
        step: f64,
    },
}

impl Elliptic {
    /// Refuses a push so small beside the spin that no `f64` holds their ratio even when it is scaled up: 1e-570.
    pub(crate) fn new(motion: &Asymmetric, omega: &[f64; 3]) -> Result<Self, Error> {
        let (x, m, c) = (motion.across, motion.middle, motion.around);
        let i = motion.moments;
        let modulus = motion.modulus();
        let complement = motion.complement(0).hi();
        let quarter = motion.quarter_period();
        let other = elliptic::quarter_period(modulus);
        let ratio = if motion.separatrix { 0.0 } else { other / quarter.hi() };
        // What is small may be out of range beside what is not: near the saddle the across and the circled
        // component (with cn, dn and the complement), in a small wobble the across and the middle one.
        let wobbles = ratio >= TURNING_RATIO;
        let shift = if wobbles || motion.small > -200 { 0 } else { (-motion.small).min(1000) };
        let lift = if wobbles && motion.off_axis < -200 { -motion.off_axis } else { 0 };
        let [amplitude_x, amplitude_m, amplitude_c] = motion.amplitudes(lift);
        let scaled_complement = if shift == 0 { complement } else { motion.complement(shift).hi() };
        if !motion.separatrix && !wobbles && !scaled_complement.is_normal() {
            let what = "how close to the separatrix the motion is, as a complementary modulus,";
            return Err(Error::OutOfRange { what, value: complement });
        }
        let at_start = |axis: usize, up: i32| times_power_of_two(omega[axis], up - motion.clock);
        let [w_x, w_m, w_c] = [at_start(x, shift + lift), at_start(m, lift), at_start(c, shift)];
        let forward = w_c > 0.0;
        let cyclic = (x + 1) % 3 == m;
        let sign = if forward { 1.0 } else { -1.0 };
        let s = if cyclic { 1.0 } else { -1.0 };
        let direction = s * sign * if i[c] > i[m] { 1.0 } else { -1.0 };
        let rate = motion.rate() * direction;

        // The start: sn, and cn, dn times 2^shift.
        let [sn, cn, dn] = [w_m / amplitude_m.hi(), w_x / amplitude_x.hi(), w_c.abs() / amplitude_c.hi()];

        // L and 2E in the same units, and the momentum's greatest shares.
        let w = [0, 1, 2].map(|axis| times_power_of_two(omega[axis], -motion.clock));
        let sum = |f: &dyn Fn(usize) -> DoubleDouble| f(0) + f(1) + f(2);
        let twice_energy = sum(&|k| DoubleDouble::product(w[k], w[k]) * i[k]);
        let momentum = sum(&|k| DoubleDouble::product(w[k], w[k]) * DoubleDouble::product(i[k], i[k])).sqrt();
        let share_c = amplitude_c.hi() * i[c] / momentum.hi();
        let [share_x, share_m] = [(amplitude_x, x), (amplitude_m, m)]
            .map(|(amplitude, axis)| amplitude.scaled(-lift).hi() * i[axis] / momentum.hi());

        // The zero of the theta functions: y = rho^(-1/2) R_F((rho-1)/rho, (rho-1+m)/rho, 1).
        let [d_cx, d_cm, d_mx] = [motion.d_cx, motion.d_cm, motion.d_mx].map(DoubleDouble::hi);
        let over_rho = d_cm * i[x] / (d_cx * i[m]);
        let excess = d_mx * i[c] / (d_cx * i[m]);
        let depth = over_rho.sqrt()
            * elliptic::rf_of_roots(excess.sqrt(), (excess + modulus * modulus * over_rho).sqrt(), 1.0);

        let tilt = share_m / (1.0 + share_c * complement);
        let tau = DoubleDouble::PI * 2.0;
        let (mut form, drift) = if wobbles {
            let shape = Shape { cyclic, forward, tilt, depth: PI * depth / quarter.hi() };
            let q = exp(-PI * ratio);
            let pair = TrigonometricPair::new(q, &shape);
            let turns = rate / (quarter * 4.0);
            // Steady rate: that of the smooth phase about L where the across component is largest, less what
            // the theta function turns there.
            let about = (twice_energy + momentum * amplitude_c) / (momentum + amplitude_c * i[c]) * sign;
            let drift = about * 0.5 / tau - turns * pair.turning_at_zero();
            let start = phase_at_start(sn, cn, dn, complement, quarter.hi());
            let form = Form::Trigonometric {
                spin: Trigonometric::new(q),
                pair,
                start,
                turns,
                turns_per_argument: 0.25 / quarter.hi(),
            };
            (form, drift)
        } else {
            let shape = Shape { cyclic, forward, tilt, depth: PI * depth / (4.0 * other) };
            let p = if motion.separatrix { 0.0 } else { exp(-FRAC_PI_2 / ratio) };
            let pair = HyperbolicPair::new(p, &shape);
            let stretch = PI / (2.0 * other);
            let (angle, turning) = pair.angle_and_turning_at_middle();
            // At the saddle the rate is L/I_M but for terms that vanish with the complement.
            let slow = amplitude_c.hi() * complement;
            let lead = momentum / DoubleDouble::from(i[m]);
            let side = if i[c] > i[m] { 1.0 } else { -1.0 };
            let signed_distance = side * motion.distance_from_separatrix();
            let l = momentum.hi();
            let rest = -(signed_distance + l * slow * (i[c] - i[m])) / (i[m] * (l + i[c] * slow));
            let about = (lead + DoubleDouble::from(rest)) * sign;
            let drift = (about * 0.5 - rate * (stretch * turning)) / tau;
            let way = Way {
                start: argument_at_start(sn, cn, dn, scaled_complement, quarter, shift),
                rate: if motion.separatrix { rate } else { rate / (quarter * 2.0) },
                quarter,
                half: quarter * 2.0,
                stretch,
                nome_root: p,
                turn: if cn < 0.0 { -1.0 } else { 1.0 },
            };
            let spin = Hyperbolic::new(p * p, scaled_complement, shift);
            (Form::Hyperbolic { spin, pair, way, step: 2.0 * angle / (2.0 * PI) }, drift)
        };
        let mut amplitudes = [amplitude_x.hi(), amplitude_m.hi(), sign * amplitude_c.hi()];
        form.meet_the_start(&mut amplitudes, [w_x, w_m, w_c], modulus);
        let (start, argument) = (form.start(), form.argument());
        let lifts = [shift + lift, lift, shift];
        let within = lifts == [0; 3] && motion.clock.abs() <= ONE_PRODUCT;
        let grand = amplitudes.map(|x| if within { times_power_of_two(x, motion.clock) } else { x });
        let unscale = lifts.map(|up| {
            let total = if within { 0 } else { motion.clock - up };
            let part = if total < -900 { 600 } else { 0 };
            [times_power_of_two(1.0, total + part), times_power_of_two(1.0, -part)]
        });
        let top = |amplitude: DoubleDouble, up: i32| times_power_of_two(amplitude.hi(), motion.clock - up);
        let greatest = top(amplitude_x, lift).max(top(amplitude_m, lift)).max(top(amplitude_c, 0));
        Ok(Self {
            axes: [x, m, c],
            amplitudes,
            grand,
            unscale,
            greatest,
            form,
            start,
            drift,
            constants: Constants {
                about: if i[c] > i[m] { Axis::Largest } else { Axis::Smallest },
                modulus,
                complement,
                scaled_complement,
                lifts,
                rate,
                quarter,
                argument,
                shares: [share_x, share_m, share_c],
            },
        })
    }

    pub(crate) fn regime(&self, per_second: impl Fn(f64) -> f64) -> Regime {
        let Constants { about, modulus, complement, rate, quarter, .. } = self.constants;
        let rate = per_second(rate.hi().abs());
        if quarter.hi().is_infinite() {
            return Regime::Separatrix { rate };
        }
        Regime::Circulating { about, modulus, complement, rate }
    }

    /// Index of the axis circled.
    pub(crate) fn around(&self) -> usize {
        self.axes[2]
    }

    pub(crate) fn greatest_spin(&self) -> f64 {
        self.greatest
    }

    /// Half the spin's period, in scaled time.
    pub(crate) fn half_period(&self) -> Option<f64> {
        let Constants { rate, quarter, .. } = self.constants;
        quarter.hi().is_finite().then(|| (quarter * 2.0 / rate.abs()).hi())
    }

    pub(crate) fn clock(&self) -> Clock {
        let Constants { rate, quarter, argument, .. } = self.constants;
        if quarter.hi().is_infinite() {
            return Clock::Once(-argument / rate);
        }
        Clock::Evenly { offset: argument / (quarter * 2.0), rate: rate / (quarter * 2.0) }
    }

    /// Least and greatest angle between a principal axis and the momentum.
    pub(crate) fn angles(&self, axis: usize) -> [f64; 2] {
        let [across, middle, around] = self.constants.shares;
        let least = around * self.constants.complement;
        let swing = |angle: f64| [angle, PI - angle];
        if axis == self.axes[0] {
            swing(atan2(around, across))
        } else if axis == self.axes[1] {
            swing(atan2(least, middle))
        } else {
            let [near, far] = [atan2(across, around), atan2(middle, least)];
            if self.amplitudes[2] > 0.0 { [near, far] } else { [PI - far, PI - near] }
        }
    }

    /// Radians about the momentum from one flip to the next.
    pub(crate) fn twist_of_half_period(&self) -> Option<f64> {
        let half = self.half_period()?;
        let step = match &self.form {
            Form::Trigonometric { .. } => 0.0,
            Form::Hyperbolic { step, .. } => step * self.constants.rate.hi().signum(),
        };
        Some((4.0 * PI * (self.drift.hi() * half + step)).abs())
    }

    #[inline(always)]
    fn spin(&self, [sn, cn, dn]: [f64; 3]) -> Vector3<f64> {
        let unscaled = |k: usize, w: f64| self.grand[k] * w * self.unscale[k][0] * self.unscale[k][1];
        let [across, middle, around] = [unscaled(0, cn), unscaled(1, sn), unscaled(2, dn)];
        let [x, m, c] = self.axes;
        let cyclic = m == (x + 1) % 3;
        let (next, last) = if cyclic { (across, middle) } else { (middle, across) };
        arranged(c, [around, next, last]).into()
    }

    /// The turn since the start, from its parts along the circled axis and the next two.
    #[inline(always)]
    fn turn(&self, [real, i, j, k]: [f64; 4]) -> Quaternion<f64> {
        let [x, y, z] = arranged(self.axes[2], [i, j, k]);
        klein::quaternion(klein::unit([real, x, y, z]))
    }

    /// The spin at scaled time `time`.
    pub(crate) fn omega(&self, time: f64) -> Vector3<f64> {
        match &self.form {
            Form::Trigonometric { spin, start, turns, .. } => {
                let (sin, cos) = advanced(start, *turns * time);
                self.spin(spin.values(sin, cos))
            }
            Form::Hyperbolic { spin, way, .. } => self.spin(way.at(time).values(spin)),
        }
    }

    /// Spin and attitude at scaled time `time`.
    pub(crate) fn at(&self, time: f64) -> (Vector3<f64>, Quaternion<f64>) {
        match &self.form {
            Form::Trigonometric { spin, pair, start, turns, .. } => {
                self.waving(spin, pair, start, turns, time)
            }
            Form::Hyperbolic { spin, pair, way, step } => self.lingering(spin, pair, way, *step, time),
        }
    }

    // Inlined: an eighth of the time of an instant.
    #[inline(always)]
    fn waving(
        &self,
        spin: &Trigonometric,
        pair: &TrigonometricPair,
        start: &[f64; 2],
        turns: &DoubleDouble,
        time: f64,
    ) -> (Vector3<f64>, Quaternion<f64>) {
        let (sin, cos) = advanced(start, *turns * time);
        let turned = pair.raw(sin, cos).turned(phase(drifted(self.drift, time, DoubleDouble::ZERO)));
        (self.spin(spin.values(sin, cos)), self.turn(turned.since(&self.start)))
    }

    #[inline(always)]
    fn lingering(
        &self,
        spin: &Hyperbolic,
        pair: &HyperbolicPair,
        way: &Way,
        step: f64,
        time: f64,
    ) -> (Vector3<f64>, Quaternion<f64>) {
        let place = way.at(time);
        let extra = DoubleDouble::product(place.halves, step);
        let turned = place.pair(pair).turned(phase(drifted(self.drift, time, extra)));
        (self.spin(place.values(spin)), self.turn(turned.since(&self.start)))
    }

    /// The attitude alone.
    pub(crate) fn attitude(&self, time: f64) -> Quaternion<f64> {
        let (pair, extra) = match &self.form {
            Form::Trigonometric { pair, start, turns, .. } => {
                let (sin, cos) = advanced(start, *turns * time);
                (pair.raw(sin, cos), DoubleDouble::ZERO)
            }
            Form::Hyperbolic { pair, way, step, .. } => {
                let place = way.at(time);
                (place.pair(pair), DoubleDouble::product(place.halves, *step))
            }
        };
        self.turn(pair.turned(phase(drifted(self.drift, time, extra))).since(&self.start))
    }
}

impl Form {
    /// Shifts the phase and scales the amplitudes, by roundings, so that the start comes out as it was given.
    ///
    /// Of the relative errors of the across and middle components, what they differ by is the phase's; what they
    /// share, weighed so that the one near zero does not count, is the amplitude's.
    fn meet_the_start(&mut self, amplitudes: &mut [f64; 3], omega: [f64; 3], modulus: f64) {
        let values = self.values_at_start();
        let found = [values.cn, values.sn, values.dn];
        let off = [0, 1, 2].map(|k| {
            let off = amplitudes[k] * found[k] / omega[k] - 1.0;
            if off.abs() < 1e-6 { off } else { 0.0 }
        });
        let square = values.sn * values.sn;
        let shared = off[1] * square + off[0] * (1.0 - square);
        let quotient = values.sn * (values.cn / values.dn);
        let shift = (off[1] - off[0]) * quotient;
        amplitudes[0] *= 1.0 - shared;
        amplitudes[1] *= 1.0 - shared;
        amplitudes[2] *= 1.0 - (off[2] + shift * modulus * modulus * quotient);
        match self {
            Self::Trigonometric { start: [sin, cos], turns_per_argument, .. } => {
                let angle = 2.0 * PI * *turns_per_argument * shift;
                (*sin, *cos) = (*sin - *cos * angle, *cos + *sin * angle);
            }
            Self::Hyperbolic { way, .. } => way.start = way.start - DoubleDouble::from(shift),
        }
    }

    fn values_at_start(&self) -> elliptic::Values {
        match self {
            Self::Trigonometric { spin, start: [sin, cos], .. } => spin.at(*sin, *cos),
            Self::Hyperbolic { spin, way, .. } => way.at(0.0).spin(spin),
        }
    }

    /// Jacobi's argument at the start.
    fn argument(&self) -> DoubleDouble {
        match self {
            Self::Trigonometric { start: [sin, cos], turns_per_argument, .. } => {
                DoubleDouble::from(atan2(*sin, *cos) / (2.0 * PI * turns_per_argument))
            }
            Self::Hyperbolic { way, .. } => way.start,
        }
    }

    /// The attitude's two complex numbers at the start, of length 1.
    fn start(&self) -> Pair {
        let raw = match self {
            Self::Trigonometric { pair, start: [sin, cos], .. } => pair.raw(*sin, *cos),
            Self::Hyperbolic { pair, way, .. } => way.at(0.0).pair(pair),
        };
        raw.scaled(1.0 / raw.length())
    }
}

/// In the order of the body, from that which begins with axis number `axis`.
#[inline(always)]
fn arranged(axis: usize, [first, second, third]: [f64; 3]) -> [f64; 3] {
    // Not by an index: what goes through memory one by one is slow to come back together.
    match axis {
        0 => [first, second, third],
        1 => [third, first, second],
        _ => [second, third, first],
    }
}

/// Sine and cosine of the start's phase moved on by some turns.
#[inline(always)]
fn advanced<T: Lane>(start: &[T; 2], turns: DoubleDouble<T>) -> (T, T) {
    let (sin, cos) = elliptic::sin_cos_of_turns(turns);
    let [sin0, cos0] = *start;
    (sin0 * cos + cos0 * sin, cos0 * cos - sin0 * sin)
}

/// The common phase at a time, in turns, with what the half turns have added.
#[inline(always)]
fn drifted<T: Lane>(drift: DoubleDouble<T>, time: T, extra: DoubleDouble<T>) -> DoubleDouble<T> {
    drift * time + extra
}

/// Sine and cosine of the phase `pi u/(2K)` at the start; from whichever end is nearer, so that both keep
/// their digits.
fn phase_at_start(sn: f64, cn: f64, dn: f64, complement: f64, quarter: f64) -> [f64; 2] {
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
fn argument_at_start(
    sn: f64,
    cn: f64,
    dn: f64,
    complement: f64,
    quarter: DoubleDouble,
    shift: i32,
) -> DoubleDouble {
    let folded = if cn < 0.0 { -sn } else { sn };
    let cn = cn.abs();
    let [true_cn, true_dn] = [cn, dn].map(|x| times_power_of_two(x, -shift));
    let near = sn.abs() <= true_cn || quarter.hi().is_infinite();
    let size = if near {
        DoubleDouble::from(sn.abs() * elliptic::rf_of_roots(true_cn, true_dn, 1.0))
    } else {
        let root = complement / dn;
        quarter - DoubleDouble::from(cn / dn * elliptic::rf_of_roots(root * sn.abs(), root, 1.0))
    };
    if folded < 0.0 { -size } else { size }
}
