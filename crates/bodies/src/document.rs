//! The values of a TOML text, or the place of an error and what was expected there.

use crate::error::Error;
use serde::de::DeserializeOwned;
use std::ops::Range;
use toml::de::{DeTable, DeValue, Deserializer};

/// A value from a text of TOML whose numbers are all finite.
///
/// # Errors
/// The line, the field and what was expected; for an unknown field, the most similar known field.
pub fn from_toml<T: DeserializeOwned>(text: &str) -> Result<T, Error> {
    // A field that the whole text lacks is missing at no line.
    let at = |error: toml::de::Error, why: String| match error.span() {
        Some(span) if span.start > 0 || !why.contains("is missing") => {
            Error::at(text, &span, why + &decimal_comma(text, span.start))
        }
        _ => Error::new(why),
    };
    let plain = |message: &str| message.replace("duplicate key", TWICE).replace(UNQUOTED, STRAIGHT);
    let root = DeTable::parse(text).map_err(|error| at(error.clone(), plain(error.message())))?;
    let mut fields = root.get_ref().iter();
    if let Some((field, span, why)) = fields.find_map(|(key, value)| bad_number(key.get_ref(), value)) {
        return Err(Error::at(text, &span, why).of_field(&field));
    }
    let found = T::deserialize(Deserializer::from(root.clone()));
    found.map_err(|error| {
        let (unknown, why) = reworded(error.message());
        let field = unknown.or_else(|| field_at(root.get_ref(), error.span()?.start));
        let hint = match field.as_deref() {
            Some("turn") => "; write turn = [x, y, z, degrees]".into(),
            Some("sides") if why.contains("a list") => "; write sides = ['10 cm', '20 cm', '30 cm']".into(),
            Some(list) if LISTS.contains(&list) && why.contains("expected here") => {
                format!(": each table of a list begins with `[[{list}]]`")
            }
            _ => String::new(),
        };
        let error = at(error, why + &hint);
        field.into_iter().fold(error, |error, field| error.of_field(&field))
    })
}

/// What to write where the line has a decimal comma: `; write 0.07`.
pub(crate) fn decimal_comma(text: &str, at: usize) -> String {
    let start = text.get(..at).and_then(|before| before.rfind('\n')).map_or(0, |end| end + 1);
    let line = text.get(start..).unwrap_or_default().lines().next().unwrap_or_default();
    let digit = |c: char| c.is_ascii_digit();
    // A comma behind another in one word, or before a blank, is that of a list.
    let mended = |words: &str| {
        let pieces: Vec<_> = words.trim_end_matches(',').split(',').collect();
        let within = pieces.windows(2).all(|two| two[0].ends_with(digit) && two[1].starts_with(digit));
        let apart = pieces.iter().skip(1).rev().skip(1).all(|piece| piece.contains(' '));
        let joined = pieces.join(".");
        let single = joined.split_whitespace().all(|word| word.matches('.').count() < 2);
        (pieces.len() > 1 && within && apart && single).then_some(joined)
    };
    let parts = || line.split(['"', '\'']);
    // Within quotes its unit goes along; without a unit it is a number, which has none.
    let bare = |w: String| w.parse::<f64>().map_or(format!("'{w}'"), |_| format!("{w}, unquoted"));
    let mut quoted = parts().skip(1).step_by(2).filter_map(mended).map(bare);
    let is_list = line.contains('[') && !line.contains(", ");
    let words = parts().step_by(2).flat_map(|part| part.split([' ', '=', '[', ']']));
    let found = quoted.next().or_else(|| words.filter(|_| !is_list).find_map(mended));
    found.map_or_else(String::new, |words| format!("; write {words}"))
}

/// A number that is not usable: its field, its place and the reason.
fn bad_number(field: &str, value: &toml::Spanned<DeValue<'_>>) -> Option<(String, Range<usize>, String)> {
    let number = match value.get_ref() {
        DeValue::Float(number) => number.as_str(),
        DeValue::Integer(it) if u64::from_str_radix(it.as_str().trim_matches('-'), it.radix()).is_err() => {
            let why = format!("{it} is too long for a whole number; write it with a power, such as 1e20");
            return Some((field.to_owned(), value.span(), why));
        }
        DeValue::Array(list) => return list.iter().find_map(|item| bad_number(field, item)),
        DeValue::Table(table) => return table.iter().find_map(|(key, item)| bad_number(key.get_ref(), item)),
        _ => return None,
    };
    let read: f64 = number.replace('_', "").parse().ok()?;
    let mantissa = number.split(['e', 'E']).next().unwrap_or_default();
    let why = match read {
        0.0 if mantissa.contains(|digit| matches!(digit, '1'..='9')) => "is too near zero to compute with",
        x if x.is_finite() => return None,
        _ => "is no finite number to compute with",
    };
    Some((field.to_owned(), value.span(), format!("{number} {why}")))
}

