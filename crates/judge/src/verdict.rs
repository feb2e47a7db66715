//! A verdict: what is allowed, what was found, and how it ends.

use crate::diagnosis::Diagnosis;
use crate::error::Error;
use crate::findings::{Complaint, Note};
use crate::fit::Fit;
use crate::law::{FlipCount, Law, LawName};
use crate::points::Point;
use crate::reading::FileMistake;
use crate::thresholds::ALLOWED;
use nalgebra::Vector3;
use serde::Serialize;

/// What the judge is to go by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Principal moments, kg m²; they take precedence over what the record says.
    pub inertia: Option<Vector3<f64>>,
    /// The most that a law may be broken by: of energy and momentum as a share, of a direction in rad.
    pub threshold: f64,
    /// Limits for single laws, in place of `threshold`. A limit for phase (in periods) or for consistency
    /// makes that law count. Without one, a phase fails that is off by more than a quarter of a period and a
    /// quarter of the periods of the exact motion.
    pub thresholds: [Option<f64>; 7],
    /// To start from the exact motion that comes nearest to this number of rows, not from the first
    /// alone.
    pub fit: Option<usize>,
}

impl Options {
    /// What is allowed of a law; nothing where it is not held to anything.
    #[must_use]
    pub fn allowed(&self, law: LawName) -> Option<f64> {
        let own = LawName::ALL.iter().position(|name| *name == law).and_then(|i| self.thresholds[i]);
        own.or_else(|| law.is_conserved().then_some(self.threshold))
    }

    /// With a limit of its own for a law.
    #[must_use]
    pub fn with(mut self, law: LawName, threshold: f64) -> Self {
        if let Some(i) = LawName::ALL.iter().position(|name| *name == law) {
            self.thresholds[i] = Some(threshold);
        }
        self
    }
}

impl Options {
    /// Limits that are numbers above zero.
    pub(crate) fn checked(&self) -> Result<(), Error> {
        let own =
            LawName::ALL.iter().zip(self.thresholds).filter_map(|(law, most)| Some((Some(*law), most?)));
        match std::iter::once((None, self.threshold))
            .chain(own)
            .find(|(_, most)| most.is_nan() || *most <= 0.0)
        {
            Some((law, value)) => Err(Error::Threshold { law, value }),
            None => Ok(()),
        }
    }
}

impl Default for Options {
    fn default() -> Self {
        Self { inertia: None, threshold: ALLOWED, thresholds: [None; 7], fit: None }
    }
}

/// The end of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Outcome {
    /// The file is sound, and every law is kept within the threshold.
    Passed,
    /// The file is not sound, or a law is broken.
    Failed,
    /// The record has nothing that is right or wrong.
    NothingToJudge,
    /// No law is broken, and too little is seen for that to say anything.
    TooShort,
}

impl Outcome {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Passed, Self::Failed, Self::NothingToJudge, Self::TooShort];

    /// What a program calls it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::NothingToJudge => "nothing to judge",
            Self::TooShort => "too short to judge",
        }
    }
}

/// A row at which the motion starts anew.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reset {
    /// Its line in the file.
    pub line: usize,
    /// Its time, s.
    pub time: f64,
    /// Whether the body was put to rest.
    pub to_rest: bool,
    /// Whether it was put back to its start.
    pub to_start: bool,
}

/// Steps that have no row.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Gaps {
    /// How often rows are missing.
    pub count: u64,
    /// The first line after such a place.
    pub line: usize,
    /// How many steps the longest is.
    pub longest: f64,
}

/// A record, as it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    /// Who made it, if it says so.
    pub engine: Option<String>,
    /// Rows.
    pub rows: u64,
    /// From the first row to the last that was judged, s.
    pub duration: f64,
    /// The step, s; none where it varies.
    pub step: Option<f64>,
    /// The rounding of its numbers, relative to 1.
    pub rounding: f64,
    /// Whether it has attitudes.
    pub has_attitude: bool,
    /// Columns that were not read.
    pub ignored: Vec<String>,
    /// What was made of the file besides its rows.
    pub notes: Vec<Note>,
    /// Laws of which it has nothing: no attitude, or no spin.
    pub missing: Vec<LawName>,
    /// Missing rows.
    pub gaps: Option<Gaps>,
    /// Times at which the quaternion changes its sign and not its attitude.
    pub sign_changes: u64,
}

/// A verdict.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// The outcome.
    pub outcome: Outcome,
    /// The record.
    pub record: Recording,
    /// Principal moments, kg m².
    pub moments: Vector3<f64>,
    /// A torque constant in the world, N m, that the record names.
    pub torque: Option<Vector3<f64>>,
    /// Mistakes of the file. What follows is of the file with these put right.
    pub file_mistakes: Vec<FileMistake>,
    /// Where the motion starts anew; the laws are followed up to the first.
    pub resets: Vec<Reset>,
    /// The laws.
    pub laws: Vec<Law>,
    /// Flips, for a body that can.
    pub flips: Option<FlipCount>,
    /// `2 E I2 / L²` in the first row and in the last, for a body with three different moments.
    pub separatrix: Option<[f64; 2]>,
    /// Which rule explains it.
    pub diagnosis: Option<Diagnosis>,
    /// What failed and is no law.
    pub complaints: Vec<Complaint>,
    /// What was allowed.
    pub options: Options,
    /// How the start was fitted, if it was.
    pub fit: Option<Fit>,
    /// Whether the body turns so far that no `f64` says where in its motion it should be.
    pub untraceable: bool,
    /// The run in at most 256 points, to draw it by.
    pub curve: Vec<Point>,
}

impl Verdict {
    /// The conserved law that is kept worst.
    #[must_use]
    pub fn worst(&self) -> Option<&Law> {
        self.laws
            .iter()
            .filter(|law| law.name.is_conserved())
            .max_by(|a, b| a.growth.rank().cmp(&b.growth.rank()).then(a.most.total_cmp(&b.most)))
    }

    /// The laws that are broken by more than is allowed.
    pub fn broken(&self) -> impl Iterator<Item = &Law> {
        self.laws
            .iter()
            .filter(|law| self.options.allowed(law.name).is_some_and(|most| law.most.abs() > most))
    }
}
