//! Which rule made a record: each candidate takes each row one step further, and is held against the next
//! row.

use crate::law::LawName;
use crate::read::{Floor, Known, Pair, Sample, middle_and_most};
use crate::rule::{
    Advice, Base, Confidence, PHYSICS_ENGINES, Rule, Run, Subject, accuracy, cap_at_start, compound,
    engine_names, engines, first_named, frozen_at, in_parts, momentum_for_spin, of_parts, plain,
};
use crate::thresholds::{
    ALIKE, ALIKE_FEW, ALIKE_ROUNDINGS, AS_EXACT, CLEAR, ERROR_ABOVE, FITS_EXACT, NEAR, NEAR_RATIO,
    TRIED_IN_PARTS, TRIED_SHARE, TRIED_TURNS,
};

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
    fn fits(self, floor: Floor) -> bool {
        let fits = floor.fits(self.median, self.percentile_95);
        let [half, nearly_all] = FITS_EXACT.map(|units| units * floor.size);
        fits && (self.rule != Rule::EXACT || self.median <= half && self.percentile_95 <= nearly_all)
    }

    /// By how much another is farther from the record: in the median, or in the 95th percentile.
    fn relative_to(&self, other: &Self) -> f64 {
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
    /// The spins before and after a first step that slows the body to what no later one exceeds, rad/s.
    pub cap: Option<[f64; 2]>,
    /// Of a record of few digits that breaks a law: how many of the best and those alike, the first of them,
    /// drift as the whole record does.
    pub drifts: Option<usize>,
    /// The rules named first: the best, and with a rule named those that make the same steps here and that an
    /// engine goes by.
    pub leading: Vec<Rule>,
    /// Engines known to go by one of them; where the record names one that goes by a rule that fits, this one
    /// first.
    pub engines: Vec<String>,
    /// Of an accurate rule that is not known the error of a step, as a share of what the gyroscopic term
    /// changes of the spin in it.
    pub error: Option<f64>,
    /// What to do about it.
    pub advice: Advice,
    /// Whether the numbers are of single precision.
    pub single: bool,
    /// Whether they are of fewer digits.
    pub(crate) few: bool,
}

/// What the whole record shows, against which a rule of its single steps is held.
pub(crate) struct Whole {
    /// The run, where its steps are of one length.
    pub run: Option<Run>,
    /// The laws that it breaks.
    pub broken: Vec<LawName>,
    /// Whether flips are missing, or too many.
    pub miscounted: bool,
    /// Whether it fails, whatever its rule.
    pub fails: bool,
    /// Whether all is kept to rounding.
    pub kept: bool,
    /// The share of the pairs of rows that are one step apart.
    pub share: f64,
}

fn explained(subject: &Subject, pairs: &[Pair], rule: Rule) -> Option<Explanation> {
    let residuals = pairs.iter().map(|pair| subject.residual(&rule, pair)).collect();
    middle_and_most(residuals).map(|[median, percentile_95]| Explanation { rule, median, percentile_95 })
}

