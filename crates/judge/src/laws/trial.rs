//! A trial: rows in, and what they do to the laws noted, up to where a motion starts anew: a step out of all
//! proportion, or back at the start without a way there.

use crate::error::Error;
use crate::laws::{Laws, Stretch, Stretches};
use crate::read::{Known, Pair, Row, angle_between};
use crate::rule::Subject;
use crate::thresholds::*;
use nalgebra::Vector3;
use serde::Serialize;
use tumbling::dynamics::euler;

/// Steps that have no row.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Gaps {
    /// How often rows are missing.
    pub count: u64,
    /// The first line after such a place.
    pub line: usize,
    /// How many steps the longest is.
    pub longest: f64,
}

/// Of a stretch the first steps are kept.
impl Stretch for [Pair; TRIED_RUN] {
    fn join(&self, _: &Self) -> Self {
        *self
    }
}

/// A trial as far as it has come.
pub(crate) struct Trial {
    pub known: Known,
    pub laws: Laws,
    pub first: Row,
    /// Steps of a record of any length, evenly from all of it, in runs of steps that follow one another; the
    /// run that is not full yet, and how many steps there are.
    runs: Stretches<[Pair; TRIED_RUN]>,
    run: Vec<Pair>,
    pub steps: u64,
    /// How many rows repeat the row before them, how often such rows come to an end, and whether the last row
    /// is one.
    equal: [u64; 2],
    is_equal: bool,
    jumps: Jumps,
    pub resets: Vec<Reset>,
    pub gaps: Option<Gaps>,
    last: Option<Row>,
    pub rows: u64,
    /// The number of pairs of rows that follow one another, however far apart.
    pub pairs: u64,
    /// At which line the attitude turns too far for its direction to be known, and by how much, rad.
    pub stopped: Option<(usize, f64)>,
    /// Where the numbers end, and with what.
    pub ended: Option<String>,
}

impl Trial {
    pub(crate) fn new(subject: &Subject, first: Row, known: Known) -> Result<Self, Error> {
        let (has_spin, floor, errors) = (known.has_spin(), known.floor.size, Errors::default());
        let Subject { moments, torque, .. } = *subject;
        Ok(Self {
            laws: Laws::new(&moments, &first, known.floor)?,
            first,
            runs: Stretches::new(TRIED_STEPS / TRIED_RUN),
            run: Vec::new(),
            steps: 0,
            equal: [0; 2],
            is_equal: false,
            jumps: Jumps { first, moments, torque, has_spin, floor, errors },
            known,
            resets: Vec::new(),
            gaps: None,
            last: None,
            rows: 0,
            pairs: 0,
            stopped: None,
            ended: None,
        })
    }

    /// One more row.
    pub(crate) fn row(&mut self, state: &Row) -> Result<(), Error> {
        let mut steps = 0.0;
        if let Some(last) = self.last.replace(*state) {
            let (h, times) = self.known.clock.between(last.t, state.t);
            steps = times;
            if times > 1.0 {
                let gaps = self.gaps.get_or_insert(Gaps { count: 0, line: state.line, longest: 0.0 });
                gaps.count += 1;
                gaps.longest = gaps.longest.max(times);
            }
            let pair = Pair { from: last, to: *state, h };
            let reset = self.jumps.reset(&pair, times);
            if self.resets.len() < RESETS {
                self.resets.extend(reset);
            }
            self.pairs += u64::from(self.resets.is_empty());
            if self.resets.is_empty() && times == 1.0 {
                if self.jumps.has_spin {
                    self.laws.pair(&pair);
                }
                if self.jumps.has_spin || state.ahead.is_some() {
                    self.step(pair);
                }
            }
        }
        if self.resets.is_empty() {
            self.laws.push(state, steps)?;
        }
        Ok(())
    }

    /// One more step, and whether its row is the row before it.
    fn step(&mut self, pair: Pair) {
        self.steps += 1;
        let was = self.is_equal;
        self.is_equal = pair.from.omega == pair.to.omega && pair.from.attitude == pair.to.attitude;
        self.equal[0] += u64::from(self.is_equal);
        self.equal[1] += u64::from(was && !self.is_equal);
        self.run.push(pair);
        if let Ok(run) = self.run[..].try_into() {
            self.runs.push(run);
            self.run.clear();
        }
    }

    /// The steps that rules are tried on.
    pub(crate) fn sample(&self) -> Vec<Pair> {
        [&self.runs.all().concat()[..], &self.run].concat()
    }

    /// Whether rows are written again under other times. A body that comes to stay is none, nor is, of spins
    /// alone, one whose spin stays between rare pushes.
    pub(crate) fn repeats(&self) -> bool {
        let ([equal, ends], steps) = (self.equal.map(|count| count as f64), self.steps as f64);
        let stays = self.first.attitude.is_none() && 2.0 * equal > steps && ends * JUMP_EVERY as f64 <= steps;
        ends > 1.0 && equal > STRAIGHT[1] * steps && !stays
    }
}

