//! What each page says of itself in one sentence, `book/pages.toml`.

use crate::files;
use std::collections::BTreeMap;
use std::path::Path;

/// The sentences in the folder of the book, by the names of the chapters' files without their ending; none
/// where there is no `pages.toml`.
///
/// # Errors
/// The fault in the file. A sentence with a number is one, since no code supports the number.
pub fn sentences(book: &Path) -> Result<BTreeMap<String, String>, String> {
    let all = files::table(&book.join("pages.toml"))?;
    let of = |(page, sentence): (&String, &String)| {
        Some(format!("book/pages.toml: the sentence of `{page}` {}", unsound(sentence)?))
    };
    all.iter().find_map(of).map_or(Ok(all), Err)
}

/// What is wrong with a sentence that no code holds.
pub(super) fn unsound(sentence: &str) -> Option<&'static str> {
    match sentence.ends_with('.') {
        _ if sentence.contains(|c: char| c.is_ascii_digit()) => {
            Some("has a number in it, which nothing holds")
        }
        true => None,
        false => Some("does not end with a full stop"),
    }
}

/// A text as HTML shows it.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_with_a_number_or_without_an_end_is_refused() {
        let book = tempfile::TempDir::new().unwrap();
        assert_eq!(sentences(book.path()), Ok(BTreeMap::new()));
        for (text, fault) in [("a = 'The 3 axes.'", "number"), ("a = 'No end'", "full stop"), ("a", "TOML")] {
            std::fs::write(book.path().join("pages.toml"), text).unwrap();
            assert!(sentences(book.path()).unwrap_err().contains(fault), "{text}");
        }
    }
}
