//! Widgets: `{{#widget NAME}}` becomes a place in the page that comes to life where there is JavaScript.
//!
//! What stands there without it, and what its controls are, says `widgets/page/NAME.html`;
//! `widgets/README.md` has the rest. As a page may be read from a disk, where nothing may be fetched,
//! modules travel as text in scripts.

use super::edits::Edits;
use super::{Folders, Piece, Source, nested};
use crate::files;
use base64::prelude::{BASE64_STANDARD, Engine as _};
use flate2::{Compression, read::ZlibEncoder};
use pulldown_cmark::{Event, Tag};
use std::collections::{BTreeMap, BTreeSet};
use std::{fs, io::Read as _};

/// How a directive begins.
const OPENING: &str = "{{#widget";

/// Files that a widget takes along besides its module: the widget, the file's name for it, and where it
/// stands.
const CARRIED: [(&str, &str, &str); 1] =
    [("judge", "example", "crates/engines/data/rapier3d-f64-0.36.1--major.csv")];

/// The modules that a widget asks: the one of its own name, if nothing else is said here.
fn modules<'a>(widget: &'a &str) -> &'a [&'a str] {
    match *widget {
        "axle" => &["two-arrows", "your-body", "tumble"],
        "engines" | "steps" => &["steps", "tumble"],
        "masses" => &["two-arrows"],
        "pitfalls" => &["pitfalls", "tumble"],
        "two-arrows" => &["two-arrows", "tumble"],
        "your-body" | "your-box" => &["your-body", "tumble"],
        "coin" | "racket" | "toss" | "tosses" | "trading" | "turning" | "why" => &["tumble"],
        _ => std::slice::from_ref(widget),
    }
}

/// The widgets that the book has so far.
pub(super) type Placed = BTreeSet<String>;

/// Replaces the directives of a chapter; returns what was wrong.
pub(super) fn replace(
    source: &Source<'_>,
    pieces: &[Piece<'_>],
    folders: &Folders,
    placed: &mut Placed,
    edits: &mut Edits,
) -> Vec<String> {
    let mut faults = Vec::new();
    let mut in_code = false;
    let mut done = 0; // up to where a directive has been seen to
    for (_, depth, (event, range)) in nested(pieces) {
        match event {
            Event::Start(Tag::Paragraph) if depth == 0 => {
                if let Some(name) = directive(&source.text[range.clone()]) {
                    match place(name, folders, placed) {
                        Ok(html) => edits.replace(range.clone(), html),
                        Err(what) => faults.push(source.fault(range.start, what)),
                    }
                    done = range.end;
                }
            }
            Event::Start(Tag::CodeBlock(_)) => in_code = true,
            Event::End(pulldown_cmark::TagEnd::CodeBlock) => in_code = false,
            Event::Text(_) if !in_code && range.start >= done => {
                if let Some(at) = source.text[range.clone()].find(OPENING) {
                    let what = "a widget stands in a paragraph of its own, in no list and no quote: `{{#widget NAME}}`";
                    faults.push(source.fault(range.start + at, what));
                }
            }
            _ => {}
        }
    }
    faults
}

/// The name in a paragraph that is a directive and nothing else.
fn directive(paragraph: &str) -> Option<&str> {
    let name = paragraph.trim().strip_prefix(OPENING)?.strip_suffix("}}")?.trim();
    (!name.is_empty() && name.bytes().all(|b| b.is_ascii_lowercase() || b == b'-')).then_some(name)
}

/// What stands in the page for a widget, with no blank line in it: that would end the HTML.
fn place(name: &str, folders: &Folders, placed: &mut Placed) -> Result<String, String> {
    let still = folders.widgets.join(format!("page/{name}.html"));
    let html = fs::read_to_string(&still)
        .map_err(|e| format!("there is no widget `{name}`: {} cannot be read ({e})", still.display()))?;
    let mut lines: Vec<&str> = html.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    let mut id = format!(" id=\"live-{name}\"");
    // Where it stands again, it waits in a template: the page of the whole book has its ids once.
    if !placed.insert(name.to_owned()) {
        let stage = lines.iter().position(|line| line.starts_with("<div class=\"live-stage\"")).unwrap_or(0);
        lines.insert(stage, "<template>");
        lines.push("</template>");
        id.clear();
    }
    Ok(format!(
        "<div class=\"live\"{id} data-live=\"{name}\" data-modules=\"{}\" data-from=\"widgets/\">\n{}\n</div>\n\
         <script src=\"widgets/live.js\" defer></script>\n\n",
        modules(&name).join(" "),
        lines.join("\n")
    ))
}

/// Copies the scripts and modules of these widgets next to the chapters, from where mdBook copies them to the
/// pages.
pub(super) fn lay_out(placed: &Placed, folders: &Folders) -> Result<(), String> {
    let mut all = BTreeMap::new();
    for name in placed.iter().map(String::as_str).chain((!placed.is_empty()).then_some("live")) {
        for script in scripts(name, folders)? {
            all.insert(script.clone(), files::bytes(&folders.widgets.join("page").join(script))?);
        }
    }
    for name in placed {
        for module in modules(&name.as_str()) {
            let built = files::bytes(&folders.widgets.join(format!("built/{module}.wasm")))?;
            all.insert(format!("{module}.wasm.js"), carrier(module, &built)?);
        }
        for (_, what, file) in CARRIED.iter().filter(|(of, ..)| of == name) {
            let carried = files::bytes(&folders.widgets.join("../..").join(file))?;
            all.insert(format!("{name}.{what}.js"), carrier(&format!("{name}.{what}"), &carried)?);
        }
    }
    files::lay_out(&folders.chapters.join("widgets"), &all)
}

/// A widget's script, and those that it loads itself: `NAME.js`, `NAME.PART.js`.
fn scripts(name: &str, folders: &Folders) -> Result<Vec<String>, String> {
    let page = folders.widgets.join("page");
    let entries = fs::read_dir(&page).map_err(|e| format!("cannot read {}: {e}", page.display()))?;
    let names = entries.flatten().filter_map(|entry| entry.file_name().into_string().ok());
    let parts = names.filter(|file| file.starts_with(&format!("{name}.")) && file.ends_with(".js"));
    let own = format!("{name}.js");
    Ok(std::iter::once(own.clone()).chain(parts.filter(|part| *part != own)).collect())
}

/// A script that hands these bytes to the page: packed before they are text, which itself packs badly.
fn carrier(name: &str, bytes: &[u8]) -> Result<Vec<u8>, String> {
    let mut packed = Vec::new();
    ZlibEncoder::new(bytes, Compression::best()).read_to_end(&mut packed).map_err(|e| e.to_string())?;
    let text = BASE64_STANDARD.encode(packed);
    Ok(format!("tumblingLive.carry(\"{name}\", \"{text}\");\n").into_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_plain_name_is_a_directive() {
        assert_eq!(directive("{{#widget two-arrows}}\n"), Some("two-arrows"));
        for none in
            ["{{#widget}}", "{{#widget ../x}}", "{{#widget a}} and more", "{{#include a}}", "widget a"]
        {
            assert_eq!(directive(none), None, "{none}");
        }
    }
}
