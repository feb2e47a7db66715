//! Expressions in the notation of Coq.

use crate::number::Symbol;
use crate::number::expression::{Expression, Node};
use num_rational::BigRational;
use num_traits::{One, Signed};
use std::collections::{BTreeSet, HashMap};

/// Parts that occur more than once and have at least this number of operations are named.
const SHARED: usize = 8;

/// So are all parts that have this number of operations, to be proven one by one.
const LONG: usize = 100;

/// Words that are no names in Coq, and the type of the real numbers.
const RESERVED: [&str; 14] =
    ["as", "at", "else", "end", "for", "fun", "if", "in", "let", "match", "then", "where", "with", "R"];

/// A variable's name in Coq.
pub(super) fn name(symbol: &Symbol) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let name: String = symbol.name().chars().map(|c| if plain(c) { c } else { '_' }).collect();
    let odd = RESERVED.contains(&name.as_str()) || !name.starts_with(|c: char| c.is_ascii_alphabetic());
    if odd { format!("v_{name}") } else { name }
}

/// A number, in brackets unless it is whole and not negative.
pub(super) fn number(value: &BigRational) -> String {
    match (value.denom().is_one(), value.is_negative()) {
        (true, false) => value.numer().to_string(),
        (true, true) => format!("({})", value.numer()),
        (false, _) => format!("({} / {})", value.numer(), value.denom()),
    }
}

/// How tightly an operation binds: sums 3, products 2, powers 1, names 0.
type Level = u8;

/// A part that has a name.
#[derive(Debug)]
pub(super) struct Definition {
    pub(super) name: String,
    pub(super) text: String,
    pub(super) expression: Expression,
}

/// Prints expressions that share parts.
#[derive(Debug, Default)]
pub(super) struct Printer {
    /// The named parts, in an order in which each needs only those before it.
    definitions: Vec<Definition>,
    names: HashMap<usize, String>,
}

impl Printer {
    /// For these expressions: parts that occur more than once get names.
    pub(super) fn new(all: &[&Expression]) -> Self {
        let mut uses: HashMap<usize, usize> = HashMap::new();
        let mut order = Vec::new();
        let mut seen = BTreeSet::new();
        for expression in all {
            *uses.entry(expression.address()).or_default() += 1;
            expression.each(&mut seen, &mut |part| order.push(part));
        }
        for part in &order {
            for inner in part.parts() {
                *uses.entry(inner.address()).or_default() += 1;
            }
        }
        let mut printer = Self::default();
        let mut sizes: HashMap<usize, usize> = HashMap::new();
        let mut known: HashMap<String, String> = HashMap::new();
        for part in order {
            let size = 1 + part.parts().iter().map(|inner| sizes[&inner.address()]).sum::<usize>();
            let named = (size >= SHARED && uses[&part.address()] > 1) || size >= LONG;
            sizes.insert(part.address(), if named { 1 } else { size });
            if named {
                // What was computed twice has one name.
                let text = printer.print(part);
                let count = printer.definitions.len();
                let name = known.entry(text.clone()).or_insert_with(|| format!("t_{}", count + 1)).clone();
                printer.names.insert(part.address(), name.clone());
                if known.len() > count {
                    printer.definitions.push(Definition { name, text, expression: part.clone() });
                }
            }
        }
        printer
    }

    /// The names and what they stand for.
    pub(super) fn definitions(&self) -> &[Definition] {
        &self.definitions
    }

    /// An expression, without brackets around it.
    pub(super) fn print(&self, expression: &Expression) -> String {
        self.at_most(expression, 3)
    }

    fn at_most(&self, expression: &Expression, most: Level) -> String {
        if let Some(name) = self.names.get(&expression.address()) {
            return name.clone();
        }
        let two = |a: &Expression, sign: &str, b: &Expression, level: Level| {
            let text = format!("{} {sign} {}", self.at_most(a, level), self.at_most(b, level - 1));
            (level, text)
        };
        let (level, text) = match expression.node() {
            Node::Variable(symbol) => (0, name(symbol)),
            Node::Number(value) => (0, number(value)),
            Node::Sum(a, b) => two(a, "+", b, 3),
            Node::Difference(a, b) => two(a, "-", b, 3),
            Node::Product(a, b) => two(a, "*", b, 2),
            Node::Quotient(a, b) => two(a, "/", b, 2),
            Node::Negative(a) => (3, format!("- {}", self.at_most(a, 1))),
            Node::Power(a, n) => (1, format!("{} ^ {n}", self.at_most(a, 0))),
        };
        if level > most { format!("({text})") } else { text }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Fraction;
    use crate::number::expression::recording;

    #[test]
    fn brackets_stand_where_the_order_of_operations_needs_them() {
        let [a, b] = ["a", "b"].map(Fraction::variable);
        let x = recording(true, || {
            -(&a - (&a - &b)) * (&a / (&b * Fraction::ratio(-2, 3))).pow(2) / (-b.clone())
        });
        let text = recording(true, || Printer::default().print(&x.expression()));
        assert_eq!(text, "(- (a - (a - b))) * (a / (b * (-2 / 3))) ^ 2 / (- b)");
    }

    #[test]
    fn a_part_that_occurs_twice_is_named_once() {
        let [a, b] = ["a", "b"].map(Fraction::variable);
        let x = recording(true, || {
            let sum = (&a + &b) * (&a - &b) + Fraction::from(3);
            &sum * &sum
        });
        let expression = x.expression();
        let printer = Printer::new(&[&expression]);
        assert_eq!(printer.print(&expression), "t_1 * t_1");
        let texts: Vec<_> =
            printer.definitions().iter().map(|d| (d.name.as_str(), d.text.as_str())).collect();
        assert_eq!(texts, [("t_1", "(a + b) * (a - b) + 3")]);
    }
}
