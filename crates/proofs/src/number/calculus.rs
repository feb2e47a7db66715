//! Calculus and values of polynomials: derivative, integral, substitution, evaluation.

use super::monomial::Monomial;
use super::polynomial::Polynomial;
use super::rational::Rational;
use super::symbol::Symbol;
use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::{One, Zero};
use tumbling::number::Field;

impl Polynomial {
    /// The partial derivative by `symbol`.
    ///
    /// ```
    /// use tumbling_proofs::Polynomial;
    /// let [x, y] = ["x", "y"].map(Polynomial::variable);
    /// assert_eq!((x.pow(3) * y.clone()).derivative(&"x".into()), x.pow(2) * y * Polynomial::from(3));
    /// ```
    #[must_use]
    pub fn derivative(&self, symbol: &Symbol) -> Self {
        let mut sum = Self::zero();
        for (monomial, coefficient) in self.terms() {
            let power = monomial.degree_in(symbol);
            if power > 0 {
                let lower = monomial.without(symbol).times(&Monomial::power(symbol.clone(), power - 1));
                sum.add_term(lower, coefficient * BigRational::from(BigInt::from(power)));
            }
        }
        sum
    }

    /// The integral over `symbol` from 0 to `symbol`.
    ///
    /// # Panics
    /// If a power exceeds 4 294 967 295.
    #[must_use]
    pub fn antiderivative(&self, symbol: &Symbol) -> Self {
        let once = Monomial::power(symbol.clone(), 1);
        let mut sum = Self::zero();
        for (monomial, coefficient) in self.terms() {
            let raised = monomial.times(&once);
            let power = BigRational::from(BigInt::from(raised.degree_in(symbol)));
            sum.add_term(raised, coefficient / power);
        }
        sum
    }

    /// The integral over `symbol` between two limits, which may contain other variables.
    ///
    /// ```
    /// use tumbling_proofs::Polynomial;
    /// let [x, a] = ["x", "a"].map(Polynomial::variable);
    /// let area = x.pow(2).integral(&"x".into(), &-a.clone(), &a);
    /// assert_eq!(area.to_string(), "2/3 a^3");
    /// ```
    #[must_use]
    pub fn integral(&self, symbol: &Symbol, from: &Self, to: &Self) -> Self {
        let whole = self.antiderivative(symbol);
        whole.substitute(symbol, to) - whole.substitute(symbol, from)
    }

    /// This with `value` put for `symbol`.
    ///
    /// ```
    /// use tumbling_proofs::Polynomial;
    /// let [x, y] = ["x", "y"].map(Polynomial::variable);
    /// let square = x.pow(2).substitute(&"x".into(), &(x + y));
    /// assert_eq!(square.to_string(), "x^2 + 2 x y + y^2");
    /// ```
    #[must_use]
    pub fn substitute(&self, symbol: &Symbol, value: &Self) -> Self {
        // Horner's rule, highest power first.
        let parts = self.in_powers_of(symbol);
        parts.iter().rev().fold(Self::zero(), |sum, part| sum * value + part)
    }

    /// Its value in any number system, given those of its variables; `None` if one is not given.
    ///
    /// ```
    /// use tumbling_proofs::{Polynomial, Rational};
    /// let p = Polynomial::variable("x").pow(2) + Polynomial::from(1);
    /// assert_eq!(p.evaluate(|_| Some(3.0)), Some(10.0));
    /// assert_eq!(p.evaluate(|_| Some(Rational::new(1, 2))), Some(Rational::new(5, 4)));
    /// ```
    pub fn evaluate<T: Field>(&self, value: impl Fn(&Symbol) -> Option<T>) -> Option<T> {
        let mut sum = T::zero();
        for (monomial, coefficient) in self.terms() {
            let mut term = in_field::<T>(coefficient);
            for (symbol, power) in monomial.powers() {
                term *= num_traits::pow(value(symbol)?, power as usize);
            }
            sum += term;
        }
        Some(sum)
    }

    /// Its exact value where every variable is a number, by name; undefined if one is missing.
    #[must_use]
    pub fn at(&self, values: &[(&str, Rational)]) -> Rational {
        let look_up = |s: &Symbol| values.iter().find(|(name, _)| *name == s.name()).map(|(_, v)| v.clone());
        self.evaluate(look_up).unwrap_or_else(|| Rational::new(0, 0))
    }
}

/// An exact fraction in any field, by doubling and adding 1.
pub(super) fn in_field<T: Field>(value: &BigRational) -> T {
    let whole = |n: &BigInt| {
        let mut sum = T::zero();
        for bit in (0..n.bits()).rev() {
            sum += sum.clone();
            if n.magnitude().bit(bit) {
                sum += T::one();
            }
        }
        if n.sign() == Sign::Minus { -sum } else { sum }
    };
    if value.denom().is_one() { whole(value.numer()) } else { whole(value.numer()) / whole(value.denom()) }
}
