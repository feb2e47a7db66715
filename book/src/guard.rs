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
mod digits;
mod equations;
mod exercises;
mod facts;
mod holding;
mod laws;
mod offence;
mod passage;
mod phrase;
mod spelled;

use crate::language::Language;
use crate::preprocess;
use crate::site::{files, manifests, paths};
use chapter::{Chapter, Reader};
pub(crate) use digits::{plain as numerals, with_unit};
use holding::Beside;
use offence::Offence;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::{fmt, fs};

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

/// The number words of a text in English, in small letters, and where they begin.
pub(crate) fn number_words(text: &str) -> Vec<(usize, String)> {
    spelled::words(text).into_iter().map(|word| (word.at.start, text[word.at].to_lowercase())).collect()
}

/// Checks the chapters in this folder.
///
/// # Errors
/// What could not be read, with its file and line.
pub(crate) fn check(folder: &Path) -> Result<Report, String> {
    let book = Book::read(folder)?;
    let missing = equations::missing(&book.chapters);
    let dropped = missing.iter().filter(|name| book.own || folder.join(format!("{name}.md")).is_file());
    let dropped = dropped.map(|name| Offence {
        file: folder.join("SUMMARY.md").display().to_string(),
        line: 1,
        found: format!("no `{name}`, which has laws to prove"),
        expected: "it in the list of chapters".into(),
    });
    let mut report = Report { chapters: book.chapters.len(), offences: dropped.collect(), held: Vec::new() };
    for chapter in &book.chapters {
        let found = holding::findings(chapter, &book.beside);
        report.offences.extend(found.offences);
        report.held.extend(found.held);
        report.offences.extend(answers::offences(chapter));
        report.offences.extend(equations::offences(chapter, &mut report.held)?);
    }
    Ok(report)
}

/// The chapters, and the data next to them.
struct Book {
    chapters: Vec<Chapter>,
    beside: Beside,
    /// Whether it is the book's own folder, and not a copy of some of it.
    own: bool,
}

impl Book {
    fn read(folder: &Path) -> Result<Self, String> {
        if !folder.is_dir() {
            return Err(format!("there is no folder {}", folder.display()));
        }
        let own = fs::canonicalize(folder).ok() == fs::canonicalize(paths::chapters()).ok();
        let mut reader = Reader::default();
        let mut chapters = Vec::new();
        let mut wrong = Vec::new();
        for name in listed(folder)? {
            let file = format!("{name}.md");
            let path = folder.join(&file);
            let text = files::text(&path)?;
            let shown = if own { format!("book/chapters/{file}") } else { path.display().to_string() };
            let faults = preprocess::unreadable(Path::new(&file), &text);
            wrong.extend(faults.into_iter().map(|f| f.replacen(&format!("book/chapters/{file}"), &shown, 1)));
            let translated =
                Language::of(&name).and_then(|own| own.map(|(own, of)| own.page(of)).transpose());
            wrong.extend(translated.err());
            match reader.chapter(&name, &shown, &text) {
                Ok(chapter) => chapters.push(chapter),
                Err(fault) => wrong.push(fault),
            }
        }
        if own {
            let readme = files::text(&paths::repository().join("README.md"))?;
            chapters.push(reader.chapter("README", "README.md", &readme)?);
            exercises::read(&mut reader, &mut chapters, &mut wrong)?;
        }
        wrong.dedup();
        if !wrong.is_empty() {
            return Err(wrong.join("\n"));
        }
        let mut facts = facts(folder)?;
        for fact in &facts {
            if own && chapters.iter().all(|c| c.name != fact.chapter) {
                return Err(format!("book/facts.toml: there is no chapter `{}`", fact.chapter));
            }
        }
        if own {
            facts.extend(versions()?);
        }
        let drawings = drawings(folder, &chapters)?;
        let mut words = words(folder)?;
        for chapter in chapters.iter().filter(|_| own) {
            words.entry(chapter.name.clone()).or_default();
        }
        Ok(Self { chapters, beside: Beside { facts, drawings, words }, own })
    }
}

/// The chapters' names, in the order of `SUMMARY.md`.
fn listed(folder: &Path) -> Result<Vec<String>, String> {
    let listed = files::listed(folder)
        .map_err(|what| format!("{what}; a folder of chapters has a SUMMARY.md that lists them"))?;
    if listed.is_empty() {
        return Err(format!("{} lists no chapter", folder.join("SUMMARY.md").display()));
    }
    Ok(listed.into_iter().map(|(name, _)| name).collect())
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

/// The facts of the folder, or those of this book if the folder has none.
fn facts(folder: &Path) -> Result<Vec<facts::Fact>, String> {
    let (file, text) = beside(folder, "facts.toml")?;
    facts::read(&text).map_err(|e| format!("{}: {e}", file.display()))
}

/// The number words, likewise.
fn words(folder: &Path) -> Result<holding::Words, String> {
    let (file, text) = beside(folder, "words.toml")?;
    let all: HashMap<String, String> =
        toml::from_str(&text).map_err(|e| format!("{}: {e}", file.display()))?;
    let words = |entry: &str| entry.split_whitespace().collect::<Vec<_>>().join(" ");
    let split = |list: String| list.split(',').map(words).filter(|entry| !entry.is_empty()).collect();
    Ok(all.into_iter().map(|(chapter, list)| (chapter, split(list))).collect())
}

/// A file next to the folder of the chapters, or this book's own if there is none.
fn beside(folder: &Path, name: &str) -> Result<(PathBuf, String), String> {
    let beside = folder.join("..").join(name);
    let file = if beside.is_file() { beside } else { paths::book().join(name) };
    let text = files::text(&file)?;
    Ok((file, text))
}

/// The titles and descriptions inside the drawings of these chapters.
fn drawings(folder: &Path, chapters: &[Chapter]) -> Result<HashMap<String, String>, String> {
    let mut drawings = HashMap::new();
    let passages = chapters.iter().flat_map(|c| &c.sections).flat_map(|s| &s.passages);
    for name in passages.filter_map(|p| p.figure.as_ref()) {
        let beside = folder.join("../../figures").join(format!("{name}.svg"));
        let file = if beside.is_file() { beside } else { paths::figures().join(format!("{name}.svg")) };
        let svg = files::text(&file)?;
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
