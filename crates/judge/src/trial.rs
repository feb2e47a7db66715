//! A trial: rows in, what they do to the laws noted, and the verdict at the end.

use crate::clock::Clock;
use crate::columns::Kind;
use crate::derived::too_far;
use crate::diagnosis::{Floor, Run, Sample, Sure, diagnose, should_change};
use crate::error::Error;
use crate::faults::{wrong_pace, wrong_rule};
use crate::laws::{LawName, Laws, angle_between};
use crate::reading::Reading;
use crate::state::{Pair, Row};
use crate::suspects::Subject;
use crate::verdict::{Gaps, Options, Outcome, Reset, Verdict};
use nalgebra::Vector3;
use std::f64::consts::TAU;
use tumbling::dynamics::euler;

/// Fewer rows than this pass nothing, nor does a record in which the body neither turns once round nor should change its spin by a tenth.
const ENOUGH: u64 = 8;

/// A trial as far as it has come.
pub(crate) struct Trial {
    pub laws: Laws,
    pub first: Row,
    pub sample: Sample,
    pub clock: Clock,
    pub rows: u64,
    pub resets: Vec<Reset>,
    pub gaps: Option<Gaps>,
    pub last: Option<Row>,
    pub moments: Vector3<f64>,
    pub torque: Option<Vector3<f64>>,
    /// The most that a step was off the law, and how many steps there were.
    pub off: f64,
    pub steps: u64,
    /// Whether the record tells spins.
    pub told: bool,
    /// At which line the attitude turns too far to tell which way, and by how much, rad.
    pub stopped: Option<(usize, f64)>,
    /// How a second vector of the record is at odds with the first, in words.
    pub second: Option<String>,
    /// The most that a step before the last was off the law in spin, and the last; the most in turn, rad; and the rounding of the numbers.
    pub most: f64,
    pub now: f64,
    pub turn_off: f64,
    pub floor: f64,
    /// Where the numbers end, and with what.
    pub ended: Option<String>,
    /// Whether the record has fewer digits than single precision.
    pub few: bool,
}

/// No more resets than this are told one by one.
const RESETS: usize = 16;

impl Trial {
    pub(crate) fn row(&mut self, state: &Row) -> Result<(), Error> {
        let mut steps = 0.0;
        if let Some(last) = self.last.replace(*state) {
            let (h, times) = self.clock.between(last.t, state.t);
            steps = times;
            if times != 1.0 {
                let gaps = self.gaps.get_or_insert(Gaps { count: 0, line: state.line, longest: 0.0 });
                gaps.count += 1;
                gaps.longest = gaps.longest.max(times);
            }
            let to_start = self.starts_anew(&last, state) || self.comes_back(&last, state, times);
            let jumps = times == 1.0 && self.jumps(&Pair { from: last, to: *state, h });
            if (to_start || jumps) && self.resets.len() < RESETS {
                let to_rest = state.omega == Vector3::zeros();
                let to_start = to_start && !to_rest;
                let line = state.ahead.map_or(state.line, |(line, _)| line);
                self.resets.push(Reset { line, time: state.t, to_rest, to_start });
            }
            if self.resets.is_empty() && times == 1.0 {
                let pair = Pair { from: last, to: *state, h };
                if self.told {
                    self.laws.pair(&pair);
                }
                if self.told || state.ahead.is_some() {
                    self.sample.push(&pair);
                }
            }
        }
        if self.resets.is_empty() {
            self.laws.push(state, steps)?;
        }
        Ok(())
    }

