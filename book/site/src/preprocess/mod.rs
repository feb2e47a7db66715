//! Turns what chapters write into what pages show: exercises and programs into folds, TeX into MathML,
//! figures into inline SVG, widgets into their places, questions into boxes.
//!
//! It works on the Markdown, before mdBook makes pages, and changes only the byte ranges of maths, figures,
//! widgets and programs.

pub(crate) mod blanks;
pub mod check;
mod edits;
mod exercises;
mod figure;
pub(crate) mod indexed;
mod maths;
mod palette;
mod programs;
pub mod protocol;
pub mod question;
mod theme;
mod turning;
mod widget;

use crate::language::Language;
use crate::{goals, home};
use edits::Edits;
use mdbook_preprocessor::book::{Book, BookItem};
use mdbook_preprocessor::errors::{Error, Result};
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use pulldown_cmark::{Event, Options, Parser};
use std::ops::Range;
use std::path::PathBuf;

/// The name of the preprocessor in `book.toml`.
pub const NAME: &str = "tumbling";

/// Only HTML pages need this preprocessor: other renderers use the Markdown as it is.
pub fn supports(renderer: &str) -> bool {
    renderer == "html"
}

/// The preprocessor.
pub enum Preprocess {
    /// For pages and paper.
    Pages,
    /// The preprocessor for the search index only.
    Index,
}

impl Preprocessor for Preprocess {
    fn name(&self) -> &str {
        NAME
    }

    fn supports_renderer(&self, renderer: &str) -> Result<bool> {
        Ok(supports(renderer))
    }

    fn run(&self, context: &PreprocessorContext, book: Book) -> Result<Book> {
        let mut book = run(context, book)?;
        if matches!(self, Self::Index) {
            indexed::reduce(&mut book, &context.root).map_err(Error::msg)?;
        }
        Ok(book)
    }
}

fn run(context: &PreprocessorContext, mut book: Book) -> Result<Book> {
    let maths = maths::Maths::new();
    let folders = Folders {
        chapters: context.root.join(&context.config.book.src),
        figures: context.root.join("../figures"),
        widgets: context.root.join("widgets"),
    };
    let exercises = tumbling_exercises::all().map_err(Error::msg)?;
    let mut seen = Seen::default();
    let mut faults = Vec::new();
    book.for_each_mut(|item| {
        let BookItem::Chapter(chapter) = item else {
            return;
        };
        let Some(path) = chapter.source_path.clone() else {
            return;
        };
        let translated = Language::of(&path.to_string_lossy()).and_then(|own| {
            let page = |(own, name): (Language, &str)| Ok((own.page(name)?, own));
            own.map(page).transpose()
        });
        let (own, other) = match translated {
            Ok(Some((page, own))) => (page, Some(own)),
            Ok(None) => (chapter.content.clone(), None),
            Err(fault) => return faults.push(fault),
        };
        // The original chapter has already copied the same drawings and widgets.
        let seen = if other.is_some() { &mut Seen::default() } else { &mut seen };
        let file = format!("book/chapters/{}", path.display());
        let written = Source { file: &file, text: &own };
        let text = exercises::replace(&written, &exercises)
            .and_then(|text| goals::replace(&text))
            .map(|text| home::replace(&text));
        let text = match text {
            Ok(text) => text,
            Err(fault) => return faults.push(fault),
        };
        let source = Source { file: &file, text: &text };
        let shown = chapter_as_shown(&source, &maths, &folders, seen).and_then(|text| match &other {
            Some(other) => other.shown(&text).map_err(|fault| vec![fault]),
            None => Ok(text),
        });
        match shown {
            Ok(text) => chapter.content = text,
            Err(more) => faults.extend(more),
        }
    });
    faults.extend(turning::add(&mut book, &context.root));
    if faults.is_empty() {
        let theme = context.root.join("theme");
        let palette = theme::palette(&theme).map_err(Error::msg)?;
        figure::lay_out(&seen.figures, &palette, &folders.chapters.join("figures")).map_err(Error::msg)?;
        widget::lay_out(&seen.widgets, &folders).map_err(Error::msg)?;
        theme::lay_out(&theme).map_err(Error::msg)?;
        Ok(book)
    } else {
        Err(Error::msg(faults.join("\n")))
    }
}

/// Where chapters, drawings and widgets are.
struct Folders {
    chapters: PathBuf,
    figures: PathBuf,
    widgets: PathBuf,
}

/// What the chapters have shown so far.
#[derive(Default)]
struct Seen {
    figures: figure::Shown,
    widgets: widget::Placed,
}

/// A chapter as written.
struct Source<'a> {
    /// Its file, as messages name it.
    file: &'a str,
    text: &'a str,
}

impl Source<'_> {
    /// A complaint about the text at this offset.
    fn fault(&self, offset: usize, what: impl std::fmt::Display) -> String {
        let line = 1 + self.text[..offset].bytes().filter(|&b| b == b'\n').count();
        format!("{}:{line}: {what}", self.file)
    }

    /// The chapter's name: that of its file, without folders and ending.
    fn name(&self) -> &str {
        let file = self.file.rsplit('/').next().unwrap_or_default();
        file.strip_suffix(".md").unwrap_or(file)
    }
}

/// An event of the Markdown parser and the bytes it came from.
pub type Piece<'a> = (Event<'a>, Range<usize>);

/// Reads Markdown as mdBook does, and also maths.
pub fn pieces(text: &str) -> Vec<Piece<'_>> {
    let options = Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH;
    Parser::new_ext(text, options).into_offset_iter().collect()
}

/// Each piece with its place in the list and the number of those that it stands in.
fn nested<'p, 'a>(pieces: &'p [Piece<'a>]) -> impl Iterator<Item = (usize, usize, &'p Piece<'a>)> {
    pieces.iter().enumerate().scan(0_usize, |depth, (at, piece)| {
        let here = *depth;
        match piece.0 {
            Event::Start(_) => *depth += 1,
            Event::End(_) => *depth = depth.saturating_sub(1),
            _ => {}
        }
        Some((at, here, piece))
    })
}

/// The chapter's text with maths, figures and widgets replaced; or all that is wrong with it.
fn chapter_as_shown(
    source: &Source<'_>,
    maths: &maths::Maths,
    folders: &Folders,
    seen: &mut Seen,
) -> std::result::Result<String, Vec<String>> {
    let pieces = pieces(source.text);
    let mut edits = Edits::default();
    let mut faults = check::faults(source, &pieces);
    faults.extend(maths.replace(source, &pieces, &mut edits));
    faults.extend(figure::replace(source, &pieces, folders, &mut seen.figures, &mut edits));
    faults.extend(widget::replace(source, &pieces, folders, &mut seen.widgets, &mut edits));
    faults.extend(question::replace(source, &pieces, &mut edits));
    programs::replace(source.text, &pieces, &mut edits);
    blanks::replace(source, &pieces, &mut edits);
    if faults.is_empty() { Ok(edits.applied_to(source.text)) } else { Err(faults) }
}

/// What is wrong with this chapter as Markdown and TeX, each with its line; figures and widgets are not
/// looked for.
pub fn unreadable(file: &str, text: &str) -> Vec<String> {
    let source = Source { file, text };
    let pieces = pieces(text);
    let mut faults = check::faults(&source, &pieces);
    faults.extend(maths::Maths::new().replace(&source, &pieces, &mut Edits::default()));
    faults
}

#[cfg(test)]
mod tests;
