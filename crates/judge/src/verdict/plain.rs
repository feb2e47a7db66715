//! Numbers, and how an error grows, in words for a reader who has no need of logarithms.

use crate::law::LawName;
use crate::laws::{Growth, Law};
use crate::thresholds::*;

impl Law {
    /// How it is kept, with what a second makes of it: `exponential: shrinks by a factor of 4.85 a second`.
    ///
    /// Energy and `|L|` are given as what happens to themselves, the other laws as what happens to the error.
    pub(crate) fn plain(&self) -> String {
        let name = self.growth.name();
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
            Growth::Exponential { rate } => (rate, times(rate)),
        };
        if rate.is_finite() { format!("{name}: {how}") } else { format!("{name}: {}", plain_number(rate)) }
    }

    /// What a number of this law counts.
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
fn times(rate: f64) -> String {
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
        Ok(power @ -3..=4_i32) => {
            let decimals = usize::try_from(2 - power).unwrap_or(0);
            format!("{x:.decimals$}")
        }
        _ => {
            let raised = |c| match c {
                '-' => '⁻',
                c => c.to_digit(10).and_then(|d| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(d as usize)).unwrap_or(c),
            };
            format!("{digits} · 10{}", power.chars().map(raised).collect::<String>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(name: LawName, growth: Growth) -> String {
        Law { name, growth, most: 1.0, last: 1.0 }.plain()
    }

    #[test]
    fn a_number_has_three_digits_and_a_raised_power_where_it_is_small_or_large() {
        let wanted = ["0.0123", "−1.50 · 10⁻⁷", "0", "beyond counting"];
        assert_eq!([0.012345, -1.5e-7, -0.0, f64::INFINITY].map(plain_number), wanted);
    }

    #[test]
    fn a_rate_is_given_as_what_a_second_makes_of_it() {
        // e^1.58 = 4.855, e^0.02 = 1.0202, ln 10 / 100 = 0.02303.
        let exponential = |rate| said(LawName::Energy, Growth::Exponential { rate });
        assert_eq!(exponential(-1.58), "exponential: shrinks by a factor of 4.85 a second");
        assert_eq!(exponential(1.58), "exponential: grows by a factor of 4.85 a second");
        assert_eq!(exponential(0.02), "exponential: grows by 2.02 % a second");
        assert_eq!(exponential(-0.02), "exponential: shrinks by 1.98 % a second");
        assert_eq!(exponential(100.0), "exponential: grows tenfold every 0.0230 s");
        assert_eq!(exponential(f64::INFINITY), "exponential: beyond counting");
        let linear = |name, rate| said(name, Growth::Linear { rate });
        assert_eq!(linear(LawName::Momentum, -1.5e-7), "linear: falls by 1.50 · 10⁻⁷ of itself a second");
        assert_eq!(linear(LawName::Phase, -1.58), "linear: falls behind by 1.58 periods a second");
        assert_eq!(linear(LawName::Direction, 0.5), "linear: turns away by 0.500 rad a second");
        assert_eq!(
            said(LawName::Direction, Growth::RandomWalk { rate: 2e12 }),
            "random walk: 2.00 · 10¹² rad in a second, tenfold in a hundred"
        );
        assert_eq!(
            said(LawName::Energy, Growth::Power { power: 2.04 }),
            "faster than linear: as time to the power 2.0"
        );
        assert_eq!(said(LawName::Unit, Growth::Bounded), "bounded");
    }
}
