//! The atlas: every method on every hard case, and what became of it.
//!
//! A [`Chart`] sweeps one difficulty (a turn per step, a needle's thinness, a push, a damping, or a list of
//! named cases); each of its [`Place`]s is one run of one method, judged with the rules of [`Fate`]: against
//! the exact motion, or, under torques, against a table of many digits. A run in single precision is judged
//! on the body that it is given, with rounded numbers. No time is measured, so the same machine always draws
//! the same atlas.

mod cases;
mod driven;
mod run;

pub use cases::{Case, Chart, charts};
pub use driven::DRIVEN;

use crate::story::Wrong;
use std::fmt;
use tumbling::step::Method;

/// What became of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Fate {
    /// All is within its bounds: energy and momentum to a hundredth, the count of flips, the last flip or the
    /// attitude to a tenth.
    Right,
    /// The flips are counted right, but the last comes more than a tenth of the time between flips too early
    /// or late; of a motion without flips, or under torques, the attitude is off by more than a tenth of a
    /// radian, or the momentum's direction by as much.
    Late,
    /// Energy or momentum is off by more than a hundredth, and no more than a tenth.
    Worn,
    /// The wrong number of sign changes of the watched spin.
    WrongFlips,
    /// Energy, or momentum, more than a tenth too high.
    Gained,
    /// Energy, or momentum, more than a tenth too low.
    Lost,
    /// Damping that turned the momentum round.
    Reversed,
    /// An error that says why.
    Refused,
    /// Infinite or not a number, without an error.
    NotFinite,
}

impl Precision {
    /// As Rust calls it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Single => "f32",
            Self::Double => "f64",
        }
    }
}

impl Fate {
    /// All of them, best first.
    pub const ALL: [Self; 9] = [
        Self::Right,
        Self::Late,
        Self::Worn,
        Self::WrongFlips,
        Self::Gained,
        Self::Lost,
        Self::Reversed,
        Self::Refused,
        Self::NotFinite,
    ];

    /// One word.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Late => "late",
            Self::Worn => "worn",
            Self::WrongFlips => "miscounted",
            Self::Gained => "gained",
            Self::Lost => "lost",
            Self::Reversed => "reversed",
            Self::Refused => "refused",
            Self::NotFinite => "not finite",
        }
    }
}

impl fmt::Display for Fate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.word())
    }
}

/// Who runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Runner {
    /// The closed form: the whole way at once, or between kicks where a torque acts.
    Exact,
    /// The run within a tolerance, which chooses its steps.
    Adaptive,
    /// A stepper.
    Stepper(Method),
}

impl Runner {
    /// The exact motion, the run within a tolerance, then every method.
    pub fn all() -> impl Iterator<Item = Self> {
        let methods = Method::ALL.iter().map(|&method| Self::Stepper(method));
        [Self::Exact, Self::Adaptive].into_iter().chain(methods)
    }

    /// What it is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact motion",
            Self::Adaptive => "adaptive",
            Self::Stepper(method) => method.info().name,
        }
    }
}

/// The numbers that a run computes with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    /// `f32`.
    Single,
    /// `f64`.
    Double,
}

/// A run's place in the atlas.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The chart's name.
    pub chart: &'static str,
    /// The case's name.
    pub case: String,
    /// Who ran.
    pub runner: &'static str,
    /// With which numbers.
    pub precision: Precision,
    /// What became of it.
    pub fate: Fate,
}

/// A line of the committed record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Row {
    /// The chart's name.
    pub chart: &'static str,
    /// The case's name.
    pub case: &'static str,
    /// Who ran.
    pub runner: &'static str,
    /// With which numbers.
    pub precision: Precision,
    /// What became of it.
    pub fate: Fate,
}

/// The committed record, a row for each place.
///
/// # Errors
/// A line that is none of the atlas.
pub fn recorded() -> Result<Vec<Row>, String> {
    let lines = include_str!("../record/atlas.tsv").lines().filter(|line| !line.starts_with('#')).skip(1);
    let read = |line: &'static str| {
        let fields: Vec<&str> = line.split('\t').collect();
        let [chart, case, runner, precision, fate] = fields[..] else { return None };
        let precision = [Precision::Single, Precision::Double].into_iter().find(|p| p.word() == precision)?;
        let fate = Fate::ALL.into_iter().find(|known| known.word() == fate)?;
        Some(Row { chart, case, runner, precision, fate })
    };
    lines.map(|line| read(line).ok_or_else(|| format!("not a line of the atlas: {line}"))).collect()
}

/// Runs everything, some seconds, on as many threads as there are charts.
///
/// # Errors
/// A table that cannot be read, or a case that the exact motion refuses.
pub fn atlas() -> Result<Vec<Place>, Wrong> {
    let (free, driven) = (charts()?, driven::charts()?);
    Ok(std::thread::scope(|scope| {
        let free = free.iter().map(|chart| scope.spawn(|| filled(chart.name, &chart.cases)));
        let mut runs: Vec<_> = free.collect();
        runs.extend(driven.iter().map(|(name, cases)| scope.spawn(|| filled(name, cases))));
        runs.into_iter().flat_map(|run| run.join().unwrap_or_default()).collect()
    }))
}

/// The atlas as a record: a head that says what it is, then a line for each place.
#[must_use]
pub fn written(places: &[Place]) -> String {
    let mut text = String::from(
        "# What becomes of each method of the library on each hard case, judged against the exact motion, and under \
         torques against data/atlas.json; in f32 on the body of rounded numbers.\n\
         # Made by: cargo run --release -- atlas. No time is measured.\n\
         chart\tcase\trunner\tprecision\tfate\n",
    );
    for Place { chart, case, runner, precision, fate } in places {
        text += &format!("{chart}\t{case}\t{runner}\t{}\t{fate}\n", precision.word());
    }
    text
}

/// The atlas to be read on a terminal: a table for each chart and precision, a line for each method.
#[must_use]
pub fn table(places: &[Place]) -> String {
    let mut text = String::new();
    let mut head = None;
    let mut line = None;
    for place in places {
        if head != Some((place.chart, place.precision)) {
            head = Some((place.chart, place.precision));
            let cases = places.iter().filter(|p| {
                p.chart == place.chart && p.precision == place.precision && p.runner == place.runner
            });
            text += &format!("\n\n{}, {}:\n", place.chart, place.precision.word());
            let names: Vec<&str> = cases.map(|p| p.case.as_str()).collect();
            text += &format!("{}\n", names.join(" | "));
            line = None;
        }
        if line != Some(place.runner) {
            line = Some(place.runner);
            text += &format!("\n{:28}", place.runner);
        }
        text += &format!(" {:10}", place.fate);
    }
    text.trim().to_owned()
}

/// The error that a run with a chosen step may make in a step, as a share, in `f64` and in `f32`.
const TOLERANCES: [f64; 2] = [1e-10, 1e-5];

/// Steps that such a run may take.
const BUDGET: usize = 100_000;

/// A case that a run can be judged on.
trait Judged {
    fn name(&self) -> &str;

    /// `None` where there is no such run: the closed form is of `f64` and of free bodies alone.
    fn judged(&self, runner: Runner, precision: Precision) -> Option<Fate>;
}

fn filled(chart: &'static str, cases: &[impl Judged]) -> Vec<Place> {
    let mut places = Vec::new();
    for precision in [Precision::Double, Precision::Single] {
        for runner in Runner::all() {
            for case in cases {
                let Some(fate) = case.judged(runner, precision) else { continue };
                let (case, runner) = (case.name().to_owned(), runner.name());
                places.push(Place { chart, case, runner, precision, fate });
            }
        }
    }
    places
}
