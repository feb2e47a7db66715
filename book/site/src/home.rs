//! Whose the book is, from `CITATION.cff`, the one place where that is set; what is not set there is absent.

const CITATION: &str = include_str!("../../../CITATION.cff");

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
pub fn replace(text: &str) -> String {
    text.replacen(DIRECTIVE, &format!("- {}\n", listed(CITATION).join("\n- ")), 1)
}

/// It in one line of Markdown, for the foot of each page.
pub fn line() -> String {
    let parts = listed(CITATION).join("</span> · <span>"); // each whole, for another language
    format!("<span>{parts}</span> · [Licences](about.md#whose-it-is)")
}

/// `, ADDRESS`, once it is set.
pub fn address() -> String {
    value(CITATION, "url: ").map_or_else(String::new, |address| format!(", {address}"))
}

fn value<'a>(citation: &'a str, key: &str) -> Option<&'a str> {
    Some(citation.lines().find_map(|line| line.strip_prefix(key))?.trim_matches('"'))
}

fn listed(citation: &str) -> Vec<String> {
    let shown = |value: &str| if value.starts_with("http") { format!("<{value}>") } else { value.to_owned() };
    let line = |(key, name): (&str, &str)| Some(format!("{name}: {}", shown(value(citation, key)?)));
    FIELDS.into_iter().filter_map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_citation_has_is_listed_and_what_it_lacks_is_absent() {
        let citation = "authors:\n  - name: A. B.\nversion: 2.1\nurl: \"https://example.org\"\n";
        assert_eq!(listed(citation), ["By: A. B.", "Version: 2.1", "Address: <https://example.org>"]);
    }
}
