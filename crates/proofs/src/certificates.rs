//! The proofs as theorems of Coq, whose kernel shares no code with this crate.
//!
//! A theorem states what a check claims, with both sides as the library's functions computed them: variables
//! are real numbers, relations and divisors other than zero are hypotheses. Where a claim must fail, the
//! theorem gives numbers for which it does.

mod print;
mod shape;
mod statement;
mod theorem;
mod witness;

use crate::number::expression::{Expression, Node};
use crate::proof::{Outcome, Proof, Residue};
use crate::proofs::{is_of_an_order, proofs};
use crate::record::{Assertion, Claim, Entry, recorded};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use theorem::Theorem;

/// One file of theorems: those of the proofs of one part of the library.
#[derive(Debug, Clone, Default)]
pub struct Certificate {
    /// The part of the library.
    pub part: &'static str,
    /// The text for Coq.
    pub text: String,
    /// The names of its proofs that have theorems.
    pub proofs: Vec<&'static str>,
    /// The names of its proofs that have no theorem: their claims are all of numbers or of the same on both
    /// sides, or too long for Coq.
    pub without: Vec<&'static str>,
    /// The number of theorems that hold for all numbers.
    pub theorems: usize,
    /// The number of theorems that give a counterexample to a claim that must fail, mutants apart.
    pub counterexamples: usize,
    /// The number of mutants whose claim a theorem about letters refutes.
    pub mutants: usize,
    /// Claims for which no theorem could be written, each with its proof.
    pub missing: Vec<String>,
}

/// Every certificate, in the order of the library.
#[must_use]
pub fn certificates() -> Vec<Certificate> {
    let mut all: Vec<Certificate> = Vec::new();
    for proof in proofs() {
        let place = all.iter().position(|c| c.part == proof.part).unwrap_or_else(|| {
            all.push(Certificate { part: proof.part, text: HEADER.to_owned(), ..Certificate::default() });
            all.len() - 1
        });
        all[place].add(proof);
    }
    all.retain(|c| !c.proofs.is_empty() || !c.without.is_empty());
    all
}

const HEADER: &str = "\
(* Made by `cargo run -- certificates`: the claims of crates/proofs, with both sides as the library's functions
   compute them. *)
Require Import Tumbling.tactics Tumbling.decide.
";

impl Certificate {
    /// Adds the theorems of a proof and of its mutants.
    fn add(&mut self, proof: &Proof) {
        let name = proof.name.replace('-', "_");
        let entries = if is_of_an_order(proof) { Vec::new() } else { recorded(proof.check).1 };
        let mut claims = claims(&entries);
        claims.dedup_by(|a, b| theorem::same_statement(a, b));
        if claims.is_empty() {
            self.without.push(proof.name);
            return;
        }
        self.proofs.push(proof.name);
        let _ = write!(self.text, "\n\n(** {}: {} *)\n", proof.name, plain(proof.statement));
        for (k, claim) in claims.iter().enumerate() {
            let name = format!("{name}_{}", k + 1);
            let (theorem, count) = match claim.holds {
                true => (Theorem::holds(&name, claim), &mut self.theorems),
                false => (Theorem::fails(&name, claim), &mut self.counterexamples),
            };
            match theorem {
                Some(theorem) => {
                    *count += 1;
                    self.write(&theorem);
                }
                None => self.missing.push(format!("{}: {}", proof.name, claim.words)),
            }
        }
        for (k, mutant) in proof.mutants.iter().enumerate() {
            let (outcome, entries) = recorded(mutant.check);
            let name = format!("{name}_mutant_{}", k + 1);
            let _ = write!(self.text, "\n(* With {}. *)\n", plain(mutant.change));
            match refutation(&name, &outcome, &entries) {
                Some(theorems) => {
                    self.mutants += usize::from(!theorems.is_empty());
                    theorems.iter().for_each(|theorem| self.write(theorem));
                }
                None => self.missing.push(format!("{} with {}", proof.name, mutant.change)),
            }
        }
    }

    fn write(&mut self, theorem: &Theorem) {
        let _ = write!(self.text, "\n{theorem}");
    }
}

/// What refutes a mutant: numbers for which its last claim fails; or, if it claims that something fails, that
/// it holds. Nothing for claims without content.
fn refutation(name: &str, outcome: &Outcome, entries: &[Entry]) -> Option<Vec<Theorem>> {
    if let (Err(Residue::Missing { .. }), [before @ .., Entry::Broken(false)]) = (outcome, entries) {
        let from = before.iter().rposition(|entry| matches!(entry, Entry::Broken(_))).map_or(0, |at| at + 1);
        let held = claims(&before[from..]);
        let theorem = |(k, claim)| Theorem::holds(&format!("{name}_{}", k + 1), claim);
        return held.iter().enumerate().map(theorem).collect();
    }
    match entries.last() {
        Some(Entry::Claimed(claim)) if !claim.holds && !has_content(claim) => Some(Vec::new()),
        Some(Entry::Claimed(claim)) if !claim.holds => {
            Theorem::fails(name, claim).map(|theorem| vec![theorem])
        }
        _ => None,
    }
}

/// The claims that have content.
fn claims(entries: &[Entry]) -> Vec<Claim> {
    let claim = |entry: &Entry| match entry {
        Entry::Claimed(claim) if has_content(claim) => Some(claim.clone()),
        Entry::Claimed(_) | Entry::Broken(_) => None,
    };
    entries.iter().filter_map(claim).collect()
}

/// Whether a claim is about more than numbers, no equation of the same on both sides but for the order of its
/// terms and factors, and not that one product of letters is not zero.
fn has_content(claim: &Claim) -> bool {
    let [left, right] = [&claim.left, &claim.right].map(|side| side.expression());
    let numbers = left.as_number().is_some() && right.as_number().is_some();
    let product = !claim.holds && right.as_number().is_some() && !adds(&left);
    !numbers && !product && (matches!(claim.kind, Assertion::Above) || shape::of(&left) != shape::of(&right))
}

/// Whether it has a sum in it.
fn adds(x: &Expression) -> bool {
    let mut found = false;
    x.each(&mut BTreeSet::new(), &mut |part| {
        found |= matches!(part.node(), Node::Sum(..) | Node::Difference(..));
    });
    found
}

/// Text as a comment of Coq may hold it.
fn plain(text: &str) -> String {
    text.replace("(*", "( *").replace("*)", "* )").replace('"', "'")
}
