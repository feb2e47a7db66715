//! Where the book says more of what the judge advises. The page of the judge has the same words.

use tumbling_judge::Advice;

/// The chapter, and where in it.
pub(crate) const fn chapter(advice: Advice) -> Option<&'static str> {
    Some(match advice {
        Advice::NoGyroscopicTerm => "\"Three pitfalls\", the engine that refuses to flip",
        Advice::FrozenTensor => "\"Three pitfalls\", the tensor that never turned",
        Advice::MomentumForSpin => "\"Three pitfalls\", momentum taken for spin",
        Advice::ExplicitTerm
        | Advice::ExplicitTermTurnedStraight
        | Advice::Rescaled
        | Advice::Dissipative => "\"Test your engine\", a step that keeps the laws",
        Advice::OtherMoments => "\"Principal axes\"",
        Advice::MeanSpin
        | Advice::ExplicitEuler
        | Advice::HighOrder
        | Advice::KeepsLaws
        | Advice::EngineLimits
        | Advice::Damped
        | Advice::Accurate
        | Advice::Unknown => "\"Stepping through time\"",
        _ => return None,
    })
}
