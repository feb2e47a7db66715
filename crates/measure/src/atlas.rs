//! The atlas: every method on every hard case, and what became of it.
//!
//! A [`Chart`] sweeps one difficulty (a turn per step, a needle's thinness, a push, a damping, or a list of
//! named cases); each of its [`Place`]s is one run of one method, judged against the exact motion with the
//! rules of [`Fate`]. No time is measured, so the same machine always draws the same atlas.

mod cases;
mod run;

pub use cases::{Case, Chart, charts};

use std::fmt;
use tumbling::Error;
use tumbling::step::Method;

/// What became of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Fate {
    /// All is within its bounds: energy and momentum to a hundredth, the count of flips, the last flip or the
    /// attitude to a tenth.
    Right,
    /// The flips are counted right, but the last comes more than a tenth of the time between flips too early
    /// or late; of a motion without flips, the attitude is off by more than a tenth of a radian.
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
    /// A stepper.
    Stepper(Method),
}

impl Runner {
    /// The exact motion, then every method.
    pub fn all() -> impl Iterator<Item = Self> {
        std::iter::once(Self::Exact).chain(Method::ALL.iter().map(|&method| Self::Stepper(method)))
    }

    /// What it is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact motion",
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
/// None, unless the exact motion refuses one of the cases.
pub fn atlas() -> Result<Vec<Place>, Error> {
    let charts = charts()?;
    Ok(std::thread::scope(|scope| {
        let runs: Vec<_> = charts.iter().map(|chart| scope.spawn(|| filled(chart))).collect();
        runs.into_iter().flat_map(|run| run.join().unwrap_or_default()).collect()
    }))
}

/// The atlas as a record: a head that says what it is, then a line for each place.
#[must_use]
pub fn written(places: &[Place]) -> String {
    let mut text = String::from(
        "# What becomes of each method of the library on each hard case, judged against the exact motion.\n\
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

fn filled(chart: &Chart) -> Vec<Place> {
    let mut places = Vec::new();
    for precision in [Precision::Double, Precision::Single] {
        for runner in Runner::all() {
            // The closed form is of f64 alone.
            if runner == Runner::Exact && precision == Precision::Single {
                continue;
            }
            for case in &chart.cases {
                let fate = case.judged(runner, precision);
                let (chart, case, runner) = (chart.name, case.name.clone(), runner.name());
                places.push(Place { chart, case, runner, precision, fate });
            }
        }
    }
    places
}
