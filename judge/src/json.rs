//! A verdict for programs.

use crate::curve::Growth;
use crate::diagnosis::{Diagnosis, Explanation, Sure};
use crate::verdict::{Outcome, Verdict};
use serde_json::{Value, json};

impl Verdict {
    /// All of it as one JSON object.
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
            .map(|reset| json!({"line": reset.line, "time": reset.time, "to_rest": reset.to_rest}))
            .collect();
        json!({
            "outcome": match self.outcome {
                Outcome::Passed => "passed",
                Outcome::Failed => "failed",
                Outcome::NothingToJudge => "nothing to judge",
            },
            "grade": self.worst().map(|law| law.growth.name()),
            "threshold": self.threshold,
            "engine": self.engine,
            "moments": self.moments.as_slice(),
            "torque": self.torque.as_ref().map(|torque| torque.as_slice().to_vec()),
            "rows": self.rows,
            "duration": self.duration,
            "step": self.step,
            "rounding": self.rounding,
            "misread": self.misread.iter().map(|x| x.words()).collect::<Vec<_>>(),
            "resets": resets,
            "gaps": self.gaps.map(|gaps| json!({"count": gaps.count, "line": gaps.line, "longest": gaps.longest})),
            "sign_changes": self.sign_changes,
            "laws": laws,
            "flips": self.flips.as_ref().map(|flips| json!({
                "found": flips.found,
                "exact": flips.exact,
                "first": flips.first,
                "first_exact": flips.first_exact,
                "apart": flips.apart,
                "turned_over": flips.turned_over,
            })),
            "separatrix": self.separatrix,
            "complaints": self.complaints,
            "diagnosis": self.diagnosis.as_ref().map(diagnosis),
        })
    }
}

fn rate(growth: Growth) -> Option<f64> {
    match growth {
        Growth::Rounding | Growth::Bounded => None,
        Growth::RandomWalk { rate } | Growth::Linear { rate } | Growth::Exponential { rate } => Some(rate),
        Growth::Power { power } => Some(power),
    }
}

fn diagnosis(diagnosis: &Diagnosis) -> Value {
    let explanation = |x: &Explanation| {
        json!({
            "rule": x.rule.name(),
            "engines": x.rule.engines(),
            "median": x.middle,
            "percentile_95": x.most,
        })
    };
    json!({
        "best": explanation(&diagnosis.best),
        "alike": diagnosis
            .alike
            .iter()
            .map(|rule| json!({"rule": rule.name(), "engines": rule.engines()}))
            .collect::<Vec<_>>(),
        "second": diagnosis.second.as_ref().map(explanation),
        "ratio": diagnosis.ratio(),
        "sure": match diagnosis.sure {
            Sure::ToRounding => "to rounding",
            Sure::MostSteps => "most steps",
            Sure::Near => "near",
            Sure::NoneFits => "none fits",
        },
        "steps": diagnosis.steps,
        "hints": diagnosis.hints,
        "advice": if diagnosis.sure == Sure::NoneFits { "" } else { diagnosis.best.rule.advice() },
    })
}
