//! Sentences for complaints and resets, the same on a page, in a program and on a terminal; numbers and
//! growth of errors without logarithms.

use crate::law::LawName;
use crate::laws::{FlipCount, Growth, Law, Reset};
use crate::rule::Rule;
use crate::thresholds::*;

/// A reason to fail a record that is not a broken law.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Complaint {
    /// The numbers end before the file does: the place and the reason.
    #[error("the numbers end at {0}. Judged up to there")]
    Ended(String),
    /// The spin along the axis that it should circle for ever changes sign: when first, s from the start.
    #[error("the spin along the axis that it should circle changes sign at {0:.4} s")]
    TurnedOver(f64),
    /// The spin along the middle axis never changes sign in the record, and should: how often it should.
    #[error("the recorded spin along the middle axis never changes sign, but should do so {}", times(*.0))]
    NeverFlips(u64),
    /// The spin along the middle axis changes sign, and should never: how often it does.
    #[error("the spin along the middle axis changes sign {}, but should never do so", times(*.0))]
    Flips(u64),
    /// The spin stays as it is, and should change: by how much, as a share.
    #[error("the spin stays constant, but should change by {:.0} %", 100.0 * .0)]
    Constant(f64),
    /// Attitudes turn too far from one to the next to say which way; the record is judged up to there: in
    /// which line, and by how much, rad.
    #[error("line {}: {}. Judged up to there", .0, too_far(*.1))]
    TooFar(usize, f64),
    /// The last rows repeat the row before them: how many, the line of the first, and the time of the row
    /// before it, s.
    #[error(
        "rows at the end repeat the row before them ({0}, from line {1} on): the run may have ended at t = {2:.4} s"
    )]
    Repeats(u64, usize, f64),
    /// No two rows are one step apart.
    #[error("no two rows are one step apart: no rule can be tested")]
    NoSteps,
    /// The attitude does not turn as the spin says.
    #[error("the attitude does not turn by the spin: off by up to {:.1} % of it{}", 100.0 * .off, how(*.seen))]
    Otherwise {
        /// By how much at most, as a share of the spin.
        off: f64,
        /// How it turns instead, where that is seen.
        seen: Option<Seen>,
    },
    /// Every step agrees, to rounding, with a rule that no body goes by.
    #[error("every step tried follows a wrong rule: {}", .0.name())]
    WrongRule(Box<Rule>),
    /// The phase ran away from the exact one.
    #[error(
        "the phase of the spin is off by {off:.2} periods after {periods:.2} periods of the exact motion (allowed by \
         default: {allowed:.2})"
    )]
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

/// How an attitude turns that does not turn as the spin says, where that is seen.
fn how(seen: Option<Seen>) -> String {
    match seen {
        None => String::new(),
        Some(Seen::BodyInWorld) => "; body spin used as world spin (dq * q, not q * dq)".into(),
        Some(Seen::WorldInBody) => "; world spin used as body spin (q * dq, not dq * q)".into(),
        Some(Seen::Times(by)) => format!("; about the spin's axis, and {by:.3} times as far"),
        Some(Seen::OtherAxis) => "; about another axis".into(),
    }
}

/// The sentence on attitudes that are too far apart, by an angle in rad.
pub(crate) fn too_far(turn: f64) -> String {
    format!(
        "the attitude turns by {turn:.2} rad or more in one step, so attitudes alone do not show which way \
         it turns. Record the spin, or shorter steps"
    )
}

impl Reset {
    /// What happens to the body there.
    #[must_use]
    pub const fn words(&self) -> &'static str {
        match (self.to_rest, self.to_start) {
            (true, _) => {
                "is put to rest (a reset or sleep; of attitudes alone, also a last row that repeats)"
            }
            (false, true) => "is put back to its start",
            (false, false) => "jumps to another motion (a reset, a push or a collision)",
        }
    }
}

