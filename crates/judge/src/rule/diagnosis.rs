//! Which rule made a record: each candidate takes each row one step further, and is held against the next
//! row.

use crate::law::LawName;
use crate::read::{Floor, Known, Pair, Row, angle_between, rounded};
use crate::rule::confidence::confidence_in;
use crate::rule::fitted::some;
use crate::rule::jumps::{Jump, pushes, without};
use crate::rule::tried::{alike_to_best, explained, tried};
use crate::rule::unnamed::{attitudes_scatter, times_the_term, unnamed};
use crate::rule::{
    Advice, Alteration, Base, Confidence, Rule, Subject, When, engine_names, engines, first_named, settings,
};
use crate::thresholds::*;
use nalgebra::{Vector2, Vector3};

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
        let of_exact = FITS_EXACT.map(|units| units * floor.size);
        let within = |[half, nearly_all]: [f64; 2]| self.median <= half && self.percentile_95 <= nearly_all;
        within(floor.limits()) && (self.rule != Rule::EXACT || within(of_exact))
    }

    /// By how much another is farther from the record: in the median, or in the 95th percentile.
    pub(super) fn relative_to(&self, other: &Self) -> f64 {
        let ratio = |a: f64, b: f64| a.max(f64::EPSILON) / b.max(f64::EPSILON);
        ratio(other.median, self.median).max(ratio(other.percentile_95, self.percentile_95))
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
    /// changes of the spin in it; of rows that scatter by how much, relative to the spin.
    pub error: Option<f64>,
    /// The steps that are not the rule's, where they are few.
    pub jumps: Vec<Jump>,
    /// How many times as much as by the gyroscopic term the spin changes, where no rule fits and that is far
    /// from one.
    pub(crate) term: Option<f64>,
    /// Whether a faster spin would distinguish the rules that explain the record alike.
    pub(crate) open: bool,
    /// What to do, for each fault that is seen.
    pub advice: Vec<Advice>,
    /// Whether the numbers are of single precision.
    pub single: bool,
    /// Whether they are of fewer digits.
    pub(crate) few: bool,
    /// The rounding of the numbers, relative to 1.
    pub(crate) rounding: f64,
    /// Whether the record fails, whatever its rule.
    pub(crate) fails: bool,
}

/// What the whole record shows, against which a rule of its single steps is held.
pub(crate) struct Whole {
    /// The laws that it breaks.
    pub broken: Vec<LawName>,
    /// Those that it does not keep to rounding.
    pub unkept: Vec<LawName>,
    /// Whether it fails, whatever its rule.
    pub fails: bool,
    /// Whether it fails by its columns, by resets or by where its numbers end alone, and not by a rule.
    pub fails_otherwise: bool,
    /// Whether all is kept to rounding.
    pub kept: bool,
    /// The share of the pairs of rows that are one step apart.
    pub share: f64,
    /// Whether rows repeat the row before them, and whether too many do for a rule to be named.
    pub again: bool,
    pub repeats: bool,
    /// Whether the attitude is turned on the wrong side.
    pub on_wrong_side: bool,
    /// Whether the step is known from times of few digits alone.
    pub of_few_times: bool,
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
        use Confidence::{Altered, Interpolated, Repeated, Scattered};
        let of_rate = matches!(self.best.rule.alteration, Some(Alteration::TermOrTimes(_)));
        let named = self.confidence == Altered || of_rate && self.confidence == Confidence::SmallErrors;
        let nearest = self.best.rule.base == Base::Exact && !named;
        let unnamed = !self.confidence.names_a_rule() && self.confidence != Confidence::FewDigits;
        let of_rows = matches!(self.confidence, Interpolated | Repeated | Scattered);
        of_rows || self.fails && nearest && unnamed
    }

    /// What would decide between the rules that explain the record alike.
    #[must_use]
    pub fn would_decide(&self) -> Option<&'static str> {
        let named = self.confidence.names_a_rule() || self.confidence == Confidence::FewDigits;
        let more = "all digits that the engine has (17 of double precision), a faster spin, or longer steps";
        let words = if self.single || self.few { more } else { "a faster spin, or longer steps" };
        (named && (self.open || self.is_exact())).then_some(words)
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
            let same = |old: &Rule| rule == old || rule.method().is_some_and(|x| old.method() == Some(x));
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

    /// Without the place in the step where damping acts, if it might be another.
    fn placed(mut self, found: &[Explanation], floor: Floor) -> Self {
        let best = self.best.rule;
        let other = |rule: &Rule| rule.base == best.base && rule.is_damped();
        let places: Vec<_> = found.iter().filter(|x| other(&x.rule)).copied().collect();
        if let Some(Alteration::Damped { when, .. }) = &mut self.best.rule.alteration
            && places.iter().filter(|x| alike_to_best(&places, floor)(x)).count() > 1
        {
            *when = When::Open;
            self.alike.retain(|rule| !other(rule));
        }
        self
    }
}

