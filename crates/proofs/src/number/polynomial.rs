//! Polynomials in named variables over exact rationals, in canonical form.

use super::monomial::Monomial;
use super::ops::{constants, from, operator};
use super::rational::Rational;
use super::symbol::Symbol;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// A polynomial in any number of named variables, with exact rational coefficients.
///
/// Polynomials are expanded, with like terms collected and no zero coefficient: two of them are the same
/// function exactly if they are equal values. So whether an identity holds for all values of its variables is
/// computed.
///
/// ```
/// use tumbling_proofs::Polynomial;
/// let [a, b] = ["a", "b"].map(Polynomial::variable);
/// let square = (a.clone() + b.clone()).pow(2);
/// assert_eq!(square.to_string(), "a^2 + 2 a b + b^2");
/// assert_eq!(square - (a.clone() - b.clone()).pow(2), a * b * Polynomial::from(4));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Polynomial {
    /// No coefficient is zero.
    terms: BTreeMap<Monomial, BigRational>,
}

impl Polynomial {
    /// The variable of this name.
    #[must_use]
    pub fn variable(name: &str) -> Self {
        Symbol::new(name).into()
    }

    /// The constant `n / d`, `None` if `d` is zero.
    #[must_use]
    pub fn constant(value: &Rational) -> Option<Self> {
        value.value().cloned().map(Self::from)
    }

    /// `coefficient` times `monomial`.
    #[must_use]
    pub fn term(monomial: Monomial, coefficient: BigRational) -> Self {
        let mut sum = Self { terms: BTreeMap::new() };
        sum.add_term(monomial, coefficient);
        sum
    }

