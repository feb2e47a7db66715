//! What to do about a rule that is found, and where the book says more.

use crate::read::Floor;
use crate::rule::{Alteration, Base, Confidence, Rule, Turn, Whole};
use tumbling::step::Method;

/// What a rule means for a body, and what to do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Advice {
    /// In a sentence or two.
    pub words: &'static str,
    /// The chapter of the book that says more, and the place in it.
    pub chapter: Option<&'static str>,
}

const PITFALL_FLIPS: &str = "\"Three pitfalls\", the engine that refuses to flip";
const PITFALL_TENSOR: &str = "\"Three pitfalls\", the tensor that never turned";
const PITFALL_MOMENTUM: &str = "\"Three pitfalls\", momentum taken for spin";
const REMEDY: &str = "\"Test your engine\", a step that keeps the laws";
const STAGE: &str = "\"Put it into your engine\"";
const AXES: &str = "\"Principal axes\"";
const STEPS: &str = "\"Stepping through time\"";

/// What to do, a name each; and the chapter.
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
    SINGLE: "Each step is right to the rounding of single precision; over many steps that rounding adds up. For longer runs \
         or for stricter limits carry attitude and momentum in double precision.";
    LONGER: "Record a longer run, and judge it again.";
    NOTHING: "Nothing to do: to the record's rounding the steps are the motion itself.";
    COMPARE: "Compare the engine's rule with the known ones." in STEPS;
    DRIFTS_ON: "Its errors fall with its step or its tolerance; what drifts in the table goes on drifting." in STEPS;
    EACH_STEP: "Write a row at each of the engine's steps, once, and none in between, and judge it again.";
    RESAMPLED: "If the rows are resampled, write the engine's own; if not, find what acts in some of its steps.";
    ALL_DIGITS: "Write the engine's own numbers, with all their digits.";
    TAKEN_BACK: "The attitude is off in one step and back in the next: it has fewer digits than are printed, or noise. Write \
         it with all the engine's digits, and judge it again.";
    FASTER: "Errors so close to rounding, or to those of other rules, fit many rules: record a faster spin, or longer steps, and judge it again.";
    MORE_DIGITS: "Write the record with all digits (17 of double precision, 9 of single), and judge it again.";
    TIMES_DIGITS: "The times have few digits, and leave the step open: write all their digits, or name the step, as in \
         `# dt: 1/60`, and judge it again.";
    JUMPS: "Something acts on the body at the jumps: turn off contacts, pushes and resets, or look at what happens there.";
    OTHERS: "Most steps are this rule's: find what acts in the others, a limit, damping, a contact or a push.";
    ADDS_UP: "Each step is right to the record's rounding, and over the whole record the laws named here are not kept: \
         errors below that rounding add up. Record all digits, or longer steps, and judge it again.";
    NAMED_HERE: "To the record's rounding the steps are the motion itself: what fails is listed under Why.";
    NOT_THE_RULE: "The rule is sound; what fails is listed under Why.";
    OTHER_BODY: "The engine steps a body with other moments, or about other axes, than the record says: look for a wrong \
         order of axes, a principal frame that is left out, or a shape that replaces the moments set. A free body shows \
         their ratios, never their common scale." in AXES;
    DAMPING: "Damping takes spin in each step: set the engine's angular damping to 0." in STEPS;
    TERM: "The gyroscopic term is not that of the body: write w' = J ((I w) x w) in body axes, with J the inverse of the \
         tensor I, once and with this order of the product (with a position stage the engine's own term is \
         off)." in PITFALL_FLIPS;
    TIMES: "The times are not those of the steps: look for rows left out, a step taken more than once, or another step than \
         the one named.";
    TURNS: "The turn does not belong to the spin: look at the times and at rows left out, at the unit of the spin, and \
         whether the body is turned once in each step.";
    TERM_OR_TIMES: "Spins alone do not tell a wrong term from wrong times. Look at the step and at rows left out, or record \
         the attitude too; if the times are right, the term is not that of the body: w' = J ((I w) x w)." in PITFALL_FLIPS;
    TURN_FIRST: "The attitude does not turn by the spin: first mend how the attitude turns, and judge again.";
    SIDE: "The turn of a step stands on the wrong side of the attitude: with q from body to world write q * dq where dq is \
         made of a spin in body axes, and dq * q where it is made of a spin in world axes.";
    OWN_TURN: "The turn does not belong to the spin: take attitude and spin at the end of the step both from this rule, \
         after all that changes the spin, and take out the engine's own update of the attitude." in STAGE;
    ONE_INSTANT: "A row's spin and attitude are of two instants: turn by the new spin, and write both after the step.";
    TURNED_OTHERWISE: "The spin goes by this rule, and the attitude does not follow it: look at how the spin turns the \
         body, and at the columns of the attitude.";
    CAP: "The spin is cut off at a limit: raise the engine's greatest angular velocity.";
    LIMITS: "The body is too fast for the engine's limits, which slow it or turn it too little: take shorter steps, or \
         raise the limits." in STEPS;
    FROZEN: "The spin is stepped in the world with the tensor of the body as it stood at the start: turn the tensor with \
         the body, R I R^T, at each step." in PITFALL_TENSOR;
    MOMENTUM: "The momentum turns the body as if it were the spin: make the spin from it by the inverse tensor turned to \
         the world, w = R J R^T L." in PITFALL_MOMENTUM;
    STRAIGHT: "The gyroscopic term is taken at the start of the step and adds energy to a body that wobbles; and the \
         straight step turns the body by too little. Turn the momentum instead of adding to it (three exact turns a step), \
         and the body by the exact turn of its spin, (cos a/2, sin a/2 times the axis)." in REMEDY;
    KEEPS_ALL: "It keeps energy and momentum to rounding. Its phase is off, by less in shorter steps." in STEPS;
    KEEPS_SIZES: "It keeps the energy and the momentum's length to rounding. The momentum's direction in the world and the \
         phase are off, by less in shorter steps." in STEPS;
    KEEPS_MOMENTUM: "It keeps the momentum to rounding. Energy and phase are off, by less in shorter steps." in STEPS;
    OF_ORDER: "Its errors add up: take shorter steps, or for long runs a method that keeps the laws." in STEPS;
    NO_TERM: "There is no gyroscopic term: a body never flips by itself, and its momentum wanders unless it spins along a \
         principal axis (the spin looks the same where the momentum is taken for it). Turn the momentum in the body (three exact turns a \
         step). An engine's flag for gyroscopic forces makes it flip, and may lose a stable spin: record that." in PITFALL_FLIPS;
    EXPLICIT: "The gyroscopic term is taken at the start of the step and adds energy to a body that wobbles. Turn the \
         momentum instead of adding to it (three exact turns a step)." in REMEDY;
    RESCALED: "After each explicit step the momentum's length is set back to that before it, the energy is not: a stable spin that \
         wobbles drifts toward the separatrix, and flips. Turn the momentum instead (three exact turns a step)." in REMEDY;
    ONE_IMPLICIT: "One implicit step takes energy and momentum from most bodies that tumble; of a step that turns by a radian or \
         more it can multiply the energy. Use three exact turns a step." in REMEDY;
    MEAN_SPIN: "The spin is of order 4, the attitude of order 2: the momentum of a body that wobbles wanders in the world. \
         Correct the stages' spins to the turn since the start of the step." in STEPS;
    EULER: "All is stepped straight ahead, and a body that wobbles gains energy: use three exact turns a step." in STEPS;
}

