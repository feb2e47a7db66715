//! The motions that sines and cosines describe: a steady spin, and that of a body with two equal moments.

use super::klein;
use crate::exact::elliptic::sin_cos_of_turns;
use crate::number::double_double::DoubleDouble;
use crate::number::functions::hypot;
use crate::number::power_of_two::{exponent, times_power_of_two};
use crate::number::{Lane, gathered};
use core::f64::consts::PI;
use nalgebra::{Quaternion, Vector3};

/// A turn at an even rate about a fixed direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Turn {
    direction: Vector3<f64>,
    /// Turns of half the angle, which is what a quaternion takes, per unit of scaled time.
    half_rate: DoubleDouble,
}

impl Turn {
    /// About the vector whose scaled components in twice the precision are given, at the rate of its length.
    pub(crate) fn along(vector: [DoubleDouble; 3]) -> Self {
        let scale = exponent(vector.iter().fold(0.0, |m: f64, x| m.max(x.hi().abs())));
        let scaled = vector.map(|x| x.scaled(-scale));
        let length = (scaled[0] * scaled[0] + scaled[1] * scaled[1] + scaled[2] * scaled[2]).sqrt();
        let [x, y, z] = scaled.map(|x| (x / length).hi());
        let half_rate = (length / (DoubleDouble::PI * 4.0)).scaled(scale);
        Self { direction: Vector3::new(x, y, z), half_rate }
    }

    /// Radians per unit of scaled time.
    pub(crate) fn rate(&self) -> f64 {
        4.0 * PI * self.half_rate.hi()
    }

    pub(crate) fn at(&self, time: f64) -> Quaternion<f64> {
        let (sin, cos) = sin_cos_of_turns(self.half_rate * time);
        let [x, y, z] = self.direction.into();
        klein::quaternion(klein::unit(about([x, y, z], sin, cos)))
    }
}

/// The quaternion of a turn about a direction.
#[inline(always)]
fn about<T: Lane>(direction: [T; 3], sin: T, cos: T) -> [T; 4] {
    let [x, y, z] = direction;
    [cos, x * sin, y * sin, z * sin]
}

/// The spin of a body with two equal moments circles its axis evenly, and the body turns evenly about its
/// momentum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Precession {
    axis: usize,
    omega: Vector3<f64>,
    /// Turns of the spin about the axis per unit of scaled time.
    wobble: DoubleDouble,
    /// The turn about the momentum.
    about_momentum: Turn,
    /// How fast the shortest way from axis to momentum turns with the body, radians per unit of scaled time.
    smooth: f64,
}

impl Precession {
    /// `moments` with the largest near 1, `scaled` the spin in scaled units, `omega` the spin itself.
    pub(crate) fn new(moments: &[f64; 3], axis: usize, scaled: &[f64; 3], omega: &Vector3<f64>) -> Self {
        let equal = moments[(axis + 1) % 3];
        let difference = DoubleDouble::from(moments[axis]) - DoubleDouble::from(equal);
        let wobble = difference * scaled[axis] / DoubleDouble::from(equal) / (DoubleDouble::PI * 2.0);
        let momentum =
            [0, 1, 2].map(|k| DoubleDouble::product(moments[k], scaled[k]) / DoubleDouble::from(equal));
        let about_momentum = Turn::along(momentum);
        // psi' = (2E + L |w_C|)/(L + I_C |w_C|), all over the equal moment.
        let (m, w) = (momentum.map(DoubleDouble::hi), scaled);
        let twice_energy = m[0] * w[0] + m[1] * w[1] + m[2] * w[2];
        let (length, along) = (about_momentum.rate(), w[axis].abs());
        let smooth = (twice_energy + length * along) / (length + moments[axis] / equal * along);
        Self { axis, omega: *omega, wobble, about_momentum, smooth }
    }

    pub(crate) fn axis(&self) -> usize {
        self.axis
    }

    /// The largest component that the spin can have, rad/s.
    pub(crate) fn greatest_spin(&self) -> f64 {
        let [a, b] = [1, 2].map(|k| self.omega[(self.axis + k) % 3]);
        hypot(a, b).max(self.omega[self.axis].abs())
    }

    /// Turns per unit of scaled time.
    pub(crate) fn wobble_turns(&self) -> f64 {
        self.wobble.hi()
    }

    pub(crate) fn wobble(&self) -> DoubleDouble {
        self.wobble
    }

    /// `L / I` with the equal moments, radians per unit of scaled time.
    pub(crate) fn precession(&self) -> f64 {
        self.about_momentum.rate()
    }

