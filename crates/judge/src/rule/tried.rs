//! Which rules are tried on a record, in which order, and how far each is from it.

use crate::read::{Floor, Known, Pair, middle_and_most};
use crate::rule::fitted::{in_steps, refitted, some};
use crate::rule::{
    Alteration, Base, Explanation, Rule, Subject, Turn, compound, in_parts, momentum_for_spin, of_parts,
    other_bodies, plain,
};
use crate::thresholds::*;
use tumbling::step::Method;

pub(super) fn explained(subject: &Subject, pairs: &[Pair], rule: Rule) -> Option<Explanation> {
    let residuals = pairs.iter().map(|pair| subject.residual(&rule, pair)).collect();
    middle_and_most(residuals).map(|[median, percentile_95]| Explanation { rule, median, percentile_95 })
}

/// Whether a rule is within rounding of the best, in the median as in the 95th percentile.
pub(super) fn alike_to_best(found: &[Explanation], floor: Floor) -> impl Fn(&Explanation) -> bool + use<> {
    let least = found.iter().map(|x| x.median).fold(f64::INFINITY, f64::min);
    let [half, nearly_all] = if floor.few { ALIKE_FEW } else { ALIKE_ROUNDINGS }.map(|x| x * floor.size);
    let near = move |x: &Explanation| x.median <= (ALIKE[0] * least).max(half);
    let best_most = found.iter().filter(|x| near(x)).map(|x| x.percentile_95).fold(f64::INFINITY, f64::min);
    move |x| near(x) && x.percentile_95 <= (ALIKE[1] * best_most).max(nearly_all)
}

/// How far rules are from the record: by a few of its steps alone where a quarter of these is far behind the
/// best, or behind `least`, in what still fits.
fn compared(
    subject: &Subject,
    pairs: &[Pair],
    rules: Vec<Rule>,
    [least, fits]: [f64; 2],
) -> Vec<Explanation> {
    let few = some(pairs, COMPARED.0);
    let by_few = |rule| {
        let mut all: Vec<f64> = few.iter().map(|pair| subject.residual(&rule, pair)).collect();
        all.sort_by(f64::total_cmp);
        let at = |share: usize| all.get(all.len() * share / 100).copied();
        Some((at(25)?, Explanation { rule, median: at(50)?, percentile_95: at(95)? }))
    };
    let seen: Vec<_> = rules.into_iter().filter_map(by_few).collect();
    let behind = COMPARED.1 * seen.iter().map(|x| x.0).fold(least, f64::min).max(fits);
    let whole = |x: Explanation| explained(subject, pairs, x.rule);
    seen.into_iter().filter_map(|(near, x)| if near > behind { Some(x) } else { whole(x) }).collect()
}

/// How far each candidate's steps are from the record's: plain rules first, and others while none fits.
pub(super) fn tried(subject: &Subject, pairs: &[Pair], known: &Known, sought: bool) -> Vec<Explanation> {
    let (floor, per_row) = (known.floor, known.clock.per_row);
    let explained = |rule: Rule| explained(subject, pairs, rule);
    let fits = |found: &[Explanation]| found.iter().any(|x| x.fits(floor));
    let free = subject.torque.is_none();
    let compared = |rules, known: &[Explanation]| {
        let least = known.iter().map(|x| x.median).fold(f64::INFINITY, f64::min);
        compared(subject, pairs, rules, [least, floor.limits()[0]])
    };
    let mut found = compared(plain(free, pairs), &[]);
    if free && (known.said.kind.is_momentum() || !fits(&found)) {
        found.extend(momentum_for_spin(subject, pairs).and_then(explained));
    }
    let rules = match in_the_clear(&found, floor) {
        _ if !free => Vec::new(),
        None => in_parts(per_row, !sought),
        // Other rules may make equal steps.
        Some(parts) => of_parts(parts),
    };
    if !rules.is_empty() {
        let mut in_parts = tried_in_parts(subject, pairs, rules, floor);
        // Those of the number that the header names go before the same rules in one part.
        if per_row.is_some_and(|parts| parts > 1) {
            std::mem::swap(&mut found, &mut in_parts);
        }
        found.extend(in_parts);
    }
    let unaltered = found.len();
    found.extend(equals(subject, pairs, &found, floor).into_iter().filter_map(explained));
    for rules in [compound, other_bodies] {
        if free && !fits(&found) {
            // Times that are nearly right are wrong where that is all there is.
            let near = |times: f64| (times - 1.0).abs() < PACE_APART;
            let is_small = |rule: &Rule| matches!(rule.alteration, Some(Alteration::Times(x)) if near(x));
            let rules = compared(rules(subject, pairs, floor.size), &found);
            found.extend(rules.into_iter().filter(|x| !is_small(&x.rule) || x.fits(floor)));
        }
    }
    if free && !fits(&found) && found.iter().any(|x| x.rule.is_damped()) {
        let rules = in_steps(subject, pairs, floor.size, per_row);
        found.extend(tried_in_parts(subject, pairs, rules, floor));
    }
    let equal = equals(subject, pairs, &found[unaltered..], floor);
    found.extend(equal.into_iter().filter_map(explained));
    let with_attitude = pairs.first().is_some_and(|pair| pair.from.attitude.is_some());
    // A turn that is nearly all of it is a better answer than none.
    let exact = found.iter().find(|x| x.rule == Rule::EXACT).map_or(0.0, |x| x.median);
    let is_turned = |x: &Explanation| {
        matches!(x.rule.alteration, Some(Alteration::Turned(_))) && x.median * NEAR_RATIO < exact
    };
    if free && with_attitude && !sought && !fits(&found) && !found.iter().any(is_turned) {
        // Of the rules of engines alone: of a spin that hardly changes, those of one order make the same.
        let of_engine = |base: &Base| *base == Base::Exact || !Rule::plain(*base).engines().is_empty();
        let otherwise = |base: Base| explained(base.but(Alteration::Turned(Turn::Otherwise)));
        found.extend(Base::all().into_iter().filter(of_engine).filter_map(otherwise));
    }
    found
}

