//! Power series in a step size, cut off after some power: how the order of an integrator is found.

use super::ops::operator;
use num_traits::{One, Zero};
use std::fmt;
use std::ops::Neg;
use tumbling::number::Field;

/// A power series `a0 + a1 h + a2 h^2 + ...` over any field, known up to some power of `h`.
///
/// A result is known as far as its operands determine it: the sum of a series known to `h^2` and one known to
/// `h^5` is known to `h^2`. Plain numbers, which do not contain `h`, are known to every power. Two series are
/// equal if they agree in all powers to which both are known.
///
/// A quotient needs a divisor with `a0` not zero. By any other divisor it is *undefined*: it is known to no
/// power and, like a float's NaN, equals nothing, not even itself.
///
/// ```
/// use tumbling_proofs::{Rational, Series};
/// let h = Series::<Rational>::step(4);
/// let one = Series::constant(Rational::from(1));
/// let geometric = one.clone() / (one - h);
/// assert_eq!(geometric.to_string(), "1 + h + h^2 + h^3 + h^4 + ...");
/// ```
#[derive(Debug, Clone)]
pub struct Series<T> {
    /// One for each known power; of an exact series those that are not zero, and perhaps some that are.
    coefficients: Vec<T>,
    /// How many powers are known: `None` if all are, `Some(0)` if undefined.
    known: Option<usize>,
}

impl<T: Field> Series<T> {
    /// The number `value`, known to every power.
    #[must_use]
    pub fn constant(value: T) -> Self {
        Self { coefficients: vec![value], known: None }
    }

    /// The step `h` itself, in a computation to be followed up to the power `order`.
    #[must_use]
    pub fn step(order: usize) -> Self {
        Self::new(vec![T::zero(), T::one()], order)
    }

    /// The series with these coefficients, the rest zero, known up to the power `order`.
    #[must_use]
    pub fn new(mut coefficients: Vec<T>, order: usize) -> Self {
        coefficients.truncate(order + 1);
        Self { coefficients, known: Some(order + 1) }
    }

    /// The highest power to which it is known; `None` if to all, or to none because it is undefined.
    #[must_use]
    pub fn order(&self) -> Option<usize> {
        self.known.and_then(|known| known.checked_sub(1))
    }

    /// Whether it is the quotient by a series without constant term.
    #[must_use]
    pub fn is_undefined(&self) -> bool {
        self.known == Some(0)
    }

    /// The coefficient of the `power`-th power of the step; `None` where it is not known.
    #[must_use]
    pub fn coefficient(&self, power: usize) -> Option<T> {
        if self.known.is_some_and(|known| power >= known) {
            return None;
        }
        Some(self.at(power))
    }

    /// The integral from 0 to the step, known to one more power.
    ///
    /// ```
    /// use tumbling_proofs::{Rational, Series};
    /// let h = Series::<Rational>::step(2);
    /// assert_eq!((h.clone() * h).integral().to_string(), "1/3 h^3 + ...");
    /// ```
    #[must_use]
    pub fn integral(&self) -> Self {
        if self.is_undefined() {
            return self.clone();
        }
        let mut coefficients = vec![T::zero()];
        let mut power = T::zero();
        for a in &self.coefficients {
            power += T::one();
            coefficients.push(a.clone() / power.clone());
        }
        Self { coefficients, known: self.known.map(|known| known + 1) }
    }

    /// This known only up to the power `order`.
    #[must_use]
    pub fn cut(&self, order: usize) -> Self {
        let known = self.known.map_or(order + 1, |known| known.min(order + 1));
        let mut coefficients = self.coefficients.clone();
        coefficients.truncate(known);
        Self { coefficients, known: Some(known) }
    }

    fn at(&self, power: usize) -> T {
        self.coefficients.get(power).cloned().unwrap_or_else(T::zero)
    }

    fn both_known(&self, other: &Self) -> Option<usize> {
        [self.known, other.known].into_iter().flatten().min()
    }

    fn combined(&self, other: &Self, count: usize, at: impl Fn(usize) -> T) -> Self {
        let known = self.both_known(other);
        let count = known.map_or(count, |known| known.min(count));
        Self { coefficients: (0..count).map(at).collect(), known }
    }

