//! A verdict in words: one text, which the terminal prints and the page shows.

use crate::law::LawName;
use crate::laws::{Gaps, Law, Reset};
use crate::read::FileMistake;
use crate::rule::{Base, Confidence, Diagnosis, readable};
use crate::thresholds::{ENOUGH_CHANGE, ENOUGH_ROWS, FLIP_TIMES, STILL};
use crate::verdict::words::times;
use crate::verdict::{Complaint, Outcome, Verdict, capital, plain_number, sentence};
use serde::Serialize;
use std::f64::consts::TAU;
use std::fmt;

/// A part of a verdict in words: a title, and below it a table, lines, or both.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Section {
    /// Its title.
    pub title: String,
    /// The laws, a row each: name, largest error, last error and how it grows.
    pub table: Vec<[String; 4]>,
    /// Sentences.
    pub lines: Vec<String>,
}

/// What the columns of a table of laws are.
pub(crate) const COLUMNS: [&str; 4] = ["law", "off by at most", "at the end", "how it grows"];

fn section(title: &str, lines: impl IntoIterator<Item = String>) -> Section {
    Section { title: title.into(), table: Vec::new(), lines: lines.into_iter().collect() }
}

impl Verdict {
    /// All of it in words: the outcome, the rule, its engines and what to do; the reasons; how sure the rule
    /// is; the laws, and the record.
    #[must_use]
    pub fn report(&self) -> Vec<Section> {
        let sentences = |all: Vec<String>| all.iter().map(|words| sentence(words)).collect::<Vec<_>>();
        let short = self.outcome == Outcome::TooShort;
        let shown = self.diagnosis.as_ref().filter(|found| !short || found.confidence.names_a_rule());
        let mut head = shown.map(Diagnosis::head).unwrap_or_default();
        let mistakes = self.mistakes();
        // The rule is that of the corrected numbers.
        let named = head.first_mut().filter(|_| !mistakes.is_empty());
        named.into_iter().for_each(|line| line.insert_str(0, "With the file so corrected: "));
        if let Some(seen) = self.seen().filter(|_| !head.is_empty()) {
            head.insert(1, sentence(&seen));
        }
        let (failed, reasons) =
            (self.outcome == Outcome::Failed && !head.is_empty(), sentences(self.reasons()));
        let first = if failed { sentences(mistakes) } else { reasons.clone() };
        let mut all = vec![section(&capital(self.outcome.key()), first.into_iter().chain(head))];
        all.extend(failed.then(|| section("Why", reasons)));
        all.extend(shown.map(|found| section("Diagnosis", found.details())));
        all.extend(self.physics());
        all.extend(self.of_record());
        all.extend(self.of_file());
        all
    }

    /// How the laws are broken, where the rule is unknown.
    fn seen(&self) -> Option<String> {
        let found = self.diagnosis.as_ref().filter(|found| !found.confidence.names_a_rule())?;
        if let ([first, ..], true) = (&found.jumps[..], found.fails) {
            let (from, count, steps) = (first.time, times(found.jumps.len() as u64), found.steps);
            let words = format!("the body jumps {count} in {steps} steps tried, first at t = {from:.4} s");
            return Some(format!("observed: {words}"));
        }
        let each = self.broken().map(|law| format!("{} ({})", law.name.words(), law.plain()));
        let turned =
            self.complaints.iter().filter(|x| matches!(x, Complaint::Otherwise { seen: Some(_), .. }));
        let by = |x| format!("the change of spin is {} times that of the gyroscopic term", plain_number(x));
        let all = each.chain(turned.map(ToString::to_string)).chain(found.term.map(by));
        let all = all.collect::<Vec<_>>().join("; ");
        (!all.is_empty() && found.confidence == Confidence::NoneFits).then(|| format!("observed: {all}"))
    }

    /// The mistakes of the file in words.
    pub(crate) fn mistakes(&self) -> Vec<String> {
        // A tensor frozen at the identity looks, in the other axes, like a turn on the wrong side.
        let is_frozen = |found: &Diagnosis| matches!(found.best.rule.base, Base::FrozenTensor(..));
        let frozen = self.diagnosis.as_ref().is_some_and(is_frozen);
        let words = |mistake: &FileMistake| match (mistake, self.record.has_attitude) {
            (FileMistake::LeftHandedSpin, false) => {
                format!(
                    "{}; or the engine's gyroscopic term has the wrong sign, or its body has other moments: spins alone do not distinguish these",
                    mistake.words()
                )
            }
            (FileMistake::Times(times), _) => {
                // The step in the record, and the corrected one.
                let steps = |step| format!(" (rows dt = {:.6} s, corrected {step:.6} s)", step / times);
                let steps = self.record.step.map(steps);
                mistake.words().replacen(':', &(steps.unwrap_or_default() + ":"), 1)
            }
            (FileMistake::Frame, _) if frozen => {
                format!("{}; or a step multiplies the attitude on the wrong side", mistake.words())
            }
            _ => mistake.words(),
        };
        let all: Vec<String> = self.file_mistakes.iter().map(words).collect();
        // Attitudes alone are corrected by the gyroscopic term, which the engine itself may have wrong.
        let alone = self.record.has_attitude && self.record.missing.contains(&LawName::Consistency);
        let sure =
            |found: &Diagnosis| found.confidence.names_a_rule() && found.confidence != Confidence::Near;
        if all.is_empty() || !alone || self.diagnosis.as_ref().is_none_or(sure) {
            return all;
        }
        let file = all.join("; and ");
        vec![format!(
            "these attitudes alone do not show whether the file or the engine is wrong. Perhaps {file}; or perhaps the \
             engine has the gyroscopic term with the wrong sign"
        )]
    }

