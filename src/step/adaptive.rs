//! A run whose steps are chosen by their error: by Taylor series, by an embedded pair of high order where a
//! torque is a function, or by collocation where damping is stiff.

mod collocation;
mod dense;
mod dop853_coefficients;
mod flips;
mod law;
mod pair;
mod series;
mod sums;
mod taylor;

use crate::body::State;
use crate::error::{Error, Refusal, Subject, positive};
use crate::number::{Analytic, exponent, times_power_of_two};
use crate::step::system::System;
use alloc::boxed::Box;
use alloc::sync::Arc;
use core::f64::consts::{LN_2, LOG2_E, SQRT_2};
use flips::Flips;
use nalgebra::{Quaternion, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;
use series::Variation;

pub(super) use dense::{AdaptiveRun, Tracked};
pub(super) use law::{Circle, turned};

/// Checks that the tolerance of a step is above rounding.
pub(super) fn check_tolerance(tolerance: f64) -> Result<(), Error> {
    positive(Subject::Tolerance, tolerance)?;
    let least = 4.0 * f64::EPSILON;
    let (what, meaning) = (Subject::Tolerance, "rounding in a step");
    Refusal::TooSmall { what, value: tolerance, least, meaning }.when(tolerance < least)
}

/// The number of tries, each shorter, before a step is refused.
const TRIES: usize = 60;

/// Stability, not the error, limits a step of more than this number of decay times; about the bound of
/// [HW96](crate::references), IV.2, for explicit steps of low order.
const STIFF: f64 = 3.25;

/// After this number of such steps the law counts as stiff; six others in a row begin the count again.
const STIFF_STEPS: u32 = 15;

/// A run, or a piece of one, under torques that act in all of it.
#[derive(Debug, Clone)]
struct Run {
    system: Arc<System<f64>>,
    /// Its start, s after the start of the whole run.
    from: f64,
    /// Its duration, s; infinite where nothing ends it.
    duration: f64,
    /// The requested time, s since its start; a step may go beyond it.
    goal: f64,
    tolerance: f64,
    /// Seconds since its start.
    time: f64,
    state: State<f64>,
    /// The last step taken, s.
    last: f64,
    /// The length of the momentum of a free body, which is constant; zero with torques.
    momentum: f64,
    steps: usize,
    rejected: usize,
    /// The number of stiff steps since six others in a row.
    stiff: u32,
    /// The number of other steps since the last stiff one.
    mild: u32,
    /// The search for flips, if they are tracked.
    flips: Option<Flips>,
    /// The derivatives of the state with respect to the start of the whole run, with the spin in rad/s, if
    /// they are tracked.
    variation: Option<Box<Variation>>,
}

impl Run {
    fn new(
        system: Arc<System<f64>>,
        start: &State<f64>,
        duration: f64,
        tolerance: f64,
    ) -> Result<Self, Error> {
        let mut state = *start;
        unit_length(&mut state.attitude)?;
        let momentum = if system.is_free() { Self::length(&state.momentum) } else { 0.0 };
        Ok(Self {
            system,
            from: 0.0,
            duration,
            goal: duration,
            tolerance,
            time: 0.0,
            state,
            last: duration,
            momentum,
            steps: 0,
            rejected: 0,
            stiff: 0,
            mild: 0,
            flips: None,
            variation: None,
        })
    }

    /// The length of a step that nothing limits: to the requested time.
    fn ahead(&self) -> f64 {
        self.goal - self.time
    }

    /// A step of about `h` seconds that does not pass the end of the run, and the time at its end. The step
    /// is the difference of the times, so that what rounding takes of them does not add up.
    fn fitted(&self, h: f64) -> Result<(f64, f64), Error> {
        let remaining = self.duration - self.time;
        let next = if remaining.abs() <= h.abs() { self.duration } else { self.time + h };
        if next == self.time || h.is_nan() {
            return Err(self.no_step(h));
        }
        Ok((next - self.time, next))
    }

    /// The system and its time at the start of a step. Phases are counted from there, so that stages within
    /// the step do not take them from a rounded time.
    fn now(&self) -> (Arc<System<f64>>, f64) {
        let sum = &self.system.sum;
        if sum.periodic.is_empty() && sum.gradients.is_empty() {
            return (Arc::clone(&self.system), self.time);
        }
        (Arc::new(self.system.starting_at(self.time)), 0.0)
    }

    /// Takes a step of `h` seconds to the time `next`.
    fn take(&mut self, end: State<f64>, h: f64, next: f64) {
        (self.state, self.last, self.time) = (end, h, next);
        self.steps += 1;
    }

    /// As [`project`](Self::project), at the end of a step: a component of the momentum below the normal
    /// numbers becomes zero, so that what decays comes to rest.
    fn settle(&self, end: &mut State<f64>) -> f64 {
        end.momentum.apply(|x| *x = if x.abs() < f64::MIN_POSITIVE { 0.0 } else { *x });
        self.project(end)
    }

    /// Restores the constant lengths of attitude and momentum; returns the relative deviation before.
    fn project(&self, end: &mut State<f64>) -> f64 {
        let attitude = normalize_near(&mut end.attitude);
        if self.momentum == 0.0 {
            return attitude.abs();
        }
        let scale = self.momentum / Self::length(&end.momentum);
        end.momentum.apply(|x| *x *= scale);
        largest(&[attitude, (scale - 1.0).abs()])
    }

    /// The length of a momentum whose squares may overflow or underflow.
    fn length(momentum: &Vector3<f64>) -> f64 {
        let size = largest(momentum.as_slice());
        if size == 0.0 {
            return size;
        }
        let part = momentum.map(|x| x / size);
        size * part.dot(&part).sqrt()
    }

    /// Counts steps that are long relative to the fastest decay, given the number of decay times of a step.
    fn count_stiffness(&mut self, decay: f64) {
        if decay > STIFF {
            (self.stiff, self.mild) = ((self.stiff + 1).min(STIFF_STEPS), 0);
        } else {
            self.mild += 1;
            if self.mild == 6 {
                self.stiff = 0;
            }
        }
    }

    /// The error that no step is short enough; `shortest` is the last one tried, s.
    fn no_step(&self, shortest: f64) -> Error {
        let tried = self.steps + self.rejected;
        Refusal::NoStep { tried, reached: self.from + self.time, shortest: shortest.abs() }.into()
    }

    fn unfinished(&self, why: &'static str) -> Error {
        let (what, steps) = (Subject::AdaptiveRun, self.steps + self.rejected);
        let [reached, duration] = [self.time, self.goal].map(|time| self.from + time);
        Refusal::Unfinished { what, steps, reached, duration, why }.into()
    }
}

/// Brings the attitude to length 1; a length of zero is refused.
pub(super) fn unit_length<T: Analytic>(attitude: &mut Quaternion<T>) -> Result<(), Error> {
    positive(Subject::AttitudeLength, normalize(attitude).min(f64::MAX)).map(drop)
}

/// As [`normalize`]; returns about the length before minus 1.
fn normalize_near(attitude: &mut Quaternion<f64>) -> f64 {
    let off = attitude.coords.dot(&attitude.coords) - 1.0;
    if off.abs() >= 1e-4 || off.is_nan() {
        return normalize(attitude) - 1.0;
    }
    // Neither a root nor a division: the first term that is left out of the inverse length is below 2^-54.
    let short = off * (0.5 - off * (0.375 - 0.3125 * off));
    attitude.coords.apply(|x| *x -= *x * short);
    short
}

/// Brings the attitude to length 1; returns its length before.
fn normalize<T: Analytic>(attitude: &mut Quaternion<T>) -> f64 {
    let square = attitude.coords.dot(&attitude.coords);
    if !(1e-30..=1e30).contains(&square.size()) {
        return normalize_extreme(attitude);
    }
    let length = square.sqrt();
    attitude.coords.apply(|x| *x /= length.clone());
    length.size()
}

/// Normalizes an attitude whose squared length may overflow or underflow.
#[cold]
fn normalize_extreme<T: Analytic>(attitude: &mut Quaternion<T>) -> f64 {
    let mut largest = attitude.coords[attitude.coords.map(|x| x.size()).imax()].clone();
    if largest.is_zero() {
        return 0.0;
    }
    // A number with a negative value has no root, and dividing by it would change the quaternion's sign.
    if largest.sqrt().size().is_nan() {
        largest = -largest;
    }
    attitude.coords.apply(|x| *x /= largest.clone());
    let length = attitude.coords.dot(&attitude.coords).sqrt();
    attitude.coords.apply(|x| *x /= length.clone());
    largest.size() * length.size()
}

/// The largest absolute value, computed without squares, which could overflow; NaN if any part is NaN.
fn largest(parts: &[f64]) -> f64 {
    // By their bits, which are ordered as the sizes are, NaN above all: the processor could not predict a
    // branch on the sizes.
    f64::from_bits(parts.iter().map(|x| x.abs().to_bits()).fold(0, u64::max))
}

/// `part / whole`; 0 where `part` is 0, for any `whole`.
fn ratio(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}

/// The natural logarithm of a number that is not negative, to 1e-5; minus infinity at zero. It serves to
/// choose steps, and uses only correctly rounded operations, so that it is the same wherever `f64` follows
/// IEEE 754.
fn logarithm(x: f64) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 { f64::NEG_INFINITY } else { x };
    }
    let whole = exponent(x);
    let m = times_power_of_two(x, -whole);
    let z = (m - SQRT_2) / (m + SQRT_2);
    let square = z * z;
    (f64::from(whole) + 0.5) * LN_2 + 2.0 * z * (1.0 + square * (1.0 / 3.0 + square * 0.2))
}

/// The exponential of a number, to 3e-4 of its value where that is a normal number; with the same uses.
fn exponential(x: f64) -> f64 {
    // Beyond these numbers it is infinite or zero.
    let x = x.clamp(-800.0, 800.0);
    let whole = (x * LOG2_E) as i32;
    let rest = x - f64::from(whole) * LN_2;
    let [more, less] = [rest + 3.0, rest - 3.0].map(|y| y * y + 3.0);
    times_power_of_two(more / less, whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_logarithm_and_the_exponential_keep_their_bounds() {
        for x in [-700.0, -36.0, -1.5, -0.693, 0.0, 0.3, 0.693, 2.0, 700.0] {
            assert!((logarithm(f64::exp(x)) - x).abs() < 1e-5, "{x}: {}", logarithm(f64::exp(x)));
            assert!((exponential(x) / f64::exp(x) - 1.0).abs() < 3e-4, "{x}: {}", exponential(x));
        }
        assert_eq!(logarithm(0.0), f64::NEG_INFINITY);
        assert_eq!((exponential(f64::NEG_INFINITY), exponential(f64::INFINITY)), (0.0, f64::INFINITY));
        assert!(logarithm(f64::NAN).is_nan() && exponential(f64::NAN).is_nan());
    }
}