/// Rules that fit every step, held against what the whole record shows.
fn settled(subject: &Subject, all: &[Pair], ranked: &mut Ranked, whole: &Whole, floor: Floor) -> Confidence {
    let few = floor.single || floor.few;
    // Of few digits the exact motion may fit each step of a record that fails.
    let astray = |rule: &Rule| few && whole.fails && *rule == Rule::EXACT;
    let is_one = |rule: &Rule| !astray(rule) && !is_biased(subject, all, rule, floor);
    ranked.alike.retain(is_one);
    let best = ranked.best.rule;
    if !is_one(&best) {
        let Some(&first) = ranked.alike.first() else { return Confidence::NoneFits };
        ranked.alike.remove(0);
        ranked.best = explained(subject, all, first).unwrap_or(ranked.best);
        return Confidence::FewDigits;
    }
    let sought = all.iter().any(|pair| pair.to.ahead.is_some());
    // What such a rule does to energy and momentum is below the rounding of few digits: others do less.
    let base = best.base.spin().or(best.method()).filter(|_| !best.base.is_still());
    let first = base.is_some_and(|base| base.0.info().order == 1);
    // Some rules of first order differ by what they do to these alone.
    let unseen = || {
        let random = BIASED[3] * floor.size * (all.len() as f64).sqrt();
        first && best.alteration.is_none() && changes(subject, all, &best)[0].amax() <= random
    };
    // A rule that keeps a law does not make every step of a record that breaks it.
    let kept = |law: &LawName| best == Rule::EXACT || best.keeps(*law);
    // Rules that keep the laws go along the exact motion's curve at rates of their own, and with wrong times
    // at any: a number that is not round is no name.
    let near = NEAR_A_TERM[0].max(FITS_EXACT[0] * floor.size);
    let own = best.alteration.filter(|_| best.base == Base::Exact);
    let is_round = |x: f64| rounded(x).is_some_and(|round| (x / round - 1.0).abs() <= near);
    let between = matches!(own, Some(Alteration::TermOrTimes(x)) if !is_round(x));
    let kept_all = whole.unkept.is_empty();
    match whole.broken.iter().any(kept) {
        _ if between => Confidence::SmallErrors,
        true if few => Confidence::FewDigits,
        true => Confidence::MostSteps,
        false if few && !sought && unseen() => Confidence::SmallErrors,
        false if few && first && !whole.fails && (sought || kept_all) => Confidence::SmallErrors,
        false => Confidence::ToRounding,
    }
}

/// Rules that fit every step between jumps, held against what these steps show together.
fn between_jumps(subject: &Subject, own: &[Pair], ranked: &mut Ranked, floor: Floor) -> Confidence {
    ranked.alike.retain(|rule| !is_biased(subject, own, rule, floor));
    match is_biased(subject, own, &ranked.best.rule, floor) {
        true => Confidence::NoneFits,
        false if floor.few && !ranked.alike.is_empty() => Confidence::FewDigits,
        false => Confidence::MostSteps,
    }
}

/// Whether the steps of a rule, all of which fit, change energy or momentum otherwise in their sum than the
/// record's do: rounding is much less in a sum. Nor does a record keep what a rule changes step by step, or
/// what the rule without its damping does.
fn is_biased(subject: &Subject, pairs: &[Pair], rule: &Rule, floor: Floor) -> bool {
    let undamped = rule.is_damped().then(|| Rule::plain(rule.base));
    let [count, root] = [pairs.len() as f64, (pairs.len() as f64).sqrt()];
    let turned: f64 = pairs.iter().map(|pair| pair.from.omega.norm() * pair.h).sum();
    let parts = 1 + pairs.windows(2).filter(|two| two[0].to.line != two[1].from.line).count();
    let [ends, turns, each, kept] = BIASED.map(|roundings| roundings * floor.size);
    // What is rounded where it is written is in two steps, with opposite signs but for the turn; the engine's
    // own rounding may add up.
    let [allowed, kept] = match floor.is_of_writing() {
        true => [ends * (parts as f64).sqrt() + turns * turned / root, kept * root],
        // Of a spin made from a turn the next step takes back what this one is off by.
        false if floor.size > FITS_FEW_FROM => {
            let is_sought = pairs.iter().any(|pair| pair.to.ahead.is_some());
            let own = if is_sought { floor.attitude } else { floor.size };
            [ends * floor.size + each / floor.size * own * count, kept * root]
        }
        false => [floor.limits()[1] * count; 2],
    };
    let holds = |own: f64, seen: f64| own.abs() > kept && seen.abs() < KEPT_OF_CHANGED * own.abs();
    std::iter::once(*rule).chain(undamped).any(|this| {
        let [own, seen] = changes(subject, pairs, &this);
        (own - seen).amax() > allowed && this == *rule || (0..2).any(|i| holds(own[i], seen[i]))
    })
}

