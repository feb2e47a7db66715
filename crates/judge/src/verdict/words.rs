//! The sentences of complaints, notes and resets: one for each, on a page, in a program or on a terminal.

use crate::laws::{Complaint, Reset, Seen};
use crate::read::Note;
use std::fmt;

impl fmt::Display for Complaint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ended { at } => write!(f, "the numbers end at {at}. Judged up to there"),
            Self::TurnedOver { time } => {
                write!(f, "the spin turns over at {time:.4} s about the axis that it should circle for ever")
            }
            Self::NeverFlips { exact } => {
                let exact = times(*exact);
                write!(f, "the spin along the middle axis never changes sign, and should do so {exact}")
            }
            Self::Flips { found } => {
                let found = times(*found);
                write!(f, "the spin along the middle axis changes sign {found}, and should never do so")
            }
            Self::Constant { moved } => {
                let moved = 100.0 * moved;
                write!(f, "the spin stays as it is at the start, and should change by {moved:.0} % of it")
            }
            Self::TooFar { line, turn } => write!(f, "line {line}: {}. Judged up to there", too_far(*turn)),
            Self::NoSteps => f.write_str("no two rows are one step apart: no rule can be tried"),
            Self::Otherwise { off, seen } => {
                let how = match seen {
                    None => String::new(),
                    Some(Seen::BodyInWorld) => ": it turns about a spin in body axes as if that were in the world's (dq * q, not q * \
                         dq)".into(),
                    Some(Seen::WorldInBody) => ": it turns about a spin in world axes as if that were in the body's (q * dq, not dq * \
                         q)".into(),
                    Some(Seen::Times(times)) => format!(": it turns about the spin's axis, and {times:.3} times as far"),
                    Some(Seen::OtherAxis) => ": it turns about another axis".into(),
                };
                let off = 100.0 * off;
                write!(f, "the attitude does not turn as the spin says, by up to {off:.1} % of it{how}")
            }
            Self::WrongRule(rule) => {
                write!(f, "every step is made by a rule that is wrong here: {}", rule.name())
            }
            Self::WrongPace { off, periods, allowed } => write!(
                f,
                "the phase of the spin is off by {off:.2} periods after {periods:.2} periods of the exact motion (allowed: \
                 {allowed:.2}, unless a limit for phase says otherwise)"
            ),
        }
    }
}

/// What is wrong where attitudes are too far apart, by an angle in rad.
pub(crate) fn too_far(turn: f64) -> String {
    format!(
        "the attitude turns by {turn:.2} rad or more in one step, and attitudes alone do not distinguish a turn from one \
         that goes the other way round. Record the spin, or shorter steps"
    )
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unread { line, word } => {
                write!(f, "line {line} speaks of `{word}`, and no number is read from it")
            }
            Self::Story(name) => write!(f, "the record is of the kit's story {name}"),
            Self::Rest { line } => {
                write!(f, "the body is at rest before line {line}, and is judged from there")
            }
            Self::Flat { printed, missing, moments } => write!(
                f,
                "the largest moment is printed as {printed}, {missing:.1e} more than the others together, which no body \
                 has; its printed digits leave that open, and a flat body of {}, {}, {} kg m2 is judged",
                moments.x, moments.y, moments.z
            ),
            Self::EvenSteps { named, step } => {
                let which = if *named { "that the header names" } else { "that they have in the mean" };
                write!(
                    f,
                    "the times are printed with few digits, and are taken as multiples of the step {which}, {step:.9} s as \
                     the file counts"
                )
            }
            Self::StepsPerRow { named, steps } => {
                write!(f, "the header names a step of {named:.9} s: from row to row are {steps} such steps")
            }
            Self::OtherStep { named, row } => write!(
                f,
                "the header names a step of {named:.9} s, and the rows are {row:.9} s apart, no whole number of such steps: \
                 it is not used"
            ),
        }
    }
}

impl Reset {
    /// What the body does there.
    #[must_use]
    pub const fn words(&self) -> &'static str {
        match (self.to_rest, self.to_start) {
            (true, _) => "is put to rest (a reset, or put to sleep)",
            (false, true) => "is put back to its start",
            (false, false) => "jumps to another motion (a reset, a push or a collision)",
        }
    }
}

fn times(count: u64) -> String {
    if count == 1 { "once".into() } else { format!("{count} times") }
}
