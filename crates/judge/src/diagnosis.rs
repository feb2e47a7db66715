//! Which rule made a record: each suspect takes each row one step further, and is held against the next row.

use crate::advice::significant;
use crate::fitted::{compound, momentum_for_spin};
use crate::laws::{angle_between, ordered};
use crate::state::{Pair, Row, middle_and_most};
use crate::suspects::{Rule, Spin, Steps, Subject, simple, straight};
use nalgebra::Vector3;
use tumbling::step::Method;
use tumbling::{attitude, dynamics::euler};

/// How much of the record is tried, at most, evenly through it.
const PAIRS: usize = 2048;

/// The same where the record tells no spin.
const SOUGHT: usize = 256;

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

/// The rounding of a record's numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Floor {
    /// Beside 1.
    pub size: f64,
    /// Whether it is of a few decimal digits, fewer than single precision has.
    pub few: bool,
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
    /// Whether every step is the rule's, but for rounding and what a step that multiplies it makes of it. A few decimal digits are off
    /// by half a one of the last place and not more, and of what they leave open a wrong rule may be all.
    fn fits(self, floor: Floor) -> bool {
        let [middle, most] = if floor.few { [2.0, 16.0] } else { [100.0, 1e4] };
        self.middle <= middle * floor.size && self.most <= most * floor.size
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
    /// The steps are its own to rounding, and so they are of other rules; over the whole record it does not drift as the record does,
    /// or it is one of several that do.
    FewDigits,
    /// None of the rules known here.
    NoneFits,
}

impl Sure {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::ToRounding, Self::MostSteps, Self::Near, Self::FewDigits, Self::NoneFits];

    /// What a program calls it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::ToRounding => "to rounding",
            Self::MostSteps => "most steps",
            Self::Near => "near",
            Self::FewDigits => "too few digits",
            Self::NoneFits => "none fits",
        }
    }
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
    /// Of a record of few digits that breaks a law: how many of the best and those alike, the first of them, drift as the whole record
    /// does.
    pub drifts: Option<usize>,
}

/// A whole run, from its first row to its last.
pub(crate) struct Run {
    pub first: Row,
    pub last: Row,
    pub h: f64,
    /// How often the spin along the middle axis changes sign.
    pub flips: Option<u64>,
    pub floor: f64,
}

/// More steps than this are not taken once more for each rule.
const RUN: f64 = 20_000.0;

impl Run {
    /// The logarithms of the ratios of energy and momentum, last to first.
    fn drift(subject: &Subject, from: &Row, to: &Row) -> [f64; 2] {
        let angular = |state: &Row| subject.moments.component_mul(&state.omega);
        let energy = |state: &Row| state.omega.dot(&angular(state));
        [(energy(to) / energy(from)).ln(), (angular(to).norm() / angular(from).norm()).ln()]
    }

    /// Whether a rule, from the first row on, drifts as the record does: to a quarter.
    fn is_like(&self, subject: &Subject, rule: &Rule) -> bool {
        let wanted = Self::drift(subject, &self.first, &self.last);
        let steps = ((self.last.t - self.first.t) / self.h).round();
        let part = (steps / RUN).max(1.0);
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
        if self.flips.is_some_and(|wanted| part == 1.0 && wanted.abs_diff(flips) > 1 + wanted / 10) {
            return false;
        }
        let size = wanted[0].abs() + wanted[1].abs() + 32.0 * self.floor;
        (found[0] - wanted[0]).abs() + (found[1] - wanted[1]).abs() <= 0.25 * size
    }
}

fn explained(subject: &Subject, pairs: &[Pair], rule: Rule) -> Option<Explanation> {
    let residuals = pairs.iter().map(|pair| subject.residual(&rule, pair)).collect();
    middle_and_most(residuals).map(|[middle, most]| Explanation { rule, middle, most })
}

