//! The phrases with numbers in a section's code.

use super::certainty::Certainty;
use super::digits;
use std::cell::Cell;
use std::ops::Range;

/// Words with numbers, which the text may repeat.
#[derive(Debug, Clone)]
pub(crate) struct Phrase {
    pub(super) text: String,
    /// The text as it begins a sentence.
    pub(super) first: String,
    /// Whether an assertion expects it; then the text must repeat it. Otherwise it is a note at the end of a
    /// line.
    pub(super) asserted: bool,
    /// The certainty of the assertion; for the note of an input, `Given`.
    pub(super) certainty: Certainty,
    /// The line: within the block, from zero, for a phrase of a block; in the chapter's file, for one of a
    /// section.
    pub(super) line: usize,
    /// The first place where the text has it.
    pub(super) said: Cell<Option<usize>>,
}

impl Phrase {
    pub(super) fn new(text: &str, asserted: bool, line: usize, certainty: Certainty) -> Self {
        let text = text.replace('\u{2212}', "-");
        let mut first = text.clone();
        if let Some(letter) = first.get_mut(..1) {
            letter.make_ascii_uppercase();
        }
        Self { text, first, asserted, certainty, line, said: Cell::new(None) }
    }

    pub(super) fn is_row(&self) -> bool {
        self.text.starts_with('|')
    }

    /// Whether it has no number: then it may stand anywhere in the section, in a figure's words too.
    pub(super) fn is_words(&self) -> bool {
        digits::plain(&self.text).is_empty()
    }

    /// A description of it.
    pub(super) fn holder(&self) -> String {
        format!("the {} in line {}", if self.asserted { "assertion" } else { "note" }, self.line)
    }

    /// The places where the passage has it: a row as a whole, other phrases anywhere.
    pub(super) fn quotations<'b>(&'b self, text: &'b str) -> impl Iterator<Item = Range<usize>> + 'b {
        let row = (self.is_row() && text.trim() == self.text).then_some(0..text.len());
        let phrase = (!self.is_row()).then_some(&self.text);
        let first = phrase.and(Some(&self.first).filter(|first| **first != self.text));
        let words = phrase.into_iter().chain(first);
        row.into_iter().chain(words.flat_map(|words| digits::quotations(text, words)))
    }
}

/// The phrases, each with the certainty of all phrases with the same words together. A phrase that is exact
/// or enclosed strengthens an equal one in floats, and the text need not repeat it.
pub(super) fn strengthened(phrases: Vec<Phrase>) -> Vec<Phrase> {
    let sure = |c: Certainty| matches!(c, Certainty::Exact | Certainty::Enclosed);
    let mut kept: Vec<Phrase> = Vec::new();
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

/// The phrase that is most similar to these words: the one with the longest common beginning and end.
pub(super) fn nearest(phrases: &[Phrase], own: &str) -> String {
    let alike = |phrase: &&Phrase| {
        let (a, b) = (own.bytes(), phrase.text.bytes());
        let begin = a.clone().zip(b.clone()).take_while(|(a, b)| a == b).count();
        let end = a.rev().zip(b.rev()).take_while(|(a, b)| a == b).count();
        (begin + end, std::cmp::Reverse(phrase.text.len()))
    };
    phrases.iter().max_by_key(alike).map_or_else(
        || "a Rust block in this section that asserts it".into(),
        |near| {
            let (text, line) = (&near.text, near.line);
            format!("words that the section's code asserts or notes; nearest is `{text}` in line {line}")
        },
    )
}
