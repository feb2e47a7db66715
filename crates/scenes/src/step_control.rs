//! How a driven body is stepped: on, finer, and at what price.

use crate::error::Error;
use crate::exact_drift;
use crate::prices;
use tumbling::step::{Method, State, System, adaptive};

/// The least tolerance that [`adaptive`] takes: below it a step's error is rounding.
pub(crate) const LEAST_TOLERANCE: f64 = 4.0 * f64::EPSILON;

/// How a driven body is stepped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum StepControl {
    /// With this method, in steps of at most this many seconds.
    Fixed(Method, f64),
    /// With the exact drift between kicks, in steps of at most this many seconds.
    ExactDrift(f64),
    /// With Taylor series and this tolerance of a step.
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
        let (Self::Fixed(_, step) | Self::ExactDrift(step)) = self else { return None };
        parts(duration, step, 1).ok().map(|(count, _)| count)
    }

    /// `duration` seconds on, in at least `least` steps if they are of a fixed length; they are taken off
    /// those left.
    pub(crate) fn advance(
        self,
        system: &System<f64>,
        start: &State<f64>,
        duration: f64,
        least: usize,
        left: &mut usize,
    ) -> Result<State<f64>, Stop> {
        let (step, method) =
            match self {
                Self::Tolerance(tolerance) => {
                    let end = adaptive(system, start, duration, tolerance, left);
                    return end.map_err(|error| {
                        if *left == 0 { Stop::OutOfSteps } else { Stop::Refused(error.into()) }
                    });
                }
                Self::Fixed(method, step) => (step, Some(method)),
                Self::ExactDrift(step) => (step, None),
            };
        let (count, h) = parts(duration, step, least)?;
        if count > *left {
            return Err(Stop::OutOfSteps);
        }
        let mut state = *start;
        for _ in 0..count {
            *left -= 1;
            state = match method {
                Some(method) => {
                    method.step(system, &state, h).map_err(|error| Stop::Refused(error.into()))?
                }
                None => exact_drift::step(system, &state, h)?,
            };
        }
        Ok(state)
    }

    /// `duration` seconds on, in as many steps as that takes.
    #[inline]
    pub(crate) fn to_the_end(
        self,
        system: &System<f64>,
        start: &State<f64>,
        duration: f64,
    ) -> Result<State<f64>, Error> {
        self.advance(system, start, duration, 1, &mut { usize::MAX }).map_err(|stop| match stop {
            Stop::Refused(error) => error,
            Stop::OutOfSteps => Error::OutOfRange { what: "the number of steps", value: f64::INFINITY },
        })
    }

    /// The cost of a step, in instructions.
    pub(crate) fn price_of_step(self) -> f64 {
        match self {
            Self::Fixed(Method::LinearisedImplicit, _) => prices::LINEARISED,
            Self::Fixed(..) => prices::KICKED,
            Self::ExactDrift(_) => prices::DRIFT,
            Self::Tolerance(tolerance) => prices::series(tolerance),
        }
    }

    /// The least number of steps from one state to the next.
    pub(crate) fn least_steps(self) -> f64 {
        if let Self::Tolerance(_) = self { prices::RESTART } else { 1.0 }
    }

    /// The cost of a number of states in a number of steps, or in more where states are requested more often.
    pub(crate) fn price(self, states: u64, steps: usize) -> f64 {
        self.price_of_step() * (steps as f64).max(self.least_steps() * states as f64)
    }

    /// The same, finer: by half or more, for an error smaller by the factor `share`; zero where no error was
    /// observed.
    pub(crate) fn finer(self, share: f64) -> Self {
        // Nothing observed yet: half, or a tenth of the tolerance.
        let by = |root: f64, first: f64| if share > 0.0 { (0.8 * root).clamp(1e-2, 0.5) } else { first };
        // Errors fall as the first or the second power of the step.
        let (first_order, second_order) = (share, share.sqrt());
        match self {
            Self::Fixed(method @ Method::LinearisedImplicit, step) => {
                Self::Fixed(method, step * by(first_order, 0.5))
            }
            Self::Fixed(method, step) => Self::Fixed(method, step * by(second_order, 0.5)),
            Self::ExactDrift(step) => Self::ExactDrift(step * by(second_order, 0.5)),
            Self::Tolerance(tolerance) => {
                Self::Tolerance((tolerance * by(first_order, 0.1)).max(LEAST_TOLERANCE))
            }
        }
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
