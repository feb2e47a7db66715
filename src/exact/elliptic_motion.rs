//! The motion of a body with three different moments, about the axis of its largest or smallest moment, or on
//! the separatrix: Jacobi's elliptic functions.

mod instant;
mod prepare;
mod range_reduction;
mod variations;

pub(super) use instant::{ComplementaryAttitude, ComplementarySpin, DirectAttitude, DirectSpin};
pub(super) use prepare::{argument_at_start, phase_at_start};
pub(super) use range_reduction::{Exponentials, Reduction};

use super::Regime;
use super::elementary::Kernel;
use super::flips::Clock;
use crate::inertia::Axis;
use crate::number::functions::atan2;
use crate::number::{DoubleDouble, Real, splat};
use core::f64::consts::PI;
use nalgebra::{Quaternion, Vector3};

/// The constants needed at an instant, in units where the largest spin is near 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EllipticMotion<T = f64> {
    /// Body indices of the axis across, the middle, the axis circled.
    pub(super) axes: [usize; 3],
    /// Amplitudes of the spin along them, with their signs.
    amplitudes: [T; 3],
    /// Two powers of two for each component of the body that take it to rad/s, where the spin is not well
    /// within the range of `f64`; together one would not do.
    unscale: Option<[[T; 2]; 3]>,
    /// The largest component that the spin ever has, rad/s.
    pub(super) greatest: T,
    form: Form<T>,
    constants: Constants<T>,
}

/// The series by which the motion is summed.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Form<T = f64> {
    /// A series in the nome.
    Direct { spin: DirectSpin<T>, attitude: DirectAttitude<T> },
    /// A series in the complementary nome, which is zero on the separatrix, where the motion does not return.
    Complementary { spin: ComplementarySpin<T>, attitude: ComplementaryAttitude<T> },
}

/// Constants of the whole motion that are not needed at an instant, in the same units.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Constants<T = f64> {
    about: Axis,
    modulus: T,
    complement: T,
    /// The complement times `2^shift`, and the powers of two taken into the three components: `[shift +
    /// lift, lift, shift]`. One of the two is 0.
    scaled_complement: T,
    lifts: [i32; 3],
    /// With its sign, per unit of time.
    rate: DoubleDouble<T>,
    /// `K`, infinite on the separatrix.
    quarter: DoubleDouble<T>,
    /// Jacobi's argument at the start, from the nearest flip.
    argument: DoubleDouble<T>,
    /// The greatest share of the momentum along each of the three axes.
    shares: [T; 3],
}

impl EllipticMotion {
    pub(crate) fn regime(&self, per_second: impl Fn(f64) -> f64) -> Regime {
        let Constants { about, modulus, complement, rate, .. } = self.constants;
        let rate = per_second(rate.hi().abs());
        if self.returns() {
            Regime::Elliptic { about, modulus, complement, rate }
        } else {
            Regime::Separatrix { rate }
        }
    }

    pub(crate) fn modulus(&self) -> f64 {
        self.constants.modulus
    }

    /// Half the spin's period, in scaled time.
    pub(crate) fn half_period(&self) -> Option<f64> {
        self.returns().then(|| self.span_of_half_period())
    }

    pub(crate) fn clock(&self) -> Clock {
        let Constants { rate, quarter, argument, .. } = self.constants;
        if !self.returns() {
            return Clock::Once(-argument / rate);
        }
        // (C36)
        let half = quarter.times_exact(2.0);
        Clock::Evenly { offset: argument / half, rate: rate / half }
    }

    /// Least and greatest angle between a principal axis and the momentum.
    pub(crate) fn angles(&self, axis: usize) -> [f64; 2] {
        let [across, middle, around] = self.constants.shares;
        let least = around * self.constants.complement;
        let around_a_right_angle = |angle: f64| [angle, PI - angle];
        if axis == self.axes[0] {
            around_a_right_angle(atan2(around, across))
        } else if axis == self.axes[1] {
            around_a_right_angle(atan2(least, middle))
        } else {
            let [a, b] = [atan2(across, around), atan2(middle, least)];
            if self.amplitudes[2] > 0.0 { [a, b] } else { [PI - b, PI - a] }
        }
    }

