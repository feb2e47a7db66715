//! What to do about the rule that was found, and the chapter that explains it.

use crate::read::Floor;
use crate::rule::{Alteration, Base, Confidence, Rule, Turn, Whole};
use tumbling::step::Method;

/// What a rule means for a body, and what to do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Advice {
    /// One or two sentences.
    pub words: &'static str,
    /// The chapter of the book that explains it, and the part of that chapter.
    pub chapter: Option<&'static str>,
}

const PITFALL_FLIPS: &str = "\"Three pitfalls\", the engine that refuses to flip";
const PITFALL_TENSOR: &str = "\"Three pitfalls\", the tensor that never turned";
const PITFALL_MOMENTUM: &str = "\"Three pitfalls\", momentum taken for spin";
const REMEDY: &str = "\"Test your engine\", a step that keeps the laws";
const STAGE: &str = "\"Put it into your engine\"";
const AXES: &str = "\"Principal axes\"";
const STEPS: &str = "\"Stepping through time\"";

/// Each advice with its name, its words and its chapter.
macro_rules! advices {
    ($($name:ident: $words:literal $(in $chapter:ident)?;)+) => {
        impl Advice {
            $(pub(crate) const $name: Self = Self { words: $words, chapter: advices!(@ $($chapter)?) };)+
        }
    };
    (@) => { None };
    (@ $chapter:ident) => { Some($chapter) };
}

advices! {
    SINGLE: "Each step is right to the rounding of single precision; over many steps these rounding errors add up. For longer \
         runs or stricter limits, store attitude and momentum in double precision.";
    LONGER: "Record a longer run, and judge it again.";
    NOTHING: "Nothing to do: the steps are exact to the record's rounding.";
    COMPARE: "Compare the engine's rule with the known ones." in STEPS;
    DRIFTS_ON: "Its errors shrink with its step or its tolerance; a drift in the table will continue." in STEPS;
    EACH_STEP: "Write one row after each of the engine's steps, once, and no rows in between, and judge it again.";
    RESAMPLED: "If the rows are resampled, write the engine's own rows; if not, find what acts in only some of its steps.";
    ALL_DIGITS: "Write the engine's own numbers, with all their digits.";
    TAKEN_BACK: "The attitude is off in one step and back in the next: it has fewer significant digits than are printed, or \
         noise. Write it with all the engine's digits, and judge it again.";
    FASTER: "Errors so close to rounding, or to the errors of other rules, fit many rules: record a faster spin, or longer steps, and judge it again.";
    MORE_DIGITS: "Write the record with all digits (17 of double precision, 9 of single), and judge it again.";
    TIMES_DIGITS: "The times have too few digits to determine the step: write all their digits, or give the step, as in \
         `# dt: 1/60`, and judge it again.";
    JUMPS: "Something acts on the body at the jumps: turn off contacts, pushes and resets, or find what happens there.";
    OTHERS: "Most steps follow this rule: find what acts in the others (a limit, damping, a contact or a push).";
    ADDS_UP: "Each step is right to the record's rounding, but over the whole record the laws listed here are broken: \
         errors below that rounding add up. Record all digits, or longer steps, and judge it again.";
    NAMED_HERE: "The steps are exact to the record's rounding: what fails is listed under Why.";
    NOT_THE_RULE: "The rule is sound; what fails is listed under Why.";
    OTHER_BODY: "The engine uses other moments of inertia, or other axes, than the record says: look for axes in a wrong \
         order, a principal frame that is ignored, or a shape that replaces the moments set. A free motion determines \
         only the ratios of the moments." in AXES;
    DAMPING: "Damping reduces the spin in each step: set the engine's angular damping to 0." in STEPS;
    TERM: "The gyroscopic term is not that of the body: use w' = J ((I w) x w) in body axes, with J the inverse of the \
         tensor I, once per step and with the factors in this order (with a position stage, turn off the engine's own \
         term)." in PITFALL_FLIPS;
    TIMES: "The times do not match the steps: look for missing rows, a step taken more than once, or another step than \
         the one given.";
    TURNS: "The turn of the attitude does not match the spin: check the times, missing rows and the unit of the spin, and \
         whether the body is turned once in each step.";
    TERM_OR_TIMES: "Spins alone do not distinguish a wrong gyroscopic term from wrong times. Check the step and look for missing rows, \
         or record the attitude too; if the times are right, the term is wrong: use w' = J ((I w) x w)." in PITFALL_FLIPS;
    TURN_FIRST: "The attitude does not turn by the spin: first correct how the attitude turns, and judge again.";
    SIDE: "The rotation of a step multiplies the attitude on the wrong side: with q from body to world, use q * dq if dq is \
         made from a spin in body axes, and dq * q if it is made from a spin in world axes.";
    OWN_TURN: "The turn of the attitude does not match the spin: take both attitude and spin at the end of the step from this rule, \
         after everything that changes the spin, and remove the engine's own update of the attitude." in STAGE;
    ONE_INSTANT: "The spin and the attitude of a row belong to different times: turn by the new spin, and write both after the step.";
    TURNED_OTHERWISE: "The spin follows this rule, but the attitude does not: check how the spin turns the body, and \
         the columns of the attitude.";
    CAP: "The spin is cut off at a limit: raise the engine's maximum angular velocity.";
    LIMITS: "The body is too fast for the engine's limits, which slow it or turn it too little: use shorter steps, or \
         raise the limits." in STEPS;
    FROZEN: "The spin is stepped in world axes with the tensor that the body had at the start: rotate the tensor with \
         the body, R I R^T, at each step." in PITFALL_TENSOR;
    MOMENTUM: "The momentum turns the body as if it were the spin: compute the spin from it with the inverse tensor rotated \
         to the world, w = R J R^T L." in PITFALL_MOMENTUM;
    STRAIGHT: "The gyroscopic term is evaluated at the start of the step, which adds energy to a body that wobbles; and the \
         linear update turns the body by too little. Rotate the momentum instead (three exact turns a step), \
         and turn the body by the exact rotation of its spin, (cos a/2, sin a/2 times the axis)." in REMEDY;
    KEEPS_ALL: "Its phase has an error, which shrinks with the step; energy and momentum have those of rounding alone." in STEPS;
    KEEPS_SIZES: "The momentum's direction in the world and the phase have errors, which shrink with the step; the energy and \
         the momentum's length have those of rounding alone." in STEPS;
    KEEPS_MOMENTUM: "Energy and phase have errors, which shrink with the step; the momentum has those of rounding alone." in STEPS;
    OF_ORDER: "Its errors add up: use shorter steps, or for long runs a method that keeps the laws." in STEPS;
    NO_TERM: "There is no gyroscopic term: a body never flips, and its momentum is not conserved unless it spins about a principal \
         axis. (An engine that takes the momentum for the spin shows the same spin in body axes.) Rotate the momentum in the body instead \
         (three exact turns a step). An engine's flag for gyroscopic forces makes it flip, but may lose a stable spin: record that." in PITFALL_FLIPS;
    EXPLICIT: "The gyroscopic term is evaluated at the start of the step, which adds energy to a body that wobbles. Rotate \
         the momentum instead (three exact turns a step)." in REMEDY;
    RESCALED: "After each explicit step the momentum's length is set back to its old value, but the energy is not: a stable spin that \
         wobbles drifts toward the separatrix, and flips. Rotate the momentum instead (three exact turns a step)." in REMEDY;
    ONE_IMPLICIT: "One implicit step takes energy and momentum from most bodies that tumble; if it turns the body by a radian or \
         more, it can multiply the energy. Use three exact turns a step." in REMEDY;
    MEAN_SPIN: "The spin is of order 4, the attitude of order 2: the momentum of a body that wobbles drifts in the world. \
         Correct the stages' spins for the rotation since the start of the step." in STEPS;
    EULER: "Spin and attitude are both stepped by explicit Euler, and a body that wobbles gains energy: use three exact turns a step." in STEPS;
}