/// Rules that make the steps of one that fits, though not by name: a straight turn by the new spin is one by
/// the old where the spins are a row late, and the other way round, and the position stage cuts a long step
/// by itself; of altered rules, those that make the spin of one that fits, or is the nearest.
fn equals(subject: &Subject, pairs: &[Pair], found: &[Explanation], floor: Floor) -> Vec<Rule> {
    let least = found.iter().map(|x| x.median).fold(NEAR, f64::min);
    let equal = |x: &Explanation| match x.rule.base {
        base if x.rule.alteration.is_some() => {
            let others = Base::every().map(|other| other.in_parts(base.parts()));
            let same = |other: &Base| other.spin().is_some() && other.spin() == base.spin();
            let with = |base| refitted(subject, pairs, Rule { base, ..x.rule });
            others.filter(same).map(with).collect()
        }
        Base::Straight(Method::SemiImplicitEuler, parts) => {
            vec![Base::Method(Method::ExplicitEuler, parts).but(Alteration::Turned(Turn::Late))]
        }
        Base::Method(Method::ExplicitEuler, parts) => {
            vec![Base::Straight(Method::SemiImplicitEuler, parts).but(Alteration::Turned(Turn::Early))]
        }
        Base::PositionStage(1) => PARTS.map(|parts| Rule::plain(Base::PositionStage(parts))).to_vec(),
        _ => Vec::new(),
    };
    let is_open = |x: &Explanation| match x.rule.alteration {
        None => x.fits(floor),
        Some(Alteration::Turned(_)) => false,
        Some(_) => !x.rule.is_of_spin() && (x.fits(floor) || x.median <= ALIKE[0] * least),
    };
    let all = found.iter().filter(|x| is_open(x)).flat_map(equal);
    all.filter(|rule| found.iter().all(|x| x.rule != *rule)).collect()
}

/// In how many parts the best rule found makes its steps, if no rule in another number of parts can come as
/// near: the steps are exact to rounding, or they are a rule's own and its error is plain.
fn in_the_clear(found: &[Explanation], floor: Floor) -> Option<u32> {
    let Some(exact) = found.iter().find(|x| x.rule == Rule::EXACT) else { return Some(1) };
    if alike_to_best(found, floor)(exact) && exact.fits(floor) {
        return Some(1);
    }
    let fits = found.iter().filter(|x| x.fits(floor) && x.rule != Rule::EXACT);
    let best = fits.min_by(|a, b| a.median.total_cmp(&b.median))?;
    (exact.median > CLEAR * best.median.max(floor.size)).then_some(best.rule.base.parts())
}

/// The rules in parts that a few of the pairs do not rule out.
fn tried_in_parts(subject: &Subject, pairs: &[Pair], rules: Vec<Rule>, floor: Floor) -> Vec<Explanation> {
    let [first, more] = TRIED_IN_PARTS.map(|count| some(pairs, count));
    let [half, nearly_all] = floor.limits();
    // The first of them, and the same with the exact motion's end.
    let measure = first.first().and_then(|pair| {
        let to = subject.next(&Rule::EXACT, &pair.from, pair.h)?;
        Some((subject.residual(&Rule::EXACT, pair), Pair { to, ..*pair }))
    });
    let mut as_exact: Vec<(Base, u32)> = Vec::new();
    let mut possible = |rule: &Rule| {
        let (mut far, mut off) = (0, 0);
        if let Some((error, exact)) = &measure {
            let (base, parts) = (rule.base.in_parts(1), rule.base.parts());
            if as_exact.iter().any(|(other, least)| *other == base && parts > *least) {
                return false;
            }
            // Its own error is far below the record's: in more parts it comes no nearer.
            if *error > nearly_all && subject.residual(rule, exact) < AS_EXACT * error {
                as_exact.push((base, parts));
                return false;
            }
        }
        first.iter().all(|pair| {
            let residual = subject.residual(rule, pair);
            far += u32::from(residual > nearly_all);
            off += usize::from(residual > half);
            far < 2 && 2 * off <= first.len() + 1
        })
    };
    let possible = rules.into_iter().filter(|rule| possible(rule));
    possible.filter_map(|rule| explained(subject, &more, rule)).collect()
}
