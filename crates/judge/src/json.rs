//! A verdict for programs.

use crate::curve::Growth;
use crate::diagnosis::{Diagnosis, Explanation};
use crate::law::LawName;
use crate::points::Point;
use crate::verdict::Verdict;
use nalgebra::Vector3;
use serde_json::{Map, Value, json};

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
        let laws: Vec<Value> = self
            .laws
            .iter()
            .map(|law| {
                json!({
                    "law": law.name.key(),
                    "grade": law.growth.name(),
                    "rate": rate(law.growth),
                    "most": law.most,
                    "last": law.last,
                })
            })
            .collect();
        let resets: Vec<Value> = self
            .resets
            .iter()
            .map(|reset| json!({"line": reset.line, "time": reset.time, "to_rest": reset.to_rest, "to_start": reset.to_start}))
            .collect();
        json!({
            "outcome": self.outcome.key(),
            "reason": self.reason(),
            "grade": self.worst().map(|law| law.growth.name()),
            "threshold": self.options.threshold,
            "thresholds": thresholds(self),
            "fit": self.fit.map(|fit| json!({"rows": fit.rows, "left": fit.left, "moved": fit.moved})),
            "engine": self.record.engine,
            "moments": self.moments.as_slice(),
            "torque": self.torque.as_ref().map(|torque| torque.as_slice().to_vec()),
            "rows": self.record.rows,
            "duration": self.record.duration,
            "step": self.record.step,
            "rounding": self.record.rounding,
            "misread": self.file_mistakes.iter().map(|x| x.words()).collect::<Vec<_>>(),
            "ignored": self.record.ignored,
            "notes": words(&self.record.notes),
            "untold": self.record.missing.iter().map(|law| law.key()).collect::<Vec<_>>(),
            "resets": resets,
            "gaps": self.record.gaps.map(|gaps| json!({"count": gaps.count, "line": gaps.line, "longest": gaps.longest})),
            "sign_changes": self.record.sign_changes,
            "laws": laws,
            "flips": self.flips.as_ref().map(|flips| json!({
                "found": flips.found,
                "exact": flips.exact,
                "first": flips.first,
                "first_exact": flips.first_exact,
                "apart": flips.apart,
                "turned_over": flips.turned_over,
                "times": flips.times,
            })),
            "separatrix": self.separatrix,
            "complaints": words(&self.complaints),
            "diagnosis": self.diagnosis.as_ref().map(diagnosis),
            "curve": curve(&self.curve),
        })
    }
}

/// Each in its sentence.
fn words(all: &[impl ToString]) -> Vec<String> {
    all.iter().map(ToString::to_string).collect()
}

/// The limits that laws have of their own.
fn thresholds(verdict: &Verdict) -> Value {
    let own = LawName::ALL.iter().zip(verdict.options.thresholds);
    own.filter_map(|(name, most)| Some((name.key().to_string(), json!(most?)))).collect::<Map<_, _>>().into()
}

/// One array for each quantity, and one for each of three components.
fn curve(points: &[Point]) -> Value {
    let each = |of: fn(&Point) -> Option<f64>| points.iter().map(of).collect::<Option<Vec<f64>>>();
    let three = |of: fn(&Point) -> &Vector3<f64>| {
        [0, 1, 2].map(|i| points.iter().map(|point| of(point)[i]).collect::<Vec<f64>>())
    };
    json!({
        "time": each(|point| Some(point.time)),
        "energy": each(|point| Some(point.energy)),
        "momentum": each(|point| Some(point.momentum)),
        "direction": each(|point| point.direction),
        "phase": each(|point| point.phase),
        "spin": three(|point| &point.spin),
        "spin_least": three(|point| &point.spin_range[0]),
        "spin_greatest": three(|point| &point.spin_range[1]),
        "exact": three(|point| &point.exact),
        "exact_least": three(|point| &point.exact_range[0]),
        "exact_greatest": three(|point| &point.exact_range[1]),
    })
}

fn rate(growth: Growth) -> Option<f64> {
    match growth {
        Growth::Rounding | Growth::Bounded | Growth::Stayed => None,
        Growth::RandomWalk { rate } | Growth::Linear { rate } | Growth::Exponential { rate } => Some(rate),
        Growth::Power { power } => Some(power),
    }
}

fn diagnosis(diagnosis: &Diagnosis) -> Value {
    let explanation = |x: &Explanation| {
        json!({
            "rule": x.rule.name(),
            "engines": x.rule.engines(),
            "median": x.median,
            "percentile_95": x.percentile_95,
        })
    };
    let mut best = explanation(&diagnosis.best);
    best["engines"] = diagnosis.engines.clone().into();
    json!({
        "best": best,
        "alike": diagnosis
            .alike
            .iter()
            .map(|rule| json!({"rule": rule.name(), "engines": rule.engines()}))
            .collect::<Vec<_>>(),
        "second": diagnosis.second.as_ref().map(explanation),
        "ratio": diagnosis.ratio(),
        "sure": diagnosis.confidence.key(),
        "steps": diagnosis.steps,
        "share": diagnosis.share,
        "single": diagnosis.single,
        "would_decide": diagnosis.would_decide(),
        "accuracy": diagnosis.accuracy.map(|x| json!({"order": x.order, "controlled": x.controlled, "per_second": x.per_second})),
        "hints": words(&diagnosis.hints),
        "advice": diagnosis.advice.words(),
    })
}
