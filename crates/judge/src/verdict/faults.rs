//! What fails a record besides the laws: a spin that turns over or flips otherwise, a rule that is wrong for
//! certain, and a circuit at another rate.

use crate::law::LawName;
use crate::laws::{Complaint, FlipCount, Law};
use crate::options::Options;
use crate::rule::{Alteration, Base, Confidence, Diagnosis, Rule};
use crate::thresholds::PHASE;
use tumbling::step::Method;

/// If digits show it, a spin that turns over, or flips where it never should, or never where it should.
pub(crate) fn spin_faults(
    flips: &FlipCount,
    [axis, shown]: [bool; 2],
) -> impl Iterator<Item = Complaint> + use<> {
    let over = flips.turned_over.filter(|_| axis).map(|time| Complaint::TurnedOver { time });
    let counted = match (flips.found, flips.exact) {
        _ if !shown => None,
        (0, exact) if exact > 0 => Some(Complaint::NeverFlips { exact }),
        (found, 0) if found > 0 => Some(Complaint::Flips { found }),
        _ => None,
    };
    over.into_iter().chain(counted)
}

/// A rule that no body goes by, however small the step; of several that cannot be distinguished all must be
/// wrong.
pub(crate) fn wrong_rule(diagnosis: &Diagnosis) -> Option<Complaint> {
    let all_wrong = std::iter::once(&diagnosis.best.rule).chain(&diagnosis.alike).all(is_wrong);
    let wrong = diagnosis.confidence == Confidence::ToRounding && all_wrong;
    wrong.then(|| Complaint::WrongRule(Box::new(diagnosis.best.rule)))
}

/// Whether shorter steps do not lead to the motion of the body.
const fn is_wrong(rule: &Rule) -> bool {
    let base = match rule.base {
        Base::Exact | Base::PositionStage(_) => false,
        Base::Method(method, _) | Base::Straight(method, _) => matches!(method, Method::ConstantSpin),
        // A limit on the turn of a step is out of reach of shorter ones.
        Base::Engine(engine) => {
            engine.limits.component.is_some() || matches!(engine.method, Method::ConstantSpin)
        }
        _ => true,
    };
    let altered = match rule.alteration {
        Some(Alteration::Turned(turn)) => !turn.is_of_rows(),
        other => other.is_some(),
    };
    base || altered
}

/// A phase that ran away, where the caller has set no limit of its own for it; of that many
/// periods, the share of which that digits leave open is to be small. So near the separatrix that
/// 2 E I2 / L² came farther from its first value than that is from 1, and within its limit, any period is
/// right.
pub(crate) fn wrong_pace(
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