impl Advice {
    /// The advice for the rule that fits best; `floor` is the record's rounding. `jumps` says whether some
    /// steps do not follow the rule, `turns` whether the record has attitudes, `scatter` whether these
    /// scatter by more than their printed digits allow.
    pub(crate) fn of(
        confidence: Confidence,
        rule: &Rule,
        floor: Floor,
        whole: &Whole,
        [jumps, turns, scatter]: [bool; 3],
    ) -> Vec<Self> {
        let is_accurate = *rule == Rule::EXACT || rule.method().is_some_and(|rule| rule.0.info().order > 3);
        let one = match confidence {
            Confidence::NoneFits | Confidence::SmallErrors if jumps => Self::JUMPS,
            Confidence::NoneFits | Confidence::Altered if whole.on_wrong_side => Self::SIDE,
            Confidence::NoneFits | Confidence::Accurate if scatter => Self::TAKEN_BACK,
            Confidence::Interpolated => Self::RESAMPLED,
            Confidence::Scattered | Confidence::NoneFits if whole.of_few_times => Self::TIMES_DIGITS,
            Confidence::NoneFits if !floor.few => Self::COMPARE,
            Confidence::Accurate => Self::DRIFTS_ON,
            Confidence::Repeated | Confidence::FewSteps => Self::EACH_STEP,
            Confidence::Scattered => Self::ALL_DIGITS,
            Confidence::SmallErrors if matches!(rule.alteration, Some(Alteration::TermOrTimes(_))) => {
                Self::of_rule(rule, turns)
            }
            Confidence::SmallErrors | Confidence::FewDigits if whole.of_few_times => Self::TIMES_DIGITS,
            Confidence::SmallErrors => Self::FASTER,
            Confidence::FewDigits if floor.single && is_accurate => Self::SINGLE,
            Confidence::FewDigits if floor.single => Self::FASTER,
            Confidence::FewDigits | Confidence::NoneFits => Self::MORE_DIGITS,
            Confidence::MostSteps if jumps => Self::JUMPS,
            Confidence::MostSteps => Self::OTHERS,
            Confidence::ToRounding | Confidence::Near | Confidence::Altered => {
                match Self::of_rule(rule, turns) {
                    Self::TURNED_OTHERWISE if scatter => Self::TAKEN_BACK,
                    Self::NOTHING if floor.single => Self::SINGLE,
                    Self::NOTHING if whole.again => Self::EACH_STEP,
                    Self::NOTHING if !whole.kept && !whole.fails_otherwise => Self::ADDS_UP,
                    Self::NOTHING if whole.fails => Self::NAMED_HERE,
                    other => other,
                }
            }
        };
        let fine = [Self::NOTHING, Self::KEEPS_ALL, Self::KEEPS_SIZES, Self::KEEPS_MOMENTUM, Self::OF_ORDER];
        // The base of an altered rule may have a fault too, and so may the rule between jumps.
        let term = matches!(rule.alteration, Some(Alteration::Damped { term, .. }) if term != 1.0);
        let term = (term && one == Self::DAMPING).then_some(Self::TERM);
        let more = (confidence.names_a_rule() && (jumps || rule.alteration.is_some()))
            .then(|| Self::of_rule(&if jumps { *rule } else { Rule::plain(rule.base) }, turns))
            .filter(|more| !fine.contains(more));
        // A rule of the spin alone does not determine how the attitude turns.
        let side = (whole.on_wrong_side && one != Self::SIDE && rule.is_of_spin()).then_some(Self::SIDE);
        let is_right = rule.alteration.is_none() && !rule.is_wrong() && *rule != Rule::EXACT;
        let is_sound = confidence.names_a_rule() && !jumps && is_right || confidence == Confidence::Accurate;
        let other = (whole.fails_otherwise && is_sound).then_some(Self::NOT_THE_RULE);
        let again = Some(Self::EACH_STEP).filter(|x| whole.again && confidence.names_a_rule() && one != *x);
        [other, Some(one), term, again, side, more].into_iter().flatten().collect()
    }

