//! How a fraction was computed: the expression as it was written, before anything is expanded.

use super::calculus::in_field;
use super::polynomial::Polynomial;
use super::symbol::Symbol;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::cell::Cell;
use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;
use tumbling::number::Field;

thread_local! {
    static RECORDING: Cell<bool> = const { Cell::new(false) };
}

/// Whether fractions on this thread keep their expressions.
pub(crate) fn is_recording() -> bool {
    RECORDING.get()
}

/// Runs `work`, in which fractions keep their expressions, or do not.
pub(crate) fn recording<R>(on: bool, work: impl FnOnce() -> R) -> R {
    let before = RECORDING.replace(on);
    let result = work();
    RECORDING.set(before);
    result
}

/// An arithmetic expression whose parts may be shared. Numbers are combined, and terms and factors that
/// change nothing are dropped; otherwise it stays as it was built.
#[derive(Debug, Clone)]
pub(crate) struct Expression(Arc<Node>);

/// One operation of an expression.
#[derive(Debug)]
pub(crate) enum Node {
    Variable(Symbol),
    Number(BigRational),
    Sum(Expression, Expression),
    Difference(Expression, Expression),
    Product(Expression, Expression),
    Quotient(Expression, Expression),
    Negative(Expression),
    Power(Expression, u32),
}

use Node::{Difference, Negative, Number, Power, Product, Quotient, Sum, Variable};

impl Expression {
    pub(crate) fn new(node: Node) -> Self {
        Self(Arc::new(node))
    }

    pub(crate) fn node(&self) -> &Node {
        &self.0
    }

    /// What tells a shared part from another that looks the same.
    pub(crate) fn address(&self) -> usize {
        Arc::as_ptr(&self.0) as usize
    }

    pub(crate) fn number(value: BigRational) -> Self {
        Self::new(Number(value))
    }

    pub(crate) fn variable(symbol: &Symbol) -> Self {
        Self::new(Variable(symbol.clone()))
    }

    /// The expanded polynomial, term by term.
    pub(crate) fn polynomial(p: &Polynomial) -> Self {
        let mut sum = Self::number(BigRational::zero());
        for (monomial, coefficient) in p.terms() {
            let mut term = Self::number(coefficient.abs());
            for (symbol, power) in monomial.powers() {
                term = term.times(&Self::variable(symbol).power(power));
            }
            sum = if coefficient.is_negative() { sum.minus(&term) } else { sum.plus(&term) };
        }
        sum
    }

    /// The number, if it is one.
    pub(crate) fn as_number(&self) -> Option<&BigRational> {
        if let Number(value) = self.node() { Some(value) } else { None }
    }

    fn is(&self, n: i64) -> bool {
        self.as_number().is_some_and(|value| *value == BigRational::from(BigInt::from(n)))
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        if let (Some(a), Some(b)) = (self.as_number(), other.as_number()) {
            return Self::number(a + b);
        }
        match (self.is(0), other.is(0), other.node()) {
            (true, _, _) => other.clone(),
            (_, true, _) => self.clone(),
            (_, _, Negative(x)) => Self::new(Difference(self.clone(), x.clone())),
            _ => Self::new(Sum(self.clone(), other.clone())),
        }
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        if let (Some(a), Some(b)) = (self.as_number(), other.as_number()) {
            return Self::number(a - b);
        }
        match (self.is(0), other.is(0), other.node()) {
            (true, _, _) => other.negative(),
            (_, true, _) => self.clone(),
            (_, _, Negative(x)) => Self::new(Sum(self.clone(), x.clone())),
            _ => Self::new(Difference(self.clone(), other.clone())),
        }
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        if let (Some(a), Some(b)) = (self.as_number(), other.as_number()) {
            return Self::number(a * b);
        }
        match (self, other) {
            (zero, _) | (_, zero) if zero.is(0) => zero.clone(),
            (one, x) | (x, one) if one.is(1) => x.clone(),
            (minus, x) | (x, minus) if minus.is(-1) => x.negative(),
            _ => Self::new(Product(self.clone(), other.clone())),
        }
    }

    pub(crate) fn over(&self, other: &Self) -> Self {
        match (self.as_number(), other.as_number()) {
            (Some(a), Some(b)) if !b.is_zero() => Self::number(a / b),
            (_, Some(b)) if b.is_one() => self.clone(),
            _ => Self::new(Quotient(self.clone(), other.clone())),
        }
    }

    pub(crate) fn negative(&self) -> Self {
        match self.node() {
            Number(x) => Self::number(-x),
            Negative(x) => x.clone(),
            _ => Self::new(Negative(self.clone())),
        }
    }

    pub(crate) fn power(&self, n: u32) -> Self {
        match (n, self.node()) {
            (0, _) => Self::number(BigRational::one()),
            (1, _) => self.clone(),
            (_, Number(x)) => Self::number(num_traits::pow(x.clone(), n as usize)),
            _ => Self::new(Power(self.clone(), n)),
        }
    }

    /// The parts that it is directly made of.
    pub(crate) fn parts(&self) -> Vec<&Self> {
        match self.node() {
            Variable(_) | Number(_) => Vec::new(),
            Negative(a) | Power(a, _) => vec![a],
            Sum(a, b) | Difference(a, b) | Product(a, b) | Quotient(a, b) => vec![a, b],
        }
    }

    /// Every part once, each after those that it is made of.
    pub(crate) fn each<'a>(&'a self, seen: &mut BTreeSet<usize>, take: &mut impl FnMut(&'a Self)) {
        if seen.insert(self.address()) {
            for part in self.parts() {
                part.each(seen, take);
            }
            take(self);
        }
    }

