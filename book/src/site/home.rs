//! Whose the book is, from `CITATION.cff`, the one place where that is set; what is not set there is absent.

use crate::site::{files, paths};

/// Where a page says it, alone in its line.
const DIRECTIVE: &str = "{{#home}}\n";

/// The keys of the file, and what they are.
const FIELDS: [(&str, &str); 5] = [
    ("  - name: ", "By"),
    ("version: ", "Version"),
    ("date-released: ", "Date"),
    ("repository-code: ", "Source"),
    ("url: ", "Address"),
];

/// A page's text with it in the place of the directive.
///
/// # Errors
/// A file that cannot be read.
pub(crate) fn replace(text: &str) -> Result<String, String> {
    if !text.contains(DIRECTIVE) {
        return Ok(text.to_owned());
    }
    Ok(text.replacen(DIRECTIVE, &listed(&files::text(&paths::repository().join("CITATION.cff"))?), 1))
}

fn listed(citation: &str) -> String {
    let value = |key: &str| citation.lines().find_map(|line| line.strip_prefix(key));
    let shown = |value: &str| if value.starts_with("http") { format!("<{value}>") } else { value.to_owned() };
    let line =
        |(key, name): (&str, &str)| Some(format!("- {name}: {}\n", shown(value(key)?.trim_matches('"'))));
    FIELDS.into_iter().filter_map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_citation_has_is_listed_and_what_it_lacks_is_absent() {
        let citation = "authors:\n  - name: A. B.\nversion: 2.1\nurl: \"https://example.org\"\n";
        assert_eq!(listed(citation), "- By: A. B.\n- Version: 2.1\n- Address: <https://example.org>\n");
    }
}
