//! Jumps: steps that do not follow the rule, among steps that do.

use crate::read::{Floor, Pair};
use crate::rule::{Explanation, Rule, Subject};
use crate::thresholds::*;
use serde::Serialize;

/// A step that does not follow the rule, among steps that do.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Jump {
    /// The line of its end.
    pub line: usize,
    /// Its end, s.
    pub time: f64,
    /// Its distance from the rule's step: spin relative to its length, or attitude in rad.
    pub size: f64,
}

/// The steps without those that jump.
pub(super) fn without(pairs: &[Pair], jumps: &[Jump]) -> Vec<Pair> {
    let is_own = |pair: &&Pair| jumps.iter().all(|jump| jump.line != pair.to.line);
    pairs.iter().filter(is_own).copied().collect()
}

/// The steps that are farther from the exact motion than any step of an unknown rule: pushes.
pub(super) fn pushes(subject: &Subject, pairs: &[Pair], found: &[Explanation], floor: Floor) -> Vec<Jump> {
    let exact = found.iter().find(|x| x.rule == Rule::EXACT).filter(|x| x.percentile_95 < NEAR);
    let most = exact.map(|x| JUMP_IN_LIMITS * x.percentile_95.max(floor.limits()[1]));
    most.and_then(|most| far_off(subject, pairs, &Rule::EXACT, most, JUMP_EVERY[1])).unwrap_or_default()
}

/// The steps that do not follow the rule; `None` if they do not look like pushes: rare, far larger than the
/// errors of the other steps, and apart from each other.
pub(super) fn far_off(
    subject: &Subject,
    all: &[Pair],
    rule: &Rule,
    far: f64,
    every: usize,
) -> Option<Vec<Jump>> {
    let jump = |pair: &Pair| {
        let size = subject.residual(rule, pair);
        (size > far).then_some(Jump { line: pair.to.line, time: pair.to.t, size })
    };
    let off: Vec<Jump> = all.iter().filter_map(jump).collect();
    let rare = off.iter().all(|jump| jump.size > JUMP_IN_LIMITS * far) && off.len() * every <= all.len();
    // Of attitudes alone one push is in two turns.
    let apart = off.windows(3).all(|three| three[2].line > three[0].line + 2);
    (off.is_empty() || rare && apart).then_some(off)
}
