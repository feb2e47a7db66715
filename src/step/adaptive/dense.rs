//! An adaptive run. The tolerance sets the lengths of its steps, and a state within the last step is read
//! from that step's series. A step also ends where a torque begins or ends, so a run consists of pieces in
//! each of which the same torques act.
//!
//! The steps are taken by series, by an embedded pair where a torque is a function, or by collocation where
//! damping is far faster than the motion.

use super::collocation::Collocation;
use super::flips::Flips;
use super::pair::Pair;
use super::series::identity;
use super::taylor::Taylor;
use super::{Run, STIFF, STIFF_STEPS, check_tolerance, largest, ratio};
use crate::body::State;
use crate::error::{Error, Refusal, Subject, finite};
use crate::step::method::check_square_underflow;
use crate::step::system::System;
use crate::step::torque::Torque;
use alloc::boxed::Box;
use alloc::sync::Arc;
use alloc::vec::Vec;
use nalgebra::Matrix6;

/// What a run keeps track of besides the state.
#[derive(Debug, Clone, Copy)]
pub(in crate::step) enum Tracked {
    Nothing,
    /// Changes of sign of the spin about the middle axis. The value is the sign before the start, or zero if
    /// it is not known.
    Flips(f64),
    /// The derivatives of attitude and spin with respect to those at the start.
    Variation,
}

/// Requesting a state does not change the states after it.
#[derive(Debug, Clone)]
pub(in crate::step) struct AdaptiveRun {
    system: Arc<System<f64>>,
    /// The current piece, up to the time where a torque begins or ends.
    run: Run,
    /// The end of the piece and the end of the run, s after the start.
    until: f64,
    end: f64,
    steps: Steps,
    /// The start of the last step, s after the start of the piece.
    before: (State<f64>, f64),
}

impl AdaptiveRun {
    /// From `start` to the time `end` (s after the start; before it, if negative), which may be infinite.
    pub(in crate::step) fn new(
        system: System<f64>,
        start: &State<f64>,
        end: f64,
        tolerance: f64,
        tracked: Tracked,
    ) -> Result<Self, Error> {
        check_tolerance(tolerance)?;
        (*start).checked()?;
        let system = Arc::new(if system.time == 0.0 { system } else { system.starting_at(system.time) });
        let (acting, until) = piece(&system, 0.0, end);
        let mut run = Run::new(acting, start, until, tolerance)?;
        match tracked {
            Tracked::Nothing => {}
            Tracked::Flips(before) => run.flips = Some(Flips::new(&system, start, before)),
            Tracked::Variation => run.variation = Some(Box::new(identity())),
        }
        let (steps, before) = (Steps::new(&run)?, (run.state, 0.0));
        Ok(Self { system, run, until, end, steps, before })
    }

    /// Whether a time is between the start of the last step and the end of the run.
    pub(in crate::step) fn holds(&self, time: f64) -> bool {
        let began = self.run.from + self.before.1;
        if self.end < 0.0 { self.end <= time && time <= began } else { began <= time && time <= self.end }
    }

    /// The state at a time (s after the start) that the run [holds](Self::holds). The steps that this takes,
    /// accepted or rejected, are subtracted from `budget`. After an error the run is at the end of its last
    /// accepted step.
    pub(in crate::step) fn at(&mut self, time: f64, budget: &mut usize) -> Result<State<f64>, Error> {
        finite(Subject::Duration, time)?;
        if !self.reached(time) {
            check_square_underflow(&self.run.system.omega(&self.run.state.momentum), &time)?;
        }
        while !self.reached(time) {
            self.advance(time, budget)?;
        }
        self.read(time)
    }

    /// The state at a time that the steps have [reached](Self::reached).
    pub(in crate::step) fn read(&self, time: f64) -> Result<State<f64>, Error> {
        let (run, (start, began)) = (&self.run, &self.before);
        let time = if time == self.until { run.duration } else { time - run.from };
        if time == run.time {
            return run.state.checked();
        }
        self.steps.within(run, start, *began, time - began)?.checked()
    }

    /// Whether the steps taken include this time.
    pub(in crate::step) fn reached(&self, time: f64) -> bool {
        let (from, until, run) = (self.run.from, self.until, &self.run);
        let within = if from < until { time <= until } else { time >= until };
        within && (run.time == run.duration || (time - from).abs() <= run.time.abs())
    }

