//! The diagnosis of a record that no rule fits.

use crate::read::{Floor, Pair, law, median};
use crate::rule::diagnosis::{Ranked, Whole};
use crate::rule::tried::explained;
use crate::rule::{Alteration, Base, Confidence, Explanation, Rule, Subject, When};
use crate::thresholds::*;
use nalgebra::{UnitQuaternion, Vector2, Vector3};

/// One of: the exact motion with one number altered, or with what brings a rule near, if that explains nearly
/// all of its error; an accurate rule, with the error of its steps; rows that scatter, and by how much; none.
pub(super) fn unnamed(
    subject: &Subject,
    pairs: &[Pair],
    (found, near): (&[Explanation], Option<Explanation>),
    ranked: Ranked,
    whole: &Whole,
    floor: Floor,
) -> (Ranked, Confidence, Option<f64>) {
    let Some(exact) = found.iter().find(|x| x.rule == Rule::EXACT) else {
        return (ranked, Confidence::NoneFits, None);
    };
    let alone = |best: &Explanation| Ranked { best: *best, alike: Vec::new(), second: Some(*exact) };
    let (altered, times) = altered(subject, pairs, found, near.as_ref());
    if let Some(altered) = altered.filter(|x| times > ALTERED[1] && x.median < NEAR) {
        let mut altered = alone(altered);
        // The exact motion does not show where in an unknown rule's step the damping acts.
        if let Some(Alteration::Damped { when, .. }) = &mut altered.best.rule.alteration {
            *when = When::Open;
        }
        return (altered, Confidence::Altered, None);
    }
    // Times of few digits may be off by more than such an error.
    let may_be = whole.is_sound && !whole.of_few_times && times < ALTERED[0];
    let error = accuracy(subject, pairs, exact, floor.size).filter(|_| may_be);
    if error.is_some() {
        return (Ranked { second: ranked.second, ..alone(exact) }, Confidence::Accurate, error);
    }
    let off = |x: &Pair| Some((x.to.omega - subject.spin_after(&Rule::EXACT, x)?) / x.to.omega.norm());
    let scatter = scatter(pairs, off).filter(|off| exact.median < OF_SCATTER * off);
    (ranked, if scatter.is_some() { Confidence::Scattered } else { Confidence::NoneFits }, scatter)
}

/// Whether the attitudes scatter about a rule's results by more than the rounding of the printed digits:
/// numbers that had fewer digits before, as those from a matrix may.
pub(super) fn attitudes_scatter(subject: &Subject, pairs: &[Pair], base: Base, floor: Floor) -> bool {
    // In the world, where the next step takes back the very vector.
    let off = |pair: &Pair| {
        let end = subject.next(&Rule::plain(base), &pair.from, pair.h)?;
        Some(UnitQuaternion::new_normalize(end.attitude?) * Pair { from: end, ..*pair }.turn()?)
    };
    scatter(pairs, off).is_some_and(|off| off > floor.limits()[1])
}

/// The scatter of rows about a smooth motion, if it is most of the error of their steps: the next step
/// reverses a row's scatter, while the errors of a rule accumulate.
fn scatter(pairs: &[Pair], off: impl Fn(&Pair) -> Option<Vector3<f64>>) -> Option<f64> {
    let both =
        |two: &[Pair]| Some([off(&two[0])?, off(&two[1])?]).filter(|_| two[0].to.line == two[1].from.line);
    let (mut own, mut next, mut count) = (0.0, 0.0, 0.0);
    for [first, second] in pairs.windows(2).filter_map(both) {
        own += (first.norm_squared() + second.norm_squared()) / 2.0;
        next += first.dot(&second);
        count += 1.0;
    }
    // For noise alone it is half.
    (next < -TAKEN_BACK * own && count >= SCATTERED_ROWS).then(|| (own / (6.0 * count)).sqrt())
}

/// The exact motion, with one number altered or as it is near, that explains the record best, and how many
/// times as well as without that number.
fn altered<'a>(
    subject: &Subject,
    pairs: &[Pair],
    found: &'a [Explanation],
    near: Option<&'a Explanation>,
) -> (Option<&'a Explanation>, f64) {
    let is_one = |altered| {
        use Alteration::{Damped, Term, TermOrTimes, Times};
        matches!(altered, Some(Damped { .. } | Term(_) | TermOrTimes(_) | Times(_)))
    };
    let one = |x: &&Explanation| x.rule.base == Base::Exact && is_one(x.rule.alteration);
    let times = |x: &Explanation| {
        let without = x.rule.neutral().into_iter().filter_map(|rule| explained(subject, pairs, rule));
        let times = without.map(|y| (y.median / x.median).min(y.percentile_95 / x.percentile_95));
        times.fold(f64::INFINITY, f64::min)
    };
    let best = found.iter().filter(one).chain(near).max_by(|a, b| times(a).total_cmp(&times(b)));
    (best, best.map_or(0.0, times))
}

