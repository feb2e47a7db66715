//! A diagnosis in words.

use crate::rule::accuracy::Accuracy;
use crate::rule::confidence::Confidence;
use crate::rule::diagnosis::{Diagnosis, Explanation};
use crate::rule::rules::Rule;
use crate::thresholds::RULES_NAMED;
use std::fmt;

impl Confidence {
    /// How a rule is named with this confidence, up to a colon and its name.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::ToRounding => "Every step is made by",
            Self::MostSteps => "Most steps, but not all, are made by",
            Self::Near => "Most like",
            Self::FewDigits => "Too few digits to name the rule by its single steps. One that fits is",
            Self::SmallErrors => {
                "The errors of the steps are too near to rounding to name the rule. One that fits is"
            }
            Self::FewSteps => {
                "Too few rows follow one another by one step to name the rule. One that fits those is"
            }
            Self::Accurate => "An accurate rule, none of those known. Nearest is",
            Self::NoneFits => "None of the known rules fits. Nearest is",
        }
    }
}

impl Diagnosis {
    /// How the best rule is named, up to a colon and its name.
    #[must_use]
    pub const fn words(&self) -> &'static str {
        match (self.confidence, self.single) {
            (Confidence::ToRounding, true) => "To the rounding of single precision every step is that of",
            (Confidence::ToRounding, false) if self.few => "To the record's rounding every step is that of",
            (confidence, _) => confidence.words(),
        }
    }

    /// In a line: the rule, and how sure it is; or how many fit.
    pub(crate) fn heading(&self) -> String {
        if self.confidence == Confidence::FewDigits {
            let count = 1 + self.alike.len();
            return format!(
                "Too few digits to name the rule by its single steps: they fit {count} rules alike"
            );
        }
        let names: Vec<String> = self.leading().into_iter().map(Rule::name).collect();
        format!("{}: {}", self.words(), names.join("; or, with the same steps here: "))
    }

    /// What else there is to say, but for the advice.
    pub(crate) fn details(&self) -> Vec<String> {
        let mut all = Vec::new();
        if self.confidence == Confidence::FewDigits {
            all.extend(self.residuals());
            all.extend(self.drifting());
        } else {
            all.extend(self.engines.iter().map(|engine| format!("as in {engine}")));
            all.extend(self.residuals());
            all.extend(self.others());
        }
        all.extend(self.hints.iter().map(ToString::to_string));
        all
    }

    fn residuals(&self) -> Vec<String> {
        let Explanation { median, percentile_95, .. } = self.best;
        let steps = self.steps;
        let mut all = vec![format!(
            "of {steps} steps half are within {median:.1e}, 95 in 100 within {percentile_95:.1e}"
        )];
        if self.share < 1.0 {
            all.push(format!("{:.0} % of the rows follow the one before by one step", 100.0 * self.share));
        }
        all
    }

    /// The other rules, relative to the one that is named.
    fn others(&self) -> Vec<String> {
        let mut all = Vec::new();
        let leading = self.leading();
        let mut alike = self.alike.iter().filter(|rule| !leading.contains(rule)).peekable();
        if alike.peek().is_some() {
            let named = |rule: &Rule| match rule.engines() {
                engines if engines.is_empty() => rule.name(),
                engines => format!("{} (as in {})", rule.name(), engines.join("; ")),
            };
            let names: Vec<String> = alike.map(named).collect();
            all.push(format!("cannot be distinguished from it here: {}", listed(&names)));
        }
        if self.is_exact() {
            all.push("nor can any other rule whose errors in a step are within that rounding".into());
        }
        if let (Some(second), Some(ratio)) = (&self.second, self.ratio()) {
            all.push(format!("next is {}, {ratio:.1e} times as far", second.rule.name()));
        }
        all.extend(self.would_decide().map(|how| format!("what would decide: {how}")));
        all.extend(self.accuracy.map(|accuracy| format!("the errors of the steps: {accuracy}")));
        all
    }

    /// What is said where a few digits fit several rules.
    fn drifting(&self) -> Vec<String> {
        let all: Vec<String> = std::iter::once(&self.best.rule).chain(&self.alike).map(Rule::name).collect();
        let (like, unlike) = all.split_at(self.drifts.unwrap_or(0).min(all.len()));
        let like_it = || format!("over the whole record these drift as it does: {}", listed(like));
        match (like, unlike) {
            ([], _) => {
                vec![format!("but over the whole record none of these drifts as it does: {}", listed(unlike))]
            }
            (_, []) => vec![like_it()],
            _ => vec![like_it(), format!("and these do not: {}", listed(unlike))],
        }
    }
}

/// The first of them, and whether there are more.
fn listed(names: &[String]) -> String {
    let more = if names.len() > RULES_NAMED { "; and others" } else { "" };
    format!("{}{more}", names.iter().take(RULES_NAMED).cloned().collect::<Vec<_>>().join("; "))
}

impl fmt::Display for Diagnosis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "Diagnosis: {}", self.heading())?;
        for line in self.details() {
            writeln!(f, "  {line}")?;
        }
        write!(f, "What to do: {}", self.advice.words())
    }
}

impl fmt::Display for Accuracy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.order, self.controlled) {
            (Some(order), _) => write!(f, "order about {order}")?,
            (None, true) => f.write_str("about equal in all steps, as where their error is controlled")?,
            (None, false) => f.write_str("no order shows in them")?,
        }
        write!(f, ", about {:.0e} of the spin a second", self.per_second)
    }
}
