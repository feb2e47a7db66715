//! A verdict for programs: what is written as JSON, field by field.

use crate::accuracy::Accuracy;
use crate::curve::Growth;
use crate::diagnosis::{Diagnosis, Explanation};
use crate::fit::Fit;
use crate::law::{FlipCount, Law, LawName};
use crate::points::Point;
use crate::rules::Rule;
use crate::verdict::{Gaps, Reset, Verdict};
use nalgebra::Vector3;
use serde::{Serialize, Serializer};
use serde_json::Value;
use std::collections::BTreeMap;

impl Verdict {
    /// All of it as one JSON object.
    ///
    /// `curve` is the run in at most 256 points, to draw it by: an array for each of `time` (s), `energy` and
    /// `momentum` (errors as shares), `direction` (rad; null without attitudes), `phase` (periods; null
    /// where the motion has no period), and three arrays, one for each body axis, for `spin` and `exact`
    /// (rad/s). A point stands for a stretch of equally many rows: the spins are those of its first row, the
    /// errors the largest of them in size, and `spin_least`, `spin_greatest`, `exact_least` and
    /// `exact_greatest` what the spins in it reach. `flips.times` has the times of the first 512 flips. What
    /// is not finite is null.
    #[must_use]
    pub fn json(&self) -> Value {
        serde_json::to_value(self).unwrap_or_default()
    }
}

impl Serialize for Verdict {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        Report::of(self).serialize(to)
    }
}

/// A verdict as it is written.
#[derive(Serialize)]
struct Report<'a> {
    outcome: &'static str,
    reason: Option<String>,
    /// Every reason, as the terminal has them.
    reasons: Vec<String>,
    grade: Option<&'static str>,
    threshold: f64,
    thresholds: BTreeMap<&'static str, f64>,
    fit: Option<Fit>,
    engine: Option<&'a str>,
    moments: [f64; 3],
    torque: Option<[f64; 3]>,
    rows: u64,
    duration: f64,
    step: Option<f64>,
    rounding: f64,
    /// What is seen of the file besides its numbers, in the terminal's sentences.
    file: Vec<String>,
    file_mistakes: Vec<String>,
    ignored: &'a [String],
    notes: Vec<String>,
    missing: Vec<&'static str>,
    resets: Vec<ReportedReset>,
    gaps: Option<Gaps>,
    sign_changes: u64,
    laws: Vec<ReportedLaw>,
    flips: Option<&'a FlipCount>,
    separatrix: Option<[f64; 2]>,
    complaints: Vec<String>,
    diagnosis: Option<ReportedDiagnosis<'a>>,
    curve: Curve,
}

impl<'a> Report<'a> {
    fn of(verdict: &'a Verdict) -> Self {
        let record = &verdict.record;
        let own = LawName::ALL.iter().zip(verdict.options.thresholds);
        let allowed = |law: &Law| verdict.options.allowed(law.name);
        Self {
            outcome: verdict.outcome.key(),
            reason: verdict.reason(),
            reasons: verdict.reasons(),
            grade: verdict.worst().map(|law| law.growth.name()),
            threshold: verdict.options.threshold,
            thresholds: own.filter_map(|(law, most)| Some((law.key(), most?))).collect(),
            fit: verdict.fit,
            engine: record.engine.as_deref(),
            moments: verdict.moments.into(),
            torque: verdict.torque.map(Into::into),
            rows: record.rows,
            duration: record.duration,
            step: record.step,
            rounding: record.rounding,
            file: verdict.of_file().into_iter().map(|(_, sentence)| sentence).collect(),
            file_mistakes: verdict.file_mistakes.iter().map(|mistake| mistake.words()).collect(),
            ignored: &record.ignored,
            notes: words(&record.notes),
            missing: record.missing.iter().map(|law| law.key()).collect(),
            resets: verdict.resets.iter().map(ReportedReset::of).collect(),
            gaps: record.gaps,
            sign_changes: record.sign_changes,
            laws: verdict.laws.iter().map(|law| ReportedLaw::of(law, allowed(law))).collect(),
            flips: verdict.flips.as_ref(),
            separatrix: verdict.separatrix,
            complaints: words(&verdict.complaints),
            diagnosis: verdict.diagnosis.as_ref().map(ReportedDiagnosis::of),
            curve: Curve::of(&verdict.curve),
        }
    }
}

#[derive(Serialize)]
struct ReportedReset {
    line: usize,
    time: f64,
    to_rest: bool,
    to_start: bool,
    words: &'static str,
}

