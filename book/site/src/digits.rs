//! Numbers as they are printed, in running text and in TeX.

use regex::Regex;
use std::ops::Range;
use std::sync::LazyLock;

/// A number, `-12.5e-3`; or a name, to which digits may belong: `Ash91`.
static IN_TEXT: LazyLock<Regex> = LazyLock::new(|| or_number(r"[\p{Alphabetic}_][\p{Alphabetic}\p{N}_]*"));

/// A number; or a command, an index or an exponent.
static IN_TEX: LazyLock<Regex> = LazyLock::new(|| or_number(r"\\[A-Za-z]*|[_^](?:\{[^}]*\}?|(?s:.))?"));

static UNIT: LazyLock<Regex> = LazyLock::new(|| Regex::new(r"^ ?[\p{Alphabetic}\p{N}°%/]+").unwrap());

/// Finds numbers, as its group, and what else may contain digits.
fn or_number(other: &str) -> Regex {
    Regex::new(&format!(r"(-?[0-9]+(?:\.[0-9]+)?(?:e-?[0-9]+)?)|{other}")).unwrap()
}

/// A number in a text.
#[derive(Debug, Clone, PartialEq)]
pub struct Numeral {
    /// Its bytes, sign and power included.
    pub at: Range<usize>,
    /// What it is worth.
    pub value: f64,
}

/// The numbers of a text, without those that are parts of formulas; the ranges are the TeX in it.
pub fn numerals(text: &str, tex: &[Range<usize>]) -> Vec<Numeral> {
    let (mut found, mut at) = (Vec::new(), 0);
    for formula in tex {
        found.extend(scan(text, at..formula.start, &IN_TEXT));
        let inside = scan(text, formula.clone(), &IN_TEX);
        found.extend(inside.filter(|numeral| is_value(text, formula, &numeral.at)));
        at = formula.end;
    }
    found.extend(scan(text, at..text.len(), &IN_TEXT));
    found
}

/// The numbers of a text without TeX.
pub fn plain(text: &str) -> Vec<Numeral> {
    numerals(text, &[])
}

/// Whether a number in a formula is a value, and not an index, a factor or an entry that belongs to the
/// formula. It is a value if it has a decimal point or a power of ten, is in a tuple of numbers or at the end
/// of `symbol = number`, or is the whole formula.
fn is_value(text: &str, formula: &Range<usize>, at: &Range<usize>) -> bool {
    let before = &text[formula.start..at.start];
    let after = &text[at.end..formula.end];
    let in_tuple = || {
        let open = before.rfind('(').map(|n| &before[n + 1..]);
        let close = after.find(')').map(|n| &after[..n]);
        let numbers = |text: &str| text.chars().all(|c| c.is_ascii_digit() || " ,.-".contains(c));
        open.zip(close).is_some_and(|(a, b)| numbers(a) && numbers(b) && (a.contains(',') || b.contains(',')))
    };
    let alone = || {
        let rest = text[formula.clone()].replace("\\times", "");
        rest.chars().all(|c| c.is_ascii_digit() || " -^{}".contains(c))
    };
    let last = || before.trim_end().ends_with('=') && after.trim().is_empty();
    text[at.clone()].contains(['.', 'e']) || alone() || in_tuple() || last()
}

fn scan<'a>(text: &'a str, within: Range<usize>, pattern: &'a Regex) -> impl Iterator<Item = Numeral> + 'a {
    pattern.captures_iter(&text[within.clone()]).filter_map(move |found| {
        let number = found.get(1)?;
        let (start, end) = (within.start + number.start(), within.start + number.end());
        // After a letter or a digit a minus is a hyphen: `T-13`.
        let hyphen = text[..start].ends_with(|c: char| c.is_alphanumeric() || matches!(c, ')' | '}'));
        let at = start + usize::from(hyphen && number.as_str().starts_with('-'))..end;
        // `1/s` and `1/(kg m²)` are units.
        let unit = text[end..within.end].strip_prefix('/').is_some_and(|tail| {
            &text[at.clone()] == "1" && tail.starts_with(|c: char| c.is_alphabetic() || c == '(')
        });
        let value = text[at.clone()].parse().ok().filter(|_| !unit)?;
        Some(Numeral { at, value })
    })
}

/// The number with the unit, or the word, that follows it: `7.4°`, `20 s`.
pub fn with_unit<'a>(text: &'a str, numeral: &Numeral) -> &'a str {
    let unit = UNIT.find(&text[numeral.at.end..]).map_or(0, |unit| unit.len());
    &text[numeral.at.start..numeral.at.end + unit]
}

/// The places where the text contains this phrase as a whole, not as part of a longer number, word or unit.
pub fn quotations<'a>(text: &'a str, phrase: &'a str) -> impl Iterator<Item = Range<usize>> + 'a {
    let found = text.match_indices(phrase).map(|(at, _)| at..at + phrase.len());
    found.filter(move |at| {
        !phrase.is_empty() && begins(&text[..at.start], phrase) && ends(phrase, &text[at.end..])
    })
}

fn begins(before: &str, phrase: &str) -> bool {
    let number = phrase.starts_with(|c: char| c.is_ascii_digit() || c == '-');
    !before.ends_with(|c: char| c.is_alphanumeric() || (number && "-./^_".contains(c)))
}

/// No word may follow a number: the counted thing and the unit belong to the phrase.
fn ends(phrase: &str, after: &str) -> bool {
    let mut next = after.chars();
    let (first, second) = (next.next().unwrap_or('.'), next.next().unwrap_or(' '));
    let bare = phrase.ends_with(|c: char| c.is_ascii_digit() || c == ')');
    let goes_on = match first {
        '/' | '^' | '_' | '·' => true,
        '-' | '%' | '°' => bare,
        '.' | ',' => bare && second.is_ascii_digit(),
        c if c.is_whitespace() && bare => second.is_alphabetic() || "%°×".contains(second),
        // `0.2 kg` is not in `0.2 kg m²`.
        c if c.is_whitespace() => {
            let unit = phrase.ends_with(|c: char| c.is_alphanumeric());
            unit && "msN".contains(second) && !next.next().is_some_and(char::is_alphabetic)
        }
        c => c.is_alphanumeric(),
    };
    !goes_on
}
