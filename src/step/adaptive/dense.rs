//! An adaptive run with dense output: its state at any time, from the series of the step about it.

use super::flips::Flips;
use super::pair::Pair;
use super::taylor::Taylor;
use super::{Run, Watch, check_tolerance, switching};
use crate::body::State;
use crate::error::{Error, Refusal, finite};
use crate::number::Analytic;
use crate::step::system::System;
use crate::step::torque::Torque;
use alloc::vec::Vec;
use num_traits::FromPrimitive;

/// A run by the steps of [`adaptive`](fn@super::adaptive), whose states are requested one after another: its
/// steps are as long as the tolerance permits, and a state between their ends is taken from the step's
/// series (dense output), as accurate as the step. Where a torque is a function, a step ends at each state
/// that is requested.
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
    /// s after the start, as all times here but those of the piece.
    end: f64,
    /// When the piece under way begins and ends: where a torque does.
    piece: [f64; 2],
    run: Run<'a, T>,
    engine: Engine<T>,
    /// Where the last step began, s after the start of the piece.
    before: (State<T>, f64),
}

/// What takes the steps of a piece.
#[derive(Debug, Clone)]
enum Engine<T: nalgebra::Scalar> {
    Series(Taylor<T>),
    Pair(Pair<T>),
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
        finite("the duration", end)?;
        check_tolerance::<T>(tolerance)?;
        (*start).checked()?;
        let (acting, until) = switching::piece(system, 0.0, end);
        let run = Run::new(acting, start, until, tolerance, watch)?;
        let (engine, before) = (Engine::new(&run)?, (run.state, 0.0));
        Ok(Self { system, end, piece: [0.0, until], run, engine, before })
    }

    /// The state at a time (s after the start) that is not before the last step: that of the last request, or
    /// later. The steps on the way, taken or rejected, are subtracted from `budget`.
    ///
    /// # Errors
    /// A time after the end or before the last step, or as [`adaptive`](fn@super::adaptive). After an error
    /// the run is where its last step took it.
    pub fn at(&mut self, time: f64, budget: &mut usize) -> Result<State<T>, Error> {
        let [from, _] = self.piece;
        let (one, other) = (from + self.before.1, self.end);
        let (first, last) = if one < other { (one, other) } else { (other, one) };
        if !(first..=last).contains(&finite("the time", time)?) {
            let (what, why) =
                ("the state at a time before the last step, or after the end", "request states in order");
            return Err(Refusal::Undefined { what, why }.into());
        }
        while !self.reached(time) {
            self.advance(time, budget)?;
        }
        let ([from, until], (start, began)) = (self.piece, &self.before);
        let time = if time == until { self.run.duration } else { time - from };
        match &self.engine {
            Engine::Series(series) if time != self.run.time => {
                series.within(&self.run, start, time - began).checked()
            }
            _ => self.run.state.checked(),
        }
    }

    /// Whether the steps taken go as far as this time.
    fn reached(&self, time: f64) -> bool {
        let [from, until] = self.piece;
        let within = time == until || (time - from).abs() < (until - from).abs();
        within && (self.run.time == self.run.duration || (time - from).abs() <= self.run.time.abs())
    }

    /// One step further, or to `time` by a pair; at the end of a piece, on to the next.
    fn advance(&mut self, time: f64, budget: &mut usize) -> Result<(), Error> {
        let ([from, until], run) = (self.piece, &mut self.run);
        if run.time == run.duration {
            return self.next_piece();
        }
        match &mut self.engine {
            Engine::Series(series) => {
                let before = (run.state, run.time);
                let done = run.advance(series, budget);
                // A step that was refused has left its series about the state that the run is in.
                self.before = if run.time == before.1 { (run.state, run.time) } else { before };
                done
            }
            Engine::Pair(pair) => {
                let whole = run.duration;
                if (time - from).abs() < (until - from).abs() {
                    run.duration = time - from;
                }
                let mut done = Ok(());
                while done.is_ok() && run.time != run.duration {
                    done = run.advance(pair, budget);
                }
                run.duration = whole;
                self.before = (run.state, run.time);
                done
            }
        }
    }

    /// On from where a torque begins or ends.
    fn next_piece(&mut self) -> Result<(), Error> {
        let [from, until] = self.piece;
        let (acting, next) = switching::piece(self.system, until, self.end);
        let mut watch = self.run.watch.clone();
        watch.flips = watch.flips.map(|seen| seen.later(until - from));
        let start = self.run.state.checked()?;
        let run = Run {
            from: until,
            end: self.end,
            steps: self.run.steps,
            rejected: self.run.rejected,
            ..Run::new(acting, &start, next - until, self.run.tolerance, watch)?
        };
        self.engine = Engine::new(&run)?;
        self.run = run;
        self.piece = [until, next];
        self.before = (self.run.state, 0.0);
        Ok(())
    }

    pub(super) fn finish(&mut self, budget: &mut usize) -> Result<State<T>, Error> {
        self.at(self.end, budget)
    }

    /// The flips seen so far, and the sign since the last.
    pub(super) fn flips(self) -> (Vec<f64>, f64) {
        self.run.watch.flips.map(Flips::found).unwrap_or_default()
    }
}

impl<T: Analytic + Copy + FromPrimitive> Engine<T> {
    fn new(run: &Run<'_, T>) -> Result<Self, Error> {
        if let Some(series) = Taylor::new(&run.system, run.tolerance) {
            return Ok(Self::Series(series));
        }
        if run.watch.flips.is_none() {
            return Pair::new(run).map(Self::Pair);
        }
        let function = run.system.torques().iter().any(|torque| matches!(torque, Torque::Function(_)));
        let (what, why) = if function {
            (
                "the times of flips under a torque that is a function",
                "its steps have no series: give the torque by its name, or look for changes of sign",
            )
        } else {
            (
                "the times of flips under two gravity gradients, or three rates of periodic torques",
                "the series of a step hold one and two: look for changes of sign",
            )
        };
        Err(Refusal::Undefined { what, why }.into())
    }
}
