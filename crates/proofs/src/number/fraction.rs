//! Quotients of polynomials: the field in which every law of the library can run.

use super::monomial::Monomial;
use super::ops::{constants, from, operator};
use super::polynomial::Polynomial;
use super::rational::Rational;
use super::symbol::Symbol;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::collections::BTreeSet;
use std::fmt;
use tumbling::number::Field;

/// A quotient of two polynomials, a rational function. Equality is decided, by cross multiplication.
///
/// Division by zero gives the *undefined* fraction. Everything computed from it is undefined too, and like a
/// float's NaN it equals nothing, not even itself.
///
/// Powers of variables are cancelled, and so is the denominator where it divides the numerator or is divided
/// by it. Other common factors may remain, which changes the printed form but not equality.
///
/// ```
/// use tumbling_proofs::Fraction;
/// let [a, b] = ["a", "b"].map(Fraction::variable);
/// let sum = Fraction::from(1) / a.clone() + Fraction::from(1) / b.clone();
/// assert_eq!(sum, (a.clone() + b.clone()) / (a.clone() * b.clone()));
/// assert_eq!(sum.to_string(), "(a + b) / (a b)");
/// assert!((a.clone() / (a.clone() - a)).is_undefined());
/// ```
#[derive(Debug, Clone)]
pub struct Fraction {
    numerator: Polynomial,
    /// Whole coefficients without common factor, the first positive; 1 where the numerator is zero; zero
    /// itself where the fraction is undefined.
    denominator: Polynomial,
}

impl Fraction {
    /// The variable of this name.
    #[must_use]
    pub fn variable(name: &str) -> Self {
        Polynomial::variable(name).into()
    }

    /// The number `n / d`; undefined if that divides by zero.
    #[must_use]
    pub fn ratio(n: i64, d: i64) -> Self {
        Self::from(n) / Self::from(d)
    }

    /// The quotient; undefined if `denominator` is zero.
    #[must_use]
    pub fn new(numerator: Polynomial, denominator: Polynomial) -> Self {
        if denominator.is_zero() {
            return Self { numerator: Polynomial::one(), denominator };
        }
        if denominator.is_one() {
            return numerator.into();
        }
        if numerator.is_zero() {
            return numerator.into();
        }
        let common = numerator.common_monomial().gcd(&denominator.common_monomial());
        let content = denominator.content();
        let (mut n, mut d) = (without(&numerator, &common), without(&denominator, &common));
        n = n.scaled(&content.recip());
        d = d.scaled(&content.recip());
        if let Some(whole) = n.exact_quotient(&d) {
            return whole.into();
        }
        if let Some(rest) = d.exact_quotient(&n) {
            let content = rest.content();
            n = content.recip().into();
            d = rest.scaled(&content.recip());
        }
        Self { numerator: n, denominator: d }
    }

    /// Above the line.
    #[must_use]
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// Below the line; zero if undefined.
    #[must_use]
    pub fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// Whether it is the result of a division by zero.
    #[must_use]
    pub fn is_undefined(&self) -> bool {
        self.denominator.is_zero()
    }

    /// As a polynomial, if it is one.
    #[must_use]
    pub fn as_polynomial(&self) -> Option<&Polynomial> {
        self.denominator.is_one().then_some(&self.numerator)
    }

    /// Its value, if no variable is left in it.
    #[must_use]
    pub fn as_constant(&self) -> Option<BigRational> {
        self.as_polynomial()?.as_constant()
    }

