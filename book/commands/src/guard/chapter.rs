//! Reads a chapter: its sections, and in each the passages a reader reads and the Rust that is run.

use super::code::{self, Code};
use super::offence::Offence;
use super::passage::{Kind, Passage, Tex};
use pulldown_cmark::{CodeBlockKind, Event, Tag, TagEnd};
use std::collections::HashMap;
use std::ops::Range;
use std::rc::Rc;
use tumbling_site::preprocess::{check, pieces};

/// A chapter, read.
#[derive(Debug)]
pub(crate) struct Chapter {
    /// The file's name without its ending.
    pub(crate) name: String,
    /// The file, as messages name it.
    pub(crate) path: String,
    /// The whole text.
    pub(crate) text: String,
    pub(crate) sections: Vec<Section>,
    /// The byte where each line begins.
    lines: Vec<usize>,
}

impl Chapter {
    /// The line, from one, of this byte.
    pub(crate) fn line(&self, at: usize) -> usize {
        self.lines.partition_point(|&start| start <= at)
    }

    /// An offence at a line, counted from one.
    pub(crate) fn offence(&self, line: usize, found: String, expected: &str) -> Offence {
        Offence { file: self.path.clone(), line, found, expected: expected.to_owned() }
    }
}

/// The contents between two headings, with the first heading.
#[derive(Debug, Default)]
pub(crate) struct Section {
    pub(crate) passages: Vec<Passage>,
    pub(crate) blocks: Vec<Block>,
}

/// A Rust block.
#[derive(Debug)]
pub(crate) struct Block {
    pub(crate) code: Rc<Code>,
    /// Where each line of the code, as the compiler sees it, begins in the chapter.
    lines: Vec<usize>,
}

impl Block {
    /// The byte of the chapter at this line of the code and this byte of the line.
    pub(crate) fn source(&self, line: usize, column: usize) -> usize {
        self.lines.get(line).map_or(0, |start| start + column)
    }
}

/// Reads chapters, and each Rust block but once.
#[derive(Debug, Default)]
pub(crate) struct Reader {
    known: HashMap<String, Result<Rc<Code>, code::Fault>>,
}

/// The languages that a block may be in.
const LANGUAGES: [&str; 5] = ["python", "rust", "sh", "text", "toml"];

impl Reader {
    /// Reads a chapter.
    ///
    /// # Errors
    /// `file:line: what`, where there is something that cannot be read.
    pub(crate) fn chapter(&mut self, name: &str, path: &str, text: &str) -> Result<Chapter, String> {
        let mut reading = Reading::default();
        let mut sections = Vec::new();
        let fault = |at: usize, what: String| format!("{path}:{}: {what}", line(text, at));
        let events = pieces(text);
        let mut at = 0;
        while let Some((event, range)) = events.get(at) {
            at += 1;
            match event {
                Event::Start(Tag::Heading { level, .. }) => {
                    let section = std::mem::take(&mut reading.section);
                    sections.push(section);
                    reading.open(Kind::Heading(*level as u8));
                }
                Event::Html(html) | Event::InlineHtml(html)
                    if html.contains(|c: char| c.is_ascii_digit()) =>
                {
                    return Err(fault(range.start, "HTML with a number, which nothing could hold".into()));
                }
                Event::Start(Tag::Link { title, .. } | Tag::Image { title, .. })
                    if title.contains(|c: char| c.is_ascii_digit()) =>
                {
                    return Err(fault(range.start, "a title with a number, which nothing could hold".into()));
                }
                Event::Start(Tag::CodeBlock(kind)) => {
                    let end = events[at..].iter().position(|(e, _)| *e == Event::End(TagEnd::CodeBlock));
                    let inside = &events[at..at + end.unwrap_or(0)];
                    at += inside.len();
                    if let Some((code, lines)) =
                        rust(kind, inside, text, range.start).map_err(|w| fault(range.start, w))?
                    {
                        let code = self.code(&code).map_err(|f| {
                            let at = lines.get(f.line).copied().unwrap_or(range.start);
                            fault(at, f.what)
                        })?;
                        let block = Block { code, lines };
                        reading.section.passages.extend(comments(&block, text));
                        reading.section.blocks.push(block);
                    }
                }
                event => reading.take(event, range),
            }
        }
        reading.close();
        sections.push(reading.section);
        sections.retain(|s| !s.passages.is_empty() || !s.blocks.is_empty());
        let lines = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        Ok(Chapter { name: name.to_owned(), path: path.to_owned(), text: text.to_owned(), sections, lines })
    }

    fn code(&mut self, text: &str) -> Result<Rc<Code>, code::Fault> {
        if let Some(known) = self.known.get(text) {
            return known.clone();
        }
        let read = code::read(text).map(Rc::new);
        self.known.insert(text.to_owned(), read.clone());
        read
    }
}

/// The comments of a block, each a passage.
fn comments<'a>(block: &'a Block, text: &'a str) -> impl Iterator<Item = Passage> + 'a {
    block.code.comments.iter().map(|comment| {
        let mut passage = Passage::new(if comment.note { Kind::Note } else { Kind::Comment });
        passage.values.clone_from(&comment.values);
        for part in &comment.lines {
            let (start, end) = (block.source(part.line, part.start), block.source(part.line, part.end));
            passage.push(text.get(start..end).unwrap_or_default(), start);
        }
        passage
    })
}