    /// Every reason for the outcome.
    #[must_use]
    pub fn reasons(&self) -> Vec<String> {
        let mut reasons = Vec::new();
        match self.outcome {
            Outcome::Failed => {
                if !self.file_mistakes.is_empty() {
                    reasons.push("with its columns read as named, the record is not a motion of this body".into());
                }
                if !self.resets.is_empty() {
                    reasons.push("the motion is interrupted by a reset or a jump".into());
                }
                reasons.extend(self.broken().map(|law| {
                    let (most, allowed) = (plain_number(law.most), self.options.allowed(law.name));
                    let allowed = allowed.unwrap_or(f64::INFINITY);
                    format!("{} is off by up to {most} (allowed: {allowed})", law.name.words())
                }));
            }
            Outcome::Passed => reasons.push(self.within()),
            Outcome::NothingToJudge => reasons.push(self.why_not().into()),
            Outcome::TooShort => reasons.push(
                format!(
                    "no law is broken, but the record is too short to pass: it needs {ENOUGH_ROWS} rows or more, in which \
                     the body makes one turn or its spin should change by a tenth. Record {} s or more of this body",
                    plain_number(self.enough())
                ),
            ),
        }
        reasons.extend(self.complaints.iter().map(ToString::to_string));
        reasons
    }

    /// How long a record of this body must be, s: one turn, in enough rows.
    fn enough(&self) -> f64 {
        let once = self.curve.first().map_or(0.0, |first| TAU / first.spin.norm());
        once.max(self.record.step.unwrap_or(0.0) * (ENOUGH_ROWS - 1) as f64)
    }

