//! Letters: running text upright, symbols between dollar signs in italics, with sub- and superscripts.

use super::point::P;
use crate::ink::Ink;
use std::fmt::Write as _;

/// A piece of writing at a point.
///
/// Between `$` signs letters are italic, `_x` and `^x` (or `_{xy}`) are set low and high, and `!` makes the
/// next letter bold, as vectors are.
#[derive(Debug, Clone)]
pub(crate) struct Label {
    text: String,
    size: f64,
    ink: Ink,
    anchor: &'static str,
    bold: bool,
    halo: Option<Ink>,
}

/// The size of ordinary letters, in points of a figure 680 wide; at half that width they still have eight and
/// a half.
pub(crate) const SIZE: f64 = 17.0;

impl Label {
    pub(crate) fn new(text: impl Into<String>) -> Self {
        Self { text: text.into(), size: SIZE, ink: Ink::Text, anchor: "start", bold: false, halo: None }
    }

    pub(crate) fn size(self, size: f64) -> Self {
        Self { size, ..self }
    }

    pub(crate) fn ink(self, ink: Ink) -> Self {
        Self { ink, ..self }
    }

    /// The point is the middle of the writing.
    pub(crate) fn middle(self) -> Self {
        Self { anchor: "middle", ..self }
    }

    /// The point is the end of the writing.
    pub(crate) fn end(self) -> Self {
        Self { anchor: "end", ..self }
    }

    pub(crate) fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    /// Draws an outline in the background colour around the letters, so that lines do not touch them.
    pub(crate) fn halo(self, ink: Ink) -> Self {
        Self { halo: Some(ink), ..self }
    }

    /// The SVG element, with the baseline at the point.
    pub(super) fn svg(&self, at: P, fineness: f64) -> String {
        let [x, y] = [at.0, at.1].map(|x| (x * fineness).round());
        let mut tag = format!("<text x=\"{x}\" y=\"{y}\"");
        if self.size != SIZE {
            let _ = write!(tag, " font-size=\"{:.0}\"", self.size * fineness);
        }
        if self.anchor != "start" {
            let _ = write!(tag, " text-anchor=\"{}\"", self.anchor);
        }
        if self.bold {
            tag.push_str(" font-weight=\"600\"");
        }
        let mut style = Vec::new();
        if self.ink != Ink::Text {
            style.push(format!("fill:{}", self.ink.css()));
        }
        if let Some(ink) = self.halo {
            let width = 0.3 * self.size * fineness;
            style.push(format!("paint-order:stroke;stroke:{};stroke-width:{width:.0}", ink.css()));
        }
        if !style.is_empty() {
            let _ = write!(tag, " style=\"{}\"", style.join(";"));
        }
        format!("{tag}>{}</text>\n", spans(&self.text, self.size * fineness))
    }
}

const SYMBOLS: &str = "font-style=\"italic\" style=\"font-family:var(--fig-symbols,Georgia,serif)\"";

/// The text with its symbols marked up.
fn spans(text: &str, size: f64) -> String {
    let mut out = String::new();
    for (at, piece) in text.split('$').enumerate() {
        if at % 2 == 0 { out.push_str(&escaped(piece)) } else { symbols(piece, size, &mut out) }
    }
    out
}

/// Letters of a symbol that stand on one line.
struct Run {
    text: String,
    /// How far below the line they stand, in parts of the size.
    level: f64,
    bold: bool,
}

/// The runs of a symbol.
fn runs(text: &str) -> Vec<Run> {
    let mut rest = text.chars().peekable();
    let mut found = Vec::new();
    while let Some(c) = rest.next() {
        let (level, bold, text) = match c {
            '_' | '^' => {
                let mut run = String::new();
                match rest.next() {
                    Some('{') => run.extend(rest.by_ref().take_while(|&c| c != '}')),
                    Some(c) => run.push(c),
                    None => {}
                }
                (if c == '_' { 0.24 } else { -0.36 }, false, run)
            }
            '!' => (0.0, true, rest.next().into_iter().collect()),
            c => {
                let mut run = String::from(c);
                while let Some(c) = rest.next_if(|c| {
                    !matches!(c, '_' | '^' | '!') && c.is_alphabetic() == run.chars().all(char::is_alphabetic)
                }) {
                    run.push(c);
                }
                (0.0, false, run)
            }
        };
        found.push(Run { text, level, bold });
    }
    found
}

