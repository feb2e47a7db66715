//! The book in another language: `book/words.CODE.toml` maps English words to those of its pages, figures,
//! films, sheets and widgets.
//!
//! A page `NAME-CODE.md` is the chapter `NAME.md` with each paragraph, heading and item replaced by its
//! translation; code, figures, widgets and formulas are unchanged. The chapter's code supports the numbers of
//! the translation too: each paragraph must have the same numbers, units, number words and targets of links
//! as the original, in the same order. A paragraph that only one of the two has is an error: the translation
//! is not up to date.

use crate::digits::{plain as numerals, with_unit};
use crate::preprocess::blanks;
use crate::spelled;
use crate::{files, paths};
use regex::{Captures, Regex};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::LazyLock;

type Words = BTreeMap<String, String>;

/// A language, as its file has it.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Language {
    /// Its code, `de`.
    #[serde(skip)]
    pub code: String,
    /// The file, for the lines of its entries.
    #[serde(skip)]
    text: String,
    /// For each English number word, the words of the language, divided by blanks; empty where the word is
    /// not a count.
    numbers: Words,
    /// Words of figures, films, sheets and widgets: whole labels and parts of them.
    words: Words,
    /// The texts around the contents of a page, each as a whole: labels, and text between two tags.
    frame: Words,
    /// The paragraphs of each page.
    pub page: BTreeMap<String, Words>,
}

/// The units that may follow a number.
pub const UNITS: [&str; 16] =
    ["s", "ms", "min", "mm", "cm", "m", "kg", "g", "rad", "rad/s", "Hz", "J", "N", "×", "°", "%"];

