//! Which rule made a record: each candidate takes each row one step further, and is held against the next
//! row.

use crate::law::LawName;
use crate::read::{Floor, Known, Pair, Row, Sample, angle_between};
use crate::rule::confidence::confidence_in;
use crate::rule::fitted::some;
use crate::rule::tried::{alike_to_best, explained, tried};
use crate::rule::unnamed::unnamed;
use crate::rule::{Advice, Base, Confidence, Rule, Subject, engine_names, engines, first_named, settings};
use crate::thresholds::{BIASED, FASTER, FITS_EXACT, JUMP_IN_LIMITS, RESETS, SAME, TRIED_TURNS};
use nalgebra::Vector2;
use serde::Serialize;

/// A rule, and how far its steps are from the record's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Explanation {
    /// The rule.
    pub rule: Rule,
    /// The median of the steps' distances: of the spin relative to its length, of the attitude in rad,
    /// whichever is larger.
    pub median: f64,
    /// Their 95th percentile.
    pub percentile_95: f64,
}

impl Explanation {
    pub(super) fn fits(self, floor: Floor) -> bool {
        let fits = floor.fits(self.median, self.percentile_95);
        let [half, nearly_all] = FITS_EXACT.map(|units| units * floor.size);
        fits && (self.rule != Rule::EXACT || self.median <= half && self.percentile_95 <= nearly_all)
    }

    /// By how much another is farther from the record: in the median, or in the 95th percentile.
    pub(super) fn relative_to(&self, other: &Self) -> f64 {
        let ratio = |a: f64, b: f64| a.max(f64::EPSILON) / b.max(f64::EPSILON);
        ratio(other.median, self.median).max(ratio(other.percentile_95, self.percentile_95))
    }
}

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
    /// The number of steps tried.
    pub steps: usize,
    /// The share of the pairs of rows that are one step apart.
    pub share: f64,
    /// The rules named first: the best, and with a rule named those that make the same steps here and that an
    /// engine goes by.
    pub leading: Vec<Rule>,
    /// The engines' own settings, where the record fails and they have one for it.
    pub settings: Vec<String>,
    /// Engines known to go by one of them; where the record names one that goes by a rule that fits, this one
    /// first.
    pub engines: Vec<String>,
    /// Of an accurate rule that is not known the error of a step, as a share of what the gyroscopic term
    /// changes of the spin in it.
    pub error: Option<f64>,
    /// The steps that are not the rule's, where they are few.
    pub jumps: Vec<Jump>,
    /// Whether a faster spin would distinguish the rules that explain the record alike.
    pub(crate) open: bool,
    /// What to do, for each fault that is seen.
    pub advice: Vec<Advice>,
    /// Whether the numbers are of single precision.
    pub single: bool,
    /// Whether they are of fewer digits.
    pub(crate) few: bool,
    /// Whether the record fails, whatever its rule.
    pub(crate) fails: bool,
}

/// What the whole record shows, against which a rule of its single steps is held.
pub(crate) struct Whole {
    /// The laws that it breaks.
    pub broken: Vec<LawName>,
    /// Those that it does not keep to rounding.
    pub unkept: Vec<LawName>,
    /// Whether flips are missing, or too many.
    pub miscounted: bool,
    /// Whether it fails, whatever its rule.
    pub fails: bool,
    /// Whether all is kept to rounding; energy and momentum at least.
    pub kept: bool,
    pub lengths: bool,
    /// The share of the pairs of rows that are one step apart.
    pub share: f64,
}

impl Diagnosis {
    /// Whether the steps are the exact motion's, to the rounding of the record: any rule with smaller errors
    /// would look the same.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.confidence == Confidence::ToRounding && self.best.rule == Rule::EXACT
    }

    /// Whether nothing is known of the rule of a record that fails: that the exact motion is the nearest of
    /// those known says nothing for it.
    pub(crate) fn is_open(&self) -> bool {
        let nearest = self.best.rule.base == Base::Exact && !matches!(self.confidence, Confidence::Altered);
        let unnamed = !self.confidence.names_a_rule() && self.confidence != Confidence::FewDigits;
        self.fails && nearest && unnamed
    }

    /// What would decide between the rules that explain the record alike.
    #[must_use]
    pub fn would_decide(&self) -> Option<&'static str> {
        let open = self.open || self.is_exact();
        match self.confidence {
            Confidence::FewSteps => Some("a row at every step"),
            Confidence::SmallErrors => Some("a faster spin, or longer steps"),
            Confidence::NoneFits | Confidence::Accurate | Confidence::Altered | Confidence::Interpolated => {
                None
            }
            _ if !open => None,
            _ if self.single || self.few => Some(
                "all digits that the engine has (17 of double precision), a faster spin, or longer steps",
            ),
            _ => Some("a faster spin, or longer steps"),
        }
    }

    /// By how much the next rule is farther from the record than the best.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        self.second.map(|second| self.best.relative_to(&second))
    }
}

