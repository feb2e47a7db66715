//! The end of a trial: one verdict from its laws and steps.

use crate::law::LawName;
use crate::laws::{FlipCount, Law, Trial};
use crate::options::Options;
use crate::read::{FileMistake, Kind, Note, Pair, median};
use crate::rule::{Advice, Confidence, Diagnosis, Rule, Subject, Whole, diagnose};
use crate::thresholds::*;
use crate::verdict::{Complaint, Outcome, Recording, Seen, Verdict};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// A finished trial, and the limits that it is judged by.
struct End<'a> {
    trial: &'a Trial,
    subject: &'a Subject,
    options: &'a Options,
    laws: &'a [Law],
    flips: Option<&'a FlipCount>,
    /// Whether the motion should be constant, and is.
    still: bool,
}

/// The verdict on a trial.
pub(crate) fn verdict(trial: Trial, subject: &Subject, options: &Options) -> Verdict {
    let free = subject.torque.is_none();
    let mut laws = trial.laws.kept(|law| options.allowed(law));
    laws.retain(|law| free || matches!(law.name, LawName::Unit | LawName::Consistency));
    let flips = trial.laws.flips().filter(|_| free);
    let still = free && is_still(&trial, subject);
    let floor = trial.known.floor.size;
    let end = End { trial: &trial, subject, options, laws: &laws, flips: flips.as_ref(), still };
    let mut complaints = end.complaints();
    let (whole, steps) = (end.whole(&complaints), trial.sample());
    let mut diagnosis = if still { None } else { diagnose(subject, &steps, &trial.known, &whole) };
    let enough = diagnosis.as_ref().filter(|_| free && trial.rows >= ENOUGH_ROWS);
    complaints.extend(enough.and_then(wrong_rule));
    let outcome = end.outcome(complaints.is_empty());
    let short = diagnosis.as_mut().filter(|_| outcome == Outcome::TooShort);
    short.into_iter().for_each(|found| found.advice = vec![Advice::LONGER]);
    if let Some(named) = diagnosis.as_ref().filter(|found| found.confidence.names_a_rule()) {
        // An error in a law that the rule breaks is no rounding error, if it exceeds that of the numbers.
        let graded = trial.laws.kept(|_| Some(0.0));
        let of_rule = |name| is_length(name) && !named.best.rule.keeps(name);
        for law in laws.iter_mut().filter(|law| of_rule(law.name) && law.most > LAW_ROUNDINGS[0] * floor) {
            law.growth = graded.iter().find(|x| x.name == law.name).map_or(law.growth, |x| x.growth);
        }
    }
    let again = trial.written_again().map(|(count, line)| Note::Again(count, line));
    // A push makes the flips after it late, but for one at the start.
    let pushes = diagnosis.iter().flat_map(|found| &found.jumps);
    let is_pushed = pushes.filter(|jump| jump.line > trial.first.line + 1).count() > 0;
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
            notes: known.said.notes.into_iter().chain(again).collect(),
        },
        moments: known.moments,
        torque: known.said.torque,
        file_mistakes: known.reading.mistakes(),
        resets: trial.resets,
        laws,
        flips: flips.map(|x| FlipCount { late: x.late.filter(|_| !is_pushed), ..x }),
        separatrix: followed.separatrix().filter(|ends| free && ends.iter().all(|x| x.is_finite())),
        diagnosis,
        complaints,
        options: *options,
        untraceable: !still && followed.untraceable(),
        curve: followed.points.all,
    }
}

/// Whether the motion should be constant, and is.
fn is_still(trial: &Trial, subject: &Subject) -> bool {
    let (laws, floor) = (&trial.laws, trial.known.floor.size);
    laws.seen.constant
        && !subject.should_change(&trial.sample(), floor)
        && (laws.on_axis() || !laws.untraceable() && laws.seen.moved <= STILL * floor)
}

