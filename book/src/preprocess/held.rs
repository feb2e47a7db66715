//! What the index of the search must not read, held back while mdBook builds the pages, and what it should
//! read besides.
//!
//! mdBook indexes every word of a page: the description and the numbers in a drawing too, and the controls of
//! a widget. So these become comments, which it passes over, and are put back into the finished pages. The
//! words in `search.toml`, by which a reader would look for a page, stand in it only as long as the index is
//! made. Where mdBook builds the book by itself, drawings and widgets stand in the chapters from the first.

use crate::site::places::escaped;
use mdbook_preprocessor::book::{Book, BookItem};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// Where each kind begins, and what follows it.
const KINDS: [(&str, &str); 2] =
    [("<svg", "</div>\n<a class=\"fig-large\""), ("<div class=\"live\"", "\n<script src=\"")];

const OPENING: &str = "<!--held ";
const CLOSING: &str = "-->";
const SOUGHT: [&str; 2] = ["<p class=\"sought\">", "</p>\n"];

/// The pieces held back. Clones share them.
#[derive(Debug, Clone, Default)]
pub(crate) struct Held(Arc<Mutex<Vec<String>>>);

impl Held {
    /// Takes the pieces out of the chapters, and puts the words of `search.toml` in.
    ///
    /// # Errors
    /// What is wrong with that file.
    pub(super) fn take(&self, book: &mut Book, root: &Path) -> Result<(), String> {
        let mut sought = words(root)?;
        book.for_each_mut(|item| {
            let BookItem::Chapter(chapter) = item else { return };
            let name =
                chapter.source_path.as_deref().and_then(Path::file_stem).and_then(|name| name.to_str());
            let text = self.without(&chapter.content);
            chapter.content = match name.and_then(|name| sought.remove(name)) {
                Some(words) => with_words(&text, &words),
                None => text,
            };
        });
        match sought.keys().next() {
            Some(page) => Err(format!("book/search.toml has words for `{page}`, which is no page")),
            None => Ok(()),
        }
    }

    fn without(&self, text: &str) -> String {
        let mut pieces = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut out = String::with_capacity(text.len());
        let mut rest = text;
        let next = |rest: &str| {
            let found = KINDS.iter().filter_map(|(from, to)| {
                let start = rest.find(from)?;
                Some(start..start + rest[start..].find(to)?)
            });
            found.min_by_key(|range| range.start)
        };
        while let Some(range) = next(rest) {
            out.push_str(&rest[..range.start]);
            out.push_str(&format!("{OPENING}{}{CLOSING}", pieces.len()));
            pieces.push(rest[range.clone()].to_owned());
            rest = &rest[range.end..];
        }
        out + rest
    }

    /// Puts every piece back into the pages in this folder.
    ///
    /// # Errors
    /// A page that cannot be read or written.
    pub(crate) fn put_back(&self, folder: &Path) -> Result<(), String> {
        let cannot =
            |e: std::io::Error| format!("cannot put figures into the pages of {}: {e}", folder.display());
        for entry in fs::read_dir(folder).map_err(cannot)? {
            let path = entry.map_err(cannot)?.path();
            if path.extension().is_some_and(|e| e == "html") {
                let page = fs::read_to_string(&path).map_err(cannot)?;
                fs::write(&path, self.whole(&page)).map_err(cannot)?;
            }
        }
        Ok(())
    }

    fn whole(&self, page: &str) -> String {
        let pieces = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut parts = page.split(OPENING);
        let mut out = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let (number, after) = part.split_once(CLOSING).unwrap_or((part, ""));
            out.push_str(
                number.parse::<usize>().ok().and_then(|at| pieces.get(at)).map_or("", String::as_str),
            );
            out.push_str(after);
        }
        while let Some(start) = out.find(SOUGHT[0]) {
            let end = out[start..].find("</p>").map_or(out.len(), |end| start + end + "</p>".len());
            out.replace_range(start..end, "");
        }
        out
    }
}

/// The words of each page, where there are any.
fn words(root: &Path) -> Result<BTreeMap<String, String>, String> {
    match fs::read_to_string(root.join("search.toml")) {
        Ok(text) => toml::from_str(&text).map_err(|e| format!("book/search.toml: {e}")),
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => Ok(BTreeMap::new()),
        Err(e) => Err(format!("cannot read book/search.toml: {e}")),
    }
}

/// The words behind the chapter's title.
fn with_words(text: &str, words: &str) -> String {
    let title = if text.starts_with("# ") { text.find('\n').unwrap_or(text.len()) } else { 0 };
    let (before, after) = text.split_at(title);
    format!("{before}\n\n{}{}{}\n{after}", SOUGHT[0], escaped(words), SOUGHT[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "# A\n\nOne.\n<div class=\"fig-frame\"><svg a><desc>hidden</desc></svg></div>\n<a class=\"fig-large\" \
        href=\"x\">Two</a>\n<div class=\"live\" id=\"l\">\n<div>controls</div>\n</div>\n<script src=\"x\"></script>\nThree.\n";

    #[test]
    fn what_is_held_back_is_no_word_of_the_page_and_comes_back_as_it_was() {
        let held = Held::default();
        let bare = held.without(PAGE);
        assert!(!bare.contains("hidden") && !bare.contains("controls"), "{bare}");
        assert!(["One.", "Two", "Three."].iter().all(|word| bare.contains(word)), "{bare}");
        assert_eq!(held.whole(&bare), PAGE);
        let other = held.without(PAGE);
        assert_ne!(other, bare, "pieces are numbered through");
        assert_eq!(held.whole(&other), PAGE);
    }

    #[test]
    fn words_to_be_found_by_stand_behind_the_title_and_leave_the_finished_page() {
        let text = with_words("# A\n\nOne.\n", "R I R^T & more");
        assert!(text.starts_with("# A\n\n<p class=\"sought\">R I R^T &amp; more</p>"), "{text}");
        assert_eq!(Held::default().whole(&text).replace('\n', ""), "# AOne.");
    }
}
