//! The clock of a record: how long its steps are, where rows are missing, and times printed with few digits,
//! put back to the steps that they are rounded from.

use crate::read::{Note, Raw, Reading, median};
use crate::thresholds::*;
use nalgebra::Vector3;

/// How time goes from row to row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Clock {
    /// The time from row to row; none where it varies.
    pub step: Option<f64>,
    /// The number of the engine's steps from row to row, where the header names it.
    pub per_row: Option<u32>,
}

impl Clock {
    /// From the times as the file has them.
    pub(crate) fn of(probe: &[Raw]) -> Self {
        let steps = probe.windows(2).map(|rows| rows[1].t - rows[0].t);
        let least = steps.clone().fold(f64::INFINITY, f64::min);
        // A spacing that most rows have is the step, however small another one may be.
        let usual = median(steps.clone());
        let near = steps.clone().filter(|step| (step / usual - 1.0).abs() < STEP_APART);
        let (near, sum) = near.fold((0, 0.0), |(count, sum), step| (count + 1, sum + step));
        if least < usual * (1.0 - STEP_APART) && 2 * near > probe.len() - 1 {
            return Self { step: Some(sum / f64::from(near as u32)), per_row: None };
        }
        let mut count = 0.0;
        for step in steps {
            let times = (step / least).round();
            if (step / least - times).abs() > STEP_APART {
                return Self { step: None, per_row: None };
            }
            count += times;
        }
        let whole = probe.last().map_or(0.0, |row| row.t) - probe[0].t;
        Self { step: Some(whole / count), per_row: None }
    }

    /// In seconds, and to the digit where the header names the step or a whole part of it; with a note where
    /// it names another.
    pub(crate) fn read(self, time: f64, named: Option<f64>) -> (Self, Option<Note>) {
        let step = self.step.map(|step| step * time);
        let (Some(row), Some(named)) = (step, named) else { return (Self { step, per_row: None }, None) };
        if (named / row - 1.0).abs() < STEP_APART {
            return (Self { step: Some(named), per_row: Some(1) }, None);
        }
        let count = (row / named).round();
        let whole = (row / named - count).abs();
        if !(2.0..=STEPS_PER_ROW_MOST).contains(&count) || whole > STEPS_PER_ROW_APART[1] {
            return (Self { step, per_row: None }, Some(Note::OtherStep { named, row }));
        }
        // The times of rows of few digits are off by more than the header's step.
        let row = if whole < STEPS_PER_ROW_APART[0] { count * named } else { row };
        let per_row = count as u32;
        (Self { step: Some(row), per_row: Some(per_row) }, Some(Note::StepsPerRow { named, steps: per_row }))
    }

    /// The step between two times, and how many steps long it is.
    pub(crate) fn between(&self, from: f64, to: f64) -> (f64, f64) {
        let Some(step) = self.step else { return (to - from, 1.0) };
        let times = (to - from) / step;
        if (times - 1.0).abs() < STEP_SLACK { (step, 1.0) } else { (to - from, times) }
    }

    /// Three rows, each one step after the other, with the step as the file has it.
    pub(crate) fn triples(&self, probe: &[Raw]) -> Vec<[(Raw, f64); 3]> {
        let every = probe.len().div_ceil(PROBE_PAIRS).max(1);
        let three = probe.windows(3).step_by(every).filter_map(|rows| {
            let (h, times) = self.between(rows[0].t, rows[1].t);
            let (next, more) = self.between(rows[1].t, rows[2].t);
            (times == 1.0 && more == 1.0).then_some([(rows[0], 0.0), (rows[1], h), (rows[2], next)])
        });
        three.collect()
    }

