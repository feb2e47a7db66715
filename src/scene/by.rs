//! How a driven body is stepped: on, finer, and at what price.

use super::cost;
use crate::error::{Error, Refusal};
use crate::flow;
use crate::step::{LEAST_TOLERANCE, Method, State, System, adaptive_within};

/// How a driven body is stepped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum By {
    /// With this method, in steps of at most so many seconds.
    Steps(Method, f64),
    /// With the exact flow between kicks.
    Flow(f64),
    /// With this tolerance of a step.
    Control(f64),
}

impl By {
    /// How many steps it takes; none where a tolerance says it.
    pub(super) fn count(self, duration: f64) -> Option<usize> {
        let (Self::Steps(_, step) | Self::Flow(step)) = self else { return None };
        parts(duration, step, 1).ok().map(|(count, _)| count)
    }

    /// `duration` seconds on, in so many steps at least if they are of a fixed length, which are taken off those left.
    ///
    /// # Errors
    /// [`ErrorKind::TooMany`](crate::ErrorKind) when none is left, or as the steps.
    pub(super) fn on(
        self,
        system: &System<f64>,
        start: &State<f64>,
        duration: f64,
        least: usize,
        left: &mut usize,
    ) -> Result<State<f64>, Error> {
        let (step, method) = match self {
            Self::Control(tolerance) => {
                return adaptive_within(system, start, duration, tolerance, left).map(|run| run.end);
            }
            Self::Steps(method, step) => (step, Some(method)),
            Self::Flow(step) => (step, None),
        };
        let (count, h) = parts(duration, step, least)?;
        if count > *left {
            return Err(Refusal::TooMany { what: "steps", count }.into());
        }
        let mut motion = *start;
        for _ in 0..count {
            *left -= 1;
            motion = match method {
                Some(method) => method.step(system, &motion, h)?,
                None => flow::step(system, &motion, h)?,
            };
        }
        Ok(motion)
    }

    /// What a step costs, in instructions.
    pub(super) fn price_of_step(self) -> f64 {
        match self {
            Self::Steps(Method::LinearisedImplicit, _) => cost::LINEARISED,
            Self::Steps(..) => cost::KICKED,
            Self::Flow(_) => cost::FLOW,
            Self::Control(_) => cost::PAIR,
        }
    }

    /// How many steps there are from a state to the next, at least.
    pub(super) fn least_steps(self) -> f64 {
        if let Self::Control(_) = self { cost::ANEW } else { 1.0 }
    }

    /// What so many states cost in so many steps, or in more where states are asked for more often.
    #[allow(clippy::cast_precision_loss)]
    pub(super) fn price(self, states: u64, steps: usize) -> f64 {
        self.price_of_step() * (steps as f64).max(self.least_steps() * states as f64)
    }

    /// The same, finer: by half or more, aiming at an error so many times as large.
    pub(super) fn finer(self, share: f64) -> Self {
        // Nothing seen yet: half, or a tenth of the tolerance.
        let by = |order: i32, first: f64| {
            if share > 0.0 { (0.8 * share.powf(1.0 / f64::from(order))).clamp(1e-2, 0.5) } else { first }
        };
        match self {
            Self::Steps(method @ Method::LinearisedImplicit, step) => Self::Steps(method, step * by(1, 0.5)),
            Self::Steps(method, step) => Self::Steps(method, step * by(2, 0.5)),
            Self::Flow(step) => Self::Flow(step * by(2, 0.5)),
            Self::Control(tolerance) => Self::Control((tolerance * by(1, 0.1)).max(LEAST_TOLERANCE)),
        }
    }
}

/// In how many equal parts, at least `least`, none is longer than `step`.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)] // whole, and below 2^53
fn parts(duration: f64, step: f64, least: usize) -> Result<(usize, f64), Error> {
    let count = (duration / step).ceil().max(least as f64);
    if count.is_nan() || count > 1.0 / f64::EPSILON {
        return Err(Refusal::OutOfRange { what: "the number of steps", value: count }.into());
    }
    Ok((count as usize, duration / count))
}
