//! Candidates with a number in them, each fitted to the record before it is held against it.

use crate::read::{Pair, median};
use crate::rule::{Alteration, Base, Rule, Subject, When};
use crate::thresholds::{
    BEYOND, CAP_AT_START, CAPPED_ROWS, CONVERGED, DAMPED, DAMPED_ROUNDINGS, DAMPING_ROUNDS, FITTED_STEPS,
    JOLT, MOMENTS_ROUNDS,
};
use nalgebra::Vector3;

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
        all.extend(capped(pairs).map(|most| base.but(Alteration::Capped(most))));
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
    for _ in 0..DAMPING_ROUNDS {
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
    let below = 1.0 - DAMPED.max(DAMPED_ROUNDINGS * rounding);
    (factor > 0.0 && factor < below).then_some(base.but(Alteration::Damped(factor, when)))
}

/// The greatest spin, if many rows have it.
fn capped(pairs: &[Pair]) -> Option<f64> {
    let most = pairs.iter().map(|pair| pair.to.omega.norm()).fold(0.0, f64::max);
    let there = pairs.iter().filter(|pair| pair.to.omega.norm() >= most * (1.0 - BEYOND)).count();
    let [least, share] = CAPPED_ROWS;
    (most > 0.0 && there >= least && there * share >= pairs.len()).then_some(most)
}

/// The spins before and after a first step that slows the body to what no later step exceeds, rad/s.
pub(crate) fn cap_at_start(pairs: &[Pair]) -> Option<[f64; 2]> {
    let [slowed, beyond] = CAP_AT_START;
    let (from, to) = (pairs.first()?.from.omega.norm(), pairs.first()?.to.omega.norm());
    let greatest = pairs.iter().skip(1).map(|pair| pair.to.omega.norm()).fold(0.0, f64::max);
    let capped = pairs.len() > 2 && to > 0.0 && from > slowed * to && greatest <= to * (1.0 + beyond);
    capped.then_some([from, to])
}
