//! The clock of a record: how long its steps are, and where rows are missing.

use crate::rows::Raw;
use crate::thresholds::{PROBE_PAIRS, STEP_APART, STEP_SLACK};

/// How time goes from row to row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Clock {
    /// The step; none where it varies.
    pub step: Option<f64>,
}

impl Clock {
    /// From the times as the file has them.
    pub(crate) fn of(probe: &[Raw]) -> Self {
        let steps = probe.windows(2).map(|rows| rows[1].t - rows[0].t);
        let least = steps.clone().fold(f64::INFINITY, f64::min);
        let mut count = 0.0;
        for step in steps {
            let times = (step / least).round();
            if (step / least - times).abs() > STEP_APART {
                return Self { step: None };
            }
            count += times;
        }
        let whole = probe.last().map_or(0.0, |row| row.t) - probe[0].t;
        Self { step: Some(whole / count) }
    }

    /// In seconds, and to the digit where the step is told.
    pub(crate) fn read(self, time: f64, told: Option<f64>) -> Self {
        let step = self.step.map(|step| step * time);
        let step =
            step.map(|step| told.filter(|told| (told / step - 1.0).abs() < STEP_APART).unwrap_or(step));
        Self { step }
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
        let mut pairs: Vec<_> = probe
            .windows(2)
            .filter_map(|rows| {
                let (h, times) = self.between(rows[0].t, rows[1].t);
                (times == 1.0).then_some((rows[0], rows[1], h))
            })
            .collect();
        let every = pairs.len().div_ceil(PROBE_PAIRS).max(1);
        let mut place = 0;
        pairs.retain(|_| {
            place += 1;
            (place - 1) % every == 0
        });
        pairs
    }
}
