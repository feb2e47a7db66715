//! Free motions, solved exactly: reads cases of moments, initial spin and times from a JSON file and prints
//! the spin (body axes, rad/s) and the attitude (body to world, scalar part first) at each time.
//!
//! ```text
//! cargo run --example free_motion -- CASES.json
//! ```
//!
//! The file holds `{"cases": [{"name": ..., "inertia": [3], "w0": [3], "t": [...]}]}`, its numbers as numbers
//! or as decimal strings. A case that cannot be answered gets an `error` entry and a line on standard error,
//! and the program ends with 1 after answering the others; a file that is no such JSON ends it with 2.

use nalgebra::Vector3;
use serde::Deserialize;
use serde_json::{json, value::RawValue};
use std::io::{ErrorKind, Write as _};
use std::process::ExitCode;
use tumbling::PrincipalMoments;
use tumbling::exact::FreeMotion;

#[derive(Deserialize)]
struct File {
    cases: Vec<Box<RawValue>>,
}

#[derive(Deserialize)]
struct Named {
    name: String,
}

/// Numbers as they are written: one that no `f64` holds spoils its own case alone.
#[derive(Deserialize)]
struct Case {
    inertia: [Box<RawValue>; 3],
    w0: [Box<RawValue>; 3],
    t: Vec<Box<RawValue>>,
}

fn main() -> ExitCode {
    match answered() {
        Ok(all) => ExitCode::from(u8::from(!all)),
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "{error}");
            ExitCode::from(2)
        }
    }
}

/// Prints the answers; says whether every case has one.
fn answered() -> Result<bool, String> {
    let path = std::env::args_os().nth(1).ok_or("usage: free_motion CASES.json")?;
    let fault = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let text = std::fs::read_to_string(&path).map_err(|error| fault(&error))?;
    let file: File = serde_json::from_str(&text).map_err(|error| fault(&error))?;
    let mut all = true;
    let mut answers = Vec::new();
    for (index, case) in file.cases.iter().enumerate() {
        let name = serde_json::from_str(case.get()).map(|named: Named| named.name);
        let shown = name.as_ref().map_or_else(|_| format!("case {index}"), Clone::clone);
        match name.map_err(|error| error.to_string()).and_then(|_| solve(case.get())) {
            Ok((w, q)) => answers.push(json!({ "name": shown, "w": w, "q": q })),
            Err(error) => {
                all = false;
                let _ = writeln!(std::io::stderr(), "{shown}: {error}");
                answers.push(json!({ "name": shown, "error": error }));
            }
        }
    }
    let mut output = std::io::stdout().lock();
    match writeln!(output, "{}", json!({ "cases": answers })).and_then(|()| output.flush()) {
        // Who closes the pipe has read what was wanted.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(format!("the answers cannot be written: {error}"))
        }
        _ => Ok(all),
    }
}

type Answer = (Vec<[f64; 3]>, Vec<[f64; 4]>);

fn solve(case: &str) -> Result<Answer, String> {
    let case: Case = serde_json::from_str(case).map_err(|error| error.to_string())?;
    let said = |error: tumbling::Error| error.to_string();
    let moments = PrincipalMoments::try_from(vector("inertia", &case.inertia)?).map_err(said)?;
    let motion = FreeMotion::new(moments, &vector("w0", &case.w0)?).map_err(said)?;
    let mut answer = Answer::default();
    for t in &case.t {
        let at = motion.at(number("t", t)?).map_err(said)?;
        let (w, q) = (at.omega, at.attitude);
        answer.0.push([w.x, w.y, w.z]);
        answer.1.push([q.w, q.i, q.j, q.k]);
    }
    Ok(answer)
}

fn vector(field: &str, [x, y, z]: &[Box<RawValue>; 3]) -> Result<Vector3<f64>, String> {
    Ok(Vector3::new(number(field, x)?, number(field, y)?, number(field, z)?))
}

/// A number, or a string that is one: finite, and zero only if it is written as zero.
fn number(field: &str, json: &RawValue) -> Result<f64, String> {
    let numeral = serde_json::from_str(json.get()).unwrap_or_else(|_| json.get().to_owned());
    let x: f64 = numeral.trim().parse().unwrap_or(f64::NAN);
    let mantissa = numeral.split(['e', 'E']).next().unwrap_or_default();
    if !x.is_finite() {
        Err(format!("`{field}` holds {json}: not a finite number"))
    } else if x == 0.0 && mantissa.contains(|c| matches!(c, '1'..='9')) {
        Err(format!("`{field}` holds {json}: nearer to zero than any number that can be computed with"))
    } else {
        Ok(x)
    }
}
