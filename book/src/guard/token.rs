//! Numbers in running text and in TeX: what is one, what it is worth, which unit follows it.

use super::decimal::Decimal;
use std::ops::Range;

/// A number as printed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Number {
    /// Its characters, with `-` for every kind of minus and no space between groups of digits; a
    /// power of ten as `3e-13`.
    pub(crate) printed: String,
    pub(crate) value: Decimal,
    /// Whether it was written with a power of ten, and is compared by value alone.
    pub(crate) power: bool,
}

/// One number, or numbers that make sense only together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum What {
    One(Number),
    /// `3/23`.
    Fraction(Number, Number),
    /// `(1, 0, 0)`.
    Tuple(Vec<Number>),
    /// A power of a number that is not ten, which nothing in the code could be.
    Power,
}

/// A number in a text.
#[derive(Debug, Clone)]
pub(crate) struct Token {
    pub(crate) what: What,
    pub(crate) unit: Option<&'static str>,
    /// Its bytes in the text, unit and all brackets of a tuple included.
    pub(crate) at: Range<usize>,
    /// Its bytes without the unit.
    pub(crate) digits: Range<usize>,
    /// The symbol, where it stands in a formula `symbol = number`, as the code would name it.
    pub(crate) name: Option<String>,
    /// The list it belongs to: equal for the members of `a, b and c`.
    pub(crate) list: usize,
    /// An index, exponent or factor of a formula: no value of its own.
    pub(crate) structural: bool,
}

/// Units as the book prints them, and the one name each has here. Longer ones first.
const UNITS: [(&str, &str); 28] = [
    ("kg m²/s", "kg m²/s"),
    ("kg m²", "kg m²"),
    ("radians a second", "rad/s"),
    ("turns a second", "turns/s"),
    ("turn a second", "turns/s"),
    ("rad/s", "rad/s"),
    ("per second", "/s"),
    ("per cent", "%"),
    ("percent", "%"),
    ("degrees", "°"),
    ("seconds", "s"),
    ("second", "s"),
    ("joules", "J"),
    ("radians", "rad"),
    ("metres", "m"),
    ("kilograms", "kg"),
    ("kilogram", "kg"),
    ("times", "times"),
    ("rad", "rad"),
    ("N m", "N m"),
    ("mm", "mm"),
    ("kg", "kg"),
    ("/s", "/s"),
    ("°", "°"),
    ("%", "%"),
    ("m", "m"),
    ("s", "s"),
    ("J", "J"),
];

/// The unit of a number behind which stands one that the book does not know; no value of the code has it.
const UNKNOWN: &str = "(a unit unknown here)";

/// Units that the book does not use.
const OTHER_UNITS: [&str; 30] = [
    "cm",
    "km",
    "g",
    "N",
    "W",
    "Hz",
    "Pa",
    "lb",
    "ft",
    "K",
    "V",
    "A",
    "h",
    "ms",
    "rpm",
    "min",
    "inches",
    "feet",
    "pounds",
    "grams",
    "newtons",
    "watts",
    "hertz",
    "hours",
    "minutes",
    "days",
    "years",
    "milliseconds",
    "centimetres",
    "kilometres",
];

/// Spaces that may stand between the groups of digits of one number.
fn is_thin(c: char) -> bool {
    matches!(c, '\u{2009}' | '\u{202f}' | '\u{a0}')
}

fn is_minus(c: char) -> bool {
    matches!(c, '-' | '\u{2212}')
}

