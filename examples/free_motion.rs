//! Free motions, solved exactly: reads cases of moments, initial spin and times from a JSON file and prints
//! the spin (body axes, rad/s) and the attitude (body to world, scalar part first) at each time.
//!
//! ```text
//! cargo run --example free_motion -- CASES.json
//! ```
//!
//! The file holds `{"cases": [{"name": ..., "inertia": [3], "w0": [3], "t": [...]}]}`, its numbers as numbers
//! or as decimal strings. A case that cannot be answered gets an `error` entry and a line on standard error,
//! and the program ends with a failure after answering the others. So does one with a field given twice, a
//! name that an earlier one has, or a number that no `f64` holds: `1e999`, a bare `NaN`, or `1e-400`, which
//! would be taken for zero.

use nalgebra::Vector3;
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::value::RawValue;
use serde_json::{Map, Value, json};
use std::collections::HashSet;
use std::fmt;
use std::io::{ErrorKind, Write as _};
use std::process::ExitCode;
use tumbling::PrincipalMoments;
use tumbling::exact::FreeMotion;

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let [path] = arguments.as_slice() else {
        complain("usage: free_motion CASES.json");
        return ExitCode::from(2);
    };
    let text = std::fs::read_to_string(path).map_err(|error| error.to_string());
    let text = text.map(|text| with_words_in_lists(text.trim_start_matches('\u{feff}')));
    let cases = match text.as_ref().map_err(Clone::clone).and_then(|text| cases_of(text)) {
        Ok(cases) => cases,
        Err(error) => {
            complain(&format!("{}: {error}", path.to_string_lossy()));
            return ExitCode::from(2);
        }
    };
    let mut failed = false;
    let mut answers = Vec::new();
    let mut names = HashSet::new();
    for (index, case) in cases.into_iter().enumerate() {
        let case = serde_json::from_str(case.get()).unwrap_or(Fields(Vec::new()));
        let given = case.name();
        let first = given.clone().is_none_or(|given| names.insert(given));
        let name = given.unwrap_or_else(|| format!("case {index}"));
        let solved = if first { solve(&case) } else { Err("an earlier case has this name too".to_owned()) };
        let mut answer = Map::new();
        answer.insert("name".to_owned(), json!(name));
        match solved {
            Ok((w, q)) => {
                answer.insert("w".to_owned(), json!(w));
                answer.insert("q".to_owned(), json!(q));
            }
            Err(error) => {
                failed = true;
                complain(&format!("{name}: {error}"));
                answer.insert("error".to_owned(), json!(error));
            }
        }
        answers.push(Value::Object(answer));
    }
    let mut output = std::io::stdout().lock();
    match writeln!(output, "{}", json!({ "cases": answers })).and_then(|()| output.flush()) {
        // Who closes the pipe has read what was wanted.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            complain(&format!("the answers cannot be written: {error}"));
            ExitCode::from(2)
        }
        _ if failed => ExitCode::FAILURE,
        _ => ExitCode::SUCCESS,
    }
}

/// A line on standard error, if it takes one.
fn complain(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

/// The text with `NaN`, `Infinity` and `-Infinity`, which many programs write though JSON does not have them,
/// as lists of one string: readable, and not a number wherever they stand.
fn with_words_in_lists(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let (mut rest, mut quoted) = (text, false);
    while let Some(c) = rest.chars().next() {
        let word =
            ["NaN", "Infinity", "-Infinity"].into_iter().find(|word| !quoted && rest.starts_with(word));
        let length = match (word, c) {
            (Some(word), _) => word.len(),
            // What follows a backslash in a string does not end it.
            (None, '\\') if quoted => 1 + rest[1..].chars().next().map_or(0, char::len_utf8),
            (None, c) => c.len_utf8(),
        };
        quoted ^= c == '"';
        match word {
            Some(word) => out.extend(["[\"", word, "\"]"]),
            None => out.push_str(&rest[..length]),
        }
        rest = &rest[length..];
    }
    out
}

/// The fields of an object in order, each as its text: a number that `f64` lacks spoils itself alone.
struct Fields<'a>(Vec<(String, &'a RawValue)>);

