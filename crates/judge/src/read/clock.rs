//! The clock of a record: how long its steps are, and where rows are missing.

use crate::read::{Note, Raw, median};
use crate::thresholds::*;

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
        let usual = median(&mut steps.clone());
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
            return (Self { step, per_row: None }, Some(Note::OtherStep(named, row)));
        }
        // The times of rows of few digits are off by more than the header's step.
        let row = if whole < STEPS_PER_ROW_APART[0] { count * named } else { row };
        let per_row = count as u32;
        (Self { step: Some(row), per_row: Some(per_row) }, Some(Note::StepsPerRow(named, per_row)))
    }

    /// The step between two times, and how many steps long it is.
    pub(crate) fn between(&self, from: f64, to: f64) -> (f64, f64) {
        let Some(step) = self.step else { return (to - from, 1.0) };
        let times = (to - from) / step;
        if (times - 1.0).abs() < STEP_SLACK { (step, 1.0) } else { (to - from, times) }
    }

    /// Three rows, each one step after the other, with the second step as the file has it.
    pub(crate) fn triples(&self, probe: &[Raw]) -> Vec<([Raw; 3], f64)> {
        let every = probe.len().div_ceil(PROBE_PAIRS).max(1);
        let three = probe.windows(3).step_by(every).filter_map(|rows| {
            let [(_, times), (h, more)] = [0, 1].map(|i| self.between(rows[i].t, rows[i + 1].t));
            (times == 1.0 && more == 1.0).then_some(([rows[0], rows[1], rows[2]], h))
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
