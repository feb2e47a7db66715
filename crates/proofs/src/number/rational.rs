//! Exact fractions of whole numbers of any size.

use super::ops::{constants, from, operator};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::fmt;

/// An exact fraction of two whole numbers of any size: nothing rounds or overflows.
///
/// A quotient by zero is *undefined*, and so is everything computed from it. Like a float's NaN, it equals
/// nothing, not even itself; so no equality can rest on a division by zero.
///
/// ```
/// use tumbling_proofs::Rational;
/// let third = Rational::new(1, 3);
/// assert_eq!(third.clone() + third.clone() + third.clone(), Rational::from(1));
/// assert_eq!(third.to_string(), "1/3");
/// assert!(Rational::new(1, 0).is_undefined());
/// assert_ne!(Rational::new(1, 0), Rational::new(1, 0));
/// ```
#[derive(Debug, Clone)]
pub struct Rational(Option<BigRational>);

impl Rational {
    /// The fraction `numerator / denominator`; undefined if that divides by zero.
    #[must_use]
    pub fn new(numerator: i64, denominator: i64) -> Self {
        Self::from(numerator) / Self::from(denominator)
    }

    /// The exact value of a float; undefined if that is infinite or not a number.
    ///
    /// ```
    /// use tumbling_proofs::Rational;
    /// assert_eq!(Rational::of_f64(0.375), Rational::new(3, 8));
    /// assert_ne!(Rational::of_f64(0.1), Rational::new(1, 10));
    /// ```
    #[must_use]
    pub fn of_f64(x: f64) -> Self {
        Self(BigRational::from_float(x))
    }

    /// A decimal such as `-12`, `0.4167` or `2.5e-3`, taken exactly; `None` if it is not one, or if its power
    /// of ten is beyond a thousand.
    ///
    /// ```
    /// use tumbling_proofs::Rational;
    /// assert_eq!(Rational::of_decimal("0.4167"), Some(Rational::new(4167, 10_000)));
    /// assert_eq!(Rational::of_decimal("-2.5e3"), Some(Rational::from(-2500)));
    /// assert_eq!(Rational::of_decimal("2,5"), None);
    /// ```
    #[must_use]
    pub fn of_decimal(text: &str) -> Option<Self> {
        let (mantissa, power) = match text.split_once(['e', 'E']) {
            Some((mantissa, power)) => (mantissa, power.parse::<i64>().ok()?),
            None => (text, 0),
        };
        let (sign, digits) = match mantissa.strip_prefix('-') {
            Some(rest) => (-1, rest),
            None => (1, mantissa),
        };
        let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
        let all = format!("{whole}{decimals}");
        if all.is_empty() || !all.bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        let power = power - i64::try_from(decimals.len()).ok()?;
        if !(-1000..=1000).contains(&power) {
            return None;
        }
        let ten = BigInt::from(10).pow(u32::try_from(power.unsigned_abs()).ok()?);
        let digits = all.parse::<BigInt>().ok()? * sign;
        let value = if power < 0 { BigRational::new(digits, ten) } else { BigRational::from(digits * ten) };
        Some(value.into())
    }

    /// A literal of Rust, for [`given!`](crate::given): undefined if it is no decimal.
    #[doc(hidden)]
    #[must_use]
    pub fn of_literal(text: &str) -> Self {
        let plain: String = text.chars().filter(|c| !matches!(c, '_' | ' ')).collect();
        Self::of_decimal(plain.trim_end_matches('.')).unwrap_or(Self(None))
    }

    /// Whether it is the result of a division by zero.
    #[must_use]
    pub fn is_undefined(&self) -> bool {
        self.0.is_none()
    }

    /// The value, unless undefined.
    #[must_use]
    pub fn value(&self) -> Option<&BigRational> {
        self.0.as_ref()
    }

    /// The nearest float; not a number if undefined, infinite if too large.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.value().and_then(ToPrimitive::to_f64).unwrap_or(f64::NAN)
    }

    /// The square root that is not below zero, if it is a fraction.
    ///
    /// ```
    /// use tumbling_proofs::Rational;
    /// assert_eq!(Rational::new(9, 16).root(), Some(Rational::new(3, 4)));
    /// assert_eq!(Rational::from(2).root(), None);
    /// ```
    #[must_use]
    pub fn root(&self) -> Option<Self> {
        let value = self.value().filter(|value| !value.is_negative())?;
        let root = BigRational::new(value.numer().sqrt(), value.denom().sqrt());
        (&root * &root == *value).then_some(Self(Some(root)))
    }

    fn with(&self, other: &Self, f: impl Fn(&BigRational, &BigRational) -> Option<BigRational>) -> Self {
        Self(self.value().zip(other.value()).and_then(|(a, b)| f(a, b)))
    }

    fn sum(&self, other: &Self) -> Self {
        self.with(other, |a, b| Some(a + b))
    }

    fn difference(&self, other: &Self) -> Self {
        self.with(other, |a, b| Some(a - b))
    }

    fn product(&self, other: &Self) -> Self {
        self.with(other, |a, b| Some(a * b))
    }

    fn quotient(&self, other: &Self) -> Self {
        self.with(other, |a, b| (!b.is_zero()).then(|| a / b))
    }
}

operator!(Rational: Add add AddAssign add_assign = Rational::sum);
operator!(Rational: Sub sub SubAssign sub_assign = Rational::difference);
operator!(Rational: Mul mul MulAssign mul_assign = Rational::product);
operator!(Rational: Div div DivAssign div_assign = Rational::quotient);

from! {
    Rational, i64: |n| BigRational::from(BigInt::from(n)).into();
    Rational, BigRational: |value| Self(Some(value));
}

constants!(Rational: |x| x.value().is_some_and(Zero::is_zero), |x| Self(x.0.map(std::ops::Neg::neg)));

impl PartialEq for Rational {
    fn eq(&self, other: &Self) -> bool {
        self.value().zip(other.value()).is_some_and(|(a, b)| a == b)
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.value().zip(other.value()).map(|(a, b)| a.cmp(b))
    }
}

/// As a fraction, `3/23`; with a precision as a decimal, `0.1304`, rounded to the nearest, half to even.
impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.value(), f.precision()) {
            (Some(value), Some(digits)) => f.write_str(&decimal(value, digits)),
            (Some(value), None) => write!(f, "{value}"),
            (None, _) => f.write_str("undefined"),
        }
    }
}

/// With this many decimals; zero has no sign.
fn decimal(value: &BigRational, digits: usize) -> String {
    let scale = (0..digits).fold(BigInt::one(), |power, _| power * 10);
    let (numerator, denominator) = (value.numer().abs() * scale, value.denom());
    let (mut whole, left) = (&numerator / denominator, &numerator % denominator);
    let twice = left * 2;
    if twice > *denominator || (twice == *denominator && (&whole % 2) == BigInt::one()) {
        whole += 1;
    }
    let sign = if value.is_negative() && !whole.is_zero() { "-" } else { "" };
    let all = format!("{whole:0>width$}", width = digits + 1, whole = whole.to_string());
    let (before, after) = all.split_at(all.len() - digits);
    if digits == 0 { format!("{sign}{before}") } else { format!("{sign}{before}.{after}") }
}