/// Of the spin alone, and of the attitude alone with the spins that the record has: what each is stepped by, to rounding.
fn apart(subject: &Subject, pairs: &[Pair], floor: Floor) -> Option<String> {
    let fits = |misses: Vec<f64>| {
        let [middle, most] = middle_and_most(misses)?;
        let all = Explanation { rule: Rule::Exact, middle, most };
        all.fits(floor).then_some(())
    };
    let spins = [
        (Rule::Method(Method::ConstantSpin, 1), "no gyroscopic term"),
        (Rule::Straight(Spin::Explicit), "explicit gyroscopic step"),
        (Rule::Method(Method::ImplicitOneNewton, 1), "one Newton step"),
        (Rule::Method(Method::ImplicitMidpoint, 1), "implicit midpoint"),
        (Rule::Method(Method::RungeKutta4, 1), "Runge and Kutta's fourth order"),
        (Rule::Exact, "the exact motion"),
    ];
    let spin = spins.into_iter().find(|(rule, _)| {
        let off = |pair: &Pair| {
            let speed = pair.to.omega.norm().max(pair.from.omega.norm());
            subject.spin_after(rule, pair).map_or(f64::INFINITY, |spin| (spin - pair.to.omega).norm() / speed)
        };
        fits(pairs.iter().map(off).collect()).is_some()
    });
    type Turn = fn(&Pair) -> (Vector3<f64>, bool);
    let turns: [(Turn, &str); 5] = [
        (|pair| (pair.to.omega, true), "straight, by the new spin (q + h/2 q w)"),
        (|pair| (pair.from.omega, true), "straight, by the old spin (q + h/2 q w)"),
        (|pair| (pair.to.omega, false), "the turn of the new spin"),
        (|pair| (pair.from.omega, false), "the turn of the old spin"),
        (
            |pair| ((pair.from.omega + pair.to.omega) / 2.0, false),
            "the turn of the mean of the old spin and the new",
        ),
    ];
    let turn = turns.into_iter().find(|(by, _)| {
        let off = |pair: &Pair| {
            let (Some(from), Some(to)) = (pair.from.attitude, pair.to.attitude) else { return f64::INFINITY };
            let (omega, flat) = by(pair);
            let q = if flat {
                straight(&from, &omega, pair.h)
            } else {
                attitude::product(&from, &attitude::turn(&(omega * pair.h)))
            };
            angle_between(&q, &to)
        };
        fits(pairs.iter().map(off).collect()).is_some()
    });
    if spin.is_none() && turn.is_none() {
        return None;
    }
    let name = |found: Option<&str>| found.unwrap_or("none of the rules known").to_string();
    Some(format!(
        "Each apart: the spin is stepped by: {}; the attitude by: {}.",
        name(spin.map(|x| x.1)),
        name(turn.map(|x| x.1))
    ))
}

impl Diagnosis {
    /// Whether one rule is named, or several that are one here.
    #[must_use]
    pub const fn names_a_rule(&self) -> bool {
        !matches!(self.sure, Sure::NoneFits | Sure::FewDigits)
    }

