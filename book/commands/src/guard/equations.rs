//! The equations of a chapter, passed to the proofs. Each must be a law that is expected there, be on the
//! short list of exemptions, or only assign values.

use super::chapter::Chapter;
use super::laws;
use super::offence::Offence;
use tumbling_proofs::Kind;
use tumbling_proofs::equations::{Equation, Fault, Settled, read};

/// The kinds of evidence for an equation, strongest first; a lemma says nothing of the library.
#[rustfmt::skip]
pub(super) const KINDS: [&str; 8] = ["proven through the library", "proven of a second derivation", "lemma",
    "as text, a part of it proven", "as text, a part of it a lemma", "exempt", "notation", "values"];

/// The maths of a chapter, as written.
fn maths(chapter: &Chapter) -> Vec<Equation> {
    let passages = chapter.sections.iter().flat_map(|section| &section.passages);
    passages
        .flat_map(|passage| {
            passage.tex.iter().map(|tex| Equation {
                line: chapter.line(passage.source(tex.at.start)),
                tex: tex.written.clone(),
                display: tex.display,
            })
        })
        .collect()
}

/// Proves the equations of a chapter; an equation that cannot be proven is an offence.
///
/// # Errors
/// The list of exemptions cannot be read.
pub(crate) fn offences(chapter: &Chapter, held: &mut Vec<String>) -> Result<Vec<Offence>, String> {
    let read = read(&laws::of(&chapter.name)?, &maths(chapter));
    let of = |kind| move |s: &Settled| s.kind == Some(kind);
    let (library, rest): (Vec<_>, Vec<_>) = read.proven.into_iter().partition(of(Kind::Library));
    let [(lemmas, again), (parts, apart)] =
        [rest, read.apart].map(|all| all.into_iter().partition(of(Kind::Lemma)));
    let kinds: [Vec<_>; 8] = [library, again, lemmas, apart, parts, read.exempt, read.notation, read.values];
    for (settled, how) in kinds.into_iter().zip(KINDS) {
        let line = |s: &Settled| format!("{}:{}: `{}`: {how}: {}", chapter.path, s.line, s.tex, s.why);
        held.extend(settled.iter().map(line));
    }
    let offence = |Fault { line, tex, problem }| {
        let expected = format!("an equation that is proven ({problem})");
        chapter.offence(line.unwrap_or(1), format!("`{tex}`"), &expected)
    };
    Ok(read.faults.into_iter().map(offence).collect())
}

/// Chapters that have laws to prove and are not among these.
///
/// # Errors
/// The list of laws cannot be read.
pub(crate) fn missing(chapters: &[Chapter]) -> Result<Vec<&'static str>, String> {
    let known = laws::all()?.iter().map(|known| known.0);
    Ok(known.filter(|name| chapters.iter().all(|chapter| chapter.name != *name)).collect())
}

#[cfg(test)]
mod tests;
