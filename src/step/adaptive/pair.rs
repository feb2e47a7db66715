//! Steps by the pair of Dormand and Prince of orders 8, 5 and 3 [HNW93](crate::references), for torques that
//! are functions.

use super::columns::Columns;
use super::dop853_coefficients::{FIFTH, STAGES, STEP, THIRD, Weights};
use super::{Run, largest, over};
use crate::body::{Rate, State};
use crate::error::{Error, Refusal, Subject};
use crate::number::Analytic;
use crate::number::power_of_two::{exponent, times_power_of_two};
use nalgebra::{Quaternion, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;
use num_traits::FromPrimitive;

/// The slopes of a step.
#[derive(Debug, Clone)]
pub(super) struct Pair<T: nalgebra::Scalar> {
    slopes: [Rate<T>; 12],
    /// The next step, s.
    h: f64,
}

/// `start + h (sum of weights times slopes)`.
fn combined<T: Analytic + Copy + FromPrimitive>(
    start: &State<T>,
    slopes: &[Rate<T>],
    weights: Weights,
    h: T,
) -> State<T> {
    let mut sum = *start;
    for &(k, weight) in weights {
        sum = sum.plus(&slopes[k], h * Run::<T>::number(weight));
    }
    sum
}

impl<T: Analytic + Copy + FromPrimitive> Pair<T> {
    pub(super) fn new(run: &Run<'_, T>) -> Result<Self, Error> {
        let slope = run.system.rate_after(&run.state, &Run::number(run.time));
        let size = largest(&[largest(slope.attitude.coords.as_slice()), largest(slope.momentum.as_slice())]);
        if !size.is_finite() {
            return Err(Refusal::OutOfRange { what: Subject::RateAtStart, value: size }.into());
        }
        // How fast it turns, and how fast a torque would have it turn. Should the guess be too long, its
        // error will say so.
        let torque = largest(run.system.torque_after(&run.state, &Run::number(run.time)).as_slice());
        let turning =
            over(largest(slope.attitude.coords.as_slice()), largest(run.state.attitude.coords.as_slice()));
        let pace = (2.0 * turning).max((torque * largest(run.system.inverse().as_slice())).sqrt());
        let guess = eighth_root(run.tolerance) / pace;
        let remaining = run.duration - run.time;
        let h = if guess < remaining.abs() { guess.copysign(remaining) } else { remaining };
        Ok(Self { slopes: [slope; 12], h })
    }

    /// The estimated error of a step, the larger of attitude's and momentum's, each relative to its own size:
    /// of the differences from a step of order 5 and one of order 3, as [HNW93](crate::references), II.10.
    fn error(&self, run: &Run<'_, T>, end: &State<T>, h: f64) -> f64 {
        let zero = T::zero();
        let nothing =
            State { attitude: Quaternion::new(zero, zero, zero, zero), momentum: Vector3::repeat(zero) };
        let by = |weights: Weights| combined(&nothing, &self.slopes, weights, Run::number(h));
        let (fifth, whole, third) = (by(FIFTH), by(STEP), by(THIRD));
        let third = State {
            attitude: Quaternion::from_vector(whole.attitude.coords - third.attitude.coords),
            momentum: whole.momentum - third.momentum,
        };
        let [fifth, third] = [&fifth, &third].map(|off| self.relative(run, off, end, h));
        // By a power of two, so that no square leaves the range.
        let unit = -exponent(largest(&[fifth, third]));
        let [one, other] = [fifth, third].map(|x| times_power_of_two(x, unit));
        over(one, (one * one + 0.01 * other * other).sqrt()) * fifth
    }

    fn relative(&self, run: &Run<'_, T>, off: &State<T>, end: &State<T>, h: f64) -> f64 {
        // A body that starts at rest has no momentum to measure by; what a torque gives it in the step will
        // do.
        let gained = largest(self.slopes[0].momentum.as_slice()) * h.abs();
        // Nor does one that drag brought to rest: below this its momentum has no digits to the tolerance.
        let least = f64::MIN_POSITIVE / run.tolerance;
        let held = largest(run.state.momentum.as_slice()) + gained;
        let mut whole = held.max(least);
        if held == 0.0 {
            // At rest, and the torque is still to come: what it has given by the end, and no less than a turn
            // of a radian in the whole time asks for.
            let slow = over(1.0, largest(run.system.inverse().as_slice()) * run.duration.abs());
            whole = whole.max(largest(end.momentum.as_slice())).max(slow);
        }
        let attitude =
            over(largest(off.attitude.coords.as_slice()), largest(run.state.attitude.coords.as_slice()));
        let slopes = run.watch.slopes.map_or(0.0, |slopes| {
            let spun = |state: &State<T>| run.system.omega(&state.momentum).map(|x| x * Run::number(h));
            let columns =
                Columns::of(slopes, run.state.attitude.coords.as_slice(), spun(&run.state).as_slice());
            columns.share(off.attitude.coords.iter().chain(&spun(off)))
        });
        largest(&[attitude, largest(off.momentum.as_slice()) / whole, slopes])
    }

    /// The step in decay times: of two states near its end, how much faster the rates differ than the states.
    fn decay(&self, near: &State<T>, end: &State<T>, end_slope: &Rate<T>, h: f64) -> f64 {
        let apart = |a: &Vector3<T>, b: &Vector3<T>| largest((a - b).as_slice());
        let rates = apart(&end_slope.momentum, &self.slopes[11].momentum);
        h.abs() * over(rates, apart(&end.momentum, &near.momentum))
    }
}

impl<T: Analytic + Copy + FromPrimitive> Pair<T> {
    /// One step tried, and taken if its error is below the tolerance.
    pub(super) fn advance(&mut self, run: &mut Run<'_, T>) -> Result<(), Error> {
        let (h, last) = run.fitted(self.h)?;
        let step = Run::number(h);
        let mut near = run.state;
        for (k, (node, weights)) in STAGES.iter().enumerate() {
            near = combined(&run.state, &self.slopes, weights, step);
            self.slopes[k + 1] = run.system.rate_after(&near, &Run::number(run.time + node * h));
        }
        let mut end = combined(&run.state, &self.slopes, STEP, step);
        let stretched = run.project(&mut end);
        let end_slope = run.system.rate_after(&end, &Run::number(run.time + h));
        let size =
            largest(&[largest(end_slope.attitude.coords.as_slice()), largest(end_slope.momentum.as_slice())]);
        let error = largest(&[self.error(run, &end, h), stretched]) / run.tolerance;
        // A stage that left the range: the step was far too long.
        let error = if error.is_nan() || !size.is_finite() { f64::INFINITY } else { error };
        // As usual: aim a little below the tolerance, and change the step by no more than so much.
        let factor = (0.9 / eighth_root(error)).clamp(1.0 / 3.0, 6.0);
        self.h = h * factor;
        if error <= 1.0 {
            run.count_losses(self.decay(&near, &end, &end_slope, h));
            self.slopes[0] = end_slope;
            run.take(end, h, last);
        } else {
            run.rejected += 1;
        }
        Ok(())
    }
}

fn eighth_root(x: f64) -> f64 {
    x.sqrt().sqrt().sqrt()
}
