//! What to do about a finding, as a value and in words.

use crate::rule::confidence::Confidence;
use crate::rule::rules::{Alteration, Base, Rule, Spin};
use tumbling::step::Method;

/// What a finding means for a body, and what to do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Advice {
    /// The steps are the motion's, and every law is kept.
    NothingToDo,
    /// The steps are the motion's to the rounding of single precision.
    SinglePrecision,
    /// The steps are the motion's to the rounding of the record, and a law is broken over all of it.
    BelowRounding,
    /// The gyroscopic term is missing.
    NoGyroscopicTerm,
    /// The gyroscopic term is taken at the start of the step.
    ExplicitTerm,
    /// The same, and the attitude is stepped straight.
    ExplicitTermTurnedStraight,
    /// The momentum is rescaled after an explicit step.
    Rescaled,
    /// One step of an implicit solution takes energy away.
    Dissipative,
    /// The attitude is of lower order than the spin.
    MeanSpin,
    /// Everything is stepped straight ahead.
    ExplicitEuler,
    /// The errors are small and add up.
    HighOrder,
    /// The method keeps what it says it keeps.
    KeepsLaws,
    /// The body is too fast for the engine's limits.
    EngineLimits,
    /// The tensor does not turn with the body.
    FrozenTensor,
    /// The momentum turns the body.
    MomentumForSpin,
    /// The engine steps another body.
    OtherMoments,
    /// Damping takes spin in each step.
    Damped,
    /// The spin is cut off at a limit.
    Capped,
    /// Some of the steps are made by something else.
    OddSteps,
    /// The record has too few digits.
    MoreDigits,
    /// The errors of the steps are too near to rounding.
    LongerSteps,
    /// The record has too few rows that follow one another.
    EveryStep,
    /// An accurate rule, and none of those known.
    Accurate,
    /// None of the rules known.
    Unknown,
}

impl Advice {
    /// What follows from the rule that fits best and how well it fits; `single` says whether the record is in
    /// single precision, `kept` whether every law is kept.
    pub(crate) fn of(confidence: &Confidence, rule: &Rule, single: bool, kept: bool) -> Self {
        match confidence {
            Confidence::NoneFits => Self::Unknown,
            Confidence::Accurate => Self::Accurate,
            Confidence::FewSteps => Self::EveryStep,
            Confidence::SmallErrors => Self::LongerSteps,
            Confidence::FewDigits => Self::MoreDigits,
            Confidence::MostSteps => Self::OddSteps,
            Confidence::ToRounding | Confidence::Near => match Self::of_rule(rule) {
                Self::NothingToDo if single => Self::SinglePrecision,
                Self::NothingToDo if !kept => Self::BelowRounding,
                advice => advice,
            },
        }
    }

    /// What follows from a rule that all steps are made by.
    #[must_use]
    pub const fn of_rule(rule: &Rule) -> Self {
        match &rule.alteration {
            Some(Alteration::OtherMoments(_)) => Self::OtherMoments,
            Some(Alteration::Damped(..)) => Self::Damped,
            Some(Alteration::Capped(_)) => Self::Capped,
            None => match &rule.base {
                Base::Exact => Self::NothingToDo,
                Base::Method(method, _) => Self::of_method(*method),
                Base::Engine(engine) if engine.limits.rate.is_none() => Self::EngineLimits,
                Base::Engine(engine) => Self::of_method(engine.method),
                Base::PositionStage(_) => Self::KeepsLaws,
                Base::FrozenTensor(_) | Base::FrozenAt(..) => Self::FrozenTensor,
                Base::MomentumForSpin(_) => Self::MomentumForSpin,
                Base::Straight(Spin::Kept, _) => Self::NoGyroscopicTerm,
                Base::Straight(Spin::Explicit, _) => Self::ExplicitTermTurnedStraight,
            },
        }
    }

    const fn of_method(method: Method) -> Self {
        match method {
            Method::ConstantSpin => Self::NoGyroscopicTerm,
            Method::SemiImplicitEuler => Self::ExplicitTerm,
            Method::Rescaled | Method::RescaledLinearAttitude => Self::Rescaled,
            Method::ImplicitOneNewton | Method::LinearisedImplicit => Self::Dissipative,
            Method::MeanSpinRungeKutta4 => Self::MeanSpin,
            Method::ExplicitEuler => Self::ExplicitEuler,
            Method::RungeKutta4
            | Method::DormandPrince5
            | Method::TurnedRungeKutta4
            | Method::MuntheKaas4 => Self::HighOrder,
            _ => Self::KeepsLaws,
        }
    }