fn symbols(text: &str, size: f64, out: &mut String) {
    // The current shift below the line, which the next span must undo.
    let mut low = 0.0;
    for Run { text: run, level, bold } in runs(text) {
        let shift = (level - low) * size;
        low = level;
        let mut tag = String::new();
        if shift != 0.0 {
            let _ = write!(tag, " dy=\"{shift:.0}\"");
        }
        if level != 0.0 {
            let _ = write!(tag, " font-size=\"{:.0}\"", LOW_OR_HIGH * size);
        }
        if bold {
            tag.push_str(" font-weight=\"bold\"");
        }
        if run.chars().any(char::is_alphabetic) {
            tag.push(' ');
            tag.push_str(SYMBOLS);
        }
        if tag.is_empty() {
            out.push_str(&escaped(&run));
        } else {
            let _ = write!(out, "<tspan{tag}>{}</tspan>", escaped(&run));
        }
    }
    if low != 0.0 {
        // A zero-width space carries the baseline back.
        let _ = write!(out, "<tspan dy=\"{:.0}\">\u{200b}</tspan>", -low * size);
    }
}

/// The size of low and high letters, in parts of the others'.
const LOW_OR_HIGH: f64 = 0.74;

/// The width of a letter relative to its size: that of DejaVu Sans, the widest fallback font of common
/// systems.
fn advance(c: char) -> f64 {
    match c {
        '\u{200b}' => 0.0,
        'i' | 'j' | 'l' | 'I' | 'J' => 0.29,
        'f' | 't' | ' ' | '.' | ',' | '’' | ':' | ';' | '/' | '(' | ')' | '-' | '|' => 0.39,
        'r' | '²' | '³' | '¹' => 0.42,
        'm' | 'w' | 'M' | 'W' | '%' | '–' => 0.99,
        '+' | '=' | '×' | '−' | '<' | '>' => 0.84,
        'A'..='Z' | 'Λ' | 'Ω' | 'ω' => 0.79,
        _ => 0.64,
    }
}

impl Label {
    /// An upper bound on the width of its letters.
    pub(crate) fn width(&self) -> f64 {
        let [left, _, right, _] = self.bounds((0.0, 0.0));
        right - left
    }

    /// Upper bounds on left, top, right and bottom of its letters, with the baseline at the point.
    pub(super) fn bounds(&self, at: P) -> [f64; 4] {
        let (mut width, mut top, mut bottom) = (0.0, 0.74_f64, 0.21_f64);
        let wide = |text: &str| text.chars().map(advance).sum::<f64>();
        for (place, piece) in self.text.split('$').enumerate() {
            if place % 2 == 0 {
                width += wide(piece);
                continue;
            }
            for Run { text, level, .. } in runs(piece) {
                let size = if level == 0.0 { 1.0 } else { LOW_OR_HIGH };
                width += size * wide(&text);
                top = top.max(0.74 * size - level);
                bottom = bottom.max(0.21 * size + level);
            }
        }
        width *= self.size * if self.bold { 1.1 } else { 1.0 };
        let left = match self.anchor {
            "middle" => at.0 - 0.5 * width,
            "end" => at.0 - width,
            _ => at.0,
        };
        [left, at.1 - top * self.size, left + width, at.1 + bottom * self.size]
    }
}

pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_are_italic_and_subscripts_come_back_to_the_line() {
        let out = spans("spin $ω_1$ & more", 100.0);
        assert!(out.starts_with("spin <tspan font-style=\"italic\""), "{out}");
        assert!(out.contains("<tspan dy=\"24\" font-size=\"74\">1</tspan><tspan dy=\"-24\">"), "{out}");
        assert!(out.ends_with(" &amp; more"), "{out}");
    }
}