    /// Radians about the momentum in half a turn of the spin.
    pub(crate) fn twist_of_half_period(&self) -> f64 {
        0.5 * self.smooth / self.wobble.hi().abs()
    }

    pub(crate) fn omega(&self, time: f64) -> Vector3<f64> {
        let (a, b) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        let (sin, cos) = sin_cos_of_turns(self.wobble * time);
        let mut omega = self.omega;
        omega[a] = self.omega[a] * cos - self.omega[b] * sin;
        omega[b] = self.omega[b] * cos + self.omega[a] * sin;
        omega
    }

    pub(crate) fn attitude(&self, time: f64) -> Quaternion<f64> {
        let (sin, cos) = sin_cos_of_turns(self.wobble * (0.5 * time));
        let mut back = [0.0; 3];
        back[self.axis] = -sin;
        let turn = self.about_momentum.at(time);
        let turn = [turn.w, turn.i, turn.j, turn.k];
        klein::quaternion(klein::unit(klein::product(turn, [cos, back[0], back[1], back[2]])))
    }
}

/// Even turns of many bodies, side by side: those at rest too, which turn by nothing.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Turns<T> {
    direction: [T; 3],
    half_rate: DoubleDouble<T>,
}

impl<T: Lane> Turns<T> {
    pub(crate) fn gathered<S>(from: &[S], of: impl Fn(&S) -> Option<Turn>) -> Self {
        let half_rate = |s: &S| of(s).map_or(DoubleDouble::ZERO, |turn| turn.half_rate);
        Self {
            direction: [0, 1, 2].map(|n| gathered(from, |s| of(s).map_or(0.0, |turn| turn.direction[n]))),
            half_rate: DoubleDouble::parts(
                gathered(from, |s| half_rate(s).hi()),
                gathered(from, |s| half_rate(s).lo()),
            ),
        }
    }

    /// The turn since the start, real part first.
    #[inline(always)]
    pub(crate) fn at(&self, time: T) -> [T; 4] {
        let (sin, cos) = sin_cos_of_turns(self.half_rate * time);
        klein::unit(about(self.direction, sin, cos))
    }
}

/// The spins of many tops, side by side.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Wobbles<T> {
    /// 1 in the place of the axis.
    axis: [T; 3],
    omega: [T; 3],
    wobble: DoubleDouble<T>,
}

impl<T: Lane> Wobbles<T> {
    pub(crate) fn gathered<S>(from: &[S], of: impl Fn(&S) -> &Precession) -> Self {
        Self {
            axis: [0, 1, 2].map(|n| gathered(from, |s| if of(s).axis == n { 1.0 } else { 0.0 })),
            omega: [0, 1, 2].map(|n| gathered(from, |s| of(s).omega[n])),
            wobble: DoubleDouble::parts(
                gathered(from, |s| of(s).wobble.hi()),
                gathered(from, |s| of(s).wobble.lo()),
            ),
        }
    }

    #[inline(always)]
    pub(crate) fn omega(&self, time: T) -> [T; 3] {
        let (sin, cos) = sin_cos_of_turns(self.wobble * time);
        let along = self.axis.map(|x| T::splat(0.5).lt(x));
        // In each place what it would be if that were the first or the second place after the axis.
        [0, 1, 2].map(|n| {
            let [before, after] = [self.omega[(n + 2) % 3], self.omega[(n + 1) % 3]];
            let first = self.omega[n] * cos - after * sin;
            let second = self.omega[n] * cos + before * sin;
            T::select(along[n], self.omega[n], T::select(along[(n + 2) % 3], first, second))
        })
    }

    /// The turn since the start, real part first, from that about the momentum.
    #[inline(always)]
    pub(crate) fn turn(&self, about_momentum: &Turns<T>, time: T) -> [T; 4] {
        let (sin, cos) = sin_cos_of_turns(self.wobble * (time * 0.5));
        let nothing = T::splat(0.0);
        let [x, y, z] = self.axis.map(|along| T::select(nothing.lt(along), -sin, nothing));
        klein::unit(klein::product(about_momentum.at(time), [cos, x, y, z]))
    }
}

impl Precession {
    pub(crate) fn about_momentum(&self) -> Turn {
        self.about_momentum
    }
}

/// Moments and spin with powers of two taken out, and the power taken from the spin.
pub(crate) fn scaled(moments: &[f64; 3], omega: &[f64; 3]) -> ([f64; 3], [f64; 3], i32) {
    let largest = |v: &[f64; 3]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let (heaviest, clock) = (exponent(largest(moments)), exponent(largest(omega)).clamp(-1000, 1000));
    (moments.map(|x| times_power_of_two(x, -heaviest)), omega.map(|x| times_power_of_two(x, -clock)), clock)
}
