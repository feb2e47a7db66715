//! A trial: rows in, what they do to the laws noted, and the verdict at the end.

use crate::advice::Advice;
use crate::candidates::Subject;
use crate::clock::Clock;
use crate::columns::Kind;
use crate::confidence::Confidence;
use crate::diagnosis::{Circumstances, Diagnosis, diagnose};
use crate::drift::Run;
use crate::error::Error;
use crate::faults::{spin_faults, wrong_pace, wrong_rule};
use crate::findings::Complaint;
use crate::hints::should_change;
use crate::jumps::Jumps;
use crate::law::{FlipCount, Law, LawName};
use crate::laws::Laws;
use crate::reading::Reading;
use crate::rules::{Base, Rule};
use crate::sample::{Floor, Sample};
use crate::state::{Pair, Row};
use crate::thresholds::{ENOUGH_CHANGE, ENOUGH_ROWS, FLIPS_APART, RESETS, STILL};
use crate::verdict::{Gaps, Options, Outcome, Recording, Reset, Verdict};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// What holds for a record as a whole.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Conditions {
    pub kind: Kind,
    pub clock: Clock,
    /// The rounding of the numbers, relative to 1.
    pub floor: f64,
    /// Whether the record has fewer digits than single precision.
    pub few: bool,
    /// Whether its numbers are those of single precision.
    pub single: bool,
}

/// A trial as far as it has come.
pub(crate) struct Trial {
    conditions: Conditions,
    laws: Laws,
    first: Row,
    sample: Sample,
    jumps: Jumps,
    resets: Vec<Reset>,
    gaps: Option<Gaps>,
    last: Option<Row>,
    pub rows: u64,
    /// The number of pairs of rows that follow one another, however far apart.
    pairs: u64,
    /// At which line the attitude turns too far for its direction to be known, and by how much, rad.
    pub stopped: Option<(usize, f64)>,
    /// How a second vector of the record is at odds with the first.
    pub second: Option<Complaint>,
    /// Where the numbers end, and with what.
    pub ended: Option<String>,
}

/// What is found in a whole record, before it is judged.
struct Findings {
    free: bool,
    /// Whether there is nothing that the body should do.
    still: bool,
    laws: Vec<Law>,
    flips: Option<FlipCount>,
    diagnosis: Option<Diagnosis>,
    /// Whether a law is broken by more than is allowed.
    broken: bool,
    /// By how much the attitude turns otherwise than the spin says, if by more than is allowed.
    otherwise: Option<f64>,
}

impl Trial {
    pub(crate) fn new(
        subject: &Subject,
        first: Row,
        direction: Option<Vector3<f64>>,
        conditions: Conditions,
    ) -> Result<Self, Error> {
        let has_spin = conditions.kind != Kind::Attitude;
        Ok(Self {
            conditions,
            laws: Laws::new(&subject.moments, &first, direction, conditions.floor)?,
            first,
            sample: Sample::new(),
            jumps: Jumps::new(first, subject.moments, subject.torque, has_spin, conditions.floor),
            resets: Vec::new(),
            gaps: None,
            last: None,
            rows: 0,
            pairs: 0,
            stopped: None,
            second: None,
            ended: None,
        })
    }

    /// One more row.
    pub(crate) fn row(&mut self, state: &Row) -> Result<(), Error> {
        let mut steps = 0.0;
        if let Some(last) = self.last.replace(*state) {
            let (h, times) = self.conditions.clock.between(last.t, state.t);
            steps = times;
            if times > 1.0 {
                let gaps = self.gaps.get_or_insert(Gaps { count: 0, line: state.line, longest: 0.0 });
                gaps.count += 1;
                gaps.longest = gaps.longest.max(times);
            }
            let pair = Pair { from: last, to: *state, h };
            let reset = self.jumps.reset(&pair, times);
            if self.resets.len() < RESETS {
                self.resets.extend(reset);
            }
            self.pairs += u64::from(self.resets.is_empty());
            if self.resets.is_empty() && times == 1.0 {
                if self.jumps.has_spin {
                    self.laws.pair(&pair);
                }
                if self.jumps.has_spin || state.ahead.is_some() {
                    self.sample.push(&pair);
                }
            }
        }
        if self.resets.is_empty() {
            self.laws.push(state, steps)?;
        }
        Ok(())
    }

    /// The verdict.
    pub(crate) fn end(self, subject: &Subject, reading: &Reading, options: &Options) -> Verdict {
        let mut found = self.findings(subject, options);
        let complaints = self.complaints(&found, options);
        self.weigh_drift(&mut found, subject);
        contradicted(&mut found, options);
        let file_mistakes = reading.mistakes();
        let outcome = self.outcome(&found, !file_mistakes.is_empty(), complaints.is_empty());
        let kept = outcome == Outcome::Passed && found.laws.iter().all(|law| law.growth.rank() == 0);
        if let Some(diagnosis) = &mut found.diagnosis {
            let Diagnosis { confidence, best, single, .. } = diagnosis;
            diagnosis.advice = Advice::of(confidence, &best.rule, *single, kept);
        }
        let Conditions { kind, clock, floor, .. } = self.conditions;
        let has_attitude = self.first.attitude.is_some();
        let ends = self.laws.separatrix().filter(|ends| found.free && ends.iter().all(|x| x.is_finite()));
        Verdict {
            outcome,
            record: Recording {
                engine: None,
                rows: self.rows,
                duration: self.laws.seen.last.t - self.first.t,
                step: clock.step,
                rounding: floor,
                has_attitude,
                ignored: Vec::new(),
                notes: Vec::new(),
                missing: missing(has_attitude, kind),
                gaps: self.gaps,
                sign_changes: self.laws.seen.sign_changes,
            },
            moments: subject.moments,
            torque: subject.torque,
            file_mistakes,
            resets: self.resets,
            laws: found.laws,
            flips: found.flips,
            separatrix: ends,
            diagnosis: found.diagnosis,
            complaints,
            options: *options,
            fit: None,
            untraceable: !found.still && self.laws.untraceable(),
            curve: self.laws.points.into_all(),
        }
    }

