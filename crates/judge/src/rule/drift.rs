//! A rule over a whole run: whether it drifts as the record does.

use crate::read::{Row, ordered};
use crate::rule::{Rule, Subject};
use crate::thresholds::{DRIFT_APART, DRIFT_ROUNDINGS, FLIPS_APART, FLIPS_MISSED, RUN_STEPS};

/// A whole run, from its first row to its last.
pub(crate) struct Run {
    pub first: Row,
    pub last: Row,
    pub h: f64,
    /// How often the spin along the middle axis changes sign.
    pub flips: Option<u64>,
    pub floor: f64,
}

impl Run {
    /// The logarithms of the ratios of energy and momentum, last to first.
    pub(super) fn drift(subject: &Subject, from: &Row, to: &Row) -> [f64; 2] {
        let angular = |state: &Row| subject.moments.component_mul(&state.omega);
        let energy = |state: &Row| state.omega.dot(&angular(state));
        [(energy(to) / energy(from)).ln(), (angular(to).norm() / angular(from).norm()).ln()]
    }

    /// Whether a rule, from the first row on, drifts as the record does.
    pub(crate) fn is_like(&self, subject: &Subject, rule: &Rule) -> bool {
        let wanted = Self::drift(subject, &self.first, &self.last);
        let steps = ((self.last.t - self.first.t) / self.h).round();
        let part = (steps / RUN_STEPS).max(1.0);
        let mut state = self.first;
        let mut taken = 0.0;
        let middle = ordered(&subject.moments)[1];
        let mut flips = 0_u64;
        while taken < steps / part {
            let Some(next) = subject.next(rule, &state, self.h) else { return false };
            flips += u64::from(state.omega[middle] * next.omega[middle] < 0.0);
            state = next;
            taken += 1.0;
        }
        let found = Self::drift(subject, &self.first, &state).map(|x| x * part);
        // A flip more or less, or a tenth of many, is a matter of the start's rounding.
        if self
            .flips
            .is_some_and(|wanted| part == 1.0 && wanted.abs_diff(flips) > FLIPS_APART + wanted / FLIPS_MISSED)
        {
            return false;
        }
        let size = wanted[0].abs() + wanted[1].abs() + DRIFT_ROUNDINGS * self.floor;
        (found[0] - wanted[0]).abs() + (found[1] - wanted[1]).abs() <= DRIFT_APART * size
    }
}
