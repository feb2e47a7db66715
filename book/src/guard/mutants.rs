//! The guard's guard: alters the book one digit at a time, and asks whether that would be noticed.
//!
//! - Each digit of each number that the guard binds is replaced by each of the nine others, each minus sign
//!   is taken away, and each quantity in words is replaced by another; the guard must object (or fail to read
//!   the chapter).
//! - Each digit of each literal of an assertion is replaced by each of the nine others. Where the guard does
//!   not object, the assertion itself fails when `cargo test` runs it: it holds today, and the value it
//!   compares with is now another. The exception is a bound, such as the small number on the right of `<`:
//!   altered, it may leave the assertion true, or make it stricter. Those are counted apart.

use super::chapter::{Chapter, Reader};
use super::code::Role;
use super::holding::{self, Beside, Findings, WORDS};
use super::spelled;
use std::fmt;
use std::ops::Range;

/// What became of the alterations of one chapter.
#[derive(Debug, Default)]
pub(crate) struct Tally {
    pub(crate) name: String,
    /// Alterations of numbers in the text, and how many the guard noticed.
    pub(crate) text: Score,
    /// The same for quantities in words.
    pub(crate) words: Score,
    /// Alterations of assertions that the guard noticed.
    pub(crate) claims_by_guard: usize,
    /// Those that fail the assertion they stand in, and that the guard does not notice.
    pub(crate) claims_by_test: usize,
    /// Those of tolerances.
    pub(crate) tolerances: usize,
    /// What went unnoticed in the text: `file:line: kind`, and the altered words.
    pub(crate) survivors: Vec<String>,
}

impl Tally {
    /// Adds what became of another chapter.
    pub(crate) fn add(&mut self, other: &Self) {
        for (mine, others) in [(&mut self.text, other.text), (&mut self.words, other.words)] {
            mine.killed += others.killed;
            mine.made += others.made;
        }
        self.claims_by_guard += other.claims_by_guard;
        self.claims_by_test += other.claims_by_test;
        self.tolerances += other.tolerances;
        self.survivors.extend(other.survivors.iter().cloned());
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (text, words) = (self.text.to_string(), self.words.to_string());
        let claims = format!("{} + {}", self.claims_by_guard, self.claims_by_test);
        let (name, tolerances) = (&self.name, self.tolerances);
        write!(f, "{name:18} {text:>12} {words:>10} {claims:>22} {tolerances:>11}")
    }
}

/// How many of how many.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Score {
    pub(crate) killed: usize,
    pub(crate) made: usize,
}

impl fmt::Display for Score {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.killed, self.made)
    }
}

/// Alters this chapter in every way, one at a time.
pub(crate) fn tally(chapter: &Chapter, beside: &Beside, reader: &mut Reader) -> Tally {
    let Findings { places, claims, .. } = holding::findings(chapter, beside);
    let mut tally = Tally { name: chapter.name.clone(), ..Tally::default() };
    let mut noticed = |text: &str| match reader.chapter(&chapter.name, &chapter.path, text) {
        Ok(altered) => holding::objects(&altered, chapter, beside),
        Err(_) => true,
    };
    for place in &places {
        let own = &chapter.text[place.at.clone()];
        let (before, after) = (&chapter.text[..place.at.start], &chapter.text[place.at.end..]);
        let mut altered: Vec<String> = Vec::new();
        let score = if place.kind == WORDS {
            altered.extend(spelled::altered(own).iter().map(|other| format!("{before}{other}{after}")));
            &mut tally.words
        } else {
            altered.extend(digits(&chapter.text, &place.at).flat_map(|at| other_digits(&chapter.text, at)));
            let positive = own.strip_prefix(['-', '\u{2212}']);
            altered.extend(positive.map(|positive| format!("{before}{positive}{after}")));
            &mut tally.text
        };
        for text in altered {
            score.made += 1;
            if noticed(&text) {
                score.killed += 1;
            } else {
                let line = chapter.line(place.at.start);
                let row = |text: &str| text.lines().nth(line - 1).unwrap_or_default().to_owned();
                let (path, kind, near) = (&chapter.path, place.kind, near(&row(&text), &row(&chapter.text)));
                tally.survivors.push(format!("{path}:{line}: {kind} `{near}`"));
            }
        }
    }
    for claim in &claims {
        for text in digits(&chapter.text, &claim.at).flat_map(|at| other_digits(&chapter.text, at)) {
            match claim.role {
                _ if noticed(&text) => tally.claims_by_guard += 1,
                Role::Tolerance => tally.tolerances += 1,
                _ => tally.claims_by_test += 1,
            }
        }
    }
    tally
}

/// The digits in this range, but not those of a type's name: `3_f64`.
fn digits(text: &str, at: &Range<usize>) -> impl Iterator<Item = usize> {
    let own = &text[at.clone()];
    let end = if own.starts_with('"') { own.len() } else { own.find("_f").unwrap_or(own.len()) };
    (at.start..at.start + end).filter(|&i| text.as_bytes()[i].is_ascii_digit())
}

/// The text with each other digit at this byte.
fn other_digits(text: &str, at: usize) -> impl Iterator<Item = String> {
    (b'0'..=b'9').filter(move |&d| text.as_bytes().get(at) != Some(&d)).map(move |digit| {
        let mut altered = text.as_bytes().to_vec();
        if let Some(byte) = altered.get_mut(at) {
            *byte = digit;
        }
        String::from_utf8(altered).unwrap_or_default()
    })
}

/// The altered line from shortly before where it differs.
fn near(altered: &str, original: &str) -> String {
    let same = altered.chars().zip(original.chars()).take_while(|(a, b)| a == b).count();
    altered.chars().skip(same.saturating_sub(12)).take(30).collect()
}
