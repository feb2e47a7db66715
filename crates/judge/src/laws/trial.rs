//! A trial: rows in, and what they do to the laws noted.

use crate::error::Error;
use crate::laws::{Errors, Jumps, Laws, Reset, Stretch, Stretches};
use crate::read::{Known, Pair, Row};
use crate::rule::Subject;
use crate::thresholds::*;
use serde::Serialize;

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

/// Of a stretch the first step is kept.
impl Stretch for Pair {
    fn join(&self, _: &Self) -> Self {
        *self
    }
}

/// A trial as far as it has come.
pub(crate) struct Trial {
    pub known: Known,
    pub laws: Laws,
    pub first: Row,
    /// Steps of a record of any length, evenly from all of it, and how many there are.
    pub sample: Stretches<Pair>,
    pub steps: u64,
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
            sample: Stretches::new(TRIED_STEPS),
            steps: 0,
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
                    self.sample.push(pair);
                    self.steps += 1;
                }
            }
        }
        if self.resets.is_empty() {
            self.laws.push(state, steps)?;
        }
        Ok(())
    }
}
