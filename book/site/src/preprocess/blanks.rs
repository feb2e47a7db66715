//! No line ends inside `0.6 N m` or `198 × 20 mm`: the blanks there become no-break spaces, for pages and
//! paper alike. And a citation stands in square brackets there.

use super::edits::Edits;
use super::{Piece, Source};
use crate::language::UNITS;
use pulldown_cmark::{Event, Tag, TagEnd};

/// The characters that may follow a unit.
const MARKS: [char; 6] = ['.', ',', ';', ':', ')', '?'];

/// Replaces these blanks in a chapter, and brackets its citations; code and descriptions of images stay.
pub(super) fn replace(source: &Source<'_>, pieces: &[Piece<'_>], edits: &mut Edits) {
    let mut raw = false;
    for (event, range) in pieces {
        match event {
            Event::Start(Tag::CodeBlock(_) | Tag::Image { .. }) => raw = true,
            Event::End(TagEnd::CodeBlock | TagEnd::Image) => raw = false,
            Event::Start(Tag::Link { dest_url, .. }) if dest_url.starts_with("references.md#") => {
                edits.replace(range.start..range.start, "\\[".into());
                edits.replace(range.end..range.end, "\\]".into());
            }
            Event::Text(_) if !raw => {
                // A formula keeps the unit after it on its line.
                let after = source.text[..range.start].ends_with('$');
                let start = range.start + if after { unit_behind(&source.text[range.clone()]) } else { 0 };
                for at in inside(&source.text[start..range.end]).map(|at| start + at) {
                    edits.replace(at..at + 1, "\u{a0}".into());
                }
            }
            _ => {}
        }
    }
}

/// The text with these blanks replaced.
pub(crate) fn kept(text: &str) -> String {
    let mut edits = Edits::default();
    inside(text).for_each(|at| edits.replace(at..at + 1, "\u{a0}".into()));
    edits.applied_to(text)
}

/// Whether it is a unit, apart from marks behind it.
fn unit(word: &str) -> bool {
    let word = word.trim_end_matches(MARKS);
    word.split('/').all(|part| UNITS.contains(&part.trim_end_matches(['²', '³'])))
}

/// The bytes of the unit behind a value that ends before this text: ` kg m²/s`.
pub(super) fn unit_behind(text: &str) -> usize {
    let mut ended = false;
    let words = text.strip_prefix(' ').unwrap_or_default().split(' ');
    let words = words.take_while(|word| !std::mem::replace(&mut ended, word.ends_with(MARKS)) && unit(word));
    let taken: usize = words.map(|word| 1 + word.len()).sum();
    text[..taken].trim_end_matches(MARKS).len()
}

/// Where the blanks between a number and its unit, the parts of a unit, and the factors of a product are.
fn inside(text: &str) -> impl Iterator<Item = usize> {
    let number = |word: &str| word.trim_start_matches(['(', '−', '-']).starts_with(char::is_numeric);
    text.match_indices(' ').map(|(at, _)| at).filter(move |&at| {
        let before = text[..at].rsplit(' ').next().unwrap_or_default();
        let after = text[at + 1..].split(' ').next().unwrap_or_default();
        unit(after) && (number(before) || unit(before)) && !before.ends_with([',', '.', ';', ':'])
            || before == "×" && number(after)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_keeps_its_unit_and_a_product_its_factors() {
        for (text, shown) in [
            ("A torque of 0.6 N m, for 2 s.", "A torque of 0.6~N~m, for 2~s."),
            ("a book of 129 × 198 × 20 mm and 0.340 kg", "a book of 129~×~198~×~20~mm and 0.340~kg"),
            ("(4.71 rad/s) or 1.5 kg m² in 2 turns", "(4.71~rad/s) or 1.5~kg~m² in 2 turns"),
            ("In chapter 3, m is a mass; 24, 12 and 7 cm.", "In chapter 3, m is a mass; 24, 12 and 7~cm."),
        ] {
            assert_eq!(kept(text).replace('\u{a0}', "~"), shown);
        }
    }
}
