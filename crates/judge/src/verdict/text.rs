//! A verdict in plain words.

use crate::law::LawName;
use crate::laws::jumps::Reset;
use crate::laws::kept::Law;
use crate::laws::trial::Gaps;
use crate::rule::names::readable;
use crate::verdict::outcome::{Outcome, Verdict};
use std::fmt;

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(engine) = &self.record.engine {
            writeln!(f, "Engine:   {engine}")?;
        }
        let [a, b, c] = self.moments.map(readable).into();
        writeln!(f, "Body:     moments {a}, {b}, {c} kg m2")?;
        if let Some(torque) = self.torque {
            let [x, y, z] = torque.map(readable).into();
            writeln!(f, "Torque:   {x}, {y}, {z} N m, constant in the world")?;
        }
        let step = match self.record.step {
            Some(step) => format!("steps of {step:.6} s"),
            None => "steps of various lengths".into(),
        };
        writeln!(
            f,
            "Record:   {} rows, {}, judged over {:.3} s",
            self.record.rows, step, self.record.duration
        )?;
        if let Some(fit) = &self.fit {
            writeln!(
                f,
                "Start:    fitted to the first {} rows, {:.1e} rad/s from the first one; {:.1e} rad/s are left",
                fit.rows, fit.moved, fit.left
            )?;
        }
        for (label, sentence) in self.of_file() {
            let label = if label.is_empty() { String::new() } else { format!("{label}:") };
            writeln!(f, "{label:9} {sentence}")?;
        }
        self.physics(f)?;
        if let Some(diagnosis) = &self.diagnosis {
            writeln!(f, "\n{diagnosis}")?;
        }
        writeln!(f)?;
        if let Some(law) = self.worst() {
            writeln!(
                f,
                "Overall:  {} (of what the motion keeps, {} is kept worst)",
                law.growth.words(),
                law.name.words()
            )?;
        }
        write!(f, "{}: {}", self.outcome.key().to_uppercase(), self.reasons().join(";\n  "))
    }
}

impl Verdict {
    /// Why it ends so, in words; `None` where it failed, which has its reasons in the laws, the file and the
    /// complaints.
    #[must_use]
    pub fn reason(&self) -> Option<String> {
        let words = match self.outcome {
            Outcome::Failed => return None,
            Outcome::Passed => return Some(self.within()),
            Outcome::NothingToJudge if self.torque.is_some() => {
                "a torque acts, and the laws judged here are those of a free body. The rule that made the record is named above"
            }
            Outcome::NothingToJudge if self.untraceable => {
                "the body turns so far from row to row that no number of double precision says where it should be. Record it with shorter \
                 steps, and look at the units"
            }
            Outcome::NothingToJudge => {
                "the spin is constant, as it is right for this start. Push the body off its principal axis"
            }
            Outcome::TooShort => {
                "no law is broken, and too little is seen to say more: it takes eight rows at least, in which the body turns once round \
                 or its spin should change by a tenth"
            }
        };
        Some(words.into())
    }

    /// Every reason for the outcome, in words.
    #[must_use]
    pub fn reasons(&self) -> Vec<String> {
        let mut reasons: Vec<String> = self.reason().into_iter().collect();
        if self.outcome == Outcome::Failed {
            if !self.file_mistakes.is_empty() {
                reasons.push("the file is not what its names say".into());
            }
            if !self.resets.is_empty() {
                reasons.push("the motion does not go through".into());
            }
            reasons.extend(self.broken().map(|law| {
                let allowed = self.options.allowed(law.name).unwrap_or(f64::INFINITY);
                format!("{} is off by up to {:.3e} (allowed: {allowed})", law.name.words(), law.most)
            }));
        }
        reasons.extend(self.complaints.iter().map(ToString::to_string));
        reasons
    }

    /// What every law is kept within.
    fn within(&self) -> String {
        let mut text = format!("every law is kept within {}", self.options.threshold);
        for (name, most) in LawName::ALL.iter().zip(self.options.thresholds) {
            if let Some(most) = most {
                text += &format!(", {} within {most}", name.words());
            }
        }
        text
    }

