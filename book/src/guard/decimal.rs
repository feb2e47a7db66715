//! Decimal numbers as they are printed: exact, so that equal means equal.

use std::fmt;

/// `mantissa` times ten to the power `exponent`. No trailing zero is left in the mantissa, so that
/// equal numbers have equal parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Decimal {
    mantissa: i128,
    exponent: i32,
}

impl Decimal {
    /// This many units of the decimal place `exponent`.
    pub(crate) fn new(mantissa: i128, exponent: i32) -> Self {
        let (mut mantissa, mut exponent) = (mantissa, exponent);
        if mantissa == 0 {
            return Self { mantissa, exponent: 0 };
        }
        while mantissa % 10 == 0 {
            mantissa /= 10;
            exponent = exponent.saturating_add(1);
        }
        Self { mantissa, exponent }
    }

    /// Reads `-12.50e-3` and `1_000`; nothing where it is no such number, or has too many digits.
    pub(crate) fn read(text: &str) -> Option<Self> {
        let text: String = text.chars().filter(|&c| c != '_').collect();
        let (digits, power) = match text.split_once(['e', 'E']) {
            Some((digits, power)) => (digits, power.parse::<i32>().ok()?),
            None => (text.as_str(), 0),
        };
        let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
        let mantissa: i128 = format!("{whole}{part}").parse().ok()?;
        Some(Self::new(mantissa, power.checked_sub(i32::try_from(part.len()).ok()?)?))
    }

    /// The product, unless it has too many digits.
    pub(crate) fn times(self, other: Self) -> Option<Self> {
        let mantissa = self.mantissa.checked_mul(other.mantissa)?;
        Some(Self::new(mantissa, self.exponent.checked_add(other.exponent)?))
    }

    /// This over `other`, where both are whole and so is that.
    pub(crate) fn whole_ratio(self, other: Self) -> Option<Self> {
        let whole = |n: Self| n.mantissa.checked_mul(10_i128.checked_pow(u32::try_from(n.exponent).ok()?)?);
        let (over, under) = (whole(self)?, whole(other)?);
        (over.checked_rem(under)? == 0).then(|| Self::new(over / under, 0))
    }

    pub(crate) fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    /// Whether this is no more than a thousandth.
    pub(crate) fn is_within_a_thousandth(self) -> bool {
        let digits = self.mantissa.checked_ilog10().map_or(0, |n| i64::from(n) + 1);
        // 0.001 itself, and all with three zeros behind the point.
        self == Self::new(1, -3) || self.mantissa <= 0 || i64::from(self.exponent) + digits <= -3
    }

    /// With the other sign.
    pub(crate) fn negated(self) -> Self {
        Self { mantissa: -self.mantissa, exponent: self.exponent }
    }

    /// Whether the product with `other` is one.
    pub(crate) fn is_inverse_of(self, other: Self) -> bool {
        self.times(other) == Some(Self::new(1, 0))
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match usize::try_from(-i64::from(self.exponent)) {
            Err(_) if self.exponent < 9 => {
                write!(f, "{}{}", self.mantissa, "0".repeat(usize::try_from(self.exponent).unwrap_or(0)))
            }
            Ok(0) => write!(f, "{}", self.mantissa),
            Ok(places) if places <= 9 => {
                let sign = if self.mantissa < 0 { "-" } else { "" };
                let digits = format!("{:0>1$}", self.mantissa.unsigned_abs(), places + 1);
                let (whole, part) = digits.split_at(digits.len() - places);
                write!(f, "{sign}{whole}.{part}")
            }
            _ => write!(f, "{}e{}", self.mantissa, self.exponent),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_written_differently_are_equal_and_different_ones_are_not() {
        let read = |text| Decimal::read(text).unwrap();
        assert_eq!(read("20_000"), read("2e4"));
        assert_eq!(read("0.10"), read("1e-1"));
        assert_eq!(read("-0.0"), read("0"));
        assert_ne!(read("0.1"), read("0.01"));
        assert_ne!(read("-1"), read("1"));
        assert_eq!(read("0.001").times(read("2050")), Some(read("2.05")));
        for shown in ["0.05", "-0.108", "20000", "0", "3e-13"] {
            assert_eq!(read(shown).to_string(), shown);
        }
        assert!(read("0.05").is_inverse_of(read("20")));
        for wrong in ["", "1.2.3", "e5", "x", "1e", "123456789012345678901234567890123456789012"] {
            assert_eq!(Decimal::read(wrong), None, "{wrong}");
        }
    }
}
