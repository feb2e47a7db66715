//! Quantities spelled out: `a twentieth`, `twice`, `ten radians a second`, `one to four`.
//!
//! Words mostly count what the reader has before him (`three axes`, `both spins`, `a half turn`). Those are
//! counted and left alone. A word states a quantity when it is a fraction finer than a third (`a twentieth`,
//! `three tenths`), a multiple (`twice`, `tenfold`, `ten times smaller`), a ratio (`one to four`), or has a unit
//! after it (`two turns a second`).

use super::decimal::Decimal;
use super::token::unit_at;
use std::ops::Range;

/// A quantity in words.
#[derive(Debug, Clone)]
pub(crate) struct Spelled {
    pub(crate) at: Range<usize>,
    pub(crate) value: Decimal,
    pub(crate) unit: Option<&'static str>,
    /// Whether it is a fraction, which may be written as what it is or as a division.
    pub(crate) part: bool,
}

const CARDINALS: [&str; 21] = [
    "zero",
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
    "thirteen",
    "fourteen",
    "fifteen",
    "sixteen",
    "seventeen",
    "eighteen",
    "nineteen",
    "twenty",
];
const TENS: [&str; 7] = ["thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"];
const POWERS: [(&str, i32); 4] = [("hundred", 2), ("thousand", 3), ("million", 6), ("billion", 9)];
/// Fractions by the number they are one part of, as mantissa and power of ten.
const PARTS: [(&str, i128, i32); 9] = [
    ("fifth", 2, -1),
    ("tenth", 1, -1),
    ("twentieth", 5, -2),
    ("fiftieth", 2, -2),
    ("hundredth", 1, -2),
    ("thousandth", 1, -3),
    ("millionth", 1, -6),
    ("billionth", 1, -9),
    ("twenty-fifth", 4, -2),
];
const MULTIPLES: [(&str, i128); 5] =
    [("twice", 2), ("thrice", 3), ("tenfold", 10), ("hundredfold", 100), ("twofold", 2)];

fn cardinal(word: &str) -> Option<Decimal> {
    let small = CARDINALS.iter().position(|&c| c == word).and_then(|n| i128::try_from(n).ok());
    let power = || POWERS.iter().find(|(name, _)| *name == word).map(|&(_, p)| Decimal::new(1, p));
    let ten = |word: &str| TENS.iter().position(|&t| t == word).and_then(|n| i128::try_from(n + 3).ok());
    let tens = || match word.split_once('-') {
        Some((tens, ones)) => {
            let tens = if tens == "twenty" { Some(2) } else { ten(tens) };
            let ones =
                CARDINALS[1..10].iter().position(|&c| c == ones).and_then(|n| i128::try_from(n + 1).ok());
            Some(Decimal::new(tens? * 10 + ones?, 0))
        }
        None => Some(Decimal::new(ten(word)?, 1)),
    };
    small.map(|n| Decimal::new(n, 0)).or_else(tens).or_else(power)
}

fn part(word: &str) -> Option<Decimal> {
    let single = word.strip_suffix('s').unwrap_or(word);
    PARTS.iter().find(|(name, ..)| *name == single).map(|&(_, m, e)| Decimal::new(m, e))
}

/// The quantities in this text, and how many number words only count.
pub(crate) fn spelled(text: &str) -> (Vec<Spelled>, usize) {
    let words = words(text);
    let word = |i: usize| words.get(i).map_or("", |(w, _)| w.as_str());
    let mut found = Vec::new();
    let mut counting = 0;
    let mut i = 0;
    while i < words.len() {
        let start = words[i].1.start;
        let mut take = |last: usize, value: Decimal, part: bool| {
            let end = words[last].1.end;
            let unit = unit_at(text, end).map(|(unit, _)| unit).filter(|u| *u != "times");
            found.push(Spelled { at: start..end, value, unit, part });
            last + 1
        };
        let multiple = MULTIPLES.iter().find(|(name, _)| *name == word(i));
        if let Some(&(_, n)) = multiple {
            i = take(i, Decimal::new(n, 0), false);
            continue;
        }
        if let Some(value) = part(word(i)) {
            i = take(i, value, true);
            continue;
        }
        let article = matches!(word(i), "a" | "an") && POWERS.iter().any(|(name, _)| *name == word(i + 1));
        let first = i + usize::from(article);
        let Some(mut value) = cardinal(word(first)) else {
            i += 1;
            continue;
        };
        let mut last = first;
        while let Some(power) = POWERS.iter().find(|(name, _)| *name == word(last + 1)).map(|p| p.1) {
            let Some(product) = value.times(Decimal::new(1, power)) else { break };
            value = product;
            last += 1;
        }
        let next = word(last + 1);
        let of_parts = part(next).and_then(|p| value.times(p));
        let compares =
            matches!(word(last + 2), "as" | "smaller" | "larger" | "less" | "more" | "that" | "the" | "its");
        let ratio = cardinal(word(last + 2)).filter(|_| next == "to").map(|to| {
            // A ratio that is no whole number is nothing the code could say in one literal.
            to.whole_ratio(value).unwrap_or(Decimal::new(-1, 0))
        });
        i = if let Some(parts) = of_parts {
            take(last + 1, parts, true)
        } else if next == "times" && compares {
            take(last + 1, value, false)
        } else if let Some(ratio) = ratio {
            take(last + 2, ratio, false)
        } else if next != "times"
            // A single letter behind a number word is a symbol.
            && unit_at(text, words[last].1.end).is_some()
            && next.len() != 1
        {
            take(last, value, false)
        } else {
            counting += 1;
            last + 1
        };
    }
    (found, counting)
}

/// The phrase with one of its number words replaced by another of its kind, in every place.
pub(crate) fn altered(phrase: &str) -> Vec<String> {
    let cardinals = || CARDINALS[1..].iter().copied().chain(POWERS.iter().map(|p| p.0));
    let parts = || PARTS.iter().map(|p| p.0);
    let mut found = Vec::new();
    for (word, at) in words(phrase) {
        let plural = if word.ends_with('s') { "s" } else { "" };
        let others: Vec<String> = if cardinal(&word).is_some() {
            cardinals().filter(|c| *c != word).map(str::to_owned).collect()
        } else if part(&word).is_some() {
            parts().filter(|p| *p != word.trim_end_matches('s')).map(|p| format!("{p}{plural}")).collect()
        } else {
            let own = MULTIPLES.iter().find(|m| m.0 == word).map(|m| m.1);
            let others = MULTIPLES.iter().filter(|m| own.is_some_and(|own| own != m.1));
            others.map(|m| m.0.to_owned()).collect()
        };
        for other in others {
            found.push(format!("{}{other}{}", &phrase[..at.start], &phrase[at.end..]));
        }
    }
    found
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
