//! A verdict: what was found, and how it ends; and what of it is written as JSON, field by field.
#![expect(non_camel_case_types, reason = "a key of an object is the name of its type too")]

use crate::law::LawName;
use crate::laws::{FlipCount, Gaps, Law, Point, Reset};
use crate::options::Options;
use crate::read::{FileMistake, Note};
use crate::rule::{Diagnosis, Explanation, Rule};
use crate::verdict::{COLUMNS, Complaint};
use nalgebra::Vector3;
use serde::{Serialize, Serializer};
use serde_json::Value;
use std::collections::BTreeMap;

/// An object with these keys, written as it stands: a value that is built first is far more code in a module.
macro_rules! object {
    ($($key:ident: $value:expr),* $(,)?) => {{
        #[derive(Serialize)]
        struct Object<$($key),*> { $($key: $key),* }
        Object { $($key: $value),* }
    }};
}

/// The end of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Outcome {
    /// The file is sound, and every law that it shows is kept within the threshold, or within what the digits
    /// show.
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

/// Of the keys: another one where a key goes or changes its meaning, or a word is new.
pub(crate) const VERSION: u32 = 3;

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
    /// Mistakes of the file, or what may be one. What follows is of the file read so.
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
        let all = self.laws.iter().filter(|law| law.name.is_conserved());
        all.max_by(|a, b| a.growth.rank().cmp(&b.growth.rank()).then(a.most.total_cmp(&b.most)))
    }

    /// The laws that are broken by more than is allowed and than the digits leave open.
    pub fn broken(&self) -> impl Iterator<Item = &Law> {
        self.laws.iter().filter(|law| !self.options.allows(law))
    }

    /// All of it as one JSON object.
    ///
    /// `version` is that of the keys: 3 since no start is fitted, 2 since a grade may be `changed, then
    /// stayed`, and a confidence `scattered` or `repeated`. `report` is all of it in words, as
    /// [`Verdict::report`] has it; the other keys are for programs. `curve` is the run in at most 256 points,
    /// to draw it by: an array for each of `time` (s), `energy` and `momentum` (errors as shares),
    /// `direction` (rad; null without attitudes), `phase` (periods; null where the motion has no period), and
    /// three arrays, one for each body axis, for `spin` and `exact` (rad/s). A point stands for a stretch of
    /// equally many rows: the
    /// spins are those of its first row, the errors the largest of them in size, and `spin_least`,
    /// `spin_greatest`, `exact_least` and `exact_greatest` what the spins in it reach. `flips.times` has
    /// the times of the first 512 flips, and `flips.late` by how much they are late, if by a number (s), a
    /// share of the time, or both. What is not finite is null.
    #[must_use]
    pub fn json(&self) -> Value {
        serde_json::to_value(self).unwrap_or_default()
    }

    fn object(&self) -> impl Serialize {
        let record = &self.record;
        object!(
            version: VERSION,
            outcome: self.outcome.key(),
            report: self.report(),
            columns: COLUMNS,
            grade: self.worst().map(|law| law.growth.name()),
            threshold: self.options.threshold,
            thresholds: self.options.own().map(|(law, most)| (law.key(), most)).collect::<BTreeMap<_, _>>(),
            engine: &record.engine,
            moments: <[f64; 3]>::from(self.moments),
            torque: self.torque.map(<[f64; 3]>::from),
            rows: record.rows,
            duration: record.duration,
            step: record.step,
            rounding: record.rounding,
            file_mistakes: self.mistakes(),
            ignored: &record.ignored,
            notes: words(&record.notes),
            missing: record.missing.iter().map(|law| law.key()).collect::<Vec<_>>(),
            resets: self.resets.iter().map(reset).collect::<Vec<_>>(),
            gaps: record.gaps,
            sign_changes: record.sign_changes,
            laws: self.laws.iter().map(|law| reported(law, self)).collect::<Vec<_>>(),
            flips: &self.flips,
            separatrix: self.separatrix,
            complaints: words(&self.complaints),
            diagnosis: self.diagnosis.as_ref().map(diagnosed),
            curve: drawn(&self.curve),
        )
    }
}

impl Serialize for Verdict {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        self.object().serialize(to)
    }
}

fn reset(reset: &Reset) -> impl Serialize {
    let Reset { line, time, to_rest, to_start } = reset;
    object!(line: line, time: time, to_rest: to_rest, to_start: to_start, words: reset.words())
}

fn reported(law: &Law, verdict: &Verdict) -> impl Serialize {
    object!(
        law: law.name.key(),
        words: law.name.words(),
        grade: law.growth.name(),
        growth: law.plain(),
        rate: law.growth.rate(),
        most: law.most,
        last: law.last,
        allowed: verdict.options.allowed(law.name),
    )
}

fn diagnosed(diagnosis: &Diagnosis) -> impl Serialize {
    object!(
        best: explained(&diagnosis.best, diagnosis.engines.clone()),
        alike: diagnosis.alike.iter().map(ruled).collect::<Vec<_>>(),
        second: diagnosis.second.as_ref().map(|second| explained(second, second.rule.engines())),
        ratio: diagnosis.ratio(),
        confidence: diagnosis.confidence.key(),
        words: diagnosis.words(),
        steps: diagnosis.steps,
        share: diagnosis.share,
        single: diagnosis.single,
        would_decide: diagnosis.would_decide(),
        error: diagnosis.error,
        jumps: &diagnosis.jumps,
        advice: diagnosis.advice.iter().map(|advice| advice.words).collect::<Vec<_>>().join(" "),
        chapter: diagnosis.advice.iter().find_map(|advice| advice.chapter),
    )
}

fn ruled(rule: &Rule) -> impl Serialize {
    object!(rule: rule.name(), engines: rule.engines())
}

fn explained(found: &Explanation, engines: Vec<String>) -> impl Serialize {
    let Explanation { rule, median, percentile_95 } = *found;
    object!(rule: rule.name(), engines: engines, median: median, percentile_95: percentile_95)
}

/// One array for each quantity, and one for each of three components.
fn drawn(points: &[Point]) -> impl Serialize {
    let each = |of: fn(&Point) -> f64| points.iter().map(of).collect::<Vec<_>>();
    let known = |of: fn(&Point) -> Option<f64>| points.iter().map(of).collect::<Option<Vec<_>>>();
    let three = |of: fn(&Point) -> &Vector3<f64>| {
        [0, 1, 2].map(|i| points.iter().map(|point| of(point)[i]).collect::<Vec<_>>())
    };
    object!(
        time: each(|point| point.time),
        energy: each(|point| point.energy),
        momentum: each(|point| point.momentum),
        direction: known(|point| point.direction),
        phase: known(|point| point.phase),
        spin: three(|point| &point.spin),
        spin_least: three(|point| &point.spin_range[0]),
        spin_greatest: three(|point| &point.spin_range[1]),
        exact: three(|point| &point.exact),
        exact_least: three(|point| &point.exact_range[0]),
        exact_greatest: three(|point| &point.exact_range[1]),
    )
}

/// Each in its sentence.
fn words(all: &[impl ToString]) -> Vec<String> {
    all.iter().map(ToString::to_string).collect()
}
