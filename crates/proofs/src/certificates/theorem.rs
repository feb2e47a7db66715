//! A theorem and its proof in Coq.

use super::print::{Printer, number};
use super::statement::Statement;
use super::witness::{Value, find};
use crate::number::{Fraction, Rational, Symbol};
use crate::record::Claim;
use num_traits::Zero;
use std::fmt;

/// A theorem: its name, what it says and the tactics that prove it.
#[derive(Debug, Clone)]
pub(super) struct Theorem {
    name: String,
    words: String,
    says: Vec<String>,
    proof: Vec<String>,
}

/// Whether two claims say the same.
pub(super) fn same_statement(a: &Claim, b: &Claim) -> bool {
    a.holds == b.holds && says(a) == says(b)
}

fn says(claim: &Claim) -> Vec<String> {
    let s = Statement::new(claim);
    let sides = [&s.left, &s.right].map(|side| s.printer.print(side));
    [s.ties(), definitions(&s.printer).collect(), s.nonzero(), sides.to_vec()].concat()
}

impl Theorem {
    /// That the claim holds for all numbers; `None` if it divides by zero whatever the variables are, so that
    /// a theorem would say nothing.
    pub(super) fn holds(name: &str, claim: &Claim) -> Option<Self> {
        let s = Statement::new(claim);
        let variable = |symbol: &Symbol| Fraction::from(symbol.clone());
        if s.divisors.iter().any(|d| d.evaluate(variable).is_zero()) {
            return None;
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
        let introduced = [
            s.names(),
            named("H", ties.len()).join(" "),
            named("t", s.printer.definitions().len()).join(" "),
            named("D", nonzero.len()).join(" "),
        ];
        let mut proof = vec![format!("intros {}.", introduced.join(" "))];
        let above = |d| format!("assert (0 < {}) by (unnamed; positive).", s.printer.print(d));
        proof.extend(s.signed.iter().map(above));
        proof.push("rational.".to_owned());
        Some(Self { name: name.to_owned(), words: claim.words.clone(), says, proof })
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

impl fmt::Display for Theorem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "(* {} *)\nTheorem {} :", super::plain(&self.words), self.name)?;
        self.says.iter().try_for_each(|part| writeln!(f, "  {part}"))?;
        writeln!(f, "Proof.")?;
        self.proof.iter().try_for_each(|part| writeln!(f, "  {part}"))?;
        writeln!(f, "Qed.")
    }
}