impl End<'_> {
    const fn free(&self) -> bool {
        self.subject.torque.is_none()
    }

    /// The laws that are broken by more than is allowed.
    fn broken(&self) -> impl Iterator<Item = &Law> {
        self.laws.iter().filter(|law| !self.options.allows(law))
    }

    /// By how much the turn of the attitude differs from the spin, if by more than is allowed.
    fn otherwise(&self) -> Option<f64> {
        let allowed = self.options.allowed(LawName::Consistency).unwrap_or(self.options.threshold);
        let allowed = self.trial.known.grid.map_or(allowed, |grid| allowed.max(grid.share()));
        let law = self.laws.iter().find(|law| law.name == LawName::Consistency && law.most > allowed);
        law.map(|law| law.most)
    }

    /// Evidence from the whole record, as opposed to its single steps.
    fn whole(&self, complaints: &[Complaint]) -> Whole {
        let Trial { known, steps, pairs, resets, ended, .. } = self.trial;
        let mistakes = known.reading.mistakes();
        // That may be the engine's wrong sign.
        let is_mirrored = mistakes.contains(&FileMistake::LeftHandedSpin);
        let sound = mistakes.is_empty() && resets.is_empty() && ended.is_none();
        let broken: Vec<LawName> = self.broken().map(|law| law.name).collect();
        let fails = !sound || !broken.is_empty() || !complaints.is_empty();
        let unkept = self.laws.iter().filter(|law| is_length(law.name) && law.growth.rank() > 0);
        let again = self.trial.written_again().is_some() || self.trial.tail().is_some();
        let of_again = |x: &Complaint| again && matches!(x, Complaint::Otherwise { seen: None, .. });
        let rows = |x: &Complaint| matches!(x, Complaint::Ended(_) | Complaint::Repeats(..)) || of_again(x);
        Whole {
            fails_otherwise: fails && broken.is_empty() && complaints.iter().all(rows),
            is_sound: broken.is_empty() && complaints.is_empty() && resets.is_empty() && !is_mirrored,
            broken,
            unkept: unkept.map(|law| law.name).collect(),
            fails,
            kept: self.laws.iter().all(|law| law.growth.rank() == 0),
            again,
            repeats: self.trial.repeats(),
            of_few_times: known.grid.is_some_and(|grid| !grid.named),
            share: *steps as f64 / (*pairs).max(1) as f64,
            on_wrong_side: complaints.iter().any(|complaint| {
                let seen = [Seen::BodyInWorld, Seen::WorldInBody].map(Some);
                matches!(complaint, Complaint::Otherwise { seen: way, .. } if seen.contains(way))
            }),
        }
    }

    /// Faults other than broken laws and a wrong rule.
    fn complaints(&self) -> Vec<Complaint> {
        let Trial { known, laws, steps, stopped, ended, rows, .. } = self.trial;
        let mut all = Vec::new();
        all.extend(ended.clone().map(Complaint::Ended));
        all.extend(self.trial.tail().map(|(rows, line, time)| Complaint::Repeats(rows, line, time)));
        all.extend(self.flips.into_iter().flat_map(|flips| spin_faults(flips, laws.shows_flips())));
        let moved = laws.seen.moved;
        if self.free()
            && !self.still
            && laws.seen.constant
            && moved > ENOUGH_CHANGE.max(STILL * known.floor.size)
        {
            all.push(Complaint::Constant(moved));
        }
        all.extend(stopped.map(|(line, turn)| Complaint::TooFar(line, turn)));
        if *steps == 0 {
            all.push(Complaint::NoSteps);
        }
        let seen = || turned(&self.trial.sample()).filter(|_| !self.trial.repeats());
        all.extend(self.otherwise().map(|off| Complaint::Otherwise { off, seen: seen() }));
        if self.free() && *rows >= ENOUGH_ROWS {
            let first = laws.separatrix().map(|x| x[0]);
            all.extend(wrong_pace(self.laws, first, [laws.periods(), laws.pace_left_open()], self.options));
        }
        all
    }

    fn outcome(&self, no_complaint: bool) -> Outcome {
        let Trial { known, laws, resets, ended, .. } = self.trial;
        // With equal moments the spin is constant in every motion, whatever the start.
        let uniform = laws.has_equal_moments() && self.trial.first.attitude.is_some();
        let broken = self.broken().next().is_some();
        if !known.reading.mistakes().is_empty() || !resets.is_empty() || ended.is_some() {
            Outcome::Failed
        } else if !self.free() || self.still && !broken && self.otherwise().is_none() && !uniform {
            Outcome::NothingToJudge
        } else if broken || !no_complaint {
            Outcome::Failed
        } else if laws.untraceable() {
            // The exact motion is not known here.
            Outcome::NothingToJudge
        } else if self.trial.rows < ENOUGH_ROWS || laws.seen.turned < TAU && laws.seen.moved < ENOUGH_CHANGE {
            Outcome::TooShort
        } else {
            Outcome::Passed
        }
    }
}