/// The rules that explain a record: the best, others that do so alike, and the next.
pub(super) struct Ranked {
    pub best: Explanation,
    pub alike: Vec<Rule>,
    pub second: Option<Explanation>,
}

impl Ranked {
    fn of(found: &[Explanation], floor: Floor) -> Option<Self> {
        let least = found.iter().map(|x| x.median).fold(f64::INFINITY, f64::min);
        if !least.is_finite() {
            return None;
        }
        let alike_of = alike_to_best(found, floor);
        let best = *found.iter().find(|x| alike_of(x))?;
        // A rule with limits that the record does not reach is the rule without them.
        let mut seen = vec![best.rule];
        let mut is_new = |rule: &Rule| {
            let same =
                |other: &Rule| rule == other || rule.method().is_some_and(|x| other.method() == Some(x));
            let new = !seen.iter().any(same);
            seen.push(*rule);
            new
        };
        // Where even the best is farther off than its own rounding would put it, whatever fits may be it.
        let [rounding, _] = floor.closely();
        let alike_of = |x: &Explanation| alike_of(x) || least > rounding && x.fits(floor);
        let alike = found.iter().filter(|x| alike_of(x)).map(|x| x.rule).filter(&mut is_new).collect();
        let others = found.iter().filter(|x| !alike_of(x)).copied();
        let second = others.min_by(|a, b| best.relative_to(a).total_cmp(&best.relative_to(b)));
        Some(Self { best, alike, second })
    }

    /// Without the rules that change energy and momentum in the mean otherwise than the record, unless all
    /// do; and how sure that is.
    fn unbiased(mut self, subject: &Subject, pairs: &[Pair], floor: Floor) -> (Self, Confidence) {
        let all = std::iter::once(self.best.rule).chain(self.alike.iter().copied());
        let like: Vec<Rule> = all.filter(|rule| !is_biased(subject, pairs, rule, floor)).collect();
        if like.len() > self.alike.len() && self.best.rule != Rule::EXACT {
            return (self, Confidence::ToRounding);
        }
        if let [first, others @ ..] = &like[..] {
            self.best = explained(subject, pairs, *first).unwrap_or(self.best);
            self.alike = others.to_vec();
        }
        (self, Confidence::FewDigits)
    }
}

impl Whole {
    /// Whether a record of few digits fails: of such digits a wrong rule may fit each step, and what the
    /// whole record does is held against it too.
    fn is_astray(&self, best: &Rule, floor: Floor) -> bool {
        let fails = self.miscounted || !self.broken.is_empty();
        floor.few && fails || (floor.few || floor.single) && self.fails && *best == Rule::EXACT
    }
}

/// A rule that fits every step, held against what the whole record shows.
fn settled(
    subject: &Subject,
    pairs: &[Pair],
    ranked: Ranked,
    whole: &Whole,
    floor: Floor,
) -> (Ranked, Confidence) {
    let (few, best) = (floor.single || floor.few, ranked.best.rule);
    let sought = pairs.iter().any(|pair| pair.to.ahead.is_some());
    if whole.is_astray(&best, floor) || is_biased(subject, pairs, &best, floor) {
        return ranked.unbiased(subject, pairs, floor);
    }
    // What such a rule does to energy and momentum is below the rounding of few digits: others do less.
    let first = best.method().is_some_and(|rule| rule.0.info().order == 1);
    // A rule that keeps a law does not make every step of a record that breaks it.
    let kept = |law: &LawName| best == Rule::EXACT || best.keeps(*law);
    let confidence = match whole.broken.iter().any(kept) {
        true if few => Confidence::FewDigits,
        true => Confidence::MostSteps,
        false if few && first && !whole.fails && (whole.lengths || sought) => Confidence::SmallErrors,
        false => Confidence::ToRounding,
    };
    (ranked, confidence)
}

/// Whether a rule that fits each step to the rounding of few digits changes energy or momentum otherwise in
/// the mean of them, in which rounding is much less.
fn is_biased(subject: &Subject, pairs: &[Pair], rule: &Rule, floor: Floor) -> bool {
    let drift = |pair: &Pair| {
        let end = subject.next(rule, &pair.from, pair.h).filter(|_| pair.to.ahead.is_none())?.omega;
        let [a, b] = [end, pair.to.omega].map(|omega| (omega, subject.moments.component_mul(&omega)));
        Some(Vector2::new((a.0.dot(&a.1) / b.0.dot(&b.1)).ln(), (a.1.norm() / b.1.norm()).ln()))
    };
    let all: Vec<_> = pairs.iter().filter_map(drift).collect();
    let count = all.len().max(1) as f64;
    // What is rounded where it is written does not add up; the engine's own rounding may.
    let adds_up = if floor.few { count.sqrt() } else { 1.0 };
    let mean = all.iter().sum::<Vector2<f64>>() / count;
    (floor.single || floor.few) && mean.amax() > BIASED * floor.size / adds_up
}

