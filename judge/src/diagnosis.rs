//! Which rule made a record: each suspect takes each row one step further, and is held against the next row.

use crate::laws::ordered;
use crate::state::{Pair, median, middle_and_most};
use crate::suspects::{Base, Rule, Subject, When, simple};
use nalgebra::Vector3;
use tumbling::euler;

/// How much of the record is tried, at most, evenly through it.
const PAIRS: usize = 2048;
/// Of those, for what has to be fitted.
const FITTED: usize = 96;

/// Pairs of rows from all of a record of any length.
#[derive(Debug)]
pub(crate) struct Sample {
    pairs: Vec<Pair>,
    every: u64,
    seen: u64,
}

impl Sample {
    pub(crate) const fn new() -> Self {
        Self { pairs: Vec::new(), every: 1, seen: 0 }
    }

    pub(crate) fn push(&mut self, pair: &Pair) {
        if self.seen.is_multiple_of(self.every) {
            if self.pairs.len() == PAIRS {
                let mut place = 0;
                self.pairs.retain(|_| {
                    place += 1;
                    place % 2 == 1
                });
                self.every *= 2;
            }
            if self.seen.is_multiple_of(self.every) {
                self.pairs.push(*pair);
            }
        }
        self.seen += 1;
    }

    pub(crate) const fn seen(&self) -> u64 {
        self.seen
    }

    pub(crate) fn pairs(&self) -> &[Pair] {
        &self.pairs
    }
}

/// A rule, and how far its steps are from the record's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Explanation {
    /// The rule.
    pub rule: Rule,
    /// Half of the steps are nearer than this (spin beside spin, attitude in rad).
    pub middle: f64,
    /// 95 of 100 are nearer than this.
    pub most: f64,
}

impl Explanation {
    /// Whether every step is the rule's, but for rounding and what a step that multiplies it makes of it.
    fn fits(self, floor: f64) -> bool {
        self.middle <= 100.0 * floor && self.most <= 1e4 * floor
    }

    /// By how much another is farther from the record: in the middle, or in the last twentieth.
    fn beside(&self, other: &Self) -> f64 {
        let ratio = |a: f64, b: f64| a.max(f64::EPSILON) / b.max(f64::EPSILON);
        ratio(other.middle, self.middle).max(ratio(other.most, self.most))
    }
}

/// How sure a diagnosis is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Sure {
    /// Every step is the rule's to rounding.
    ToRounding,
    /// More than half of the steps are the rule's to rounding; one in twenty or more is not.
    MostSteps,
    /// Nearer than any other by far, and not to rounding: such a rule, in some other form.
    Near,
    /// None of the rules known here.
    NoneFits,
}

/// What made the record.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnosis {
    /// The rule that explains it best; of several that do so alike the simplest.
    pub best: Explanation,
    /// Others that explain it as well.
    pub alike: Vec<Rule>,
    /// The best of those that do not.
    pub second: Option<Explanation>,
    /// How sure.
    pub sure: Sure,
    /// How many steps were tried.
    pub steps: usize,
    /// What else was seen.
    pub hints: Vec<String>,
}

impl Diagnosis {
    /// By how much the next rule is farther from the record than the best.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        self.second.map(|second| self.best.beside(&second))
    }
}

/// Tries every suspect on the sample. `floor` is the rounding of the numbers, beside 1.
pub(crate) fn diagnose(
    subject: &Subject,
    sample: &Sample,
    floor: f64,
    of_momentum: bool,
) -> Option<Diagnosis> {
    let pairs = sample.pairs();
    let explained = |rule: Rule| -> Option<Explanation> {
        let residuals = pairs.iter().map(|pair| subject.residual(&rule, pair)).collect();
        middle_and_most(residuals).map(|[middle, most]| Explanation { rule, middle, most })
    };
    let fits = |found: &[Explanation]| found.iter().any(|x| x.fits(floor));
    let free = subject.torque.is_none();
    let mut found: Vec<Explanation> = simple(free, pairs).into_iter().filter_map(explained).collect();
    if free && of_momentum {
        found.extend(momentum_for_spin(subject, pairs).and_then(explained));
    }
    if free && !fits(&found) {
        found.extend(compound(subject, pairs).into_iter().filter_map(explained));
    }
    let least = found.iter().map(|x| x.middle).fold(f64::INFINITY, f64::min);
    if !least.is_finite() {
        return None;
    }
    // Within rounding of the best, in the middle as in the last twentieth.
    let near = |x: &&Explanation| x.middle <= (2.0 * least).max(8.0 * floor);
    let best_most = found.iter().filter(near).map(|x| x.most).fold(f64::INFINITY, f64::min);
    let alike_of = |x: &&Explanation| near(x) && x.most <= (4.0 * best_most).max(64.0 * floor);
    let best = *found.iter().find(alike_of)?;
    // The same rule with limits that the record does not reach says nothing new.
    let same =
        |rule: &Rule| *rule == best.rule || rule.method().is_some() && rule.method() == best.rule.method();
    let alike = found.iter().filter(alike_of).map(|x| x.rule).filter(|rule| !same(rule)).collect();
    let second = found
        .iter()
        .filter(|x| !alike_of(x))
        .copied()
        .min_by(|a, b| best.beside(a).total_cmp(&best.beside(b)));
    let ratio = second.map_or(f64::INFINITY, |second| best.beside(&second));
    let sure = if best.fits(floor) {
        Sure::ToRounding
    } else if best.middle <= 100.0 * floor {
        Sure::MostSteps
    } else if best.middle < 0.01 && ratio >= 10.0 {
        Sure::Near
    } else {
        Sure::NoneFits
    };
    Some(Diagnosis { best, alike, second, sure, steps: pairs.len(), hints: hints(pairs, floor) })
}

