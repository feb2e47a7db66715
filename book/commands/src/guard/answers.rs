//! Answers: checks that the right answers of questions, and the answers of problems, rest on assertions of
//! the section's code.

use super::chapter::{Chapter, Section};
use super::offence::Offence;
use std::ops::Range;
use tumbling_site::preprocess::question;

/// The evidence for an answer.
const ASSERTED: &str = "it as a string that an `assert_eq!` of this section expects";

/// The answers that no assertion contains.
pub(super) fn offences(chapter: &Chapter) -> Vec<Offence> {
    let mut found = Vec::new();
    let mut offend = |at, what| found.push(chapter.offence(chapter.line(at), what, ASSERTED));
    for (at, right) in question::answers(&chapter.text) {
        let asserted = section(chapter, at).is_some_and(|s| asserted(s).any(|words| words == right));
        if !asserted {
            offend(at, format!("the answer `{right}`"));
        }
    }
    let folds = folds(&chapter.text).filter(|_| chapter.name == "problems");
    for fold in folds {
        let answer = section(chapter, fold.start).is_some_and(|section| {
            let inside = |at: usize| fold.contains(&at);
            let said = section.passages.iter().filter(|p| inside(p.source(0))).map(|p| &p.text);
            let said = said.map(String::as_str).collect::<Vec<_>>().join(" ");
            asserted(section).any(|words| said.contains(words))
        });
        if !answer {
            offend(fold.start, "an answer".into());
        }
    }
    found
}

/// The section in which this byte of the chapter stands.
fn section(chapter: &Chapter, at: usize) -> Option<&Section> {
    let begins = |s: &Section| s.passages.first().map_or(usize::MAX, |passage| passage.source(0));
    chapter.sections.iter().rev().find(|s| begins(s) <= at)
}

/// The strings that the code of a section asserts, with numbers or without.
fn asserted(section: &Section) -> impl Iterator<Item = &str> {
    section.blocks.iter().flat_map(|block| {
        let numbers = block.code.phrases.iter().filter(|p| p.asserted).map(|p| p.text.as_str());
        numbers.chain(block.code.answers.iter().map(String::as_str))
    })
}

/// The folds of a chapter in which answers stand.
fn folds(text: &str) -> impl Iterator<Item = Range<usize>> {
    text.match_indices("<details").map(|(at, _)| at..at + text[at..].find("</details>").unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::super::Reader;

    fn offences(name: &str, text: &str) -> Vec<String> {
        let chapter = Reader::default().chapter(name, "x.md", text).unwrap();
        super::offences(&chapter).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn the_right_answer_of_a_question_is_one_that_the_code_of_its_section_gives() {
        let text = "## A\n\n> **Predict.** Up?\n>\n> - Up\n> - Down $x$\n>\n> *Down $x$*: it must.\n\n```rust\nassert_eq!(way, [\"Down $x$\"]);\n```\n\n## B\n";
        assert_eq!(offences("x", text), [""; 0]);
        for (from, to) in
            [("*Down $x$*", "*Up*"), ("[\"Down", "[\"No, down"), ("\n```rust", "\n## C\n\n```rust")]
        {
            let wrong = offences("x", &text.replace(from, to));
            assert!(wrong.len() == 1 && wrong[0].starts_with("x.md:3: found the answer `"), "{wrong:?}");
        }
    }

    #[test]
    fn the_answer_of_a_problem_says_something_that_the_code_of_its_section_gives() {
        let text = "### A\n\nHow?\n\n<details class=\"fold\">\n<summary>Answer</summary>\n\nSmaller. It is nearer.\n\n</details>\n\n```rust\nassert_eq!(way, \"Smaller\");\n```\n\n### B\n\nSmaller.\n";
        assert_eq!(offences("problems", text), [""; 0]);
        let wrong = offences("problems", &text.replace("Smaller. It", "Larger. It"));
        assert!(wrong.len() == 1 && wrong[0].starts_with("x.md:5: found an answer"), "{wrong:?}");
    }
}