    /// Takes one step toward `goal`; at the end of a piece, begins the next piece.
    fn advance(&mut self, goal: f64, budget: &mut usize) -> Result<(), Error> {
        let run = &mut self.run;
        if run.time == run.duration {
            return self.next_piece();
        }
        run.goal = goal - run.from;
        self.steps.choose(run, *budget)?;
        let before = (run.state, run.time);
        let done = self.steps.advance(run, budget);
        // After a refused step the series is about the current state of the run.
        self.before = if run.time == before.1 { (run.state, run.time) } else { before };
        done
    }

    /// Continues after a time where a torque begins or ends.
    fn next_piece(&mut self) -> Result<(), Error> {
        let (acting, next) = piece(&self.system, self.until, self.end);
        let mut run = Run::new(acting, &self.run.state.checked()?, next - self.until, self.run.tolerance)?;
        run.from = self.until;
        (run.steps, run.rejected) = (self.run.steps, self.run.rejected);
        run.variation = self.run.variation.take();
        run.flips = self.run.flips.clone();
        let renewed = if let Steps::Series(series) = &mut self.steps { series.renew(&run) } else { false };
        if !renewed {
            self.steps = Steps::new(&run)?;
        }
        (self.run, self.until) = (run, next);
        self.before = (self.run.state, 0.0);
        Ok(())
    }

    /// Takes the next step and returns its end, s after the start; `None` at the end of the run.
    pub(in crate::step) fn next_step(&mut self, budget: &mut usize) -> Result<Option<f64>, Error> {
        let taken = self.run.steps;
        while self.run.steps == taken && (self.run.time != self.run.duration || self.until != self.end) {
            self.advance(self.end, budget)?;
        }
        let ended =
            if self.run.time == self.run.duration { self.until } else { self.run.from + self.run.time };
        Ok((self.run.steps != taken).then_some(ended))
    }

    /// The state at the end of the last step.
    pub(in crate::step) fn state(&self) -> &State<f64> {
        &self.run.state
    }

    /// The derivatives of attitude and spin (rad/s) at the end of the last step, with respect to those at the
    /// start or where they [began anew](Self::vary_anew); the identity for a run that does not track them.
    pub(in crate::step) fn variation(&self) -> Matrix6<f64> {
        let variation = self.run.variation.as_deref().copied().unwrap_or_else(identity);
        Matrix6::from_fn(|i, j| variation[i / 3][i % 3][j])
    }

    /// From now on the derivatives are taken with respect to the current state.
    pub(in crate::step) fn vary_anew(&mut self) {
        self.run.variation = Some(Box::new(identity()));
        // The error of the variations limits the next steps again.
        self.run.stiff = 0;
    }

    /// The flips before the time `end` that were not returned yet, s after the start, and the sign of the
    /// spin before `end`; `None` for a run that does not look for flips.
    pub(in crate::step) fn take_flips(&mut self, end: f64) -> Option<(Vec<f64>, f64)> {
        let back = self.end < 0.0;
        self.run.flips.as_mut().map(|flips| flips.take_before(end, back))
    }

    /// Whether it looks for flips, on the way to times after this one.
    pub(in crate::step) fn flips_after(&self, time: f64, end: f64) -> bool {
        self.run.flips.is_some() && ((end < time) == (self.end < 0.0))
    }
}

/// The system under the torques that act from the time `from` to the next switch on the way to `end`, with
/// its own time zero at `from`; and the time of this switch, or the end.
fn piece(system: &Arc<System<f64>>, from: f64, end: f64) -> (Arc<System<f64>>, f64) {
    if !system.torques().iter().any(|torque| matches!(torque, Torque::During { .. })) {
        return (Arc::clone(system), end);
    }
    let until = next_switch(system, from, end);
    let (first, last) = if from < until { (from, until) } else { (until, from) };
    let acts = |(torque, [start, end]): (&Torque<f64>, [f64; 2])| {
        (start <= first && last <= end).then(|| torque.starting_at(from))
    };
    let torques = system.torques().iter().map(window).filter_map(acts).collect();
    (Arc::new(system.under(torques)), until)
}

/// A torque without its `During`s, and the times between which all of them let it act, s.
fn window(torque: &Torque<f64>) -> (&Torque<f64>, [f64; 2]) {
    let (mut torque, mut first, mut last) = (torque, f64::NEG_INFINITY, f64::INFINITY);
    while let Torque::During { start, end, torque: inner } = torque {
        (first, last) = (first.max(*start), last.min(*end));
        torque = inner;
    }
    (torque, [first, last])
}

