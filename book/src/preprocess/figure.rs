//! Figures: `![what is seen](../../figures/NAME.svg)` becomes the drawing itself, with its caption.
//!
//! Inline, a drawing takes the reader's theme; as an `<img>` it could not.

use super::edits::Edits;
use super::palette::Palette;
use super::svg::{self, Drawing};
use super::{Folders, Piece, Source, nested};
use crate::site::files;
use pulldown_cmark::{Event, Tag, TagEnd};
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Component, Path, PathBuf};

/// The drawings that the book shows so far, by name, and where.
pub(super) type Shown = BTreeMap<String, (Drawing, PathBuf)>;

/// Replaces the figures of a chapter; returns what was wrong.
pub(super) fn replace(
    source: &Source<'_>,
    pieces: &[Piece<'_>],
    folders: &Folders,
    shown: &mut Shown,
    edits: &mut Edits,
) -> Vec<String> {
    let mut faults = Vec::new();
    for (at, depth, (event, range)) in nested(pieces) {
        if let Event::Start(Tag::Image { dest_url, .. }) = event
            && let Some(name) = figure_name(source, dest_url, folders)
        {
            let placed = if depth == 1 { placed(pieces, at) } else { None };
            let html = match &placed {
                Some(_) => opening(source, &name, &words(&pieces[at..]), folders, shown),
                None => Err("a figure stands in a paragraph of its own, in no list and no quote".into()),
            };
            match (placed, html) {
                (Some(place), Ok(html)) => place.edit(html, edits),
                (_, Err(what)) => faults.push(source.fault(range.start, what)),
                (None, Ok(_)) => {}
            }
        }
    }
    faults
}

/// Lays the drawings beside the chapters, whence mdBook copies them to the pages: the links that open
/// a drawing by itself lead there.
pub(super) fn lay_out(shown: &Shown, palette: &Palette, folder: &Path) -> Result<(), String> {
    let alone = |(name, (drawing, _)): (&String, &(Drawing, PathBuf))| {
        (format!("{name}.svg"), drawing.alone(&palette.of(name)).into_bytes())
    };
    files::lay_out(folder, &shown.iter().map(alone).collect())
}

/// The name of the figure that this target leads to, if it leads to one.
fn figure_name(source: &Source<'_>, target: &str, folders: &Folders) -> Option<String> {
    let chapter = folders.chapters.join(source.path);
    let file = normal(&chapter.parent()?.join(target));
    (file.parent() == Some(&normal(&folders.figures)))
        .then(|| file.file_name()?.to_str()?.strip_suffix(".svg").map(str::to_owned))
        .flatten()
}

/// The path without `.` and `..`, taken by its words: no file needs to exist.
fn normal(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => {
                out.pop();
            }
            part => out.push(part),
        }
    }
    out
}

/// A paragraph that holds a figure and nothing else, and the caption after it.
struct Place {
    paragraph: Range<usize>,
    caption: Option<Caption>,
}

/// A paragraph that is emphasised from end to end.
struct Caption {
    paragraph: Range<usize>,
    /// What is between the two asterisks.
    inner: Range<usize>,
}

impl Place {
    /// Puts the figure there. The caption remains Markdown, between raw tags.
    fn edit(self, html: String, edits: &mut Edits) {
        match self.caption {
            None => edits.replace(self.paragraph, html + "</figure>\n\n"),
            Some(Caption { paragraph, inner }) => {
                let before = self.paragraph.start..inner.start;
                edits.replace(before, html + "<figcaption>\n\n");
                edits.replace(inner.end..paragraph.end, "\n\n</figcaption>\n</figure>\n\n".into());
            }
        }
    }
}

/// Where the image that starts at `image` stands, if it stands alone in its paragraph.
fn placed(pieces: &[Piece<'_>], image: usize) -> Option<Place> {
    let (Event::Start(Tag::Paragraph), paragraph) = pieces.get(image.checked_sub(1)?)? else {
        return None;
    };
    let end = image + pieces[image..].iter().position(|(e, _)| *e == Event::End(TagEnd::Image))?;
    let (Event::End(TagEnd::Paragraph), _) = pieces.get(end + 1)? else {
        return None;
    };
    Some(Place { paragraph: paragraph.clone(), caption: caption(&pieces[end + 2..]) })
}

fn caption(next: &[Piece<'_>]) -> Option<Caption> {
    let [(Event::Start(Tag::Paragraph), paragraph), (Event::Start(Tag::Emphasis), emphasis), ..] = next
    else {
        return None;
    };
    let end = next.iter().position(|(e, _)| *e == Event::End(TagEnd::Paragraph))?;
    // The emphasis that the paragraph begins with must be the one that it ends with.
    let (last, closing) = &next[end - 1];
    (*last == Event::End(TagEnd::Emphasis) && closing == emphasis)
        .then(|| Caption { paragraph: paragraph.clone(), inner: emphasis.start + 1..emphasis.end - 1 })
}

/// The description of the image that these pieces start with.
fn words(image: &[Piece<'_>]) -> String {
    let mut out = String::new();
    for (event, _) in image {
        match event {
            Event::Text(text) | Event::Code(text) => out.push_str(text),
            Event::SoftBreak | Event::HardBreak => out.push(' '),
            Event::End(TagEnd::Image) => break,
            _ => {}
        }
    }
    out
}

/// The figure up to its caption, with no blank line in it: that would end the HTML.
fn opening(
    source: &Source<'_>,
    name: &str,
    words: &str,
    folders: &Folders,
    shown: &mut Shown,
) -> Result<String, String> {
    if words.trim().is_empty() {
        return Err(format!("the figure `{name}` needs words that say what is seen: `![words](...)`"));
    }
    if let Some((_, earlier)) = shown.get(name) {
        return Err(format!(
            "the figure `{name}` is shown already in {}; lead there by a link to `#fig-{name}`",
            earlier.display()
        ));
    }
    let text = files::text(&folders.figures.join(format!("{name}.svg")))
        .map_err(|what| format!("{what}; `cargo run -- figures {name}` draws it if `-- list` knows it"))?;
    let drawing = svg::Drawing::new(name, text)?;
    let up = "../".repeat(source.path.components().count().saturating_sub(1));
    let html = format!(
        "<figure class=\"fig\" id=\"fig-{name}\">\n<div class=\"fig-frame\">{}</div>\n\
         <a class=\"fig-large\" href=\"{up}figures/{name}.svg\">Open large</a>\n",
        drawing.inline(words)
    );
    shown.insert(name.to_owned(), (drawing, source.path.to_owned()));
    Ok(html)
}