    fn findings(&self, subject: &Subject, options: &Options) -> Findings {
        let Conditions { kind, clock, floor, few, single } = self.conditions;
        let (laws, sample) = (&self.laws, &self.sample);
        let free = subject.torque.is_none();
        let still = free
            && laws.seen.constant
            && !should_change(subject, sample.pairs(), floor)
            && (laws.on_axis() || !laws.untraceable() && laws.seen.moved <= STILL * floor);
        let about = Circumstances {
            floor: Floor { size: floor, few, single },
            of_momentum: kind.is_momentum(),
            per_row: clock.per_row,
            share: sample.seen() as f64 / self.pairs.max(1) as f64,
        };
        let diagnosis = if still { None } else { diagnose(subject, sample, about) };
        let mut kept = laws.kept(|law| options.allowed(law));
        if !free {
            kept.retain(|law| matches!(law.name, LawName::Unit | LawName::Consistency));
        }
        let consistent = options.allowed(LawName::Consistency).unwrap_or(options.threshold);
        let otherwise = kept.iter().find(|law| law.name == LawName::Consistency && law.most > consistent);
        let otherwise = otherwise.map(|law| law.most);
        let broken =
            kept.iter().any(|law| options.allowed(law.name).is_some_and(|most| law.most.abs() > most));
        let flips = laws.flips().filter(|_| free);
        Findings { free, still, laws: kept, flips, diagnosis, broken, otherwise }
    }

    fn complaints(&self, found: &Findings, options: &Options) -> Vec<Complaint> {
        let mut all = Vec::new();
        all.extend(self.ended.clone().map(|at| Complaint::Ended { at }));
        all.extend(found.flips.iter().flat_map(spin_faults));
        all.extend(self.second.clone());
        let (constant, moved) = (self.laws.seen.constant, self.laws.seen.moved);
        if found.free && !found.still && constant && moved > ENOUGH_CHANGE.max(STILL * self.conditions.floor)
        {
            all.push(Complaint::Constant { moved });
        }
        all.extend(self.stopped.map(|(line, turn)| Complaint::TooFar { line, turn }));
        if self.sample.seen() == 0 {
            all.push(Complaint::NoSteps);
        }
        all.extend(found.otherwise.map(|off| Complaint::Otherwise { off }));
        if found.free && self.rows >= ENOUGH_ROWS {
            all.extend(found.diagnosis.as_ref().and_then(wrong_rule));
            all.extend(wrong_pace(&found.laws, self.laws.ways_round(), options));
        }
        all
    }

    /// Of few digits a wrong rule may fit each step: what the whole record does is held against it too.
    fn weigh_drift(&self, found: &mut Findings, subject: &Subject) {
        let Conditions { clock, floor, few, .. } = self.conditions;
        let miscounted = |flips: &FlipCount| flips.found.abs_diff(flips.exact) > FLIPS_APART;
        let astray = found.free && (found.broken || found.flips.as_ref().is_some_and(miscounted));
        let flips = found.flips.as_ref().map(|flips| flips.found);
        if let (Some(diagnosis), Some(h)) = (&mut found.diagnosis, clock.step)
            && few
            && astray
            && diagnosis.confidence == Confidence::ToRounding
        {
            let run = Run { first: self.first, last: self.laws.seen.last, h, flips, floor };
            diagnosis.by_drift(subject, &self.sample, &run);
        }
    }

    /// Whether the body has equal moments, and attitudes that show how it turns: a constant spin is then all
    /// of its motion, and not a start along an axis.
    fn turns_uniformly(&self) -> bool {
        self.laws.has_equal_moments() && self.first.attitude.is_some()
    }

    fn outcome(&self, found: &Findings, file_mistakes: bool, no_complaint: bool) -> Outcome {
        let Findings { free, still, broken, .. } = *found;
        let seen = &self.laws.seen;
        if file_mistakes || !self.resets.is_empty() || self.ended.is_some() {
            Outcome::Failed
        } else if !free || still && !broken && found.otherwise.is_none() && !self.turns_uniformly() {
            Outcome::NothingToJudge
        } else if broken || !no_complaint {
            Outcome::Failed
        } else if self.laws.untraceable() {
            // What is right here is not known.
            Outcome::NothingToJudge
        } else if self.rows < ENOUGH_ROWS || seen.turned < TAU && seen.moved < ENOUGH_CHANGE {
            Outcome::TooShort
        } else {
            Outcome::Passed
        }
    }
}

/// A rule that keeps a law does not make every step of a record that breaks it.
fn contradicted(found: &mut Findings, options: &Options) {
    let Some(diagnosis) = &mut found.diagnosis else { return };
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
    let broken = |law: &Law| kept(law.name) && options.allowed(law.name).is_some_and(|most| law.most > most);
    if diagnosis.confidence == Confidence::ToRounding && found.laws.iter().any(broken) {
        diagnosis.confidence = Confidence::MostSteps;
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