    /// Of rules that explain the steps alike to a few digits, those that drift over the whole record as the record does.
    pub(crate) fn by_drift(&mut self, subject: &Subject, sample: &Sample, run: &Run) {
        let all: Vec<Rule> = std::iter::once(self.best.rule).chain(self.alike.iter().copied()).collect();
        let (like, unlike): (Vec<Rule>, Vec<Rule>) =
            all.into_iter().partition(|rule| run.is_like(subject, rule));
        self.drifts = Some(like.len());
        if like.first() != Some(&self.best.rule) || !unlike.is_empty() {
            self.sure = Sure::FewDigits;
        }
        let mut ordered = like.into_iter().chain(unlike);
        if let Some(best) = ordered.next().and_then(|rule| explained(subject, sample.pairs(), rule)) {
            self.best = best;
        }
        self.alike = ordered.collect();
        if self.drifts == Some(1) {
            self.sure = Sure::ToRounding;
        }
    }

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
    floor: Floor,
    of_momentum: bool,
) -> Option<Diagnosis> {
    // Of attitudes alone each rule's spin has to be sought first, step by step: fewer steps do.
    let sought = sample.pairs().iter().any(|pair| pair.to.ahead.is_some());
    let every = if sought { sample.pairs().len().div_ceil(SOUGHT).max(1) } else { 1 };
    let pairs: Vec<Pair> = sample.pairs().iter().step_by(every).copied().collect();
    let pairs = pairs.as_slice();
    let explained = |rule: Rule| explained(subject, pairs, rule);
    let fits = |found: &[Explanation]| found.iter().any(|x| x.fits(floor));
    let free = subject.torque.is_none();
    let mut found: Vec<Explanation> = simple(free, pairs).into_iter().filter_map(explained).collect();
    if free && of_momentum {
        found.extend(momentum_for_spin(subject, pairs).and_then(explained));
    }
    if free && !of_momentum && !fits(&found) {
        found.extend(momentum_for_spin(subject, pairs).and_then(explained));
    }
    if free && !fits(&found) {
        found.extend(frozen_at(pairs).into_iter().filter_map(explained));
    }
    if free && !fits(&found) {
        found.extend(compound(subject, pairs).into_iter().filter_map(explained));
    }
    let least = found.iter().map(|x| x.middle).fold(f64::INFINITY, f64::min);
    if !least.is_finite() {
        return None;
    }
    // Within rounding of the best, in the middle as in the last twentieth.
    let near =
        |x: &&Explanation| x.middle <= (2.0 * least).max(if floor.few { 2.0 } else { 8.0 } * floor.size);
    let best_most = found.iter().filter(near).map(|x| x.most).fold(f64::INFINITY, f64::min);
    let alike_of = |x: &&Explanation| {
        near(x) && x.most <= (4.0 * best_most).max(if floor.few { 16.0 } else { 64.0 } * floor.size)
    };
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
    } else if best.middle <= (if floor.few { 2.0 } else { 100.0 }) * floor.size {
        Sure::MostSteps
    } else if best.middle < 0.01 && ratio >= 10.0 {
        Sure::Near
    } else {
        Sure::NoneFits
    };
    let mut hints = hints(subject, pairs, floor.size);
    if sure == Sure::NoneFits && free && !sought {
        hints.extend(apart(subject, pairs, floor));
    }
    Some(Diagnosis { best, alike, second, sure, steps: pairs.len(), hints, drifts: None })
}

/// The tensor frozen as it stood at the record's first attitude, where that is another than the identity.
fn frozen_at(pairs: &[Pair]) -> Vec<Rule> {
    let first = pairs.first().and_then(|pair| pair.from.attitude);
    let first = first.map(|q| q / q.norm()).filter(|q| q.imag().norm() > 0.0 && q.norm().is_finite());
    first.map_or(Vec::new(), |q| [Steps::First, Steps::Fourth].map(|steps| Rule::FrozenAt(q, steps)).to_vec())
}

/// A first step that brings the spin down to a value that no later step exceeds.
fn cap_at_start(pairs: &[Pair]) -> Option<String> {
    let (start, end) = (pairs.first()?.from.omega.norm(), pairs.first()?.to.omega.norm());
    let greatest = pairs.iter().skip(1).map(|pair| pair.to.omega.norm()).fold(0.0, f64::max);
    (pairs.len() > 2 && end > 0.0 && start > 1.05 * end && greatest <= end * (1.0 + 1e-6)).then(|| {
        format!(
            "The first step takes the spin from {} to {} rad/s, and no later one goes beyond: a cap on the spin.",
            significant(start),
            significant(end)
        )
    })
}

fn hints(subject: &Subject, pairs: &[Pair], floor: f64) -> Vec<String> {
    let mut hints = Vec::new();
    hints.extend(cap_at_start(pairs));
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
    let held = pairs.iter().filter(|pair| {
        let mean = (pair.from.omega + pair.to.omega) / 2.0;
        let law = euler::angular_acceleration(&subject.moments, &mean, &Vector3::zeros()) * pair.h;
        (0..3).any(|i| pair.to.omega[i] == 0.0 && law[i].abs() > 100.0 * floor * mean.norm())
    });
    let held = held.count();
    if held > 0 && subject.torque.is_none() {
        hints.push(format!(
            "In {held} of the steps tried a component of the spin is zero to the last digit, where the law moves it: a threshold for \
             small spins may hold it there."
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

    #[test]
    fn a_sample_is_no_larger_however_long_the_record_and_from_all_of_it() {
        let mut sample = Sample::new();
        for line in 0..1_000_000 {
            let state = Row { line, t: 0.0, attitude: None, omega: Vector3::zeros(), ahead: None };
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
