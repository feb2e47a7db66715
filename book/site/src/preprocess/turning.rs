//! The foot of each page: the chapter before and the one after, each with a sentence, and whose the book is.

use crate::home;
use crate::places::{self, escaped};
use mdbook_preprocessor::book::{Book, BookItem};
use std::path::{Path, PathBuf};

/// Adds the foot to every chapter of a book that has sentences for its pages; returns what was wrong.
pub(super) fn add(book: &mut Book, root: &Path) -> Vec<String> {
    let mut sentences = match places::sentences(root) {
        Ok(sentences) if sentences.is_empty() => return Vec::new(),
        Ok(sentences) => sentences,
        Err(what) => return vec![what],
    };
    let mut faults = Vec::new();
    let mut chapters = Vec::new();
    for chapter in book.chapters() {
        let Some(path) = &chapter.source_path else { continue };
        let page = path.with_extension("").display().to_string();
        match sentences.remove(&page) {
            Some(sentence) => chapters.push((path.clone(), chapter.name.clone(), sentence)),
            None => faults.push(format!("book/pages.toml has no sentence for `{page}`")),
        }
    }
    let other = |page| format!("book/pages.toml has a sentence for `{page}`, which is no page");
    faults.extend(sentences.keys().map(other));
    if !faults.is_empty() {
        return faults;
    }
    book.for_each_mut(|item| {
        if let BookItem::Chapter(chapter) = item
            && let Some(path) = &chapter.source_path
            && let Some(at) = chapters.iter().position(|(other, ..)| other == path)
        {
            let before = at.checked_sub(1).and_then(|at| chapters.get(at));
            chapter.content.push_str(&foot(before, chapters.get(at + 1)));
        }
    });
    Vec::new()
}

type Page = (PathBuf, String, String);

fn foot(before: Option<&Page>, after: Option<&Page>) -> String {
    let mut html =
        String::from("\n\n<footer class=\"turning\">\n<nav aria-label=\"Chapters before and after\">\n");
    for (way, chapter) in [("Before", before), ("Next", after)] {
        if let Some((path, name, sentence)) = chapter {
            html.push_str(&format!(
                "<p class=\"turning-{}\"><span>{way}</span> <a href=\"{}\">{}</a> {}</p>\n",
                way.to_lowercase(),
                path.with_extension("html").display(),
                escaped(name),
                escaped(sentence),
            ));
        }
    }
    html + "</nav>\n\n" + &home::line() + "\n\n</footer>\n"
}
