//! The end of a trial: what its laws and steps come to, as one verdict.

use crate::law::LawName;
use crate::laws::complaint::Complaint;
use crate::laws::kept::{FlipCount, Law};
use crate::laws::trial::Trial;
use crate::options::Options;
use crate::read::columns::Kind;
use crate::read::fit::Fit;
use crate::read::known::Disagreement;
use crate::rule::advice::Advice;
use crate::rule::candidates::Subject;
use crate::rule::confidence::Confidence;
use crate::rule::diagnosis::{Diagnosis, diagnose};
use crate::rule::drift::Run;
use crate::rule::hints::should_change;
use crate::rule::rules::{Base, Rule};
use crate::thresholds::{ENOUGH_CHANGE, ENOUGH_ROWS, FLIPS_APART, STILL};
use crate::verdict::faults::{spin_faults, wrong_pace, wrong_rule};
use crate::verdict::outcome::{Outcome, Recording, Verdict};
use std::f64::consts::TAU;

/// A trial that is over, and what it is held to.
struct End<'a> {
    trial: &'a Trial,
    subject: &'a Subject,
    options: &'a Options,
    laws: &'a [Law],
    flips: Option<&'a FlipCount>,
    /// Whether there is nothing that the body should do.
    still: bool,
}

/// The verdict on a trial of a body with moments in this unit, kg m².
pub(crate) fn verdict(
    trial: Trial,
    subject: &Subject,
    unit: f64,
    fit: Option<Fit>,
    options: &Options,
) -> Verdict {
    let free = subject.torque.is_none();
    let mut laws = trial.laws.kept(|law| options.allowed(law));
    laws.retain(|law| free || matches!(law.name, LawName::Unit | LawName::Consistency));
    let flips = trial.laws.flips().filter(|_| free);
    let still = free && is_still(&trial, subject);
    let end = End { trial: &trial, subject, options, laws: &laws, flips: flips.as_ref(), still };
    let mut diagnosis = end.diagnosis();
    let complaints = end.complaints(diagnosis.as_ref());
    let outcome = end.outcome(complaints.is_empty());
    if let Some(diagnosis) = &mut diagnosis {
        end.weigh_drift(diagnosis);
        end.contradict(diagnosis);
        let kept = matches!(outcome, Outcome::Passed | Outcome::TooShort)
            && laws.iter().all(|law| law.growth.rank() == 0);
        diagnosis.advice = Advice::of(&diagnosis.confidence, &diagnosis.best.rule, diagnosis.single, kept);
        diagnosis.in_units_of(unit);
        diagnosis.name_engines(trial.known.said.engine.as_deref());
    }
    let ends = trial.laws.separatrix().filter(|ends| free && ends.iter().all(|x| x.is_finite()));
    let untraceable = !still && trial.laws.untraceable();
    let Trial { known, laws: followed, first, .. } = trial;
    let has_attitude = first.attitude.is_some();
    Verdict {
        outcome,
        record: Recording {
            rows: trial.rows,
            duration: followed.seen.last.t - first.t,
            step: known.clock.step,
            rounding: known.floor.size,
            has_attitude,
            missing: missing(has_attitude, known.said.kind),
            gaps: trial.gaps,
            sign_changes: followed.seen.sign_changes,
            engine: known.said.engine,
            ignored: known.said.ignored,
            notes: known.said.notes,
        },
        moments: known.moments,
        torque: known.said.torque,
        file_mistakes: known.reading.mistakes(),
        resets: trial.resets,
        laws,
        flips,
        separatrix: ends,
        diagnosis,
        complaints,
        options: *options,
        fit,
        untraceable,
        curve: followed.points.into_all(),
    }
}

/// Whether there is nothing that the body should do, nor does it.
fn is_still(trial: &Trial, subject: &Subject) -> bool {
    let (laws, floor) = (&trial.laws, trial.known.floor.size);
    laws.seen.constant
        && !should_change(subject, trial.sample.pairs(), floor)
        && (laws.on_axis() || !laws.untraceable() && laws.seen.moved <= STILL * floor)
}