    /// A step that is a hundred times as far from the law as the steps before it were, and farther than a rule's error in one step can
    /// be: the law itself changes the spin by no more than the angle turned.
    fn jumps(&mut self, pair: &Pair) -> bool {
        let (from, to) = (pair.from.omega, pair.to.omega);
        // Of attitudes alone a spin that is out of all proportion is what is to be found.
        let speed = if self.told { from.norm().max(to.norm()) } else { from.norm() };
        let mean = (from + to) / 2.0;
        let rate = euler::angular_acceleration(&self.moments, &mean, &self.torque(pair));
        let spin = (to - from - rate * pair.h).norm() / speed;
        let turn = match (pair.turn(), speed * pair.h < 1.0) {
            (Some(turn), true) => (turn - mean * pair.h).norm(),
            _ => 0.0,
        };
        let off = spin.max(turn);
        if !off.is_finite() {
            return false;
        }
        self.most = self.most.max(self.now);
        self.now = spin;
        // A slow body turns little in a step: what is no jump for a fast one is many steps for it.
        let thrown = self.steps > 8
            && turn > 20.0 * speed * pair.h
            && turn > 100.0 * self.turn_off
            && turn > 1e3 * self.floor;
        self.turn_off = self.turn_off.max(turn);
        if thrown {
            return true;
        }
        let jumps = self.steps > 8 && off > 0.2 && off > 3.0 * speed * pair.h && off > 100.0 * self.off;
        if !jumps {
            // Forgotten slowly, so that a rule that goes astray now and then is known to.
            self.off = off.max(0.98 * self.off);
            self.steps += 1;
        }
        jumps
    }

    /// Back at the spin of the start, to its last digit, by a step that is farther from the law than any before: a record without attitudes
    /// that starts anew where the spin is near its first value anyway.
    fn comes_back(&self, last: &Row, state: &Row, times: f64) -> bool {
        let (first, now, was) = (&self.first.omega, &state.omega, &last.omega);
        let h = state.t - last.t;
        if self.steps < 8
            || times != 1.0
            || state.attitude.is_some()
            || (now - first).norm() > 1e-12 * first.norm()
        {
            return false;
        }
        let rate = euler::angular_acceleration(&self.moments, &((was + now) / 2.0), &Vector3::zeros());
        let off = (now - was - rate * h).norm() / now.norm().max(was.norm());
        off > 4.0 * self.most.max(self.now) && off > 64.0 * self.floor
    }

    /// The torque in body axes, for a mean over the step.
    fn torque(&self, pair: &Pair) -> Vector3<f64> {
        match (self.torque, pair.from.attitude) {
            (Some(torque), Some(q)) => {
                tumbling::attitude::rotation_matrix(&q).tr_mul(&torque) / q.norm_squared()
            }
            _ => Vector3::zeros(),
        }
    }

    /// A body that moves is at rest all of a sudden, or back at the start without a way there.
    fn starts_anew(&self, last: &Row, state: &Row) -> bool {
        let (before, now) = (last.omega.norm(), state.omega.norm());
        if before > 0.0 && now == 0.0 {
            return before > 1e-3 * self.first.omega.norm();
        }
        let back = (state.omega - self.first.omega).norm() <= 1e-12 * self.first.omega.norm();
        let Some(((first, q), was)) = self.first.attitude.zip(state.attitude).zip(last.attitude) else {
            return back && (last.omega - state.omega).norm() > 0.2 * now;
        };
        let turned = angle_between(&was, &q);
        back && angle_between(&first, &q) < 1e-12
            && turned > 0.2
            && turned > 1.5 * before.max(now) * (state.t - last.t)
    }

