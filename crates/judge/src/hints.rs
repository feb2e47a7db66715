//! What is seen in the steps besides the rule.

use crate::candidates::{Subject, straight};
use crate::findings::Hint;
use crate::rules::{Base, Rule, Spin};
use crate::sample::Floor;
use crate::state::{Pair, angle_between, middle_and_most, ordered};
use crate::thresholds::{CAP_AT_START, STILL};
use nalgebra::Vector3;
use tumbling::step::Method;
use tumbling::{attitude, dynamics::euler};

/// Everything besides the rule that may help to find what made the steps.
pub(crate) fn hints(subject: &Subject, pairs: &[Pair], floor: f64) -> Vec<Hint> {
    let mut hints: Vec<Hint> = cap_at_start(pairs).into_iter().collect();
    let still = pairs.iter().filter(|pair| {
        pair.turn().is_some_and(|turn| turn == Vector3::zeros())
            && pair.from.omega.norm() * pair.h > STILL * floor
    });
    let angles: Vec<f64> = still.map(|pair| pair.from.omega.norm() * pair.h).collect();
    if !angles.is_empty() {
        let angle = angles.iter().copied().fold(0.0, f64::max);
        hints.push(Hint::StandsStill { steps: angles.len(), angle });
    }
    let held = pairs.iter().filter(|pair| {
        let mean = (pair.from.omega + pair.to.omega) / 2.0;
        let law = euler::angular_acceleration(&subject.moments, &mean, &Vector3::zeros()) * pair.h;
        (0..3).any(|i| pair.to.omega[i] == 0.0 && law[i].abs() > STILL * floor * mean.norm())
    });
    let steps = held.count();
    if steps > 0 && subject.torque.is_none() {
        hints.push(Hint::HeldAtZero { steps });
    }
    hints
}

/// A first step that brings the spin down to a value that no later step exceeds.
fn cap_at_start(pairs: &[Pair]) -> Option<Hint> {
    let [slowed, beyond] = CAP_AT_START;
    let (from, to) = (pairs.first()?.from.omega.norm(), pairs.first()?.to.omega.norm());
    let greatest = pairs.iter().skip(1).map(|pair| pair.to.omega.norm()).fold(0.0, f64::max);
    let capped = pairs.len() > 2 && to > 0.0 && from > slowed * to && greatest <= to * (1.0 + beyond);
    capped.then_some(Hint::CapAtStart { from, to })
}

/// Of the spin alone, and of the attitude alone with the spins that the record has: what each is stepped by,
/// to rounding.
pub(crate) fn apart(subject: &Subject, pairs: &[Pair], floor: Floor) -> Option<Hint> {
    let fits = |misses: Vec<f64>| {
        let [middle, most] = middle_and_most(misses)?;
        floor.fits(middle, most).then_some(())
    };
    let spins = [
        (Base::Method(Method::ConstantSpin, 1), "no gyroscopic term"),
        (Base::Straight(Spin::Explicit, 1), "explicit gyroscopic step"),
        (Base::Method(Method::ImplicitOneNewton, 1), "one Newton step"),
        (Base::Method(Method::ImplicitMidpoint, 1), "implicit midpoint"),
        (Base::Method(Method::RungeKutta4, 1), "Runge and Kutta's fourth order"),
        (Base::Exact, "the exact motion"),
    ];
    let spin = spins.into_iter().find(|(base, _)| {
        let off = |pair: &Pair| {
            let speed = pair.to.omega.norm().max(pair.from.omega.norm());
            subject
                .spin_after(&Rule::plain(*base), pair)
                .map_or(f64::INFINITY, |spin| (spin - pair.to.omega).norm() / speed)
        };
        fits(pairs.iter().map(off).collect()).is_some()
    });
    type Turn = fn(&Pair) -> (Vector3<f64>, bool);
    let turns: [(Turn, &str); 5] = [
        (|pair| (pair.to.omega, true), "straight, by the new spin (q + h/2 q w)"),
        (|pair| (pair.from.omega, true), "straight, by the old spin (q + h/2 q w)"),
        (|pair| (pair.to.omega, false), "the turn of the new spin"),
        (|pair| (pair.from.omega, false), "the turn of the old spin"),
        (
            |pair| ((pair.from.omega + pair.to.omega) / 2.0, false),
            "the turn of the mean of the old spin and the new",
        ),
    ];
    let turn = turns.into_iter().find(|(by, _)| {
        let off = |pair: &Pair| {
            let (Some(from), Some(to)) = (pair.from.attitude, pair.to.attitude) else { return f64::INFINITY };
            let (omega, flat) = by(pair);
            let q = if flat {
                straight(&from, &omega, pair.h)
            } else {
                attitude::product(&from, &attitude::turn(&(omega * pair.h)))
            };
            angle_between(&q, &to)
        };
        fits(pairs.iter().map(off).collect()).is_some()
    });
    let (spin, turn) = (spin.map(|found| found.1), turn.map(|found| found.1));
    (spin.is_some() || turn.is_some()).then_some(Hint::Apart { spin, turn })
}

/// Whether the gyroscopic term is a part worth speaking of in the changes of spin that the sample should
/// have.
pub(crate) fn should_change(subject: &Subject, pairs: &[Pair], floor: f64) -> bool {
    let [smallest, _, largest] = ordered(&subject.moments);
    subject.moments[smallest] < subject.moments[largest]
        && pairs.iter().any(|pair| {
            let rate = euler::angular_acceleration(&subject.moments, &pair.from.omega, &Vector3::zeros());
            rate.norm() * pair.h > STILL * floor * pair.from.omega.norm()
        })
}
