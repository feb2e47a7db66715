//! How a driven body is stepped: on, finer, and at what price.

use crate::error::Error;
use crate::exact_drift;
use crate::prices;
use tumbling::step::{State, Stepper, System};

/// The least tolerance that an adaptive [`Stepper`] takes: below it a step's error is rounding.
pub(crate) const LEAST_TOLERANCE: f64 = 4.0 * f64::EPSILON;

/// How a driven body is stepped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum StepControl {
    /// With the exact drift between kicks, in steps of at most this many seconds.
    ExactDrift(f64),
    /// With an adaptive [`Stepper`] and this tolerance of a step.
    Tolerance(f64),
}

/// Why a run ended early.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Stop {
    /// The steps allowed are used up.
    OutOfSteps,
    /// A step is refused.
    Refused(Error),
}

impl From<Error> for Stop {
    fn from(error: Error) -> Self {
        Self::Refused(error)
    }
}

impl StepControl {
    /// The number of steps in `duration`; none where a tolerance decides.
    pub(crate) fn count(self, duration: f64) -> Option<usize> {
        let Self::ExactDrift(step) = self else { return None };
        parts(duration, step, 1).ok().map(|(count, _)| count)
    }

    /// The cost of a step, in instructions.
    pub(crate) fn price_of_step(self) -> f64 {
        match self {
            Self::ExactDrift(_) => prices::DRIFT,
            Self::Tolerance(tolerance) => prices::series(tolerance),
        }
    }

    /// The cost of a number of states in a number of steps, most of them by collocation if losses are stiff.
    pub(crate) fn price(self, states: u64, steps: usize, stiff: bool) -> f64 {
        let (states, steps) = (states as f64, steps as f64);
        match self {
            Self::Tolerance(_) => {
                let dearer = if stiff { prices::COLLOCATION } else { 1.0 };
                prices::BEGIN + dearer * self.price_of_step() * steps + prices::WITHIN * states
            }
            _ => self.price_of_step() * steps.max(states),
        }
    }

    /// The same, finer: by half or more, for an error smaller by the factor `share`; zero where no error was
    /// observed. A tolerance by a hundred: errors fall with it on average only, and where the motion
    /// multiplies them two runs ten times apart were seen to be wrong by the same, in 3 of 60 000 scenes.
    pub(crate) fn finer(self, share: f64) -> Self {
        let by = |root: f64| if share > 0.0 { (0.8 * root).clamp(1e-2, 0.5) } else { 0.5 };
        match self {
            // Errors fall as the second power of the step.
            Self::ExactDrift(step) => Self::ExactDrift(step * by(share.sqrt())),
            // Which costs a quarter more.
            Self::Tolerance(tolerance) => Self::Tolerance((0.01 * tolerance).max(LEAST_TOLERANCE)),
        }
    }
}

/// A driven body while it is stepped, from one time to the next.
#[derive(Debug, Clone)]
pub(crate) enum Stepping<'a> {
    /// In steps from one time to the next.
    Steps { control: StepControl, system: &'a System<f64>, now: f64, state: State<f64> },
    /// In steps of its own, with each state from the series of one.
    Series(Box<Stepper>),
}

impl<'a> Stepping<'a> {
    /// From the state at time zero, with at most this number of steps from one time to the next.
    pub(crate) fn new(
        control: StepControl,
        system: &'a System<f64>,
        start: &State<f64>,
        budget: usize,
    ) -> Result<Self, Error> {
        Ok(match control {
            StepControl::Tolerance(tolerance) => {
                Self::Series(Box::new(Stepper::of_system(system.clone(), start, tolerance, budget)?))
            }
            _ => Self::Steps { control, system, now: 0.0, state: *start },
        })
    }

    /// The state at a time, no earlier than the last; at least `least` steps of a fixed length lead to a
    /// later one. Steps are taken off those left.
    pub(crate) fn to(&mut self, time: f64, least: usize, left: &mut usize) -> Result<State<f64>, Stop> {
        match self {
            Self::Steps { control, system, now, state } => {
                if time > *now {
                    *state = control.advance(system, state, time - *now, least, left)?;
                    *now = time;
                }
                Ok(*state)
            }
            Self::Series(stepper) => {
                let before = stepper.steps_of_run();
                let state = stepper.step_to(time);
                let taken = stepper.steps_of_run() - before;
                let over = taken > *left || (taken == *left && state.is_err());
                *left = left.saturating_sub(taken);
                if over { Err(Stop::OutOfSteps) } else { Ok(state.map_err(Error::from)?) }
            }
        }
    }
}

impl StepControl {
    /// `duration` seconds on, in at least `least` steps of a fixed length.
    fn advance(
        self,
        system: &System<f64>,
        start: &State<f64>,
        duration: f64,
        least: usize,
        left: &mut usize,
    ) -> Result<State<f64>, Stop> {
        let step = if let Self::ExactDrift(step) = self { step } else { duration };
        let (count, h) = parts(duration, step, least)?;
        if count > *left {
            return Err(Stop::OutOfSteps);
        }
        let mut state = *start;
        for _ in 0..count {
            *left -= 1;
            state = exact_drift::step(system, &state, h)?;
        }
        Ok(state)
    }
}

/// The least number of equal parts, at least `least`, of which none is longer than `step`; and their length.
fn parts(duration: f64, step: f64, least: usize) -> Result<(usize, f64), Error> {
    let count = (duration / step).ceil().max(least as f64);
    if count.is_nan() || count > 1.0 / f64::EPSILON {
        return Err(Error::OutOfRange { what: "the number of steps", value: count });
    }
    Ok((count as usize, duration / count))
}
