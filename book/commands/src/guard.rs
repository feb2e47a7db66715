//! The guard: it names the evidence for each number and each equation of the book, and reports those without
//! evidence.
//!
//! It reads the chapters (and the README, and the exercises) with the Markdown parser that makes the pages,
//! and their code with a Rust parser. A chapter is divided at its headings. The code of each section contains
//! phrases, and every number in prose, captions, tables, TeX and comments must be part of one of them, word
//! for word:
//!
//! - **asserted**: a string that an `assert_eq!` expects. The doc-test shows that its digits are right. The
//!   text must contain it, in the order of the assertions. A string that begins with `|` is a whole row of a
//!   table. A string of several words (`never closes`, `the larger moment`) must be there too,
//!   wherever it stands;
//! - **noted**: a part, divided by `;`, of the comment after a line of code. Its numbers must be consecutive
//!   literals of that line, so that inputs are stated as they are;
//! - **a fact** of `facts.toml`, which the text must contain. The versions in the README are facts of the
//!   manifests;
//! - **drawn**: a caption may repeat the description inside the drawing, which is made from computed values.
//!   The alternative text of a figure may contain only numbers of that description, in its order.
//!
//! The calls in an assertion show how certain its number is: `exactly(x)` is exact, `enclosed(x)` an
//! interval; all else is computed in floats. If two assertions of a section expect the same string, and one
//! of them is of an exact number or an interval, that one counts: see `certainty`.
//!
//! The words after a number belong to the phrase: `7.4` does not support `7.4 m`, nor does `0.2 kg` support
//! `0.2 kg m²`. So the guard needs no list of units. Both kinds of minus sign are equal, a power of ten in
//! TeX is `3e-13`, and a phrase may begin a sentence.
//!
//! Equations are evaluated from their TeX on letters, most with the library's own functions, some of a
//! formula written a second time or as a lemma: see `tumbling_proofs::equations`.
//!
//! The right answer of a question, in words or a number, must be a string that an assertion of its section
//! expects, and the answer of each problem must contain such a string: see `answers`.
//!
//! Some numbers need no evidence: names with digits (`Ash91`), code spans and targets of links, units
//! (`1/s`). Numbers before headings (`2. ...`) must count up. Whole numbers inside a formula with symbols (an
//! index, an exponent, a factor, a matrix's zero) are part of the formula. Number words (`a twentieth`,
//! `three axes`) that are in no phrase are listed in `words.toml` with the word after them, as often as the
//! chapter has them, so that no change of one goes unnoticed.

mod answers;
mod certainty;
mod chapter;
mod code;
mod equations;
mod exercises;
mod facts;
mod holding;
mod laws;
mod manifests;
mod offence;
mod passage;
mod phrase;

use chapter::{Chapter, Reader};
use holding::Beside;
use offence::Offence;
use std::collections::HashMap;
use std::fmt;
use tumbling_site::language::Language;
use tumbling_site::preprocess;
use tumbling_site::{digits, files, paths, spelled};

/// The findings of the guard.
#[derive(Debug)]
pub(crate) struct Report {
    chapters: usize,
    pub(crate) offences: Vec<Offence>,
    /// Each number and each equation, with its evidence.
    pub(crate) held: Vec<String>,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "numbers and equations: {} in {} files", self.held.len(), self.chapters)?;
        for kind in equations::KINDS {
            let so = |held: &&String| held.contains(&format!("`: {kind}: "));
            writeln!(f, "equations, {kind}: {}", self.held.iter().filter(so).count())?;
        }
        write!(f, "offences: {}", self.offences.len())
    }
}

/// Checks the chapters, the README and the exercises.
///
/// # Errors
/// What could not be read, with its file and line.
pub(crate) fn check() -> Result<Report, String> {
    Book::read()?.report()
}

/// The chapters, and the data next to them.
struct Book {
    chapters: Vec<Chapter>,
    beside: Beside,
}

impl Book {
    fn report(&self) -> Result<Report, String> {
        let dropped = equations::missing(&self.chapters)?.into_iter().map(|name| Offence {
            file: "book/chapters/SUMMARY.md".into(),
            line: 1,
            found: format!("no `{name}`, which has laws to prove"),
            expected: "it in the list of chapters".into(),
        });
        let mut report =
            Report { chapters: self.chapters.len(), offences: dropped.collect(), held: Vec::new() };
        for chapter in &self.chapters {
            let found = holding::findings(chapter, &self.beside);
            report.offences.extend(found.offences);
            report.held.extend(found.held);
            report.offences.extend(answers::offences(chapter));
            report.offences.extend(equations::offences(chapter, &mut report.held)?);
        }
        Ok(report)
    }