/// The unit that follows at this byte, and where it ends.
pub(crate) fn unit_at(text: &str, at: usize) -> Option<(&'static str, usize)> {
    let rest = &text[at..];
    let after_space = rest.trim_start_matches(|c: char| c == ' ' || is_thin(c));
    let start = at + rest.len() - after_space.len();
    let found = UNITS.iter().find_map(|&(written, name)| {
        let tail = after_space.strip_prefix(written)?;
        let letters = written.ends_with(|c: char| c.is_alphanumeric() || c == '²');
        if letters && tail.starts_with(|c: char| c.is_alphabetic() && !matches!(c, '²' | '³')) {
            return None;
        }
        let goes_on = letters && tail.starts_with(['²', '³', '/', '^', '·']);
        Some((if goes_on { UNKNOWN } else { name }, start + written.len()))
    });
    let Some((name, end)) = found else {
        let word = after_space.split(|c: char| !c.is_alphabetic() && c != '/').next().unwrap_or_default();
        return OTHER_UNITS.contains(&word).then_some((UNKNOWN, start + word.len()));
    };
    // `kg m³` is no kilogram.
    let more = text[end..].strip_prefix(' ').and_then(|tail| tail.strip_prefix(['m', 's', 'N']));
    let more =
        more.is_some_and(|tail| !tail.starts_with(|c: char| c.is_alphabetic() && !matches!(c, '²' | '³')));
    Some((if more { UNKNOWN } else { name }, end))
}

/// All numbers of a text, of which these ranges are TeX.
pub(crate) fn tokens(text: &str, tex: &[Range<usize>]) -> Vec<Token> {
    let mut found = Vec::new();
    let mut at = 0;
    for formula in tex {
        Scanner { text, at, end: formula.start, tex: false }.scan(&mut found);
        in_formula(text, formula, &mut found);
        at = formula.end;
    }
    Scanner { text, at, end: text.len(), tex: false }.scan(&mut found);
    for token in &mut found {
        if !token.structural
            && let Some((unit, end)) = unit_at(text, token.digits.end)
        {
            token.unit = Some(unit);
            token.at.end = end;
        }
    }
    join_lists(text, &mut found);
    found
}

/// Finds the lists. A member without a unit takes that of the next one.
fn join_lists(text: &str, found: &mut [Token]) {
    for (number, token) in found.iter_mut().enumerate() {
        token.list = number;
    }
    let listable = |t: &Token| matches!(t.what, What::One(_)) && t.name.is_none() && !t.structural;
    for i in (1..found.len()).rev() {
        let (a, b) = (&found[i - 1], &found[i]);
        let joined = listable(a)
            && listable(b)
            && (a.unit.is_none() || a.unit == b.unit)
            && matches!(&text[a.at.end..b.at.start], ", " | " and " | ", and " | " or " | " to " | "–");
        if joined {
            let (list, unit) = (b.list, b.unit);
            found[i - 1].list = list;
            found[i - 1].unit = found[i - 1].unit.or(unit);
        }
    }
}

/// The numbers of a formula. A value is what has a decimal point or a power of ten, a tuple of
/// numbers, a formula that is one number, and a formula `symbol = number`; every other number is a
/// part of the formula, true or false with it.
fn in_formula(text: &str, formula: &Range<usize>, found: &mut Vec<Token>) {
    let from = found.len();
    Scanner { text, at: formula.start, end: formula.end, tex: true }.scan(found);
    let whole = text[formula.clone()].trim();
    for token in &mut found[from..] {
        let own = &text[token.digits.clone()];
        let before = text[formula.start..token.digits.start].trim();
        let to_the_end = text[token.digits.end..formula.end].trim().is_empty();
        let symbol = before.strip_suffix('=').filter(|_| to_the_end).and_then(symbol);
        token.structural = match &token.what {
            What::Tuple(_) => false,
            What::One(n) => !(n.power || n.printed.contains('.') || own == whole || symbol.is_some()),
            What::Fraction(..) => own != whole && symbol.is_none(),
            What::Power => has_symbol(whole),
        };
        token.name = symbol;
    }
}

/// Whether letters stand in this formula, besides its commands.
fn has_symbol(tex: &str) -> bool {
    let mut rest = tex;
    while let Some(at) = rest.find(|c: char| c == '\\' || c.is_alphabetic()) {
        let Some(command) = rest[at..].strip_prefix('\\') else {
            return true;
        };
        rest = command.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    }
    false
}