/// A label that screen readers read.
static LABEL: LazyLock<Regex> = LazyLock::new(|| Regex::new(r#"(aria-label|alt)="([^"]*)"?"#).unwrap());

/// The target of a link, with the brackets around it.
static TARGET: LazyLock<Regex> = LazyLock::new(|| Regex::new(r"\]\(([^)]*)\)?").unwrap());

static WORD: LazyLock<Regex> = LazyLock::new(|| Regex::new(r"\p{Alphabetic}[\p{Alphabetic}/]*").unwrap());

impl Language {
    /// The language of this code.
    ///
    /// # Errors
    /// A file that cannot be read, or a translation that has other numbers or links than the original.
    pub fn read(code: &str) -> Result<Self, String> {
        let text = files::text(&paths::book().join(format!("words.{code}.toml")));
        Self::parse(code, &text.map_err(|_| format!("there is no book/words.{code}.toml"))?)
    }

    fn parse(code: &str, text: &str) -> Result<Self, String> {
        let found: Self = toml::from_str(text).map_err(|e| format!("book/words.{code}.toml: {e}"))?;
        let mut found = Self { code: code.to_owned(), text: text.to_owned(), ..found };
        let all = found.page.values().flatten().chain(&found.words).chain(&found.frame);
        let wrong: Vec<String> = all.filter_map(|(own, said)| found.differs(own, said)).collect();
        found.page.values_mut().flat_map(Words::values_mut).for_each(|said| *said = blanks::kept(said));
        if wrong.is_empty() { Ok(found) } else { Err(wrong.join("\n")) }
    }

    /// The language of a page `NAME-CODE`, and the chapter that it translates; `None` for a page of the book
    /// itself.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn of(page: &str) -> Result<Option<(Self, &str)>, String> {
        let parts = page.trim_end_matches(".md").rsplit_once('-');
        let known = parts.filter(|(_, code)| paths::book().join(format!("words.{code}.toml")).is_file());
        known.map(|(name, code)| Ok((Self::read(code)?, name))).transpose()
    }

    /// What is wrong with an entry, with its line; an entry that is not there has no translation and no line.
    pub fn fault(&self, original: &str, said: &str, what: &str) -> String {
        let [own, said] = [original, said].map(|words| serde_json::to_string(words).unwrap_or_default());
        let entry = format!("{own} = {said}").replace('\u{a0}', " ");
        let line = self.text.lines().position(|line| line == entry);
        let line = line.map_or(String::new(), |at| format!(":{}", at + 1));
        format!("book/words.{}.toml{line}: `{original:.70}`: {what}", self.code)
    }

    /// What differs between a translation and its original.
    fn differs(&self, original: &str, said: &str) -> Option<String> {
        let ((text, links), (own, own_links)) = (without_targets(original), without_targets(said));
        let (there, here) = (self.original_numbers(&text), self.own_numbers(&own));
        let numbers = || format!("the numbers {here:?} where the original has {there:?}");
        let other = links != own_links && !original.starts_with("{{#");
        let links = other.then(|| "other links than in the original".into());
        let what = (there != here).then(numbers).or(links);
        what.map(|what| self.fault(original, said, &what))
    }

    fn original_numbers(&self, text: &str) -> Vec<String> {
        let counts = |word: &String| self.numbers.get(word).is_none_or(|own| !own.is_empty());
        let words =
            spelled::words(text).into_iter().map(|word| (word.at.start, text[word.at].to_lowercase()));
        let words = words.filter(|(_, word)| counts(word));
        let phrases = self.numbers.keys().filter(|words| words.contains(' '));
        let phrases = phrases.flat_map(|words| text.match_indices(words.as_str()));
        let phrases = phrases.map(|(at, words)| (at, words.to_owned()));
        in_order(digits(text).chain(words).chain(phrases))
    }

    fn own_numbers(&self, text: &str) -> Vec<String> {
        // A decimal point is an error in this language, so it splits the number in two here.
        let points = with(&with(text, '.', ';'), ',', '.');
        let lower = text.to_lowercase();
        let words = words_of(&lower).filter_map(|at| {
            let word = &lower[at.clone()];
            let known = self.numbers.iter().find(|(_, own)| own.split(' ').any(|own| own == word));
            Some((at.start, known?.0.clone()))
        });
        in_order(digits(&points).chain(words))
    }

    /// The chapter in this language.
    ///
    /// # Errors
    /// Each paragraph without a translation, with its line, and each translation without a paragraph.
    pub fn page(&self, name: &str) -> Result<String, String> {
        let text = files::text(&paths::chapters().join(format!("{name}.md")))?;
        let known = self.page.get(name).cloned().unwrap_or_default();
        let (mut out, mut end, mut wrong) = (String::new(), 0, self.behind()?);
        for item in items(&text) {
            let original = in_one_line(&text[item.clone()]);
            match known.get(&original) {
                Some(said) => {
                    let right = |text: &str| Some(text.strip_prefix('*')?.split_once('*')?.0.to_owned());
                    let option = right(&original).and_then(|right| known.get(&right));
                    let other = option.filter(|option| right(said).as_ref() != Some(*option));
                    let what = "another answer where the original has the right one";
                    wrong.extend(other.map(|_| self.fault(&original, said, what)));
                    out.push_str(&text[end..item.start]);
                    out.push_str(said);
                    end = item.end;
                }
                None if original.starts_with("{{#") => {}
                None => {
                    let line = 1 + text[..item.start].matches('\n').count();
                    let place = format!("not there; it is in book/chapters/{name}.md:{line}");
                    wrong.push(self.fault(&original, "", &place));
                }
            }
        }
        if wrong.is_empty() { Ok(out + &text[end..]) } else { Err(wrong.join("\n")) }
    }

    /// The translations whose original is not in its chapter.
    fn behind(&self) -> Result<Vec<String>, String> {
        let mut wrong = Vec::new();
        for (page, known) in &self.page {
            let text = files::text(&paths::chapters().join(format!("{page}.md")))?;
            let there: Vec<_> = items(&text).into_iter().map(|item| in_one_line(&text[item])).collect();
            let what = format!("{page}.md says it no more");
            let lost = known.iter().filter(|(own, _)| !there.contains(*own));
            wrong.extend(lost.map(|(own, said)| self.fault(own, said, &what)));
        }
        Ok(wrong)
    }

    /// A label in this language, translated as a whole or part by part; and its words without a translation.
    pub fn label(&self, text: &str) -> (String, Vec<String>) {
        let own = text.trim();
        if let Some(said) = self.words.get(own) {
            return (text.replacen(own, said, 1), Vec::new());
        }
        let text = with(text, '.', ',');
        let (mut out, mut unknown, mut at) = (String::new(), Vec::new(), 0);
        for word in words_of(&text) {
            if word.start < at {
                continue;
            }
            let rest = &text[word.start..];
            let whole = |part: &&String| !rest[part.len()..].starts_with(char::is_alphabetic);
            let parts = self.words.keys().filter(|part| rest.starts_with(*part)).filter(whole);
            let known = parts.max_by_key(|part| part.len());
            let own = &text[word.clone()];
            out.push_str(&text[at..word.start]);
            out.push_str(known.map_or(own, |part| &self.words[part]));
            at = known.map_or(word.end, |part| word.start + part.len());
            if known.is_none() && own.chars().count() > 2 && !UNITS.contains(&own) {
                unknown.push(own.to_owned());
            }
        }
        (out + &text[at..], unknown)
    }

    /// HTML or SVG in this language: text between tags, and labels for screen readers.
    ///
    /// Also returns the labels with words that have no translation.
    pub fn markup(&self, html: &str) -> (String, Vec<String>) {
        let (mut out, mut wrong, mut raw) = (String::new(), Vec::new(), false);
        let mut said = |text: &str| {
            let (label, unknown) = self.label(text);
            if !unknown.is_empty() {
                let what = format!("not there, as a label; of it, `{}` is not known", unknown.join(" "));
                wrong.push(self.fault(text.trim(), "", &what));
            }
            label
        };
        for part in html.split_inclusive(['<', '>']) {
            if let Some(text) = part.strip_suffix('<') {
                out.push_str(&if raw { text.to_owned() } else { said(text) });
                out.push('<');
                continue;
            }
            let opens = ["style", "script", "code"].iter().any(|tag| part.starts_with(tag));
            raw = opens || (raw && !part.starts_with('/'));
            let own = |label: &Captures<'_>| format!("{}=\"{}\"", &label[1], said(&label[2]));
            out.push_str(&LABEL.replace_all(part, own));
        }
        (out, wrong)
    }

    /// A built page, with the texts around its contents in this language.
    ///
    /// # Errors
    /// The texts that no page has.
    pub fn framed(&self, html: &str) -> Result<String, String> {
        let mut page = html.replacen("<html lang=\"en\"", &format!("<html lang=\"{}\"", self.code), 1);
        let mut wrong = Vec::new();
        for (original, said) in &self.frame {
            let put = |page: &str, [before, after]: [&str; 2]| {
                page.replace(&format!("{before}{original}{after}"), &format!("{before}{said}{after}"))
            };
            let framed = put(&put(&page, [">", "<"]), ["=\"", "\""]);
            let what = "the frame of a page says it no more";
            wrong.extend((framed == page).then(|| self.fault(original, said, what)));
            page = framed;
        }
        if wrong.is_empty() { Ok(page) } else { Err(wrong.join("\n")) }
    }

    /// A page as shown, from Markdown with raw HTML in it: also the HTML in this language, and the words for
    /// scripts.
    ///
    /// # Errors
    /// The labels with words that have no translation.
    pub fn shown(&self, text: &str) -> Result<String, String> {
        let (mut out, mut wrong) = (String::new(), Vec::new());
        for line in text.split_inclusive('\n') {
            // Markdown is translated already.
            let raw = line.starts_with('<');
            let (line, faults) = if raw { self.markup(line) } else { (line.to_owned(), Vec::new()) };
            out.push_str(&line);
            wrong.extend(faults);
        }
        let ask = self.label("Predict.").0;
        let words = serde_json::to_string(&self.words).unwrap_or_default().replace("</", "<\\/");
        let script = include_str!("../../theme/language.js");
        let (out, code) = (out.replace("**Predict.**", &format!("**{ask}**")), &self.code);
        let page = format!(
            "<div lang=\"{code}\">\n\n{out}\n\n<script>\nvar tumblingWords = {words};\n{script}</script>\n</div>\n"
        );
        if wrong.is_empty() { Ok(page) } else { Err(wrong.join("\n")) }
    }
}

/// A text without the targets of its links, and these targets.
fn without_targets(text: &str) -> (String, Vec<&str>) {
    let targets = TARGET.captures_iter(text).map(|found| found.extract::<1>().1[0]).collect();
    (TARGET.replace_all(text, "]").into_owned(), targets)
}

/// Replaces the decimal mark `mark` by `other`.
pub fn with(text: &str, mark: char, other: char) -> String {
    let all: Vec<char> = text.chars().collect();
    let digit = |at: Option<usize>| at.and_then(|at| all.get(at)).is_some_and(char::is_ascii_digit);
    let decimal = |at: usize| all[at] == mark && digit(at.checked_sub(1)) && digit(Some(at + 1));
    (0..all.len()).map(|at| if decimal(at) { other } else { all[at] }).collect()
}

/// The numbers in digits with their units, the signs before and between them, and units alone.
fn digits(text: &str) -> impl Iterator<Item = (usize, String)> + '_ {
    let signs = text.match_indices(['−', '+', '±', '×']).map(|(at, sign)| (at, sign.to_owned()));
    let units = words_of(text).filter(|at| at.len() > 1 && UNITS.contains(&&text[at.clone()]));
    let marks = signs.chain(units.map(|at| (at.start, text[at].to_owned())));
    marks.chain(numerals(text).into_iter().map(|numeral| {
        let (number, all) = (&text[numeral.at.clone()], with_unit(text, &numeral));
        let known = UNITS.contains(&all[number.len()..].trim());
        (numeral.at.start, if known { all } else { number }.to_owned())
    }))
}

