//! What each page says of itself in one sentence, `book/pages.toml`.

use std::collections::BTreeMap;
use std::path::Path;

/// The sentences, by the names of the chapters' files without their ending.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Sentences(BTreeMap<String, String>);

impl Sentences {
    /// Reads `pages.toml` in the folder of the book, if there is one.
    ///
    /// # Errors
    /// The fault in the file. A sentence with a number is one, since no code supports the number.
    pub(crate) fn read(book: &Path) -> Result<Option<Self>, String> {
        let file = book.join("pages.toml");
        match std::fs::read_to_string(&file) {
            Ok(text) => Self::parse(&text).map(Some).map_err(|what| format!("{}: {what}", file.display())),
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(e) => Err(format!("cannot read {}: {e}", file.display())),
        }
    }

    fn parse(text: &str) -> Result<Self, String> {
        let all: BTreeMap<String, String> = toml::from_str(text).map_err(|e| e.to_string())?;
        for (page, sentence) in &all {
            if let Some(what) = unsound(sentence) {
                return Err(format!("the sentence of `{page}` {what}"));
            }
        }
        Ok(Self(all))
    }

    /// The sentence of the page from this file.
    ///
    /// # Errors
    /// There is none.
    pub(crate) fn of(&self, file: &Path) -> Result<&str, String> {
        let name = file.file_stem().and_then(|name| name.to_str()).unwrap_or_default();
        let missing = || format!("book/pages.toml has no sentence for `{name}`");
        self.0.get(name).map(String::as_str).ok_or_else(missing)
    }

    /// The pages that have one.
    pub(crate) fn pages(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }
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
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_with_a_number_or_without_an_end_is_refused() {
        assert!(Sentences::parse("a = 'Fine.'").is_ok());
        assert!(Sentences::parse("a = 'The 3 axes.'").unwrap_err().contains("number"));
        assert!(Sentences::parse("a = 'No end'").unwrap_err().contains("full stop"));
    }

    #[test]
    fn the_page_that_has_no_sentence_is_named() {
        let sentences = Sentences::parse("a = 'Fine.'").unwrap();
        assert_eq!(sentences.of(Path::new("a.md")), Ok("Fine."));
        assert!(sentences.of(Path::new("b.md")).unwrap_err().contains("`b`"));
    }
}
