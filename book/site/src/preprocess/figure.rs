//! Figures: `![what is seen](../../figures/NAME.svg)` becomes the drawing itself, with its caption.
//!
//! A drawing inside the page uses the reader's theme; an `<img>` could not.

use super::edits::Edits;
use super::palette::Palette;
use super::{Folders, Piece, Source, nested};
use crate::files;
use pulldown_cmark::{Event, Tag, TagEnd};
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

/// The drawings that the book shows so far, by name, and in which file.
pub(super) type Shown = BTreeMap<String, (String, String)>;

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
            && let Some(name) = figure_name(dest_url)
        {
            let placed = if depth == 1 { placed(pieces, at) } else { None };
            let html = match &placed {
                Some(_) => opening(source, &name, &pieces[at..], folders, shown),
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

/// Copies the drawings next to the chapters, from where mdBook copies them to the pages, for the links that
/// open a drawing on its own.
pub(super) fn lay_out(shown: &Shown, palette: &Palette, folder: &Path) -> Result<(), String> {
    let alone = |(name, (drawing, _)): (&String, &(String, String))| {
        (format!("{name}.svg"), alone(drawing, &palette.of(name)).into_bytes())
    };
    files::lay_out(folder, &shown.iter().map(alone).collect())
}

/// The name of the figure that this target leads to, if it leads to one: all chapters lie in one folder.
fn figure_name(target: &str) -> Option<String> {
    let name = target.strip_prefix("../../figures/")?.strip_suffix(".svg")?;
    (!name.contains('/')).then(|| name.to_owned())
}

/// A paragraph that contains only a figure, and the caption after it.
struct Place {
    paragraph: Range<usize>,
    caption: Option<Caption>,
}

/// A paragraph that is emphasised from end to end.
struct Caption {
    paragraph: Range<usize>,
    /// The text between the two asterisks.
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

/// The place of the image that starts at `image`, if it is alone in its paragraph.
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
    // The emphasis at the start of the paragraph must be the one that ends it.
    let (last, closing) = &next[end - 1];
    (*last == Event::End(TagEnd::Emphasis) && closing == emphasis)
        .then(|| Caption { paragraph: paragraph.clone(), inner: emphasis.start + 1..emphasis.end - 1 })
}

/// The figure up to its caption, with no blank line in it: that would end the HTML.
fn opening(
    source: &Source<'_>,
    name: &str,
    image: &[Piece<'_>],
    folders: &Folders,
    shown: &mut Shown,
) -> Result<String, String> {
    if matches!(image, [_, (Event::End(TagEnd::Image), _), ..]) {
        return Err(format!("the figure `{name}` needs words that say what is seen: `![words](...)`"));
    }
    if let Some((_, earlier)) = shown.get(name) {
        let instead = format!("lead there by a link to `#fig-{name}`");
        return Err(format!("the figure `{name}` is shown already in {earlier}; {instead}"));
    }
    let text = files::text(&folders.figures.join(format!("{name}.svg")))
        .map_err(|what| format!("{what}; `cargo run -- figures {name}` draws it if `-- list` knows it"))?;
    // No blank line and no carriage return either.
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
    let html = format!(
        "<figure class=\"fig\" id=\"fig-{name}\">\n<div class=\"fig-frame\">{}</div>\n\
         <a class=\"fig-large\" href=\"figures/{name}.svg\">Open large</a>\n",
        lines.join("\n")
    );
    shown.insert(name.to_owned(), (text, source.file.to_owned()));
    Ok(html)
}

/// The drawing as a document of its own, with this put at its end: as large as the window it is opened in, in
/// its middle.
fn alone(svg: &str, added: &str) -> String {
    let (start, marks) = svg.split_once('>').unwrap_or((svg, ""));
    let (before, after) = start.split_once(" width=\"").unwrap_or((start, "\""));
    let start = format!("{before}{}", after.split_once('"').map_or("", |(_, rest)| rest));
    let start = start.replacen("<svg", "<svg width=\"100%\" height=\"100%\"", 1);
    let (marks, end) = marks.rsplit_once("</svg>").unwrap_or((marks, ""));
    format!("{start}>{marks}{added}</svg>{end}")
}
