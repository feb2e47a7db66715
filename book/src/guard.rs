//! The guard: names what holds each number and each equation in the book, and objects where nothing does.
//!
//! It reads the chapters (and the README, and the exercises) with the Markdown parser that makes the pages,
//! and their Rust with a parser of Rust. A chapter is cut at its headings. Within each section, the code
//! holds phrases, and every number in prose, captions, tables, TeX and comments must stand in one of them,
//! word for word:
//!
//! - **asserted**: a string that an `assert_eq!` expects. That its digits are right is the doc-test's affair.
//!   The text must say it, and say first what is asserted first. One that begins with `|` is a whole row of a
//!   table. A string without a number that denies (`never closes`) must be said too;
//! - **noted**: the comment behind a line of code, divided by `;`. Its numbers must be literals of that line,
//!   one after the other, so that inputs too are said as they are;
//! - **a fact** of `facts.toml`, which the text must state. The versions in the README are facts of the
//!   manifests;
//! - **drawn**: what a caption says may stand in the description inside the drawing, which is made from
//!   computed values. The words for a figure bring no other number, and in the drawing's order.
//!
//! The calls in an assertion show how certain its number is: `exactly(x)` is exact, `enclosed(x)` an
//! interval; all else is computed in floats. Where an assertion says a string again that the section's code
//! asserts already, but of an exact number or an interval, the better one counts: see `certainty`.
//!
//! What follows a number belongs to the phrase: `7.4` does not hold `7.4 m`, nor `0.2 kg` a `0.2 kg m²`, so
//! that no unit needs to be known here. Minus signs of both kinds are one, a power of ten in TeX is `3e-13`,
//! and a phrase may begin a sentence.
//!
//! Equations are proven from their TeX, against the library's own functions: see
//! `tumbling_proofs::equations`.
//!
//! The right answer of a question, in words or a number, is a string that an assertion of its section
//! expects, and so is something in the answer of each problem: see `answers`.
//!
//! Not held, by rule: names with digits (`Ash91`), code spans and targets of links, units (`1/s`). Numbers
//! before headings (`2. ...`) count up. Whole numbers inside a formula with symbols (an index, an exponent, a
//! factor, a matrix's zero) are a part of the formula. Number words (`a twentieth`, `three axes`) that stand
//! in no phrase are listed in `words.toml` with the word behind them, as often as the chapter says them, so
//! that none becomes another unseen.

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

/// What the guard found.
#[derive(Debug)]
pub(crate) struct Report {
    chapters: usize,
    pub(crate) offences: Vec<Offence>,
    /// Each number, and each equation, with what holds it.
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

/// The chapters and what stands beside them.
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

/// The facts beside the chapters, or those of this book where there are none.
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

/// A file beside the folder of the chapters, or this book's own where there is none.
fn beside(folder: &Path, name: &str) -> Result<(PathBuf, String), String> {
    let beside = folder.join("..").join(name);
    let file = if beside.is_file() { beside } else { paths::book().join(name) };
    let text = files::text(&file)?;
    Ok((file, text))
}

/// What the drawings of these chapters say of themselves.
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

/// What the first element of this kind holds.
fn inside(svg: &str, element: &str) -> String {
    let opened = svg.split_once(&format!("<{element}")).and_then(|(_, rest)| rest.split_once('>'));
    let text = opened.and_then(|(_, rest)| rest.split_once(&format!("</{element}>"))).map_or("", |(t, _)| t);
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
}

#[cfg(test)]
mod tests;