fn in_order(numbers: impl Iterator<Item = (usize, String)>) -> Vec<String> {
    numbers.collect::<BTreeMap<_, _>>().into_values().collect()
}

/// The places of the words of this text.
fn words_of(text: &str) -> impl Iterator<Item = Range<usize>> + '_ {
    WORD.find_iter(text).map(|word| word.range())
}

fn in_one_line(item: &str) -> String {
    item.lines().map(|line| line.trim_start_matches(['>', ' '])).collect::<Vec<_>>().join(" ")
}

/// The texts of a chapter: each paragraph, heading and item, without the marks before it.
fn items(text: &str) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    let (mut at, mut in_code, mut open) = (0, false, false);
    for line in text.split_inclusive('\n') {
        let start = at;
        at += line.len();
        in_code ^= line.starts_with("```");
        let own = line.trim_start_matches(['>', ' ']);
        let bare = own.trim_start_matches(['#', '-']).trim_start();
        let bare = bare.strip_prefix("**Predict.** ").unwrap_or(bare);
        let content = start + line.len() - bare.len()..start + line.trim_end().len();
        match found.last_mut().filter(|_| open && bare.len() == own.len()) {
            _ if in_code || bare.trim().is_empty() || line.starts_with("```") => open = false,
            Some(last) => last.end = content.end,
            None => {
                open = true;
                found.push(content);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests;
