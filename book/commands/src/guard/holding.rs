//! Finds for each number of a chapter a phrase in the code of its section that contains it.

use super::certainty::Certainty;
use super::chapter::{Chapter, Section};
use super::digits::{self, Numeral};
use super::facts::Fact;
use super::offence::Offence;
use super::passage::{Kind, Passage};
use super::phrase::{Phrase, nearest, strengthened};
use super::spelled;
use std::collections::HashMap;
use std::ops::Range;

/// The number words that are in no phrase, by chapter, each with the word after it, as often as the chapter
/// has it.
pub(crate) type Words = HashMap<String, Vec<String>>;

/// The data besides the chapter.
#[derive(Debug, Default)]
pub(crate) struct Beside {
    pub(crate) facts: Vec<Fact>,
    /// The title and description of each drawing, by the figure's name.
    pub(crate) drawings: HashMap<String, String>,
    /// A chapter without an entry may have any number words.
    pub(crate) words: Words,
}

/// All that was found in a chapter.
#[derive(Debug, Default)]
pub(crate) struct Findings {
    pub(crate) offences: Vec<Offence>,
    /// The places of the numbers and number words, in bytes of the chapter.
    pub(crate) places: Vec<Range<usize>>,
    /// Each number with its evidence: `file:line: number: holder`.
    pub(crate) held: Vec<String>,
}

/// The evidence for a number, and its certainty.
type Holder = (String, Certainty);

/// Checks a chapter.
pub(crate) fn findings(chapter: &Chapter, beside: &Beside) -> Findings {
    let mut checker = Checker {
        chapter,
        beside,
        found: Findings::default(),
        ordinals: HashMap::new(),
        counting: Vec::new(),
    };
    for section in &chapter.sections {
        checker.section(section);
    }
    checker.facts_are_stated();
    checker.words_are_listed();
    checker.found.offences.sort();
    checker.found
}

struct Checker<'a> {
    chapter: &'a Chapter,
    beside: &'a Beside,
    found: Findings,
    ordinals: HashMap<u8, usize>,
    /// The number words that are in no phrase, and their places.
    counting: Vec<(String, usize)>,
}

