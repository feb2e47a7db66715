//! What is seen in the steps besides the rule.

use crate::read::state::{Pair, ordered};
use crate::rule::candidates::Subject;
use crate::thresholds::{CAP_AT_START, STILL};
use nalgebra::Vector3;
use tumbling::dynamics::euler;

/// What is seen in the steps besides the rule.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Hint {
    /// The first step slows the spin, and no later one goes beyond: a cap on the spin.
    CapAtStart {
        /// From this spin, rad/s.
        from: f64,
        /// To this one.
        to: f64,
    },
    /// A component of the spin is zero to the last digit, where the law moves it.
    HeldAtZero {
        /// The number of steps.
        steps: usize,
    },
}

/// Everything besides the rule that may help to find what made the steps.
pub(crate) fn hints(subject: &Subject, pairs: &[Pair], floor: f64) -> Vec<Hint> {
    let mut hints: Vec<Hint> = cap_at_start(pairs).into_iter().collect();
    let held = pairs.iter().filter(|pair| {
        let mean = (pair.from.omega + pair.to.omega) / 2.0;
        let law = euler::angular_acceleration(&subject.moments, &mean, &Vector3::zeros()) * pair.h;
        (0..3).any(|i| pair.to.omega[i] == 0.0 && law[i].abs() > STILL * floor * mean.norm())
    });
    let steps = held.count();
    if steps > 0 && subject.torque.is_none() {
        hints.push(Hint::HeldAtZero { steps });
    }
    hints
}

/// A first step that brings the spin down to a value that no later step exceeds.
fn cap_at_start(pairs: &[Pair]) -> Option<Hint> {
    let [slowed, beyond] = CAP_AT_START;
    let (from, to) = (pairs.first()?.from.omega.norm(), pairs.first()?.to.omega.norm());
    let greatest = pairs.iter().skip(1).map(|pair| pair.to.omega.norm()).fold(0.0, f64::max);
    let capped = pairs.len() > 2 && to > 0.0 && from > slowed * to && greatest <= to * (1.0 + beyond);
    capped.then_some(Hint::CapAtStart { from, to })
}

/// Whether the gyroscopic term is a part worth speaking of in the changes of spin that the sample should
/// have.
pub(crate) fn should_change(subject: &Subject, pairs: &[Pair], floor: f64) -> bool {
    let [smallest, _, largest] = ordered(&subject.moments);
    subject.moments[smallest] < subject.moments[largest]
        && pairs.iter().any(|pair| {
            let rate = euler::angular_acceleration(&subject.moments, &pair.from.omega, &Vector3::zeros());
            rate.norm() * pair.h > STILL * floor * pair.from.omega.norm()
        })
}
