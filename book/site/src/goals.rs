//! What a reader can do after each chapter, `book/goals.toml`, and the exercise or question that shows it.

use crate::places::unsound;
use crate::preprocess::question;
use crate::{files, paths};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Something that a reader can do.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Goal {
    /// Continues "After this chapter you can".
    pub goal: String,
    /// The name of an exercise of the chapter, or `question N`.
    pub shown: String,
}

type Goals = BTreeMap<String, Vec<Goal>>;

/// How many goals a chapter may have.
const NUMBER: std::ops::RangeInclusive<usize> = 2..=4;

/// The goals of a chapter.
///
/// # Errors
/// A goal that nothing shows, or a chapter without goals.
pub fn of(chapter: &str) -> Result<Vec<Goal>, String> {
    let mut all = read()?;
    all.remove(chapter).ok_or_else(|| format!("book/goals.toml has no goals for `{chapter}`"))
}

/// The goals of all chapters as Markdown, each with a link to what shows it.
///
/// # Errors
/// A goal that nothing shows, or a chapter without goals.
fn listed() -> Result<String, String> {
    let all = read()?;
    let mut out = String::new();
    for (chapter, title) in chapters()? {
        out.push_str(&format!("- **[{title}]({chapter}.md).**"));
        for goal in all.get(&chapter).into_iter().flatten() {
            let place = match goal.shown.strip_prefix("question ") {
                Some(number) => format!("{chapter}-question-{number}"),
                None => goal.shown.clone(),
            };
            out.push_str(&format!(" [{}]({chapter}.md#{place})", goal.goal));
        }
        out.push('\n');
    }
    Ok(out)
}

/// The directive in whose place a page lists all goals; it must be alone in its line.
const DIRECTIVE: &str = "{{#goals}}\n";

/// A chapter's text with the list of all goals in the place of the directive.
///
/// # Errors
/// A goal that nothing shows, or a chapter without goals.
pub fn replace(text: &str) -> Result<String, String> {
    if text.contains(DIRECTIVE) { Ok(text.replacen(DIRECTIVE, &listed()?, 1)) } else { Ok(text.to_owned()) }
}

/// The chapters that have exercises and their titles, in order.
fn chapters() -> Result<Vec<(String, String)>, String> {
    let taught = |(name, _): &(String, String)| {
        let text = fs::read_to_string(paths::chapters().join(format!("{name}.md")));
        text.is_ok_and(|text| text.contains("{{#exercises}}"))
    };
    Ok(files::listed(&paths::chapters())?.into_iter().filter(taught).collect())
}

fn read() -> Result<Goals, String> {
    let text = files::text(&paths::book().join("goals.toml"))?;
    let goals: Goals = toml::from_str(&text).map_err(|e| format!("book/goals.toml: {e}"))?;
    let names: Vec<String> = chapters()?.into_iter().map(|(chapter, _)| chapter).collect();
    let exercises = tumbling_exercises::all()?;
    let exercises: Vec<(String, &str)> = exercises.iter().map(|e| (e.place().0, e.name.as_str())).collect();
    let faults = faults(&goals, &names, &exercises, &|chapter| questions(&paths::chapters(), chapter));
    if faults.is_empty() { Ok(goals) } else { Err(faults.join("\n")) }
}

/// The number of questions of a chapter.
fn questions(folder: &Path, chapter: &str) -> usize {
    let text = fs::read_to_string(folder.join(format!("{chapter}.md"))).unwrap_or_default();
    question::answers(&text).len()
}

/// What is wrong with the goals.
fn faults(
    goals: &Goals,
    chapters: &[String],
    exercises: &[(String, &str)],
    questions: &dyn Fn(&str) -> usize,
) -> Vec<String> {
    let mut faults = Vec::new();
    for chapter in chapters {
        let count = goals.get(chapter).map_or(0, Vec::len);
        if !NUMBER.contains(&count) {
            faults.push(format!("book/goals.toml: `{chapter}` has {count} goals, not two to four"));
        }
    }
    for (chapter, of) in goals {
        if !chapters.contains(chapter) {
            faults.push(format!("book/goals.toml has goals for `{chapter}`, which is no chapter"));
        }
        for Goal { goal, shown } in of {
            let known = match shown.strip_prefix("question ") {
                Some(number) => {
                    number.parse().is_ok_and(|number: usize| (1..=questions(chapter)).contains(&number))
                }
                None => exercises.iter().any(|(at, name)| at == chapter && name == shown),
            };
            if !known {
                faults.push(format!("book/goals.toml: `{chapter}` has no `{shown}` to show \"{goal}\""));
            }
            faults.extend(unsound(goal).map(|what| format!("book/goals.toml: \"{goal}\" {what}")));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_goal_of_the_book_is_shown_by_an_exercise_or_a_question() {
        let listed = listed().unwrap();
        assert_eq!(listed.matches("- **[").count(), chapters().unwrap().len());
    }

    #[test]
    fn a_goal_that_nothing_shows_is_an_offence() {
        let of = |text: &str| {
            let goals: Goals = toml::from_str(text).unwrap();
            faults(&goals, &["a".to_owned()], &[("a".to_owned(), "a_1"), ("b".to_owned(), "b_1")], &|_| 2)
        };
        let good = "[[a]]\ngoal='See.'\nshown='a_1'\n[[a]]\ngoal='Say.'\nshown='question 2'\n";
        assert_eq!(of(good), [""; 0]);
        for (from, to, what) in [
            ("a_1", "b_1", "no `b_1`"),
            ("question 2", "question 3", "no `question 3`"),
            ("See.", "See 3.", "a number"),
            ("See.", "See", "full stop"),
            ("[[a]]\ngoal='See.'\nshown='a_1'\n", "", "1 goals"),
            ("[[a]]", "[[c]]", "no chapter"),
        ] {
            let faults = of(&good.replace(from, to));
            assert!(faults.iter().any(|fault| fault.contains(what)), "{to}: {faults:?}");
        }
    }
}