    fn read() -> Result<Self, String> {
        let mut reading = Reading::default();
        for (name, _) in files::listed(&paths::chapters())? {
            let translated =
                Language::of(&name).and_then(|own| own.map(|(own, of)| own.page(of)).transpose());
            reading.wrong.extend(translated.err());
            reading.add(&name, &format!("book/chapters/{name}.md"), str::to_owned)?;
        }
        reading.add("README", "README.md", str::to_owned)?;
        for exercise in tumbling_exercises::all()? {
            let file = format!("book/exercises/whole/{}.md", exercise.name);
            reading.add(&exercise.name, &file, exercises::as_chapter)?;
        }
        let Reading { chapters, mut wrong, .. } = reading;
        wrong.dedup();
        if !wrong.is_empty() {
            return Err(wrong.join("\n"));
        }
        let mut facts = beside("facts.toml", facts::read)?;
        if let Some(fact) = facts.iter().find(|fact| chapters.iter().all(|c| c.name != fact.chapter)) {
            return Err(format!("book/facts.toml: there is no chapter `{}`", fact.chapter));
        }
        facts.extend(versions()?);
        let drawings = drawings(&chapters)?;
        let mut words = beside("words.toml", words)?;
        for chapter in &chapters {
            words.entry(chapter.name.clone()).or_default();
        }
        Ok(Self { chapters, beside: Beside { facts, drawings, words } })
    }
}

/// The chapters read so far, and what is wrong with others.
#[derive(Default)]
struct Reading {
    reader: Reader,
    chapters: Vec<Chapter>,
    wrong: Vec<String>,
}

impl Reading {
    /// Reads a file of the repository; `seen` is what the guard sees of its text.
    fn add(&mut self, name: &str, file: &str, seen: fn(&str) -> String) -> Result<(), String> {
        let text = files::text(&paths::repository().join(file))?;
        self.wrong.extend(preprocess::unreadable(file, &text));
        match self.reader.chapter(name, file, &seen(&text)) {
            Ok(chapter) => self.chapters.push(chapter),
            Err(fault) => self.wrong.push(fault),
        }
        Ok(())
    }
}

/// The versions that the first page names, as the manifests have them.
fn versions() -> Result<Vec<facts::Fact>, String> {
    let fact = |text| facts::Fact {
        chapter: "README".into(),
        text,
        source: "the manifests".into(),
        certainty: "certain".into(),
    };
    Ok(manifests::versions()?.into_iter().map(fact).collect())
}

/// A file next to the folder of the chapters, as `read` takes it.
fn beside<T>(name: &str, read: fn(&str) -> Result<T, String>) -> Result<T, String> {
    read(&files::text(&paths::book().join(name))?).map_err(|e| format!("book/{name}: {e}"))
}

/// The number words of each chapter.
fn words(text: &str) -> Result<holding::Words, String> {
    let all: HashMap<String, String> = toml::from_str(text).map_err(|e| e.to_string())?;
    let words = |entry: &str| entry.split_whitespace().collect::<Vec<_>>().join(" ");
    let split = |list: String| list.split(',').map(words).filter(|entry| !entry.is_empty()).collect();
    Ok(all.into_iter().map(|(chapter, list)| (chapter, split(list))).collect())
}

/// The titles and descriptions inside the drawings of these chapters.
fn drawings(chapters: &[Chapter]) -> Result<HashMap<String, String>, String> {
    let mut drawings = HashMap::new();
    let passages = chapters.iter().flat_map(|c| &c.sections).flat_map(|s| &s.passages);
    for name in passages.filter_map(|p| p.figure.as_ref()) {
        let svg = files::text(&paths::figures().join(format!("{name}.svg")))?;
        let words = ["title", "desc"].map(|element| inside(&svg, element)).join(". ");
        drawings.insert(name.clone(), words.replace('\u{2212}', "-"));
    }
    Ok(drawings)
}

/// The contents of the first element with this name.
fn inside(svg: &str, element: &str) -> String {
    let opened = svg.split_once(&format!("<{element}")).and_then(|(_, rest)| rest.split_once('>'));
    let text = opened.and_then(|(_, rest)| rest.split_once(&format!("</{element}>"))).map_or("", |(t, _)| t);
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
}

#[cfg(test)]
mod tests;
