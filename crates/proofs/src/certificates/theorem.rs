//! A theorem and its proof in Coq.

use super::print::{Printer, number};
use super::statement::{Statement, weight};
use super::witness::{Value, find};
use crate::number::expression::{Expression, Node};
use crate::number::{Fraction, Polynomial, Rational, Symbol};
use crate::record::{Claim, Kind};
use num_traits::Zero;
use std::collections::{BTreeSet, HashMap};
use std::fmt;

/// Lines are broken at this number of columns.
const WIDTH: usize = 100;

/// Claims with at most this number of operations are proven in one step.
const WHOLE: u64 = 1200;

/// Proofs with more operations than this take seconds, and are left out.
const MOST: u64 = 2000;

/// A part whose simplest form has more terms than this is not simplified on its own.
const SIMPLE: usize = 40;

/// The number of operations in a term of a polynomial, about.
const OF_A_TERM: u64 = 6;

/// A theorem: its name, what it says and the tactics that prove it.
#[derive(Debug, Clone)]
pub(super) struct Theorem {
    name: String,
    words: String,
    says: Vec<String>,
    proof: Vec<String>,
}

/// Why a claim has no theorem.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Without {
    /// It divides by zero whatever the variables are, so that a theorem would say nothing.
    Empty,
    /// Its proof would take too long.
    Long,
}

/// Whether two claims say the same.
pub(super) fn same_statement(a: &Claim, b: &Claim) -> bool {
    a.holds == b.holds && says(a) == says(b)
}

fn says(claim: &Claim) -> Vec<String> {
    let s = Statement::new(claim);
    [s.ties(), s.nonzero(), vec![s.printer.print(&s.left), s.printer.print(&s.right)]].concat()
}

impl Theorem {
    /// That the claim holds for all numbers.
    ///
    /// # Errors
    /// Why there is no such theorem.
    pub(super) fn holds(name: &str, claim: &Claim) -> Result<Self, Without> {
        let s = Statement::new(claim);
        let variable = |symbol: &Symbol| Fraction::from(symbol.clone());
        if s.divisors.iter().any(|d| d.evaluate(variable).is_zero()) {
            return Err(Without::Empty);
        }
        let (ties, nonzero) = (s.ties(), s.nonzero());
        let mut says = Vec::new();
        if !s.symbols.is_empty() {
            says.push(format!("forall {} : R,", s.names()));
        }
        says.extend(ties.iter().map(|tie| format!("{tie} ->")));
        says.extend(definitions(&s.printer));
        says.extend(nonzero.iter().map(|tie| format!("{tie} ->")));
        says.push(conclusion(&s, if s.positive { ">" } else { "=" }));
        let named = |letter: &str, count: usize| -> Vec<String> {
            (1..=count).map(|k| format!("{letter}_{k}")).collect()
        };
        let rules = named("H", ties.len()).join(" ");
        let all = [s.names(), rules.clone(), named("t", s.printer.definitions().len()).join(" ")];
        let mut proof = vec![format!("intros {} {}.", all.join(" "), named("D", nonzero.len()).join(" "))];
        let rules = if rules.is_empty() || s.positive { rules } else { format!(" [{rules}]") };
        let (steps, operations) = cuts(&s, claim, &rules);
        if operations > MOST {
            return Err(Without::Long);
        }
        proof.extend(steps);
        let divides = [&s.left, &s.right].iter().any(|side| divides(side));
        proof.push(match (&claim.kind, divides) {
            (Kind::Above, _) => {
                let (above, below) = (printed(claim.left.numerator()), printed(claim.left.denominator()));
                format!("apply (above_zero _ ({above}) ({below})); [positive | positive | field; nonzero].")
            }
            (Kind::Equal(_), true) => format!("field{rules}; nonzero."),
            (Kind::Equal(_), false) => format!("ring{rules}."),
        });
        Ok(Self { name: name.to_owned(), words: claim.words.clone(), says, proof })
    }