/// The code of a block as the compiler sees it, and where its lines begin; nothing for other languages.
fn rust(
    kind: &CodeBlockKind<'_>,
    inside: &[(Event<'_>, Range<usize>)],
    text: &str,
    start: usize,
) -> Result<Option<(String, Vec<usize>)>, String> {
    let mut words = check::words(kind);
    // The preprocessor has named code of no language.
    let Some(language) = words.next() else { return Ok(None) };
    if !LANGUAGES.contains(&language) {
        return Err(format!("a block in `{language}`, which is none of {}", LANGUAGES.join(", ")));
    }
    if language != "rust" {
        return Ok(None);
    }
    if let Some(idle) =
        words.find(|w| ["no_run", "compile_fail", "should_panic"].contains(w) || w.starts_with("ignore"))
    {
        return Err(format!("a Rust block marked `{idle}`: what is not run to its end holds no number"));
    }
    let (Some((_, first)), Some((_, last))) = (inside.first(), inside.last()) else {
        return Err("an empty Rust block".into());
    };
    let begins = text[start..first.start].rfind('\n').map_or(first.start, |n| start + n + 1);
    let (mut code, mut lines, mut at) = (String::new(), Vec::new(), begins);
    for written in text[begins..last.end].split_inclusive('\n') {
        // Lines that rustdoc compiles and does not show.
        let indent = written.len() - written.trim_start().len();
        let shown = written.trim_start();
        let hidden = match shown.strip_prefix('#') {
            Some(rest) if rest.starts_with([' ', '#']) || rest.trim().is_empty() => indent + 1,
            _ => 0,
        };
        code.push_str(&written[hidden..]);
        lines.push(at + hidden);
        at += written.len();
    }
    Ok(Some((code, lines)))
}

/// A chapter half read.
#[derive(Default)]
struct Reading {
    section: Section,
    open: Option<Passage>,
    /// The image being described, which is a passage of its own.
    alt: Option<Passage>,
    /// The drawing in the paragraph just closed, if it held nothing else.
    just_shown: Option<String>,
    /// The drawing in the paragraph that is open.
    shows: Option<String>,
    /// Whether the open paragraph began with emphasis that has not ended before its end.
    emphasis: usize,
    plain: bool,
    item: bool,
}

impl Reading {
    fn open(&mut self, kind: Kind) {
        self.close();
        self.open = Some(Passage::new(kind));
        self.plain = false;
    }

    fn close(&mut self) {
        let Some(mut passage) = self.open.take() else { return };
        let blank = passage.text.trim().is_empty();
        if passage.kind == Kind::Prose
            && !self.plain
            && !blank
            && let Some(figure) = self.just_shown.take()
        {
            passage.kind = Kind::Caption;
            passage.figure = Some(figure);
        }
        self.just_shown = self.shows.take().filter(|_| blank);
        if !blank {
            self.section.passages.push(passage);
        }
    }

    fn take(&mut self, event: &Event<'_>, range: &Range<usize>) {
        match event {
            Event::Start(Tag::Paragraph) => self.open(Kind::Prose),
            Event::Start(Tag::Item) => {
                self.open(Kind::Prose);
                self.item = true;
            }
            Event::Start(Tag::TableHead | Tag::TableRow) => {
                self.open(Kind::Row);
                self.add("|", range.start, true);
            }
            Event::Start(Tag::TableCell) => self.add(" ", range.start, true),
            Event::End(TagEnd::TableCell) => self.add(" |", range.start, true),
            Event::End(
                TagEnd::Paragraph | TagEnd::Heading(_) | TagEnd::Item | TagEnd::TableHead | TagEnd::TableRow,
            ) => self.close(),
            Event::Start(Tag::Emphasis) => self.emphasis += 1,
            Event::End(TagEnd::Emphasis) => self.emphasis = self.emphasis.saturating_sub(1),
            Event::Start(Tag::Image { dest_url, .. }) => {
                let name = dest_url.rsplit('/').next().and_then(|file| file.strip_suffix(".svg"));
                self.shows = name.map(str::to_owned);
                let mut alt = Passage::new(Kind::Alt);
                alt.figure = name.map(str::to_owned);
                self.alt = Some(alt);
            }
            Event::End(TagEnd::Image) => self.section.passages.extend(self.alt.take()),
            Event::Text(text) => self.add(text, range.start, false),
            Event::Code(_) => self.add("\u{fffc}", range.start, false),
            Event::SoftBreak | Event::HardBreak => self.add(" ", range.start, true),
            Event::InlineMath(tex) => self.formula(tex, range.start + 1, false),
            Event::DisplayMath(tex) => self.formula(tex, range.start + 2, true),
            _ => {}
        }
    }

    fn add(&mut self, text: &str, source: usize, between: bool) {
        if let Some(alt) = &mut self.alt {
            alt.push(text, source);
            return;
        }
        if !between && self.emphasis == 0 {
            self.plain = true;
        }
        // Text outside of any paragraph does not occur; should it, it is prose.
        self.open.get_or_insert_with(|| Passage::new(Kind::Prose)).push(text, source);
    }

    fn formula(&mut self, tex: &str, source: usize, display: bool) {
        self.add("", source, false);
        if let Some(passage) = self.alt.as_mut().or(self.open.as_mut()) {
            let start = passage.text.len();
            passage.push_tex(tex, source);
            passage.tex.push(Tex { at: start..passage.text.len(), written: tex.to_owned(), display });
        }
    }
}

fn line(text: &str, at: usize) -> usize {
    1 + text.bytes().take(at).filter(|&b| b == b'\n').count()
}