    /// In a sentence or two.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::NothingToDo => "Nothing to do: the steps are the motion itself.",
            Self::SinglePrecision => {
                "Each step is exact to the rounding of single precision; over many steps that rounding adds up. For longer runs or \
                 for stricter limits carry attitude and momentum in double precision."
            }
            Self::BelowRounding => {
                "Each step is exact to the record's rounding, and over the whole record the laws named above are not kept: errors \
                 below that rounding add up. Record all digits, or longer steps, and judge it again."
            }
            Self::NoGyroscopicTerm => {
                "There is no gyroscopic term: a body never flips and its momentum wanders (a record of the spin looks the same where \
                 the momentum is taken for the spin). Turn the momentum in the body (three exact turns a step). An engine's flag for \
                 gyroscopic forces makes the body flip, and may lose a stable spin: record one with it."
            }
            Self::ExplicitTerm => {
                "The gyroscopic term is taken at the start of the step and adds energy without bound: a stable spin blows up. Turn the \
                 momentum instead of adding to it (three exact turns a step)."
            }
            Self::ExplicitTermTurnedStraight => {
                "The gyroscopic term is taken at the start of the step and adds energy without bound: a stable spin blows up; and the \
                 straight step turns the body by too little. Turn the momentum instead of adding to it (three exact turns a step), and \
                 the body by the exact turn of its spin, (cos a/2, sin a/2 times the axis)."
            }
            Self::Rescaled => {
                "The momentum's length is put right after an explicit step, its energy is not: a stable spin drifts toward the \
                 separatrix, and flips. Turn the momentum instead (three exact turns a step keep the length without rescaling)."
            }
            Self::Dissipative => {
                "One implicit step takes energy and momentum from most bodies that tumble, so that they slow down by themselves; of a \
                 step that turns by a radian or more it can multiply the energy. Use three exact turns a step."
            }
            Self::MeanSpin => {
                "The spin is of order 4, the attitude of order 2: the momentum wanders in the world. Correct the stages' spins to the \
                 turn since the start of the step."
            }
            Self::ExplicitEuler => {
                "Everything is stepped straight ahead, and the energy grows without bound: use three exact turns a step."
            }
            Self::HighOrder => {
                "A good method whose errors fall fast with the step, and add up: for long runs take one that keeps the laws."
            }
            Self::KeepsLaws => {
                "A method that keeps what it says it keeps; what is left is an error of phase."
            }
            Self::EngineLimits => {
                "The body is too fast for the engine's limits, which slow it or turn it too little: take shorter steps, or raise the \
                 limits."
            }
            Self::FrozenTensor => {
                "The spin is stepped in the world with the tensor of the body as it stood at the start: turn the tensor with the body, \
                 R I R^T, at each step."
            }
            Self::MomentumForSpin => {
                "The momentum turns the body as if it were the spin: make the spin from it by the inverse tensor turned to the world, \
                 w = R J R^T L."
            }
            _ => self.of_alteration(),
        }
    }

    const fn of_alteration(self) -> &'static str {
        match self {
            Self::OtherMoments => {
                "The engine steps a body with other moments than the record says: look for a wrong order of axes, a principal frame \
                 that is left out, or a shape that replaces the moments set. A free body shows their ratios, never their common scale."
            }
            Self::Damped => "Damping takes spin in each step: set the engine's angular damping to 0.",
            Self::Capped => "The spin is cut off at a limit: raise the engine's greatest angular velocity.",
            Self::OddSteps => {
                "Most steps are this rule's: find what acts in the others, a limit, damping, a contact or a push."
            }
            Self::MoreDigits => {
                "Write the record with all digits (17 of double precision, 9 of single), and judge it again."
            }
            Self::LongerSteps => {
                "Errors so close to rounding are those of many rules: record a faster spin, or longer steps, and judge it again."
            }
            Self::EveryStep => "Write a row at every step, and judge it again.",
            Self::Accurate => {
                "The rule is none of those known here, as those with steps chosen by error control are. Its errors fall with its \
                 tolerance or its step; what drifts in the table above goes on drifting."
            }
            _ => "Compare the engine's rule with those that are known.",
        }
    }
}
