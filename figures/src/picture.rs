//! A finished drawing, and helpers that all figures share: the colour of an axis, powers of ten.

use crate::draw::Canvas;
use crate::ink::Ink;
use tumbling::Axis;

/// A finished drawing and its description, for readers who cannot see it.
pub(crate) struct Picture {
    pub(crate) canvas: Canvas,
    pub(crate) description: String,
}

pub(crate) type Drawing = Result<Picture, Box<dyn std::error::Error>>;

impl Canvas {
    /// This sheet as a picture, and what it shows in words.
    pub(crate) fn described(self, description: impl Into<String>) -> Drawing {
        Ok(Picture { canvas: self, description: description.into() })
    }
}

/// The ink of a principal axis.
pub(crate) fn ink_of(axis: Axis) -> Ink {
    match axis {
        Axis::Smallest => Ink::AxisMin,
        Axis::Middle => Ink::AxisMid,
        Axis::Largest => Ink::AxisMax,
    }
}

/// A power of ten as an axis shows it.
pub(crate) fn power_of_ten(exponent: i32) -> String {
    match exponent {
        0 => "1".into(),
        1 => "10".into(),
        n => format!("$10^{{{}}}$", n.to_string().replace('-', "−")),
    }
}

/// A power of ten in letters that are as large as the others.
pub(crate) fn raised(exponent: i32) -> String {
    let digits = exponent.unsigned_abs().to_string();
    let high = digits.chars().filter_map(|c| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(c.to_digit(10)? as usize));
    match exponent {
        0 | 1 => power_of_ten(exponent),
        n => format!("10{}{}", if n < 0 { "⁻" } else { "" }, high.collect::<String>()),
    }
}

/// The text with its numbers as readers write them: `3 × 10⁻⁴` for `3e-4`.
pub(crate) fn with_powers(text: &str) -> String {
    let word = |word: &str| -> Option<String> {
        let (number, rest) = word.split_once('e')?;
        let end = rest.find(|c: char| !(c.is_ascii_digit() || c == '-')).unwrap_or(rest.len());
        let start = number.rfind(|c: char| !(c.is_ascii_digit() || c == '.')).map_or(0, |at| at + 1);
        let (before, factor) = number.split_at(start);
        let power = raised(rest[..end].parse().ok()?);
        factor.parse::<f64>().ok()?;
        let factor = if factor == "1" { String::new() } else { format!("{factor} × ") };
        Some(format!("{before}{factor}{power}{}", &rest[end..]))
    };
    let words = text.split(' ').map(|one| word(one).unwrap_or_else(|| one.to_owned()));
    words.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_with_powers_and_words_stay() {
        let said = "a push of 3e-4, the least (1e-16), 2.5e12; the end of 10 and Moser-Veselov 8e";
        let written = "a push of 3 × 10⁻⁴, the least (10⁻¹⁶), 2.5 × 10¹²; the end of 10 and Moser-Veselov 8e";
        assert_eq!(with_powers(said), written);
    }
}
