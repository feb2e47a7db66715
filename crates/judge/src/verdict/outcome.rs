//! A verdict: what was found, and how it ends.

use crate::law::LawName;
use crate::laws::{Complaint, FlipCount, Gaps, Law, Point, Reset};
use crate::options::Options;
use crate::read::{FileMistake, Note};
use crate::rule::Diagnosis;
use nalgebra::Vector3;

/// The end of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Outcome {
    /// The file is sound, and every law is kept within the threshold, or within what the digits show.
    Passed,
    /// The file is not sound, or a law is broken.
    Failed,
    /// The record has nothing that is right or wrong.
    NothingToJudge,
    /// No law is broken, and too little is seen for that to say anything.
    TooShort,
}

impl Outcome {
    /// What a program calls it, and with a capital letter a reader.
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

    /// The laws that are broken by more than is allowed and than the digits leave open.
    pub fn broken(&self) -> impl Iterator<Item = &Law> {
        self.laws.iter().filter(|law| !self.options.allows(law))
    }
}