    /// What is seen of the file besides its numbers: a label and a sentence for each.
    pub(crate) fn of_file(&self) -> Vec<(&'static str, String)> {
        let record = &self.record;
        let mut all = Vec::new();
        if !record.ignored.is_empty() {
            all.push(("Ignored", format!("the columns {}", record.ignored.join(", "))));
        }
        all.extend(record.notes.iter().map(|note| ("Note", note.to_string())));
        all.extend(self.file_mistakes.iter().map(|mistake| ("File", mistake.words())));
        if !self.file_mistakes.is_empty() {
            all.push(("", "what follows is of the file with that put right".into()));
        }
        all.extend(self.resets.iter().map(|reset| {
            let Reset { line, time, .. } = reset;
            let how = reset.words();
            ("Reset", format!("line {line}, t = {time:.4} s: the body {how}; judged up to there"))
        }));
        all.extend(record.gaps.map(|Gaps { count, line, longest }| {
            let places = if count == 1 { "one place".into() } else { format!("{count} places") };
            let words = format!(
                "rows are missing in {places}, the first before line {line}; the longest is {longest:.0} steps"
            );
            ("Gaps", words)
        }));
        all.extend(self.unavailable().map(|words| ("Missing", words)));
        if record.sign_changes > 0 {
            let times = record.sign_changes;
            let words = format!("the quaternion changes its sign {times} times; the attitude does not");
            all.push(("Signs", words));
        }
        all
    }

    /// The laws that the record has nothing of, and why.
    fn unavailable(&self) -> Option<String> {
        let names: Vec<&str> = self.record.missing.iter().map(|law| law.words()).collect();
        let why = match self.record.has_attitude {
            true => "no spin: it is made from the turns between the attitudes, by the exact motion",
            false => "no attitude",
        };
        (!names.is_empty())
            .then(|| format!("nothing is known of {} (the record has {why})", names.join(", ")))
    }

    fn physics(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.laws.is_empty() {
            writeln!(f, "\nErrors relative to the first row:")?;
            writeln!(f, "{:22} {:>11} {:>11}   grade", "law", "most", "last")?;
        }
        for law in &self.laws {
            writeln!(f, "{law}")?;
        }
        if let Some([first, last]) = self.separatrix {
            let nearer = (last - 1.0).abs() < (first - 1.0).abs() || (first - 1.0) * (last - 1.0) < 0.0;
            let moved = self.laws.iter().any(|law| law.name == LawName::Separatrix && law.growth.rank() > 0);
            let toward = match (moved, nearer) {
                (false, _) => "",
                (true, true) => ", toward the separatrix at 1, where a stable spin starts to flip",
                (true, false) => ", away from the separatrix at 1",
            };
            writeln!(f, "2 E I2 / L^2 goes from {first:.6} to {last:.6}{toward}")?;
            writeln!(
                f,
                "(E energy, I2 the middle moment: below 1 the spin goes round the largest moment's axis, above 1 round the smallest's)"
            )?;
        }
        if let Some(flips) = &self.flips {
            write!(
                f,
                "The spin along the middle axis changes sign {} times (exact: {})",
                flips.found, flips.exact
            )?;
            if let (Some(first), Some(exact)) = (flips.first, flips.first_exact) {
                write!(
                    f,
                    "; the first at {first:.4} s (exact: {exact:.4} s), at most {:.2e} s apart",
                    flips.apart
                )?;
            }
            writeln!(f)?;
            if let Some(first) = flips.turned_over {
                writeln!(f, "The spin that should never turn over does so, first at {first:.4} s")?;
            }
        }
        Ok(())
    }
}

impl fmt::Display for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.name.heading();
        write!(f, "{name:22} {:>11.3e} {:>11.3e}   {}", self.most, self.last, self.growth)
    }
}
