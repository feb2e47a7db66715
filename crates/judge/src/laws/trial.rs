//! A trial: rows in, and what they do to the laws noted, up to where a motion starts anew.

use crate::error::Error;
use crate::laws::{Errors, Laws, Reset, Stretch, Stretches};
use crate::read::{Known, Pair, Row, law};
use crate::thresholds::*;
use nalgebra::Vector3;
use serde::Serialize;
use tumbling::dynamics::euler::angular_acceleration;

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

/// Of two stretches one is kept, now the first and now the second: always the first would see of what comes
/// back every sixteenth row all or nothing.
impl Stretch for [(Pair, bool); TRIED_RUN] {
    fn join(&self, next: &Self) -> Self {
        // Fibonacci hashing of its place.
        let is_odd = (self[0].0.to.line as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 63 == 1;
        if is_odd { *next } else { *self }
    }
}

/// A trial as far as it has come.
pub(crate) struct Trial {
    pub known: Known,
    pub laws: Laws,
    pub first: Row,
    /// Steps of a record of any length, evenly from all of it, in runs of steps that follow one another; the
    /// run that is not full yet, and how many steps there are. Of each step whether it ends or starts with a
    /// row that repeats the row before it: the row behind a missed one is two steps on.
    runs: Stretches<[(Pair, bool); TRIED_RUN]>,
    run: Vec<(Pair, bool)>,
    pub steps: u64,
    /// The last rows, if they repeat the row before: how many, the line of the first, and the time of the row
    /// before it. How often such rows come to an end, how many they are, and the line of the first.
    tail: Option<(u64, usize, f64)>,
    ends: u64,
    equal: Option<(u64, usize)>,
    pub(super) errors: Errors,
    pub resets: Vec<Reset>,
    pub gaps: Option<Gaps>,
    last: Option<Row>,
    /// Of attitudes alone the row whose spin the next one gives.
    pub waiting: Option<Row>,
    pub rows: u64,
    /// The number of pairs of rows that follow one another, however far apart.
    pub pairs: u64,
    /// At which line the attitude turns too far for its direction to be known, and by how much, rad.
    pub stopped: Option<(usize, f64)>,
    /// Where the numbers end, and with what.
    pub ended: Option<String>,
}

impl Trial {
    pub(crate) fn new(moments: &Vector3<f64>, first: Row, known: Known) -> Result<Self, Error> {
        Ok(Self {
            laws: Laws::new(moments, &first, known.floor)?,
            first,
            runs: Stretches::new(TRIED_STEPS / TRIED_RUN),
            run: Vec::new(),
            steps: 0,
            tail: None,
            ends: 0,
            equal: None,
            errors: Errors::default(),
            known,
            resets: Vec::new(),
            gaps: None,
            last: None,
            waiting: None,
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
            let reset = self.reset(&pair, times);
            if self.resets.len() < RESETS {
                self.resets.extend(reset);
            }
            let rest = self.resets.first().filter(|reset| reset.to_rest && !self.known.has_spin());
            if let Some(Reset { line, .. }) = rest.filter(|_| state.omega != Vector3::zeros()) {
                let problem = "the attitude is that of the row before it, and the body goes on later: of attitudes alone that is a row written again, or a rest, and neither can be judged. Write each instant once, or end the record before this line";
                return Err(Error::Line { line: *line, problem: problem.into() });
            }
            self.pairs += u64::from(self.resets.is_empty());
            if self.resets.is_empty() && times == 1.0 {
                if self.known.has_spin() {
                    self.laws.pair(&pair);
                }
                if self.known.has_spin() || state.ahead.is_some() {
                    self.step(pair);
                }
            }
        }
        if self.resets.is_empty() {
            self.laws.push(state, steps)?;
        }
        Ok(())
    }

    fn step(&mut self, pair: Pair) {
        self.steps += 1;
        let is_equal = self.is_equal(&pair);
        self.ends += u64::from(self.tail.is_some() && !is_equal);
        self.run.push((pair, is_equal || self.tail.is_some()));
        self.tail = self.tail.filter(|_| is_equal);
        if is_equal {
            self.equal.get_or_insert((0, pair.to.line)).0 += 1;
            self.tail.get_or_insert((0, pair.to.line, pair.from.t)).0 += 1;
        }
        if let Ok(run) = self.run[..].try_into() {
            self.runs.push(run);
            self.run.clear();
        }
    }

    /// The steps that rules are tried on: none to or from a few rows that are written again.
    pub(crate) fn sample(&self) -> Vec<Pair> {
        let all = self.written_again().is_none() && self.tail().is_none() || self.repeats();
        self.sampled().filter(|step| all || !step.1).map(|step| step.0).collect()
    }

    fn sampled(&self) -> impl Iterator<Item = (Pair, bool)> {
        self.runs.all.iter().flatten().chain(&self.run).copied()
    }

    /// Whether a row is the row before it, and the motion between them far above the rounding of the numbers.
    fn is_equal(&self, Pair { from, to, h }: &Pair) -> bool {
        let Known { floor, moments, .. } = &self.known;
        let (speed, rate) =
            (from.omega.norm(), angular_acceleration(moments, &from.omega, &Vector3::zeros()).norm());
        let turn = from.attitude.map_or(0.0, |_| speed * h / floor.attitude);
        let shown = turn.max(rate * h / (speed * floor.size)) > ABOVE_ROUNDING;
        shown && from.omega == to.omega && from.attitude == to.attitude
    }

    /// The number of rows that are written again under other times, and the line of the first. A body that
    /// comes to stay is none, nor is, of spins alone, one whose spin stays between pushes: these do not go by
    /// the law.
    pub(crate) fn written_again(&self) -> Option<(u64, usize)> {
        self.equal.filter(|_| self.ends > 0 && self.goes_on())
    }

    fn goes_on(&self) -> bool {
        let moving = self.sampled().map(|step| step.0).filter(|pair| pair.from.omega != pair.to.omega);
        self.first.attitude.is_some() || law(&moving.collect::<Vec<_>>(), &self.known.moments).0 > LAW_AGREES
    }

    /// The last rows, if they repeat the row before them and the body moved before: a recorder may have
    /// outlived its engine.
    pub(crate) fn tail(&self) -> Option<(u64, usize, f64)> {
        self.tail.filter(|tail| tail.0 < self.steps && self.goes_on())
    }

    /// Whether too many rows are written again, in more than one place, for a rule to be named.
    pub(crate) fn repeats(&self) -> bool {
        self.ends > 1 && self.written_again().is_some_and(|x| x.0 as f64 >= REPEATED * self.steps as f64)
    }
}
