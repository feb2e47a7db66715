//! Quantities spelled out: `a twentieth`, `twice`, `ten radians a second`, `one to four`.
//!
//! A word states a quantity when it is a fraction finer than a third (`a twentieth`, `three tenths`), a
//! multiple (`twice`, `tenfold`, `ten times smaller`), a ratio (`one to four`), or has a unit after it (`two
//! turns a second`). All others count or order what the reader has before him (`three axes`, `the third
//! line`, `half a turn`), and stand in `words.toml`.

use std::ops::Range;

/// A quantity in words.
#[derive(Debug, Clone)]
pub(crate) struct Spelled {
    /// Its bytes, with the unit.
    pub(crate) at: Range<usize>,
    value: f64,
    /// Whether it is a fraction, which may be written as what it is or as a division.
    part: bool,
}

impl Spelled {
    /// Whether it is this number in words.
    pub(crate) fn says(&self, number: f64) -> bool {
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs();
        same(self.value, number) || (self.part && same(self.value * number, 1.0))
    }
}

/// What makes a quantity of the number word before it.
const UNITS: &str = "radians a second,radian a second,turns a second,turn a second,radians,radian,\
    per second,per cent,percent,degrees,seconds,second,\
    minutes,joules,metres,kilograms,kilogram,hours";

/// The length of the unit, with the blank before it, that the text begins with.
fn unit(text: &str) -> Option<usize> {
    let text = text.strip_prefix(' ')?;
    let whole = |unit: &&str| {
        text.strip_prefix(*unit).is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric()))
    };
    UNITS.split(',').find(whole).map(|unit| 1 + unit.len())
}

const CARDINALS: &str = "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen \
    sixteen seventeen eighteen nineteen twenty";
const TENS: &str = "twenty thirty forty fifty sixty seventy eighty ninety";
const POWERS: [(&str, f64); 4] = [("hundred", 1e2), ("thousand", 1e3), ("million", 1e6), ("billion", 1e9)];
/// Fractions by the number that they are one part of.
const PARTS: [(&str, f64); 9] = [
    ("fifth", 5.0),
    ("tenth", 10.0),
    ("twentieth", 20.0),
    ("fiftieth", 50.0),
    ("hundredth", 100.0),
    ("thousandth", 1e3),
    ("millionth", 1e6),
    ("billionth", 1e9),
    ("twenty-fifth", 25.0),
];
const MULTIPLES: [(&str, f64); 5] =
    [("twice", 2.0), ("thrice", 3.0), ("tenfold", 10.0), ("hundredfold", 100.0), ("twofold", 2.0)];

fn cardinal(word: &str) -> Option<f64> {
    let small =
        |word: &str| CARDINALS.split(' ').zip(0_u8..).find(|(c, _)| *c == word).map(|(_, n)| f64::from(n));
    let tens =
        |word: &str| TENS.split(' ').zip(2_u8..).find(|(t, _)| *t == word).map(|(_, n)| f64::from(n * 10));
    let both = || word.split_once('-').and_then(|(ten, one)| Some(tens(ten)? + small(one)?));
    let power = || POWERS.iter().find(|(name, _)| *name == word).map(|&(_, p)| p);
    small(word).or_else(|| tens(word)).or_else(both).or_else(power)
}

fn part(word: &str) -> Option<f64> {
    let single = word.strip_suffix('s').unwrap_or(word);
    PARTS.iter().find(|(name, ..)| *name == single).map(|&(_, n)| 1.0 / n)
}

/// Words that count or order, besides the cardinals.
const COUNTING: &str = "first second third thirds fourth fifth sixth seventh eighth ninth tenth sixteenth half halves \
    quarter quarters once ones double doubled triple dozen hundreds thousands millions";

/// Whether a word, or a part of it between hyphens, counts or orders.
fn counts(word: &str) -> bool {
    let known = |word: &str| {
        cardinal(word).is_some() || part(word).is_some() || COUNTING.split(' ').any(|known| known == word)
    };
    known(word) || word.split('-').any(known)
}

/// The quantities in this text, and the words that only count or order.
pub(crate) fn spelled(text: &str) -> (Vec<Spelled>, Vec<Range<usize>>) {
    let words = words(text);
    let word = |i: usize| words.get(i).map_or("", |(w, _)| w.as_str());
    let mut found = Vec::new();
    let mut counting = Vec::new();
    let mut i = 0;
    while i < words.len() {
        let start = words[i].1.start;
        let mut take = |last: usize, value: f64, part: bool| {
            let end = words[last].1.end;
            found.push(Spelled { at: start..end + unit(&text[end..]).unwrap_or(0), value, part });
            last + 1
        };
        let multiple = MULTIPLES.iter().find(|(name, _)| *name == word(i));
        if let Some(&(_, n)) = multiple {
            i = take(i, n, false);
            continue;
        }
        if let Some(value) = part(word(i)) {
            i = take(i, value, true);
            continue;
        }
        let article = matches!(word(i), "a" | "an") && POWERS.iter().any(|(name, _)| *name == word(i + 1));
        let first = i + usize::from(article);
        let Some(mut value) = cardinal(word(first)) else {
            // `a second`, `per second` and `1 second` are a unit.
            let unit = word(i) == "second" && i > 0 && matches!(word(i - 1), "a" | "each" | "every" | "per");
            if counts(word(i)) && !unit {
                counting.push(words[i].1.clone());
            }
            i += 1;
            continue;
        };
        let mut last = first;
        while let Some(power) = POWERS.iter().find(|(name, _)| *name == word(last + 1)).map(|p| p.1) {
            value *= power;
            last += 1;
        }
        let next = word(last + 1);
        let of_parts = part(next).map(|p| value * p);
        let compares =
            matches!(word(last + 2), "as" | "smaller" | "larger" | "less" | "more" | "that" | "the" | "its");
        let ratio = cardinal(word(last + 2)).filter(|_| next == "to").map(|to| to / value);
        i = if let Some(parts) = of_parts {
            take(last + 1, parts, true)
        } else if next == "times" && compares {
            take(last + 1, value, false)
        } else if let Some(ratio) = ratio {
            take(last + 2, ratio, false)
        } else if unit(&text[words[last].1.end..]).is_some() {
            take(last, value, false)
        } else {
            counting.push(words[first].1.start..words[last].1.end);
            last + 1
        };
    }
    (found, counting)
}

/// A counting word with the word behind it, in lower case: what it counts.
pub(crate) fn counted(text: &str, at: &Range<usize>) -> String {
    let rest = &text[at.end..];
    let behind = rest.strip_prefix(' ').unwrap_or_default();
    let length = behind.find(|c: char| !c.is_alphabetic() && c != '-').unwrap_or(behind.len());
    let end = at.end + if length > 0 { 1 + length } else { 0 };
    text[at.start..end].to_lowercase()
}

/// The words of the text in lower case, and where.
fn words(text: &str) -> Vec<(String, Range<usize>)> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..].find(|c: char| c.is_ascii_alphabetic()).map(|n| at + n) {
        let rest = &text[start..];
        let end = start + rest.find(|c: char| !c.is_ascii_alphabetic() && c != '-').unwrap_or(rest.len());
        found.push((text[start..end].to_lowercase(), start..end));
        at = end;
    }
    found
}