    /// Rows one step apart, with the step as the file has it.
    pub(crate) fn pairs(&self, probe: &[Raw]) -> Vec<(Raw, Raw, f64)> {
        let pair = |rows: &[Raw]| {
            let (h, times) = self.between(rows[0].t, rows[1].t);
            (times == 1.0).then_some((rows[0], rows[1], h))
        };
        let pairs: Vec<_> = probe.windows(2).filter_map(pair).collect();
        let every = pairs.len().div_ceil(PROBE_PAIRS).max(1);
        pairs.into_iter().step_by(every).collect()
    }
}

/// Times that are, to their own printed digits, a whole number of equal steps from the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Grid {
    start: f64,
    step: f64,
    /// How far the step may be off, s.
    off: f64,
    /// Half a unit of the last decimal of the times, s.
    half: f64,
    /// The most significant digits that they have.
    digits: i32,
    named: bool,
}

impl Grid {
    /// Where the printed digits make the steps uneven, and a step, the named one or the mean, explains all of
    /// the times.
    pub(crate) fn of(probe: &[Raw], named: Option<f64>) -> Option<Self> {
        let (first, last) = (probe.first()?, probe.last()?);
        // Of those printed without the zeros at their ends some have all the digits there are.
        let half = probe.iter().map(|raw| raw.printed.half).fold(f64::INFINITY, f64::min);
        let digits = probe.iter().map(|raw| raw.printed.digits).max()?;
        let digits = i32::try_from(digits).unwrap_or(i32::MAX);
        let steps = probe.windows(2).map(|rows| rows[1].t - rows[0].t);
        let least = steps.clone().fold(f64::INFINITY, f64::min);
        let most = steps.fold(0.0, f64::max);
        let rounding = EVEN_TIMES * f64::EPSILON * last.t.abs().max(first.t.abs());
        // Even ones, and those with missing rows, are taken as they are.
        let even = most - least <= rounding && named.is_none_or(|named| (most - named).abs() <= rounding);
        if half <= rounding || even {
            return None;
        }
        let count = (probe.len() - 1) as f64;
        let mean = Self {
            start: first.t,
            step: (last.t - first.t) / count,
            off: 2.0 * half_of(last, half, digits) / count,
            half,
            digits,
            named: false,
        };
        let named = named.map(|step| Self { step, off: 0.0, named: true, ..mean });
        named.into_iter().chain([mean]).find(|grid| grid.explains(probe))
    }

    fn explains(&self, probe: &[Raw]) -> bool {
        let forward = |rows: &[Raw]| self.place(rows[0].t) < self.place(rows[1].t);
        probe.windows(2).all(forward) && probe.iter().all(|raw| self.time(raw).is_some())
    }

    /// The time from which a row's is rounded, if it is.
    fn time(&self, raw: &Raw) -> Option<f64> {
        let time = self.start + self.place(raw.t) * self.step;
        let half = half_of(raw, self.half, self.digits);
        Some(time).filter(|time| (time - raw.t).abs() <= PRINTED_HALVES * half)
    }

    fn place(&self, t: f64) -> f64 {
        ((t - self.start) / self.step).round()
    }

    /// A row at its time.
    pub(crate) fn put(&self, raw: &mut Raw) {
        // A row that is not on it, after all those looked at, keeps its own.
        raw.t = self.time(raw).unwrap_or(raw.t);
    }

    /// The rounding that a step so uncertain gives to spins and turns.
    pub(crate) fn floor(&self, probe: &[Raw], reading: &Reading, moments: &Vector3<f64>) -> f64 {
        let speed = probe.iter().map(|raw| reading.state(raw, moments).omega.norm()).fold(0.0, f64::max);
        self.off * reading.time() * speed
    }

    /// What was made of the times.
    pub(crate) const fn note(&self) -> Note {
        Note::EvenSteps { named: self.named, step: self.step }
    }
}

/// Half a unit of the last digit that a time can have, s: for times that all have the same number of
/// decimals, or of significant digits.
fn half_of(raw: &Raw, half: f64, digits: i32) -> f64 {
    half.max(0.5 * raw.printed.above * 10.0_f64.powi(-digits))
}
