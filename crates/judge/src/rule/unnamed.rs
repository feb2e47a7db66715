//! What is said of a record that no rule fits.

use crate::read::{Floor, Pair, median};
use crate::rule::diagnosis::Ranked;
use crate::rule::tried::explained;
use crate::rule::{Alteration, Base, Confidence, Explanation, Rule, Subject, When};
use crate::thresholds::*;

/// The exact motion with a number altered, if that explains nearly all of its error; an accurate rule, and
/// the error of its steps; interpolated rows; rows that scatter, and by how much; or none.
pub(super) fn unnamed(
    subject: &Subject,
    pairs: &[Pair],
    found: &[Explanation],
    ranked: Ranked,
    fails: bool,
    floor: Floor,
) -> (Ranked, Confidence, Option<f64>) {
    let Some(exact) = found.iter().find(|x| x.rule == Rule::EXACT) else {
        return (ranked, Confidence::NoneFits, None);
    };
    let alone = |best: &Explanation| Ranked { best: *best, alike: Vec::new(), second: Some(*exact) };
    let (altered, times) = altered(subject, pairs, found);
    if let Some(altered) = altered.filter(|x| times > ALTERED[1] && x.median < NEAR) {
        let mut altered = alone(altered);
        // Where in the step of a rule that is not known it is damped, the exact motion does not show.
        if let Some(Alteration::Damped { when, .. }) = &mut altered.best.rule.alteration {
            *when = When::Open;
        }
        return (altered, Confidence::Altered, None);
    }
    let error = accuracy(subject, pairs, exact, floor.size).filter(|_| !fails && times < ALTERED[0]);
    if error.is_some() {
        return (Ranked { second: ranked.second, ..alone(exact) }, Confidence::Accurate, error);
    }
    if are_interpolated(pairs, floor) {
        return (ranked, Confidence::Interpolated, None);
    }
    let scatter = scatter(subject, pairs).filter(|off| exact.median < OF_SCATTER * off);
    (ranked, if scatter.is_some() { Confidence::Scattered } else { Confidence::NoneFits }, scatter)
}

/// By how much the spins scatter about a smooth motion, relative to them, if that is most of what they show:
/// what one row is off by, the next step takes back, while the errors of a rule go on.
fn scatter(subject: &Subject, pairs: &[Pair]) -> Option<f64> {
    let off =
        |pair: &Pair| Some((pair.to.omega - subject.spin_after(&Rule::EXACT, pair)?) / pair.to.omega.norm());
    let both =
        |two: &[Pair]| Some([off(&two[0])?, off(&two[1])?]).filter(|_| two[0].to.line == two[1].from.line);
    let (mut own, mut next, mut count) = (0.0, 0.0, 0.0);
    for [first, second] in pairs.windows(2).filter_map(both) {
        own += (first.norm_squared() + second.norm_squared()) / 2.0;
        next += first.dot(&second);
        count += 1.0;
    }
    // Of noise alone it is half.
    (next < -TAKEN_BACK * own && count >= SCATTERED_ROWS).then(|| (own / (6.0 * count)).sqrt())
}

/// The exact motion with one number altered that explains the record best, and how many times as well as
/// without that number.
fn altered<'a>(
    subject: &Subject,
    pairs: &[Pair],
    found: &'a [Explanation],
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
    let best = found.iter().filter(one).max_by(|a, b| times(a).total_cmp(&times(b)));
    (best, best.map_or(0.0, times))
}

/// Whether some of the rows are the rows before them, under other times.
pub(super) fn are_repeated(pairs: &[Pair]) -> bool {
    let same = |pair: &Pair| pair.from.omega == pair.to.omega && pair.from.attitude == pair.to.attitude;
    // A spin that comes to stay is no row written again and again.
    let ends = pairs.windows(2).filter(|two| same(&two[0]) && !same(&two[1])).count();
    ends > 1 && ends as f64 > STRAIGHT[1] * pairs.len() as f64
}

/// Whether some of the rows lie on a straight line between those before and after.
fn are_interpolated(pairs: &[Pair], floor: Floor) -> bool {
    let bends = pairs.windows(2).filter(|two| two[0].to.line == two[1].from.line).map(|two| {
        let [first, second] = [two[0], two[1]].map(|pair| pair.to.omega - pair.from.omega);
        let rounding = STRAIGHT[0] * floor.size * two[0].from.omega.norm();
        (first - second).norm() <= rounding && first.norm() > CLEAR * rounding
    });
    let (straight, all) = bends.fold((0, 0), |(straight, all), is| (straight + u32::from(is), all + 1));
    f64::from(straight) > STRAIGHT[1] * f64::from(all)
}

/// The error of the middle step, as a share of what the gyroscopic term changes of the spin in the middle
/// step; of an accurate rule alone. A share of the spin would praise each rule whose steps are short, even
/// where there is no gyroscopic term in them.
fn accuracy(subject: &Subject, pairs: &[Pair], exact: &Explanation, floor: f64) -> Option<f64> {
    let change = median(pairs.iter().filter_map(|pair| {
        let end = subject.spin_after(&Rule::EXACT, pair)?;
        Some((end - pair.from.omega).norm() / pair.from.omega.norm())
    }));
    let share = exact.median / change;
    (change.is_finite() && change > ABOVE_ROUNDING * floor && share <= ACCURATE).then_some(share)
}
