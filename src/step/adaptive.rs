//! A run whose steps are chosen by their error: the pair of Dormand and Prince, orders 5 and 4.

use super::methods::dormand_prince::Stages;
use crate::body::{Rate, State};
use crate::error::{Error, Refusal, finite, positive};
use crate::number::Analytic;
use crate::number::functions::fifth_root;
use crate::step::method::check_square_underflow;
use crate::step::system::System;
use nalgebra::{Quaternion, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;
use num_traits::FromPrimitive;

/// The state `duration` seconds after `start` (before, if negative), by steps that keep the estimated error
/// of each, relative to the attitude's length and the momentum's size, below `tolerance`.
///
/// After each step the attitude is brought back to length 1, and the momentum of a free body to the length
/// that it had at the start; what they were off by counts as an error of the step.
///
/// The first step follows from how fast the body turns; each of the others from the error of the one before.
/// The tolerance is of a step, not of the run: errors add up. A body of any tensor goes by
/// [`Stepper::adaptive`](crate::step::Stepper::adaptive).
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// use tumbling::PrincipalMoments;
/// use tumbling::exact::FreeMotion;
/// use tumbling::step::{State, System, adaptive};
/// let (moments, omega) = (PrincipalMoments::new(1.0, 2.0, 2.5)?, Vector3::new(0.3, 2.0, 0.1));
/// let system = System::free(moments)?;
/// let start = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
/// let end = adaptive(&system, &start, 10.0, 1e-10, &mut 1000)?;
/// let truth = FreeMotion::new(moments, &omega)?.at(10.0)?;
/// assert!((end.attitude.coords - truth.attitude.coords).norm() < 1e-8);
/// # Ok::<(), tumbling::Error>(())
/// ```
///
/// It takes at most `budget` steps, taken or rejected; those used are subtracted from it, also where the run
/// fails.
///
/// # Errors
/// A duration that is not finite, an attitude of no length, a tolerance below four roundings of `T`, a
/// motion that leaves what `T` holds, an error that stays too large however short the step; one of kind
/// [`TooMany`](crate::ErrorKind::TooMany) after `budget` steps, or as soon as stiff losses would need more.
pub fn adaptive<T: Analytic + Copy + FromPrimitive>(
    system: &System<T>,
    start: &State<T>,
    duration: f64,
    tolerance: f64,
    budget: &mut usize,
) -> Result<State<T>, Error> {
    finite("the duration", duration)?;
    check_tolerance::<T>(tolerance)?;
    (*start).checked()?;
    let mut run = Run::new(system, start, duration, tolerance)?;
    while run.time != duration {
        if *budget == 0 {
            return Err(run.unfinished("all its steps are taken"));
        }
        *budget -= 1;
        run.advance()?;
        if run.stiff == STIFF_STEPS && (duration - run.time).abs() / run.h.abs() > *budget as f64 {
            return Err(run.unfinished("losses far faster than the motion keep its steps short"));
        }
    }
    run.state.checked()
}

/// That the tolerance of a step is above rounding.
pub(super) fn check_tolerance<T: Analytic>(tolerance: f64) -> Result<(), Error> {
    positive("the tolerance", tolerance)?;
    let least = 4.0 * T::rounding();
    if tolerance >= least {
        return Ok(());
    }
    let (smaller, larger) = ("rounding in a step", "the tolerance");
    Err(Refusal::Order { smaller, small: least, larger, large: tolerance }.into())
}

/// A step of more than this many decay times is held back by stability, not by its error: the bound of
/// [HW96](crate::references), IV.2, for this pair.
const STIFF: f64 = 3.25;

/// After this number of such steps in a row the law is taken to be stiff.
const STIFF_STEPS: u32 = 15;

/// A run on its way.
struct Run<'a, T: Analytic> {
    system: &'a System<T>,
    duration: f64,
    tolerance: f64,
    /// Seconds since the start.
    time: f64,
    state: State<T>,
    /// The length of the momentum of a free body, which does not change; zero with torques.
    momentum: T,
    /// The rates at `state`.
    slope: Rate<T>,
    /// The next step, s.
    h: f64,
    steps: usize,
    rejected: usize,
    /// The number of stiff steps without six others between them.
    stiff: u32,
    /// The number of steps since that were not.
    mild: u32,
}

