//! The book's chapters and the maths in them, for tests and examples.

use pulldown_cmark::{Event, Options, Parser};
use std::path::Path;
use tumbling_proofs::equations::Equation;

/// Each chapter by the name of its file, with its maths.
pub fn chapters() -> Vec<(String, Vec<Equation>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/chapters");
    let mut chapters = Vec::new();
    for entry in std::fs::read_dir(folder).expect("the book's chapters") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|ending| ending == "md") {
            let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
            chapters.push((name, equations(&std::fs::read_to_string(&path).expect("a chapter"))));
        }
    }
    chapters.sort_by(|a, b| a.0.cmp(&b.0));
    chapters
}

/// The maths in a text.
pub fn equations(text: &str) -> Vec<Equation> {
    let options = Options::ENABLE_MATH | Options::ENABLE_TABLES;
    let maths = Parser::new_ext(text, options).into_offset_iter().filter_map(|(event, range)| match event {
        Event::InlineMath(tex) => Some((tex, false, range)),
        Event::DisplayMath(tex) => Some((tex, true, range)),
        _ => None,
    });
    let line = |at: usize| text[..at].matches('\n').count() + 1;
    maths
        .map(|(tex, display, range)| Equation { line: line(range.start), tex: tex.into_string(), display })
        .collect()
}
