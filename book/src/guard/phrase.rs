//! The words with numbers that a section's code holds.

use super::certainty::Certainty;
use super::digits;
use std::cell::Cell;
use std::ops::Range;

/// Words with numbers in a section's code.
pub(super) struct Phrase<'a> {
    pub(super) text: &'a str,
    /// The same as a sentence begins.
    pub(super) first: &'a str,
    pub(super) asserted: bool,
    pub(super) certainty: Certainty,
    /// Its line in the chapter's file.
    pub(super) line: usize,
    /// Where the text says it first.
    pub(super) said: Cell<Option<usize>>,
}

impl Phrase<'_> {
    pub(super) fn is_row(&self) -> bool {
        self.text.starts_with('|')
    }

    /// Where the passage says it: a row as a whole, other phrases anywhere.
    pub(super) fn quotations<'b>(&'b self, text: &'b str) -> impl Iterator<Item = Range<usize>> + 'b {
        let row = (self.is_row() && text.trim() == self.text).then_some(0..text.len());
        let phrase = (!self.is_row()).then_some(self.text);
        let first = phrase.and(Some(self.first).filter(|first| *first != self.text));
        let words = phrase.into_iter().chain(first);
        row.into_iter().chain(words.flat_map(|words| digits::quotations(text, words)))
    }
}

/// The phrases, each with what all that state the same words are worth together. One that is exact or
/// enclosed beside an assertion in floats strengthens it, and need not be said once more.
pub(super) fn strengthened(phrases: Vec<Phrase<'_>>) -> Vec<Phrase<'_>> {
    let sure = |c: Certainty| matches!(c, Certainty::Exact | Certainty::Enclosed);
    let mut kept: Vec<Phrase<'_>> = Vec::new();
    for phrase in phrases {
        let mut again = false;
        for before in kept.iter_mut().filter(|before| before.text == phrase.text) {
            before.certainty = before.certainty.with(phrase.certainty);
            again |= sure(phrase.certainty);
        }
        if !again {
            kept.push(phrase);
        }
    }
    kept
}

/// The phrase that is most like these words: that begins and ends as they do.
pub(super) fn nearest(phrases: &[Phrase<'_>], own: &str) -> String {
    let alike = |phrase: &&Phrase<'_>| {
        let (a, b) = (own.bytes(), phrase.text.bytes());
        let begin = a.clone().zip(b.clone()).take_while(|(a, b)| a == b).count();
        let end = a.rev().zip(b.rev()).take_while(|(a, b)| a == b).count();
        (begin + end, std::cmp::Reverse(phrase.text.len()))
    };
    phrases.iter().max_by_key(alike).map_or_else(
        || "a Rust block in this section that asserts it".into(),
        |near| {
            let (text, line) = (near.text, near.line);
            format!("words that the section's code asserts or notes; nearest is `{text}` in line {line}")
        },
    )
}
