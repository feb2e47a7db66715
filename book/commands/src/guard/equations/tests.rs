//! The book's equations are proven as they stand, and an altered copy does not pass for one of them.

use super::super::{Book, Reader, paths};
use super::laws;
use super::{maths, missing};
use tumbling_proofs::equations::{Equation, Exemption, Expected, Fault, read};

/// The book's chapters, each with its maths.
fn chapters() -> Vec<(String, Vec<Equation>)> {
    let book = Book::read().unwrap();
    assert_eq!(missing(&book.chapters), Ok(vec![]));
    book.chapters.iter().map(|chapter| (chapter.name.clone(), maths(chapter))).collect()
}

/// The maths in a text.
fn equations(text: &str) -> Vec<Equation> {
    maths(&Reader::default().chapter("x", "x.md", text).unwrap())
}

/// The faults in the equations of a chapter.
fn faults(chapter: &str, equations: &[Equation]) -> Vec<Fault> {
    read(&laws::of(chapter).unwrap(), equations).faults
}

#[test]
fn every_equation_of_the_book_is_proven_or_exempt_with_a_reason() {
    for (name, equations) in &chapters() {
        let (expected, found) = (laws::of(name).unwrap(), read(&laws::of(name).unwrap(), equations));
        assert!(found.faults.is_empty(), "{name}: {:#?}", found.faults);
        let apart = expected.exemptions.iter().filter(|it| it.proof.is_some()).count();
        assert_eq!((found.proven.len(), found.apart.len()), (expected.laws.len(), apart), "{name}");
        assert_eq!(found.exempt.len(), expected.exemptions.len() - apart, "{name}");
        assert_eq!(found.notation.len(), expected.notation.len(), "{name}");
    }
    let exemptions = laws::all().unwrap().iter().flat_map(|(_, expected)| expected.exemptions);
    assert!(exemptions.clone().count() > 0 && exemptions.into_iter().all(|it| it.reason.len() > 10));
}

/// What is displayed from a number on until the next, of what the proof ran on that cites the number.
#[test]
fn a_proof_shows_the_formulas_whose_numbers_it_cites() {
    let (chapters, mut cited) = (chapters(), 0);
    let chapter = &chapters.iter().find(|(name, _)| name == "closed-form").unwrap().1;
    let text = std::fs::read_to_string(paths::chapters().join("closed-form.md")).unwrap();
    let line = |mark: &str| text.lines().position(|line| line.contains(mark)).unwrap() + 1;
    for proof in tumbling_proofs::proofs().iter().filter(|proof| proof.statement.contains("(C")) {
        let cases = (proof.cases)().unwrap();
        for number in proof.statement.split("(C").skip(1) {
            let number: usize = number.split(')').next().unwrap().parse().unwrap();
            let lines = line(&format!("**(C{number})**"))..line(&format!("**(C{})**", number + 1)) + 1;
            let shown: Vec<_> = chapter.iter().filter(|it| it.display && lines.contains(&it.line)).collect();
            assert!(!shown.is_empty(), "{}: {number}", proof.name);
            for it in shown {
                let found = tumbling_proofs::proof::holds_in(&cases, &it.tex);
                assert!(found.is_ok(), "{} (C{number}): `{}`: {found:?}", proof.name, it.tex);
            }
            cited += 1;
        }
    }
    assert_eq!(cited, 11);
}

/// Each equation of a chapter with seven added after its sign of equality.
#[test]
fn an_altered_equation_is_refused() {
    let (name, equations) = chapters().into_iter().find(|(name, _)| name == "proofs").unwrap();
    let laws = equations.iter().enumerate().filter(|(_, law)| law.display && law.tex.contains('='));
    assert!(laws.clone().count() >= 8);
    for (place, equation) in laws {
        let mut altered = equations.clone();
        altered[place].tex = equation.tex.replacen('=', "= 7 +", 1);
        let found = faults(&name, &altered);
        assert!(!found.is_empty(), "{}", altered[place].tex);
    }
}

