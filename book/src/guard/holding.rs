//! Holds each number of a chapter to a phrase that stands in its section's code.

use super::certainty::Certainty;
use super::chapter::{Chapter, Section};
use super::counts::Counts;
use super::digits::{self, Numeral};
use super::facts::Fact;
use super::offence::Offence;
use super::passage::{Kind, Passage};
use super::phrase::{Phrase, nearest, strengthened};
use super::spelled;
use std::cell::Cell;
use std::collections::HashMap;
use std::ops::Range;

/// The words that count, with what they count, by chapter; each as often as it is said.
pub(crate) type Words = HashMap<String, Vec<String>>;

/// What there is besides the chapter.
#[derive(Debug, Default)]
pub(crate) struct Beside {
    pub(crate) facts: Vec<Fact>,
    /// What the drawings say of themselves, title and description, by the figure's name.
    pub(crate) drawings: HashMap<String, String>,
    /// The words that count, with what they count, by the chapter's name. Those of other chapters are free.
    pub(crate) words: Words,
}

/// All that was found in a chapter.
#[derive(Debug, Default)]
pub(crate) struct Findings {
    pub(crate) offences: Vec<Offence>,
    pub(crate) counts: Counts,
    /// Where the numbers and number words of the text stand in the chapter's bytes.
    pub(crate) places: Vec<Range<usize>>,
    /// Each number and what holds it: `file:line: number: holder`.
    pub(crate) held: Vec<String>,
}

/// What holds a number.
#[derive(Debug, Clone, Copy)]
enum Holder {
    Assertion(usize, Certainty),
    Note(usize, Certainty),
    Fact,
    Drawing,
}

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
    /// The words that count, and where.
    counting: Vec<(String, usize)>,
}