impl<'a, T: Analytic + Copy + FromPrimitive> Run<'a, T> {
    fn new(system: &'a System<T>, start: &State<T>, duration: f64, tolerance: f64) -> Result<Self, Error> {
        check_square_underflow(&system.omega(&start.momentum), &Self::number(duration))?;
        let mut state = *start;
        positive("the length of the attitude quaternion", normalize(&mut state.attitude))?;
        let slope = system.rate(&state);
        let size = largest(&[largest(slope.attitude.coords.as_slice()), largest(slope.momentum.as_slice())]);
        if !size.is_finite() {
            return Err(Refusal::OutOfRange { what: "the rate at the start", value: size }.into());
        }
        // How fast it turns, and how fast a torque would have it turn. Should the guess be too long, its
        // error will say so.
        let torque = largest(system.torque(&state).as_slice());
        let turning =
            over(largest(slope.attitude.coords.as_slice()), largest(state.attitude.coords.as_slice()));
        let pace = (2.0 * turning).max((torque * largest(system.inverse().as_slice())).sqrt());
        let guess = fifth_root(tolerance) / pace;
        let h = if guess < duration.abs() { guess.copysign(duration) } else { duration };
        let momentum = if system.is_free() { Self::length(&state.momentum) } else { T::zero() };
        let (time, steps, rejected, stiff, mild) = (0.0, 0, 0, 0, 0);
        Ok(Self {
            system,
            duration,
            tolerance,
            time,
            state,
            momentum,
            slope,
            h,
            steps,
            rejected,
            stiff,
            mild,
        })
    }

    fn number(x: f64) -> T {
        T::from_f64(x).unwrap_or_else(T::zero)
    }

    /// One step tried, and taken if its error is below the tolerance.
    fn advance(&mut self) -> Result<(), Error> {
        let last = (self.duration - self.time).abs() <= self.h.abs();
        let h = if last { self.duration - self.time } else { self.h };
        if !last && self.time + h == self.time {
            return Err(Refusal::NotConverged {
                what: "the step whose error meets the tolerance",
                iterations: self.steps + self.rejected,
                residual: h,
            }
            .into());
        }
        let (step, end_time) = (Self::number(h), Self::number(self.time + h));
        let mut stages = Stages::new(self.system, &self.state, self.slope, &Self::number(self.time), &step);
        let stretched = self.project(&mut stages.end);
        let end_slope = self.system.rate_after(&stages.end, &end_time);
        let error = self.error(&stages.error(&end_slope, &step), &stages.end, h);
        let error = largest(&[error, stretched]) / self.tolerance;
        // A stage that left the range: the step was far too long.
        let error = if error.is_nan() { f64::INFINITY } else { error };
        // As usual: aim a little below the tolerance, and change the step by no more than tenfold.
        let factor = (0.9 / fifth_root(error)).clamp(0.1, 10.0);
        if error <= 1.0 {
            self.watch(&stages, &end_slope, h);
            (self.state, self.slope) = (stages.end, end_slope);
            self.steps += 1;
            self.time = if last { self.duration } else { self.time + h };
        } else {
            self.rejected += 1;
        }
        self.h = h * factor;
        Ok(())
    }

    /// Brings attitude and momentum back to the lengths that do not change; returns how far off they were,
    /// relative to these.
    fn project(&self, end: &mut State<T>) -> f64 {
        let attitude = normalize(&mut end.attitude) - 1.0;
        if self.momentum.is_zero() {
            return attitude.abs();
        }
        let scale = self.momentum / Self::length(&end.momentum);
        end.momentum.apply(|x| *x *= scale);
        largest(&[attitude, (scale - T::one()).size()])
    }

    /// The length of a momentum whose squares may leave the range of `T`.
    fn length(momentum: &Vector3<T>) -> T {
        let size = Self::number(largest(momentum.as_slice()));
        if size.is_zero() {
            return size;
        }
        let part = momentum.map(|x| x / size);
        size * part.dot(&part).sqrt()
    }

