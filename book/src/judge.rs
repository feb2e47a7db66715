//! The command `judge`: an engine's record in, a verdict out.

use crate::{complain, say};
use nalgebra::Vector3;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use std::process::ExitCode;
use tumbling_judge::{Error, Options, Outcome, Verdict};

/// The moments of `--inertia A,B,C`.
pub(crate) fn moments(text: &str) -> Result<Vector3<f64>, String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|x| x.trim().parse()).collect();
    match numbers.as_deref() {
        Ok(&[a, b, c]) => Ok(Vector3::new(a, b, c)),
        _ => Err(format!("`--inertia` takes three numbers, as in 1,2,2.5, but got `{text}`.")),
    }
}

/// The error of `--threshold X`.
pub(crate) fn threshold(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if value > 0.0 && f64::is_finite(value) => Ok(value),
        _ => Err(format!("`--threshold` takes a number above zero, but got `{text}`.")),
    }
}

/// Judges a file and tells the verdict.
pub(crate) fn judge(file: &Path, options: &Options, json: bool) -> ExitCode {
    match judged(file, options) {
        Ok(verdict) => {
            if json {
                say!("{:#}", verdict.json());
            } else {
                say!("{verdict}");
            }
            if verdict.outcome == Outcome::Passed { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(wrong) => {
            complain!("error: {}: {wrong}", file.display());
            ExitCode::from(2)
        }
    }
}

fn judged(file: &Path, options: &Options) -> Result<Verdict, Error> {
    if file == Path::new("-") {
        return tumbling_judge::judge(std::io::stdin().lock(), options);
    }
    let opened = File::open(file).map_err(|source| Error::Read { line: 0, source })?;
    tumbling_judge::judge(BufReader::with_capacity(1 << 16, opened), options)
}