/// How the attitude turns, if most steps do not turn it by the spin.
fn turned(pairs: &[Pair]) -> Option<Seen> {
    let middle = |of: &dyn Fn(Vector3<f64>, Vector3<f64>, Matrix3<f64>) -> f64| {
        median(&mut pairs.iter().filter_map(|pair| {
            let start = UnitQuaternion::new_normalize(pair.from.attitude?).to_rotation_matrix().into_inner();
            Some(of(pair.turn()? / pair.h, (pair.from.omega + pair.to.omega) / 2.0, start))
        }))
    };
    let across = |a: Vector3<f64>, b: Vector3<f64>| a.cross(&b).norm() / (a.norm() * b.norm());
    let plain = middle(&|turn, spin, _| (turn - spin).norm() / spin.norm());
    let own = middle(&|turn, spin, _| across(turn, spin));
    let body = middle(&|turn, spin, start| across(start * turn, spin));
    let world = middle(&|turn, spin, start| across(turn, start * spin));
    let times = middle(&|turn, spin, _| turn.dot(&spin) / spin.norm_squared());
    match [plain, own, body.min(world)].map(|off| off < TURNS_AGREE) {
        [true, ..] => None,
        [_, true, _] => ((times - 1.0).abs() > PACE_APART).then_some(Seen::Times(times)),
        [.., true] => Some(if body <= world { Seen::BodyInWorld } else { Seen::WorldInBody }),
        _ => (own > NEARER_READING).then_some(Seen::OtherAxis),
    }
}

/// Whether it is a law of lengths, which needs no attitude.
const fn is_length(name: LawName) -> bool {
    matches!(name, LawName::Energy | LawName::Momentum)
}

/// The laws that cannot be judged without attitudes, or from attitudes alone.
fn missing(attitude: bool, kind: Kind) -> Vec<LawName> {
    match (attitude, kind) {
        (false, _) => vec![LawName::Direction, LawName::Unit, LawName::Consistency],
        (true, Kind::Attitude) => vec![LawName::Consistency],
        _ => Vec::new(),
    }
}

/// Wrong or missing flips, and a spin that reverses, if the digits are enough to show it.
fn spin_faults(flips: &FlipCount, [axis, shown]: [bool; 2]) -> impl Iterator<Item = Complaint> + use<> {
    let over = flips.turned_over.filter(|_| axis).map(Complaint::TurnedOver);
    let counted = match (flips.found, flips.exact) {
        (0, exact) if shown && exact > 0 => Some(Complaint::NeverFlips(exact)),
        (found, 0) if shown && found > 0 => Some(Complaint::Flips(found)),
        _ => None,
    };
    over.into_iter().chain(counted)
}

/// A rule that is wrong however small the step; if several fit equally well, all must be wrong.
fn wrong_rule(diagnosis: &Diagnosis) -> Option<Complaint> {
    let all_wrong = std::iter::once(&diagnosis.best.rule).chain(&diagnosis.alike).all(Rule::is_wrong);
    let wrong = diagnosis.confidence == Confidence::ToRounding && all_wrong;
    wrong.then(|| Complaint::WrongRule(Box::new(diagnosis.best.rule)))
}

/// A phase error beyond the default limit, if the caller has set none and the digits leave little of the
/// phase open. Near the separatrix, where 2 E I2 / L² changed by more than its first distance from 1 but
/// stayed within its limit, any period is right.
fn wrong_pace(
    laws: &[Law],
    first: Option<f64>,
    [periods, open]: [f64; 2],
    options: &Options,
) -> Option<Complaint> {
    let separatrix = laws.iter().find(|law| law.name == LawName::Separatrix && options.allows(law));
    if open > PHASE || separatrix.zip(first).is_some_and(|(law, first)| law.most > (first - 1.0).abs()) {
        return None;
    }
    let phase = laws.iter().find(|law| law.name == LawName::Phase)?;
    let allowed = PHASE + (PHASE + open) * periods;
    let wrong = options.allowed(LawName::Phase).is_none() && phase.most > allowed;
    wrong.then_some(Complaint::WrongPace { off: phase.most, periods, allowed })
}
