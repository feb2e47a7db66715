//! Replacing ranges of a text.

use std::ops::Range;

/// Replacements to be made, none overlapping another.
#[derive(Debug, Default)]
pub(super) struct Edits(Vec<(Range<usize>, String)>);

impl Edits {
    /// Puts `new` in place of these bytes.
    pub(super) fn replace(&mut self, range: Range<usize>, new: String) {
        self.0.push((range, new));
    }

    /// The text after all replacements.
    pub(super) fn applied_to(mut self, text: &str) -> String {
        self.0.sort_by_key(|(range, _)| range.start);
        let mut out = String::with_capacity(text.len());
        let mut at = 0;
        for (range, new) in self.0 {
            assert!(range.start >= at, "replacements overlap at byte {}", range.start);
            out.push_str(&text[at..range.start]);
            out.push_str(&new);
            at = range.end;
        }
        out.push_str(&text[at..]);
        out
    }
}
