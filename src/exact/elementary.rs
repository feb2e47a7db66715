//! The interface that evaluates a free motion at an instant, in [lanes](crate::laws::Lane); one body is the
//! case of one lane. Also the motions that need only sines and cosines: a steady spin, and the motion of a
//! body with two equal moments.

use crate::attitude::{product, unit};
use crate::exact::elliptic::{Angle, sin_cos_of_turns};
use crate::number::functions::hypot;
use crate::number::{
    DoubleDouble, Gather, INTEGERS, Rounding, exponent, gather_fields, splat, times_power_of_two,
};
use core::f64::consts::PI;
use nalgebra::{Quaternion, Vector3};

/// The constants of one kind of motion that the spin needs. The further constants of the attitude are
/// separate, since some callers request only spins.
pub(super) trait Kernel<T: Rounding> {
    /// The further constants of the attitude.
    type Attitude;
    /// The argument of the functions, less its whole periods.
    type Reduced: Copy;
    /// Values that spin and attitude share at one instant.
    type Phase: Copy;

    /// At scaled time `time`.
    fn reduced(&self, time: T) -> Self::Reduced;

    fn phase(&self, reduced: &Self::Reduced) -> Self::Phase;

    /// The spin along the principal axes, rad/s.
    fn omega(&self, phase: &Self::Phase) -> Vector3<T>;

    /// The angle that the attitude needs beyond the phase.
    fn drift(&self, attitude: &Self::Attitude, phase: &Self::Phase, time: T) -> Angle<T>;

    /// Numbers of which the turn since the start consists, of length 1 to a few roundings, from sine and
    /// cosine of that angle.
    fn parts(&self, attitude: &Self::Attitude, phase: &Self::Phase, sin_cos: (T, T)) -> [T; 4];

    /// The turn since the start, from these: here its components, the real part last.
    #[inline(always)]
    fn turn_of(&self, parts: [T; 4]) -> Quaternion<T> {
        unit(Quaternion::from_vector(parts.into()))
    }

    /// The turn since the start.
    #[inline(always)]
    fn turn(&self, attitude: &Self::Attitude, phase: &Self::Phase, time: T) -> Quaternion<T> {
        self.turn_of(self.parts(attitude, phase, self.drift(attitude, phase, time).sin_cos()))
    }
}

/// Which principal axis each of three components belongs to, which differs from body to body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axes<T = f64> {
    /// Of each axis, which component it has.
    sources: [T; 3],
    /// 1 where they follow each other in cyclic order, otherwise -1.
    pub(super) sense: T,
}

gather_fields!(Axes { sources, sense });

impl<T: Rounding> Axes<T> {
    pub(super) fn new(axes: [usize; 3]) -> Self {
        let cyclic = (axes[0] + 1) % 3 == axes[1];
        let component = |axis| axes.iter().position(|of| of % 3 == axis).unwrap_or(0);
        let sources = [0, 1, 2].map(|axis| splat([0.0, 1.0, 2.0][component(axis)]));
        Self { sources, sense: splat(if cyclic { 1.0 } else { -1.0 }) }
    }

    /// The three components in the order of the body.
    #[inline(always)]
    pub(super) fn arranged(&self, parts: [T; 3]) -> [T; 3] {
        let on = |source: T| {
            if T::WIDTH == 1 {
                // From memory: that costs less than selections.
                return parts[(source.lane(0) + INTEGERS).to_bits() as usize % 4 % 3];
            }
            let beyond_first = T::select(source.lt(splat(1.5)), parts[1], parts[2]);
            T::select(source.lt(splat(0.5)), parts[0], beyond_first)
        };
        let [x, y, z] = self.sources;
        [on(x), on(y), on(z)]
    }
}

/// A turn at an even rate about a fixed direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Turn<T = f64> {
    direction: [T; 3],
    /// Turns of half the angle, which is what a quaternion takes, per unit of scaled time.
    half_rate: DoubleDouble<T>,
}