    /// The variables that occur in it.
    pub(crate) fn symbols(&self) -> BTreeSet<Symbol> {
        let mut all = BTreeSet::new();
        self.each(&mut BTreeSet::new(), &mut |part| {
            if let Variable(symbol) = part.node() {
                all.insert(symbol.clone());
            }
        });
        all
    }

    /// What is known of it, or else is made of it and then known.
    fn once<T: Clone>(
        &self,
        known: &mut HashMap<usize, T>,
        make: impl FnOnce(&mut HashMap<usize, T>) -> T,
    ) -> T {
        if let Some(result) = known.get(&self.address()) {
            return result.clone();
        }
        let result = make(known);
        known.insert(self.address(), result.clone());
        result
    }

    /// Its value, computed as it is written.
    pub(crate) fn evaluate<T: Field>(&self, value: impl Fn(&Symbol) -> T) -> T {
        self.evaluated(&value, &mut HashMap::new())
    }

    /// Its value where those of parts may be known, by their addresses; adds those that it finds.
    pub(crate) fn evaluated<T: Field>(
        &self,
        value: &impl Fn(&Symbol) -> T,
        known: &mut HashMap<usize, T>,
    ) -> T {
        self.once(known, |known| match self.node() {
            Variable(symbol) => value(symbol),
            Number(number) => in_field(number),
            Sum(a, b) => a.evaluated(value, known) + b.evaluated(value, known),
            Difference(a, b) => a.evaluated(value, known) - b.evaluated(value, known),
            Product(a, b) => a.evaluated(value, known) * b.evaluated(value, known),
            Quotient(a, b) => a.evaluated(value, known) / b.evaluated(value, known),
            Negative(a) => -a.evaluated(value, known),
            Power(a, n) => num_traits::pow(a.evaluated(value, known), *n as usize),
        })
    }

    /// The partial derivative by `symbol`, by the rules for sums, products and quotients.
    pub(crate) fn derivative(&self, symbol: &Symbol) -> Self {
        self.derived(symbol, &mut HashMap::new())
    }

    fn derived(&self, symbol: &Symbol, known: &mut HashMap<usize, Self>) -> Self {
        let constant = |n: i64| Self::number(BigInt::from(n).into());
        self.once(known, |known| match self.node() {
            Variable(own) => constant(i64::from(own == symbol)),
            Number(_) => constant(0),
            Sum(a, b) => a.derived(symbol, known).plus(&b.derived(symbol, known)),
            Difference(a, b) => a.derived(symbol, known).minus(&b.derived(symbol, known)),
            Product(a, b) => {
                let left = a.derived(symbol, known).times(b);
                left.plus(&a.times(&b.derived(symbol, known)))
            }
            Quotient(a, b) => {
                let (above, below) = (a.derived(symbol, known), b.derived(symbol, known));
                let part = above.over(b);
                if below.is(0) { part } else { part.minus(&a.times(&below).over(&b.power(2))) }
            }
            Negative(a) => a.derived(symbol, known).negative(),
            Power(a, n) => constant((*n).into()).times(&a.power(n - 1)).times(&a.derived(symbol, known)),
        })
    }

    /// This with `value` put for `symbol`.
    pub(crate) fn substitute(&self, symbol: &Symbol, value: &Self) -> Self {
        self.substituted(symbol, value, &mut HashMap::new())
    }

    fn substituted(&self, symbol: &Symbol, value: &Self, known: &mut HashMap<usize, Self>) -> Self {
        self.once(known, |known| {
            let mut put = |x: &Self| x.substituted(symbol, value, known);
            match self.node() {
                Variable(own) if own == symbol => value.clone(),
                Variable(_) | Number(_) => self.clone(),
                Sum(a, b) => put(a).plus(&put(b)),
                Difference(a, b) => put(a).minus(&put(b)),
                Product(a, b) => put(a).times(&put(b)),
                Quotient(a, b) => put(a).over(&put(b)),
                Negative(a) => put(a).negative(),
                Power(a, n) => put(a).power(*n),
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::number::{Fraction, Rational, Relations};
    use num_traits::{One, Zero};

    /// The value of a fraction's expression and of its expanded form, where a = 3, b = 5 and c = 2/7.
    fn both(x: &Fraction) -> [Rational; 2] {
        let value = |name: &str| match name {
            "a" => Rational::from(3),
            "b" => Rational::from(5),
            _ => Rational::new(2, 7),
        };
        let expanded = x.at(&["a", "b", "c"].map(|name| (name, value(name))));
        [x.expression().evaluate(|symbol| value(symbol.name())), expanded]
    }

    #[test]
    fn an_expression_has_the_value_of_the_fraction_that_it_computes() {
        super::recording(true, || {
            let [a, b, c] = ["a", "b", "c"].map(Fraction::variable);
            let x = (&a + &b) * (&a - &c) / (&b * &c - Fraction::from(2)) - Fraction::ratio(2, 3) * a.pow(3);
            let put = x.substitute(&"a".into(), &(&b / &c));
            let reduced = Relations::circle("d", "a").reduce_fraction(&x);
            for y in [&x, &-x.clone(), &x.derivative(&"a".into()), &x.derivative(&"b".into()), &put, &reduced]
            {
                let [computed, expanded] = both(y);
                assert!(!computed.is_zero());
                assert_eq!(computed, expanded, "{y}");
            }
            assert_eq!(x.expression().symbols(), x.symbols());
        });
    }

    #[test]
    fn without_recording_an_expression_is_the_expanded_form() {
        let [a, b] = ["a", "b"].map(Fraction::variable);
        let x = (&a + &b).pow(2) / (&a - &b);
        let [computed, expanded] = both(&x);
        assert_eq!(computed, expanded);
        assert!(Fraction::one().expression().as_number().is_some_and(One::is_one));
    }
}