impl ReportedReset {
    const fn of(reset: &Reset) -> Self {
        let Reset { line, time, to_rest, to_start } = *reset;
        Self { line, time, to_rest, to_start, words: reset.words() }
    }
}

#[derive(Serialize)]
struct ReportedLaw {
    law: &'static str,
    words: &'static str,
    heading: &'static str,
    grade: &'static str,
    /// The grade, with what a second makes of the error.
    growth: String,
    rate: Option<f64>,
    most: f64,
    last: f64,
    allowed: Option<f64>,
}

impl ReportedLaw {
    fn of(law: &Law, allowed: Option<f64>) -> Self {
        Self {
            law: law.name.key(),
            words: law.name.words(),
            heading: law.name.heading(),
            grade: law.growth.name(),
            growth: law.plain(),
            rate: rate(law.growth),
            most: law.most,
            last: law.last,
            allowed,
        }
    }
}

fn rate(growth: Growth) -> Option<f64> {
    match growth {
        Growth::Rounding | Growth::Bounded | Growth::Stayed => None,
        Growth::RandomWalk { rate } | Growth::Linear { rate } | Growth::Exponential { rate } => Some(rate),
        Growth::Power { power } => Some(power),
    }
}

#[derive(Serialize)]
struct ReportedDiagnosis<'a> {
    best: ReportedExplanation,
    alike: Vec<ReportedRule>,
    second: Option<ReportedExplanation>,
    ratio: Option<f64>,
    confidence: &'static str,
    /// How the best rule is named, up to a colon and its name.
    words: &'static str,
    /// The terminal's first line of it, and the others but for the advice.
    heading: String,
    details: Vec<String>,
    steps: usize,
    share: f64,
    single: bool,
    would_decide: Option<&'static str>,
    accuracy: Option<&'a Accuracy>,
    hints: Vec<String>,
    advice: &'static str,
}

impl<'a> ReportedDiagnosis<'a> {
    fn of(diagnosis: &'a Diagnosis) -> Self {
        let mut best = ReportedExplanation::of(&diagnosis.best);
        best.rule.engines.clone_from(&diagnosis.engines);
        Self {
            best,
            alike: diagnosis.alike.iter().map(ReportedRule::of).collect(),
            second: diagnosis.second.as_ref().map(ReportedExplanation::of),
            ratio: diagnosis.ratio(),
            confidence: diagnosis.confidence.key(),
            words: diagnosis.words(),
            heading: diagnosis.heading(),
            details: diagnosis.details(),
            steps: diagnosis.steps,
            share: diagnosis.share,
            single: diagnosis.single,
            would_decide: diagnosis.would_decide(),
            accuracy: diagnosis.accuracy.as_ref(),
            hints: words(&diagnosis.hints),
            advice: diagnosis.advice.words(),
        }
    }
}

#[derive(Serialize)]
struct ReportedRule {
    rule: String,
    engines: Vec<String>,
}

impl ReportedRule {
    fn of(rule: &Rule) -> Self {
        Self { rule: rule.name(), engines: rule.engines() }
    }
}

#[derive(Serialize)]
struct ReportedExplanation {
    #[serde(flatten)]
    rule: ReportedRule,
    median: f64,
    percentile_95: f64,
}

impl ReportedExplanation {
    fn of(explanation: &Explanation) -> Self {
        let Explanation { rule, median, percentile_95 } = explanation;
        Self { rule: ReportedRule::of(rule), median: *median, percentile_95: *percentile_95 }
    }
}

/// One array for each quantity, and one for each of three components.
#[derive(Serialize)]
struct Curve {
    time: Vec<f64>,
    energy: Vec<f64>,
    momentum: Vec<f64>,
    direction: Option<Vec<f64>>,
    phase: Option<Vec<f64>>,
    spin: [Vec<f64>; 3],
    spin_least: [Vec<f64>; 3],
    spin_greatest: [Vec<f64>; 3],
    exact: [Vec<f64>; 3],
    exact_least: [Vec<f64>; 3],
    exact_greatest: [Vec<f64>; 3],
}

impl Curve {
    fn of(points: &[Point]) -> Self {
        let each = |of: fn(&Point) -> f64| points.iter().map(of).collect();
        let known = |of: fn(&Point) -> Option<f64>| points.iter().map(of).collect();
        let three = |of: fn(&Point) -> &Vector3<f64>| {
            [0, 1, 2].map(|i| points.iter().map(|point| of(point)[i]).collect())
        };
        Self {
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
        }
    }
}

/// Each in its sentence.
fn words(all: &[impl ToString]) -> Vec<String> {
    all.iter().map(ToString::to_string).collect()
}
