//! How accurate the steps are of a rule that is none of those known.

use crate::read::{Pair, median};
use crate::rule::{Explanation, Rule, Subject};
use crate::thresholds::{ABOVE_ROUNDING, ACCURATE};

/// The error of the middle step, as a share of what the gyroscopic term changes of the spin in the middle
/// step; of an accurate rule alone. A share of the spin would praise each rule whose steps are short, even
/// where there is no gyroscopic term in them.
pub(crate) fn accuracy(subject: &Subject, pairs: &[Pair], exact: &Explanation, floor: f64) -> Option<f64> {
    let change = median(pairs.iter().filter_map(|pair| {
        let end = subject.spin_after(&Rule::EXACT, pair)?;
        Some((end - pair.from.omega).norm() / pair.from.omega.norm())
    }));
    let share = exact.median / change;
    (change.is_finite() && change > ABOVE_ROUNDING * floor && share <= ACCURATE).then_some(share)
}