impl<'de: 'a, 'a> Deserialize<'de> for Fields<'a> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Listed;
        impl<'de> Visitor<'de> for Listed {
            type Value = Fields<'de>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut fields = Vec::new();
                while let Some(field) = map.next_entry()? {
                    fields.push(field);
                }
                Ok(Fields(fields))
            }
        }
        from.deserialize_map(Listed)
    }
}

impl<'a> Fields<'a> {
    /// The one field of this name, if there is one.
    fn get(&self, name: &str) -> Result<Option<&'a RawValue>, String> {
        let mut found = self.0.iter().filter(|(field, _)| field == name).map(|(_, value)| *value);
        let first = found.next();
        if found.next().is_some() { Err(format!("the field `{name}` is there twice")) } else { Ok(first) }
    }

    /// The first string that is called the name.
    fn name(&self) -> Option<String> {
        let value = self.0.iter().find(|(field, _)| field == "name")?.1;
        serde_json::from_str(value.get()).ok()
    }
}

fn cases_of(text: &str) -> Result<Vec<&RawValue>, String> {
    let file: &RawValue = serde_json::from_str(text).map_err(|error| error.to_string())?;
    let list = match file.get().as_bytes().first() {
        Some(b'[') => file,
        Some(b'{') => {
            let fields: Fields<'_> = serde_json::from_str(file.get()).map_err(|error| error.to_string())?;
            fields.get("cases")?.ok_or("there is no field `cases`")?
        }
        _ => return Err("neither a list of cases nor an object with the field `cases`".to_owned()),
    };
    serde_json::from_str(list.get()).map_err(|_| "`cases` is not a list".to_owned())
}

type Answer = (Vec<[f64; 3]>, Vec<[f64; 4]>);

fn solve(case: &Fields<'_>) -> Result<Answer, String> {
    if case.get("name")?.is_none() || case.name().is_none() {
        return Err("the field `name` is missing or not a string".to_owned());
    }
    if let Some(twice) = case.0.iter().map(|(field, _)| field).find(|field| case.get(field).is_err()) {
        return Err(format!("the field `{twice}` is there twice"));
    }
    let moments = vector(case, "inertia")?;
    let omega = vector(case, "w0")?;
    let times = numbers(case, "t")?;
    let moments = PrincipalMoments::try_from(moments);
    let motion =
        moments.and_then(|moments| FreeMotion::new(moments, &omega)).map_err(|error| error.to_string())?;
    let mut answer = Answer::default();
    for t in times {
        let at = motion.at(t).map_err(|error| error.to_string())?;
        let (w, q) = (at.omega, at.attitude);
        answer.0.push([w.x, w.y, w.z]);
        answer.1.push([q.w, q.i, q.j, q.k]);
    }
    Ok(answer)
}

fn vector(case: &Fields<'_>, field: &str) -> Result<Vector3<f64>, String> {
    match numbers(case, field)?.as_slice() {
        [x, y, z] => Ok(Vector3::new(*x, *y, *z)),
        list => Err(format!("`{field}` has {} numbers: it must have 3", list.len())),
    }
}

fn numbers(case: &Fields<'_>, field: &str) -> Result<Vec<f64>, String> {
    let value = case.get(field)?.ok_or_else(|| format!("the field `{field}` is missing"))?;
    let list: Vec<&RawValue> =
        serde_json::from_str(value.get()).map_err(|_| format!("`{field}` is not a list"))?;
    list.into_iter()
        .map(|x| number(x.get()).map_err(|rule| format!("`{field}` holds {}: {rule}", x.get())))
        .collect()
}

/// A number, or a string that is one, if finite and not so small that it would be taken for zero.
fn number(json: &str) -> Result<f64, &'static str> {
    let numeral = serde_json::from_str(json).unwrap_or_else(|_| json.to_owned());
    let x: f64 = numeral.trim().parse().map_err(|_| "not a finite number")?;
    let mantissa = numeral.split(['e', 'E']).next().unwrap_or_default();
    if !x.is_finite() {
        Err("not a finite number")
    } else if x == 0.0 && mantissa.contains(|c| matches!(c, '1'..='9')) {
        Err("not zero, but closer to it than any number that can be computed with")
    } else {
        Ok(x)
    }
}