impl End<'_> {
    const fn free(&self) -> bool {
        self.subject.torque.is_none()
    }

    /// Whether a law is broken by more than is allowed.
    fn broken(&self) -> bool {
        let over = |law: &Law| self.options.allowed(law.name).is_some_and(|most| law.most.abs() > most);
        self.laws.iter().any(over)
    }

    /// By how much the attitude turns otherwise than the spin says, if by more than is allowed.
    fn otherwise(&self) -> Option<f64> {
        let allowed = self.options.allowed(LawName::Consistency).unwrap_or(self.options.threshold);
        let law = self.laws.iter().find(|law| law.name == LawName::Consistency && law.most > allowed);
        law.map(|law| law.most)
    }

    fn diagnosis(&self) -> Option<Diagnosis> {
        let Trial { known, sample, pairs, .. } = self.trial;
        let share = sample.seen() as f64 / (*pairs).max(1) as f64;
        if self.still { None } else { diagnose(self.subject, sample, known, share) }
    }

    fn complaints(&self, diagnosis: Option<&Diagnosis>) -> Vec<Complaint> {
        let trial = self.trial;
        let mut all = Vec::new();
        all.extend(trial.ended.clone().map(|at| Complaint::Ended { at }));
        all.extend(self.flips.into_iter().flat_map(spin_faults));
        all.extend(trial.second.as_ref().map(|Disagreement { column, off, line }| Complaint::OtherSpin {
            column: column.clone(),
            off: *off,
            line: *line,
        }));
        let (constant, moved) = (trial.laws.seen.constant, trial.laws.seen.moved);
        let enough = ENOUGH_CHANGE.max(STILL * trial.known.floor.size);
        if self.free() && !self.still && constant && moved > enough {
            all.push(Complaint::Constant { moved });
        }
        all.extend(trial.stopped.map(|(line, turn)| Complaint::TooFar { line, turn }));
        if trial.sample.seen() == 0 {
            all.push(Complaint::NoSteps);
        }
        all.extend(self.otherwise().map(|off| Complaint::Otherwise { off }));
        if self.free() && trial.rows >= ENOUGH_ROWS {
            all.extend(diagnosis.and_then(wrong_rule));
            all.extend(wrong_pace(self.laws, trial.laws.ways_round(), self.options));
        }
        all
    }

    /// Of few digits a wrong rule may fit each step: what the whole record does is held against it too.
    fn weigh_drift(&self, diagnosis: &mut Diagnosis) {
        let Trial { known, laws, first, sample, .. } = self.trial;
        let miscounted = |flips: &FlipCount| flips.found.abs_diff(flips.exact) > FLIPS_APART;
        let astray = self.free() && (self.broken() || self.flips.is_some_and(miscounted));
        if let Some(h) = known.clock.step
            && known.floor.few
            && astray
            && diagnosis.confidence == Confidence::ToRounding
        {
            let flips = self.flips.map(|flips| flips.found);
            let run = Run { first: *first, last: laws.seen.last, h, flips, floor: known.floor.size };
            diagnosis.by_drift(self.subject, sample, &run);
        }
    }

    /// A rule that keeps a law does not make every step of a record that breaks it.
    fn contradict(&self, diagnosis: &mut Diagnosis) {
        let keeps = match diagnosis.best.rule {
            Rule { base: Base::Method(method, _), alteration: None } => {
                let kept = method.info().conserved;
                [kept.energy, kept.momentum, kept.direction]
            }
            Rule { base: Base::PositionStage(_), alteration: None } => [true; 3],
            _ => return,
        };
        let kept = |law: LawName| match law {
            LawName::Energy => keeps[0],
            LawName::Momentum => keeps[1],
            LawName::Direction => keeps[2],
            _ => false,
        };
        let broken =
            |law: &Law| kept(law.name) && self.options.allowed(law.name).is_some_and(|most| law.most > most);
        if diagnosis.confidence == Confidence::ToRounding && self.laws.iter().any(broken) {
            diagnosis.confidence = Confidence::MostSteps;
        }
    }

    fn outcome(&self, no_complaint: bool) -> Outcome {
        let Trial { known, laws, resets, ended, .. } = self.trial;
        // Of equal moments a constant spin is all of the motion, and not a start along an axis.
        let uniform = laws.has_equal_moments() && self.trial.first.attitude.is_some();
        let broken = self.broken();
        if !known.reading.mistakes().is_empty() || !resets.is_empty() || ended.is_some() {
            Outcome::Failed
        } else if !self.free() || self.still && !broken && self.otherwise().is_none() && !uniform {
            Outcome::NothingToJudge
        } else if broken || !no_complaint {
            Outcome::Failed
        } else if laws.untraceable() {
            // What is right here is not known.
            Outcome::NothingToJudge
        } else if self.trial.rows < ENOUGH_ROWS || laws.seen.turned < TAU && laws.seen.moved < ENOUGH_CHANGE {
            Outcome::TooShort
        } else {
            Outcome::Passed
        }
    }
}

/// What a record without attitudes, or of attitudes alone, has nothing of.
fn missing(attitude: bool, kind: Kind) -> Vec<LawName> {
    match (attitude, kind) {
        (false, _) => vec![LawName::Direction, LawName::Unit, LawName::Consistency],
        (true, Kind::Attitude) => vec![LawName::Consistency],
        _ => Vec::new(),
    }
}
