//! What takes the steps of a run: series, a pair where a torque is a function, or collocation where damping
//! is far faster than the motion.

use super::collocation::Collocation;
use super::pair::Pair;
use super::taylor::Taylor;
use super::{Run, STIFF, STIFF_STEPS, largest, ratio};
use crate::body::State;
use crate::error::{Error, Refusal, Subject};
use crate::number::Analytic;
use num_traits::FromPrimitive;

/// After this number of stiff steps, damping is solved for.
const DAMPED_STEPS: u32 = 4;

/// Rounding keeps steps of a tight tolerance below the bound of stability, so that none counts as stiff.
/// After each 16 steps damping is looked at that has more than a quarter of a decay time in the last.
const CHECKED_STEPS: usize = 16;
const LONG: f64 = 0.25;

/// Where it is this number of times faster than the motion: a step by collocation, of about a radian, takes
/// as long as some ten by series, of some seven decay times.
const FASTER: f64 = 64.0;

/// A momentum that decays has none left after this number of decay times.
const FADED: f64 = 800.0;

/// What takes the steps of a run under torques that act in all of it.
#[derive(Debug, Clone)]
pub(super) enum Steps<T: nalgebra::Scalar> {
    Series(Taylor<T>),
    Pair(Pair<T>),
    Collocation(Collocation<T>),
}

impl<T: Analytic + Copy + FromPrimitive> Steps<T> {
    /// Explicit ones.
    pub(super) fn new(run: &Run<T>) -> Result<Self, Error> {
        if let Some(series) = Taylor::new(&run.system, run.tolerance) {
            return Ok(Self::Series(series));
        }
        if run.flips.is_none() {
            return Pair::new(run).map(Self::Pair);
        }
        let why = if !run.system.sum_of_torques().functions.is_empty() {
            "steps under a torque that is a function have no series: give the torque by its name, or look for changes of sign"
        } else {
            "steps under two gravity gradients, or three rates of periodic torques, have no series: look for changes of sign"
        };
        Err(Refusal::Undefined { what: Subject::FlipTimes, why }.into())
    }

    /// What takes the next step: it may be another than took the last.
    pub(super) fn choose(&mut self, run: &mut Run<T>, budget: usize) -> Result<(), Error> {
        let solves = matches!(self, Self::Collocation(_));
        // A piece without a step tells nothing of its damping.
        let due = run.time != 0.0 && run.steps % CHECKED_STEPS == CHECKED_STEPS - 1;
        if run.stiff == 0 && solves {
            *self = Self::new(run)?;
        } else if !solves && (run.stiff >= DAMPED_STEPS || due) {
            self.solve_damping(run, budget)?;
        }
        Ok(())
    }

    /// One step further.
    pub(super) fn advance(&mut self, run: &mut Run<T>, budget: &mut usize) -> Result<(), Error> {
        if *budget == 0 {
            return Err(run.unfinished("all its steps are taken"));
        }
        let before = run.steps + run.rejected;
        let done = match self {
            Self::Series(series) => series.advance(run),
            Self::Pair(pair) => pair.advance(run),
            Self::Collocation(steps) => steps.advance(run),
        };
        *budget = budget.saturating_sub((run.steps + run.rejected - before).max(1));
        done
    }

    /// After some steps that stiffness keeps short: solves for damping, once the motion is slow.
    fn solve_damping(&mut self, run: &mut Run<T>, budget: usize) -> Result<(), Error> {
        let (system, state) = (&run.system, &run.state);
        let sum = system.sum_of_torques();
        let decay = largest(sum.damping.component_mul(system.inverse()).as_slice());
        if run.stiff < DAMPED_STEPS && decay * run.last <= LONG {
            return Ok(());
        }
        let change = change(run);
        let tracked = run.flips.is_some() || run.derivatives.is_some();
        if !tracked && sum.dissipation.is_zero() && decay * run.last > LONG {
            let rate = sum.periodic.iter().map(|torque| torque.rate.size()).fold(change, f64::max);
            if decay > FASTER * largest(system.omega(&state.momentum).as_slice()).max(rate) {
                *self = Self::Collocation(Collocation::new(run));
                run.stiff = DAMPED_STEPS;
                return Ok(());
            }
            if decay * run.last > STIFF {
                return Ok(());
            }
        }
        // To the end, or until nothing is left of the momentum.
        let left = run.ahead().abs().min(FADED / change) / run.last.abs();
        if run.stiff == STIFF_STEPS && left > budget as f64 {
            return Err(
                run.unfinished("damping or dissipation far faster than the motion keeps its steps short")
            );
        }
        Ok(())
    }

    /// The state `time` seconds after the start of the last step, where the body was in the state `start` at
    /// the time `began`.
    pub(super) fn within(
        &self,
        run: &Run<T>,
        start: &State<T>,
        began: f64,
        time: f64,
    ) -> Result<State<T>, Error> {
        match self {
            Self::Series(series) => Ok(series.within(run, start, time)),
            Self::Collocation(steps) => Ok(steps.within(run, start, time)),
            Self::Pair(pair) => pair.within(run, start, began, time),
        }
    }
}

/// The rate at which the momentum changes, relative to its size, 1/s.
fn change<T: Analytic + Copy + FromPrimitive>(run: &Run<T>) -> f64 {
    let rate = run.system.rate_after(&run.state, &Run::number(run.time)).momentum;
    ratio(largest(rate.as_slice()), largest(run.state.momentum.as_slice()))
}
