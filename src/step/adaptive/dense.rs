//! An adaptive run with dense output: its state at any time, from the series of the step about it.

use super::flips::Flips;
use super::steps::Steps;
use super::{Run, Watch, check_tolerance, switching};
use crate::body::State;
use crate::error::{Error, Refusal, Subject, finite};
use crate::number::Analytic;
use crate::step::system::System;
use alloc::vec::Vec;
use num_traits::FromPrimitive;

/// A run by the steps of [`adaptive`](fn@super::adaptive), whose states are requested one after another: its
/// steps are as long as the tolerance permits, and a state between their ends is taken from the step's
/// series (dense output), as accurate as the step; where a torque is a function, from a shorter step. What is
/// requested on the way changes nothing of what follows.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// use tumbling::PrincipalMoments;
/// use tumbling::step::{AdaptiveRun, State, System, Torque, adaptive};
/// let top = Torque::gravity(&Vector3::new(0.05, 0.0, 0.1), 0.5);
/// let system = System::with(PrincipalMoments::new(1.0, 2.0, 2.5)?, vec![top])?;
/// let momentum = system.momentum(&Vector3::new(0.3, 2.0, 0.1));
/// let start = State { attitude: Quaternion::identity(), momentum };
/// // 600 frames of a film of 10 s.
/// let (mut run, mut budget) = (AdaptiveRun::new(&system, &start, 10.0, 1e-12)?, 1000);
/// for frame in 1..=600 {
///     run.at(f64::from(frame) / 60.0, &mut budget)?;
/// }
/// // The steps taken are those of the run without a film.
/// let mut alone = 1000;
/// assert_eq!(run.at(10.0, &mut budget)?, adaptive(&system, &start, 10.0, 1e-12, &mut alone)?);
/// assert!(budget == alone && 1000 - alone < 40);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct AdaptiveRun<'a, T: nalgebra::Scalar> {
    system: &'a System<T>,
    /// The piece under way: to where a torque begins or ends.
    run: Run<'a, T>,
    /// When the piece ends, s after the start.
    until: f64,
    steps: Steps<T>,
    /// Where the last step began, s after the start of the piece.
    before: (State<T>, f64),
}

impl<'a, T: Analytic + Copy + FromPrimitive> AdaptiveRun<'a, T> {
    /// From `start` to the time `end` (s after the start; before it, if negative), with an estimated error of
    /// at most `tolerance` in each step, as for [`adaptive`](fn@super::adaptive).
    ///
    /// # Errors
    /// As [`adaptive`](fn@super::adaptive).
    pub fn new(system: &'a System<T>, start: &State<T>, end: f64, tolerance: f64) -> Result<Self, Error> {
        Self::watching(system, start, end, tolerance, Watch { flips: None, slopes: None })
    }

    pub(super) fn watching(
        system: &'a System<T>,
        start: &State<T>,
        end: f64,
        tolerance: f64,
        watch: Watch<T>,
    ) -> Result<Self, Error> {
        finite(Subject::Duration, end)?;
        check_tolerance::<T>(tolerance)?;
        (*start).checked()?;
        let (acting, until) = switching::piece(system, 0.0, end);
        let run = Run { end, ..Run::new(acting, start, until, tolerance, watch)? };
        let (steps, before) = (Steps::new(&run)?, (run.state, 0.0));
        Ok(Self { system, run, until, steps, before })
    }

    /// The state at a time (s after the start) that is not before the last step: that of the last request, or
    /// later. The steps on the way, taken or rejected, are subtracted from `budget`.
    ///
    /// # Errors
    /// A time after the end or before the last step, or as [`adaptive`](fn@super::adaptive). After an error
    /// the run is where its last step took it.
    pub fn at(&mut self, time: f64, budget: &mut usize) -> Result<State<T>, Error> {
        let (one, other) = (self.run.from + self.before.1, self.run.end);
        let (first, last) = if one < other { (one, other) } else { (other, one) };
        if !(first..=last).contains(&finite(Subject::Time, time)?) {
            let (what, why) = (Subject::PastState, "request states in order");
            return Err(Refusal::Undefined { what, why }.into());
        }
        while !self.reached(time) {
            self.advance(budget)?;
        }
        let (run, (start, began)) = (&self.run, &self.before);
        let time = if time == self.until { run.duration } else { time - run.from };
        if time == run.time {
            return run.state.checked();
        }
        self.steps.within(run, start, *began, time - began)?.checked()
    }

    /// Whether the steps taken go as far as this time.
    fn reached(&self, time: f64) -> bool {
        let (from, until, run) = (self.run.from, self.until, &self.run);
        let within = if from < until { time <= until } else { time >= until };
        within && (run.time == run.duration || (time - from).abs() <= run.time.abs())
    }

    /// One step further; at the end of a piece, on to the next.
    fn advance(&mut self, budget: &mut usize) -> Result<(), Error> {
        let run = &mut self.run;
        if run.time == run.duration {
            return self.next_piece();
        }
        self.steps.choose(run, *budget)?;
        let before = (run.state, run.time);
        let done = self.steps.advance(run, budget);
        // A step that was refused has left its series about the state that the run is in.
        self.before = if run.time == before.1 { (run.state, run.time) } else { before };
        done
    }

    /// On from where a torque begins or ends.
    fn next_piece(&mut self) -> Result<(), Error> {
        let Run { from, end, .. } = self.run;
        let (acting, next) = switching::piece(self.system, self.until, end);
        let mut watch = self.run.watch.clone();
        watch.flips = watch.flips.map(|seen| seen.later(self.until - from));
        let start = self.run.state.checked()?;
        let run = Run {
            from: self.until,
            end,
            steps: self.run.steps,
            rejected: self.run.rejected,
            ..Run::new(acting, &start, next - self.until, self.run.tolerance, watch)?
        };
        self.steps = Steps::new(&run)?;
        (self.run, self.until) = (run, next);
        self.before = (self.run.state, 0.0);
        Ok(())
    }

    /// Takes the next step: where it began and ended, s after the start of the run. None at the end.
    pub(in crate::step) fn next_step(&mut self, budget: &mut usize) -> Result<Option<[f64; 2]>, Error> {
        while self.run.time != self.run.duration || self.until != self.run.end {
            let began = self.run.from + self.run.time;
            self.advance(budget)?;
            let whole = self.run.time == self.run.duration;
            let ended = if whole { self.until } else { self.run.from + self.run.time };
            if ended != began {
                return Ok(Some([began, ended]));
            }
        }
        Ok(None)
    }

    /// The state that the steps have led to.
    pub(in crate::step) fn state(&self) -> &State<T> {
        &self.run.state
    }

    pub(super) fn finish(&mut self, budget: &mut usize) -> Result<State<T>, Error> {
        self.at(self.run.end, budget)
    }

    /// The flips seen so far, and the sign since the last.
    pub(super) fn flips(self) -> (Vec<f64>, f64) {
        self.run.watch.flips.map(Flips::found).unwrap_or_default()
    }
}