/// The message for a field or a table that occurs twice.
const TWICE: &str = "this is there already; each table of a list begins with `[[`, such as `[[part]]`";

/// The parser's message on a fraction or on curly quotation marks, and what to write instead.
const UNQUOTED: &str = "string values must be quoted, expected literal string";
const STRAIGHT: &str = "a number is expected here, or a text in straight quotation marks, such as \"7 cm\"";

/// The fields that are lists of tables.
const LISTS: [&str; 3] = ["body", "part", "torque"];

/// The innermost field whose value is here.
fn field_at(table: &DeTable<'_>, at: usize) -> Option<String> {
    fn within(value: &DeValue<'_>, at: usize) -> Option<String> {
        match value {
            DeValue::Table(table) => field_at(table, at),
            DeValue::Array(list) => list.iter().find_map(|item| within(item.get_ref(), at)),
            _ => None,
        }
    }
    table.iter().find_map(|(key, value)| {
        let here = || value.span().contains(&at).then(|| key.get_ref().to_string());
        within(value.get_ref(), at).or_else(here)
    })
}

/// Serde's message in a reader's words, and the field that is unknown.
fn reworded(message: &str) -> (Option<String>, String) {
    let mut words = message.split('`').skip(1).step_by(2);
    if message.starts_with("unknown ")
        && let Some(name) = words.next()
    {
        let hint = nearest(name, &words.collect::<Vec<_>>());
        let field = message.starts_with("unknown field").then(|| name.to_owned());
        let none = format!("`{name}` is not known here.{hint}");
        return if field.is_some() { (field, format!("no such field.{hint}")) } else { (None, none) };
    }
    if let Some(name) = message.strip_prefix("missing field ") {
        let places = ["it stands above the first `[[...]]`", "each begins with `[[body]]`"];
        return (None, format!("{name} is missing; {}", places[usize::from(name == "`body`")]));
    }
    let Some((found, expected)) = message.split_once(", expected ") else {
        return (None, message.replace("wanted string or table", "a text is expected here"));
    };
    let known = [("f64", "a number"), ("a sequence", "a list"), ("struct Table", "a table")];
    let expected = known.iter().find(|(own, _)| *own == expected).map_or(expected, |(_, words)| words);
    let found = found.trim_start_matches("invalid type: ").trim_start_matches("invalid ");
    (None, format!("{expected} is expected here, not {found}"))
}

/// Other names of fields.
const ELSEWHERE: [(&str, &[&str]); 15] = [
    ("spin", &["omega", "angular_velocity", "w"]),
    ("moments", &["inertia", "tensor"]),
    ("momentum", &["angular_momentum"]),
    ("sides", &["size"]),
    ("turn", &["axis"]),
    ("mass", &["weight"]),
    ("attitude", &["quaternion", "orientation", "rotation"]),
    ("every", &["dt", "step"]),
    ("span", &["duration", "end"]),
    ("accuracy", &["tolerance"]),
    ("damping", &["drag"]),
    ("field", &["gravity"]),
    ("moment", &["dipole"]),
    ("from", &["start", "begin"]),
    ("to", &["until"]),
];

fn nearest(name: &str, known: &[&str]) -> String {
    let lower = name.to_lowercase();
    let meant =
        ELSEWHERE.iter().find(|(meant, words)| words.contains(&lower.as_str()) && known.contains(meant));
    let alike = |known: &&str| strsim::normalized_damerau_levenshtein(name, known);
    let best = known.iter().copied().max_by(|a, b| alike(a).total_cmp(&alike(b)));
    let meant = meant.map(|(meant, _)| *meant).or(best.filter(|best| alike(best) >= 0.6));
    let all = || format!(" There are `{}`.", known.join("`, `"));
    meant.map_or_else(all, |name| format!(" Did you mean `{name}`?"))
}