    /// Its terms, largest monomial first.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, &BigRational)> {
        self.terms.iter().rev()
    }

    /// How many terms it has.
    #[must_use]
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether it has no terms: whether it is zero.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// The coefficient of a monomial.
    #[must_use]
    pub fn coefficient(&self, monomial: &Monomial) -> BigRational {
        self.terms.get(monomial).cloned().unwrap_or_else(BigRational::zero)
    }

    /// The largest sum of powers in a term; 0 for constants, zero among them.
    #[must_use]
    pub fn degree(&self) -> u64 {
        self.terms.last_key_value().map_or(0, |(monomial, _)| monomial.degree())
    }

    /// The largest power of `symbol`.
    #[must_use]
    pub fn degree_in(&self, symbol: &Symbol) -> u32 {
        self.terms.keys().map(|monomial| monomial.degree_in(symbol)).max().unwrap_or(0)
    }

    /// The variables that occur in it.
    #[must_use]
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        self.terms.keys().flat_map(|monomial| monomial.powers().map(|(symbol, _)| symbol.clone())).collect()
    }

    /// Its value, if no variable occurs in it.
    #[must_use]
    pub fn as_constant(&self) -> Option<BigRational> {
        match self.terms.len() {
            0 => Some(BigRational::zero()),
            1 => self.terms.get(&Monomial::default()).cloned(),
            _ => None,
        }
    }

    /// As a polynomial in `symbol` alone: the coefficients of its powers 0, 1, 2, ..., none of which
    /// contains it.
    ///
    /// ```
    /// use tumbling_proofs::{Polynomial, Symbol};
    /// let [x, y] = ["x", "y"].map(Polynomial::variable);
    /// let p = x.clone() * x.clone() * y.clone() + x.clone() * y.clone() + x;
    /// assert_eq!(p.in_powers_of(&"x".into()), [Polynomial::from(0), y.clone() + Polynomial::from(1), y]);
    /// ```
    #[must_use]
    pub fn in_powers_of(&self, symbol: &Symbol) -> Vec<Self> {
        let mut parts = vec![Self::zero(); self.degree_in(symbol) as usize + 1];
        for (monomial, coefficient) in &self.terms {
            let power = monomial.degree_in(symbol) as usize;
            parts[power].add_term(monomial.without(symbol), coefficient.clone());
        }
        parts
    }

    /// The common sign of all its coefficients: `Some(1)` or `Some(-1)`; `None` if they differ or there are
    /// none. This is its sign wherever all its variables are positive.
    ///
    /// ```
    /// use tumbling_proofs::Polynomial;
    /// let [a, b] = ["a", "b"].map(Polynomial::variable);
    /// assert_eq!((a.clone() * b.clone() + b.clone()).common_sign(), Some(1));
    /// assert_eq!((-a.clone()).common_sign(), Some(-1));
    /// assert_eq!((a - b).common_sign(), None);
    /// ```
    #[must_use]
    pub fn common_sign(&self) -> Option<i32> {
        let mut signs = self.terms.values().map(|c| if c.is_negative() { -1 } else { 1 });
        let first = signs.next()?;
        signs.all(|sign| sign == first).then_some(first)
    }

    /// The `n`-th power.
    ///
    /// # Panics
    /// As the product: if a power of a variable exceeds 4 294 967 295.
    #[must_use]
    pub fn pow(&self, n: u32) -> Self {
        num_traits::pow(self.clone(), n as usize)
    }

    /// The quotient, if `divisor` divides this without remainder.
    ///
    /// ```
    /// use tumbling_proofs::Polynomial;
    /// let [a, b] = ["a", "b"].map(Polynomial::variable);
    /// let difference = a.pow(3) - b.pow(3);
    /// let quotient = difference.exact_quotient(&(a.clone() - b.clone()));
    /// assert_eq!(quotient.map(|q| q.to_string()).as_deref(), Some("a^2 + a b + b^2"));
    /// assert_eq!(difference.exact_quotient(&(a + b)), None);
    /// ```
    #[must_use]
    pub fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        let (lead, by) = divisor.terms.last_key_value()?;
        let fits = |s: &Symbol| divisor.degree_in(s) <= self.degree_in(s);
        if !self.is_empty() && !divisor.symbols().iter().all(fits) {
            return None;
        }
        let (mut rest, mut quotient) = (self.clone(), Self::zero());
        while let Some((monomial, coefficient)) = rest.terms.last_key_value() {
            // The largest term of a product is the product of the largest terms.
            let factor = monomial.divided_by(lead)?;
            let coefficient = coefficient / by;
            for (m, c) in &divisor.terms {
                rest.add_term(m.times(&factor), -(c * &coefficient));
            }
            quotient.add_term(factor, coefficient);
        }
        Some(quotient)
    }

    /// The largest monomial that divides every term; 1 for zero.
    #[must_use]
    pub fn common_monomial(&self) -> Monomial {
        let mut all = self.terms.keys();
        let first = all.next().cloned().unwrap_or_default();
        all.fold(first, |common, monomial| common.gcd(monomial))
    }

    /// The rational number by which to divide so that the coefficients are whole, without a common factor,
    /// and the first of them positive; 1 for zero.
    #[must_use]
    pub fn content(&self) -> BigRational {
        let numerators = self.terms.values().fold(BigInt::zero(), |all, c| all.gcd(c.numer()));
        match self.terms.last_key_value() {
            None => BigRational::one(),
            Some((_, first)) => BigRational::new(numerators, self.denominator()) * first.signum(),
        }
    }

    /// This times a number.
    #[must_use]
    pub fn scaled(&self, factor: &BigRational) -> Self {
        if factor.is_zero() {
            return Self::zero();
        }
        Self { terms: self.terms.iter().map(|(m, c)| (m.clone(), c * factor)).collect() }
    }

    /// This times a monomial.
    #[must_use]
    pub fn times_monomial(&self, factor: &Monomial) -> Self {
        Self { terms: self.terms.iter().map(|(m, c)| (m.times(factor), c.clone())).collect() }
    }

    /// Adds one term, gathered with the like one if there is one.
    pub(super) fn add_term(&mut self, monomial: Monomial, coefficient: BigRational) {
        use std::collections::btree_map::Entry;
        match self.terms.entry(monomial) {
            Entry::Vacant(place) => {
                if !coefficient.is_zero() {
                    place.insert(coefficient);
                }
            }
            Entry::Occupied(mut place) => {
                *place.get_mut() += coefficient;
                if place.get().is_zero() {
                    place.remove();
                }
            }
        }
    }

    fn sum(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (monomial, coefficient) in &other.terms {
            sum.add_term(monomial.clone(), coefficient.clone());
        }
        sum
    }

    fn difference(&self, other: &Self) -> Self {
        self.sum(&-other.clone())
    }

    /// The least one that is common to its coefficients.
    fn denominator(&self) -> BigInt {
        self.terms.values().fold(BigInt::one(), |below, c| below.lcm(c.denom()))
    }

    /// In whole numbers, because reducing the fraction of each product of two terms would take most of the
    /// time.
    fn product(&self, other: &Self) -> Self {
        let [(a, below), (b, others_below)] = [self, other].map(|p| {
            let below = p.denominator();
            let whole = p.terms.iter().map(|(m, c)| (m, c.numer() * (&below / c.denom())));
            (whole.collect::<Vec<_>>(), below)
        });
        let (below, mut sums) = (below * others_below, BTreeMap::<_, BigInt>::new());
        for (m, a) in &a {
            b.iter().for_each(|(n, b)| *sums.entry(m.times(n)).or_default() += a * b);
        }
        sums.retain(|_, sum| !sum.is_zero());
        Self { terms: sums.into_iter().map(|(m, c)| (m, BigRational::new(c, below.clone()))).collect() }
    }
}

operator!(Polynomial: Add add AddAssign add_assign = Polynomial::sum);
operator!(Polynomial: Sub sub SubAssign sub_assign = Polynomial::difference);
operator!(Polynomial: Mul mul MulAssign mul_assign = Polynomial::product);

from! {
    Polynomial, Symbol: |symbol| Self::term(Monomial::power(symbol, 1), BigRational::one());
    Polynomial, i64: |n| BigRational::from(BigInt::from(n)).into();
    Polynomial, BigRational: |value| Self::term(Monomial::default(), value);
}

constants!(Polynomial: |p| p.is_empty(), |p| {
    Self { terms: p.terms.into_iter().map(|(m, c)| (m, -c)).collect() }
});

impl fmt::Display for Polynomial {
    /// The largest terms first, without coefficients and powers of 1.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = String::new();
        for (monomial, coefficient) in self.terms() {
            text += match (text.is_empty(), coefficient.is_negative()) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            };
            let size = coefficient.abs();
            text += &match (monomial.is_unit(), size.is_one()) {
                (true, _) => size.to_string(),
                (false, true) => monomial.to_string(),
                (false, false) => format!("{size} {monomial}"),
            };
        }
        f.pad(if text.is_empty() { "0" } else { &text })
    }
}
