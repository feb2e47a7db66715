//! Folds: each program of the text waits behind one quiet line. A fold is `<details>`: it opens without a
//! script.

use super::edits::Edits;
use super::{Piece, nested};
use pulldown_cmark::{CodeBlockKind, Event, Tag};

/// Folds every Rust block that stands in the text itself, in no list, no quote and no other fold, unless it
/// is to be `shown`.
pub(super) fn replace(text: &str, pieces: &[Piece<'_>], edits: &mut Edits) {
    let mut folds = 0_usize;
    for (_, depth, (event, range)) in nested(pieces) {
        match event {
            Event::Html(html) | Event::InlineHtml(html) => {
                folds = (folds + html.matches("<details").count())
                    .saturating_sub(html.matches("</details>").count());
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language)))
                if depth == 0 && folds == 0 && language.starts_with("rust") =>
            {
                let block = &text[range.clone()];
                let made = match language.ends_with(",shown") {
                    true => format!("<div class=\"program\">\n\n{}\n\n</div>\n\n", block.trim_end()),
                    false => fold("fold program", &summary(block), block),
                };
                edits.replace(range.clone(), made);
            }
            _ => {}
        }
    }
}

/// The lines of a fenced block that its page shows: rustdoc hides those that begin with `# `.
fn summary(block: &str) -> String {
    let inside = block.trim_end().lines().filter(|line| !line.starts_with("```"));
    let shown = inside.filter(|line| !line.starts_with("# ") && *line != "#" && !line.is_empty()).count();
    format!("Checked by {shown} {} of Rust", if shown == 1 { "line" } else { "lines" })
}

/// A chapter as it is shown, without its programs and what opens them.
pub(super) fn without(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut inside = false;
    for line in text.lines() {
        let fence = line.trim_start_matches(['>', ' ']);
        let opens = !inside && fence.starts_with("```rust");
        if !(inside || opens || line.starts_with("<summary>Checked by ")) {
            out.push_str(line);
            out.push('\n');
        }
        inside = opens || (inside && fence.trim_end() != "```");
    }
    out
}

/// A fold with blank lines around what is inside, so that Markdown reads it.
pub(super) fn fold(class: &str, summary: &str, inside: &str) -> String {
    format!(
        "<details class=\"{class}\">\n<summary>{summary}</summary>\n\n{}\n\n</details>\n\n",
        inside.trim_end()
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::preprocess::pieces;

    fn folded(text: &str) -> String {
        let mut edits = Edits::default();
        replace(text, &pieces(text), &mut edits);
        edits.applied_to(text)
    }

    #[test]
    fn a_program_is_folded_behind_the_number_of_its_lines() {
        let text = "One.\n\n```rust\n# use std::f64;\nlet a = 1;\n\nassert_eq!(a, 1);\n```\n\nTwo.\n";
        assert_eq!(
            folded(text),
            "One.\n\n<details class=\"fold program\">\n<summary>Checked by 2 lines of Rust</summary>\n\n\
             ```rust\n# use std::f64;\nlet a = 1;\n\nassert_eq!(a, 1);\n```\n\n</details>\n\n\n\nTwo.\n"
        );
    }

    #[test]
    fn a_chapter_can_be_had_without_its_programs() {
        let text = folded(
            "One.\n\n```rust\nlet a = 1;\n```\n\n```sh\ncargo test\n```\n\n- a\n\n  ```rust,x\n  b();\n  ```\n\nTwo.\n",
        );
        let bare = without(&text);
        assert!(["One.", "cargo test", "- a", "Two."].iter().all(|words| bare.contains(words)), "{bare}");
        assert!(["let a", "b()", "Checked", "rust"].iter().all(|words| !bare.contains(words)), "{bare}");
    }

    #[test]
    fn what_is_folded_already_and_other_languages_stay_as_they_are() {
        for text in [
            "<details class=\"fold\">\n<summary>Hint</summary>\n\n```rust\nlet a = 1;\n```\n\n</details>\n",
            "```sh\ncargo test\n```\n",
            "- one\n\n  ```rust\n  let a = 1;\n  ```\n",
        ] {
            assert_eq!(folded(text), text);
        }
        let shown = "```rust,shown\nlet a = 1;\n```\n";
        assert_eq!(folded(shown), format!("<div class=\"program\">\n\n{shown}\n</div>\n\n\n"));
        let after = "<details>\n<summary>Hint</summary>\n\n</details>\n\n```rust\nlet a = 1;\n```\n";
        assert!(folded(after).contains("Checked by 1 line of"), "{}", folded(after));
    }
}
