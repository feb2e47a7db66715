//! Every proof holds, and none holds of an altered law.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use tumbling_proofs::{Residue, proofs};

#[test]
fn every_proof_leaves_nothing_over() {
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(proof) = proofs().get(next.fetch_add(1, Ordering::Relaxed)) {
                    (proof.check)().unwrap_or_else(|residue| panic!("{}: {residue}", proof.name));
                }
            });
        }
    });
}

/// Mutants in which what is claimed to break, or to be found, does not or is not; all others must leave
/// something over.
const FOUND_MISSING: [(&str, &str); 4] = [
    ("spin-is-not-conserved", "the law of a ball"),
    ("spin-is-not-conserved", "a steady spin"),
    ("frozen-tensor", "the right engine in its place"),
    ("momentum-for-spin", "said to break the energy"),
];

#[test]
fn every_altered_law_leaves_something_over() {
    let mut missing = Vec::new();
    for proof in proofs() {
        assert!(!proof.mutants.is_empty(), "{} has no mutant", proof.name);
        for mutant in proof.mutants {
            match (mutant.check)() {
                Ok(()) => panic!("{} still holds with {}", proof.name, mutant.change),
                Err(Residue::Undefined { claim }) => {
                    panic!("{} with {} only divides by zero: {claim}", proof.name, mutant.change)
                }
                Err(Residue::Missing { .. }) => missing.push((proof.name, mutant.change)),
                Err(residue) => assert!(!residue.to_string().is_empty()),
            }
        }
    }
    assert_eq!(missing, FOUND_MISSING);
}

#[test]
fn proofs_have_different_names_and_say_what_they_prove() {
    let names: BTreeSet<_> = proofs().iter().map(|proof| proof.name).collect();
    assert_eq!(names.len(), proofs().len());
    assert!(proofs().iter().all(|proof| proof.statement.ends_with('.')));
}
