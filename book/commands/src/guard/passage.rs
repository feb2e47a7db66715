//! Running text, in the form that phrases are compared with.

use std::ops::Range;

/// The kind of place of a passage.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub(crate) enum Kind {
    /// Its level, from one.
    Heading(u8),
    #[default]
    Prose,
    /// A paragraph in italics after a figure.
    Caption,
    /// A row of a table, as `| a | b |`.
    Row,
    /// The alternative text of a figure.
    Alt,
    /// A comment in Rust.
    Comment,
    /// A comment behind code, on its line.
    Note,
}

/// Running text in the form that phrases are compared with: a minus is `-`, code is a single `\u{fffc}`, TeX
/// has no dollar signs and no thin spaces, and a power of ten is `3e-13`.
#[derive(Debug, Default)]
pub(crate) struct Passage {
    pub(crate) kind: Kind,
    pub(crate) text: String,
    pub(crate) tex: Vec<Tex>,
    /// The name of the drawing that it belongs to.
    pub(crate) figure: Option<String>,
    /// For a note, the values of the literals on its line.
    pub(crate) values: Vec<f64>,
    /// The start of each stretch of the text, here and in the chapter.
    places: Vec<(usize, usize)>,
}

/// A formula in a passage.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Tex {
    /// Its bytes in the passage's text.
    pub(crate) at: Range<usize>,
    pub(crate) written: String,
    /// Whether it is displayed, between double dollars.
    pub(crate) display: bool,
}

impl Passage {
    pub(crate) fn new(kind: Kind) -> Self {
        Self { kind, ..Self::default() }
    }

    pub(crate) fn push(&mut self, text: &str, source: usize) {
        for (at, piece) in text.split_inclusive('\u{2212}').scan(0, |end, piece| {
            *end += piece.len();
            Some((*end - piece.len(), piece))
        }) {
            self.places.push((self.text.len(), source + at));
            match piece.strip_suffix('\u{2212}') {
                Some(before) => {
                    self.text.push_str(before);
                    self.places.push((self.text.len(), source + at + before.len()));
                    self.text.push('-');
                }
                None => self.text.push_str(piece),
            }
        }
    }

    pub(crate) fn push_tex(&mut self, tex: &str, source: usize) {
        let mut at = 0;
        while let Some(next) = tex[at..].find(['\\', '1']).map(|n| at + n) {
            let (head, rest) = (&tex[at..next], &tex[next..]);
            let times = rest.starts_with('\\');
            let number = head.trim_end().ends_with(|c: char| c.is_ascii_digit());
            let power = power_of_ten(rest).filter(|_| times == number);
            let (before, taken) = match (power, rest.get(..2)) {
                (Some((power, length)), _) => {
                    self.push(if times { head.trim_end() } else { head }, source + at);
                    self.push(if times { "e" } else { "1e" }, source + next);
                    self.push(power, source + next + rest[..length].rfind(power).unwrap_or(0));
                    ("", length)
                }
                (None, Some("\\," | "\\;")) => (head, 2),
                _ => {
                    self.push(&tex[at..=next], source + at);
                    at = next + 1;
                    continue;
                }
            };
            self.push(before, source + at);
            at = next + taken;
        }
        self.push(&tex[at..], source + at);
    }

    /// The byte of the chapter that this byte of the text came from.
    pub(crate) fn source(&self, at: usize) -> usize {
        let after = self.places.partition_point(|(here, _)| *here <= at);
        let place = self.places[..after].last();
        place.map_or(0, |(here, source)| source + (at - here))
    }
}

/// The power in `10^{-12}` or `\times 10^{-13}`, where the text begins with that, and its length.
fn power_of_ten(text: &str) -> Option<(&str, usize)> {
    let ten = text.strip_prefix("\\times").unwrap_or(text).trim_start();
    let (power, rest) = ten.strip_prefix("10^{")?.split_once('}')?;
    power.parse::<i32>().ok().map(|_| (power, text.len() - rest.len()))
}
