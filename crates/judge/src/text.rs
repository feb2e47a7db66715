//! A verdict in plain words.

use crate::law::{Law, LawName};
use crate::names::readable;
use crate::verdict::{Outcome, Verdict};
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
        self.file(f)?;
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
        let name = self.outcome.key().to_uppercase();
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
        write!(f, "{name}: {}", reasons.join(";\n  "))
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
                "no law is broken, and too little is seen to say more: eight rows at least are wanted, in which the body turns once round \
                 or its spin should change by a tenth"
            }
        };
        Some(words.into())
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

    fn file(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.record.ignored.is_empty() {
            writeln!(f, "Ignored:  the columns {}", self.record.ignored.join(", "))?;
        }
        for note in &self.record.notes {
            writeln!(f, "Note:     {note}.")?;
        }
        for mistake in &self.file_mistakes {
            writeln!(f, "File:     {}.", mistake.words())?;
        }
        if !self.file_mistakes.is_empty() {
            writeln!(f, "          What follows is of the file with that put right.")?;
        }
        for reset in &self.resets {
            let how = reset.words();
            writeln!(
                f,
                "Reset:    line {}, t = {:.4} s: the body {how}. Judged up to there.",
                reset.line, reset.time
            )?;
        }
        if let Some(gaps) = &self.record.gaps {
            writeln!(
                f,
                "Gaps:     rows are missing in {} places, the first before line {}; the longest is {:.0} steps",
                gaps.count, gaps.line, gaps.longest
            )?;
        }
        if !self.record.missing.is_empty() {
            let names: Vec<&str> = self.record.missing.iter().map(|law| law.words()).collect();
            writeln!(
                f,
                "Not available: {} (the file has no {})",
                names.join(", "),
                if self.record.has_attitude {
                    "spin: it is made from the turns between the attitudes, by the exact motion"
                } else {
                    "attitude"
                }
            )?;
        }
        if self.record.sign_changes > 0 {
            writeln!(
                f,
                "Signs:    the quaternion changes its sign {} times; the attitude does not",
                self.record.sign_changes
            )?;
        }
        Ok(())
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
