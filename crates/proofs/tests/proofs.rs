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
const FOUND_MISSING: [(&str, &str); 2] =
    [("spin-is-not-conserved", "the law of a ball"), ("spin-is-not-conserved", "a steady spin")];

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
    assert_eq!((names.len(), with_formulas), (114, 112));
}

/// A formula with each sign turned, its last side doubled or no longer zero, and each letter that stands
/// alone become the next one, where that does not make its sides the same.
fn altered(tex: &str) -> Vec<String> {
    let signs: &[char] = if tex.contains(['<', '>']) { &['<', '>'] } else { &['+', '-'] };
    let turned = |(at, sign)| {
        format!("{}{}{}", &tex[..at], &"+-+<><".split_once(sign).unwrap().1[..1], &tex[at + 1..])
    };
    let mut all: Vec<_> = tex.match_indices(signs).map(turned).collect();
    if let Some((left, right)) = tex.rsplit_once('=') {
        all.push(if right.trim() == "0" { format!("{left} = 1") } else { format!("{left} = 2 ({right})") });
    }
    let pieces: Vec<_> = tex.split_inclusive(|c: char| !c.is_alphabetic() && c != '\\').collect();
    let alone = |n: &usize| pieces[*n].trim_end_matches(|c: char| !c.is_alphabetic()).len() == 1;
    for pair in (0..pieces.len()).filter(alone).collect::<Vec<_>>().windows(2) {
        let [one, next] = [0, 1].map(|n| pieces[pair[n]]);
        let tex =
            [&pieces[..pair[0]].concat(), &next[..1], &one[1..], &pieces[pair[0] + 1..].concat()].concat();
        let sides = tex.split_once('=').filter(|(a, b)| a.trim() != b.trim() && !b.contains('='));
        all.extend((next[..1] != one[..1] && sides.is_some()).then_some(tex));
    }
    all
}

#[test]
fn no_formula_of_a_sentence_passes_with_a_sign_a_side_or_a_letter_altered() {
    let (mut refused, mut passed) = (0, Vec::new());
    for proof in proofs() {
        let cases = (proof.cases)().unwrap();
        for tex in formulas(proof.statement).flat_map(altered) {
            match holds_in(&cases, &tex) {
                Err(Residue::Formula { .. } | Residue::Missing { .. }) => refused += 1,
                other => passed.push((proof.name, tex, other)),
            }
        }
    }
    assert!(passed.is_empty(), "{passed:#?}");
    assert_eq!(refused, 1180);
}