impl Checker<'_> {
    fn offend(&mut self, at: usize, found: String, expected: &str) {
        self.found.offences.push(self.chapter.offence(self.chapter.line(at), found, expected));
    }

    fn section(&mut self, section: &Section) {
        let mut phrases = Vec::new();
        for block in &section.blocks {
            phrases.extend(block.code.phrases.iter().map(|phrase| Phrase {
                line: self.chapter.line(block.source(phrase.line, 0)),
                ..phrase.clone()
            }));
            for (line, found, expected) in &block.code.hollow {
                self.offend(block.source(*line, 0), found.clone(), expected);
            }
        }
        let phrases = strengthened(phrases);
        for passage in &section.passages {
            self.passage(passage, &phrases);
        }
        self.asserted_is_said(&phrases);
    }

    /// The text must contain what the code asserts, and numbers in the same order, so that neither they nor
    /// rows of a table can trade places.
    fn asserted_is_said(&mut self, phrases: &[Phrase]) {
        for rows in [true, false] {
            let mut latest: Option<(&Phrase, usize)> = None;
            for phrase in phrases.iter().filter(|p| p.asserted && p.is_row() == rows) {
                let found = format!("`{}`", phrase.text);
                let line = phrase.line;
                match (phrase.said.get(), latest) {
                    (None, _) => {
                        let (found, expected) = (found + ", asserted", "the same in the text of the section");
                        self.found.offences.push(self.chapter.offence(line, found, expected));
                    }
                    (Some(_), _) if phrase.is_words() => {}
                    (Some(at), Some((before, last))) if at < last => {
                        let (text, of) = (&before.text, before.line);
                        let expected =
                            format!("it after `{text}`, as in the assertions of lines {of} and {line}");
                        self.offend(at, found, &expected);
                    }
                    (Some(at), _) => latest = Some((phrase, at)),
                }
            }
        }
    }

    fn passage(&mut self, passage: &Passage, phrases: &[Phrase]) {
        let text = &passage.text;
        let tex: Vec<_> = passage.tex.iter().map(|t| t.at.clone()).collect();
        let mut numbers = digits::numerals(text, &tex);
        if let Kind::Heading(level) = passage.kind {
            self.ordinal(passage, level, &mut numbers);
        }
        let words = spelled::words(text);
        let all = numbers.iter().map(|number| &number.at).chain(words.iter().map(|word| &word.at));
        self.found.places.extend(all.map(|at| span(passage, at)));
        let quoted = self.quoted(passage, phrases);
        let note = passage.kind == Kind::Note;
        for word in words {
            // The code's reader has checked a note's numbers, and each word of it that is a literal of its
            // line.
            let at = passage.source(word.at.start);
            match holder(&quoted, &word.at) {
                _ if note && passage.values.iter().any(|value| word.says(*value)) => {}
                Some(held) if !note => self.hold(at, &text[word.at], held),
                _ => self.counting.push((spelled::counted(text, &word.at), at)),
            }
        }
        if note {
            return;
        }
        let drawing = passage.figure.as_ref().and_then(|name| self.beside.drawings.get(name));
        let mut drawn =
            drawing.map(|words| digits::plain(words).into_iter().map(move |n| digits::with_unit(words, &n)));
        for number in &numbers {
            let own = digits::with_unit(text, number);
            let by_drawing = || in_drawing(own, phrases);
            let holder = match &mut drawn {
                // The alternative text of a figure must repeat its drawing's description, in the same order.
                Some(rest) if passage.kind == Kind::Alt => rest.any(|words| words == own).then(by_drawing),
                _ => holder(&quoted, &number.at)
                    .or_else(|| drawn.clone()?.any(|words| words == own).then(by_drawing)),
            };
            let place = passage.source(number.at.start);
            match holder {
                Some(held) => self.hold(place, own, held),
                None => self.refuse(place, own, passage, phrases),
            }
        }
    }

    fn hold(&mut self, at: usize, own: &str, (name, certainty): Holder) {
        let (file, line) = (&self.chapter.path, self.chapter.line(at));
        self.found.held.push(format!("{file}:{line}: `{own}`: {name}: {certainty}"));
    }

    /// Reports a number without evidence.
    fn refuse(&mut self, at: usize, own: &str, passage: &Passage, phrases: &[Phrase]) {
        if passage.kind == Kind::Alt {
            let figure = passage.figure.as_deref().unwrap_or("?");
            let expected = format!("it in the description inside the drawing `{figure}`, in this order");
            self.offend(at, format!("`{own}` in the words for a figure"), &expected);
        } else {
            let row = passage.kind == Kind::Row && phrases.iter().any(Phrase::is_row);
            let own = if row { passage.text.trim() } else { own };
            self.offend(at, format!("`{own}`"), &nearest(phrases, own));
        }
    }

    /// The stretches of the passage that quote a phrase or a fact.
    fn quoted(&self, passage: &Passage, phrases: &[Phrase]) -> Vec<(Range<usize>, Holder)> {
        let text = &passage.text;
        let rows = passage.kind == Kind::Row && phrases.iter().any(Phrase::is_row);
        let read = !matches!(passage.kind, Kind::Comment | Kind::Note);
        let mut found: Vec<(Range<usize>, Holder)> = Vec::new();
        for fact in self.own_facts() {
            let holder = ("a fact".to_owned(), Certainty::Fact);
            let all = text.match_indices(&fact.text);
            found.extend(all.map(|(at, words)| (at..at + words.len(), holder.clone())));
        }
        for phrase in phrases.iter().filter(|p| p.is_row() || !rows) {
            for at in phrase.quotations(text) {
                let counts = read && (passage.kind != Kind::Alt || phrase.is_words());
                let first = phrase.said.get().or(counts.then(|| passage.source(at.start)));
                phrase.said.set(first);
                found.push((at, (phrase.holder(), phrase.certainty)));
            }
        }
        found
    }

    /// The numbers before headings of one level (`1. The first`) must count up from one.
    fn ordinal(&mut self, passage: &Passage, level: u8, numbers: &mut Vec<Numeral>) {
        let begins = |n: &&Numeral| n.at.start == 0 && passage.text[n.at.end..].starts_with(". ");
        let Some(first) = numbers.first().filter(begins) else { return };
        let next = self.ordinals.entry(level).or_insert(0);
        *next += 1;
        let next = next.to_string();
        self.found.places.push(span(passage, &first.at));
        let own = &passage.text[first.at.clone()];
        if own != next {
            self.offend(passage.source(0), format!("the heading number {own}"), &next);
        }
        numbers.remove(0);
    }

    fn own_facts(&self) -> impl Iterator<Item = &Fact> {
        self.beside.facts.iter().filter(|f| f.chapter == self.chapter.name)
    }

    /// Each number word that is in no phrase must be in the chapter's list, and as often as there.
    fn words_are_listed(&mut self) {
        let Some(listed) = self.beside.words.get(&self.chapter.name) else { return };
        let mut left: Vec<&str> = listed.iter().map(String::as_str).collect();
        for (words, at) in std::mem::take(&mut self.counting) {
            match left.iter().position(|listed| *listed == words) {
                Some(place) => drop(left.swap_remove(place)),
                None => self.offend(at, format!("`{words}`"), LISTED),
            }
        }
        for words in left {
            self.offend(0, format!("no `{words}`"), "it, as book/words.toml lists it, or not there");
        }
    }

    fn facts_are_stated(&mut self) {
        let stated = |fact: &Fact| {
            let mut passages = self.chapter.sections.iter().flat_map(|s| &s.passages);
            passages.any(|p| p.text.contains(&fact.text))
        };
        let gone: Vec<String> = self.own_facts().filter(|f| !stated(f)).map(|f| f.text.clone()).collect();
        for text in gone {
            self.offend(0, format!("no `{text}`"), "these words of the facts file, or no such fact there");
        }
    }
}

/// The requirement on a number word.
const LISTED: &str = "digits that the section's code asserts or notes, or, where it is language, these words for this chapter in book/words.toml";

/// The bytes of the chapter that correspond to these bytes of a passage.
fn span(passage: &Passage, at: &Range<usize>) -> Range<usize> {
    passage.source(at.start)..passage.source(at.end - 1) + 1
}

/// If an assertion of the section contains what a drawing states, its certainty counts.
fn in_drawing(own: &str, phrases: &[Phrase]) -> Holder {
    let says = phrases.iter().filter(|phrase| digits::quotations(&phrase.text, own).next().is_some());
    let certainty = says.map(|phrase| phrase.certainty).reduce(Certainty::with);
    ("the drawing".to_owned(), certainty.unwrap_or(Certainty::Drawn))
}

fn holder(quoted: &[(Range<usize>, Holder)], at: &Range<usize>) -> Option<Holder> {
    let held = quoted.iter().find(|(range, _)| range.start <= at.start && at.end <= range.end);
    held.map(|(_, holder)| holder.clone())
}