gather_fields!(Turn { direction, half_rate });

impl Turn {
    /// That of a body at rest.
    pub(crate) const NONE: Self = Self { direction: [0.0; 3], half_rate: DoubleDouble::ZERO };

    /// About the vector whose scaled components in twice the precision are given, at the rate of its length.
    pub(crate) fn along(vector: [DoubleDouble; 3]) -> Self {
        let largest = vector.iter().fold(0.0, |m: f64, x| m.max(x.hi().abs()));
        if largest == 0.0 {
            return Self::NONE;
        }
        let scale = exponent(largest);
        let scaled = vector.map(|x| x.scaled(-scale));
        let length = (scaled[0] * scaled[0] + scaled[1] * scaled[1] + scaled[2] * scaled[2]).sqrt();
        let direction = scaled.map(|x| (x / length).hi());
        let half_rate = (length / (DoubleDouble::PI * 4.0)).scaled(scale);
        Self { direction, half_rate }
    }

    /// Radians per unit of scaled time.
    pub(crate) fn rate(&self) -> f64 {
        4.0 * PI * self.half_rate.hi()
    }
}

impl<T: Rounding> Turn<T> {
    /// The turn since the start.
    #[inline(always)]
    pub(crate) fn at(&self, time: T) -> Quaternion<T> {
        unit(self.by(sin_cos_of_turns(self.half_rate.times_loosely(time))))
    }

    /// The turn by twice the angle with this sine and cosine, of length 1 to a few roundings.
    #[inline(always)]
    fn by(&self, (sin, cos): (T, T)) -> Quaternion<T> {
        let [x, y, z] = self.direction;
        Quaternion::new(cos, x * sin, y * sin, z * sin)
    }
}

/// A spin that does not change.
impl<T: Rounding> Kernel<T> for Vector3<T> {
    type Attitude = Turn<T>;
    type Reduced = ();
    type Phase = ();

    #[inline(always)]
    fn reduced(&self, _: T) {}

    #[inline(always)]
    fn phase(&self, (): &()) {}

    #[inline(always)]
    fn omega(&self, (): &()) -> Vector3<T> {
        *self
    }

    #[inline(always)]
    fn drift(&self, turn: &Turn<T>, (): &(), time: T) -> Angle<T> {
        Angle::of_turns(turn.half_rate.times_loosely(time))
    }

    #[inline(always)]
    fn parts(&self, turn: &Turn<T>, (): &(), sin_cos: (T, T)) -> [T; 4] {
        turn.by(sin_cos).coords.into()
    }
}

/// The spin of a body with two equal moments: it circles the third axis evenly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TopSpin<T = f64> {
    axes: Axes<T>,
    /// Along that axis and the next two, at the start.
    omega: [T; 3],
    /// Turns about it per unit of scaled time.
    pub(super) nutation: DoubleDouble<T>,
}

gather_fields!(TopSpin { axes, omega, nutation });

impl<T: Rounding> Kernel<T> for TopSpin<T> {
    /// The turn about the momentum.
    type Attitude = Turn<T>;
    /// The time: spin and attitude turn by different angles.
    type Reduced = T;
    type Phase = T;

    #[inline(always)]
    fn reduced(&self, time: T) -> T {
        time
    }

    #[inline(always)]
    fn phase(&self, &time: &T) -> T {
        time
    }

    #[inline(always)]
    fn omega(&self, &time: &T) -> Vector3<T> {
        let (sin, cos) = sin_cos_of_turns(self.nutation.times_loosely(time));
        let [along, first, second] = self.omega;
        self.axes.arranged([along, first * cos - second * sin, second * cos + first * sin]).into()
    }

    #[inline(always)]
    fn drift(&self, about_momentum: &Turn<T>, _: &T, time: T) -> Angle<T> {
        Angle::of_turns(about_momentum.half_rate.times_loosely(time))
    }

