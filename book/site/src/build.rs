//! Building the pages.

use crate::docs;
use crate::files::{self, write_changed};
use crate::places::escaped;
use crate::preprocess::{Preprocess, indexed};
use crate::say;
use crate::share::{self, Site};
use crate::{log, paths};
use mdbook_driver::MDBook;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The position stage for engines, which a chapter links to; it is in the folder `engine` next to the pages.
const TO_TAKE_ALONG: [&str; 2] = ["c/position_stage.h", "position_stage.rs"];

/// Builds the book into `book/html/`, for publication at `site` if that is known.
///
/// # Errors
/// What mdBook or our preprocessor found wrong. A warning counts as wrong, and so does a page with a
/// directive left in it that mdBook was to replace.
pub fn build(site: Option<&Site>) -> Result<(), String> {
    let start = Instant::now();
    let pages = build_into(None, site)?;
    if !docs::lay_beside(&paths::pages())? {
        say!("Without the library's documentation: `cargo run` makes that too.");
    }
    say!("Built {pages} pages in {:.1} s: {}", start.elapsed().as_secs_f64(), paths::pages().display());
    Ok(())
}

/// Builds into `destination`, or where `book.toml` says; returns the number of pages.
fn build_into(destination: Option<&Path>, site: Option<&Site>) -> Result<usize, String> {
    let folder = rendered(destination, Preprocess::Pages)?;
    // mdBook copies all files next to the chapters that are not Markdown; this one must not become a page.
    let _ = fs::remove_file(folder.join("lib.rs"));
    for file in TO_TAKE_ALONG {
        let from = paths::repository().join("examples/engines").join(file);
        docs::copy(&from, &folder.join("engine").join(file))?;
    }
    share::tell(paths::book(), &folder, site)?;
    index_of_words(&folder)?;
    left_directives(&folder)
}

/// Gives the pages the index of a book without programs, drawings and widgets: mdBook's own has every word of
/// them.
fn index_of_words(pages: &Path) -> Result<(), String> {
    let bare = tempfile::TempDir::new().map_err(|e| format!("no folder for the index: {e}"))?;
    let [from, to] = [&rendered(Some(bare.path()), Preprocess::Index)?, pages].map(|folder| {
        let files = fs::read_dir(folder).into_iter().flatten().flatten().map(|file| file.path());
        let named = |path: &PathBuf| path.file_name().and_then(|name| name.to_str()).map(str::to_owned);
        let index = |path: &PathBuf| named(path).is_some_and(|name| name.starts_with("searchindex"));
        files.filter(index).collect::<Vec<_>>()
    });
    match (from.as_slice(), to.as_slice()) {
        ([from], [to]) => {
            // No result shows the words by which it is found.
            let bare = |text: String, words: &String| text.replace(&format!("{} ", escaped(words)), "");
            let words = indexed::words(paths::book())?;
            let text = words.values().filter(|words| !words.is_empty()).fold(files::text(from)?, bare);
            write_changed(to, text.as_bytes()).map(|_| ())
        }
        _ => Err(format!("{} and {} indices of the search, not one and one", from.len(), to.len())),
    }
}

/// What mdBook makes of the chapters by this preprocessor, and where.
pub fn rendered(destination: Option<&Path>, preprocessor: Preprocess) -> Result<PathBuf, String> {
    let (built, complaints) = log::listening(|| -> Result<PathBuf, mdbook_driver::errors::Error> {
        let mut book = MDBook::load(paths::book())?;
        if let Some(folder) = destination {
            book.config.build.build_dir = folder.to_owned();
        }
        // book.toml names our preprocessor as a command, for those who run mdBook itself. Here it
        // is at hand: ours of the same name takes the place of the command.
        book.with_preprocessor(preprocessor);
        book.build()?;
        Ok(book.build_dir_for("html"))
    });
    let folder = built.map_err(|e| format!("the book was not built.\n{e:#}"))?;
    if complaints > 0 {
        return Err(format!("mdBook complained {complaints} times, see above"));
    }
    Ok(folder)
}

/// Counts the pages; a page that still holds a directive is an error.
fn left_directives(folder: &Path) -> Result<usize, String> {
    let cannot = |e: std::io::Error| format!("cannot read the pages in {}: {e}", folder.display());
    let mut pages = 0;
    for entry in fs::read_dir(folder).map_err(cannot)? {
        let path = entry.map_err(cannot)?.path();
        if path.extension().is_some_and(|e| e == "html") {
            pages += 1;
            if fs::read_to_string(&path).map_err(cannot)?.contains("{{#") {
                let why = "contains `{{#`: a directive that mdBook did not replace";
                return Err(format!("{} {why}", path.display()));
            }
        }
    }
    Ok(pages)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_book_builds_without_a_complaint() {
        let folder = tempfile::TempDir::new().unwrap();
        let site = Site::parse("https://example.org/book/").unwrap();
        let pages = build_into(Some(folder.path()), Some(&site)).unwrap();
        let chapters = include_str!("../../chapters/SUMMARY.md").matches("](").count();
        // Besides the chapters: the first once more as index, the table of contents, the whole book
        // for printing, and the page for addresses that lead nowhere; the table of contents in German.
        assert_eq!(pages, chapters + 5);
        for file in TO_TAKE_ALONG {
            assert!(folder.path().join("engine").join(file).exists(), "{file}");
        }

        let page = fs::read_to_string(folder.path().join("two-arrows.html")).unwrap();
        assert!(page.contains("class=\"turning\"") && page.contains("rel=\"canonical\""));
        assert!(page.contains("<svg") && page.contains("id=\"live-two-arrows\""));
        let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
        for name in ["index.html", "404.html", "toc.html", "print.html", "proofs.html"] {
            assert_eq!(read(name).matches("og:image").count(), 1, "{name}");
        }
        let [german, toc] = ["toss-a-book-de.html", "toc-de.html"].map(read);
        assert!(german.contains("<html lang=\"de\"") && !german.contains("\"Next chapter\""));
        assert!(german.contains("\"toc-de.html\""));
        assert!(toc.contains("8.</strong> Warum") && toc.contains("Eulers") && !toc.contains("-book.html"));
        let files = fs::read_dir(folder.path()).unwrap().map(|file| file.unwrap().path());
        let index = files.filter(|file| file.to_string_lossy().contains("searchindex"));
        let index: String = index.map(|file| fs::read_to_string(file).unwrap()).collect();
        for words in ["tennis racket", "separatrix", "gyroscopic", "coin"] {
            assert!(index.contains(words), "{words}");
        }
        // The last ones are of `search.toml`, by which a page is found and which no result shows.
        for words in ["With JavaScript", "assert_eq", "use nalgebra", "Checked by", "R I R^T, R I RT"] {
            assert!(!index.contains(words), "{words}");
        }
        // A drawing's description.
        assert!(!index.contains("Each grey curve is a method at ever finer steps. A bold"));
        let map = fs::read_to_string(folder.path().join("sitemap.xml")).unwrap();
        assert_eq!(map.matches("<loc>").count(), chapters);
        assert!(map.contains("<loc>https://example.org/book/two-arrows.html</loc>"), "{map}");
        assert!(folder.path().join("preview.png").is_file());
    }

    #[test]
    fn a_directive_left_in_a_page_is_a_fault() {
        let folder = tempfile::TempDir::new().unwrap();
        fs::write(folder.path().join("a.html"), "fine").unwrap();
        assert_eq!(left_directives(folder.path()), Ok(1));
        fs::write(folder.path().join("b.html"), "{{#include missing.rs}}").unwrap();
        assert!(left_directives(folder.path()).unwrap_err().contains("b.html"));
    }
}