/// The name that code gives to a symbol: `\boldsymbol{\omega}` is `omega`, `\mathbf{L}` is `l`.
fn symbol(tex: &str) -> Option<String> {
    let mut rest = tex.trim();
    for dress in ["\\boldsymbol", "\\mathbf", "\\mathrm"] {
        if let Some(inner) = rest.strip_prefix(dress) {
            rest = inner.trim().strip_prefix('{')?.strip_suffix('}')?.trim();
        }
    }
    let name = rest.strip_prefix('\\').unwrap_or(rest);
    let plain = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphabetic());
    let one = rest.starts_with('\\') || name.len() == 1;
    (plain && one).then(|| name.to_lowercase())
}

struct Scanner<'a> {
    text: &'a str,
    at: usize,
    end: usize,
    tex: bool,
}

impl Scanner<'_> {
    fn rest(&self) -> &str {
        &self.text[self.at..self.end]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn scan(mut self, found: &mut Vec<Token>) {
        while let Some(c) = self.peek() {
            let start = self.at;
            let what = match c {
                '(' => self.tuple().map(What::Tuple),
                _ => self.number().map(|n| self.perhaps_more(n)),
            };
            if let Some(what) = what {
                // `1/s` and `1/(kg m²)` are units.
                let unit = matches!(&what, What::One(n) if n.printed == "1") && self.inverse_unit();
                if !unit {
                    let digits = start..self.at;
                    let at = digits.clone();
                    let list = 0;
                    found.push(Token { what, unit: None, at, digits, name: None, list, structural: false });
                }
                continue;
            }
            self.at = start;
            self.skip(c);
        }
    }

    /// Steps over what is no number.
    fn skip(&mut self, c: char) {
        let run = |text: &str| text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
        if !self.tex {
            // Digits that cling to letters before them are a part of a name: `Ash91`.
            let name = c.is_alphabetic() || c == '_';
            self.at += if name { run(self.rest()) } else { c.len_utf8() };
            return;
        }
        self.at += c.len_utf8();
        if c == '\\' {
            let command = self.rest().find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(self.rest().len());
            self.at += command;
        } else if matches!(c, '_' | '^') {
            // An index or an exponent says nothing by itself.
            self.at += match self.rest().strip_prefix('{') {
                Some(inner) => inner.find('}').map_or(self.rest().len(), |end| end + 2),
                None => self.peek().map_or(0, char::len_utf8),
            };
        }
    }

    fn blank(&mut self) {
        loop {
            let rest = self.rest();
            let spaces = rest.len() - rest.trim_start().len();
            self.at += spaces;
            let rest = self.rest();
            if self.tex && (rest.starts_with("\\,") || rest.starts_with("\\;") || rest.starts_with("\\ ")) {
                self.at += 2;
            } else {
                return;
            }
        }
    }

    fn tuple(&mut self) -> Option<Vec<Number>> {
        let mut numbers = Vec::new();
        self.at += 1;
        loop {
            self.blank();
            numbers.push(self.number()?);
            self.blank();
            match self.peek()? {
                ',' => self.at += 1,
                ')' if numbers.len() > 1 => {
                    self.at += 1;
                    return Some(numbers);
                }
                _ => return None,
            }
        }
    }

    /// Reads a number that begins here; the position is undefined where there is none.
    fn number(&mut self) -> Option<Number> {
        let before = self.text[..self.at].chars().next_back();
        let first = self.peek()?;
        let mut printed = String::new();
        if is_minus(first) {
            // After a letter or a digit it is a hyphen: `T-13`.
            if before.is_some_and(|c| c.is_alphanumeric() || matches!(c, ')' | '}')) {
                return None;
            }
            self.at += first.len_utf8();
            printed.push('-');
        }
        self.digits(&mut printed)?;
        if let Some(tail) = self.rest().strip_prefix('.')
            && tail.starts_with(|c: char| c.is_ascii_digit())
        {
            self.at += 1;
            printed.push('.');
            self.plain_digits(&mut printed);
        }
        self.with_power(printed)
    }

    /// Digits, perhaps in groups of three.
    fn digits(&mut self, printed: &mut String) -> Option<()> {
        if self.plain_digits(printed) == 0 {
            return None;
        }
        loop {
            let mut rest = self.rest().chars();
            let thin = match rest.next() {
                Some(c) if is_thin(c) => c.len_utf8(),
                Some('\\') if self.tex && rest.next() == Some(',') => 2,
                _ => return Some(()),
            };
            let group = &self.rest()[thin..];
            let count = group.find(|c: char| !c.is_ascii_digit()).unwrap_or(group.len());
            if count != 3 {
                return Some(());
            }
            self.at += thin;
            self.plain_digits(printed);
        }
    }

    fn plain_digits(&mut self, printed: &mut String) -> usize {
        let rest = self.rest();
        let count = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        printed.push_str(&rest[..count]);
        self.at += count;
        count
    }

    /// Reads `e-9`, `^{-12}` after a ten, `\times 10^{-13}` and `× 10⁻¹³`.
    fn with_power(&mut self, printed: String) -> Option<Number> {
        let digits = printed.clone();
        let power = if let Some(tail) = self.rest().strip_prefix('e') {
            let (sign, tail) = match tail.strip_prefix(is_minus) {
                Some(tail) => ("-", tail),
                None => ("", tail),
            };
            let count = tail.find(|c: char| !c.is_ascii_digit()).unwrap_or(tail.len());
            let taken = self.rest().len() - tail.len() + count;
            (count > 0).then(|| (digits, format!("{sign}{}", &tail[..count]), taken))
        } else if printed == "10" {
            raised(self.rest()).map(|(power, taken)| ("1".to_owned(), power, taken))
        } else {
            let rest = self.rest();
            let tail = rest.trim_start();
            let cross = tail.strip_prefix("\\times").or_else(|| tail.strip_prefix('×')).map(str::trim_start);
            cross.and_then(|tail| {
                let base = tail.strip_prefix("10")?;
                let (power, taken) = raised(base)?;
                Some((digits, power, rest.len() - base.len() + taken))
            })
        };
        match power {
            Some((digits, power, taken)) => {
                self.at += taken;
                let printed = format!("{digits}e{power}");
                let value = Decimal::read(&printed)?;
                Some(Number { printed, value, power: true })
            }
            None => {
                let value = Decimal::read(&printed)?;
                Some(Number { printed, value, power: false })
            }
        }
    }

    /// `3/23`, where a slash and another number follow; `2^{-3}`, where an exponent does.
    fn perhaps_more(&mut self, over: Number) -> What {
        let at = self.at;
        if let Some((_, taken)) = raised(self.rest()).filter(|_| !over.power) {
            self.at += taken;
            return What::Power;
        }
        if self.rest().starts_with('/') {
            self.at += 1;
            if self.peek().is_some_and(|c| c.is_ascii_digit())
                && let Some(under) = self.number()
            {
                return What::Fraction(over, under);
            }
        }
        self.at = at;
        What::One(over)
    }

    /// Steps over `/s` or `/(kg m²)` after a one.
    fn inverse_unit(&mut self) -> bool {
        let Some(tail) = self.rest().strip_prefix('/') else {
            return false;
        };
        let open = usize::from(tail.starts_with('('));
        match unit_at(self.text, self.at + 1 + open) {
            Some((_, end)) if self.text[end..].starts_with(')') || open == 0 => {
                self.at = end + open;
                true
            }
            _ => false,
        }
    }
}

/// The power written at the start: `^{-12}`, `^2`, `⁻¹²`; and its bytes.
fn raised(text: &str) -> Option<(String, usize)> {
    if let Some(tail) = text.strip_prefix('^') {
        let (inner, taken) = match tail.strip_prefix('{') {
            Some(inner) => {
                let end = inner.find('}')?;
                (&inner[..end], end + 3)
            }
            None => (tail.get(..1)?, 2),
        };
        return inner.trim().parse::<i32>().ok().map(|power| (power.to_string(), taken));
    }
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let mut power = String::new();
    let mut taken = 0;
    for c in text.chars() {
        match RAISED.iter().position(|&r| r == c) {
            Some(digit) => power.push_str(&digit.to_string()),
            None if c == '⁻' && power.is_empty() => power.push('-'),
            None => break,
        }
        taken += c.len_utf8();
    }
    power.parse::<i32>().ok().map(|power| (power.to_string(), taken))
}
