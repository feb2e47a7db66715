//! Which rule made a record: each suspect takes each row one step further, and is held against the next row.

use crate::candidates::Subject;
use crate::drift::Run;
use crate::findings::Hint;
use crate::fitted::{compound, momentum_for_spin};
use crate::hints::{apart, hints};
use crate::rules::{Rule, frozen_at, plain};
use crate::sample::{Floor, Sample};
use crate::state::{Pair, middle_and_most};
use crate::thresholds::{ALIKE, ALIKE_FEW, ALIKE_ROUNDINGS, FITS, FITS_FEW, NEAR, NEAR_RATIO, TRIED_TURNS};

/// A rule, and how far its steps are from the record's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Explanation {
    /// The rule.
    pub rule: Rule,
    /// Half of the steps are nearer than this (spin beside spin, attitude in rad).
    pub median: f64,
    /// 95 of 100 are nearer than this.
    pub percentile_95: f64,
}

impl Explanation {
    fn fits(self, floor: Floor) -> bool {
        floor.fits(self.median, self.percentile_95)
    }

    /// By how much another is farther from the record: in the middle, or in the last twentieth.
    fn beside(&self, other: &Self) -> f64 {
        let ratio = |a: f64, b: f64| a.max(f64::EPSILON) / b.max(f64::EPSILON);
        ratio(other.median, self.median).max(ratio(other.percentile_95, self.percentile_95))
    }
}

/// How sure a diagnosis is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Confidence {
    /// Every step is the rule's to rounding.
    ToRounding,
    /// More than half of the steps are the rule's to rounding; one in twenty or more is not.
    MostSteps,
    /// Nearer than any other by far, and not to rounding: such a rule, in some other form.
    Near,
    /// The steps are its own to rounding, and so they are of other rules; over the whole record it does not
    /// drift as the record does, or it is one of several that do.
    FewDigits,
    /// None of the rules known here.
    NoneFits,
}

impl Confidence {
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
    pub confidence: Confidence,
    /// How many steps were tried.
    pub steps: usize,
    /// What else was seen.
    pub hints: Vec<Hint>,
    /// Of a record of few digits that breaks a law: how many of the best and those alike, the first of them,
    /// drift as the whole record does.
    pub drifts: Option<usize>,
}

fn explained(subject: &Subject, pairs: &[Pair], rule: Rule) -> Option<Explanation> {
    let residuals = pairs.iter().map(|pair| subject.residual(&rule, pair)).collect();
    middle_and_most(residuals).map(|[median, percentile_95]| Explanation { rule, median, percentile_95 })
}

impl Diagnosis {
    /// Whether one rule is named, or several that are one here.
    #[must_use]
    pub const fn names_a_rule(&self) -> bool {
        !matches!(self.confidence, Confidence::NoneFits | Confidence::FewDigits)
    }

    /// Of rules that explain the steps alike to a few digits, those that drift over the whole record as the
    /// record does.
    pub(crate) fn by_drift(&mut self, subject: &Subject, sample: &Sample, run: &Run) {
        let all: Vec<Rule> = std::iter::once(self.best.rule).chain(self.alike.iter().copied()).collect();
        let (like, unlike): (Vec<Rule>, Vec<Rule>) =
            all.into_iter().partition(|rule| run.is_like(subject, rule));
        self.drifts = Some(like.len());
        if like.first() != Some(&self.best.rule) || !unlike.is_empty() {
            self.confidence = Confidence::FewDigits;
        }
        let mut ordered = like.into_iter().chain(unlike);
        if let Some(best) = ordered.next().and_then(|rule| explained(subject, sample.pairs(), rule)) {
            self.best = best;
        }
        self.alike = ordered.collect();
        if self.drifts == Some(1) {
            self.confidence = Confidence::ToRounding;
        }
    }

    /// By how much the next rule is farther from the record than the best.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        self.second.map(|second| self.best.beside(&second))
    }
}

/// Tries every suspect on the sample.
pub(crate) fn diagnose(
    subject: &Subject,
    sample: &Sample,
    floor: Floor,
    of_momentum: bool,
) -> Option<Diagnosis> {
    // Of attitudes alone each rule's spin has to be found first, step by step: fewer steps do.
    let sought = sample.pairs().iter().any(|pair| pair.to.ahead.is_some());
    let every = if sought { sample.pairs().len().div_ceil(TRIED_TURNS).max(1) } else { 1 };
    let pairs: Vec<Pair> = sample.pairs().iter().step_by(every).copied().collect();
    let pairs = pairs.as_slice();
    let found = tried(subject, pairs, floor, of_momentum);
    let least = found.iter().map(|x| x.median).fold(f64::INFINITY, f64::min);
    if !least.is_finite() {
        return None;
    }
    // Within rounding of the best, in the middle as in the last twentieth.
    let [half, nearly_all] = floor.either(ALIKE_ROUNDINGS, ALIKE_FEW).map(|units| units * floor.size);
    let near = |x: &&Explanation| x.median <= (ALIKE[0] * least).max(half);
    let best_most = found.iter().filter(near).map(|x| x.percentile_95).fold(f64::INFINITY, f64::min);
    let alike_of = |x: &&Explanation| near(x) && x.percentile_95 <= (ALIKE[1] * best_most).max(nearly_all);
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
    let confidence = confidence_in(&best, second.as_ref(), floor);
    let mut hints = hints(subject, pairs, floor.size);
    if confidence == Confidence::NoneFits && subject.torque.is_none() && !sought {
        hints.extend(apart(subject, pairs, floor));
    }
    Some(Diagnosis { best, alike, second, confidence, steps: pairs.len(), hints, drifts: None })
}

/// How far each suspect's steps are from the record's: plain rules first, and others while none fits.
fn tried(subject: &Subject, pairs: &[Pair], floor: Floor, of_momentum: bool) -> Vec<Explanation> {
    let explained = |rule: Rule| explained(subject, pairs, rule);
    let fits = |found: &[Explanation]| found.iter().any(|x| x.fits(floor));
    let free = subject.torque.is_none();
    let mut found: Vec<Explanation> = plain(free, pairs).into_iter().filter_map(explained).collect();
    if free && (of_momentum || !fits(&found)) {
        found.extend(momentum_for_spin(subject, pairs).and_then(explained));
    }
    if free && !fits(&found) {
        found.extend(frozen_at(pairs).into_iter().filter_map(explained));
    }
    if free && !fits(&found) {
        found.extend(compound(subject, pairs).into_iter().filter_map(explained));
    }
    found
}

fn confidence_in(best: &Explanation, second: Option<&Explanation>, floor: Floor) -> Confidence {
    let ratio = second.map_or(f64::INFINITY, |second| best.beside(second));
    if best.fits(floor) {
        Confidence::ToRounding
    } else if best.median <= floor.either(FITS, FITS_FEW)[0] * floor.size {
        Confidence::MostSteps
    } else if best.median < NEAR && ratio >= NEAR_RATIO {
        Confidence::Near
    } else {
        Confidence::NoneFits
    }
}