    /// The advice for a rule that all steps follow.
    const fn of_rule(rule: &Rule, turns: bool) -> Self {
        match (&rule.alteration, &rule.base) {
            (Some(Alteration::OtherMoments(..)), _) => Self::OTHER_BODY,
            (Some(Alteration::Damped { .. }), _) => Self::DAMPING,
            (Some(Alteration::Term(_)), _) => Self::TERM,
            (Some(Alteration::Times(_)), base) if base.is_still() => Self::TURNS,
            (Some(Alteration::Times(_)), _) => Self::TIMES,
            (Some(Alteration::TermOrTimes(_)), _) if turns => Self::TURN_FIRST,
            (Some(Alteration::TermOrTimes(_)), _) => Self::TERM_OR_TIMES,
            (Some(Alteration::Turned(Turn::BodyInWorld | Turn::WorldInBody)), _) => Self::SIDE,
            (Some(Alteration::Turned(Turn::TwiceBefore | Turn::TwiceAfter | Turn::Own)), _) => Self::OWN_TURN,
            (Some(Alteration::Turned(Turn::Old | Turn::Late | Turn::Early)), _) => Self::ONE_INSTANT,
            (Some(Alteration::Turned(Turn::Otherwise)), _) => Self::TURNED_OTHERWISE,
            (Some(Alteration::Capped(_)), _) => Self::CAP,
            (None, Base::Exact) => Self::NOTHING,
            (None, Base::Engine(engine)) if engine.limits.rate.is_none() => Self::LIMITS,
            (None, Base::Method(method, _)) => Self::of_method(*method),
            (None, Base::Engine(engine)) => Self::of_method(engine.method),
            (None, Base::PositionStage(_)) => Self::KEEPS_ALL,
            (None, Base::FrozenTensor(..)) => Self::FROZEN,
            (None, Base::MomentumForSpin(_)) => Self::MOMENTUM,
            (None, Base::Straight(Method::ConstantSpin, _)) => Self::of_method(Method::ConstantSpin),
            (None, Base::Straight(..)) => Self::STRAIGHT,
        }
    }

    const fn of_method(method: Method) -> Self {
        let kept = method.info();
        match method {
            Method::ConstantSpin => Self::NO_TERM,
            Method::SemiImplicitEuler => Self::EXPLICIT,
            Method::Rescaled | Method::RescaledLinearAttitude => Self::RESCALED,
            Method::ImplicitOneNewton | Method::LinearisedImplicit => Self::ONE_IMPLICIT,
            Method::MeanSpinRungeKutta4 => Self::MEAN_SPIN,
            Method::ExplicitEuler => Self::EULER,
            _ if !kept.reversible => Self::OF_ORDER,
            _ if !kept.energy => Self::KEEPS_MOMENTUM,
            _ if !kept.direction => Self::KEEPS_SIZES,
            _ => Self::KEEPS_ALL,
        }
    }
}