    /// The variables that occur in it.
    #[must_use]
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        &self.numerator.symbols() | &self.denominator.symbols()
    }

    /// The `n`-th power.
    ///
    /// # Panics
    /// If a power of a variable exceeds 4 294 967 295.
    #[must_use]
    pub fn pow(&self, n: u32) -> Self {
        if self.is_undefined() {
            return self.clone();
        }
        let (numerator, denominator) = (self.numerator.pow(n), self.denominator.pow(n));
        Self { numerator, denominator }
    }

    /// The partial derivative by `symbol`.
    ///
    /// ```
    /// use tumbling_proofs::Fraction;
    /// let x = Fraction::variable("x");
    /// let inverse = Fraction::from(1) / x.clone();
    /// assert_eq!(inverse.derivative(&"x".into()), Fraction::from(-1) / (x.clone() * x));
    /// ```
    #[must_use]
    pub fn derivative(&self, symbol: &Symbol) -> Self {
        let (n, d) = (&self.numerator, &self.denominator);
        let (n_rate, d_rate) = (n.derivative(symbol), d.derivative(symbol));
        if d_rate.is_zero() && !d.is_zero() {
            Self::new(n_rate, d.clone())
        } else {
            Self::new(n_rate * d - n * &d_rate, d * d)
        }
    }

    /// This with `value` put for `symbol`; undefined where that divides by zero.
    #[must_use]
    pub fn substitute(&self, symbol: &Symbol, value: &Self) -> Self {
        let put = |p: &Polynomial| {
            let parts = p.in_powers_of(symbol);
            parts.into_iter().rev().fold(Self::zero(), |sum, part| sum * value + Self::from(part))
        };
        if self.is_undefined() {
            return self.clone();
        }
        put(&self.numerator) / put(&self.denominator)
    }

    /// Its value in any number system, given those of its variables; `None` if one is not given.
    pub fn evaluate<T: Field>(&self, value: impl Fn(&Symbol) -> Option<T>) -> Option<T> {
        let numerator = self.numerator.evaluate(&value)?;
        if self.denominator.is_one() {
            return Some(numerator);
        }
        Some(numerator / self.denominator.evaluate(&value)?)
    }

    /// Its exact value where every variable is a number, by name; undefined if one is missing or the
    /// denominator vanishes there.
    ///
    /// ```
    /// use tumbling_proofs::{Fraction, Rational};
    /// let [a, b] = ["a", "b"].map(Fraction::variable);
    /// let at = |a, b| [("a", Rational::from(a)), ("b", Rational::from(b))];
    /// assert_eq!((a.clone() / b.clone()).at(&at(3, 23)), Rational::new(3, 23));
    /// assert!((a / b).at(&at(3, 0)).is_undefined());
    /// ```
    #[must_use]
    pub fn at(&self, values: &[(&str, Rational)]) -> Rational {
        self.numerator.at(values) / self.denominator.at(values)
    }

    fn combined(&self, other: &Self, f: impl Fn(&Polynomial, &Polynomial) -> Polynomial) -> Self {
        if self.denominator == other.denominator {
            return Self::new(f(&self.numerator, &other.numerator), self.denominator.clone());
        }
        let (a, b) = (&self.denominator, &other.denominator);
        if a.is_zero() || b.is_zero() {
            return Self::new(Polynomial::one(), Polynomial::zero());
        }
        let common = common_multiple(a, b);
        let Some((by, other_by)) = common.exact_quotient(a).zip(common.exact_quotient(b)) else {
            return Self::new(Polynomial::one(), Polynomial::zero()); // Not a multiple: never to be believed.
        };
        Self::new(f(&(&self.numerator * &by), &(&other.numerator * &other_by)), common)
    }

    fn sum(&self, other: &Self) -> Self {
        self.combined(other, |a, b| a + b)
    }

    fn difference(&self, other: &Self) -> Self {
        self.combined(other, |a, b| a - b)
    }

    fn product(&self, other: &Self) -> Self {
        if self.denominator.is_one() && other.denominator.is_one() {
            return (&self.numerator * &other.numerator).into();
        }
        // Cancelled crosswise first: fractions in lowest terms stay so, and products stay small.
        let left = Self::new(self.numerator.clone(), other.denominator.clone());
        let right = Self::new(other.numerator.clone(), self.denominator.clone());
        Self::new(left.numerator * right.numerator, left.denominator * right.denominator)
    }

    fn quotient(&self, other: &Self) -> Self {
        if other.is_undefined() {
            return other.clone();
        }
        let inverse = Self::new(other.denominator.clone(), other.numerator.clone());
        self.product(&inverse)
    }
}

/// `p` over a monomial that divides it.
fn without(p: &Polynomial, monomial: &Monomial) -> Polynomial {
    if monomial.is_unit() {
        return p.clone();
    }
    let mut rest = Polynomial::zero();
    for (m, c) in p.terms() {
        if let Some(m) = m.divided_by(monomial) {
            rest.add_term(m, c.clone());
        }
    }
    rest
}

/// A multiple of both: of their monomials the smallest, of the rest the larger if the other divides it.
fn common_multiple(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let (m, n) = (a.common_monomial(), b.common_monomial());
    let (p, q) = (without(a, &m), without(b, &n));
    let rest = if p.exact_quotient(&q).is_some() {
        p
    } else if q.exact_quotient(&p).is_some() {
        q
    } else {
        p * q
    };
    rest.times_monomial(&m.lcm(&n))
}

operator!(Fraction: Add add AddAssign add_assign = Fraction::sum);
operator!(Fraction: Sub sub SubAssign sub_assign = Fraction::difference);
operator!(Fraction: Mul mul MulAssign mul_assign = Fraction::product);
operator!(Fraction: Div div DivAssign div_assign = Fraction::quotient);

constants!(Fraction:
    |x| x.numerator.is_zero() && !x.is_undefined(),
    |x| Self { numerator: -x.numerator, ..x }
);

impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        if self.is_undefined() || other.is_undefined() {
            return false;
        }
        if self.denominator == other.denominator {
            return self.numerator == other.numerator;
        }
        &self.numerator * &other.denominator == &other.numerator * &self.denominator
    }
}

from! {
    Fraction, Polynomial: |numerator| Self { numerator, denominator: Polynomial::one() };
    Fraction, Symbol: |symbol| Polynomial::from(symbol).into();
    Fraction, i64: |n| Polynomial::from(n).into();
    Fraction, Rational: |x| Polynomial::constant(&x).map_or_else(|| Self::ratio(1, 0), Self::from);
}

impl tumbling::laws::Series for Fraction {}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_undefined() {
            return f.pad("undefined");
        }
        if let Some(whole) = self.as_polynomial() {
            return whole.fmt(f);
        }
        let above = |p: &Polynomial| if p.len() > 1 { format!("({p})") } else { p.to_string() };
        let below = |p: &Polynomial| {
            let bare = p.len() == 1 && p.degree() == 1 && p.content().is_one();
            if bare { p.to_string() } else { format!("({p})") }
        };
        f.pad(&format!("{} / {}", above(&self.numerator), below(&self.denominator)))
    }
}
