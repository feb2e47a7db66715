//! Free motions in closed form: reads moments, initial spin and times from a JSON file, and prints the spin
//! (body axes, rad/s) and the attitude (body to world, scalar part first) at each time.
//!
//! `cargo run --example free_motion -- tests/data/free-motion.json`
//!
//! The file holds `{"cases": [{"name": ..., "inertia": [3], "w0": [3], "t": [...]}]}`, its numbers as numbers
//! or as decimal strings. A case that cannot be answered has an `error` in place of its answer, and the
//! program ends with 1 after answering the others.

use nalgebra::Vector3;
use serde_json::{Value, json};
use std::error::Error;
use std::process::ExitCode;
use tumbling::PrincipalMoments;
use tumbling::exact::FreeMotion;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let file = std::env::args_os().nth(1).ok_or("usage: free_motion CASES.json")?;
    let cases: Value = serde_json::from_str(&std::fs::read_to_string(file)?)?;
    let cases = cases["cases"].as_array().ok_or("no list of `cases`")?;
    let answers = cases.iter().map(|case| {
        solve(case).unwrap_or_else(|error| json!({ "name": case["name"], "error": error.to_string() }))
    });
    let answers: Vec<_> = answers.collect();
    println!("{}", json!({ "cases": answers }));
    Ok(ExitCode::from(u8::from(answers.iter().any(|answer| answer.get("error").is_some()))))
}

fn solve(case: &Value) -> Result<Value, Box<dyn Error>> {
    let vector = |field: &str| match numbers(&case[field])?[..] {
        [x, y, z] => Ok(Vector3::new(x, y, z)),
        _ => Err(format!("`{field}` does not hold three numbers")),
    };
    let motion = FreeMotion::new(PrincipalMoments::try_from(vector("inertia")?)?, &vector("w0")?)?;
    let (mut w, mut q) = (Vec::new(), Vec::new());
    for t in numbers(&case["t"])? {
        let at = motion.at(t)?;
        w.push(at.omega.as_slice().to_vec());
        q.push([at.attitude.w, at.attitude.i, at.attitude.j, at.attitude.k]);
    }
    Ok(json!({ "name": case["name"], "w": w, "q": q }))
}

/// A list of numbers, each as a number or as a string.
fn numbers(list: &Value) -> Result<Vec<f64>, String> {
    let list = list.as_array().ok_or_else(|| format!("{list} is no list of numbers"))?;
    let number = |x: &Value| x.as_f64().or_else(|| x.as_str()?.parse().ok());
    list.iter().map(|x| number(x).ok_or_else(|| format!("{x} is no number"))).collect()
}