impl FlipCount {
    /// How late they are, if by a constant, a share of the time, or both.
    pub(crate) fn lateness(&self) -> String {
        let Some(([shift, share], end)) = self.late.zip(self.times.last()) else { return String::new() };
        let parts = [(shift, shift, " s"), (share * end, 100.0 * share, " % of the time since the start")];
        let seen = parts.iter().filter(|x| x.0.abs() > LATE_PART * shift.abs().max((share * end).abs()));
        let words = seen.map(|(_, size, unit)| {
            let way = if *size < 0.0 { "earlier" } else { "later" };
            format!("{way} by {}{unit}", plain_number(size.abs()))
        });
        format!("; they come {}", words.collect::<Vec<_>>().join(", and "))
    }
}

pub(super) fn times(count: u64) -> String {
    if count == 1 { "once".into() } else { format!("{count} times") }
}

impl Law {
    /// How it is kept, with what a second makes of it: `exponential: shrinks by a factor of 4.85 a second`.
    ///
    /// Energy and `|L|` are described by their own change, the other laws by the change of the error.
    ///
    /// ```
    /// use tumbling_judge::{Growth, Law, LawName};
    /// let growth = Growth::Linear { rate: -1.5e-7 };
    /// let law = Law { name: LawName::Momentum, growth, most: 1e-5, last: -1e-5 };
    /// assert_eq!(law.plain(), "linear: falls by 1.50 · 10⁻⁷ of itself a second");
    /// ```
    pub fn plain(&self) -> String {
        let name = self.how();
        let (rate, how) = match self.growth {
            Growth::Rounding | Growth::Bounded | Growth::Stayed => return name.into(),
            Growth::Power { power } => (power, format!("as time to the power {power:.1}")),
            Growth::RandomWalk { rate } => {
                let first = plain_number(rate);
                (rate, format!("{first}{} in a second, tenfold in a hundred", self.unit()))
            }
            Growth::Linear { rate } => {
                (rate, format!("{} {}{} a second", self.moves(rate), plain_number(rate.abs()), self.unit()))
            }
            Growth::Exponential { rate } => (rate, in_a_second(rate)),
        };
        if rate.is_finite() { format!("{name}: {how}") } else { format!("{name}: {}", plain_number(rate)) }
    }

    /// The unit of this law's numbers.
    const fn unit(&self) -> &'static str {
        match self.name {
            LawName::Energy | LawName::Momentum => " of itself",
            LawName::Direction => " rad",
            LawName::Phase => " periods",
            LawName::Consistency => " of the spin",
            LawName::Unit | LawName::Separatrix => "",
        }
    }

    fn moves(&self, rate: f64) -> &'static str {
        match (self.name, rate < 0.0) {
            (LawName::Direction, _) => "turns away by",
            (LawName::Phase, true) => "falls behind by",
            (LawName::Phase, false) => "runs ahead by",
            (_, true) => "falls by",
            (_, false) => "grows by",
        }
    }
}

/// What a second makes of a quantity that grows by this number of powers of e in it, or shrinks.
fn in_a_second(rate: f64) -> String {
    let (way, steep) = if rate < 0.0 { ("shrinks", "to a tenth") } else { ("grows", "tenfold") };
    let size = rate.abs();
    if size > STEEP {
        format!("{way} {steep} every {} s", plain_number(std::f64::consts::LN_10 / size))
    } else if size < GENTLE {
        format!("{way} by {} % a second", plain_number(100.0 * rate.exp_m1().abs()))
    } else {
        format!("{way} by a factor of {} a second", plain_number(size.exp()))
    }
}

/// A number in three digits, with a raised power of ten where it is very small or large.
pub(crate) fn plain_number(x: f64) -> String {
    if x < 0.0 {
        return format!("−{}", plain_number(-x));
    }
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 { "0".into() } else { "beyond counting".into() };
    }
    let scientific = format!("{x:.2e}");
    let (digits, power) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    match power.parse() {
        Ok(power @ -3..=4_i32) => format!("{x:.0$}", usize::try_from(2 - power).unwrap_or(0)),
        _ => {
            let raised = |c| match c {
                '-' => '⁻',
                c => c.to_digit(10).and_then(|d| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(d as usize)).unwrap_or(c),
            };
            format!("{digits} · 10{}", power.chars().map(raised).collect::<String>())
        }
    }
}
