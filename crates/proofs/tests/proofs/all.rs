//! Every proof holds, and none holds for an altered law.

use std::collections::{BTreeSet, HashMap};
use std::sync::LazyLock;
use std::thread;
use tumbling_proofs::proof::{formulas, holds_in};
use tumbling_proofs::tex::Scope;
use tumbling_proofs::{Proof, Residue, proofs};

/// The cases that each check looks at, found once for all tests; or what is left over, so that all proofs
/// that fail are named, not the first alone.
static CASES: LazyLock<HashMap<&str, Result<Vec<Scope>, Residue>>> = LazyLock::new(|| {
    let found = |proof: &Proof| (proof.name, (proof.cases)());
    halves(|half| half.map(found).collect::<Vec<_>>()).into_iter().collect()
});

/// What two threads find, each of every other proof.
fn halves<T: Send>(find: impl Fn(&mut dyn Iterator<Item = &Proof>) -> Vec<T> + Sync) -> Vec<T> {
    let half = |first: usize| find(&mut proofs().into_iter().skip(first).step_by(2));
    let two = thread::scope(|scope| [0, 1].map(|n| scope.spawn(move || half(n))).map(|half| half.join()));
    two.into_iter().flat_map(Result::unwrap).collect()
}

#[test]
fn every_proof_leaves_nothing_over() {
    let left = |proof: &Proof| {
        let cases = CASES[proof.name].as_ref().map_err(Residue::clone);
        cases.and_then(|cases| proof.check_in(cases)).err().map(|left| format!("{}: {left}", proof.name))
    };
    assert_eq!(halves(|half| half.filter_map(left).collect()), [""; 0]);
}

/// Mutants in which something that is claimed to break, or to be found, does not break or is not found; all
/// other mutants must leave a residue.
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
        let outside = proof.statement.split('$').step_by(2);
        let words = outside.flat_map(|text| text.split([' ', ',', '.', ';', ':']));
        let words = words.map(|word| word.trim_matches(['(', ')']));
        for word in words.filter(|word| !["", "a", "A"].contains(word)) {
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

/// The letters of the sentences that have a name in TeX.
const GREEK: &str = r"\alpha \beta \gamma \delta \eta \theta \lambda \sigma \tau \phi \psi \omega \Omega";

/// A formula with each sign changed, with its last side doubled or no longer zero, and with each letter
/// replaced by the next one, if this gives a new side.
fn altered(tex: &str) -> Vec<String> {
    let tex = &tex.replace('\\', r" \");
    let sides = |tex: &str| tex.split(['=', '<', '>']).map(|side| side.trim().to_owned()).collect::<Vec<_>>();
    let turned = |(at, sign)| {
        format!("{}{}{}", &tex[..at], &"+-+<><".split_once(sign).unwrap().1[..1], &tex[at + 1..])
    };
    let mut all: Vec<_> = tex.match_indices(['+', '-', '<', '>']).map(turned).collect();
    if let Some((left, right)) = tex.rsplit_once('=') {
        all.push(if right.trim() == "0" { format!("{left} = 1") } else { format!("{left} = 2 ({right})") });
    }
    let pieces: Vec<_> = tex.split_inclusive(|c: char| !c.is_alphabetic() && c != '\\').collect();
    let name = |at: &usize| pieces[*at].trim_end_matches(|c: char| !c.is_alphabetic());
    let letter = |at: &usize| name(at).len() == 1 || GREEK.split(' ').any(|of| name(at) == of);
    let letters: Vec<_> = (0..pieces.len()).filter(letter).collect();
    for (n, at) in letters.iter().enumerate() {
        let mut others = letters[n..].iter().chain(&letters[..n]).map(name);
        let Some(other) = others.find(|other| *other != name(at)) else { continue };
        let after = &pieces[*at][name(at).len()..];
        let new = [&pieces[..*at].concat(), other, after, &pieces[at + 1..].concat()].concat();
        all.extend(sides(&new).iter().any(|side| !sides(tex).contains(side)).then_some(new));
    }
    all
}

/// The altered ones that hold are inequalities, and true: a sum for a difference of positive quotients, letters
/// of a product of positive factors, and a number above nine tenths in place of one of two.
#[test]
fn no_formula_of_a_sentence_passes_with_a_sign_a_side_or_a_letter_altered() {
    let ([mut untrue, mut meaningless, mut true_too], mut passed) = ([0; 3], Vec::new());
    for proof in proofs() {
        let cases = CASES[proof.name].as_deref().unwrap_or_default();
        for tex in formulas(proof.statement).flat_map(altered) {
            match holds_in(cases, &tex) {
                Err(Residue::Formula { .. }) => untrue += 1,
                Err(Residue::Missing { .. }) => meaningless += 1,
                Ok(()) if tex.contains('>') => true_too += 1,
                other => passed.push((proof.name, tex, other)),
            }
        }
    }
    assert!(passed.is_empty(), "{passed:#?}");
    assert_eq!([untrue, meaningless, true_too], [1326, 523, 5]);
}