    /// Why there is nothing to judge.
    fn why_not(&self) -> &'static str {
        if self.torque.is_some() {
            "a torque acts: the laws judged here hold for free bodies only, and damping and wrong gyroscopic terms are \
             tested on free bodies only"
        } else if self.untraceable {
            "the body turns so far that double precision cannot determine where it should be. \
             Record it with shorter steps, and check the units"
        } else if STILL * self.record.rounding > ENOUGH_CHANGE {
            "the numbers have too few digits to say whether the spin changes. Record more digits"
        } else {
            "the spin is constant, which is correct for this start. Start with a spin off the principal axis"
        }
    }

    /// The limit within which every law that the record shows is kept, and the laws beyond it whose errors
    /// the digits leave open.
    fn within(&self) -> String {
        let own = self.options.own().map(|(law, most)| format!(", {} within {most}", law.words()));
        let own: String = own.collect();
        let beyond = |law: &&Law| self.options.allowed(law.name).is_some_and(|most| law.most.abs() > most);
        let words = |law: &Law| format!("{} by {}", law.name.words(), plain_number(law.most));
        let open: Vec<String> = self.laws.iter().filter(beyond).map(words).collect();
        let open = match &open[..] {
            [] => String::new(),
            open => format!("; or off by no more than its digits leave open: {}", open.join(", ")),
        };
        format!("every law that the record shows is kept within {}{own}{open}", self.options.threshold)
    }

    /// The laws, the separatrix and the flips.
    fn physics(&self) -> Vec<Section> {
        let mut all = Vec::new();
        if !self.laws.is_empty() {
            let worst = self.worst().map(|law| {
                let (name, how) = (law.name.words(), law.how());
                format!("The worst of the conserved quantities is {name}: {how}.")
            });
            let table = self.laws.iter().map(|law| law.cells()).collect();
            all.push(Section { table, ..section("Errors relative to the first row", worst) });
        }
        if let Some([first, last]) = self.separatrix {
            let nearer = (last - 1.0).abs() < (first - 1.0).abs() || (first - 1.0) * (last - 1.0) < 0.0;
            let moved = self.laws.iter().any(|law| law.name == LawName::Separatrix && law.growth.rank() > 0);
            let toward = match (moved, nearer) {
                (false, _) => "",
                (true, true) => ", toward the separatrix at 1, where a stable spin starts to flip",
                (true, false) => ", away from the separatrix at 1",
            };
            let line = format!(
                "2 E I₂ / L² goes from {first:.6} to {last:.6}{toward} (E energy, I₂ the middle moment: below 1 the spin \
                 circles the axis of the largest moment, above 1 that of the smallest)."
            );
            all.push(section("Separatrix", [line]));
        }
        if let Some(flips) = &self.flips {
            let (found, exact) = (times(flips.found), flips.exact);
            let mut line = format!("The spin along the middle axis changes sign {found} (exact: {exact})");
            if let (Some(at), Some(exact)) = (flips.first, flips.first_exact) {
                let by = plain_number(flips.apart);
                let many = flips.found.min(flips.exact) > FLIP_TIMES as u64;
                let of = if many { format!("the first {FLIP_TIMES} ") } else { String::new() };
                line += &format!("; the first at {at:.4} s (exact: {exact:.4} s), {of}at most {by} s apart");
            }
            line += &flips.lateness();
            all.push(section("Flips", [line + "."]));
        }
        all
    }

    /// The body, and how the record was read.
    fn of_record(&self) -> Vec<Section> {
        let three = |vector: nalgebra::Vector3<f64>| {
            let [x, y, z] = vector.map(readable).into();
            format!("{x}, {y}, {z}")
        };
        let mut all: Vec<Section> =
            self.record.engine.iter().map(|engine| section("Engine", [engine.clone()])).collect();
        all.push(section("Body", [format!("moments {} kg m²", three(self.moments))]));
        let torque = self.torque.map(|torque| format!("{} N m, constant in the world", three(torque)));
        all.extend(torque.map(|words| section("Torque", [words])));
        let steps = |step| format!("steps of {step:.6} s");
        let step = self.record.step.map_or_else(|| "steps of various lengths".into(), steps);
        let (rows, duration) = (self.record.rows, self.record.duration);
        all.push(section("Record", [format!("{rows} rows, {step}, judged over {duration:.3} s")]));
        all
    }

    /// Facts about the file besides its numbers.
    fn of_file(&self) -> Vec<Section> {
        let record = &self.record;
        let mut all: Vec<(&str, String)> = Vec::new();
        if !record.ignored.is_empty() {
            all.push(("Ignored", format!("the columns {}", record.ignored.join(", "))));
        }
        all.extend(record.notes.iter().map(|note| ("Note", note.to_string())));
        if !self.file_mistakes.is_empty() {
            all.push(("File", "it is judged with these corrections, which its first rows suggest".into()));
        }
        all.extend(self.resets.iter().map(|reset| {
            let Reset { line, time, .. } = reset;
            let how = reset.words();
            ("Reset", format!("line {line}, t = {time:.4} s: the body {how}; judged up to there"))
        }));
        all.extend(record.gaps.map(|Gaps { count, line, longest }| {
            let places = if count == 1 { "one place".into() } else { format!("{count} places") };
            let first = format!("rows are missing in {places}, the first before line {line}");
            ("Gaps", format!("{first}; the longest is {longest:.0} steps"))
        }));
        if !record.missing.is_empty() {
            let names: Vec<&str> = record.missing.iter().map(|law| law.words()).collect();
            let why = match record.has_attitude {
                true => "no spin: it is computed from the attitudes, with the exact motion",
                false => "no attitude",
            };
            all.push(("Missing", format!("nothing is known of {} (the record has {why})", names.join(", "))));
        }
        let signs = |times| format!("the quaternion changes its sign {times} times; the attitude does not");
        all.extend(Some(record.sign_changes).filter(|times| *times > 0).map(|times| ("Signs", signs(times))));
        all.into_iter().map(|(title, line)| section(title, [line])).collect()
    }
}

impl Law {
    /// A row of the table of laws.
    fn cells(&self) -> [String; 4] {
        let name = self.name.heading().to_owned();
        [name, plain_number(self.most), plain_number(self.last), self.plain()]
    }
}

fn row(f: &mut fmt::Formatter<'_>, [name, most, last, growth]: [&str; 4]) -> fmt::Result {
    write!(f, "{name:22} {most:>14} {last:>14}   {growth}")
}

impl fmt::Display for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        row(f, self.cells().each_ref().map(String::as_str))
    }
}

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.title)?;
        if !self.table.is_empty() {
            write!(f, "\n  ")?;
            row(f, COLUMNS)?;
        }
        for cells in &self.table {
            write!(f, "\n  ")?;
            row(f, cells.each_ref().map(String::as_str))?;
        }
        match &self.lines[..] {
            [line] if self.table.is_empty() => write!(f, " {line}"),
            lines => lines.iter().try_for_each(|line| write!(f, "\n  {line}")),
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [outcome, others @ ..] = &self.report()[..] else { return Ok(()) };
        write!(f, "{}", Section { title: outcome.title.to_ascii_uppercase(), ..outcome.clone() })?;
        others.iter().try_for_each(|section| write!(f, "\n{section}"))
    }
}
