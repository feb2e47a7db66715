//! How sure a diagnosis is, in steps that a reader can act on; and what is said of a record that no rule
//! fits.

use crate::read::{Floor, Known, Pair, law, median, unit};
use crate::rule::diagnosis::{Jump, Ranked, Whole, jumps, without};
use crate::rule::tried::explained;
use crate::rule::{Alteration, Base, Explanation, PHYSICS_ENGINES, Rule, Subject, Turn, When};
use crate::thresholds::*;

/// What a program calls each, and how a reader is led to the rule's name.
macro_rules! confidences {
    ($(#[$meta:meta])* enum; $($(#[$doc:meta])* $name:ident: $key:literal, $words:literal;)+) => {
        $(#[$meta])*
        pub enum Confidence {
            $($(#[$doc])* $name,)+
        }

        impl Confidence {
            /// What a program calls it.
            #[must_use]
            pub const fn key(self) -> &'static str {
                self.names()[0]
            }

            pub(crate) const fn names(self) -> [&'static str; 2] {
                match self { $(Self::$name => [$key, $words],)+ }
            }
        }
    };
}

confidences! {
    /// How sure a diagnosis is.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[non_exhaustive]
    enum;
    /// Every step is the rule's to rounding.
    ToRounding: "to rounding", "Every step tried agrees, to the record's rounding, with";
    /// The steps are the rule's to rounding but for a few jumps, or the record breaks a law that the rule
    /// keeps.
    MostSteps: "most steps", "Most steps, but not all, agree to rounding with";
    /// Nearer than any other by far, and not to rounding: such a rule, in some other form.
    Near: "near", "Most like";
    /// The steps are its own to rounding, and so they are of other rules; over the whole record it does not
    /// drift as the record does, or it is one of several that do.
    FewDigits: "too few digits", "Too few digits to name the rule by its single steps. One that fits is";
    /// The steps are its own to rounding, and their errors are hardly above rounding: many a rule has as
    /// small ones.
    SmallErrors: "errors too small", "The errors of the steps are too near to rounding to name the rule. One that fits is";
    /// Too few of the rows follow one another by one step.
    FewSteps: "too few steps", "Too few rows follow one another by one step to name the rule. One that fits those is";
    /// None of the rules known here, and so near to the exact motion that the error of a step is a small
    /// share of what the gyroscopic term does in it ([`error`](crate::Diagnosis::error)).
    Accurate: "accurate", "An accurate rule, none of those known. Nearest is";
    /// None of the rules known here; the exact motion with one number altered, damping or the size of the
    /// gyroscopic term, explains nearly all that is seen.
    Altered: "altered", "None of the known rules fits. What is seen is";
    /// Rows lie on straight lines between others: they are interpolated.
    Interpolated: "interpolated", "The rows are interpolated between the engine's steps, and name no rule";
    /// Rows repeat the row before them, under other times.
    Repeated: "repeated", "Rows repeat the row before them, and name no rule";
    /// Rows scatter about a smooth motion: half precision, or a noisy sensor.
    Scattered: "scattered", "The rows scatter about a smooth motion, and name no rule";
    /// None of the rules known here.
    NoneFits: "none fits", "None of the known rules fits. Nearest is";
}

impl Confidence {
    /// Whether one rule is named, or several that are one here.
    #[must_use]
    pub const fn names_a_rule(self) -> bool {
        matches!(self, Self::ToRounding | Self::MostSteps | Self::Near)
    }
}

/// How sure a diagnosis is: by how near the best rule is to the record, relative to rounding, to the error
/// that it explains, and to the next rule.
pub(super) fn confidence_in(
    subject: &Subject,
    pairs: &[Pair],
    ranked: &Ranked,
    known: &Known,
    whole: &Whole,
) -> (Confidence, Vec<Jump>) {
    let (floor, best) = (known.floor, &ranked.best);
    let ratio = ranked.second.map_or(f64::INFINITY, |second| best.relative_to(&second));
    let is_exact = best.rule == Rule::EXACT;
    // A rule that is not known here may come near to one that is; to its rounding only by chance.
    let [rounding, _] = floor.closely();
    let closely = best.median <= rounding && (!is_exact || best.median <= FITS_EXACT[0] * floor.size);
    let fitted = usize::from(has_fitted_number(&best.rule, known.clock.per_row));
    let most = floor.limits()[1];
    let jumps = if closely { jumps(subject, pairs, &best.rule, most, JUMP_EVERY[0]) } else { None };
    let own = without(pairs, jumps.as_deref().unwrap_or_default());
    let of_own = explained(subject, &own, best.rule).unwrap_or(*best);
    let much = |above: f64| explains_much(subject, &own, &of_own, floor, above);
    let clear = is_exact || much(ERROR_ABOVE[fitted]);
    // An exact spin alone says nothing of what turned the attitude.
    let of_spin = best.rule == Base::Exact.but(Alteration::Turned(Turn::Otherwise));
    let confidence = if whole.repeats {
        Confidence::Repeated
    } else if whole.share < TRIED_SHARE {
        Confidence::FewSteps
    } else if are_interpolated(subject, pairs, floor) {
        Confidence::Interpolated
    } else if of_spin {
        Confidence::NoneFits
    } else if (jumps.is_some() || best.fits(floor)) && !clear {
        return (Confidence::SmallErrors, jumps.unwrap_or_default());
    } else if let Some(jumps) = jumps.filter(|jumps| best.fits(floor) || !jumps.is_empty()) {
        return (if jumps.is_empty() { Confidence::ToRounding } else { Confidence::MostSteps }, jumps);
    } else if best.median < NEAR && !is_exact && ratio >= NEAR_RATIO && much(ERROR_ABOVE[1]) {
        Confidence::Near
    } else {
        Confidence::NoneFits
    };
    (confidence, Vec::new())
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

/// Whether the error that a rule explains (of the exact motion; of the rule without what is altered) is so
/// many times as large as what is left of it and as the rounding. Otherwise it may be near by chance.
fn explains_much(subject: &Subject, pairs: &[Pair], best: &Explanation, floor: Floor, above: f64) -> bool {
    let otherwise = Alteration::Turned(Turn::Otherwise);
    let altered = best.rule.alteration.is_some_and(|alteration| alteration != otherwise);
    let is_far = |error: &Explanation, best: &Explanation, above: f64| {
        // An alteration may act in some of the steps alone.
        (altered || error.median >= above * best.median.max(floor.size))
            && error.percentile_95 >= above * best.percentile_95.max(floor.size)
    };
    let mut without = best.rule.neutral().into_iter().filter_map(|rule| explained(subject, pairs, rule));
    // A turn of its own does not make the spin that of a rule.
    let of_spin = |rule: &Rule| explained(subject, pairs, rule.base.but(otherwise));
    let spins = of_spin(&Rule::EXACT).zip(of_spin(&best.rule));
    without.all(|error| is_far(&error, best, above))
        && (altered || spins.is_none_or(|(error, best)| is_far(&error, &best, SPIN_ABOVE)))
}

/// The exact motion with a number altered, if that explains nearly all of its error; an accurate rule, and
/// the error of its steps; rows that scatter, and by how much; or none.
pub(super) fn unnamed(
    subject: &Subject,
    pairs: &[Pair],
    found: &[Explanation],
    ranked: Ranked,
    fails: bool,
    floor: Floor,
) -> (Ranked, Confidence, Option<f64>) {
    let Some(exact) = found.iter().find(|x| x.rule == Rule::EXACT) else {
        return (ranked, Confidence::NoneFits, None);
    };
    let alone = |best: &Explanation| Ranked { best: *best, alike: Vec::new(), second: Some(*exact) };
    let (altered, times) = altered(subject, pairs, found);
    if let Some(altered) = altered.filter(|x| times > ALTERED[1] && x.median < NEAR) {
        let mut altered = alone(altered);
        // Where in the step of a rule that is not known it is damped, the exact motion does not show.
        if let Some(Alteration::Damped { when, .. }) = &mut altered.best.rule.alteration {
            *when = When::Open;
        }
        return (altered, Confidence::Altered, None);
    }
    let error = accuracy(subject, pairs, exact, floor.size).filter(|_| !fails && times < ALTERED[0]);
    if error.is_some() {
        return (Ranked { second: ranked.second, ..alone(exact) }, Confidence::Accurate, error);
    }
    let off = |x: &Pair| Some((x.to.omega - subject.spin_after(&Rule::EXACT, x)?) / x.to.omega.norm());
    let scatter = scatter(pairs, off).filter(|off| exact.median < OF_SCATTER * off);
    (ranked, if scatter.is_some() { Confidence::Scattered } else { Confidence::NoneFits }, scatter)
}

/// Whether the attitudes scatter about what a rule makes of the rows, by more than the rounding of the digits
/// that are printed: numbers that had fewer before, as those of a matrix may.
pub(super) fn attitudes_scatter(subject: &Subject, pairs: &[Pair], base: Base, floor: Floor) -> bool {
    // In the world, where the next step takes back the very vector.
    let off = |pair: &Pair| {
        let end = subject.next(&Rule::plain(base), &pair.from, pair.h)?;
        Some(unit(&end.attitude?) * Pair { from: end, ..*pair }.turn()?)
    };
    scatter(pairs, off).is_some_and(|off| off > floor.limits()[1])
}

/// By how much rows scatter about a smooth motion, if that is most of what their steps are off by: what one
/// row is off by, the next step takes back, while the errors of a rule go on.
fn scatter(pairs: &[Pair], off: impl Fn(&Pair) -> Option<nalgebra::Vector3<f64>>) -> Option<f64> {
    let both =
        |two: &[Pair]| Some([off(&two[0])?, off(&two[1])?]).filter(|_| two[0].to.line == two[1].from.line);
    let (mut own, mut next, mut count) = (0.0, 0.0, 0.0);
    for [first, second] in pairs.windows(2).filter_map(both) {
        own += (first.norm_squared() + second.norm_squared()) / 2.0;
        next += first.dot(&second);
        count += 1.0;
    }
    // Of noise alone it is half.
    (next < -TAKEN_BACK * own && count >= SCATTERED_ROWS).then(|| (own / (6.0 * count)).sqrt())
}

/// The exact motion with one number altered that explains the record best, and how many times as well as
/// without that number.
fn altered<'a>(
    subject: &Subject,
    pairs: &[Pair],
    found: &'a [Explanation],
) -> (Option<&'a Explanation>, f64) {
    let is_one = |altered| {
        use Alteration::{Damped, Term, TermOrTimes, Times};
        matches!(altered, Some(Damped { .. } | Term(_) | TermOrTimes(_) | Times(_)))
    };
    let one = |x: &&Explanation| x.rule.base == Base::Exact && is_one(x.rule.alteration);
    let times = |x: &Explanation| {
        let without = x.rule.neutral().into_iter().filter_map(|rule| explained(subject, pairs, rule));
        let times = without.map(|y| (y.median / x.median).min(y.percentile_95 / x.percentile_95));
        times.fold(f64::INFINITY, f64::min)
    };
    let best = found.iter().filter(one).max_by(|a, b| times(a).total_cmp(&times(b)));
    (best, best.map_or(0.0, times))
}

/// Whether some of the rows lie on a straight line between those before and after, next to a plain bend: no
/// smooth motion has that.
fn are_interpolated(subject: &Subject, pairs: &[Pair], floor: Floor) -> bool {
    // The attitudes between two others turn about one axis, however the spin changes there.
    let is_between = |[first, second]: [&Pair; 2]| match (first.turn(), second.turn()) {
        (Some(a), Some(b)) if first.to.ahead.is_none() => {
            let (v, w) = (first.to.omega, second.to.omega);
            a.cross(&b).norm() * v.norm() * w.norm() < TURNS_APART * v.cross(&w).norm() * a.norm() * b.norm()
        }
        _ => true,
    };
    let bends = pairs.windows(2).filter(|two| two[0].to.line == two[1].from.line).map(|two| {
        let [first, second] = [two[0], two[1]].map(|pair| pair.to.omega - pair.from.omega);
        let rounding = STRAIGHT[0] * floor.size * two[0].from.omega.norm();
        let bend = (first - second).norm() / rounding;
        let is_seen = first.norm() > CLEAR * rounding && (bend > 1.0 || is_between([&two[0], &two[1]]));
        if is_seen { bend } else { f64::NAN }
    });
    let bends: Vec<f64> = bends.collect();
    let is_knot = |two: &&[f64]| two[0].min(two[1]) <= 1.0 && two[0].max(two[1]) > ABOVE_ROUNDING;
    let many = bends.windows(2).filter(is_knot).count() as f64 > STRAIGHT[1] * bends.len() as f64;
    // The spins of pushes do not go by the law.
    many && law(pairs.iter().copied(), &subject.moments).0 > LAW_AGREES
}

/// The error of the middle step, as a share of what the gyroscopic term changes of the spin in the middle
/// step; of an accurate rule alone. A share of the spin would praise each rule whose steps are short, even
/// where there is no gyroscopic term in them.
fn accuracy(subject: &Subject, pairs: &[Pair], exact: &Explanation, floor: f64) -> Option<f64> {
    let change = median(pairs.iter().filter_map(|pair| {
        let end = subject.spin_after(&Rule::EXACT, pair)?;
        Some((end - pair.from.omega).norm() / pair.from.omega.norm())
    }));
    let share = exact.median / change;
    (change.is_finite() && change > ABOVE_ROUNDING * floor && share <= ACCURATE).then_some(share)
}
