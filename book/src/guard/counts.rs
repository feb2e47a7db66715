//! How many numbers a chapter has.

use super::certainty::Certainty;
use std::collections::HashMap;

/// How many numbers there are, by where they stand and by what holds them.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Counts {
    /// All numbers and quantities in words that must be held.
    pub(crate) all: usize,
    /// By what they rest on.
    pub(crate) certainty: HashMap<Certainty, usize>,
    pub(crate) by_assertion: usize,
    /// By the note of a literal.
    pub(crate) by_note: usize,
    pub(crate) by_fact: usize,
    pub(crate) by_drawing: usize,
    /// Ordinals before headings, held by their order.
    pub(crate) ordinals: usize,
    /// Words that count, not held.
    pub(crate) counting: usize,
    /// Indices, exponents and factors inside formulas, not held here.
    pub(crate) structural: usize,
}

impl Counts {
    pub(crate) fn add(&mut self, other: &Self) {
        for (certainty, count) in &other.certainty {
            *self.certainty.entry(*certainty).or_default() += count;
        }
        for (mine, others) in [
            (&mut self.all, other.all),
            (&mut self.by_assertion, other.by_assertion),
            (&mut self.by_note, other.by_note),
            (&mut self.by_fact, other.by_fact),
            (&mut self.by_drawing, other.by_drawing),
            (&mut self.ordinals, other.ordinals),
            (&mut self.counting, other.counting),
            (&mut self.structural, other.structural),
        ] {
            *mine += others;
        }
    }

    /// How many rest on each, the most certain first.
    pub(crate) fn by_certainty(&self) -> String {
        let count = |c: Certainty| format!("{c} {}", self.certainty.get(&c).copied().unwrap_or(0));
        Certainty::ALL.map(count).join(", ")
    }
}
