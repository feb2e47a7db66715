//! What a theorem speaks of: both sides of a claim, and under which hypotheses.

use super::print::{Printer, name};
use crate::number::expression::{Expression, Node};
use crate::number::{Fraction, Polynomial, Symbol};
use crate::record::{Assertion, Claim};
use std::collections::{BTreeSet, HashMap};
use tumbling::number::Field;

/// A claim's parts, ready to be printed.
pub(super) struct Statement {
    pub(super) left: Expression,
    pub(super) right: Expression,
    /// Every variable.
    pub(super) symbols: BTreeSet<Symbol>,
    /// What ties the variables: the square of each symbol, and what it equals.
    pub(super) squares: Vec<(Symbol, Polynomial)>,
    /// What is divided by, in factors, other than what the variables' sign keeps from zero.
    pub(super) divisors: Vec<Expression>,
    /// What is divided by and above zero, since every variable is.
    pub(super) signed: Vec<Expression>,
    /// Whether every variable is above zero.
    pub(super) positive: bool,
    pub(super) printer: Printer,
}

impl Statement {
    pub(super) fn new(claim: &Claim) -> Self {
        let (left, right) = (claim.left.expression(), claim.right.expression());
        let (positive, all) = match &claim.kind {
            Assertion::Equal(relations) => (false, relations.squares()),
            Assertion::Above => (true, &[][..]),
        };
        let mut symbols = &left.symbols() | &right.symbols();
        // No right side holds an earlier symbol, so one pass finds all that are needed.
        let mut squares = Vec::new();
        for (symbol, square) in all {
            if symbols.contains(symbol) {
                symbols.extend(square.symbols());
                squares.push((symbol.clone(), square.clone()));
            }
        }
        let printer = Printer::new(&[&left, &right]);
        let mut divisors = Vec::new();
        let mut seen = BTreeSet::new();
        for side in [&left, &right] {
            side.each(&mut seen, &mut |part| {
                if let Node::Quotient(_, divisor) = part.node() {
                    factors(divisor, &mut divisors);
                }
            });
        }
        let mut known = BTreeSet::new();
        divisors.retain(|d| known.insert(printer.print(d)));
        let (signed, divisors) = divisors.into_iter().partition::<Vec<_>, _>(|d| positive && one_sign(d));
        Self { left, right, symbols, squares, divisors, signed, positive, printer }
    }

    /// The variables' names, in one line.
    pub(super) fn names(&self) -> String {
        self.symbols.iter().map(name).collect::<Vec<_>>().join(" ")
    }

    /// The hypotheses about the variables alone.
    pub(super) fn ties(&self) -> Vec<String> {
        let print = |p: &Polynomial| Printer::default().print(&Expression::polynomial(p));
        let signs = self.symbols.iter().filter(|_| self.positive).map(|s| format!("0 < {}", name(s)));
        let squares = self.squares.iter().map(|(s, square)| format!("{} ^ 2 = {}", name(s), print(square)));
        signs.chain(squares).collect()
    }

    /// That nothing is divided by zero.
    pub(super) fn nonzero(&self) -> Vec<String> {
        self.divisors.iter().map(|d| format!("{} <> 0", self.printer.print(d))).collect()
    }

    /// The value of each named part for these values of the variables, put in its simplest form.
    pub(super) fn values<T: Field>(
        &self,
        value: impl Fn(&Symbol) -> T,
        simplest: impl Fn(T) -> T,
    ) -> Vec<(&str, T)> {
        let mut known = HashMap::new();
        let mut all = Vec::new();
        for definition in self.printer.definitions() {
            let value = simplest(definition.expression.evaluated(&value, &mut known));
            known.insert(definition.expression.address(), value.clone());
            all.push((definition.name.as_str(), value));
        }
        all
    }
}

/// The factors of a divisor that are no numbers.
fn factors(x: &Expression, all: &mut Vec<Expression>) {
    match x.node() {
        Node::Number(_) => {}
        Node::Product(a, b) => {
            factors(a, all);
            factors(b, all);
        }
        Node::Quotient(a, _) | Node::Negative(a) | Node::Power(a, _) => factors(a, all),
        Node::Variable(_) | Node::Sum(..) | Node::Difference(..) => all.push(x.clone()),
    }
}

/// Whether it has one sign, and is not zero, wherever all its variables are above zero.
fn one_sign(x: &Expression) -> bool {
    let value = x.evaluate(|symbol| Fraction::from(symbol.clone()));
    value.numerator().common_sign().is_some() && value.denominator().common_sign().is_some()
}
