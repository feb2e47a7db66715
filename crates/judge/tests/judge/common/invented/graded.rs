//! Whether the judge says what made a record.

use super::rules::known;
use super::{Fault, Invented, Layout, Motion, Truth, is_still};
use nalgebra::UnitQuaternion;
use std::io;
use tumbling::step::Method;
use tumbling_judge::{
    Alteration, Base, Confidence, Diagnosis, FileMistake, Options, Outcome, Rule, Turn, Verdict, When, judge,
};

/// What the judge makes of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Named {
    /// The rule, first.
    Rightly,
    /// The rule, among those that make the same steps here; or the exact motion, from which it differs by
    /// less than rounding.
    AmongEquals,
    /// No rule.
    Not,
    /// Another rule.
    Wrongly,
}

impl Invented {
    /// Whether a rule is the one that made it.
    fn is(&self, rule: &Rule) -> bool {
        matches!(self.truth, Truth::Known(base) if self.is_as_said(rule) && self.is_base(base, rule))
    }

    /// Whether the fault is the one that was made.
    fn is_as_said(&self, rule: &Rule) -> bool {
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-2;
        match (self.fault, rule.alteration) {
            (Fault::Damped(wanted, place), Some(Alteration::Damped { rate, when, term: 1.0, .. })) => {
                near(rate, wanted) && (when == When::Open || when == place)
            }
            (Fault::Term(wanted), Some(Alteration::Term(times) | Alteration::TermOrTimes(times))) => {
                near(times, wanted)
            }
            // It is said of both.
            (
                Fault::Turned(Turn::TwiceBefore | Turn::TwiceAfter),
                Some(Alteration::Turned(Turn::TwiceBefore | Turn::TwiceAfter)),
            ) => true,
            (Fault::Turned(wanted), Some(Alteration::Turned(turn))) => turn == wanted,
            (Fault::Other(wanted, degrees), Some(Alteration::OtherMoments(moments, axes))) => {
                (moments / moments.sum() - wanted / wanted.sum()).norm() < 1e-2
                    && (axes.angle().to_degrees() - degrees).abs() < 1.0
            }
            // A spin that does not change, or is written alone, hides which of its values turned the body.
            (Fault::Turned(_), None) => self.layout == Layout::Spin,
            (Fault::Paced(times), found) if self.layout == Layout::Spin => {
                matches!(found, Some(Alteration::TermOrTimes(found)) if near(found * times, 1.0))
            }
            (Fault::Paced(times), Some(Alteration::Times(found))) => near(found * times, 1.0),
            (Fault::None | Fault::Hits(_) | Fault::Rest | Fault::Paced(_), None) => true,
            _ => false,
        }
    }

    fn is_base(&self, base: Base, rule: &Rule) -> bool {
        let plain = match base {
            Base::Engine(engine) if engine.limits.straight => Base::Straight(engine.method, engine.parts),
            Base::Engine(engine) => Base::Method(engine.method, engine.parts),
            other => other,
        };
        let every = self.every;
        match (plain, rule.base) {
            // A momentum that turns the body turns it about itself, and the spin in the body stays.
            _ if is_still(base) && !matches!(self.layout, Layout::Both | Layout::World) => {
                is_still(rule.base)
            }
            (_, Base::Engine(found)) => matches!(plain, Base::Method(m, _) if m == found.method),
            (Base::Exact, Base::Exact) | (Base::FrozenTensor(..), Base::FrozenTensor(..)) => true,
            (Base::MomentumForSpin(_), Base::MomentumForSpin(_)) => true,
            (Base::Method(..), Base::Method(..)) if is_still(plain) && is_still(rule.base) => true,
            (Base::Method(a, parts), Base::Method(b, found)) => {
                self.spins_alike(a) == self.spins_alike(b) && found == parts * every
            }
            (Base::PositionStage(parts), Base::PositionStage(found)) => found == parts * every,
            (Base::Straight(a, parts), Base::Straight(b, found)) => a == b && found == parts * every,
            _ => false,
        }
    }

