//! Steps that are not the rule's, among steps that are: pushes.

use crate::read::{Floor, Pair};
use crate::rule::{Explanation, Rule, Subject};
use crate::thresholds::*;
use serde::Serialize;

/// A step that is not the rule's, among steps that are.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Jump {
    /// The line in which it ends.
    pub line: usize,
    /// Its end, s.
    pub time: f64,
    /// How far it is from the rule's: of the spin relative to its length, of the attitude in rad.
    pub size: f64,
}

/// The steps without those that jump.
pub(super) fn without(pairs: &[Pair], jumps: &[Jump]) -> Vec<Pair> {
    let is_own = |pair: &&Pair| jumps.iter().all(|jump| jump.line != pair.to.line);
    pairs.iter().filter(is_own).copied().collect()
}

/// The steps that are as far from the motion as no step of a rule that is not known: pushes.
pub(super) fn pushes(subject: &Subject, pairs: &[Pair], found: &[Explanation], floor: Floor) -> Vec<Jump> {
    let exact = found.iter().find(|x| x.rule == Rule::EXACT).filter(|x| x.percentile_95 < NEAR);
    let most = exact.map(|x| JUMP_IN_LIMITS * x.percentile_95.max(floor.limits()[1]));
    most.and_then(|most| jumps(subject, pairs, &Rule::EXACT, most, JUMP_EVERY[1])).unwrap_or_default()
}

/// The steps that are not the rule's: a push is rare, far larger than the errors of the steps, and not the
/// end of another; all other steps are the rule's. `None` where that is not so.
pub(super) fn jumps(
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