/// The first switch after `from` on the way to `duration`, or `duration` if there is none.
fn next_switch(system: &System<f64>, from: f64, duration: f64) -> f64 {
    let ahead = |time: &f64| {
        if duration < 0.0 { *time < from && *time > duration } else { *time > from && *time < duration }
    };
    let switches = system.torques().iter().flat_map(|torque| window(torque).1).filter(ahead);
    switches.fold(duration, |next, time| if (time - from).abs() < (next - from).abs() { time } else { next })
}

/// The number of stiff steps after which damping is solved for.
const DAMPED_STEPS: u32 = 4;

/// With a tight tolerance, rounding keeps steps below the stability limit, so that none counts as stiff. So
/// every 16 steps the damping is examined if the last step was longer than a quarter of a decay time.
const CHECKED_STEPS: usize = 16;
const LONG: f64 = 0.25;

/// The damping must be this many times faster than the motion. A step by collocation is about a radian long
/// and costs about as much as ten steps by series, each of about seven decay times.
const FASTER: f64 = 64.0;

/// After this number of decay times nothing is left of a decaying momentum.
const FADED: f64 = 800.0;

/// The method that takes the steps of a run under torques that act in all of it.
#[derive(Debug, Clone)]
enum Steps {
    Series(Taylor),
    Pair(Pair),
    Collocation(Collocation),
}

impl Steps {
    /// An explicit method.
    fn new(run: &Run) -> Result<Self, Error> {
        if let Some(series) = Taylor::new(run) {
            return Ok(Self::Series(series));
        }
        let (what, why) = if run.variation.is_some() {
            (Subject::Transition, "a function has no derivatives: use another kind of torque")
        } else if run.flips.is_some() {
            let why = "a function has no series: use another kind of torque, or look for changes of sign";
            (Subject::FlipTimes, why)
        } else {
            return Pair::new(run).map(Self::Pair);
        };
        Err(Refusal::Undefined { what, why }.into())
    }

    /// Chooses the method of the next step, which may differ from that of the last.
    fn choose(&mut self, run: &mut Run, budget: usize) -> Result<(), Error> {
        let solves = matches!(self, Self::Collocation(_));
        // Before its first step a piece has no information on its damping.
        let due = run.time != 0.0 && run.steps % CHECKED_STEPS == CHECKED_STEPS - 1;
        if run.stiff == 0 && solves {
            *self = Self::new(run)?;
        } else if !solves && (run.stiff >= DAMPED_STEPS || due) {
            self.solve_damping(run, budget)?;
        }
        Ok(())
    }

    /// Takes one step.
    fn advance(&mut self, run: &mut Run, budget: &mut usize) -> Result<(), Error> {
        if *budget == 0 {
            return Err(run.unfinished("its budget of steps is used up"));
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

    /// If stiffness has kept some steps short and the motion is slow, switches to solving for the damping; an
    /// error where the remaining steps cannot reach the goal.
    fn solve_damping(&mut self, run: &mut Run, budget: usize) -> Result<(), Error> {
        let (system, state) = (&run.system, &run.state);
        let sum = &system.sum;
        let decay = largest(sum.damping.component_mul(&system.inverse).as_slice());
        if run.stiff < DAMPED_STEPS && decay * run.last <= LONG {
            return Ok(());
        }
        let change = change(run);
        let tracked = run.flips.is_some() || run.variation.is_some();
        if !tracked && sum.dissipation == 0.0 && decay * run.last > LONG {
            let rate = sum.periodic.iter().map(|torque| torque.rate.abs()).fold(change, f64::max);
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
    fn within(&self, run: &Run, start: &State<f64>, began: f64, time: f64) -> Result<State<f64>, Error> {
        match self {
            Self::Series(series) => Ok(series.within(run, start, time)),
            Self::Collocation(steps) => Ok(steps.within(run, start, time)),
            Self::Pair(pair) => pair.within(run, start, began, time),
        }
    }
}

/// The rate at which the momentum changes, relative to its size, 1/s.
fn change(run: &Run) -> f64 {
    let rate = run.system.rate_after(&run.state, &run.time).momentum;
    ratio(largest(rate.as_slice()), largest(run.state.momentum.as_slice()))
}