    #[inline(always)]
    fn parts(&self, about_momentum: &Turn<T>, &time: &T, sin_cos: (T, T)) -> [T; 4] {
        let (sin, cos) = sin_cos_of_turns(self.nutation.times_loosely(time * 0.5));
        let zero = splat::<T>(0.0);
        let [x, y, z] = self.axes.arranged([-sin, zero, zero]);
        product(&unit(about_momentum.by(sin_cos)), &Quaternion::new(cos, x, y, z)).coords.into()
    }
}

/// The motion of a body with two equal moments: its spin circles its axis, and the body turns evenly about
/// its momentum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Precession {
    pub(super) axis: usize,
    pub(super) spin: TopSpin,
    /// At the rate `L / I` with the equal moments.
    pub(super) about_momentum: Turn,
    /// The rate at which the shortest rotation from axis to momentum turns with the body, radians per unit of
    /// scaled time.
    smooth: f64,
}

impl Precession {
    /// `moments` with the largest near 1, `scaled` the spin in scaled units, `omega` the spin itself.
    pub(crate) fn new(moments: &[f64; 3], axis: usize, scaled: &[f64; 3], omega: &Vector3<f64>) -> Self {
        let equal = moments[(axis + 1) % 3];
        let difference = DoubleDouble::from(moments[axis]) - DoubleDouble::from(equal);
        // (C38)
        let nutation = difference * scaled[axis] / DoubleDouble::from(equal) / (DoubleDouble::PI * 2.0);
        let momentum =
            [0, 1, 2].map(|k| DoubleDouble::product(moments[k], scaled[k]) / DoubleDouble::from(equal));
        let about_momentum = Turn::along(momentum);
        // psi' = (2E + L |w_C|)/(L + I_C |w_C|), all over the equal moment.
        let (m, w) = (momentum.map(DoubleDouble::hi), scaled);
        let twice_energy = m[0] * w[0] + m[1] * w[1] + m[2] * w[2];
        let (length, along) = (about_momentum.rate(), w[axis].abs());
        let smooth = (twice_energy + length * along) / (length + moments[axis] / equal * along);
        let omega = [0, 1, 2].map(|k| omega[(axis + k) % 3]);
        let spin =
            TopSpin { axes: Axes::new([axis, axis + 1, axis + 2].map(|axis| axis % 3)), omega, nutation };
        Self { axis, spin, about_momentum, smooth }
    }

    /// The largest component that the spin can have, rad/s.
    pub(crate) fn greatest_spin(&self) -> f64 {
        let [along, a, b] = self.spin.omega;
        hypot(a, b).max(along.abs())
    }

    /// Turns per unit of scaled time.
    pub(crate) fn nutation_turns(&self) -> f64 {
        self.spin.nutation.hi()
    }

    /// Radians about the momentum in half a turn of the spin.
    pub(crate) fn twist_of_half_period(&self) -> f64 {
        0.5 * self.smooth / self.nutation_turns().abs()
    }

    pub(crate) fn omega(&self, time: f64) -> Vector3<f64> {
        self.spin.omega(&time)
    }

    /// The turn since the start.
    // Not inlined: a steady spin is faster without this code.
    #[inline(never)]
    pub(crate) fn attitude(&self, time: f64) -> Quaternion<f64> {
        self.spin.turn(&self.about_momentum, &time, time)
    }
}

/// Moments and spin with powers of two taken out, and the power taken from the spin.
pub(crate) fn scaled(moments: &[f64; 3], omega: &[f64; 3]) -> ([f64; 3], [f64; 3], i32) {
    let largest = |v: &[f64; 3]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let (heaviest, clock) = (exponent(largest(moments)), exponent(largest(omega)).clamp(-1000, 1000));
    (moments.map(|x| times_power_of_two(x, -heaviest)), omega.map(|x| times_power_of_two(x, -clock)), clock)
}
