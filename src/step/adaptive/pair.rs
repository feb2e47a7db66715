//! Steps by the pair of Dormand and Prince of orders 8, 5 and 3 [HNW93](crate::references), for torques that
//! are functions.

use super::dop853_coefficients::{FIFTH, STAGES, STEP, THIRD, Weights};
use super::{Run, largest, ratio};
use crate::body::{Rate, State};
use crate::error::{Error, Subject, representable};
use crate::number::{exponent, times_power_of_two};
use nalgebra::{Quaternion, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The rates at the stages of a step.
#[derive(Debug, Clone)]
pub(super) struct Pair {
    rates: [Rate<f64>; 12],
    /// The rate at the start of the last step that was taken.
    first: Rate<f64>,
    /// The next step, s.
    h: f64,
}

/// The largest number of steps to a state within a step.
const SHORTER_STEPS: usize = 1000;

/// The number of tries of a step from rest before the torque is assumed to jump.
const JUMP_TRIES: usize = 40;

/// In a step of this number of decay times or more, the differences from the steps of lower order may be far
/// less than the error; at 5.65 decay times they vanish.
const DECAYED: f64 = 5.0;

/// `start + h (sum of weights times rates)`.
fn combined(start: &State<f64>, rates: &[Rate<f64>], weights: Weights, h: f64) -> State<f64> {
    let mut sum = *start;
    for &(k, weight) in weights {
        sum = sum.plus(&rates[k], h * weight);
    }
    sum
}

fn difference(a: &State<f64>, b: &State<f64>) -> State<f64> {
    let attitude = Quaternion::from_vector(a.attitude.coords - b.attitude.coords);
    State { attitude, momentum: a.momentum - b.momentum }
}

impl Pair {
    pub(super) fn new(run: &Run) -> Result<Self, Error> {
        let (system, time) = run.now();
        let rate = system.rate_after(&run.state, &time);
        let size = largest(&[largest(rate.attitude.coords.as_slice()), largest(rate.momentum.as_slice())]);
        representable(Subject::RateAtStart, &[size])?;
        // The first guess uses the rate of turn, and the rate that a torque would cause. If it is too long,
        // the error estimate rejects it.
        let torque = largest(system.torque_after(&run.state, &time).as_slice());
        let turning =
            ratio(largest(rate.attitude.coords.as_slice()), largest(run.state.attitude.coords.as_slice()));
        let turning_rate = (2.0 * turning).max((torque * largest(run.system.inverse.as_slice())).sqrt());
        let guess = eighth_root(run.tolerance) / turning_rate;
        // Where nothing turns yet, no time scale exists: the guess is one second.
        let guess = if guess.is_finite() { guess } else { 1.0 };
        let h = guess.copysign(run.duration);
        Ok(Self { rates: [rate; 12], first: rate, h })
    }

    /// The estimated error of a step, the larger of attitude's and momentum's, each relative to its own size.
    /// It combines the differences from a step of order 5 and a step of order 3, as in
    /// [HNW93](crate::references), II.10.
    fn error(&self, run: &Run, end: &State<f64>, h: f64) -> f64 {
        let nothing = difference(end, end);
        let by = |weights: Weights| combined(&nothing, &self.rates, weights, h);
        let (fifth, third) = (by(FIFTH), difference(&by(STEP), &by(THIRD)));
        let [fifth, third] = [&fifth, &third].map(|off| self.relative(run, off, end, h));
        // By a power of two, so that no square leaves the range.
        let unit = -exponent(largest(&[fifth, third]));
        let [one, other] = [fifth, third].map(|x| times_power_of_two(x, unit));
        ratio(one, (one * one + 0.01 * other * other).sqrt()) * fifth
    }

    fn relative(&self, run: &Run, off: &State<f64>, end: &State<f64>, h: f64) -> f64 {
        // The momentum of a body that drag has brought to rest has no digits below this limit.
        let least = f64::MIN_POSITIVE / run.tolerance;
        let held = largest(run.state.momentum.as_slice());
        // For a body at rest, the scale is the momentum that a torque has given it at the end of the step.
        let mut whole = held.max(largest(end.momentum.as_slice())).max(least);
        if held == 0.0 && run.rejected > JUMP_TRIES {
            // A torque that jumps: no step across the jump is accurate relative to the momentum gained in it.
            // The scale is the momentum that turns the body by a radian in the time until now.
            let time = run.time.abs().max(h.abs());
            whole = whole.max(ratio(1.0, largest(run.system.inverse.as_slice()) * time));
        }
        let attitude =
            ratio(largest(off.attitude.coords.as_slice()), largest(run.state.attitude.coords.as_slice()));
        largest(&[attitude, largest(off.momentum.as_slice()) / whole])
    }

    /// The step in decay times, from two states near its end: the ratio of the difference of their rates to
    /// the difference of the states, times the step.
    fn decay(&self, near: &State<f64>, end: &State<f64>, end_rate: &Rate<f64>, h: f64) -> f64 {
        let apart = |a: &Vector3<f64>, b: &Vector3<f64>| largest((a - b).as_slice());
        let rates = apart(&end_rate.momentum, &self.rates[11].momentum);
        h.abs() * ratio(rates, apart(&end.momentum, &near.momentum))
    }

    /// Tries one step, and accepts it if its error is within the tolerance.
    pub(super) fn advance(&mut self, run: &mut Run) -> Result<(), Error> {
        let (h, next) = run.fitted(self.h)?;
        let (mut near, (system, time)) = (run.state, run.now());
        for (k, (node, weights)) in STAGES.iter().enumerate() {
            near = combined(&run.state, &self.rates, weights, h);
            self.rates[k + 1] = system.rate_after(&near, &(time + node * h));
        }
        let mut end = combined(&run.state, &self.rates, STEP, h);
        let stretched = run.project(&mut end);
        let end_rate = system.rate_after(&end, &(time + h));
        let size =
            largest(&[largest(end_rate.attitude.coords.as_slice()), largest(end_rate.momentum.as_slice())]);
        let mut error = largest(&[self.error(run, &end, h), stretched]) / run.tolerance;
        let decay = self.decay(&near, &end, &end_rate, h);
        if decay > DECAYED && error <= 1.0 {
            error = self.relative(run, &difference(&end, &near), &end, h) / run.tolerance;
        }
        // A stage overflowed: the step was far too long.
        let error = if error.is_nan() || !size.is_finite() { f64::INFINITY } else { error };
        // As usual: aim a little below the tolerance, and keep the change of the step within bounds.
        let factor = (0.9 / eighth_root(error)).clamp(1.0 / 3.0, 6.0);
        self.h = h * factor;
        if error <= 1.0 {
            run.count_stiffness(decay);
            self.first = core::mem::replace(&mut self.rates[0], end_rate);
            run.take(end, h, next);
        } else {
            run.rejected += 1;
        }
        Ok(())
    }

    /// The state `duration` seconds after the start of the last step, where the body was in the state `start`
    /// at the time `began`: by a shorter step from there, or several if its error is not below the tolerance.
    pub(super) fn within(
        &self,
        run: &Run,
        start: &State<f64>,
        began: f64,
        duration: f64,
    ) -> Result<State<f64>, Error> {
        let mut pair = Self { rates: [self.first; 12], first: self.first, h: duration };
        let end = began + duration;
        let mut part = Run { time: began, state: *start, duration: end, goal: end, ..run.clone() };
        let before = run.steps + run.rejected;
        while part.time != end {
            if part.steps + part.rejected > before + SHORTER_STEPS {
                return Err(part.no_step(pair.h));
            }
            pair.advance(&mut part)?;
        }
        Ok(part.state)
    }
}

fn eighth_root(x: f64) -> f64 {
    x.sqrt().sqrt().sqrt()
}