impl Diagnosis {
    /// Whether the steps are the exact motion's, to the rounding of the record: any rule with smaller errors
    /// would look the same.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.confidence == Confidence::ToRounding && self.best.rule == Rule::EXACT
    }

    /// What would decide between the rules that explain the record alike.
    #[must_use]
    pub fn would_decide(&self) -> Option<&'static str> {
        let open = !self.alike.is_empty() || self.is_exact();
        match self.confidence {
            Confidence::FewSteps => Some("a row at every step"),
            Confidence::SmallErrors => Some("a faster spin, or longer steps"),
            Confidence::NoneFits | Confidence::Accurate => None,
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
struct Ranked {
    best: Explanation,
    alike: Vec<Rule>,
    second: Option<Explanation>,
}

impl Ranked {
    fn of(found: &[Explanation], floor: Floor) -> Option<Self> {
        let least = found.iter().map(|x| x.median).fold(f64::INFINITY, f64::min);
        if !least.is_finite() {
            return None;
        }
        let alike_of = alike_to_best(found, floor);
        let best = *found.iter().find(|x| alike_of(x))?;
        // The same rule with limits that the record does not reach says nothing new.
        let same = |rule: &Rule| {
            *rule == best.rule || rule.method().is_some() && rule.method() == best.rule.method()
        };
        // Where even the best is farther off than its own rounding would put it, whatever fits may be it.
        let [rounding, _] = floor.closely();
        let alike_of = |x: &Explanation| alike_of(x) || least > rounding && x.fits(floor);
        let alike = found.iter().filter(|x| alike_of(x)).map(|x| x.rule).filter(|rule| !same(rule)).collect();
        let others = found.iter().filter(|x| !alike_of(x)).copied();
        let second = others.min_by(|a, b| best.relative_to(a).total_cmp(&best.relative_to(b)));
        Some(Self { best, alike, second })
    }

    /// With those rules first that drift over the whole record as the record does, how sure that is, and how
    /// many these are.
    fn by_drift(self, subject: &Subject, sample: &Sample, run: &Run) -> (Self, Confidence, Option<usize>) {
        let all = std::iter::once(self.best.rule).chain(self.alike);
        let (mut ordered, unlike): (Vec<Rule>, Vec<Rule>) = all.partition(|rule| run.is_like(subject, rule));
        let count = ordered.len();
        let sure = unlike.is_empty() && ordered.first() == Some(&self.best.rule);
        ordered.extend(unlike);
        let best = explained(subject, sample.pairs(), ordered.remove(0)).unwrap_or(self.best);
        let confidence = if sure { Confidence::ToRounding } else { Confidence::FewDigits };
        (Self { best, alike: ordered, ..self }, confidence, Some(count))
    }
}

impl Whole {
    /// The run, where a record of few digits breaks a law: of such digits a wrong rule may fit each step, and
    /// what the whole record does is held against it too.
    fn run_astray(&self, floor: Floor) -> Option<&Run> {
        self.run.as_ref().filter(|_| floor.few && (self.miscounted || !self.broken.is_empty()))
    }
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
    let every = if sought { sample.pairs().len().div_ceil(TRIED_TURNS).max(1) } else { 1 };
    let pairs: Vec<Pair> = sample.pairs().iter().step_by(every).copied().collect();
    let pairs = pairs.as_slice();
    let found = tried(subject, pairs, known, sought);
    let mut ranked = Ranked::of(&found, floor)?;
    let mut confidence = confidence_in(&ranked, &found, known, whole.share);
    let mut error = None;
    if confidence == Confidence::NoneFits
        && let Some(exact) = found.iter().find(|x| x.rule == Rule::EXACT)
        && !whole.fails
        && !sought
    {
        error = accuracy(subject, pairs, exact, floor.size);
        if error.is_some() {
            ranked = Ranked { best: *exact, alike: Vec::new(), ..ranked };
            confidence = Confidence::Accurate;
        }
    }
    let mut drifts = None;
    if confidence == Confidence::ToRounding
        && let Some(run) = whole.run_astray(floor)
    {
        (ranked, confidence, drifts) = ranked.by_drift(subject, sample, run);
    }
    // A rule that keeps a law does not make every step of a record that breaks it.
    if confidence == Confidence::ToRounding && whole.broken.iter().any(|law| ranked.best.rule.keeps(*law)) {
        confidence = Confidence::MostSteps;
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
        cap: cap_at_start(pairs),
        drifts,
        engines: engine_names(&own, &leading),
        leading: leading.iter().map(|rule| rule.times(subject.unit)).collect(),
        error,
        advice: Advice::of(confidence, &best.rule, floor.single, whole.kept, whole.fails),
        single: floor.single,
        few: floor.few,
    })
}

/// Whether a rule is within rounding of the best, in the median as in the 95th percentile.
fn alike_to_best(found: &[Explanation], floor: Floor) -> impl Fn(&Explanation) -> bool + use<> {
    let least = found.iter().map(|x| x.median).fold(f64::INFINITY, f64::min);
    let [half, nearly_all] = floor.either(ALIKE_ROUNDINGS, ALIKE_FEW).map(|units| units * floor.size);
    let near = move |x: &Explanation| x.median <= (ALIKE[0] * least).max(half);
    let best_most = found.iter().filter(|x| near(x)).map(|x| x.percentile_95).fold(f64::INFINITY, f64::min);
    move |x| near(x) && x.percentile_95 <= (ALIKE[1] * best_most).max(nearly_all)
}

/// How far each candidate's steps are from the record's: plain rules first, and others while none fits.
fn tried(subject: &Subject, pairs: &[Pair], known: &Known, sought: bool) -> Vec<Explanation> {
    let (floor, per_row) = (known.floor, known.clock.per_row);
    let explained = |rule: Rule| explained(subject, pairs, rule);
    let fits = |found: &[Explanation]| found.iter().any(|x| x.fits(floor));
    let free = subject.torque.is_none();
    let mut found: Vec<Explanation> = plain(free, pairs).into_iter().filter_map(explained).collect();
    if free && (known.said.kind.is_momentum() || !fits(&found)) {
        found.extend(momentum_for_spin(subject, pairs).and_then(explained));
    }
    let rules = match in_the_clear(&found, floor) {
        _ if !free => Vec::new(),
        None => in_parts(per_row, !sought),
        // Other rules may make equal steps.
        Some(parts) => of_parts(parts),
    };
    if !rules.is_empty() {
        let mut in_parts = tried_in_parts(subject, pairs, rules, floor);
        // Those of the number that the header names go before the same rules in one part.
        if per_row.is_some_and(|parts| parts > 1) {
            std::mem::swap(&mut found, &mut in_parts);
        }
        found.extend(in_parts);
    }
    if free && !fits(&found) {
        found.extend(frozen_at(pairs).into_iter().filter_map(explained));
    }
    if free && !fits(&found) {
        found.extend(compound(subject, pairs, floor.size).into_iter().filter_map(explained));
    }
    found
}