/// The logarithms by which all steps of a rule together change energy and momentum, and those of the record.
fn changes(subject: &Subject, pairs: &[Pair], rule: &Rule) -> [Vector2<f64>; 2] {
    let size = |omega: Vector3<f64>| {
        let momentum = subject.moments.component_mul(&omega);
        Vector2::new(omega.dot(&momentum).ln(), momentum.norm().ln())
    };
    let step = |(i, pair): (usize, &Pair)| {
        if pair.to.ahead.is_none() {
            return Some([pair.from.omega, subject.spin_after(rule, pair)?, pair.to.omega]);
        }
        // A spin made from turns is not the rule's own: that of the next turn is.
        let next = pairs.get(i + 1).filter(|next| next.from.line == pair.to.line)?;
        let [(own, _), (next, _)] = [subject.spins_of_turn(rule, pair)?, subject.spins_of_turn(rule, next)?];
        Some([own[0], own[1], next[0]])
    };
    let steps = pairs.iter().enumerate().filter_map(step).map(|all| all.map(size));
    steps.fold([Vector2::zeros(); 2], |[own, seen], [from, end, to]| [own + end - from, seen + to - from])
}

/// Whether a record drifts otherwise than a rule that comes near to it: what is left of a rule without fitted
/// numbers is random, and what it keeps is kept.
fn drifts_from(subject: &Subject, pairs: &[Pair], best: &Explanation, whole: &Whole) -> bool {
    let rule = best.rule;
    let is_plain = rule.alteration.is_none() && !matches!(rule.base, Base::MomentumForSpin(_));
    let [own, seen] = changes(subject, pairs, &rule);
    let drifts = is_plain && (own - seen).amax() > BIASED[0] * best.median * (pairs.len() as f64).sqrt();
    drifts || whole.unkept.iter().any(|law| rule.keeps(*law))
}

/// Tries every candidate on the sample.
pub(crate) fn diagnose(subject: &Subject, all: &[Pair], known: &Known, whole: &Whole) -> Option<Diagnosis> {
    let floor = known.floor;
    // Of attitudes alone each rule's spin has to be found first, step by step: fewer steps do.
    let sought = all.iter().any(|pair| pair.to.ahead.is_some());
    let pairs = &*if sought { some(all, TRIED_TURNS) } else { all.to_vec() };
    let found = tried(subject, pairs, known, sought);
    let (mut ranked, mut error) = (Ranked::of(&found, floor)?, None);
    ranked.second = ranked.second.and_then(|second| explained(subject, pairs, second.rule));
    let (mut confidence, mut jumps) = confidence_in(subject, pairs, &ranked, known, whole);
    if confidence == Confidence::Near && drifts_from(subject, pairs, &ranked.best, whole) {
        confidence = Confidence::NoneFits;
    }
    // Friction that overshoots at rest turns the spin right round in each step, and is no scatter.
    let is_back =
        |x: &Pair| x.from.omega.dot(&x.to.omega) <= RIGHT_ROUND * x.from.omega.norm() * x.to.omega.norm();
    let going: Vec<_> = pairs.iter().filter(|x| !is_back(x)).copied().collect();
    let going = if going.is_empty() { pairs } else { &going };
    if confidence == Confidence::NoneFits && !sought {
        (ranked, confidence, error) = unnamed(subject, going, &found, ranked, whole.fails, floor);
    }
    if confidence == Confidence::NoneFits {
        jumps = pushes(subject, pairs, &found, floor);
    }
    let shows = confidence == Confidence::NoneFits && jumps.is_empty() && !sought;
    let term = if shows { times_the_term(subject, going) } else { None };
    if confidence == Confidence::ToRounding {
        confidence = settled(subject, pairs, &mut ranked, whole, floor);
    } else if confidence == Confidence::MostSteps {
        confidence = between_jumps(subject, &without(pairs, &jumps), &mut ranked, floor);
        jumps.retain(|_| confidence != Confidence::NoneFits);
    }
    let Ranked { best, alike, second } = ranked.placed(&found, floor);
    let turns = pairs.iter().any(|pair| pair.from.attitude.is_some());
    let scatter = !sought && attitudes_scatter(subject, pairs, best.rule.base, floor);
    let header = known.said.engine.as_deref().unwrap_or_default();
    let named =
        confidence.names_a_rule() && (confidence != Confidence::ToRounding || best.rule != Rule::EXACT);
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
        settings: if whole.fails && named { settings(&own, &leading) } else { Vec::new() },
        leading: leading.iter().map(|rule| rule.times(subject.unit)).collect(),
        error,
        advice: Advice::of(confidence, &best.rule, floor, whole, [!jumps.is_empty(), turns, scatter]),
        term,
        open: alike.iter().any(|rule| is_another(subject, pairs, &best.rule, rule)),
        jumps,
        single: floor.single,
        few: floor.few,
        rounding: floor.size,
        fails: whole.fails,
    })
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