    /// The estimated error of a step, the larger of attitude's and momentum's, each relative to its own size.
    fn error(&self, off: &State<T>, end: &State<T>, h: f64) -> f64 {
        // A body that starts at rest has no momentum to measure by; what a torque gives it in the step will
        // do.
        let gained = largest(self.slope.momentum.as_slice()) * h.abs();
        // Nor does one that drag brought to rest: below this its momentum has no digits to the tolerance.
        let least = f64::MIN_POSITIVE / self.tolerance;
        let held = largest(self.state.momentum.as_slice()) + gained;
        let mut whole = held.max(least);
        if held == 0.0 {
            // At rest, and the torque is still to come: what it has given by the end, and no less than a turn
            // of a radian in the whole time asks for.
            let slow = over(1.0, largest(self.system.inverse().as_slice()) * self.duration.abs());
            whole = whole.max(largest(end.momentum.as_slice())).max(slow);
        }
        let attitude =
            over(largest(off.attitude.coords.as_slice()), largest(self.state.attitude.coords.as_slice()));
        let momentum = over(largest(off.momentum.as_slice()), whole);
        largest(&[attitude, momentum])
    }

    /// Counts steps that are long relative to the fastest decay: of two states near the end of the step, how
    /// much faster the rates differ than the states.
    fn watch(&mut self, stages: &Stages<T>, end_slope: &Rate<T>, h: f64) {
        let apart = |a: &Vector3<T>, b: &Vector3<T>| largest((a - b).as_slice());
        let [.., near_slope] = &stages.slopes;
        let decay = h.abs()
            * over(
                apart(&end_slope.momentum, &near_slope.momentum),
                apart(&stages.end.momentum, &stages.near.momentum),
            );
        if decay > STIFF {
            (self.stiff, self.mild) = ((self.stiff + 1).min(STIFF_STEPS), 0);
        } else {
            self.mild += 1;
            if self.mild == 6 {
                self.stiff = 0;
            }
        }
    }

    fn unfinished(&self, why: &'static str) -> Error {
        let steps = self.steps + self.rejected;
        Refusal::Unfinished {
            what: "an adaptive run",
            steps,
            reached: self.time,
            duration: self.duration,
            why,
        }
        .into()
    }
}

/// Brings the attitude to length 1; returns its length before.
fn normalize<T: Analytic>(attitude: &mut Quaternion<T>) -> f64 {
    let length = attitude.coords.dot(&attitude.coords).sqrt();
    attitude.coords.apply(|x| *x /= length.clone());
    length.size()
}

/// The size of the largest number, without a square, which would leave the range before the number does; NaN
/// if one is.
fn largest<T: Analytic>(parts: &[T]) -> f64 {
    parts.iter().map(Analytic::size).fold(0.0, |most, x| if x > most || x.is_nan() { x } else { most })
}

/// A share, of which zero is zero of anything.
fn over(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inertia::PrincipalMoments;
    use crate::step::torque::Torque;

    #[test]
    fn a_controlled_run_takes_back_steps_that_were_too_long() {
        // A needle let go a thousandth of a radian from standing against the field: it hardly moves for long,
        // then swings through. Energy, of motion and of place, must be the same wherever the run ends.
        let pull = 3.0;
        let aligning = Torque::Aligning { arm: Vector3::x(), field: Vector3::x() * -pull };
        let system = System::with(PrincipalMoments::new(1.0, 1.5, 2.0).unwrap(), vec![aligning]).unwrap();
        let (sine, cosine) = 5e-4_f64.sin_cos();
        let from = State { attitude: Quaternion::new(cosine, 0.0, 0.0, sine), momentum: Vector3::zeros() };
        let energy = |state: &State<f64>| {
            crate::dynamics::observe::energy(&system.omega(&state.momentum), &state.momentum)
                + pull * crate::attitude::rotation_matrix(&state.attitude)[(0, 0)]
        };
        let mut run = Run::new(&system, &from, 40.0, 1e-9).unwrap();
        while run.time != 40.0 {
            run.advance().unwrap();
        }
        assert!(run.rejected > 0, "{}", run.steps);
        assert!((energy(&run.state) - energy(&from)).abs() < 1e-6, "{:?}", run.state);
    }
}
