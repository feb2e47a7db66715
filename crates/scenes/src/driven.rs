//! Ways to answer for a body under torques: chosen by how strong and how fast they are, and then tried.

use crate::error::Error;
use crate::initial_state::Principal;
use crate::prices;
use crate::scene::Scene;
use crate::step_control::{LEAST_TOLERANCE, StepControl};
use crate::strategy::{Driven, Strategy};
use crate::torques::{Rates, along, have_series, is_timed};
use crate::trial::{Budget, Chosen, Trial};
use tumbling::step::{State, System};

/// The largest number of steps of all trial runs together.
const MOST_STEPS: usize = 3_000_000;
/// The number of requested times at which runs are compared, besides the last,
const COMPARED: u64 = 32;
/// and the number of equal parts of the span at whose ends they are. No step is longer than one part, so that
/// what is tried is what is done.
const INNER: f64 = 16.0;

/// How often an accuracy is tried that may be attainable where the one requested is not.
const OFFERS: usize = 8;

/// The cheapest way that the trial runs showed to be accurate enough.
///
/// An accuracy is offered instead only where a plan for it was made: the smallest difference that two runs
/// showed is a bad guess, for it is small by chance where all of it is rounding.
pub(crate) fn strategy(body: &Principal, scene: &Scene) -> Result<Strategy, Error> {
    let requested = scene.accuracy();
    let mut found = strategy_to(requested, body, scene);
    let mut offered = None;
    for _ in 0..OFFERS {
        match found {
            Err(Error::Unattainable { attainable, .. }) => {
                let offer = two_digits(attainable.max(2.0 * offered.unwrap_or(0.0)));
                offered = Some(offer);
                found = strategy_to(offer, body, scene);
            }
            Ok(strategy) => {
                let refused = |attainable| Err(Error::Unattainable { requested, attainable });
                return offered.map_or(Ok(strategy), refused);
            }
            _ => break,
        }
    }
    match found {
        Err(Error::Unattainable { .. }) | Ok(_) => Err(Error::Disagreement { requested, steps: 0 }),
        Err(Error::Disagreement { steps, .. }) => Err(Error::Disagreement { requested, steps }),
        Err(error) => Err(error),
    }
}

/// The number rounded up to the two digits that are printed of it.
fn two_digits(x: f64) -> f64 {
    format!("{:.1e}", 1.05 * x).parse().unwrap_or(x).max(x)
}

fn strategy_to(accuracy: f64, body: &Principal, scene: &Scene) -> Result<Strategy, Error> {
    let torques = scene.torques().iter().map(|torque| along(body, torque)).collect::<Result<_, _>>()?;
    let system = System::with(body.moments, torques)?;
    let start = State { attitude: body.world.into_inner(), momentum: system.momentum(&body.omega) };
    let end = scene.times().end();
    let rates = Rates::of(&system, &start, end);
    let times = compared(scene);
    let turned = (rates.spin * end).max(1.0);
    let outputs = scene.outputs();
    let trial = Trial { system: &system, start: &start, times: &times, outputs, accuracy, end, turned };
    let (chosen, trials) = if end == 0.0 {
        let control = StepControl::Tolerance(first_tolerance(accuracy));
        (Chosen { control, difference: 0.0, steps: 0 }, 0.0)
    } else {
        // Where damping is that fast, each step is a collocation; MOST_STEPS of them take too long to try.
        let most = if rates.are_stiff(end) { MOST_STEPS / 20 } else { MOST_STEPS };
        first_right(&trial, &candidates(&rates, accuracy, scene), most)?
    };
    let Chosen { control, difference, steps } = chosen;
    let stops = if have_series(system.torques()) { Vec::new() } else { times.clone() };
    let stiff = rates.are_stiff(end);
    let driven = Driven { system: system.clone(), start, control, stops, difference, steps, trials, stiff };
    Ok(match control {
        StepControl::Tolerance(_) => Strategy::Adaptive(driven),
        StepControl::ExactDrift(_) => Strategy::ExactDrift(driven),
    })
}

/// What is worth a trial, in order.
fn candidates(rates: &Rates, accuracy: f64, scene: &Scene) -> Vec<StepControl> {
    let (spin, end) = (rates.spin, scene.times().end());
    let series = StepControl::Tolerance(first_tolerance(accuracy));
    if scene.torques().iter().any(is_timed) {
        // Series alone count the time, and end a step where a torque begins or ends.
        return vec![series];
    }
    let turned = (spin * end).max(1.0);
    let push = rates.push + rates.loss / spin.max(f64::MIN_POSITIVE);
    // The error of kicks goes with the square of the step, times the push.
    let radians = (12.0 * accuracy / (push * turned).max(f64::MIN_POSITIVE)).sqrt().min(turned / INNER);
    let drift = StepControl::ExactDrift((radians / spin).min(end / INNER));
    let states = scene.times().count();
    let price =
        |control: StepControl, radians: f64| control.price(states, (turned / radians).ceil() as usize, false);
    if price(drift, radians) <= price(series, prices::RADIANS) {
        // Should it not get there in reasonable steps, the series may.
        vec![drift, series]
    } else {
        vec![series]
    }
}

/// The first that is accurate enough, with the instructions of the trial runs.
fn first_right(trial: &Trial<'_>, candidates: &[StepControl], most: usize) -> Result<(Chosen, f64), Error> {
    let (mut left, mut trials, mut refusal) = (most, 0.0, None);
    for (k, &first) in candidates.iter().enumerate() {
        let share = left / (candidates.len() - k);
        let mut budget = Budget { left: share, spent: 0.0 };
        let found = trial.refined(first, &mut budget);
        left -= share - budget.left;
        trials += budget.spent;
        match found {
            Ok(chosen) => return Ok((chosen, trials)),
            Err(error) => refusal = Some(refusal.map_or(error.clone(), |other| kinder(other, error))),
        }
    }
    Err(refusal.unwrap_or(Error::Disagreement { requested: trial.accuracy, steps: 0 }))
}

/// Of two refusals the one that offers more.
fn kinder(one: Error, other: Error) -> Error {
    match (&one, &other) {
        (Error::Unattainable { attainable: a, .. }, Error::Unattainable { attainable: b, .. }) if b < a => {
            other
        }
        (Error::Unattainable { .. }, _) => one,
        _ => other,
    }
}

/// Leaves room for a finer tolerance, so that there are two runs to compare.
fn first_tolerance(accuracy: f64) -> f64 {
    (0.03 * accuracy).max(8.0 * LEAST_TOLERANCE)
}

/// Times at which runs are compared, in order: some of those requested, evenly chosen, with the last, and
/// ever closer to the first, where what fades fast is still there; and some between, for at one instant alone
/// two wrong runs may meet.
fn compared(scene: &Scene) -> Vec<f64> {
    let last = scene.times().count().saturating_sub(1);
    let every = scene.times().count().div_ceil(COMPARED).max(1);
    let doubled = (0..64).map(|k| 1_u64 << k);
    let mut places: Vec<u64> =
        (0..COMPARED).map(|k| k * every).chain(doubled).filter(|n| *n < last).collect();
    places.push(last);
    places.sort_unstable();
    places.dedup();
    let end = scene.times().end();
    let inner = (1..INNER as u32).map(|k| end * (f64::from(k) / INNER));
    let mut times: Vec<f64> = places.into_iter().map(|n| scene.times().nth(n)).chain(inner).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}
