//! Finds the rule that made a record: each candidate takes each row one step further, and its result is
//! compared with the next row.

use crate::law::LawName;
use crate::read::{Floor, Known, Pair, Row, angle_between, rounded};
use crate::rule::confidence::confidence_in;
use crate::rule::fitted::some;
use crate::rule::jumps::{Jump, far_off, pushes, without};
use crate::rule::tried::{alike_to_best, explained, tried};
use crate::rule::unnamed::{
    attitudes_scatter, by_alteration, changes, drifts_from, going, times_the_term, unnamed,
};
use crate::rule::{
    Advice, Alteration, Base, Confidence, Rule, Subject, When, engine_names, engines, first_named, settings,
    with_unseen,
};
use crate::thresholds::*;

/// A rule, and the distance of its steps from the record's.
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

    /// The ratio of another rule's distance to this one's, in the median or in the 95th percentile.
    pub(super) fn relative_to(&self, other: &Self) -> f64 {
        let ratio = |a: f64, b: f64| a.max(f64::EPSILON) / b.max(f64::EPSILON);
        ratio(other.median, self.median).max(ratio(other.percentile_95, self.percentile_95))
    }
}

/// The rules that may have made the record.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnosis {
    /// The rule that fits best; of several that fit equally well, the simplest.
    pub best: Explanation,
    /// Other rules that fit equally well.
    pub alike: Vec<Rule>,
    /// The best of the rules that fit less well.
    pub second: Option<Explanation>,
    /// How certain it is.
    pub confidence: Confidence,
    /// The number of steps tried.
    pub steps: usize,
    /// The share of the pairs of rows that are one step apart.
    pub share: f64,
    /// The rules named first: the best and, if a rule is named, those with the same steps in this record that
    /// an engine uses.
    pub leading: Vec<Rule>,
    /// The engines' own settings, where the record fails and they have one for it.
    pub settings: Vec<String>,
    /// Engines known to use one of them; an engine that the record names comes first, if it uses a rule that
    /// fits.
    pub engines: Vec<String>,
    /// For an unknown accurate rule, the error of a step as a share of the change of spin by the gyroscopic
    /// term; for rows that scatter, the scatter relative to the spin.
    pub error: Option<f64>,
    /// The steps that do not follow the rule, if they are few.
    pub jumps: Vec<Jump>,
    /// The ratio of the change of spin to that by the gyroscopic term, if no rule fits and it is far from 1.
    pub(crate) term: Option<f64>,
    /// Whether a faster spin would distinguish the rules that explain the record alike.
    pub(crate) open: bool,
    /// The advice, one for each fault found.
    pub advice: Vec<Advice>,
    /// Whether the numbers are of single precision.
    pub single: bool,
    /// Their rounding.
    pub(crate) floor: Floor,
    /// Whether the record fails, whatever its rule.
    pub(crate) fails: bool,
}

/// Evidence from the whole record, with which a rule found from single steps is compared.
pub(crate) struct Whole {
    /// The laws that it breaks.
    pub broken: Vec<LawName>,
    /// The laws that it does not keep to rounding.
    pub unkept: Vec<LawName>,
    /// Whether it fails, whatever its rule.
    pub fails: bool,
    /// Whether nothing fails, or only what its columns are called.
    pub is_sound: bool,
    /// Whether it fails only by its columns, by resets or by an early end of its numbers, not by a rule.
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
    /// Whether the steps, but for jumps, are the exact motion's to the rounding of the record: any rule with
    /// smaller errors would look the same.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        matches!(self.confidence, Confidence::ToRounding | Confidence::MostSteps)
            && self.best.rule == Rule::EXACT
    }

    /// Whether the rule of a record that fails is unknown: that the exact motion is the nearest known rule is
    /// no evidence for it.
    pub(crate) fn is_open(&self) -> bool {
        use Confidence::{Altered, Interpolated, Repeated, Scattered};
        let of_rate = matches!(self.best.rule.alteration, Some(Alteration::TermOrTimes(_)));
        let named = self.confidence == Altered || of_rate && self.confidence == Confidence::SmallErrors;
        let nearest = self.best.rule.base == Base::Exact && !named;
        let unnamed = !self.confidence.names_a_rule() && self.confidence != Confidence::FewDigits;
        let of_rows = matches!(self.confidence, Interpolated | Repeated | Scattered);
        of_rows || self.fails && nearest && unnamed
    }

    /// What to record to distinguish between the rules that fit equally well.
    #[must_use]
    pub fn would_decide(&self) -> Option<&'static str> {
        let named = self.confidence.names_a_rule() || self.confidence == Confidence::FewDigits;
        let more = "all digits that the engine has (17 of double precision), a faster spin, or longer steps";
        let words = if self.single || self.floor.few { more } else { "a faster spin, or longer steps" };
        (named && (self.open || self.is_exact())).then_some(words)
    }

    /// The ratio of the next rule's distance from the record to the best one's.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        self.second.map(|second| self.best.relative_to(&second))
    }
}

