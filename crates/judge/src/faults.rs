//! What fails a record beside the laws: a rule that is wrong for certain, and a way round at another pace.

use crate::diagnosis::{Diagnosis, Sure};
use crate::laws::{Law, LawName};
use crate::suspects::Rule;
use crate::verdict::Options;
use tumbling::step::Method;

/// How far the phase may run from the exact one where no limit is asked for: a quarter of a way round, and this share of the ways round that
/// the exact motion makes. A right rule of second order loses far less than that, but near the separatrix, where a way round takes as
/// long as the smallest error lets it; a rule without a gyroscopic term loses all, a clock at half its pace a half.
const PACE: f64 = 0.25;

/// A rule that no body goes by, however small the step; several that are not to be told apart must all be wrong.
pub(crate) fn wrong_rule(diagnosis: &Diagnosis) -> Option<String> {
    let all_wrong = std::iter::once(&diagnosis.best.rule).chain(&diagnosis.alike).all(is_wrong);
    (diagnosis.sure == Sure::ToRounding && all_wrong)
        .then(|| format!("every step is made by a rule that is wrong here: {}", diagnosis.best.rule.name()))
}

/// Whether shorter steps do not lead to the motion of the body.
fn is_wrong(rule: &Rule) -> bool {
    match rule {
        Rule::Exact => false,
        Rule::Method(method, _) => *method == Method::ConstantSpin,
        _ => true,
    }
}

/// A phase that ran away, where the caller has set no limit of its own for it.
pub(crate) fn wrong_pace(laws: &[Law], ways: f64, options: &Options) -> Option<String> {
    let phase = laws.iter().find(|law| law.name == LawName::Phase)?;
    let allowed = PACE + PACE * ways;
    (options.allowed(LawName::Phase).is_none() && phase.most > allowed).then(|| {
        format!(
            "the spin is {:.3} ways round from the exact one, which goes {ways:.3} ways round (allowed: {allowed:.3}, unless \
             `--threshold phase=X` says otherwise)",
            phase.most
        )
    })
}
