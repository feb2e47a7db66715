//! The chapters as the index of the search reads them.
//!
//! mdBook indexes every word of a page, even in programs, in the descriptions and numbers of drawings, and in
//! the controls of widgets. So the index is made from chapters without these and without the answers of
//! questions. The words in `search.toml` are added: readers may search for them, and no result shows them. A
//! page without words in that file is indexed as a whole, after the chapters that explain.

use super::programs;
use crate::files;
use crate::places::escaped;
use mdbook_preprocessor::book::{Book, BookItem};
use std::collections::BTreeMap;
use std::path::Path;

/// Where each kind that is left out begins, and what follows it.
const KINDS: [(&str, &str); 3] = [
    ("<svg", "</div>\n<a class=\"fig-large\""),
    ("<div class=\"live\"", "\n<script src=\""),
    ("<nav aria-label=\"Chapters", "</footer>"),
];

/// Removes what no reader searches for, and adds the words of `search.toml`.
///
/// # Errors
/// A fault in that file.
pub(super) fn reduce(book: &mut Book, root: &Path) -> Result<(), String> {
    let mut sought = words(root)?;
    book.for_each_mut(|item| {
        let BookItem::Chapter(chapter) = item else { return };
        let name = chapter.source_path.as_deref().and_then(Path::file_stem).and_then(|name| name.to_str());
        let text = unanswered(&programs::without(&without(&chapter.content)));
        chapter.content = match name.and_then(|name| sought.remove(name)) {
            Some(words) if words.is_empty() => text.replace("\n## ", "\n### "), // found as a whole
            Some(words) => with_words(&text, &words),
            None => text,
        };
    });
    match sought.keys().next() {
        Some(page) => Err(format!("book/search.toml has words for `{page}`, which is no page")),
        None => Ok(()),
    }
}

/// A chapter without drawings and widgets.
fn without(text: &str) -> String {
    let mut out = text.to_owned();
    let next = |text: &str| {
        let found = KINDS.iter().filter_map(|(from, to)| {
            let start = text.find(from)?;
            Some(start..start + text[start..].find(to)?)
        });
        found.min_by_key(|range| range.start)
    };
    while let Some(range) = next(&out) {
        out.replace_range(range, "");
    }
    out
}

/// A chapter without the answers of its questions: the last paragraph of each box.
fn unanswered(text: &str) -> String {
    let mut answer = false;
    let asked = text.lines().filter(|line| {
        answer = line.starts_with('>') && (answer || (line.starts_with("> *") && !line.starts_with("> **")));
        !answer
    });
    asked.fold(String::new(), |out, line| out + line + "\n")
}

/// The words of each page, where there are any.
///
/// # Errors
/// A fault in that file.
pub(crate) fn words(root: &Path) -> Result<BTreeMap<String, String>, String> {
    files::table(&root.join("search.toml"))
}

/// The words behind the chapter's title.
fn with_words(text: &str, words: &str) -> String {
    let title = if text.starts_with("# ") { text.find('\n').unwrap_or(text.len()) } else { 0 };
    let (before, after) = text.split_at(title);
    format!("{before}\n\n<p>{}</p>\n\n{after}", escaped(words))
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "# A\n\nOne.\n<div class=\"fig-frame\"><svg a><desc>hidden</desc></svg></div>\n<a class=\"fig-large\" \
        href=\"x\">Two</a>\n<div class=\"live\" id=\"l\">\n<div>controls</div>\n</div>\n<script src=\"x\"></script>\nThree.\n";

    #[test]
    fn drawings_and_controls_are_no_words_of_the_index() {
        let bare = without(PAGE);
        assert!(!bare.contains("hidden") && !bare.contains("controls"), "{bare}");
        assert!(["One.", "Two", "Three."].iter().all(|word| bare.contains(word)), "{bare}");
    }

    #[test]
    fn the_answer_of_a_question_is_no_word_of_the_index() {
        let asked = "> **Predict.** Which?\n>\n> - One\n>\n";
        assert_eq!(
            unanswered(&format!("{asked}> *One*: for\n> it is.\n\n*Two.*\n")),
            format!("{asked}\n*Two.*\n")
        );
    }

    #[test]
    fn words_to_be_found_by_stand_behind_the_title() {
        let text = with_words("# A\n\nOne.\n", "R I R^T & more");
        assert!(text.starts_with("# A\n\n<p>R I R^T &amp; more</p>\n\n"), "{text}");
    }
}
