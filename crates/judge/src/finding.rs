//! A diagnosis in words.

use crate::accuracy::Accuracy;
use crate::confidence::Confidence;
use crate::diagnosis::Diagnosis;
use crate::rules::Rule;
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

    fn residuals(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "  of {} steps half are within {:.1e}, 95 in 100 within {:.1e}",
            self.steps, self.best.median, self.best.percentile_95
        )?;
        if self.share < 1.0 {
            writeln!(f, "  {:.0} % of the rows follow the one before by one step", 100.0 * self.share)?;
        }
        Ok(())
    }

    fn what_to_do(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for hint in &self.hints {
            writeln!(f, "  {hint}")?;
        }
        write!(f, "What to do: {}", self.advice.words())
    }

    /// What is said where a few digits fit several rules.
    fn few_digits(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let all: Vec<String> = std::iter::once(&self.best.rule).chain(&self.alike).map(Rule::name).collect();
        let (like, unlike) = all.split_at(self.drifts.unwrap_or(0).min(all.len()));
        writeln!(
            f,
            "Diagnosis: too few digits to name the rule by its single steps: they fit {} rules alike",
            all.len()
        )?;
        self.residuals(f)?;
        match (like, unlike) {
            ([], _) => {
                let unlike = listed(unlike);
                writeln!(f, "  but over the whole record none of these drifts as it does: {unlike}")?;
            }
            (_, []) => writeln!(f, "  over the whole record these drift as it does: {}", listed(like))?,
            _ => {
                writeln!(f, "  over the whole record these drift as it does: {}", listed(like))?;
                writeln!(f, "  and these do not: {}", listed(unlike))?;
            }
        }
        self.what_to_do(f)
    }
}

/// The first of them, and whether there are more.
fn listed(names: &[String]) -> String {
    let more = if names.len() > RULES_NAMED { "; and others" } else { "" };
    format!("{}{more}", names.iter().take(RULES_NAMED).cloned().collect::<Vec<_>>().join("; "))
}

impl fmt::Display for Diagnosis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.confidence == Confidence::FewDigits {
            return self.few_digits(f);
        }
        writeln!(f, "Diagnosis: {}: {}", self.words(), self.best.rule.name())?;
        for engine in &self.engines {
            writeln!(f, "  as in {engine}")?;
        }
        self.residuals(f)?;
        if !self.alike.is_empty() {
            let named = |rule: &Rule| match rule.engines() {
                engines if engines.is_empty() => rule.name(),
                engines => format!("{} (as in {})", rule.name(), engines.join("; ")),
            };
            let names: Vec<String> = self.alike.iter().map(named).collect();
            writeln!(f, "  cannot be distinguished from it here: {}", listed(&names))?;
        }
        if self.is_exact() {
            writeln!(f, "  nor can any other rule whose errors in a step are within that rounding")?;
        }
        if let (Some(second), Some(ratio)) = (&self.second, self.ratio()) {
            writeln!(f, "  next is {}, {ratio:.1e} times as far", second.rule.name())?;
        }
        if let Some(wanted) = self.would_decide() {
            writeln!(f, "  what would decide: {wanted}")?;
        }
        if let Some(accuracy) = &self.accuracy {
            writeln!(f, "  the errors of the steps: {accuracy}")?;
        }
        self.what_to_do(f)
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