impl Checker<'_> {
    fn offend(&mut self, at: usize, found: String, expected: String) {
        let line = self.chapter.line(at);
        self.found.offences.push(Offence { file: self.chapter.path.clone(), line, found, expected });
    }

    fn section(&mut self, section: &Section) {
        let mut phrases = Vec::new();
        for block in &section.blocks {
            phrases.extend(block.code.phrases.iter().map(|phrase| Phrase {
                text: &phrase.text,
                first: &phrase.first,
                asserted: phrase.asserted,
                certainty: phrase.certainty,
                line: self.chapter.line(block.source(phrase.line, 0)),
                said: Cell::new(None),
            }));
            for (line, found, expected) in &block.code.hollow {
                self.offend(block.source(*line, 0), found.clone(), (*expected).to_owned());
            }
        }
        let phrases = strengthened(phrases);
        for passage in &section.passages {
            self.passage(passage, &phrases);
        }
        self.asserted_is_said(&phrases);
    }

    /// The text says what the code asserts, and in the same order: so numbers cannot trade places, nor rows
    /// of a table.
    fn asserted_is_said(&mut self, phrases: &[Phrase<'_>]) {
        for rows in [true, false] {
            let mut latest: Option<(&Phrase<'_>, usize)> = None;
            for phrase in phrases.iter().filter(|p| p.asserted && p.is_row() == rows) {
                let found = format!("`{}`", phrase.text);
                let line = phrase.line;
                match (phrase.said.get(), latest) {
                    (None, _) => self.found.offences.push(Offence {
                        file: self.chapter.path.clone(),
                        line,
                        found: format!("{found}, asserted"),
                        expected: "the same in the text of the section".into(),
                    }),
                    (Some(at), Some((before, last))) if at < last => {
                        let (text, of) = (before.text, before.line);
                        self.offend(
                            at,
                            found,
                            format!("it after `{text}`, as in the assertions of lines {of} and {line}"),
                        );
                    }
                    (Some(at), _) => latest = Some((phrase, at)),
                }
            }
        }
    }

    fn passage(&mut self, passage: &Passage, phrases: &[Phrase<'_>]) {
        let text = &passage.text;
        let tex: Vec<_> = passage.tex.iter().map(|t| t.at.clone()).collect();
        let (mut numbers, structural) = digits::numerals(text, &tex);
        self.found.counts.structural += structural;
        if let Kind::Heading(level) = passage.kind {
            self.ordinal(passage, level, &mut numbers);
        }
        let (words, counting) = spelled::spelled(text);
        self.found.counts.counting += counting.len();
        let all = numbers.iter().map(|number| &number.at).chain(words.iter().map(|word| &word.at));
        self.found.places.extend(all.map(|at| span(passage, at)));
        self.found.counts.all += numbers.len() + words.len();
        if passage.kind == Kind::Note {
            // The code's reader holds them.
            let line = self.chapter.line(passage.source(0));
            let own = phrases.iter().find(|p| p.line == line && !p.asserted);
            let certainty = own.map_or(Certainty::Given, |p| p.certainty);
            self.found.counts.by_note += numbers.len() + words.len();
            *self.found.counts.certainty.entry(certainty).or_default() += numbers.len() + words.len();
            counting.iter().for_each(|at| self.count(passage, at));
            return;
        }
        if numbers.is_empty() && words.is_empty() && counting.is_empty() {
            return;
        }
        let quoted = self.quoted(passage, phrases);
        let free = counting.iter().filter(|at| holder(&quoted, at).is_none());
        free.for_each(|at| self.count(passage, at));
        let drawing = passage.figure.as_ref().and_then(|name| self.beside.drawings.get(name));
        let mut drawn =
            drawing.map(|words| digits::plain(words).into_iter().map(move |n| digits::with_unit(words, &n)));
        for number in &numbers {
            let own = digits::with_unit(text, number);
            let holder = match &mut drawn {
                // The words for a figure say what the drawing says of itself, in the same order.
                Some(rest) if passage.kind == Kind::Alt => {
                    rest.any(|words| words == own).then_some(Holder::Drawing)
                }
                _ => holder(&quoted, &number.at)
                    .or_else(|| drawn.clone()?.any(|words| words == own).then_some(Holder::Drawing)),
            };
            self.settle(passage, own, &number.at, holder, phrases);
        }
        for word in words {
            let own = &text[word.at.clone()];
            let drawn = || drawing.filter(|words| words.contains(own)).map(|_| Holder::Drawing);
            let holder = holder(&quoted, &word.at).or_else(drawn);
            self.settle(passage, own, &word.at, holder, phrases);
        }
    }

    /// Notes a word that only counts, for the list.
    fn count(&mut self, passage: &Passage, at: &Range<usize>) {
        self.counting.push((spelled::counted(&passage.text, at), passage.source(at.start)));
        self.found.places.push(span(passage, at));
    }

    /// The stretches of the passage that quote a phrase or a fact.
    fn quoted(&self, passage: &Passage, phrases: &[Phrase<'_>]) -> Vec<(Range<usize>, Holder)> {
        let text = &passage.text;
        let rows = passage.kind == Kind::Row && phrases.iter().any(Phrase::is_row);
        let read = matches!(passage.kind, Kind::Prose | Kind::Row | Kind::Heading(_));
        let mut found: Vec<(Range<usize>, Holder)> = Vec::new();
        for fact in self.own_facts() {
            found.extend(
                text.match_indices(&fact.text).map(|(at, words)| (at..at + words.len(), Holder::Fact)),
            );
        }
        for phrase in phrases.iter().filter(|p| p.is_row() || !rows) {
            for at in phrase.quotations(text) {
                if read && phrase.said.get().is_none() {
                    phrase.said.set(Some(passage.source(at.start)));
                }
                let line = phrase.line;
                let holder = if phrase.asserted { Holder::Assertion } else { Holder::Note };
                found.push((at, holder(line, phrase.certainty)));
            }
        }
        found
    }

    /// Counts what holds a number, or objects.
    fn settle(
        &mut self,
        passage: &Passage,
        own: &str,
        at: &Range<usize>,
        holder: Option<Holder>,
        phrases: &[Phrase<'_>],
    ) {
        // What a drawing says, an assertion of the section may say too.
        let says = |p: &&Phrase<'_>| digits::quotations(p.text, own).next().is_some();
        let also = phrases.iter().filter(says).map(|p| p.certainty).reduce(Certainty::with);
        let also = also.unwrap_or(Certainty::Drawn);
        let counts = &mut self.found.counts;
        let place = passage.source(at.start);
        let (count, name, certainty) = match holder {
            Some(Holder::Assertion(line, certainty)) => {
                (&mut counts.by_assertion, format!("the assertion in line {line}"), certainty)
            }
            Some(Holder::Note(line, certainty)) => {
                (&mut counts.by_note, format!("the note in line {line}"), certainty)
            }
            Some(Holder::Fact) => (&mut counts.by_fact, "a fact".into(), Certainty::Fact),
            Some(Holder::Drawing) => (&mut counts.by_drawing, "the drawing".into(), also),
            None if passage.kind == Kind::Alt => {
                let figure = passage.figure.as_deref().unwrap_or("?");
                let expected = format!("it in the description inside the drawing `{figure}`, in this order");
                return self.offend(place, format!("`{own}` in the words for a figure"), expected);
            }
            None => {
                let row = passage.kind == Kind::Row && phrases.iter().any(Phrase::is_row);
                let own = if row { passage.text.trim() } else { own };
                return self.offend(place, format!("`{own}`"), nearest(phrases, own));
            }
        };
        *count += 1;
        *counts.certainty.entry(certainty).or_default() += 1;
        let (file, line) = (&self.chapter.path, self.chapter.line(place));
        self.found.held.push(format!("{file}:{line}: `{own}`: {name}: {certainty}"));
    }

    /// `1. The first` and so on: the numbers before headings of one level count up from one.
    fn ordinal(&mut self, passage: &Passage, level: u8, numbers: &mut Vec<Numeral>) {
        let Some(first) = numbers.first() else { return };
        if first.at.start != 0 || !passage.text[first.at.end..].starts_with(". ") {
            return;
        }
        let next = self.ordinals.entry(level).or_insert(0);
        *next += 1;
        let next = next.to_string();
        self.found.counts.ordinals += 1;
        self.found.places.push(span(passage, &first.at));
        let own = &passage.text[first.at.clone()];
        if own != next {
            self.offend(passage.source(0), format!("the heading number {own}"), next);
        }
        numbers.remove(0);
    }

    fn own_facts(&self) -> impl Iterator<Item = &Fact> {
        self.beside.facts.iter().filter(|f| f.chapter == self.chapter.name)
    }

    /// Each word that counts stands in the chapter's list with what it counts, and as often as there.
    fn words_are_listed(&mut self) {
        let Some(listed) = self.beside.words.get(&self.chapter.name) else { return };
        let mut left: Vec<&str> = listed.iter().map(String::as_str).collect();
        for (words, at) in std::mem::take(&mut self.counting) {
            match left.iter().position(|listed| *listed == words) {
                Some(place) => drop(left.swap_remove(place)),
                None => self.offend(at, format!("`{words}`"), LISTED.into()),
            }
        }
        for words in left {
            let expected = "it, as book/words.toml lists it, or not there";
            self.offend(0, format!("no `{words}`"), expected.into());
        }
    }

    fn facts_are_stated(&mut self) {
        let stated = |fact: &Fact| {
            let mut passages = self.chapter.sections.iter().flat_map(|s| &s.passages);
            passages.any(|p| p.text.contains(&fact.text))
        };
        let gone: Vec<String> = self.own_facts().filter(|f| !stated(f)).map(|f| f.text.clone()).collect();
        for text in gone {
            let expected = "these words of the facts file, or no such fact there";
            self.offend(0, format!("no `{text}`"), expected.into());
        }
    }
}

/// What a word that counts must be.
const LISTED: &str = "digits that the section's code asserts or notes, or, where it is language, these words for this chapter in book/words.toml";

/// The bytes of the chapter from which these of a passage came.
fn span(passage: &Passage, at: &Range<usize>) -> Range<usize> {
    passage.source(at.start)..passage.source(at.end - 1) + 1
}

fn holder(quoted: &[(Range<usize>, Holder)], at: &Range<usize>) -> Option<Holder> {
    let held = quoted.iter().find(|(range, _)| range.start <= at.start && at.end <= range.end);
    held.map(|(_, holder)| *holder)
}