/// Whether some rows lie on a straight line between their neighbours, next to a clear bend: no smooth motion
/// does that.
pub(super) fn are_interpolated(subject: &Subject, pairs: &[Pair], floor: Floor) -> bool {
    // The attitudes between two others turn about one axis, however the spin changes there.
    let is_between = |[first, second]: [&Pair; 2]| match (first.turn(), second.turn()) {
        (Some(a), Some(b)) if first.to.ahead.is_none() => {
            let (v, w) = (first.to.omega, second.to.omega);
            a.cross(&b).norm() * v.norm() * w.norm() < TURNS_APART * v.cross(&w).norm() * a.norm() * b.norm()
        }
        _ => true,
    };
    let bends = pairs.windows(2).filter(|two| two[0].to.line == two[1].from.line).map(|two| {
        let [first, second] = [two[0], two[1]].map(|pair| pair.to.omega - pair.from.omega);
        let rounding = STRAIGHT[0] * floor.size * two[0].from.omega.norm();
        let bend = (first - second).norm() / rounding;
        let is_seen = first.norm() > CLEAR * rounding && (bend > 1.0 || is_between([&two[0], &two[1]]));
        if is_seen { bend } else { f64::NAN }
    });
    let bends: Vec<f64> = bends.collect();
    let is_knot = |two: &&[f64]| two[0].min(two[1]) <= 1.0 && two[0].max(two[1]) > ABOVE_ROUNDING;
    let many = bends.windows(2).filter(is_knot).count() as f64 > STRAIGHT[1] * bends.len() as f64;
    // Spins alone that are pushed do not follow Euler's equations.
    many && (pairs[0].from.attitude.is_some() || law(pairs, &subject.moments).0 > LAW_AGREES)
}

/// The median error of a step as a share of the median change of spin by the gyroscopic term; only for an
/// accurate rule. A share of the spin itself would call every rule with short steps accurate, even one
/// without a gyroscopic term.
fn accuracy(subject: &Subject, pairs: &[Pair], exact: &Explanation, floor: f64) -> Option<f64> {
    let change = median(&mut pairs.iter().filter_map(|pair| {
        let end = subject.spin_after(&Rule::EXACT, pair)?;
        Some((end - pair.from.omega).norm() / pair.from.omega.norm())
    }));
    let share = exact.median / change;
    (change.is_finite() && change > ABOVE_ROUNDING * floor && share <= ACCURATE).then_some(share)
}

/// The ratio of the change of spin to that by the gyroscopic term, if no rule fits and the ratio is far
/// from 1.
pub(super) fn times_the_term(subject: &Subject, pairs: &[Pair]) -> Option<f64> {
    let (alike, times) = law(pairs, &subject.moments);
    // A torque changes the spin too.
    let seen = subject.torque.is_none() && alike.abs() > LAW_AGREES && (times - 1.0).abs() > TERM_APART;
    seen.then_some(times)
}

/// The logarithms by which all steps of a rule together change energy and momentum, and those of the record.
pub(super) fn changes(subject: &Subject, pairs: &[Pair], rule: &Rule) -> [Vector2<f64>; 2] {
    let size = |omega: Vector3<f64>| {
        let momentum = subject.moments.component_mul(&omega);
        Vector2::new(omega.dot(&momentum).ln(), momentum.norm().ln())
    };
    let step = |(i, pair): (usize, &Pair)| {
        if pair.to.ahead.is_none() {
            return Some([pair.from.omega, subject.spin_after(rule, pair)?, pair.to.omega]);
        }
        // A spin made from turns is not the rule's own: that of the next turn is.
        let next = pairs.get(i + 1).filter(|next| next.from.line == pair.to.line)?;
        let [(own, _), (next, _)] = [subject.spins_of_turn(rule, pair)?, subject.spins_of_turn(rule, next)?];
        Some([own[0], own[1], next[0]])
    };
    let steps = pairs.iter().enumerate().filter_map(step).map(|all| all.map(size));
    steps.fold([Vector2::zeros(); 2], |[own, seen], [from, end, to]| [own + end - from, seen + to - from])
}

/// Whether a record drifts differently from a rule that is near: if the rule has no fitted numbers, the
/// remainder must be random, and the laws of the rule must hold.
pub(super) fn drifts_from(subject: &Subject, pairs: &[Pair], best: &Explanation, whole: &Whole) -> bool {
    let rule = best.rule;
    let [own, seen] = changes(subject, pairs, &rule);
    let is_plain = rule.alteration.is_none() && !matches!(rule.base, Base::MomentumForSpin(_));
    let drifts = is_plain && (own - seen).amax() > BIASED[0] * best.median * (pairs.len() as f64).sqrt();
    drifts || whole.unkept.iter().any(|law| rule.keeps(*law))
}

/// The exact motion with the alteration of a rule that is near, unless that rule is nearer by far: else it is
/// the alteration that comes near, with the steps of any accurate rule.
pub(super) fn by_alteration(subject: &Subject, pairs: &[Pair], best: &Explanation) -> Option<Explanation> {
    // How the attitude turns is no number that is fitted.
    best.rule.alteration.filter(|alteration| !matches!(alteration, Alteration::Turned(_)))?;
    let exact = explained(subject, pairs, Rule { base: Base::Exact, ..best.rule })?;
    (best.relative_to(&exact) < NEAR_RATIO).then_some(exact)
}

/// The steps without those in which friction that overshoots at rest reverses the spin, which is no scatter;
/// all, if there are no others.
pub(super) fn going(pairs: &[Pair]) -> Vec<Pair> {
    let is_back =
        |x: &Pair| x.from.omega.dot(&x.to.omega) <= RIGHT_ROUND * x.from.omega.norm() * x.to.omega.norm();
    let going: Vec<_> = pairs.iter().filter(|x| !is_back(x)).copied().collect();
    if going.is_empty() { pairs.to_vec() } else { going }
}