/// A row at which the motion starts anew.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reset {
    /// Its line in the file.
    pub line: usize,
    /// Its time, s.
    pub time: f64,
    /// Whether the body was put to rest.
    pub to_rest: bool,
    /// Whether it was put back to its start.
    pub to_start: bool,
}

/// What the steps so far were off by, and what a next one is held against.
pub(crate) struct Jumps {
    pub first: Row,
    pub moments: Vector3<f64>,
    /// Constant in the world, N m.
    pub torque: Option<Vector3<f64>>,
    /// Whether the record has spins.
    pub has_spin: bool,
    /// The rounding of the numbers, relative to 1.
    pub floor: f64,
    pub errors: Errors,
}

/// How far steps were off the law, relative to the spin or in rad.
#[derive(Default)]
pub(crate) struct Errors {
    /// The most in spin or turn, slowly forgotten.
    off: f64,
    /// How many steps there were.
    steps: u64,
    /// The most in turn.
    turn: f64,
}

impl Jumps {
    /// Whether the motion starts anew with a row, this number of steps after the last.
    pub(crate) fn reset(&mut self, pair: &Pair, times: f64) -> Option<Reset> {
        let Pair { from: last, to: state, .. } = pair;
        let to_start = self.starts_anew(last, state);
        let jumps = times == 1.0 && self.jumps(pair);
        let to_rest = state.omega == Vector3::zeros();
        let line = state.ahead.map_or(state.line, |(line, _)| line);
        let reset = Reset { line, time: state.t, to_rest, to_start: to_start && !to_rest };
        (to_start || jumps).then_some(reset)
    }

    /// A step that is a hundred times as far from the law as the steps before it were, and farther than a
    /// rule's error in one step can be: the law itself changes the spin by no more than the angle turned.
    fn jumps(&mut self, pair: &Pair) -> bool {
        let (from, to) = (pair.from.omega, pair.to.omega);
        // Of attitudes alone a spin that is out of all proportion is what is to be found.
        let speed = if self.has_spin { from.norm().max(to.norm()) } else { from.norm() };
        let mean = (from + to) / 2.0;
        let rate = euler::angular_acceleration(&self.moments, &mean, &self.torque(pair));
        let spin = (to - from - rate * pair.h).norm() / speed;
        let turn = match (pair.turn(), speed * pair.h < SHORT_TURN) {
            (Some(turn), true) => (turn - mean * pair.h).norm(),
            _ => 0.0,
        };
        let off = spin.max(turn);
        if !off.is_finite() {
            return false;
        }
        // A slow body turns little in a step: what is no jump for a fast one is many steps for it.
        let thrown = self.errors.steps > STEPS_BEFORE_A_JUMP
            && turn > THROWN_IN_TURNS * speed * pair.h
            && turn > JUMP_IN_ERRORS * self.errors.turn
            && turn > THROWN_IN_ROUNDINGS * self.floor;
        self.errors.turn = self.errors.turn.max(turn);
        let jumps = thrown
            || self.errors.steps > STEPS_BEFORE_A_JUMP
                && off > JUMP
                && off > JUMP_IN_TURNS * speed * pair.h
                && off > JUMP_IN_ERRORS * self.errors.off;
        if !jumps {
            // Forgotten slowly, so that a rule that goes astray now and then is known to.
            self.errors.off = off.max(ERROR_KEPT * self.errors.off);
            self.errors.steps += 1;
        }
        jumps
    }

    /// The torque in body axes, for a mean over the step.
    fn torque(&self, pair: &Pair) -> Vector3<f64> {
        match (self.torque, pair.from.attitude) {
            (Some(torque), Some(q)) => {
                tumbling::attitude::rotation_matrix(&q).tr_mul(&torque) / q.norm_squared()
            }
            _ => Vector3::zeros(),
        }
    }

    /// A body that moves is at rest all of a sudden, or back at the start without a way there.
    fn starts_anew(&self, last: &Row, state: &Row) -> bool {
        let [jump, turns] = JUMP_BACK;
        let (before, now) = (last.omega.norm(), state.omega.norm());
        if before > 0.0 && now == 0.0 {
            return before > NEARLY_AT_REST.max(ON_AXIS * self.floor) * self.first.omega.norm();
        }
        let back = (state.omega - self.first.omega).norm() <= BACK * self.first.omega.norm();
        let Some(((first, q), was)) = self.first.attitude.zip(state.attitude).zip(last.attitude) else {
            let (h, [errors, roundings]) = (state.t - last.t, BACK_IN_ERRORS);
            let mean = (last.omega + state.omega) / 2.0;
            let rate = euler::angular_acceleration(&self.moments, &mean, &Vector3::zeros());
            let off = (state.omega - last.omega - rate * h).norm() / before.max(now);
            let change = (state.omega - last.omega).norm() / before.max(now);
            let is_far = off.min(change) > roundings * self.floor && off > errors * self.errors.off;
            return back && (change > jump || is_far && self.errors.steps >= STEPS_BEFORE_A_JUMP);
        };
        let turned = angle_between(&was, &q);
        back && angle_between(&first, &q) < BACK
            && turned > jump
            && turned > turns * before.max(now) * (state.t - last.t)
    }
}