/// The rules that fit a record: the best, those that fit equally well, and the next.
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
        // If even the best is off by more than its own rounding, any rule that fits is possible.
        let [rounding, _] = floor.closely();
        let alike_of = |x: &Explanation| alike_of(x) || least > rounding && x.fits(floor);
        let alike = found.iter().filter(|x| alike_of(x)).map(|x| x.rule).filter(&mut is_new).collect();
        let others = found.iter().filter(|x| !alike_of(x)).copied();
        let second = others.min_by(|a, b| best.relative_to(a).total_cmp(&best.relative_to(b)));
        Some(Self { best, alike, second })
    }

    /// Without factors of times that rounding of these may explain: it is the rows that scatter.
    fn timed(mut self, whole: &Whole, confidence: &mut Confidence) -> Self {
        let of_rounding = |rule: &Rule| match rule.alteration {
            Some(Alteration::Times(x) | Alteration::TermOrTimes(x)) => TIMES_OF_ROUNDING.contains(&x),
            _ => false,
        };
        if whole.of_few_times {
            self.alike.retain(|rule| !of_rounding(rule));
            *confidence = if of_rounding(&self.best.rule) { Confidence::Scattered } else { *confidence };
        }
        self
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

/// Compares rules that fit every step with the whole record.
fn settled(subject: &Subject, all: &[Pair], ranked: &mut Ranked, whole: &Whole, floor: Floor) -> Confidence {
    let few = floor.single || floor.few;
    // With few digits the exact motion may fit each step of a record that fails.
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
    // With few digits, the errors of such a rule in energy and momentum are below rounding, like others'.
    let base = best.base.spin().or(best.method()).filter(|_| !best.base.is_still());
    let first = base.is_some_and(|base| base.0.info().order == 1);
    // Some rules of first order differ by what they do to these alone.
    let unseen = || {
        let random = BIASED[3] * floor.size * (all.len() as f64).sqrt();
        first && best.alteration.is_none() && changes(subject, all, &best)[0].amax() <= random
    };
    // A rule that keeps a law does not make every step of a record that breaks it.
    let kept = |law: &LawName| best == Rule::EXACT || best.keeps(*law);
    // Rules that keep the laws follow the exact motion's curve at their own rate, and with wrong times at any
    // rate: a number that is not round identifies none.
    let near = NEAR_A_TERM[0].max(FITS_EXACT[0] * floor.size);
    let own = best.alteration.filter(|_| Rule::plain(best.base).keeps(LawName::Separatrix));
    let is_round = |x: f64| rounded(x).is_some_and(|round| (x / round - 1.0).abs() <= near);
    let between = match own {
        Some(Alteration::TermOrTimes(x)) => !is_round(x),
        Some(Alteration::Times(x)) => best.base != Base::Exact && !is_round(x),
        _ => false,
    };
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

/// Compares rules that fit every step between jumps with the sum of these steps.
fn between_jumps(subject: &Subject, own: &[Pair], ranked: &mut Ranked, floor: Floor) -> Confidence {
    ranked.alike.retain(|rule| !is_biased(subject, own, rule, floor));
    match is_biased(subject, own, &ranked.best.rule, floor) {
        true => Confidence::NoneFits,
        false if floor.few && !ranked.alike.is_empty() => Confidence::FewDigits,
        false => Confidence::MostSteps,
    }
}

/// Whether the steps of a rule, each of which fits, change energy or momentum in sum by another amount than
/// the record's: rounding matters less in a sum. Also whether the record keeps what the rule, or the rule
/// without its damping, changes in each step.
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

/// How sure a rule is once the steps are known that are none of its own, and how many steps were searched.
fn without_jumps(
    subject: &Subject,
    [all, pairs]: [&[Pair]; 2],
    confidence: Confidence,
    (ranked, jumps): (&mut Ranked, &mut Vec<Jump>),
    whole: &Whole,
    floor: Floor,
) -> (Confidence, usize) {
    let mut found = confidence;
    if confidence == Confidence::ToRounding {
        found = settled(subject, pairs, ranked, whole, floor);
        if found == Confidence::MostSteps {
            // Those that break a law may not be among the few that are tried.
            *jumps = far_off(subject, all, &ranked.best.rule, floor.limits()[1], JUMP_EVERY[0])
                .unwrap_or_default();
            return (found, all.len());
        }
    } else if confidence == Confidence::MostSteps {
        found = between_jumps(subject, &without(pairs, jumps), ranked, floor);
        jumps.retain(|_| found != Confidence::NoneFits);
    }
    (found, pairs.len())
}

/// Tries every candidate on the sample.
pub(crate) fn diagnose(subject: &Subject, all: &[Pair], known: &Known, whole: &Whole) -> Option<Diagnosis> {
    let floor = known.floor;
    // From attitudes alone, each rule's spin must be solved for in each step: fewer steps are tried.
    let sought = all.iter().any(|pair| pair.to.ahead.is_some());
    let pairs = &*if sought { some(all, TRIED_TURNS) } else { all.to_vec() };
    let found = tried(subject, pairs, known, sought);
    let (mut ranked, mut error) = (Ranked::of(&found, floor)?, None);
    ranked.second = ranked.second.and_then(|second| explained(subject, pairs, second.rule));
    let (mut confidence, mut jumps) = confidence_in(subject, pairs, &ranked, known, whole);
    let of_alteration =
        by_alteration(subject, pairs, &ranked.best).filter(|_| confidence == Confidence::Near);
    let drifts = || drifts_from(subject, pairs, &ranked.best, whole);
    if confidence == Confidence::Near && (of_alteration.is_some() || drifts()) {
        confidence = Confidence::NoneFits;
    }
    let going = &going(pairs);
    if confidence == Confidence::NoneFits && !sought {
        let found = (&found[..], of_alteration);
        (ranked, confidence, error) = unnamed(subject, going, found, ranked, whole, floor);
    }
    if confidence == Confidence::NoneFits {
        jumps = pushes(subject, pairs, &found, floor);
    }
    let shows = confidence == Confidence::NoneFits && jumps.is_empty() && !sought;
    let term = if shows { times_the_term(subject, going) } else { None };
    let steps;
    (confidence, steps) =
        without_jumps(subject, [all, pairs], confidence, (&mut ranked, &mut jumps), whole, floor);
    let Ranked { best, alike, second } = ranked.placed(&found, floor).timed(whole, &mut confidence);
    let turns = pairs.iter().any(|pair| pair.from.attitude.is_some());
    let scatter = !sought && attitudes_scatter(subject, pairs, best.rule.base, floor);
    let header = known.said.engine.as_deref().unwrap_or_default();
    // As the exact motion's, steps are those of any rule with errors below rounding.
    let named = confidence.names_a_rule() && best.rule != Rule::EXACT;
    let own: Vec<_> = engines(header, std::iter::once(&best.rule).chain(&alike));
    let leading = first_named(&best.rule, if named { &alike } else { &[] }, own.first().map(|own| own.0));
    let said = |rule: &Rule| rule.written(!sought).times(subject.unit);
    let all = with_unseen(sought, &said(&best.rule), alike.iter().map(said));
    Some(Diagnosis {
        best: Explanation { rule: said(&best.rule), ..best },
        second: second.map(|x| Explanation { rule: said(&x.rule), ..x }).filter(|x| !all.contains(&x.rule)),
        alike: all,
        confidence,
        steps,
        share: whole.share,
        engines: engine_names(&own, &leading),
        settings: if whole.fails && named { settings(&own, &leading) } else { Vec::new() },
        leading: leading.iter().map(said).collect(),
        error,
        advice: Advice::of(confidence, &best.rule, floor, whole, [!jumps.is_empty(), turns, scatter]),
        term,
        open: alike.iter().any(|rule| is_another(subject, pairs, &best.rule, rule)),
        jumps,
        single: floor.single,
        floor,
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
