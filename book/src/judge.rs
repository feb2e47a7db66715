//! The command `judge`: an engine's record in, a verdict out.

use crate::{complain, nearest};
use nalgebra::Vector3;
use std::fs::File;
use std::io::{BufReader, Write as _};
use std::path::Path;
use std::process::ExitCode;
use tumbling_judge::{Error, LawName, Options, Outcome, Verdict};

/// The options that go with `judge`.
pub(crate) const OPTIONS: [&str; 6] = ["--help", "--inertia", "--threshold", "--fit", "--svg", "--json"];

pub(crate) const HELP: &str = "\
Holds an engine's record of a free body against the exact motion, and says which rule made it.

    cargo run --release -- judge FILE [OPTIONS]

FILE (- for the standard input) has a line of column names, then rows of numbers:
    t (s), or step with a comment `# dt: 1/60`
    qw,qx,qy,qz     attitude, body to world
    wx,wy,wz        spin in body axes, rad/s; or wxw,wyw,wzw in world axes;
                    or momentum, lx,ly,lz or lxw,lyw,lzw (kg m2/s)
The axes of the body are its principal ones, with the moments in their order: a comment `# inertia: A B C`
names them, or --inertia. Write all digits (17 of double precision, 9 of single).

    --inertia A,B,C      principal moments about the body's x, y and z, kg m2
    --threshold X        the most error allowed of a law, beside the first row (0.01 if not given)
    --threshold LAW=X,LAW=X
                         of energy, momentum, direction, unit, separatrix; and of phase and consistency,
                         which are held to nothing otherwise
    --fit [N]            take as the start the spin whose exact motion comes nearest to the first N rows
                         (64 if not given), and not the first row's alone: where it has few digits
    --svg OUT            draw the verdict into the file OUT
    --json               the verdict as one JSON object:
                         outcome (passed, failed, nothing to judge, too short to judge), complaints,
                         laws (law, grade, rate, most, last), flips, separatrix (2 E I2 / L^2, first and last),
                         misread, resets, gaps, untold, sign_changes, rounding,
                         diagnosis (sure: to rounding, most steps, near, too few digits or none fits; best, alike,
                         second, ratio, hints, advice), curve (the run in at most 256 points), and what was read
    --help               this text

Exit code: 0 where the record passes, 1 where it fails or there is nothing or too little to judge, 2 where it
cannot be read.

Errors are beside the first row: of energy and |L| a share, of a direction rad. 2 E I2 / L^2 (I2 the middle
moment) is below 1 where the spin goes round the largest moment's axis, above 1 where round the smallest's.
Phase is how far the spin is ahead of the exact one, in times round its closed curve.";

/// The moments of `--inertia A,B,C`.
pub(crate) fn moments(text: &str) -> Result<Vector3<f64>, String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|x| x.trim().parse()).collect();
    match numbers.as_deref() {
        Ok(&[a, b, c]) => Ok(Vector3::new(a, b, c)),
        _ => Err(format!("`--inertia` takes three numbers, as in 1,2,2.5, but got `{text}`.")),
    }
}

/// The limits of `--threshold X` or `--threshold LAW=X,LAW=X`.
pub(crate) fn threshold(text: &str, options: &mut Options) -> Result<(), String> {
    for part in text.split(',').map(str::trim) {
        let (law, number) = match part.split_once('=') {
            Some((law, number)) => (Some(law.trim()), number.trim()),
            None => (None, part),
        };
        let value = match number.parse() {
            Ok(value) if value > 0.0 && f64::is_finite(value) => value,
            _ => return Err(format!("`--threshold` takes a number above zero, but got `{number}`.")),
        };
        match law {
            None => options.threshold = value,
            Some(key) => {
                let keys = LawName::ALL.map(LawName::key);
                let law = LawName::ALL.into_iter().find(|law| law.key() == key).ok_or_else(|| {
                    let near = nearest::perhaps(key, keys);
                    format!("`--threshold` knows no law `{key}`.{near} There are {}.", keys.join(", "))
                })?;
                *options = options.with(law, value);
            }
        }
    }
    Ok(())
}

/// How many rows `--fit` takes where it does not say.
pub(crate) const FITTED: usize = 64;

/// The rows of `--fit N`.
pub(crate) fn fit(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(rows) if rows >= 2 => Ok(rows),
        _ => Err(format!("`--fit` takes a number of rows, two at least, but got `{text}`.")),
    }
}

/// Judges a file and tells the verdict.
pub(crate) fn judge(file: &Path, options: &Options, json: bool, svg: Option<&Path>) -> ExitCode {
    match judged(file, options) {
        Ok(verdict) => {
            if let Some(out) = svg
                && let Err(wrong) = draw(&verdict, out)
            {
                complain!("error: {}: {wrong}", out.display());
                return ExitCode::from(2);
            }
            let text = if json { format!("{:#}\n", verdict.json()) } else { format!("{verdict}\n") };
            let mut out = std::io::stdout().lock();
            if let Err(wrong) = out.write_all(text.as_bytes()).and_then(|()| out.flush())
                && wrong.kind() != std::io::ErrorKind::BrokenPipe
            {
                complain!("error: the verdict could not be written: {wrong}");
                return ExitCode::from(2);
            }
            if verdict.outcome == Outcome::Passed { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(wrong) => {
            complain!("error: {}: {wrong}", file.display());
            ExitCode::from(2)
        }
    }
}

fn draw(verdict: &Verdict, out: &Path) -> Result<(), Box<dyn std::error::Error>> {
    Ok(std::fs::write(out, tumbling_figures::verdict(verdict)?)?)
}

fn judged(file: &Path, options: &Options) -> Result<Verdict, Error> {
    if file == Path::new("-") {
        return tumbling_judge::judge(std::io::stdin().lock(), options);
    }
    let opened = File::open(file).map_err(|source| Error::Read { line: 0, source })?;
    tumbling_judge::judge(BufReader::with_capacity(1 << 16, opened), options)
}
