//! Where the book says more of what the judge advises. The page of the judge has the same words.

use tumbling_judge::Advice;

/// The chapter, and where in it.
pub(crate) const fn chapter(advice: Advice) -> Option<&'static str> {
    Some(match advice {
        Advice::NoGyroscopicTerm => "\"Three pitfalls\", 3",
        Advice::FrozenTensor => "\"Three pitfalls\", 1",
        Advice::MomentumForSpin => "\"Three pitfalls\", 2",
        Advice::ExplicitTerm
        | Advice::ExplicitTermTurnedStraight
        | Advice::Rescaled
        | Advice::Dissipative => "\"Where things break\", the fix",
        Advice::OtherMoments => "\"Principal axes\"",
        Advice::MeanSpin
        | Advice::ExplicitEuler
        | Advice::HighOrder
        | Advice::KeepsLaws
        | Advice::EngineLimits
        | Advice::Damped
        | Advice::DampedByAxis
        | Advice::SmallTurn
        | Advice::Zeroed
        | Advice::OtherTurn
        | Advice::OtherStep
        | Advice::Accurate
        | Advice::Unknown => "\"Stepping through time\"",
        _ => return None,
    })
}
