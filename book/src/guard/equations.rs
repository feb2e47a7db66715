//! The equations of a chapter, passed to the proofs. Each must be a law of the library's own functions, be on
//! the short list of exemptions, or only assign values.

use super::chapter::Chapter;
use super::laws;
use super::offence::Offence;
use tumbling_proofs::equations::{Equation, Fault, read};

/// The kinds of evidence for an equation, strongest first: proven from functions of the library, or less.
#[rustfmt::skip]
pub(super) const KINDS: [&str; 6] = ["proven", "proven of a formula written again", "as text, a part of it proven",
    "exempt", "notation", "values"];

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
    let (again, proven): (Vec<_>, _) = read.proven.into_iter().partition(|s| s.again);
    let kinds = [proven, again, read.apart, read.exempt, read.notation, read.values];
    for (settled, how) in kinds.into_iter().zip(KINDS) {
        held.extend(settled.iter().map(|s| {
            let (file, line) = (&chapter.path, s.line);
            format!("{file}:{line}: `{}`: {how}: {}", s.tex, s.why)
        }));
    }
    let offence = |Fault { line, tex, problem }| {
        let expected = format!("an equation that the library's functions prove ({problem})");
        chapter.offence(line.unwrap_or(1), format!("`{tex}`"), &expected)
    };
    Ok(read.faults.into_iter().map(offence).collect())
}

/// Chapters that have laws to prove and are not among these.
pub(crate) fn missing(chapters: &[Chapter]) -> Vec<&'static str> {
    let known = laws::CHAPTERS.iter().map(|known| known.0);
    known.filter(|name| chapters.iter().all(|chapter| chapter.name != *name)).collect()
}

#[cfg(test)]
mod tests;