    /// Radians about the momentum from one flip to the next.
    pub(crate) fn twist_of_half_period(&self) -> Option<f64> {
        let half = self.half_period()?;
        let (drift, step) = match &self.form {
            Form::Direct { attitude, .. } => (attitude.drift, 0.0),
            Form::Complementary { attitude, .. } => {
                (attitude.drift, attitude.step * self.constants.rate.hi().signum())
            }
        };
        // (C37), (C33)
        Some((PI * (drift.hi() * half + step)).abs())
    }

    /// The constants that run in lanes: those of the direct series.
    pub(super) fn direct(&self) -> Option<(&DirectSpin, &DirectAttitude)> {
        match &self.form {
            Form::Direct { spin, attitude } if self.unscale.is_none() => Some((spin, attitude)),
            _ => None,
        }
    }

    /// The constants that run in lanes: those of the complementary series, where the motion returns.
    pub(super) fn complementary(&self) -> Option<(&ComplementarySpin, &ComplementaryAttitude)> {
        match &self.form {
            Form::Complementary { spin, attitude } if self.unscale.is_none() && self.returns() => {
                Some((spin, attitude))
            }
            _ => None,
        }
    }
}

impl<T: Real> EllipticMotion<T> {
    /// Not on the separatrix.
    fn returns(&self) -> bool {
        self.constants.quarter.hi().finite()
    }

    /// Half the spin's period, in scaled time, where the motion returns.
    pub(crate) fn span_of_half_period(&self) -> T {
        let Constants { rate, quarter, .. } = self.constants;
        (quarter.times_exact(splat(2.0)) / rate.abs()).hi()
    }

    /// Half periods until scaled time `time`, from the flip nearest to the start, where the motion returns.
    pub(crate) fn half_periods_since_flip(&self, time: T) -> T {
        let Constants { rate, quarter, argument, .. } = self.constants;
        // (C36)
        ((rate * time).plus(argument) / (quarter.times_exact(splat(2.0)))).hi()
    }

    /// The spin at scaled time `time`.
    pub(crate) fn omega(&self, time: T) -> Vector3<T> {
        self.unscaled(match &self.form {
            Form::Direct { spin, .. } => spin.omega(&spin.phase(&spin.reduced(time))),
            Form::Complementary { spin, .. } => spin.omega(&spin.reduction.argument(time)),
        })
    }

    /// The turn since the start at scaled time `time`.
    pub(crate) fn attitude(&self, time: T) -> Quaternion<T> {
        match &self.form {
            Form::Direct { spin, attitude } => spin.turn(attitude, &spin.phase(&spin.reduced(time)), time),
            Form::Complementary { spin, attitude } => {
                spin.turn(attitude, &spin.reduction.argument(time), time)
            }
        }
    }

    /// Spin and turn since the start at scaled time `time`.
    #[inline(always)]
    pub(crate) fn at(&self, time: T) -> (Vector3<T>, Quaternion<T>) {
        let (omega, turn) = match &self.form {
            Form::Direct { spin, attitude } => both(spin, attitude, spin.phase(&spin.reduced(time)), time),
            Form::Complementary { spin, attitude } => {
                both(spin, attitude, spin.reduction.argument(time), time)
            }
        };
        (self.unscaled(omega), turn)
    }

    /// In rad/s where the amplitudes are not.
    #[inline(always)]
    fn unscaled(&self, omega: Vector3<T>) -> Vector3<T> {
        let Some(unscale) = &self.unscale else { return omega };
        Vector3::from_fn(|k, _| omega[k] * unscale[k][0] * unscale[k][1])
    }
}

#[inline(always)]
fn both<T: Real, K: Kernel<T>>(
    spin: &K,
    attitude: &K::Attitude,
    phase: K::Phase,
    time: T,
) -> (Vector3<T>, Quaternion<T>) {
    (spin.omega(&phase), spin.turn(attitude, &phase, time))
}
