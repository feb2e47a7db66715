//! What is found in a record besides the laws, as values; `words` puts them into sentences.

use crate::rules::Rule;
use nalgebra::Vector3;

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
    /// The record has a second vector that is at odds with the first.
    OtherSpin {
        /// The first column of the second vector.
        column: String,
        /// By how much, as a share.
        off: f64,
        /// In which line.
        line: usize,
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
    },
    /// Every step is made by a rule that no body goes by.
    WrongRule(Rule),
    /// The phase ran away from the exact one.
    WrongPace {
        /// How far, in periods of the spin.
        off: f64,
        /// The number of periods of the exact motion.
        ways: f64,
        /// How far was allowed.
        allowed: f64,
    },
}

/// What is seen in the steps besides the rule.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Hint {
    /// The first step slows the spin, and no later one goes beyond: a cap on the spin.
    CapAtStart {
        /// From this spin, rad/s.
        from: f64,
        /// To this one.
        to: f64,
    },
    /// The attitude stands still while the body spins.
    StandsStill {
        /// The number of steps.
        steps: usize,
        /// By so much the body should have turned at most, rad.
        angle: f64,
    },
    /// A component of the spin is zero to the last digit, where the law moves it.
    HeldAtZero {
        /// The number of steps.
        steps: usize,
    },
    /// By what the spin alone is stepped, and the attitude alone, where no rule fits both.
    Apart {
        /// The spin.
        spin: Option<&'static str>,
        /// The attitude.
        turn: Option<&'static str>,
    },
}

/// What was made of a file besides its rows.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// A comment seems to name a number, and none is read from it.
    Unread {
        /// Its line.
        line: usize,
        /// What it speaks of.
        word: &'static str,
    },
    /// Rounded moments that no body has are taken for those of a flat body.
    Flat {
        /// The largest, as printed, kg m².
        printed: f64,
        /// How much more it is than the others together, kg m².
        missing: f64,
        /// The moments judged, kg m².
        moments: Vector3<f64>,
    },
    /// The header names a step of which each row is a whole number.
    StepsPerRow {
        /// The step named, s.
        named: f64,
        /// The number of such steps from row to row.
        steps: u32,
    },
    /// The header names a step of which the time from row to row is no whole number.
    OtherStep {
        /// The step named, s.
        named: f64,
        /// The time from row to row, s.
        row: f64,
    },
    /// Times of few digits are taken for multiples of one step.
    EvenSteps {
        /// Whether the record names the step.
        named: bool,
        /// The step, as the file counts.
        step: f64,
    },
}