    /// Of a record of spins alone the method whose spin is the same.
    fn spins_alike(&self, method: Method) -> Method {
        match method {
            Method::ExplicitEuler if self.layout == Layout::Spin => Method::SemiImplicitEuler,
            Method::RescaledLinearAttitude if self.layout == Layout::Spin => Method::Rescaled,
            other => other,
        }
    }

    /// What the judge made of it.
    fn named(&self, verdict: &Verdict) -> Named {
        let Some(found) = &verdict.diagnosis else { return Named::Not };
        let all = || std::iter::once(&found.best.rule).chain(&found.alike);
        let (first, any) = (found.leading.iter().any(|x| self.is(x)), all().any(|x| self.is(x)));
        // A spin alone leaves wrong sign, other moments and the other hand open: all are offered.
        let sure = found.confidence.names_a_rule();
        let is_own = |rule: &Rule| matches!(self.truth, Truth::Known(base) if self.is_base(base, rule));
        let in_mirror = |rule: &Rule| match self.fault {
            // The other hand's spin goes by the term with its own sign.
            Fault::Term(-1.0) => rule.alteration.is_none() && is_own(rule),
            // What is left of the other body, of the rule or of the motion.
            Fault::Other(..) => matches!(rule.alteration, Some(Alteration::OtherMoments(..))),
            _ => false,
        };
        let mirrored = (!sure || all().any(in_mirror))
            && matches!(self.fault, Fault::Term(-1.0) | Fault::Other(..))
            && verdict.file_mistakes.contains(&FileMistake::LeftHandedSpin)
            && verdict.to_string().contains("wrong sign");
        // The exact motion with the fault: the rule's own error is less than what is left.
        let of_fault = found.best.rule.base == Base::Exact && self.is_as_said(&found.best.rule);
        let near = found.confidence == Confidence::Near;
        // Times that are said to be wrong are, and by this much; those that are wrong are said to be.
        let said = verdict.file_mistakes.iter().find_map(|mistake| match mistake {
            FileMistake::Times(times) => Some(*times),
            _ => None,
        });
        let times = match self.fault {
            Fault::Paced(times) if matches!(self.layout, Layout::Both | Layout::World) => Some(1.0 / times),
            _ => None,
        };
        match (said, times) {
            (Some(said), times) if times.is_none_or(|times| (said / times - 1.0).abs() > 1e-2) => {
                return Named::Wrongly;
            }
            (None, Some(_)) if !any && !of_fault => return if sure { Named::Wrongly } else { Named::Not },
            _ => {}
        }
        let Truth::Known(base) = self.truth else { return self.outside(found, verdict.record.rounding) };
        match (sure, first, any) {
            (true, true, _) if found.alike.is_empty() => Named::Rightly,
            (true, true, _) if found.leading.len() == 1 => Named::Rightly,
            // What the digits do not show.
            (true, ..) if found.is_exact() && verdict.outcome != Outcome::Failed => Named::AmongEquals,
            (_, _, true) => Named::AmongEquals,
            // A spin that stays, turned as it is.
            _ if is_still(base) && is_still(found.best.rule.base) => Named::AmongEquals,
            _ if mirrored || sure && of_fault => Named::AmongEquals,
            // The rule is right, and a fault is not seen.
            _ if near && all().any(|x| self.is_base(base, &Rule::plain(x.base))) => Named::Not,
            (true, ..) => Named::Wrongly,
            (false, ..) => Named::Not,
        }
    }

    /// Whether the place in the step where damping acts is named rightly, not, or wrongly.
    fn places(&self, verdict: &Verdict) -> [u64; 3] {
        let is_said = |x: &&Diagnosis| x.confidence.names_a_rule() || x.confidence == Confidence::Altered;
        let said = verdict.diagnosis.as_ref().filter(is_said).and_then(|found| found.best.rule.alteration);
        let (Fault::Damped(_, place), Some(Alteration::Damped { when, .. })) = (self.fault, said) else {
            return [0; 3];
        };
        [when == place, when == When::Open, ![place, When::Open].contains(&when)].map(u64::from)
    }

