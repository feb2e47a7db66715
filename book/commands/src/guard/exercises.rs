//! The exercises, to be guarded like chapters: each is one section, whose numbers are held by its code and
//! its solution.

/// The text, each line in its place: headings of hints and solution left blank, so that all is one section,
/// and the wrong answers left blank, which hold nothing.
pub(super) fn as_chapter(text: &str) -> String {
    let mut wrong = false;
    text.split_inclusive('\n')
        .map(|line| {
            wrong |= line.starts_with("## Wrong: ");
            if wrong || line.starts_with("## ") { blank(line) } else { line.to_owned() }
        })
        .collect()
}

/// As many bytes, and the same end.
fn blank(line: &str) -> String {
    line.bytes().map(|byte| if byte == b'\n' { '\n' } else { ' ' }).collect()
}

#[cfg(test)]
mod tests {
    use super::super::{Beside, Book, Reader, holding};
    use super::*;

    const WHOLE: &str = "# T\n\nA mass of 2 kg falls for 3 s.\n\n```rust\n// -- your turn --\n\
                         let mass = todo!(\"kg\");\n// -- until here --\nlet seconds = 3.0; // 3 s\n```\n\n\
                         ## Hint\n\nThink of 2 kg.\n\n## Solution\n\nIt is 2 kg.\n\n```rust\nlet mass = 2.0; // 2 kg\n```\n\n\
                         ## Wrong: twice as much, ö\n\n```rust\nlet mass = 4.0; // 4 kg\n```\n";

    fn offences(text: &str) -> Vec<String> {
        let chapter = Reader::default().chapter("t_1", "whole/t_1.md", &as_chapter(text)).unwrap();
        holding::findings(&chapter, &Beside::default()).offences.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn what_is_blanked_keeps_every_line_and_every_byte_in_its_place() {
        let seen = as_chapter(WHOLE);
        assert_eq!(seen.len(), WHOLE.len());
        let ends = |text: &str| text.match_indices('\n').map(|(at, _)| at).collect::<Vec<_>>();
        assert_eq!(ends(&seen), ends(WHOLE));
        assert!(!seen.contains("## ") && !seen.contains("4.0"));
        let (kept, _) = WHOLE.split_once("## Hint").unwrap();
        assert!(seen.starts_with(kept), "the task is as it stands");
    }

    #[test]
    fn numbers_of_task_and_hints_are_held_by_the_code_and_by_the_solution() {
        assert_eq!(offences(WHOLE), [""; 0]);
    }

    #[test]
    fn a_number_that_only_a_wrong_answer_has_is_held_by_nothing() {
        let all = offences(&WHOLE.replace("A mass of 2 kg", "A mass of 4 kg"));
        // With the line of the file itself.
        assert!(all.len() == 1 && all[0].starts_with("whole/t_1.md:3: found `4 kg`"), "{all:?}");
        let all = offences(&WHOLE.replace("Think of 2 kg", "Think of 5 kg"));
        assert!(all.len() == 1 && all[0].starts_with("whole/t_1.md:14: found `5 kg`"), "{all:?}");
    }

    #[test]
    fn every_exercise_is_read_under_the_name_of_its_own_file() {
        let mut chapters = Book::read().unwrap().chapters;
        chapters.retain(|chapter| chapter.path.starts_with("book/exercises/"));
        let names: Vec<&str> = chapters.iter().map(|chapter| chapter.name.as_str()).collect();
        let all = tumbling_exercises::all().unwrap();
        assert_eq!(names, all.iter().map(|exercise| exercise.name.as_str()).collect::<Vec<_>>());
        for chapter in &chapters {
            assert_eq!(chapter.path, format!("book/exercises/whole/{}.md", chapter.name));
            assert_eq!(chapter.sections.len(), 1, "{}: all of it is one section", chapter.name);
        }
    }
}
