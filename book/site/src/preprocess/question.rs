//! Questions: a quote that begins with `**Predict.**` asks something before the text answers it. If scripts
//! run, its answer is hidden until the reader has chosen.
//!
//! Such a quote has a paragraph with the question, optionally a list of answers to choose from, and a
//! paragraph that begins with the right answer in italics and continues with the reason. Without a list, the
//! right answer is a number with its unit, and the reader sets a slider; the script
//! `../../../theme/questions.js` does the rest. The box has the id `CHAPTER-question-NUMBER`.

use super::edits::Edits;
use super::{Piece, Source, nested};
use pulldown_cmark::{Event, Tag, TagEnd};
use std::ops::Range;

/// How a question begins.
const OPENING: &str = "> **Predict.**";

/// Puts a box around each question of a chapter; returns what was wrong.
pub(super) fn replace(source: &Source<'_>, pieces: &[Piece<'_>], edits: &mut Edits) -> Vec<String> {
    let mut faults = Vec::new();
    let mut number = 0_usize;
    for (at, depth, (event, range)) in nested(pieces) {
        if let Event::Start(Tag::BlockQuote(_)) = event
            && source.text[range.clone()].starts_with(OPENING)
        {
            match wrong(source.text, &pieces[at..], range, depth) {
                None => {
                    number += 1;
                    let start =
                        format!("<div class=\"question\" id=\"{}-question-{number}\">\n\n", source.name());
                    edits.replace(range.start..range.start, start);
                    edits.replace(range.end..range.end, "\n</div>\n\n".to_owned());
                }
                Some(what) => faults.push(source.fault(range.start, what)),
            }
        }
    }
    faults
}

/// The right answer of each question of a chapter, and where the question begins.
pub fn answers(text: &str) -> Vec<(usize, String)> {
    let pieces = super::pieces(text);
    let opens = |range: &Range<usize>| text[range.clone()].starts_with(OPENING);
    let questions = pieces
        .iter()
        .filter(|(event, range)| matches!(event, Event::Start(Tag::BlockQuote(_))) && opens(range));
    let right = |(_, range): &Piece<'_>| {
        let (_, answer) = text[range.clone()].rsplit_once("\n>\n> *")?;
        Some((range.start, plain(answer.split_once('*')?.0)))
    };
    questions.filter_map(right).collect()
}

/// The reason why this quote, the first of the pieces, is not a question.
fn wrong(text: &str, pieces: &[Piece<'_>], quote: &Range<usize>, depth: usize) -> Option<String> {
    if depth > 0 {
        return Some("a question stands in no list and no other quote".to_owned());
    }
    let inside = || pieces.iter().skip(1).take_while(|(_, range)| range.end <= quote.end);
    let options: Vec<String> = inside()
        .filter(|(event, _)| matches!(event, Event::Start(Tag::Item)))
        .map(|(_, range)| plain(text[range.clone()].trim_start_matches(['-', '*', ' '])))
        .collect();
    let last = inside().filter(|(event, _)| matches!(event, Event::End(TagEnd::Paragraph))).last()?;
    let answer = &text[last.1.clone()];
    let Some((right, why)) = answer.strip_prefix('*').and_then(|answer| answer.split_once('*')) else {
        return Some("a question ends with the right answer, in italics, and the reason".to_owned());
    };
    if plain(why).trim_start_matches([':', ',', '.', ' ']).is_empty() {
        return Some("the right answer is followed by the reason".to_owned());
    }
    let right = plain(right);
    if options.is_empty() {
        let number = right.starts_with(|first: char| first.is_ascii_digit());
        return (!number)
            .then(|| format!("without a list of answers the right one is a number, not `{right}`"));
    }
    let matching = options.iter().filter(|option| **option == right).count();
    (matching != 1 || options.len() < 2)
        .then(|| format!("of the answers to choose from one, not {matching}, must read `{right}`"))
}

/// A text in one line, without the marks of a quote.
fn plain(text: &str) -> String {
    let lines = text.lines().map(|line| line.trim_start_matches(['>', ' ']));
    lines.collect::<Vec<_>>().join(" ").trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::preprocess::pieces;

    fn shown(text: &str) -> Result<String, Vec<String>> {
        let mut edits = Edits::default();
        let source = Source { file: "book/chapters/x.md", text };
        let faults = replace(&source, &pieces(text), &mut edits);
        if faults.is_empty() { Ok(edits.applied_to(text)) } else { Err(faults) }
    }

    const CHOICE: &str = "One.\n\n> **Predict.** Which way?\n>\n> - Along it\n> - Across $x$\n>\n> *Across $x$*: it\n> must.\n\nTwo.\n";

    #[test]
    fn a_question_is_put_into_a_box() {
        let boxed = CHOICE
            .replace("> **Pre", "<div class=\"question\" id=\"x-question-1\">\n\n> **Pre")
            .replace("must.\n", "must.\n\n</div>\n\n");
        assert_eq!(shown(CHOICE).unwrap(), boxed);
        assert!(shown("> **Predict.** How long?\n>\n> *0.64 s*, well before.\n").is_ok());
        let other = "> **A sign.** None.\n";
        assert_eq!(shown(other).unwrap(), other);
    }

    #[test]
    fn a_question_that_cannot_be_answered_is_a_fault() {
        for (from, to, what) in [
            ("*Across $x$*", "Across", "ends with the right answer"),
            ("*Across $x$*", "*Across $y$*", "not 0, must read `Across $y$`"),
            ("Along it", "Across $x$", "not 2, must read"),
            (": it\n> must.", "", "followed by the reason"),
            ("> - Along it\n> - Across $x$\n>\n", "", "is a number, not `Across $x$`"),
        ] {
            let faults = shown(&CHOICE.replace(from, to)).unwrap_err();
            assert!(faults[0].contains(what) && faults[0].contains("x.md:3"), "{faults:?}");
        }
    }
}
