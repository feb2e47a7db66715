//! How certain a diagnosis is, in grades that a reader can act on.

use crate::read::{Floor, Known, Pair};
use crate::rule::diagnosis::{Ranked, Whole};
use crate::rule::jumps::{Jump, far_off, without};
use crate::rule::tried::explained;
use crate::rule::unnamed::are_interpolated;
use crate::rule::{Alteration, Base, Explanation, Rule, Subject, Turn};
use crate::thresholds::*;
use tumbling_engines::PHYSICS_ENGINES;

/// The key of each for programs, and the words before the rule's name for readers.
macro_rules! confidences {
    ($(#[$meta:meta])* enum; $($(#[$doc:meta])* $name:ident: $key:literal, $words:literal;)+) => {
        $(#[$meta])*
        pub enum Confidence {
            $($(#[$doc])* $name,)+
        }

        impl Confidence {
            /// The key for programs.
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
    /// How certain a diagnosis is.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[non_exhaustive]
    enum;
    /// Every step agrees with the rule to rounding.
    ToRounding: "to rounding", "Every step tried agrees, to the record's rounding, with";
    /// The steps agree with the rule to rounding except for a few jumps, or the record breaks a law that the
    /// rule keeps.
    MostSteps: "most steps", "Most steps, but not all, agree to rounding with";
    /// By far the nearest rule, but not to rounding: probably a variant of it.
    Near: "near", "No known rule fits to rounding. The closest by far is";
    /// The steps agree with it to rounding, but also with other rules; over the whole record it does not
    /// drift as the record does, or several rules do.
    FewDigits: "too few digits", "Too few digits to identify the rule by its single steps. One of those that fit is";
    /// The steps agree with it to rounding, but their errors, or the differences from other rules, are hardly
    /// above rounding: many rules have errors as small.
    SmallErrors: "errors too small", "The errors of the steps, or the differences between rules, are too close to rounding to identify the rule. One of those that fit is";
    /// Too few of the rows are one step apart.
    FewSteps: "too few steps", "Too few rows are one step apart to identify the rule. One of those that fit is";
    /// None of the known rules, but so near to the exact motion that the error of a step is a small share of
    /// the change of spin by the gyroscopic term in it ([`error`](crate::Diagnosis::error)).
    Accurate: "accurate", "An accurate rule, but none of the known ones. Nearest is";
    /// None of the known rules; the exact motion with one number altered (damping, or the size of the
    /// gyroscopic term) explains nearly all of the error.
    Altered: "altered", "None of the known rules fits. The best description is";
    /// Rows lie on straight lines between their neighbours: interpolated, or a term is not updated each step.
    Interpolated: "interpolated", "Some rows lie on straight lines between their neighbours (interpolated rows, or a term that is not updated in each step), so no rule can be identified";
    /// Rows repeat the row before them at later times.
    Repeated: "repeated", "Rows repeat the row before them, so no rule can be identified";
    /// Rows scatter about a smooth motion: half precision, or a noisy sensor.
    Scattered: "scattered", "The rows scatter about a smooth motion, so no rule can be identified";
    /// None of the known rules.
    NoneFits: "none fits", "None of the known rules fits. Nearest is";
}

impl Confidence {
    /// Whether it names one rule, or several with the same steps in this record.
    #[must_use]
    pub const fn names_a_rule(self) -> bool {
        matches!(self, Self::ToRounding | Self::MostSteps | Self::Near)
    }
}

/// How certain a diagnosis is: compares the best rule's distance from the record with rounding, with the
/// error that it explains, and with the next rule's distance.
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
    // An unknown rule may come near to a known one, but to rounding only by chance.
    let [rounding, _] = floor.closely();
    let closely = best.median <= rounding && (!is_exact || best.median <= FITS_EXACT[0] * floor.size);
    let fitted = usize::from(has_fitted_number(&best.rule, known.clock.per_row));
    let most = floor.limits()[1];
    let jumps = if closely { far_off(subject, pairs, &best.rule, most, JUMP_EVERY[0]) } else { None };
    let own = without(pairs, jumps.as_deref().unwrap_or_default());
    let of_own = explained(subject, &own, best.rule).unwrap_or(*best);
    let much = |above: f64| explains_much(subject, &own, &of_own, floor, above);
    let clear = is_exact || much(ERROR_ABOVE[fitted]);
    // An exact spin alone does not determine how the attitude turns.
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

/// Whether a number of the rule is fitted to the record: that of an alteration, or a number of parts that is
/// neither in the header nor in an engine's rule.
fn has_fitted_number(rule: &Rule, per_row: Option<u32>) -> bool {
    let parts = rule.base.parts();
    let is_engine = |rule| PHYSICS_ENGINES.iter().any(|engine| (engine.method, engine.parts) == rule);
    let of_an_engine = rule.method().is_some_and(is_engine);
    rule.alteration.is_some() || parts > 1 && per_row != Some(parts) && !of_an_engine
}

/// Whether the error that a rule explains (that of the exact motion, or of the unaltered rule) is at least
/// `above` times the remaining error and the rounding. Otherwise the rule may be near by chance.
fn explains_much(subject: &Subject, pairs: &[Pair], best: &Explanation, floor: Floor, above: f64) -> bool {
    let otherwise = Alteration::Turned(Turn::Otherwise);
    let altered = best.rule.alteration.is_some_and(|alteration| alteration != otherwise);
    let is_far = |error: &Explanation, best: &Explanation, above: f64| {
        // An alteration may act in only some of the steps.
        (altered || error.median >= above * best.median.max(floor.size))
            && error.percentile_95 >= above * best.percentile_95.max(floor.size)
    };
    let mut without = best.rule.neutral().into_iter().filter_map(|rule| explained(subject, pairs, rule));
    // Another turn of the attitude is no evidence that the spin follows the rule.
    let of_spin = |rule: &Rule| explained(subject, pairs, rule.base.but(otherwise));
    let spins = of_spin(&Rule::EXACT).zip(of_spin(&best.rule));
    without.all(|error| is_far(&error, best, above))
        && (altered || spins.is_none_or(|(error, best)| is_far(&error, &best, SPIN_ABOVE)))
}
