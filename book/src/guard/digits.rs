//! Numbers as they are printed, in running text and in TeX.

use std::ops::Range;

/// A number in a text.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Numeral {
    /// Its bytes, sign and power included.
    pub(crate) at: Range<usize>,
    pub(crate) value: f64,
}

/// The numbers of a text, without those that are parts of formulas; the ranges are the TeX in it.
pub(crate) fn numerals(text: &str, tex: &[Range<usize>]) -> Vec<Numeral> {
    let (mut found, mut at) = (Vec::new(), 0);
    for formula in tex {
        scan(text, at..formula.start, false, &mut found);
        let mut inside = Vec::new();
        scan(text, formula.clone(), true, &mut inside);
        inside.retain(|numeral| is_value(text, formula, &numeral.at));
        found.append(&mut inside);
        at = formula.end;
    }
    scan(text, at..text.len(), false, &mut found);
    found
}

/// The numbers of a text without TeX.
pub(crate) fn plain(text: &str) -> Vec<Numeral> {
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

fn scan(text: &str, within: Range<usize>, tex: bool, found: &mut Vec<Numeral>) {
    let mut at = within.start;
    while let Some(c) = text[at..within.end].chars().next() {
        let rest = &text[at..within.end];
        if let Some(length) = number(&text[..at], rest) {
            // `1/s` and `1/(kg m²)` are units.
            let unit = rest[length..].strip_prefix('/').is_some_and(|tail| {
                &rest[..length] == "1" && tail.starts_with(|c: char| c.is_alphabetic() || c == '(')
            });
            if let (false, Ok(value)) = (unit, rest[..length].parse()) {
                found.push(Numeral { at: at..at + length, value });
            }
            at += length;
        } else {
            at += if tex { part_of_formula(rest) } else { name(rest) }.max(c.len_utf8());
        }
    }
}

/// The bytes of a name, to which digits may belong: `Ash91`.
fn name(text: &str) -> usize {
    if !text.starts_with(|c: char| c.is_alphabetic() || c == '_') {
        return 0;
    }
    text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len())
}

/// The bytes of a command, an index or an exponent.
fn part_of_formula(text: &str) -> usize {
    let end = |rest: &str| text.len() - rest.len();
    if let Some(command) = text.strip_prefix('\\') {
        return end(command.trim_start_matches(|c: char| c.is_ascii_alphabetic()));
    }
    match text.strip_prefix(['_', '^']).map(|raised| (raised, raised.strip_prefix('{'))) {
        Some((_, Some(group))) => group.find('}').map_or(text.len(), |close| end(&group[close + 1..])),
        Some((one, None)) => end(one.strip_prefix(|_| true).unwrap_or(one)),
        None => 0,
    }
}

/// The bytes of the number that `rest` begins with: `-12.5e-3`.
fn number(before: &str, rest: &str) -> Option<usize> {
    let digits = |text: &str| text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    // After a letter or a digit it is a hyphen: `T-13`.
    let hyphen = before.ends_with(|c: char| c.is_alphanumeric() || matches!(c, ')' | '}'));
    let sign = usize::from(rest.starts_with('-') && !hyphen);
    let mut end = sign + Some(digits(&rest[sign..])).filter(|&n| n > 0)?;
    if let Some(tail) = rest[end..].strip_prefix('.') {
        end += Some(digits(tail)).filter(|&n| n > 0).map_or(0, |n| n + 1);
    }
    if let Some(tail) = rest[end..].strip_prefix('e') {
        let sign = usize::from(tail.starts_with('-'));
        end += Some(digits(&tail[sign..])).filter(|&n| n > 0).map_or(0, |n| n + sign + 1);
    }
    Some(end)
}

/// The number with the unit, or the word, that follows it: `7.4°`, `20 s`.
pub(crate) fn with_unit<'a>(text: &'a str, numeral: &Numeral) -> &'a str {
    let tail = &text[numeral.at.end..];
    let word =
        |text: &str| text.find(|c: char| !c.is_alphanumeric() && !"°%/".contains(c)).unwrap_or(text.len());
    let length = match tail.strip_prefix(' ') {
        Some(next) if word(next) > 0 => 1 + word(next),
        _ => word(tail),
    };
    &text[numeral.at.start..numeral.at.end + length]
}

/// The places where the text contains this phrase as a whole, not as part of a longer number, word or unit.
pub(crate) fn quotations<'a>(text: &'a str, phrase: &'a str) -> impl Iterator<Item = Range<usize>> + 'a {
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
