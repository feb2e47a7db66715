//! Finds mistakes that Markdown accepts, but that would confuse a reader or `cargo test`.

use super::{Piece, Source};
use pulldown_cmark::{CodeBlockKind, Event, Tag, TagEnd};

/// Finds a dollar sign that is neither maths nor escaped, and code of no language.
pub(super) fn faults(source: &Source<'_>, pieces: &[Piece<'_>]) -> Vec<String> {
    let mut faults = Vec::new();
    let mut in_code = false;
    for (event, range) in pieces {
        match event {
            Event::Start(Tag::CodeBlock(kind)) => {
                in_code = true;
                if words(kind).next().is_none() {
                    let what = "code of no language: rustdoc would test it as Rust; \
                                begin it with ```rust or ```text";
                    faults.push(source.fault(range.start, what));
                }
            }
            Event::End(TagEnd::CodeBlock) => in_code = false,
            Event::Text(_) if !in_code => {
                // An escaped dollar begins its own text, right after the backslash.
                let escaped = source.text[..range.start].ends_with('\\');
                let text = &source.text[range.clone()];
                if let Some(at) = text.bytes().skip(usize::from(escaped)).position(|b| b == b'$') {
                    let what = "a dollar sign that neither begins nor ends maths (inside it a blank \
                                line, a line that begins like a list, or braces that do not \
                                balance? a space just after it?); a plain one is written `\\$`";
                    faults.push(source.fault(range.start + usize::from(escaped) + at, what));
                }
            }
            _ => {}
        }
    }
    faults
}

/// The words behind the fence of a block of code, the language first.
pub fn words<'a>(kind: &'a CodeBlockKind<'a>) -> impl Iterator<Item = &'a str> {
    let info = match kind {
        CodeBlockKind::Indented => "",
        CodeBlockKind::Fenced(info) => info,
    };
    info.split([' ', '\t', ',']).filter(|word| !word.is_empty())
}
