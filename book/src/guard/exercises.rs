//! The exercises, to be guarded like chapters: each is one section, whose numbers are held by its code and its solution.

use super::chapter::{Chapter, Reader};
use crate::preprocess;
use std::fs;
use std::path::Path;

/// Reads all exercises; what is wrong with one as Markdown and TeX goes to `wrong`.
pub(super) fn read(
    reader: &mut Reader,
    chapters: &mut Vec<Chapter>,
    wrong: &mut Vec<String>,
) -> Result<(), String> {
    for exercise in tumbling_exercises::all()? {
        let name = &exercise.name;
        let path = tumbling_exercises::whole().join(format!("{name}.md"));
        let text = fs::read_to_string(&path).map_err(|e| format!("cannot read {}: {e}", path.display()))?;
        let shown = format!("book/exercises/whole/{name}.md");
        let faults = preprocess::unreadable(Path::new(name), &text);
        wrong.extend(faults.into_iter().map(|f| f.replacen(&format!("book/chapters/{name}"), &shown, 1)));
        match reader.chapter(name, &shown, &as_chapter(&text)) {
            Ok(chapter) => chapters.push(chapter),
            Err(fault) => wrong.push(fault),
        }
    }
    Ok(())
}

/// The text, each line in its place: headings of hints and solution left blank, so that all is one section, and the
/// wrong answers left blank, which hold nothing.
fn as_chapter(text: &str) -> String {
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
