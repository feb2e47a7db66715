//! How many numbers a chapter has.

use std::collections::HashMap;

/// How many numbers there are, by where they stand and by what holds them.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Counts {
    /// By the kind of place.
    pub(crate) places: HashMap<&'static str, usize>,
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
        for (place, count) in &other.places {
            *self.places.entry(place).or_default() += count;
        }
        for (mine, others) in [
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

    /// All numbers and quantities in words that must be held.
    pub(crate) fn all(&self) -> usize {
        self.places.values().sum()
    }
}