/// Each is refused if it is appended to a chapter.
#[test]
fn what_states_something_or_cannot_be_read_never_passes_for_notation_or_a_value() {
    let holes = [
        r"$$I_{xx} = 7,\qquad I_{yy}=1000$$",
        r"$I_1 = 4$",
        r"$\lambda^2 = 6$",
        r"$I_1+I_2 = 9$",
        "$a = 1/2$",
        r"$a \neq b$",
        r"$a \approx b$",
        r"$a \propto b$",
        r"$a \to b$",
        r"$a \equiv b$",
        r"$a \parallel b$",
        r"$a \perp b$",
        r"$a \gg b$",
        r"$a \ll b$",
        r"$a \sim b$",
        r"$a \simeq b$",
        r"$$a \approx b$$",
        r"$-\boldsymbol{\omega}\times$",
        r"$e^{-\lambda t}$",
        r"$R^{\mathsf T} I$",
        r"$\sum m\,xx$",
        r"$\lambda^3$",
        r"$\dot{I} b$",
        r"$$R^{\mathsf{T}}$$",
        r"$\mathbf{L} = (1, 2, 1/2)$",
        r"$E = 5$",
        r"$a = 2 = 7$",
    ];
    for (name, equations_of_it) in chapters() {
        for hole in holes {
            let mut all = equations_of_it.clone();
            all.extend(equations(hole));
            assert!(!faults(&name, &all).is_empty(), "{name}: {hole}");
        }
    }
}

#[test]
fn a_law_that_leaves_its_chapter_is_missed() {
    let faults = faults("worked-example", &equations("Nothing."));
    let missed = faults.iter().filter(|fault| fault.problem.starts_with("this law is not found")).count();
    assert_eq!(missed, laws::of("worked-example").unwrap().laws.len());
    assert_eq!(missed, faults.len());
}

#[test]
fn an_exemption_no_longer_needed_is_a_fault() {
    let (_, mut all) = chapters().into_iter().find(|(name, _)| name == "principal-axes").unwrap();
    assert_eq!(faults("principal-axes", &all), []);
    all.retain(|equation| !equation.tex.contains(r"\le"));
    let faults = faults("principal-axes", &all);
    assert_eq!(faults.len(), 1);
    assert_eq!(faults[0].to_string(), r"`I_1\le I_2\le I_3`: exempt, but no longer there");
}

#[test]
fn an_equation_proven_apart_needs_a_proof_of_that_name() {
    const UNPROVEN: &[Exemption] =
        &[Exemption { tex: "a=b", reason: "proven apart, it is said", proof: Some("no-such-proof") }];
    let found = read(&Expected { exemptions: UNPROVEN, ..Expected::NOTHING }, &equations("$a = b$"));
    assert_eq!(found.faults[0].to_string(), "line 1: `a = b`: no proof has the name `no-such-proof`");
    assert!(found.proven.is_empty() && found.apart.is_empty() && found.exempt.is_empty());
}

/// An exempt equation may only stand as it was when it was exempted.
#[test]
fn an_altered_exempt_equation_is_noticed() {
    for (chapter, expected) in laws::all().unwrap() {
        for exemption in expected.exemptions {
            let altered = exemption.tex.replacen(['x', 'v', '1', 'a', 'l', 'e'], "z", 1);
            let text = format!("${altered}$");
            let faults = faults(chapter, &equations(&text));
            let noticed = faults.iter().any(|fault| fault.line == Some(1));
            assert!(noticed, "{text}: {faults:?}");
        }
    }
}

#[test]
fn faults_say_where_and_what() {
    let fault = |text: &str| faults("a-new-chapter", &equations(text))[0].to_string();
    assert_eq!(
        fault("One.\n\nThen $x = y$."),
        "line 3: `x = y`: no law for a left side `x` is expected here"
    );
    assert_eq!(
        fault(r"$x = \left[ y \right]$"),
        r"line 1: `x = \left[ y \right]`: expected a number, a name or a bracket at byte 9"
    );
    assert_eq!(fault("$x = é$"), "line 1: `x = é`: expected a character of plain TeX at byte 4");
    assert!(
        faults("a-new-chapter", &equations("$x$, $a = 2$, $\\mathbf{v} = (1, 2, 3)$ and $10^{-9}$"))
            .is_empty()
    );
}

/// The residue of a wrong sign in Euler's equations is shown in symbols.
#[test]
fn a_wrong_equation_leaves_what_is_wrong_with_it() {
    let text = r"$\tan\theta = \sqrt{b/a}$";
    let faults = faults("two-arrows", &equations(text));
    assert_eq!(
        faults[0].to_string(),
        r"line 1: `\tan\theta = \sqrt{b/a}`: `\tan\theta` and `\sqrt{b/a}`: the difference: leaves (-2 a d - d^2) / (a^2 + a d)"
    );
}