/// In how many parts the best rule found makes its steps, if no rule in another number of parts can come as
/// near: the steps are exact to rounding, or they are a rule's own and its error is plain.
fn in_the_clear(found: &[Explanation], floor: Floor) -> Option<u32> {
    let Some(exact) = found.iter().find(|x| x.rule == Rule::EXACT) else { return Some(1) };
    if alike_to_best(found, floor)(exact) && exact.fits(floor) {
        return Some(1);
    }
    let fits = found.iter().filter(|x| x.fits(floor) && x.rule != Rule::EXACT);
    let best = fits.min_by(|a, b| a.median.total_cmp(&b.median))?;
    (exact.median > CLEAR * best.median.max(floor.size)).then_some(best.rule.base.parts())
}

/// The rules in parts that a few of the pairs do not rule out.
fn tried_in_parts(subject: &Subject, pairs: &[Pair], rules: Vec<Rule>, floor: Floor) -> Vec<Explanation> {
    let [first, more] = TRIED_IN_PARTS.map(|count| -> Vec<Pair> {
        pairs.iter().step_by(pairs.len().div_ceil(count).max(1)).copied().collect()
    });
    let [half, nearly_all] = floor.limits();
    // The first of them, and the same with the exact motion's end.
    let measure = first.first().and_then(|pair| {
        let to = subject.next(&Rule::EXACT, &pair.from, pair.h)?;
        Some((subject.residual(&Rule::EXACT, pair), Pair { to, ..*pair }))
    });
    let mut as_exact: Vec<(Base, u32)> = Vec::new();
    let mut possible = |rule: &Rule| {
        let (mut far, mut off) = (0, 0);
        if let Some((error, exact)) = &measure {
            let (base, parts) = (rule.base.in_parts(1), rule.base.parts());
            if as_exact.iter().any(|(other, least)| *other == base && parts > *least) {
                return false;
            }
            // Its own error is far below the record's: in more parts it comes no nearer.
            if *error > nearly_all && subject.residual(rule, exact) < AS_EXACT * error {
                as_exact.push((base, parts));
                return false;
            }
        }
        first.iter().all(|pair| {
            let residual = subject.residual(rule, pair);
            far += u32::from(residual > nearly_all);
            off += usize::from(residual > half);
            far < 2 && 2 * off <= first.len() + 1
        })
    };
    rules
        .into_iter()
        .filter(|rule| possible(rule))
        .filter_map(|rule| explained(subject, &more, rule))
        .collect()
}

/// How sure a diagnosis is: by how near the best rule is to the record, relative to rounding, to the error
/// that it explains, and to the next rule.
fn confidence_in(ranked: &Ranked, found: &[Explanation], known: &Known, share: f64) -> Confidence {
    let (floor, best) = (known.floor, &ranked.best);
    let ratio = ranked.second.map_or(f64::INFINITY, |second| best.relative_to(&second));
    let is_exact = best.rule == Rule::EXACT;
    // A rule that is not known here may come near to one that is; to its rounding only by chance.
    let [rounding, _] = floor.closely();
    let closely = best.median <= rounding && (!is_exact || best.median <= FITS_EXACT[0] * floor.size);
    let fitted = usize::from(has_fitted_number(&best.rule, known.clock.per_row));
    let clear = is_exact || explains_much(best, found, floor, ERROR_ABOVE[fitted]);
    if share < TRIED_SHARE {
        Confidence::FewSteps
    } else if (closely || best.fits(floor)) && !clear {
        Confidence::SmallErrors
    } else if closely && best.fits(floor) {
        Confidence::ToRounding
    } else if closely {
        Confidence::MostSteps
    } else if best.median < NEAR && !is_exact && clear && ratio >= NEAR_RATIO[fitted] {
        Confidence::Near
    } else {
        Confidence::NoneFits
    }
}

/// Whether a number of the rule is fitted to the record: that of an alteration, or a number of parts that
/// neither the header nor an engine's rule names.
fn has_fitted_number(rule: &Rule, per_row: Option<u32>) -> bool {
    let parts = rule.base.parts();
    let of_an_engine = rule
        .method()
        .is_some_and(|rule| PHYSICS_ENGINES.iter().any(|engine| (engine.method, engine.parts) == rule));
    rule.alteration.is_some() || parts > 1 && per_row != Some(parts) && !of_an_engine
}

/// Whether the error that a rule explains (of the exact motion; of the rule without its alteration) is so
/// many times as large as what is left of it and as the rounding. Otherwise it may be near by chance.
fn explains_much(best: &Explanation, found: &[Explanation], floor: Floor, above: f64) -> bool {
    let altered = best.rule.alteration.is_some();
    let without = if altered { Rule::plain(best.rule.base) } else { Rule::EXACT };
    let Some(error) = found.iter().find(|x| x.rule == without) else { return true };
    // An alteration may act in some of the steps alone.
    (altered || error.median >= above * best.median.max(floor.size))
        && error.percentile_95 >= above * best.percentile_95.max(floor.size)
}
