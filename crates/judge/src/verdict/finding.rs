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
    /// How the best rule is named, up to a colon and its name; all of it where a record fails and nothing is
    /// known of its rule.
    #[must_use]
    pub fn words(&self) -> &'static str {
        let words = match self.confidence {
            Confidence::NoneFits if self.few => {
                "Too few digits to name a rule, and none of those known fits. Nearest is"
            }
            other => other.names()[1],
        };
        // Up to what comes nearest.
        if self.is_open() { words.split(". ").next().unwrap_or(words) } else { words }
    }

    /// The rule, the engines that go by it, and what to do.
    pub(crate) fn head(&self) -> Vec<String> {
        let names = self.leading.iter().map(Rule::name).collect::<Vec<_>>();
        let (names, steps) = (names.join("; or, with the same steps here: "), self.steps);
        let words = match (self.confidence, self.jumps.len()) {
            (Confidence::FewDigits, _) if !self.alike.is_empty() => {
                format!("Too few digits to name the rule: they fit {} rules alike", 1 + self.alike.len())
            }
            _ if self.is_open() => self.words().into(),
            (Confidence::NoneFits | Confidence::SmallErrors, _) | (_, 0) => {
                format!("{}: {names}", self.words())
            }
            (_, count) => {
                format!("But for jumps ({count} of {steps} steps tried) all agree to rounding with: {names}")
            }
        };
        let mut lines = vec![words];
        let open = self.is_open() || matches!(self.confidence, Confidence::FewDigits | Confidence::NoneFits);
        let said = Some(&self.engines).filter(|engines| !engines.is_empty() && !open);
        lines.extend(said.map(|engines| format!("as in {}", engines.join("; or in "))));
        lines.extend(self.advice.iter().map(|Advice { words, chapter }| {
            let more = chapter.map(|place| format!(" More about it: chapter {place}"));
            format!("{words}{}", more.unwrap_or_default())
        }));
        lines.extend(self.settings.iter().map(|setting| format!("setting of {setting}")));
        lines.iter().map(|line| sentence(line)).collect()
    }

    /// How sure that is, and what else there is.
    pub(crate) fn details(&self) -> Vec<String> {
        let (half, most) = (plain_number(self.best.median), plain_number(self.best.percentile_95));
        let mut lines: Vec<String> = self.jumps.iter().take(RESETS).map(Jump::words).collect();
        let nearest = if self.best.rule.base == Base::Exact { "exact motion" } else { "nearest known rule" };
        let of = if self.is_open() { format!(" of the {nearest}'s") } else { String::new() };
        lines.push(format!("of {} steps half are within {half}{of}, 95 in 100 within {most}", self.steps));
        if self.share < 1.0 {
            lines.push(format!("{:.0} % of the rows follow the one before by one step", 100.0 * self.share));
        }
        // Beyond the digits that are printed those that are sound count.
        let (scatter, few) = (self.error.filter(|_| self.confidence == Confidence::Scattered), self.few);
        lines.extend(scatter.or(few.then_some(self.rounding)).map(|off| {
            let like = match (off > DIGITS_OF_A_SENSOR, scatter) {
                (false, _) => "",
                (true, None) => ", as of half precision",
                (true, Some(_)) => ", as of half precision or a noisy sensor",
            };
            format!("digits: about {:.0}{like}", -off.log10())
        }));
        lines.extend(match self.confidence {
            Confidence::FewDigits => {
                let all = std::iter::once(&self.best.rule).chain(&self.alike).map(Rule::name);
                vec![format!("those that fit: {}", listed(&all.collect::<Vec<_>>()))]
            }
            _ => self.others(),
        });
        lines.iter().map(|line| sentence(line)).collect()
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
        } else if self.confidence == Confidence::ToRounding && (self.single || self.few) {
            all.push(
                "nor can a rule that is not known here, if its steps differ by less than that rounding"
                    .into(),
            );
        }
        // Errors too near to rounding to name a rule rank none.
        let ranks = self.confidence != Confidence::SmallErrors;
        if let (Some(second), Some(ratio), true) = (&self.second, self.ratio(), ranks) {
            all.push(format!("next is {}, {} times as far", second.rule.name(), plain_number(ratio)));
        }
        all.extend(self.would_decide().map(|how| format!("what would decide: {how}")));
        all.extend(self.error.filter(|_| self.confidence == Confidence::Accurate).map(|share| {
            let share = plain_number(share);
            format!("the error of a step is {share} of what the gyroscopic term changes in it")
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
            "at t = {time:.4} s (line {line}) the body jumps, by {size} of its spin: a push, a contact, a limit on the spin or a reset"
        )
    }
}