    pub(crate) fn end(
        self,
        subject: &Subject,
        reading: &Reading,
        kind: Kind,
        floor: f64,
        engine: Option<String>,
        options: &Options,
    ) -> Verdict {
        let Self { laws, first, sample, clock, rows, resets, gaps, stopped, second, ended, few, .. } = self;
        let free = subject.torque.is_none();
        let still = free
            && laws.constant
            && !should_change(subject, sample.pairs(), floor)
            && (laws.on_axis() || !laws.untraceable() && laws.moved <= 100.0 * floor);
        let few = Floor { size: floor, few };
        let mut diagnosis = if still { None } else { diagnose(subject, &sample, few, kind.is_momentum()) };
        let mut kept = laws.kept(|law| options.allowed(law));
        if !free {
            kept.retain(|law| matches!(law.name, LawName::Unit | LawName::Consistency));
        }
        let mut complaints = Vec::new();
        complaints.extend(ended.map(|at| format!("the numbers end at {at}. Judged up to there")));
        let ended = !complaints.is_empty();
        let flips = laws.flips().filter(|_| free);
        if let Some(t) = flips.as_ref().and_then(|flips| flips.turned_over) {
            complaints.push(format!(
                "the spin turns over at {t:.4} s about the axis that it should circle for ever"
            ));
        }
        match flips.as_ref().map(|flips| (flips.found, flips.exact)) {
            Some((0, wanted)) if wanted > 0 => {
                complaints.push(format!(
                    "the spin along the middle axis never changes sign, and should do so {}",
                    times(wanted)
                ));
            }
            Some((found, 0)) if found > 0 => {
                complaints.push(format!(
                    "the spin along the middle axis changes sign {}, and should never do so",
                    times(found)
                ));
            }
            _ => {}
        }
        complaints.extend(second);
        if free && !still && laws.constant && laws.moved > f64::max(0.1, 100.0 * floor) {
            let moved = 100.0 * laws.moved;
            complaints.push(format!(
                "the spin stays as it is at the start, and should change by {moved:.0} % of it"
            ));
        }
        if let Some((line, turn)) = stopped {
            complaints.push(format!("line {line}: {}. Judged up to there", too_far(turn)));
        }
        if sample.seen() == 0 {
            complaints.push("no two rows are one step apart: no rule can be tried".into());
        }
        let consistent = options.allowed(LawName::Consistency).unwrap_or(options.threshold);
        let otherwise = kept.iter().find(|law| law.name == LawName::Consistency && law.most > consistent);
        let turns_otherwise = otherwise.is_some();
        if let Some(law) = otherwise {
            let off = 100.0 * law.most;
            complaints
                .push(format!("the attitude does not turn as the spin says, by up to {off:.1} % of it"));
        }
        // Of a few rows any rule may be had.
        if free && rows >= ENOUGH {
            complaints.extend(diagnosis.as_ref().and_then(wrong_rule));
            complaints.extend(wrong_pace(&kept, laws.ways_round(), options));
        }
        let misread = reading.mistakes();
        let broken =
            kept.iter().any(|law| options.allowed(law.name).is_some_and(|most| law.most.abs() > most));
        // Of few digits a wrong rule may fit each step: what the whole record does is held against it too.
        let astray =
            free && (broken || flips.as_ref().is_some_and(|flips| flips.found.abs_diff(flips.exact) > 1));
        if let (Some(found), Some(h)) = (&mut diagnosis, clock.step)
            && few.few
            && astray
            && found.sure == Sure::ToRounding
        {
            let flips = flips.as_ref().map(|flips| flips.found);
            found.by_drift(subject, &sample, &Run { first, last: laws.last, h, flips, floor });
        }
        let outcome = if !misread.is_empty() || !resets.is_empty() || ended {
            Outcome::Failed
        } else if !free || still && !broken && !turns_otherwise {
            Outcome::NothingToJudge
        } else if broken || !complaints.is_empty() {
            Outcome::Failed
        } else if laws.untraceable() {
            // What is right here nobody can tell.
            Outcome::NothingToJudge
        } else if rows < ENOUGH || laws.turned < TAU && laws.moved < 0.1 {
            Outcome::TooShort
        } else {
            Outcome::Passed
        };
        Verdict {
            engine,
            moments: subject.moments,
            torque: subject.torque,
            rows,
            duration: laws.last.t - first.t,
            step: clock.step,
            rounding: floor,
            has_attitude: first.attitude.is_some(),
            misread,
            untold: untold(first.attitude.is_some(), kind),
            resets,
            gaps,
            sign_changes: laws.sign_changes,
            laws: kept,
            flips,
            separatrix: laws.separatrix().filter(|ends| free && ends.iter().all(|x| x.is_finite())),
            diagnosis,
            complaints,
            options: *options,
            fit: None,
            ignored: Vec::new(),
            notes: Vec::new(),
            untraceable: !still && laws.untraceable(),
            curve: laws.points.into_all(),
            outcome,
        }
    }
}

/// What a record without attitudes, or of attitudes alone, does not tell.
fn untold(attitude: bool, kind: Kind) -> Vec<LawName> {
    match (attitude, kind) {
        (false, _) => vec![LawName::Direction, LawName::Unit, LawName::Consistency],
        (true, Kind::Attitude) => vec![LawName::Consistency],
        _ => Vec::new(),
    }
}

fn times(count: u64) -> String {
    if count == 1 { "once".into() } else { format!("{count} times") }
}
