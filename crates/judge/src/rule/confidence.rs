//! How sure a diagnosis is, in steps that a reader can act on.

use crate::read::{Floor, Known, Pair};
use crate::rule::diagnosis::{Ranked, Whole};
use crate::rule::jumps::{Jump, jumps, without};
use crate::rule::tried::explained;
use crate::rule::unnamed::are_interpolated;
use crate::rule::{Alteration, Base, Explanation, PHYSICS_ENGINES, Rule, Subject, Turn};
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
    /// The steps are its own to rounding, and their errors, or what sets it apart from other rules in them,
    /// are hardly above rounding: many a rule has as small ones.
    SmallErrors: "errors too small", "The errors of the steps, or what sets rules apart in them, are too near to rounding to name the rule. One that fits is";
    /// Too few of the rows follow one another by one step.
    FewSteps: "too few steps", "Too few rows follow one another by one step to name the rule. One that fits those is";
    /// None of the rules known here, and so near to the exact motion that the error of a step is a small
    /// share of what the gyroscopic term does in it ([`error`](crate::Diagnosis::error)).
    Accurate: "accurate", "An accurate rule, none of those known. Nearest is";
    /// None of the rules known here; the exact motion with one number altered, damping or the size of the
    /// gyroscopic term, explains nearly all that is seen.
    Altered: "altered", "None of the known rules fits. What is seen is";
    /// Rows lie on straight lines between others: they are interpolated, or a term is not renewed each time.
    Interpolated: "interpolated", "Rows lie on straight lines between others, as interpolated ones do (or those of a term that is not renewed in each step), and name no rule";
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
    let is_engine = |rule| PHYSICS_ENGINES.iter().any(|engine| (engine.method, engine.parts) == rule);
    let of_an_engine = rule.method().is_some_and(is_engine);
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