    /// What is made of a rule that the judge does not know.
    fn outside(&self, found: &Diagnosis, rounding: f64) -> Named {
        // Less than the rounding of the first row and the last.
        let is_equal = || self.off(&found.best.rule).is_some_and(|off| off < 2.0 * rounding);
        match found.confidence.names_a_rule() && !found.is_exact() {
            true if is_equal() => Named::AmongEquals,
            true => Named::Wrongly,
            false => Named::Not,
        }
    }

    /// How far a plain rule is from all the steps that were made, before they were written, together:
    /// relative to the spin or in rad.
    fn off(&self, rule: &Rule) -> Option<f64> {
        let (Base::Method(method, parts), None) = (rule.base, rule.alteration) else { return None };
        let step = known(Base::Method(method, 1), self.body);
        let off = |two: &[Motion]| {
            let end = (0..parts).try_fold(two[0], |now, _| step(&now, self.between / f64::from(parts)))?;
            let [to, q] = [end.0, two[1].0].map(UnitQuaternion::new_normalize);
            let turn = if self.layout == Layout::Spin { 0.0 } else { to.angle_to(&q) };
            // Less what the arithmetic of a step leaves.
            Some(((end.1 - two[1].1).norm() / two[1].1.norm() + turn - 1e-15).max(0.0))
        };
        self.rows.windows(2).map(off).sum()
    }
}

/// Judges the records of this many seeds, and writes which are not named, or wrongly, or praised beside a
/// failure; a single one in full. How many are named rightly, among equals, not and wrongly, and how many are
/// praised and refused (an attitude that turns too far from row to row); and of how many that are damped the
/// place in the step is named rightly, not and wrongly.
pub fn counted(first: u64, count: u64, is_known: bool, out: &mut impl io::Write) -> io::Result<[u64; 9]> {
    let mut counts = [0; 9];
    for seed in first..first.saturating_add(count) {
        let record = Invented::of(seed, is_known);
        let Ok(verdict) = judge(record.text.as_bytes(), &Options::default()) else {
            counts[5] += 1;
            continue;
        };
        let (named, praise) = (record.named(&verdict), praise(&verdict));
        counts[named as usize] += 1;
        counts[4] += u64::from(praise.is_some());
        counts[6..].iter_mut().zip(record.places(&verdict)).for_each(|(count, here)| *count += here);
        if count == 1 {
            writeln!(out, "{}\n{}\n{named:?}\n{verdict}", record.text, record.what)?;
        } else if named == Named::Wrongly || named == Named::Not && is_known || praise.is_some() {
            writeln!(out, "{seed} {named:?} {praise:?}: {}", record.what)?;
            let found =
                verdict.diagnosis.map(|found| (found.confidence, found.best.rule.name(), found.alike.len()));
            writeln!(out, "    {found:?}")?;
        }
    }
    Ok(counts)
}

/// Words of praise in the verdict on a record that fails: that something is kept, of any; and that the motion
/// is exact, unless it fails for its file or for jumps.
fn praise(verdict: &Verdict) -> Option<&'static str> {
    if verdict.outcome != Outcome::Failed {
        return None;
    }
    let jumps = verdict.diagnosis.as_ref().is_some_and(|found: &Diagnosis| !found.jumps.is_empty());
    let of_file = !verdict.file_mistakes.is_empty() || !verdict.resets.is_empty();
    let text = verdict.to_string().to_lowercase();
    let found = |words: &'static str| words.split('|').find(|words| text.contains(words));
    let accurate = verdict.diagnosis.as_ref().map(|found| found.confidence) == Some(Confidence::Accurate);
    let exact = || found("accurate|is: the exact motion|with: the exact motion|nothing to do");
    let kept = found("it keeps|keeps energy|keeps the energy|is kept|are kept");
    kept.or_else(|| exact().or(accurate.then_some("accurate")).filter(|_| !jumps && !of_file))
}
