//! A diagnosis in words.

use crate::rule::{Advice, Base, Confidence, Diagnosis, Jump, Rule};
use crate::thresholds::*;
use crate::verdict::plain_number;
use std::fmt;

/// With a capital letter.
pub(crate) fn capital(words: &str) -> String {
    let mut words = words.to_string();
    words.get_mut(..1).map(str::make_ascii_uppercase);
    words
}

/// With a capital letter and a full stop.
pub(crate) fn sentence(words: &str) -> String {
    capital(words) + if words.ends_with('.') { "" } else { "." }
}

impl Diagnosis {
    /// The words before the colon and the best rule's name; a whole sentence, without that name, where a
    /// record fails and its rule is unknown.
    #[must_use]
    pub fn words(&self) -> &'static str {
        let words = match self.confidence {
            Confidence::NoneFits if self.floor.few => {
                "Too few digits to identify a rule, and none of the known rules fits. Nearest is"
            }
            other => other.names()[1],
        };
        // Without the nearest rule.
        if self.is_open() { words.split(". ").next().unwrap_or(words) } else { words }
    }

    /// The rule, the engines that use it, and what to do.
    pub(crate) fn head(&self) -> Vec<String> {
        let names = self.leading.iter().map(Rule::name).collect::<Vec<_>>();
        let (names, steps) = (names.join("; or, with the same steps in this record: "), self.steps);
        let words = match (self.confidence, self.jumps.len()) {
            (Confidence::FewDigits, _) if !self.alike.is_empty() => {
                format!("Too few digits to identify the rule: {} rules fit", 1 + self.alike.len())
            }
            _ if self.is_open() => self.words().into(),
            (Confidence::NoneFits | Confidence::SmallErrors, _) | (_, 0) => {
                format!("{}: {names}", self.words())
            }
            (_, n) => {
                format!("Except for jumps ({n} of {steps} steps tried) all agree to rounding with: {names}")
            }
        };
        let mut lines = vec![words];
        // Beside a rule that is not identified, a reader would take the engines for the record's.
        let sure = self.confidence.names_a_rule() && self.confidence != Confidence::Near;
        let said = Some(&self.engines).filter(|engines| !engines.is_empty() && sure);
        lines.extend(said.map(|engines| format!("used by {}", engines.join("; "))));
        lines.extend(self.advice.iter().map(|Advice { words, chapter }| {
            let more = chapter.map(|place| format!(" See the chapter {place}."));
            format!("{words}{}", more.unwrap_or_default())
        }));
        lines.extend(self.settings.iter().map(|setting| format!("setting to use in {setting}")));
        lines.iter().map(|line| sentence(line)).collect()
    }

    /// How certain that is, and the other rules.
    pub(crate) fn details(&self) -> Vec<String> {
        let (half, most) = (plain_number(self.best.median), plain_number(self.best.percentile_95));
        let mut lines: Vec<String> = self.jumps.iter().take(RESETS).map(Jump::words).collect();
        let nearest = if self.best.rule.base == Base::Exact { "exact motion" } else { "nearest known rule" };
        let none = matches!(self.confidence, Confidence::NoneFits | Confidence::Accurate);
        let (from, n) = (if none || self.is_open() { nearest } else { "rule" }, self.steps);
        lines.push(format!("distance of {n} steps from the {from}: median {half}, 95th percentile {most}"));
        if (100.0 * self.share).round() < 100.0 {
            lines.push(format!("{:.0} % of the rows are one step after the row before", 100.0 * self.share));
        }
        // The significant digits count, not the printed ones.
        let (scatter, few) =
            (self.error.filter(|_| self.confidence == Confidence::Scattered), self.floor.few);
        lines.extend(scatter.or(few.then_some(self.floor.size)).map(|off| {
            let like = match (off > DIGITS_OF_A_SENSOR, scatter) {
                (false, _) => "",
                (true, None) => ", as in half precision",
                (true, Some(_)) => ", as in half precision or from a noisy sensor",
            };
            format!("significant digits: about {:.0}{like}", -off.log10())
        }));
        lines.extend(match self.confidence {
            Confidence::FewDigits => {
                let all = std::iter::once(&self.best.rule).chain(&self.alike).map(Rule::name);
                vec![format!("rules that fit: {}", listed(&all.collect::<Vec<_>>()))]
            }
            _ => self.others(),
        });
        lines.iter().map(|line| sentence(line)).collect()
    }

    /// The other rules, compared with the one that is named.
    fn others(&self) -> Vec<String> {
        let mut all = Vec::new();
        let named = |rule: &Rule| match rule.engines() {
            engines if engines.is_empty() || !self.confidence.names_a_rule() || self.is_exact() => {
                rule.name()
            }
            engines => format!("{} (used by {})", rule.name(), engines.join("; ")),
        };
        let names: Vec<_> = self.alike.iter().filter(|x| !self.leading.contains(x)).map(named).collect();
        if !names.is_empty() {
            let fits = self.confidence.names_a_rule() && self.confidence != Confidence::Near;
            let how = if fits { "fit equally well" } else { "about as near" };
            all.push(format!("{how}: {}", listed(&names)));
        }
        if self.is_exact() {
            all.push(
                "any other rule whose errors in a step are below that rounding would fit as well".into(),
            );
        } else if self.confidence == Confidence::ToRounding && (self.single || self.floor.few) {
            all.push(
                "an unknown rule with steps that differ by less than that rounding would fit too".into(),
            );
        }
        // Errors too close to rounding do not rank the rules.
        let ranks = self.confidence != Confidence::SmallErrors;
        if let (Some(second), Some(ratio @ 1.0..), true) = (&self.second, self.ratio(), ranks) {
            all.push(format!("next nearest: {}, {} times as far", second.rule.name(), plain_number(ratio)));
        }
        all.extend(self.would_decide().map(|how| format!("to distinguish such rules, record {how}")));
        all.extend(self.error.filter(|_| self.confidence == Confidence::Accurate).map(|share| {
            let share = plain_number(share);
            format!("the error of a step is {share} of the change of spin by the gyroscopic term")
        }));
        all
    }
}

/// The first of them, and whether there are more.
fn listed(names: &[String]) -> String {
    let more = if names.len() > RULES_NAMED { "; and others" } else { "" };
    format!("{}{more}", names.iter().take(RULES_NAMED).cloned().collect::<Vec<_>>().join("; "))
}

impl fmt::Display for Diagnosis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines = [self.head(), self.details()].concat();
        f.write_str(&lines.join("\n"))
    }
}

impl Jump {
    fn words(&self) -> String {
        let (Self { line, time, .. }, size) = (self, plain_number(self.size));
        format!(
            "at t = {time:.4} s (line {line}) the body jumps by {size} (spin relative to its length, or attitude in rad): a push, a contact, a limit on the spin or a reset"
        )
    }
}