/// The number that takes the momentum to the turn.
fn momentum_for_spin(subject: &Subject, pairs: &[Pair]) -> Option<Rule> {
    let mass = median(pairs.iter().filter_map(|pair| {
        let turn = pair.turn()?.norm();
        if turn > 0.0 { Some(subject.system.momentum(&pair.from.omega).norm() * pair.h / turn) } else { None }
    }));
    (mass.is_finite() && mass > 0.0).then_some(Rule::MomentumForSpin(mass))
}

/// Suspects with a number in them, which is fitted first.
fn compound(subject: &Subject, pairs: &[Pair]) -> Vec<Rule> {
    let few: Vec<Pair> = pairs.iter().step_by(pairs.len().div_ceil(FITTED).max(1)).copied().collect();
    let mut all = Vec::new();
    let mut triples = permuted(&subject.moments);
    triples.extend(from_rates(&few, &subject.moments));
    for base in Base::all() {
        all.extend(triples.iter().map(|&moments| Rule::OtherMoments(moments, base)));
        all.extend(fitted(subject, &few, base, &triples));
        for when in [When::After, When::Before] {
            all.extend(damped(subject, &few, base, when));
        }
        all.extend(capped(pairs).map(|most| Rule::Capped(most, base)));
    }
    all
}

/// The moments in every other order.
fn permuted(moments: &Vector3<f64>) -> Vec<Vector3<f64>> {
    let orders = [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    orders
        .map(|order| Vector3::from(order.map(|i| moments[i])))
        .into_iter()
        .filter(|x| x != moments)
        .collect()
}

/// The triple that the changes of spin tell, each component's on its own, scaled to the sum of `told`.
fn from_rates(pairs: &[Pair], told: &Vector3<f64>) -> Option<Vector3<f64>> {
    let (mut over, mut under) = (Vector3::zeros(), Vector3::zeros());
    for pair in pairs {
        let mean = (pair.from.omega + pair.to.omega) / 2.0;
        let speed = mean.norm_squared();
        let rate = (pair.to.omega - pair.from.omega) / pair.h;
        for i in 0..3 {
            let product = mean[(i + 1) % 3] * mean[(i + 2) % 3] / speed;
            if product.is_finite() {
                over[i] += rate[i] / speed * product;
                under[i] += product * product;
            }
        }
    }
    // w1' = a w2 w3 with a = (I2 - I3) / I1, and so on round: two of them tell the ratios.
    let rates: Vector3<f64> = over.component_div(&under);
    let second = (1.0 + rates.x) / (1.0 - rates.y);
    scaled(Vector3::new(1.0, second, 1.0 + rates.y * second), told)
}

fn scaled(moments: Vector3<f64>, told: &Vector3<f64>) -> Option<Vector3<f64>> {
    let moments = moments * (told.sum() / moments.sum());
    Subject::new(moments, None).is_ok().then_some(moments)
}

/// Gauss and Newton's way to the ratios of the moments with which the base makes the spins of the record.
fn fitted(subject: &Subject, pairs: &[Pair], base: Base, starts: &[Vector3<f64>]) -> Option<Rule> {
    let misses = |moments: &Vector3<f64>| -> Option<Vec<Vector3<f64>>> {
        pairs
            .iter()
            .map(|pair| {
                let end = subject.spin_after(&Rule::OtherMoments(*moments, base), pair)?;
                Some((end - pair.to.omega) / pair.to.omega.norm().max(f64::MIN_POSITIVE))
            })
            .collect()
    };
    let size = |misses: &[Vector3<f64>]| misses.iter().map(Vector3::norm_squared).sum::<f64>();
    let best = starts.iter().filter_map(|start| misses(start).map(|found| (*start, size(&found))));
    let (mut moments, mut least) = best.min_by(|a, b| a.1.total_cmp(&b.1))?;
    for _ in 0..12 {
        let here = misses(&moments)?;
        let jolt = 1e-6;
        let along = |i: usize| -> Option<Vec<Vector3<f64>>> {
            let mut other = moments;
            other[i] *= 1.0 + jolt;
            Some(misses(&other)?.iter().zip(&here).map(|(a, b)| (a - b) / jolt).collect())
        };
        let (a, b) = (along(1)?, along(2)?);
        let dot =
            |x: &[Vector3<f64>], y: &[Vector3<f64>]| x.iter().zip(y).map(|(x, y)| x.dot(y)).sum::<f64>();
        let (aa, ab, bb) = (dot(&a, &a), dot(&a, &b), dot(&b, &b));
        let (ha, hb) = (dot(&a, &here), dot(&b, &here));
        let determinant = aa * bb - ab * ab;
        let step = [(hb * ab - ha * bb) / determinant, (ha * ab - hb * aa) / determinant];
        let next = Vector3::new(moments.x, moments.y * step[0].exp(), moments.z * step[1].exp());
        let Some(next) = scaled(next, &subject.moments) else { break };
        let Some(now) = misses(&next).map(|found| size(&found)) else { break };
        if now >= least {
            break;
        }
        (moments, least) = (next, now);
    }
    Some(Rule::OtherMoments(moments, base))
}

/// The factor by which each step lessens the spin that the base makes.
fn damped(subject: &Subject, pairs: &[Pair], base: Base, when: When) -> Option<Rule> {
    let mut factor = 1.0;
    for _ in 0..6 {
        let more = median(pairs.iter().filter_map(|pair| {
            let end = subject.spin_after(&Rule::Damped(factor, base, when), pair)?;
            Some(pair.to.omega.dot(&end) / end.norm_squared())
        }));
        if !more.is_finite() {
            return None;
        }
        factor *= more;
        if (more - 1.0).abs() < 1e-15 || when == When::After {
            break;
        }
    }
    (factor > 0.0 && factor < 1.0 - 1e-9).then_some(Rule::Damped(factor, base, when))
}

/// The greatest spin, if many rows have it.
fn capped(pairs: &[Pair]) -> Option<f64> {
    let most = pairs.iter().map(|pair| pair.to.omega.norm()).fold(0.0, f64::max);
    let there = pairs.iter().filter(|pair| pair.to.omega.norm() >= most * (1.0 - 1e-9)).count();
    (most > 0.0 && there >= 4 && there * 10 >= pairs.len()).then_some(most)
}

fn hints(pairs: &[Pair], floor: f64) -> Vec<String> {
    let mut hints = Vec::new();
    let still = pairs.iter().filter(|pair| {
        pair.turn().is_some_and(|turn| turn == Vector3::zeros())
            && pair.from.omega.norm() * pair.h > 100.0 * floor
    });
    let angles: Vec<f64> = still.map(|pair| pair.from.omega.norm() * pair.h).collect();
    if !angles.is_empty() {
        let most = angles.iter().copied().fold(0.0, f64::max);
        hints.push(format!(
            "In {} of the steps tried the attitude stands still while the body spins: turns up to {most:.1e} rad are dropped \
             (a threshold for small rotations, or sleeping).",
            angles.len()
        ));
    }
    hints
}

/// Whether the gyroscopic term is a part worth speaking of in the changes of spin that the sample should have.
pub(crate) fn should_change(subject: &Subject, pairs: &[Pair], floor: f64) -> bool {
    let [smallest, _, largest] = ordered(&subject.moments);
    subject.moments[smallest] < subject.moments[largest]
        && pairs.iter().any(|pair| {
            let rate = euler::angular_acceleration(&subject.moments, &pair.from.omega, &Vector3::zeros());
            rate.norm() * pair.h > 100.0 * floor * pair.from.omega.norm()
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::State;

    #[test]
    fn a_sample_is_no_larger_however_long_the_record_and_from_all_of_it() {
        let mut sample = Sample::new();
        for line in 0..1_000_000 {
            let state = State { line, t: 0.0, attitude: None, omega: Vector3::zeros() };
            sample.push(&Pair { from: state, to: state, h: 1.0 });
            assert!(sample.pairs().len() <= PAIRS);
        }
        assert_eq!(sample.seen(), 1_000_000);
        let lines: Vec<usize> = sample.pairs().iter().map(|pair| pair.from.line).collect();
        assert!(lines.len() > PAIRS / 4 && lines[0] == 0 && lines[lines.len() - 1] > 990_000);
        let apart: Vec<usize> = lines.windows(2).map(|x| x[1] - x[0]).collect();
        assert!(apart.iter().all(|&x| x == apart[0]), "evenly");
    }
}