    /// That it fails for certain numbers, if such are found.
    pub(super) fn fails(name: &str, claim: &Claim) -> Option<Self> {
        let s = Statement::new(claim);
        let point = find(&s, |left, right| if s.positive { left <= right } else { left != right })?;
        let mut says = Vec::new();
        let mut proof = Vec::new();
        if !s.symbols.is_empty() {
            says.push(format!("exists {} : R,", s.names()));
            proof.push(format!("exists {}.", point.values().map(written).collect::<Vec<_>>().join(", ")));
        }
        let (ties, nonzero) = (s.ties(), s.nonzero());
        says.extend(ties.iter().map(|tie| format!("{tie} /\\")));
        says.extend(definitions(&s.printer));
        says.extend(nonzero.iter().map(|tie| format!("{tie} /\\")));
        says.push(conclusion(&s, if s.positive { "<=" } else { "<>" }));
        let roots = point.values().any(|v| matches!(v, Value::Root(_)));
        let tactic = if roots { "enclosed" } else { "computed" };
        let split = |count: usize| format!("split; [{tactic} | ]. ").repeat(count);
        proof.push(split(ties.len()));
        if roots {
            proof.push("cbv zeta.".to_owned());
        } else {
            let value = |symbol: &Symbol| match point.get(symbol) {
                Some(Value::Exact(value)) => Rational::from(value.clone()),
                _ => Rational::new(1, 0),
            };
            for (name, value) in s.values(value, |x| x) {
                let value = value.value().map(number)?;
                proof.push(format!("intros {name}; cut_to {name} {value} computed."));
            }
        }
        proof.push(format!("{}{tactic}.", split(nonzero.len())));
        proof.retain(|line| !line.is_empty());
        Some(Self { name: name.to_owned(), words: claim.words.clone(), says, proof })
    }
}

/// The first steps of a proof of equality, and the number of operations in all steps: each named part is put
/// in its simplest form, one by one, unless that form is long. Short claims are proven as they stand.
fn cuts(s: &Statement, claim: &Claim, rules: &str) -> (Vec<String>, u64) {
    let whole = s.operations();
    let Kind::Equal(relations) = &claim.kind else { return (vec!["unnamed.".to_owned()], whole) };
    if s.printer.definitions().is_empty() {
        return (Vec::new(), whole);
    }
    if whole <= WHOLE {
        return (vec!["unnamed.".to_owned()], whole);
    }
    let variable = |symbol: &Symbol| Fraction::from(symbol.clone());
    let values = s.values(variable, |x| relations.reduce_fraction(&x));
    let (mut steps, mut known, mut all) = (Vec::new(), HashMap::new(), 0_u64);
    for (definition, (name, value)) in s.printer.definitions().iter().zip(values) {
        let terms = value.numerator().len() + value.denominator().len();
        let mut own = weight(&definition.expression, &known);
        if terms > SIMPLE {
            steps.push(format!("subst {name}."));
        } else {
            all = all.saturating_add(own);
            own = OF_A_TERM * terms as u64;
            let form = match value.as_polynomial() {
                Some(whole) => format!("({})", printed(whole)),
                None => format!("(({}) / ({}))", printed(value.numerator()), printed(value.denominator())),
            };
            steps.push(format!("cut_to {name} {form} ltac:(field{rules}; nonzero)."));
        }
        known.insert(definition.expression.address(), own);
    }
    (steps, all.saturating_add(s.operations_with(&known)))
}

fn printed(p: &Polynomial) -> String {
    Printer::default().print(&Expression::polynomial(p))
}

fn conclusion(s: &Statement, relation: &str) -> String {
    format!("{} {relation} {}.", s.printer.print(&s.left), s.printer.print(&s.right))
}

fn written(value: &Value) -> String {
    match value {
        Value::Exact(value) => number(value),
        Value::Root(square) => format!("(sqrt {})", number(square)),
    }
}

/// The named parts, as the statement introduces them.
fn definitions(printer: &Printer) -> impl Iterator<Item = String> + '_ {
    printer.definitions().iter().map(|d| format!("let {} := {} in", d.name, d.text))
}

fn divides(x: &Expression) -> bool {
    let mut found = false;
    x.each(&mut BTreeSet::new(), &mut |part| match part.node() {
        Node::Quotient(..) => found = true,
        Node::Number(value) => found |= !value.is_integer(),
        _ => {}
    });
    found
}

/// Text broken at spaces.
fn broken(text: &str, indent: &str) -> String {
    let mut lines = String::from(indent);
    let mut column = indent.len();
    for (k, word) in text.split(' ').enumerate() {
        if k > 0 && column + 1 + word.len() > WIDTH {
            lines += "\n";
            lines += indent;
            lines += "  ";
            column = indent.len() + 2;
        } else if k > 0 {
            lines += " ";
            column += 1;
        }
        lines += word;
        column += word.len();
    }
    lines
}

impl fmt::Display for Theorem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "(* {} *)\nTheorem {} :", super::plain(&self.words), self.name)?;
        for part in &self.says {
            writeln!(f, "{}", broken(part, "  "))?;
        }
        writeln!(f, "Proof.")?;
        for part in &self.proof {
            writeln!(f, "{}", broken(part, "  "))?;
        }
        writeln!(f, "Qed.")
    }
}
