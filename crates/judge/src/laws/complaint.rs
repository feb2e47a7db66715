//! What fails a record and is no law, as values; the room of verdicts puts them into sentences.

use crate::rule::Rule;

/// What fails a record and is no law.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Complaint {
    /// The numbers end before the file does.
    Ended {
        /// Where, and with what.
        at: String,
    },
    /// The spin turns over about the axis that it should circle for ever.
    TurnedOver {
        /// When first, s from the start.
        time: f64,
    },
    /// The spin along the middle axis never changes sign, and should.
    NeverFlips {
        /// How often it should.
        exact: u64,
    },
    /// The spin along the middle axis changes sign, and should never.
    Flips {
        /// How often it does.
        found: u64,
    },
    /// The spin stays as it is, and should change.
    Constant {
        /// By how much, as a share.
        moved: f64,
    },
    /// Attitudes turn too far from one to the next to say which way; the record is judged up to there.
    TooFar {
        /// In which line.
        line: usize,
        /// By how much, rad.
        turn: f64,
    },
    /// No two rows are one step apart.
    NoSteps,
    /// The attitude does not turn as the spin says.
    Otherwise {
        /// By how much at most, as a share of the spin.
        off: f64,
        /// How it turns instead, where that is seen.
        seen: Option<Seen>,
    },
    /// Every step is made by a rule that no body goes by.
    WrongRule(Box<Rule>),
    /// The phase ran away from the exact one.
    WrongPace {
        /// How far, in periods of the spin.
        off: f64,
        /// The number of periods of the exact motion.
        periods: f64,
        /// How far was allowed.
        allowed: f64,
    },
}

/// How an attitude turns that does not turn as the spin says.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Seen {
    /// As a spin in body axes would turn it, if that were in the world's: the turn is on the wrong side.
    BodyInWorld,
    /// As a spin in world axes would turn it, if that were in the body's.
    WorldInBody,
    /// About the spin's own axis, this number of times as far.
    Times(f64),
    /// About another axis.
    OtherAxis,
}
