//! The fields of a table, with their lines.

use crate::error::Error;
use nalgebra::Vector3;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The bytes at which the lines begin.
pub(super) struct Lines(Vec<usize>);

impl Lines {
    pub(super) fn of(text: &str) -> Self {
        let ends = text.bytes().enumerate().filter(|&(_, byte)| byte == b'\n');
        Self(std::iter::once(0).chain(ends.map(|(at, _)| at + 1)).collect())
    }

    pub(super) fn at(&self, span: &Range<usize>) -> usize {
        self.0.partition_point(|&start| start <= span.start)
    }

    pub(super) fn wrong(&self, span: &Range<usize>, field: &str, why: impl Into<String>) -> Error {
        Error::File { line: Some(self.at(span)), field: Some(field.to_owned()), why: why.into() }
    }
}

/// A table whose fields are all known.
pub(super) struct Fields<'a, 'i> {
    pub(super) lines: &'a Lines,
    table: &'a DeTable<'i>,
    pub(super) span: Range<usize>,
}

impl<'a, 'i> Fields<'a, 'i> {
    pub(super) fn new(
        lines: &'a Lines,
        table: &'a DeTable<'i>,
        span: Range<usize>,
        known: &[&str],
    ) -> Result<Self, Error> {
        for key in table.keys() {
            let name = key.get_ref().as_ref();
            if !known.contains(&name) {
                return Err(lines.wrong(
                    &key.span(),
                    name,
                    format!("no such field.{}", nearest(name, known)),
                ));
            }
        }
        Ok(Self { lines, table, span })
    }

    pub(super) fn get(&self, name: &str) -> Option<&'a Spanned<DeValue<'i>>> {
        self.table.iter().find(|(key, _)| key.get_ref().as_ref() == name).map(|(_, value)| value)
    }

    /// A field whose value is refused.
    pub(super) fn refused(&self, name: &str, error: &impl std::error::Error) -> Error {
        let span = self.get(name).map_or_else(|| self.span.clone(), Spanned::span);
        self.lines.wrong(&span, name, error.to_string())
    }

    pub(super) fn missing(&self, what: &str) -> Error {
        // Of the file itself no line is to blame.
        let line = (self.span.start > 0).then(|| self.lines.at(&self.span));
        Error::File { line, field: None, why: format!("{what} is missing") }
    }

    /// Of two fields that go together the one that is there.
    pub(super) fn alone(&self, there: &str, missing: &str) -> Error {
        let span = self.get(there).map_or_else(|| self.span.clone(), Spanned::span);
        self.lines.wrong(&span, there, format!("{missing} is missing, which goes with it"))
    }

    pub(super) fn expected(&self, name: &str, value: &Spanned<DeValue<'_>>, expected: &str) -> Error {
        let kind = value.get_ref().type_str();
        self.lines.wrong(
            &value.span(),
            name,
            format!("{expected} is expected here, not a value of type {kind}"),
        )
    }

    fn number_of(&self, name: &str, value: &Spanned<DeValue<'_>>) -> Result<f64, Error> {
        let text = match value.get_ref() {
            DeValue::Float(number) => number.as_str(),
            DeValue::Integer(number) if number.radix() == 10 => number.as_str(),
            _ => return Err(self.expected(name, value, "a number")),
        };
        let plain = text.replace('_', "");
        let number: f64 = plain.parse().map_err(|_| self.expected(name, value, "a number"))?;
        let mantissa = plain.split(['e', 'E']).next().unwrap_or_default();
        if !number.is_finite() {
            let why = format!("{text} is no finite number that can be computed with");
            return Err(self.lines.wrong(&value.span(), name, why));
        }
        if number == 0.0 && mantissa.contains(|digit| matches!(digit, '1'..='9')) {
            let why = format!("{text} is closer to zero than any number that can be computed with");
            return Err(self.lines.wrong(&value.span(), name, why));
        }
        Ok(number)
    }

    pub(super) fn number(&self, name: &str) -> Result<Option<f64>, Error> {
        self.get(name).map(|value| self.number_of(name, value)).transpose()
    }

    pub(super) fn numbers(&self, name: &str) -> Result<Option<Vec<f64>>, Error> {
        let Some(value) = self.get(name) else { return Ok(None) };
        let DeValue::Array(list) = value.get_ref() else {
            return Err(self.expected(name, value, "a list of numbers"));
        };
        list.iter().map(|item| self.number_of(name, item)).collect::<Result<_, _>>().map(Some)
    }

    pub(super) fn exactly<const N: usize>(&self, name: &str) -> Result<Option<[f64; N]>, Error> {
        let Some(numbers) = self.numbers(name)? else { return Ok(None) };
        let count = numbers.len();
        numbers.try_into().map(Some).map_err(|_| {
            let span = self.get(name).map_or(0..0, Spanned::span);
            self.lines.wrong(&span, name, format!("{N} numbers are expected here, not {count}"))
        })
    }

    pub(super) fn vector(&self, name: &str) -> Result<Option<Vector3<f64>>, Error> {
        Ok(self.exactly::<3>(name)?.map(Vector3::from))
    }

    /// The tables of a list, with where each begins.
    pub(super) fn tables(&self, name: &str, known: &[&str]) -> Result<Vec<Fields<'a, 'i>>, Error> {
        let Some(value) = self.get(name) else { return Ok(Vec::new()) };
        let wrong =
            || self.expected(name, value, &format!("a list of tables, `[[{name}]]` at the head of each,"));
        let DeValue::Array(list) = value.get_ref() else { return Err(wrong()) };
        list.iter()
            .map(|item| match item.get_ref() {
                DeValue::Table(table) => Fields::new(self.lines, table, item.span(), known),
                _ => Err(wrong()),
            })
            .collect()
    }
}

/// Other names of these fields.
const ELSEWHERE: [(&str, &str); 21] = [
    ("omega", "spin"),
    ("angular_velocity", "spin"),
    ("w", "spin"),
    ("inertia", "moments"),
    ("tensor", "moments"),
    ("angular_momentum", "momentum"),
    ("quaternion", "attitude"),
    ("orientation", "attitude"),
    ("rotation", "attitude"),
    ("dt", "every"),
    ("step", "every"),
    ("duration", "span"),
    ("end", "span"),
    ("tolerance", "accuracy"),
    ("drag", "damping"),
    ("gravity", "field"),
    ("dipole", "moment"),
    ("nadir", "toward"),
    ("start", "from"),
    ("begin", "from"),
    ("until", "to"),
];

pub(super) fn nearest(name: &str, known: &[&str]) -> String {
    let lower = name.to_lowercase();
    let meant = ELSEWHERE.iter().find(|(word, meant)| *word == lower && known.contains(meant));
    if let Some((_, meant)) = meant {
        return format!(" Did you mean `{meant}`?");
    }
    let best = known
        .iter()
        .map(|known| (strsim::normalized_damerau_levenshtein(name, known), known))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    match best {
        Some((likeness, name)) if likeness >= 0.6 => format!(" Did you mean `{name}`?"),
        _ => format!(" There are `{}`.", known.join("`, `")),
    }
}
