//! A diagnosis in words.

use crate::rule::{Confidence, Diagnosis, Rule, significant};
use crate::thresholds::RULES_NAMED;
use crate::verdict::{Section, plain_number};
use std::fmt;

/// With a capital letter and a full stop.
pub(crate) fn sentence(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    let stop = if words.ends_with('.') { "" } else { "." };
    format!("{first}{}{stop}", letters.as_str())
}

impl Diagnosis {
    /// How the best rule is named, up to a colon and its name.
    #[must_use]
    pub const fn words(&self) -> &'static str {
        match self.confidence {
            Confidence::ToRounding if self.single => {
                "To the rounding of single precision every step is that of"
            }
            Confidence::ToRounding if self.few => "To the record's rounding every step is that of",
            Confidence::ToRounding => "Every step is made by",
            Confidence::MostSteps => "Most steps, but not all, are made by",
            Confidence::Near => "Most like",
            Confidence::FewDigits => "Too few digits to name the rule by its single steps. One that fits is",
            Confidence::SmallErrors => {
                "The errors of the steps are too near to rounding to name the rule. One that fits is"
            }
            Confidence::FewSteps => {
                "Too few rows follow one another by one step to name the rule. One that fits those is"
            }
            Confidence::Accurate => "An accurate rule, none of those known. Nearest is",
            Confidence::NoneFits => "None of the known rules fits. Nearest is",
        }
    }

    /// In words: the rule, how sure it is, and what to do.
    pub(crate) fn report(&self) -> [Section; 2] {
        let mut lines = self.of_rule();
        lines.extend(self.cap.map(|[from, to]| {
            let [from, to] = [from, to].map(significant);
            format!(
                "the first step takes the spin from {from} to {to} rad/s, and no later one goes beyond: a cap on the spin"
            )
        }));
        let lines = lines.iter().map(|line| sentence(line)).collect();
        let more = self.advice.chapter.map(|place| format!(" More about it: chapter {place}."));
        let advice = format!("{}{}", self.advice.words, more.unwrap_or_default());
        [("Diagnosis", lines), ("What to do", vec![advice])].map(|(title, lines)| Section {
            title: title.into(),
            table: Vec::new(),
            lines,
        })
    }

    fn of_rule(&self) -> Vec<String> {
        let (half, most) = (plain_number(self.best.median), plain_number(self.best.percentile_95));
        let within = format!("of {} steps half are within {half}, 95 in 100 within {most}", self.steps);
        let share = format!("{:.0} % of the rows follow the one before by one step", 100.0 * self.share);
        let share = (self.share < 1.0).then_some(share);
        if self.confidence == Confidence::FewDigits {
            let count = 1 + self.alike.len();
            let first =
                format!("Too few digits to name the rule by its single steps: they fit {count} rules alike");
            return [first, within].into_iter().chain(share).chain(self.drifting()).collect();
        }
        let names: Vec<String> = self.leading.iter().map(Rule::name).collect();
        let mut lines = vec![format!("{}: {}", self.words(), names.join("; or, with the same steps here: "))];
        lines.extend(self.engines.iter().map(|engine| format!("as in {engine}")));
        lines.push(within);
        lines.extend(share);
        lines.extend(self.others());
        lines
    }

    /// The other rules, relative to the one that is named.
    fn others(&self) -> Vec<String> {
        let mut all = Vec::new();
        let named = |rule: &Rule| match rule.engines() {
            engines if engines.is_empty() => rule.name(),
            engines => format!("{} (as in {})", rule.name(), engines.join("; ")),
        };
        let alike = self.alike.iter().filter(|rule| !self.leading.contains(rule));
        let names: Vec<String> = alike.map(named).collect();
        if !names.is_empty() {
            all.push(format!("cannot be distinguished from it here: {}", listed(&names)));
        }
        if self.is_exact() {
            all.push("nor can any other rule whose errors in a step are within that rounding".into());
        }
        if let (Some(second), Some(ratio)) = (&self.second, self.ratio()) {
            all.push(format!("next is {}, {} times as far", second.rule.name(), plain_number(ratio)));
        }
        all.extend(self.would_decide().map(|how| format!("what would decide: {how}")));
        all.extend(self.error.map(|share| {
            format!(
                "the error of a step is {} of what the gyroscopic term changes in it",
                plain_number(share)
            )
        }));
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
        let [rule, advice] = self.report();
        write!(f, "{rule}\n{advice}")
    }
}
