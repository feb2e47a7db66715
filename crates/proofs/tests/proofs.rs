//! Every proof holds, and none holds of an altered law.

use std::collections::BTreeSet;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use tumbling_proofs::proof::{formulas, holds_in};
use tumbling_proofs::{Residue, proofs};

#[test]
fn every_proof_leaves_nothing_over() {
    let (next, faults) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(proof) = proofs().get(next.fetch_add(1, Ordering::Relaxed)) {
                    if let Err(residue) = (proof.check)() {
                        faults.lock().unwrap().push(format!("{}: {residue}", proof.name));
                    }
                }
            });
        }
    });
    assert_eq!(faults.into_inner().unwrap(), [""; 0]);
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
    let (mut missing, mut faults) = (Vec::new(), Vec::new());
    for proof in proofs() {
        assert!(!proof.mutants.is_empty(), "{} has no mutant", proof.name);
        for mutant in proof.mutants {
            match (mutant.check)() {
                Err(Residue::Missing { .. }) => missing.push((proof.name, mutant.change)),
                Err(residue) if !residue.to_string().contains("by zero") => {}
                other => faults.push((proof.name, mutant.change, other)),
            }
        }
    }
    assert_eq!(missing, FOUND_MISSING);
    assert!(faults.is_empty(), "{faults:#?}");
}

/// Outside formulas there are words, counts, and numbers of the book's formulas; no letter stands alone.
#[test]
fn sentences_of_proofs_hold_formulas_between_dollars_alone() {
    let (mut names, mut faults, mut with_formulas) = (BTreeSet::new(), Vec::new(), 0);
    for proof in proofs() {
        assert!(names.insert(proof.name) && proof.statement.ends_with('.'), "{}", proof.name);
        assert!(proof.statement.matches('$').count() % 2 == 0, "{}", proof.name);
        with_formulas += usize::from(formulas(proof.statement).next().is_some());
        let words =
            proof.statement.split('$').step_by(2).flat_map(|text| text.split([' ', ',', '.', ';', ':']));
        for word in
            words.map(|word| word.trim_matches(['(', ')'])).filter(|word| !["", "a", "A"].contains(word))
        {
            let number = word.strip_prefix(['C', 'T']).unwrap_or(word).chars().all(|c| c.is_ascii_digit());
            let letters = |part: &str| !part.is_empty() && part.chars().all(char::is_alphabetic);
            if !(number || word.len() > 1 && word.split(['-', '\'']).all(letters)) {
                faults.push((proof.name, word));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
    assert_eq!((names.len(), with_formulas), (112, 49));
}

#[test]
fn no_formula_of_a_sentence_passes_with_a_sign_altered() {
    let (mut refused, mut faults) = (0, Vec::new());
    for proof in proofs() {
        let cases = (proof.cases)().unwrap();
        for tex in formulas(proof.statement) {
            let signs: &[char] = if tex.contains(['<', '>']) { &['<', '>'] } else { &['+', '-'] };
            let mut altered: Vec<_> = tex
                .match_indices(signs)
                .map(|(at, sign)| {
                    let other =
                        ["+", "-", "<", ">"][["-", "+", ">", "<"].iter().position(|x| *x == sign).unwrap()];
                    format!("{}{other}{}", &tex[..at], &tex[at + 1..])
                })
                .collect();
            if let Some((left, right)) = tex.split_once('=') {
                altered.push(if right.trim() == "0" {
                    format!("{left} = 1")
                } else {
                    format!("{left} = 2 ({right})")
                });
            }
            for tex in altered {
                match holds_in(&cases, &tex) {
                    Err(Residue::Formula { .. }) => refused += 1,
                    other => faults.push((proof.name, tex, other)),
                }
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
    assert_eq!(refused, 293);
}