/// Tries every candidate on the sample.
pub(crate) fn diagnose(
    subject: &Subject,
    sample: &Sample,
    known: &Known,
    whole: &Whole,
) -> Option<Diagnosis> {
    let floor = known.floor;
    // Of attitudes alone each rule's spin has to be found first, step by step: fewer steps do.
    let sought = sample.pairs().iter().any(|pair| pair.to.ahead.is_some());
    let pairs = if sought { some(sample.pairs(), TRIED_TURNS) } else { sample.pairs().to_vec() };
    let pairs = pairs.as_slice();
    let found = tried(subject, pairs, known, sought);
    let mut ranked = Ranked::of(&found, floor)?;
    let mut confidence = confidence_in(subject, pairs, &ranked, known, whole.share);
    // A rule that keeps a law is not nearly that of a record that does not.
    if confidence == Confidence::Near && whole.unkept.iter().any(|law| ranked.best.rule.keeps(*law)) {
        confidence = Confidence::NoneFits;
    }
    let mut error = None;
    if confidence == Confidence::NoneFits && !sought {
        (ranked, confidence, error) = unnamed(subject, pairs, &found, ranked, whole.fails, floor);
    }
    let jumps = match confidence {
        Confidence::ToRounding | Confidence::MostSteps => jumps(subject, pairs, &ranked.best.rule, floor),
        _ => Vec::new(),
    };
    if !jumps.is_empty() {
        confidence = Confidence::MostSteps;
    } else if confidence == Confidence::ToRounding {
        (ranked, confidence) = settled(subject, pairs, ranked, whole, floor);
    }
    let Ranked { best, alike, second } = ranked;
    let header = known.said.engine.as_deref().unwrap_or_default();
    let named =
        confidence.names_a_rule() && !(confidence == Confidence::ToRounding && best.rule == Rule::EXACT);
    let own: Vec<_> = engines(header, std::iter::once(&best.rule).chain(&alike));
    let leading = first_named(&best.rule, if named { &alike } else { &[] }, own.first().map(|own| own.0));
    Some(Diagnosis {
        best: Explanation { rule: best.rule.times(subject.unit), ..best },
        alike: alike.iter().map(|rule| rule.times(subject.unit)).collect(),
        second: second.map(|x| Explanation { rule: x.rule.times(subject.unit), ..x }),
        confidence,
        steps: pairs.len(),
        share: whole.share,
        engines: engine_names(&own, &leading),
        settings: if whole.fails { settings(&own, &leading) } else { Vec::new() },
        leading: leading.iter().map(|rule| rule.times(subject.unit)).collect(),
        error,
        advice: Advice::of(confidence, &best.rule, floor.single, whole, !jumps.is_empty()),
        open: alike.iter().any(|rule| is_another(subject, pairs, &best.rule, rule)),
        jumps,
        single: floor.single,
        few: floor.few,
        fails: whole.fails,
    })
}

/// The steps that are not the rule's, if they are few.
fn jumps(subject: &Subject, pairs: &[Pair], rule: &Rule, floor: Floor) -> Vec<Jump> {
    let most = JUMP_IN_LIMITS * floor.limits()[1];
    let jump = |pair: &Pair| {
        let size = subject.residual(rule, pair);
        (size > most).then_some(Jump { line: pair.to.line, time: pair.to.t, size })
    };
    let all: Vec<Jump> = pairs.iter().filter_map(jump).collect();
    if all.len() <= RESETS { all } else { Vec::new() }
}

/// Whether two rules differ where the body is faster.
fn is_another(subject: &Subject, pairs: &[Pair], rule: &Rule, other: &Rule) -> bool {
    let Some(pair) = pairs.first() else { return false };
    let from = Row { omega: pair.from.omega * FASTER, ..pair.from };
    let next = |rule: &Rule| subject.next(rule, &from, pair.h);
    let Some((a, b)) = next(rule).zip(next(other)) else { return true };
    let turn = a.attitude.zip(b.attitude).map_or(0.0, |(a, b)| angle_between(&a, &b));
    turn.max((a.omega - b.omega).norm() / a.omega.norm()) > SAME
}
