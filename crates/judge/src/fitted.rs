//! Candidates with a number in them, each fitted to the record before it is held against it.

use crate::candidates::Subject;
use crate::rules::{Alteration, Base, Rule, When};
use crate::state::{Pair, median};
use crate::thresholds::{
    BEYOND, CAPPED_ROWS, CONVERGED, DAMPED, DAMPED_ROUNDINGS, DAMPING_ROUNDS, FITTED_STEPS, FRACTION,
    FRACTION_APART, JOLT, MOMENTS_ROUNDS, OTHER_PACE, SMALL_COMPONENT,
};
use nalgebra::Vector3;
use tumbling::dynamics::euler;

/// The number that takes the momentum to the turn.
pub(crate) fn momentum_for_spin(subject: &Subject, pairs: &[Pair]) -> Option<Rule> {
    let mass = median(pairs.iter().filter_map(|pair| {
        let turn = pair.turn()?.norm();
        if turn > 0.0 { Some(subject.system.momentum(&pair.from.omega).norm() * pair.h / turn) } else { None }
    }));
    (mass.is_finite() && mass > 0.0).then_some(Rule::plain(Base::MomentumForSpin(mass)))
}

/// Candidates with a number in them, which is fitted first.
pub(crate) fn compound(subject: &Subject, pairs: &[Pair], rounding: f64) -> Vec<Rule> {
    let few: Vec<Pair> = pairs.iter().step_by(pairs.len().div_ceil(FITTED_STEPS).max(1)).copied().collect();
    let mut all = Vec::new();
    let mut triples = permuted(&subject.moments);
    triples.extend(from_rates(&few, &subject.moments));
    for base in Base::all() {
        all.extend(triples.iter().map(|&moments| base.but(Alteration::OtherMoments(moments))));
        all.extend(fitted(subject, &few, base, &triples));
        for when in [When::After, When::Before] {
            all.extend(damped(subject, &few, base, when, rounding));
        }
        for when in [When::After, When::Before] {
            all.extend(damped_by_axis(subject, &few, base, when, rounding));
        }
        all.extend(capped(pairs).map(|most| base.but(Alteration::Capped(most))));
        all.extend(small_turn(pairs).map(|angle| base.but(Alteration::SmallTurn(angle))));
        all.extend(zeroed(subject, pairs, base).map(|least| base.but(Alteration::Zeroed(least))));
        all.extend(turned_by(pairs).map(|factor| base.but(Alteration::OtherTurn(factor))));
        all.extend(clocks(subject, &few).map(|factor| base.but(Alteration::OtherStep(factor))));
    }
    all
}

