//! The exercises at the end of a chapter: `{{#exercises}}`, alone in its line, becomes tasks with their
//! commands, and folds with code, hints and solution. A fold is `<details>`: it opens without a script.

use super::{Source, programs};
use std::fmt::Write as _;
use tumbling_exercises::Exercise;

const DIRECTIVE: &str = "{{#exercises}}";

/// The chapter's text with its exercises in it.
///
/// # Errors
/// If the chapter has exercises and does not show them, once, or shows some and has none.
pub(super) fn replace(source: &Source<'_>, all: &[Exercise]) -> Result<String, String> {
    let here: Vec<&Exercise> = all.iter().filter(|e| e.place().0 == source.name()).collect();
    let places: Vec<usize> = source.text.match_indices(DIRECTIVE).map(|(at, _)| at).collect();
    match (places.as_slice(), here.as_slice()) {
        ([], []) => Ok(source.text.to_owned()),
        ([], [first, ..]) => {
            let end = source.text.len();
            Err(source.fault(
                end,
                format!("the exercise `{}` and others are left out: write `{DIRECTIVE}`", first.name),
            ))
        }
        ([at], [_, ..]) if source.text.lines().any(|line| line == DIRECTIVE) => {
            let (before, after) = (&source.text[..*at], &source.text[at + DIRECTIVE.len()..]);
            Ok(format!("{before}{}{after}", section(&here)))
        }
        ([at, ..], []) => Err(source.fault(*at, "this chapter has no exercises")),
        ([at, ..], _) => Err(source.fault(*at, format!("`{DIRECTIVE}` stands once, alone in its line"))),
    }
}

/// The tasks, one after the other.
fn section(exercises: &[&Exercise]) -> String {
    let first = exercises.first().map(|first| first.command()).unwrap_or_default();
    let mut out = format!(
        "Each is a file in `book/exercises/stubs`. This checks the first:\n\n```sh\n{first}\n```\n\n\
         [How to run them](about.md#exercises).\n",
    );
    for exercise in exercises {
        let (_, number) = exercise.place();
        let name = &exercise.name;
        let _ = write!(
            out,
            "\n### {number}. {} {{#{name}}}\n\n{}\n\n{}",
            exercise.title,
            exercise.task,
            programs::fold("fold", "The code to complete", &code(&exercise.open()))
        );
        let hints = exercise.hints.len();
        for (at, hint) in exercise.hints.iter().enumerate() {
            let summary = if hints == 1 { "Hint".into() } else { format!("Hint {} of {hints}", at + 1) };
            out.push_str(&programs::fold("fold", &summary, hint));
        }
        let solution = format!("{}\n\n{}", code(exercise.solution()), exercise.words);
        out.push_str(&programs::fold("fold", "Solution", solution.trim_end()));
    }
    out
}

fn code(rust: &str) -> String {
    format!("```rust\n{}\n```", rust.trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(chapter: &str, text: &str) -> Result<String, String> {
        let file = format!("book/chapters/{chapter}.md");
        replace(&Source { file: &file, text }, &tumbling_exercises::all().unwrap())
    }

    #[test]
    fn a_chapter_shows_its_own_exercises_with_code_hints_and_solution_and_the_command_once() {
        let out = shown("two-arrows", "# A\n\n## Exercises\n\n{{#exercises}}\n").unwrap();
        for exercise in tumbling_exercises::all().unwrap() {
            let mine = exercise.place().0 == "two-arrows";
            assert_eq!(out.contains(exercise.solution().trim_end()), mine, "{}", exercise.name);
        }
        assert!(out.starts_with("# A\n\n## Exercises\n\nEach is a file") && !out.contains("{{#"));
        let here: Vec<_> =
            tumbling_exercises::all().unwrap().into_iter().filter(|e| e.place().0 == "two-arrows").collect();
        assert!(out.contains(&here[0].command()) && out.matches("cargo exercise").count() == 1, "{out}");
        for exercise in &here {
            let (_, from) = out.split_once(&format!("{{#{}}}\n", exercise.name)).unwrap();
            let mine = from.split("\n### ").next().unwrap();
            let (shown, folded) = mine.split_once("<details").unwrap();
            assert!(shown.contains(&exercise.task), "before all folds: {shown}");
            // The words and the contents of each fold, in the order of the page.
            let mut expected = vec![("The code to complete".to_owned(), code(&exercise.open()))];
            for (at, hint) in exercise.hints.iter().enumerate() {
                let of = exercise.hints.len();
                let title = if of == 1 { "Hint".to_owned() } else { format!("Hint {} of {of}", at + 1) };
                expected.push((title, hint.clone()));
            }
            let words = format!("{}\n\n{}", code(exercise.solution()), exercise.words);
            expected.push(("Solution".to_owned(), words.trim_end().to_owned()));
            let mut found = Vec::new();
            for fold in
                format!("<details{folded}").split("</details>\n\n").filter(|fold| !fold.trim().is_empty())
            {
                let shut = fold.strip_prefix("<details class=\"fold\">\n<summary>");
                let (title, inside) = shut.expect("every fold is shut").split_once("</summary>\n\n").unwrap();
                found.push((title.to_owned(), inside.strip_suffix("\n\n").unwrap().to_owned()));
            }
            assert_eq!(found, expected, "{}", exercise.name);
        }
        let hints: usize = here.iter().map(|e| e.hints.len()).sum();
        assert!(hints > here.len(), "one of them has two hints");
        assert_eq!(out.matches("<details class=\"fold\">\n").count(), 2 * here.len() + hints);
    }

    #[test]
    fn exercises_left_out_shown_twice_or_shown_where_there_are_none_are_faults() {
        for (chapter, text, what) in [
            ("two-arrows", "# A\n", "two-arrows.md:2: the exercise `two_arrows_1` and others are left out"),
            (
                "two-arrows",
                "{{#exercises}}\n{{#exercises}}\n",
                "two-arrows.md:1: `{{#exercises}}` stands once",
            ),
            ("two-arrows", "a {{#exercises}}\n", "alone in its line"),
            ("glossary", "a\n\n{{#exercises}}\n", "glossary.md:3: this chapter has no exercises"),
        ] {
            let fault = shown(chapter, text).unwrap_err();
            assert!(fault.contains(what), "{fault}");
        }
        assert_eq!(shown("glossary", "# A\n").unwrap(), "# A\n");
    }
}