    fn sum(&self, other: &Self) -> Self {
        let count = self.coefficients.len().max(other.coefficients.len());
        self.combined(other, count, |n| self.at(n) + other.at(n))
    }

    fn difference(&self, other: &Self) -> Self {
        let count = self.coefficients.len().max(other.coefficients.len());
        self.combined(other, count, |n| self.at(n) - other.at(n))
    }

    fn product(&self, other: &Self) -> Self {
        let (a, b) = (&self.coefficients, &other.coefficients);
        let count = (a.len() + b.len()).saturating_sub(1);
        self.combined(other, count, |n| {
            let mut sum = T::zero();
            for (i, x) in a.iter().enumerate().take(n + 1) {
                if let Some(y) = b.get(n - i).filter(|y| !y.is_zero() && !x.is_zero()) {
                    sum += x.clone() * y.clone();
                }
            }
            sum
        })
    }

    fn quotient(&self, other: &Self) -> Self {
        let undefined = Self { coefficients: Vec::new(), known: Some(0) };
        let first = other.at(0);
        if first.is_zero() || self.is_undefined() || other.is_undefined() {
            return undefined;
        }
        let plain = other.coefficients.iter().skip(1).all(Zero::is_zero);
        let known = self.both_known(other);
        let count = match known {
            Some(known) => known,
            None if plain => self.coefficients.len(),
            // The quotient of two exact series has no last power: nothing determines where to stop.
            None => return undefined,
        };
        let mut coefficients: Vec<T> = Vec::with_capacity(count);
        for n in 0..count {
            let mut rest = self.at(n);
            for i in 1..=n {
                rest -= other.at(i) * coefficients[n - i].clone();
            }
            coefficients.push(rest / first.clone());
        }
        Self { coefficients, known }
    }
}

operator!(Series: Add add AddAssign add_assign = Series::sum where T: Field);
operator!(Series: Sub sub SubAssign sub_assign = Series::difference where T: Field);
operator!(Series: Mul mul MulAssign mul_assign = Series::product where T: Field);
operator!(Series: Div div DivAssign div_assign = Series::quotient where T: Field);

impl<T: Field> Neg for Series<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { coefficients: self.coefficients.into_iter().map(Neg::neg).collect(), known: self.known }
    }
}

impl<T: Field> Zero for Series<T> {
    fn zero() -> Self {
        Self { coefficients: Vec::new(), known: None }
    }
    fn is_zero(&self) -> bool {
        !self.is_undefined() && self.coefficients.iter().all(Zero::is_zero)
    }
}

impl<T: Field> One for Series<T> {
    fn one() -> Self {
        Self::constant(T::one())
    }
}

impl<T: Field> PartialEq for Series<T> {
    fn eq(&self, other: &Self) -> bool {
        // Not by the difference alone: an undefined coefficient is equal to nothing.
        let count = self.coefficients.len().max(other.coefficients.len());
        let known = |series: &Self, n: usize| series.known.is_none_or(|known| n < known);
        let both = |n: &usize| known(self, *n) && known(other, *n);
        !self.is_undefined()
            && !other.is_undefined()
            && (0..count).filter(both).all(|n| self.at(n) == other.at(n))
    }
}

impl<T: Field + fmt::Display> fmt::Display for Series<T> {
    /// The terms joined by their signs, coefficients that are sums in brackets.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut all = String::new();
        let mut add = |term: &str| {
            all += &match term.strip_prefix('-') {
                Some(rest) if !all.is_empty() => format!(" - {rest}"),
                _ if !all.is_empty() => format!(" + {term}"),
                _ => term.to_owned(),
            };
        };
        for (power, a) in self.coefficients.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
            let text = a.to_string();
            let sum = power > 0 && (text.contains(" + ") || text.contains(" - "));
            let text = if sum { format!("({text})") } else { text };
            let h = if power == 1 { "h".to_owned() } else { format!("h^{power}") };
            add(&match (power, a.is_one()) {
                (0, _) => text,
                (_, true) => h,
                (_, false) => format!("{text} {h}"),
            });
        }
        if self.known.is_some() {
            add("...");
        }
        f.pad(match all.as_str() {
            _ if self.is_undefined() => "undefined",
            "" => "0",
            terms => terms,
        })
    }
}
