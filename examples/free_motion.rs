//! Free motions, solved exactly: reads cases of moments, initial spin and times from a JSON file and prints
//! the spin (body axes, rad/s) and the attitude (body to world, scalar part first) at each time.
//!
//! ```text
//! cargo run --release --example free_motion -- CASES.json
//! ```
//!
//! The file holds `{"cases": [{"name": ..., "inertia": [3], "w0": [3], "t": [...]}]}`, its numbers as
//! numbers or as decimal strings. A case that cannot be answered gets an `error` entry and a line on standard
//! error, and the program ends with a failure after answering the others.

use nalgebra::Vector3;
use serde_json::{Map, Value, json};
use std::process::ExitCode;
use tumbling::exact::FreeMotion;

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let [path] = arguments.as_slice() else {
        eprintln!("usage: free_motion CASES.json");
        return ExitCode::from(2);
    };
    let cases = std::fs::read_to_string(path)
        .map_err(|error| error.to_string())
        .and_then(|text| serde_json::from_str::<Value>(&text).map_err(|error| error.to_string()))
        .and_then(|file| match file {
            Value::Array(cases) => Ok(cases),
            Value::Object(mut fields) => match fields.remove("cases") {
                Some(Value::Array(cases)) => Ok(cases),
                Some(_) => Err("`cases` is not a list".to_owned()),
                None => Err("there is no field `cases`".to_owned()),
            },
            _ => Err("neither a list of cases nor an object with the field `cases`".to_owned()),
        });
    let cases = match cases {
        Ok(cases) => cases,
        Err(error) => {
            eprintln!("{}: {error}", path.to_string_lossy());
            return ExitCode::from(2);
        }
    };
    let mut failed = false;
    let mut answers = Vec::new();
    for (index, case) in cases.iter().enumerate() {
        let name =
            case.get("name").and_then(Value::as_str).map_or_else(|| format!("case {index}"), str::to_owned);
        let mut answer = Map::new();
        answer.insert("name".to_owned(), json!(name));
        match solve(case) {
            Ok((w, q)) => {
                answer.insert("w".to_owned(), json!(w));
                answer.insert("q".to_owned(), json!(q));
            }
            Err(error) => {
                failed = true;
                eprintln!("{name}: {error}");
                answer.insert("error".to_owned(), json!(error));
            }
        }
        answers.push(Value::Object(answer));
    }
    println!("{}", json!({ "cases": answers }));
    if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

type Answer = (Vec<[f64; 3]>, Vec<[f64; 4]>);

fn solve(case: &Value) -> Result<Answer, String> {
    if !case.get("name").is_some_and(Value::is_string) {
        return Err("the field `name` is missing or not a string".to_owned());
    }
    let moments = vector(case, "inertia")?;
    let omega = vector(case, "w0")?;
    let times = numbers(case, "t")?;
    let motion = FreeMotion::new(&moments, &omega).map_err(|error| error.to_string())?;
    let mut answer = Answer::default();
    for t in times {
        let at = motion.at(t).map_err(|error| error.to_string())?;
        let (w, q) = (at.omega, at.attitude);
        answer.0.push([w.x, w.y, w.z]);
        answer.1.push([q.w, q.i, q.j, q.k]);
    }
    Ok(answer)
}

fn vector(case: &Value, field: &str) -> Result<Vector3<f64>, String> {
    match numbers(case, field)?.as_slice() {
        [x, y, z] => Ok(Vector3::new(*x, *y, *z)),
        list => Err(format!("`{field}` has {} numbers: it must have 3", list.len())),
    }
}

fn numbers(case: &Value, field: &str) -> Result<Vec<f64>, String> {
    let value = case.get(field).ok_or_else(|| format!("the field `{field}` is missing"))?;
    let list = value.as_array().ok_or_else(|| format!("`{field}` is not a list"))?;
    list.iter()
        .map(|x| number(x).ok_or_else(|| format!("`{field}` holds {x}: not a finite number")))
        .collect()
}

/// A number, or a string that is one, if finite.
fn number(value: &Value) -> Option<f64> {
    let x = match value {
        Value::String(text) => text.trim().parse().ok()?,
        other => other.as_f64()?,
    };
    x.is_finite().then_some(x)
}
