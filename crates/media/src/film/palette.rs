//! The few colours of a film.

use crate::picture::{Picture, Rgb};
use std::collections::HashMap;

/// At most 255 colours, and the number that stands for "as before".
#[derive(Debug, Clone)]
pub struct Palette {
    colours: Vec<Rgb>,
    /// What was looked up already.
    known: HashMap<Rgb, u8>,
}

/// The number of the transparent colour, the first.
pub(super) const AS_BEFORE: u8 = 0;

impl Palette {
    /// These colours, then the most frequent colours of the pictures, `most` in total (at most 255). Along
    /// edges there are many mixed colours, each of them rare: they are replaced by the nearest colour.
    #[must_use]
    pub fn new(first: &[Rgb], samples: &[Picture], most: usize) -> Self {
        let mut counts: HashMap<Rgb, usize> = HashMap::new();
        for run in samples.iter().flat_map(|picture| picture.pixels.chunk_by(PartialEq::eq)) {
            *counts.entry(run[0]).or_default() += run.len();
        }
        let mut common: Vec<_> = counts.into_iter().collect();
        common.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(&b.0)));
        let mut colours: Vec<Rgb> = Vec::new();
        for colour in first.iter().copied().chain(common.into_iter().map(|(colour, _)| colour)) {
            // Skip a colour that cannot be distinguished from another.
            if colours.len() < most.min(255) && colours.iter().all(|&other| distance(other, colour) > 100) {
                colours.push(colour);
            }
        }
        Self { colours, known: HashMap::new() }
    }

    /// The number of the nearest colour.
    pub(super) fn nearest(&mut self, colour: Rgb) -> u8 {
        let colours = &self.colours;
        *self.known.entry(colour).or_insert_with(|| {
            let nearest = (0_u8..).zip(colours).min_by_key(|(_, other)| distance(**other, colour));
            nearest.map_or(AS_BEFORE, |(number, _)| number.saturating_add(1))
        })
    }

    /// All of them, the transparent one first.
    pub(super) fn bytes(&self) -> Vec<u8> {
        [[0; 3]].iter().chain(&self.colours).flatten().copied().collect()
    }
}

/// The square of the distance, weighted as the eye does: green most, blue least.
fn distance(a: Rgb, b: Rgb) -> i32 {
    let [r, g, b] = [0, 1, 2].map(|i| i32::from(a[i]) - i32::from(b[i]));
    3 * r * r + 6 * g * g + b * b
}
