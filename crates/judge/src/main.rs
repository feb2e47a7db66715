//! Judges how an engine turns a free body: `cargo run -p tumbling-judge -- run.csv`.

use clap::Parser;
use nalgebra::Vector3;
use std::fs::File;
use std::io::{BufRead, BufReader, ErrorKind, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use tumbling_judge::{Error, LawName, Motion, Options, Outcome, compare, judge};

/// Judges how an engine turns a free body, by a record of its motion
#[derive(Debug, Parser)]
#[command(version, after_help = include_str!("about.txt"))]
struct Arguments {
    /// The record, comma-separated values; - for the standard input
    file: PathBuf,
    /// More records of the same object in other descriptions, to be compared with the first
    others: Vec<PathBuf>,
    /// Principal moments about the body's x, y and z, kg m2; used in place of the record's
    #[arg(long, value_name = "A,B,C", value_parser = moments, allow_hyphen_values = true)]
    inertia: Option<Vector3<f64>>,
    /// Largest error allowed in every law, or in LAW (default: 0.01)
    #[arg(long, value_name = "[LAW=]X", value_delimiter = ',', value_parser = limit, allow_hyphen_values = true)]
    threshold: Vec<Limit>,
    /// Print the verdict as one JSON object
    #[arg(long)]
    json: bool,
}

/// The largest error allowed of one law, or of all.
type Limit = (Option<LawName>, f64);

/// The moments of `--inertia A,B,C`.
fn moments(text: &str) -> Result<Vector3<f64>, Box<dyn std::error::Error + Send + Sync>> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|x| x.trim().parse()).collect();
    match numbers.as_deref() {
        Ok(&[a, b, c]) => Ok(tumbling::PrincipalMoments::new(a, b, c)?.vector()),
        _ => Err("give three numbers, as in 1,2,2.5".into()),
    }
}

/// A part of `--threshold X,LAW=X`.
fn limit(text: &str) -> Result<Limit, String> {
    let (law, number) = match text.split_once('=') {
        Some((law, number)) => (Some(law.trim()), number),
        None => (None, text),
    };
    let law = law.map(|key| {
        let known = LawName::ALL.into_iter().find(|law| law.key() == key);
        known.ok_or_else(|| format!("the laws are {}", LawName::ALL.map(LawName::key).join(", ")))
    });
    match number.trim().parse() {
        Ok(value) if value > 0.0 && f64::is_finite(value) => Ok((law.transpose()?, value)),
        _ => Err("give a number above zero".into()),
    }
}

impl Arguments {
    fn options(&self) -> Options {
        let start = Options { inertia: self.inertia, ..Options::default() };
        self.threshold.iter().fold(start, |options, &(law, most)| match law {
            None => Options { threshold: most, ..options },
            Some(law) => options.with(law, most),
        })
    }

    /// What is to be printed, and whether the record passes.
    fn judged(&self) -> Result<(String, bool), String> {
        let verdict = open(&self.file).and_then(|source| judge(source, &self.options()));
        let verdict = verdict.map_err(|wrong| format!("{}: {}", self.file.display(), mended(&wrong)))?;
        let json = self.json.then(|| format!("{:#}\n", verdict.json()));
        Ok((json.unwrap_or_else(|| format!("{verdict}\n")), verdict.outcome == Outcome::Passed))
    }

    /// What is to be printed, and whether all records are one motion.
    fn compared(&self) -> Result<(String, bool), String> {
        let mut all = Vec::new();
        for file in [&self.file].into_iter().chain(&self.others) {
            let read = open(file).and_then(|source| Motion::read(source, &self.options()));
            let name = file.display().to_string();
            all.push((name.clone(), read.map_err(|wrong| format!("{name}: {}", mended(&wrong)))?));
        }
        if self.threshold.iter().any(|limit| limit.0.is_some()) {
            return Err("records are compared with one --threshold X, not with one for each law".into());
        }
        let threshold = self.threshold.last().map(|limit| limit.1);
        let comparison = compare(&all, threshold).map_err(|wrong| wrong.to_string())?;
        let json = self.json.then(|| format!("{:#}\n", comparison.json()));
        Ok((json.unwrap_or_else(|| comparison.to_string()), comparison.others.is_empty()))
    }
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let printed = if arguments.others.is_empty() { arguments.judged() } else { arguments.compared() };
    match printed.and_then(|(text, holds)| print(&text).map(|()| holds)) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(wrong) => {
            let _ = writeln!(std::io::stderr().lock(), "error: {wrong}");
            ExitCode::from(2)
        }
    }
}

/// With the option that corrects it, where there is one.
fn mended(wrong: &Error) -> String {
    format!("{wrong}{}", if matches!(wrong, Error::NoMoments) { " (--inertia A,B,C)" } else { "" })
}

fn print(text: &str) -> Result<(), String> {
    let mut out = std::io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    let wrong = written.err().filter(|wrong| wrong.kind() != ErrorKind::BrokenPipe);
    wrong.map_or(Ok(()), |wrong| Err(format!("the verdict could not be written: {wrong}")))
}

fn open(file: &Path) -> Result<Box<dyn BufRead>, Error> {
    if file == Path::new("-") {
        return Ok(Box::new(std::io::stdin().lock()));
    }
    let opened = File::open(file).map_err(|source| Error::Read { line: 0, source })?;
    Ok(Box::new(BufReader::with_capacity(1 << 16, opened)))
}

#[cfg(test)]
mod tests {
    use super::*;
    fn options(words: &str) -> Result<Options, String> {
        let arguments = Arguments::try_parse_from(words.split(' ')).map_err(|e| e.to_string())?;
        Ok(arguments.options())
    }

    #[test]
    fn limits_and_moments_are_read() {
        assert_eq!(options("judge run.csv"), Ok(Options::default()));
        let given = options("judge - --inertia 1,2,2.5 --threshold=1e-6 --json").unwrap();
        assert_eq!((given.inertia, given.threshold), (Some(Vector3::new(1.0, 2.0, 2.5)), 1e-6));
        let given = options("judge x --threshold 0.5,energy=1e-6,phase=2").unwrap();
        let allowed = [LawName::Energy, LawName::Momentum, LawName::Phase].map(|law| given.allowed(law));
        assert_eq!(allowed, [Some(1e-6), Some(0.5), Some(2.0)]);
        assert_eq!(limit(" phase = 2 "), Ok((Some(LawName::Phase), 2.0)));
    }

    #[test]
    fn a_value_that_cannot_be_taken_is_answered_with_what_can() {
        for (words, answer) in [
            ("judge a --inertia 1,x,2", "three numbers"),
            ("judge a --threshold -1", "above zero"),
            ("judge a --threshold energy=", "above zero"),
            ("judge a --threshold enrgy=1", "the laws are energy, "),
        ] {
            let error = options(words).unwrap_err();
            assert!(error.contains(answer), "{words}: {error}");
        }
    }
}