impl Advice {
    /// What follows from the rule that fits best and how well it fits; `floor` is the record's rounding,
    /// `jumps` says whether some steps are not the rule's, `turns` whether there are attitudes, `scatter`
    /// whether these do by more than the digits that are printed.
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
        // A rule with something altered has a fault of its own, and so has one between jumps.
        let term = matches!(rule.alteration, Some(Alteration::Damped { term, .. }) if term != 1.0);
        let term = (term && one == Self::DAMPING).then_some(Self::TERM);
        let more = (confidence.names_a_rule() && (jumps || rule.alteration.is_some()))
            .then(|| Self::of_rule(&if jumps { *rule } else { Rule::plain(rule.base) }, turns))
            .filter(|more| !fine.contains(more));
        // A term that is found by the spin alone says nothing of what turns the attitude.
        let side = (whole.on_wrong_side && one != Self::SIDE && rule.is_of_spin()).then_some(Self::SIDE);
        let is_sound = confidence.names_a_rule() && !jumps && rule.alteration.is_none() && !rule.is_wrong();
        let other = (whole.fails_otherwise && is_sound && *rule != Rule::EXACT).then_some(Self::NOT_THE_RULE);
        let again = Some(Self::EACH_STEP).filter(|x| whole.again && confidence.names_a_rule() && one != *x);
        [other, Some(one), term, again, side, more].into_iter().flatten().collect()
    }

    /// What follows from a rule that all steps are made by.
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
        let kept = method.info().conserved;
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