/// The moments in every other order.
fn permuted(moments: &Vector3<f64>) -> Vec<Vector3<f64>> {
    let orders = [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    orders
        .map(|order| Vector3::from(order.map(|i| moments[i])))
        .into_iter()
        .filter(|x| x != moments)
        .collect()
}

/// The triple that follows from the changes of spin, each component on its own, scaled to the sum of `given`.
fn from_rates(pairs: &[Pair], given: &Vector3<f64>) -> Option<Vector3<f64>> {
    let (mut over, mut under) = (Vector3::zeros(), Vector3::zeros());
    for pair in pairs {
        let mean = (pair.from.omega + pair.to.omega) / 2.0;
        let speed = mean.norm_squared();
        let rate = (pair.to.omega - pair.from.omega) / pair.h;
        for i in 0..3 {
            let product = mean[(i + 1) % 3] * mean[(i + 2) % 3] / speed;
            if product.is_finite() {
                over[i] += rate[i] / speed * product;
                under[i] += product * product;
            }
        }
    }
    // w1' = a w2 w3 with a = (I2 - I3) / I1, and so on round: two of them determine the ratios.
    let rates: Vector3<f64> = over.component_div(&under);
    let second = (1.0 + rates.x) / (1.0 - rates.y);
    scaled(Vector3::new(1.0, second, 1.0 + rates.y * second), given)
}

fn scaled(moments: Vector3<f64>, given: &Vector3<f64>) -> Option<Vector3<f64>> {
    let moments = moments * (given.sum() / moments.sum());
    Subject::new(moments, None).is_ok().then_some(moments)
}

/// Gauss and Newton's way to the ratios of the moments with which the base makes the spins of the record.
fn fitted(subject: &Subject, pairs: &[Pair], base: Base, starts: &[Vector3<f64>]) -> Option<Rule> {
    let misses = |moments: &Vector3<f64>| -> Option<Vec<Vector3<f64>>> {
        pairs
            .iter()
            .map(|pair| {
                let end = subject.spin_after(&base.but(Alteration::OtherMoments(*moments)), pair)?;
                Some((end - pair.to.omega) / pair.to.omega.norm().max(f64::MIN_POSITIVE))
            })
            .collect()
    };
    let size = |misses: &[Vector3<f64>]| misses.iter().map(Vector3::norm_squared).sum::<f64>();
    let best = starts.iter().filter_map(|start| misses(start).map(|found| (*start, size(&found))));
    let (mut moments, mut least) = best.min_by(|a, b| a.1.total_cmp(&b.1))?;
    for _ in 0..MOMENTS_ROUNDS {
        let here = misses(&moments)?;
        let along = |i: usize| -> Option<Vec<Vector3<f64>>> {
            let mut other = moments;
            other[i] *= 1.0 + JOLT;
            Some(misses(&other)?.iter().zip(&here).map(|(a, b)| (a - b) / JOLT).collect())
        };
        let (a, b) = (along(1)?, along(2)?);
        let dot =
            |x: &[Vector3<f64>], y: &[Vector3<f64>]| x.iter().zip(y).map(|(x, y)| x.dot(y)).sum::<f64>();
        let (aa, ab, bb) = (dot(&a, &a), dot(&a, &b), dot(&b, &b));
        let (ha, hb) = (dot(&a, &here), dot(&b, &here));
        let determinant = aa * bb - ab * ab;
        let step = [(hb * ab - ha * bb) / determinant, (ha * ab - hb * aa) / determinant];
        let next = Vector3::new(moments.x, moments.y * step[0].exp(), moments.z * step[1].exp());
        let Some(next) = scaled(next, &subject.moments) else { break };
        let Some(now) = misses(&next).map(|found| size(&found)) else { break };
        if now >= least {
            break;
        }
        (moments, least) = (next, now);
    }
    Some(base.but(Alteration::OtherMoments(moments)))
}

/// The factor by which each step lessens the spin that the base makes.
fn damped(subject: &Subject, pairs: &[Pair], base: Base, when: When, rounding: f64) -> Option<Rule> {
    let mut factor = 1.0;
    for _ in 0..DAMPING_ROUNDS[0] {
        let more = median(pairs.iter().filter_map(|pair| {
            let end = subject.spin_after(&base.but(Alteration::Damped(factor, when)), pair)?;
            Some(pair.to.omega.dot(&end) / end.norm_squared())
        }));
        if !more.is_finite() {
            return None;
        }
        factor *= more;
        if (more - 1.0).abs() < CONVERGED || when == When::After {
            break;
        }
    }
    let below = 1.0 - DAMPED.max(DAMPED_ROUNDINGS[1] * rounding);
    (factor > 0.0 && factor < below).then_some(base.but(Alteration::Damped(factor, when)))
}

/// The factors by which each step lessens the spin about each axis of the body.
fn damped_by_axis(subject: &Subject, pairs: &[Pair], base: Base, when: When, rounding: f64) -> Option<Rule> {
    let mut factors = Vector3::repeat(1.0);
    let least = SMALL_COMPONENT * pairs.iter().map(|pair| pair.to.omega.norm()).fold(0.0, f64::max);
    for _ in 0..DAMPING_ROUNDS[1] {
        let ends: Vec<(Vector3<f64>, Vector3<f64>)> = pairs
            .iter()
            .filter_map(|pair| {
                let rule = base.but(Alteration::DampedByAxis(factors, when));
                Some((pair.to.omega, subject.spin_after(&rule, pair)?))
            })
            .collect();
        let more = Vector3::from([0, 1, 2].map(|i| {
            let ratios = ends.iter().filter(|(_, end)| end[i].abs() > least).map(|(to, end)| to[i] / end[i]);
            median(ratios)
        }));
        if !more.iter().all(|x| x.is_finite()) {
            return None;
        }
        factors.component_mul_assign(&more);
        if (more - Vector3::repeat(1.0)).amax() < CONVERGED || when == When::After {
            break;
        }
    }
    let [up, down] = DAMPED_ROUNDINGS.map(|units| units * rounding);
    let fair = factors.iter().all(|x| *x >= 0.0 && *x <= 1.0 + up) && factors.min() < 1.0 - DAMPED.max(down);
    fair.then_some(base.but(Alteration::DampedByAxis(factors, when)))
}

/// The greatest turn of a step that leaves the attitude as it was, if there are some.
fn small_turn(pairs: &[Pair]) -> Option<f64> {
    let still = pairs.iter().filter(|pair| pair.turn().is_some_and(|turn| turn == Vector3::zeros()));
    still.map(|pair| pair.to.omega.norm() * pair.h).filter(|angle| *angle > 0.0).reduce(f64::max)
}

/// The greatest component of the base's spin that the record has as zero.
fn zeroed(subject: &Subject, pairs: &[Pair], base: Base) -> Option<f64> {
    let mut most: Option<f64> = None;
    for pair in pairs.iter().filter(|pair| pair.to.omega.iter().any(|x| *x == 0.0)) {
        let end = subject.spin_after(&base.but(Alteration::Zeroed(0.0)), pair)?;
        for i in 0..3 {
            if pair.to.omega[i] == 0.0 && end[i] != 0.0 {
                most = Some(most.unwrap_or(0.0).max(end[i].abs()));
            }
        }
    }
    most
}

/// How many times as far as the spin says each step turns the body, if that is not once.
fn turned_by(pairs: &[Pair]) -> Option<f64> {
    let factor = median(pairs.iter().filter_map(|pair| {
        let turn = pair.to.omega.norm() * pair.h;
        if turn > 0.0 { Some(pair.turn()?.norm() / turn) } else { None }
    }));
    let factor = rounded(factor);
    (factor.is_finite() && (factor - 1.0).abs() > OTHER_PACE).then_some(factor)
}

/// How many times as long as the record's the steps are, if not once: from the turns, and from the changes of
/// the spin.
fn clocks(subject: &Subject, pairs: &[Pair]) -> impl Iterator<Item = f64> {
    let (mut found, mut wanted) = (0.0, 0.0);
    for pair in pairs {
        let mean = (pair.from.omega + pair.to.omega) / 2.0;
        let law = euler::angular_acceleration(&subject.moments, &mean, &Vector3::zeros()) * pair.h;
        let change = pair.to.omega - pair.from.omega;
        let weight = mean.norm_squared();
        if weight > 0.0 {
            found += change.dot(&law) / weight;
            wanted += law.dot(&law) / weight;
        }
    }
    let by_law = rounded(found / wanted);
    let by_turn = turned_by(pairs);
    let differs = move |x: &f64| x.is_finite() && *x > 0.0 && (x - 1.0).abs() > OTHER_PACE;
    by_turn.into_iter().chain((by_turn != Some(by_law)).then_some(by_law)).filter(differs)
}

/// As a fraction of small numbers if it is within a hundredth of one: a half, a third, twice.
fn rounded(factor: f64) -> f64 {
    let (under_most, small) = FRACTION;
    let near = (1..=under_most).map(f64::from).find_map(|under| {
        let over = (factor * under).round();
        let fraction = over / under;
        (over > 0.0 && (factor / fraction - 1.0).abs() < FRACTION_APART).then_some(fraction)
    });
    // A tenth, a hundredth: one part of a whole number.
    let whole = (1.0 / factor).round();
    let part = (factor < small && (1.0 / factor / whole - 1.0).abs() < FRACTION_APART).then_some(1.0 / whole);
    near.or(part).unwrap_or(factor)
}

/// The greatest spin, if many rows have it.
fn capped(pairs: &[Pair]) -> Option<f64> {
    let most = pairs.iter().map(|pair| pair.to.omega.norm()).fold(0.0, f64::max);
    let there = pairs.iter().filter(|pair| pair.to.omega.norm() >= most * (1.0 - BEYOND)).count();
    let [least, share] = CAPPED_ROWS;
    (most > 0.0 && there >= least && there * share >= pairs.len()).then_some(most)
}
