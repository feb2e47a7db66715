//! Ways to answer for a body under torques: chosen by how strong and how fast they are, and then tried.

use crate::error::Error;
use crate::initial_state::Principal;
use crate::prices;
use crate::scene::Scene;
use crate::step_control::{LEAST_TOLERANCE, StepControl};
use crate::strategy::{Driven, Strategy};
use crate::trial::{Chosen, Trial};
use nalgebra::Vector3;
use tumbling::step::{Method, State, System, Torque};

/// A torque given in body axes, along the principal axes.
///
/// # Errors
/// Damping that differs from axis to axis, of a body whose principal axes are others.
fn along(body: &Principal, torque: &Torque<f64>) -> Result<Torque<f64>, Error> {
    let turned = |v: &Vector3<f64>| body.frame.map_or(*v, |frame| frame.inverse() * v);
    Ok(match torque {
        Torque::InBody(value) => Torque::InBody(turned(value)),
        Torque::Aligning { arm, field } => Torque::Aligning { arm: turned(arm), field: *field },
        Torque::Damping(c) if body.frame.is_some() && (c.x != c.y || c.y != c.z) => {
            return Err(Error::Undefined {
                what: "damping that differs from axis to axis",
                why: "it acts along the principal axes, and those of a body with products of inertia have no order to go by: \
                      give the body's moments along them, without products",
            });
        }
        Torque::InWorld(_) | Torque::Damping(_) | Torque::Dissipation(_) => torque.clone(),
        _ => {
            return Err(Error::Undefined {
                what: "the motion under a torque given by a function",
                why: "a plan goes by how strong the torques are, which a function does not say: use a stepper",
            });
        }
    })
}

/// How fast the torques change the motion, 1/s.
struct Rates {
    /// The spin, or the larger one that the torques give in the scene's time.
    spin: f64,
    /// The relative change of the momentum by the lossless torques while the body turns by a radian.
    push: f64,
    /// The fastest loss.
    loss: f64,
}

fn rates(system: &System<f64>, start: &State<f64>, end: f64) -> Rates {
    let omega = system.omega(&start.momentum);
    let (mut torque, mut loss, mut swing) = (0.0_f64, 0.0_f64, 0.0_f64);
    let lightest = 1.0 / system.moments().min();
    for one in system.torques() {
        match one {
            Torque::InBody(value) | Torque::InWorld(value) => torque += value.norm(),
            Torque::Aligning { arm, field } => {
                torque += arm.norm() * field.norm();
                swing = swing.max((arm.norm() * field.norm() * lightest).sqrt());
            }
            Torque::Damping(c) => loss = loss.max(c.component_div(system.moments()).max()),
            Torque::Dissipation(k) => loss = loss.max(k * start.momentum.norm_squared() * lightest),
            // `along` has refused others.
            _ => {}
        }
    }
    // A constant torque spins the body up; one that aligns swings it.
    let gained = (torque * lightest * end).min(if swing > 0.0 { swing } else { f64::INFINITY });
    let spin = omega.norm().max(gained).max(swing);
    let momentum = start.momentum.norm().max(spin / lightest);
    let push = if momentum * spin > 0.0 { torque / (momentum * spin) } else { 0.0 };
    Rates { spin, push, loss }
}

/// Damping is stiff if it is faster than the spin by this factor,
const STIFF: f64 = 30.0;
/// and lasts for this number of its own time constants.
const LONG: f64 = 300.0;
/// The largest number of steps of all trial runs together.
const MOST_STEPS: usize = 3_000_000;
/// The number of requested times at which runs are compared, besides the last,
const COMPARED: u64 = 32;
/// and the number of equal parts of the span at whose ends they are. No step is longer than one part, so that
/// what is tried is what is done.
const INNER: f64 = 16.0;

/// The cheapest way that the trial runs showed to be accurate enough.
pub(crate) fn strategy(body: &Principal, scene: &Scene) -> Result<Strategy, Error> {
    let torques = scene.torques().iter().map(|torque| along(body, torque)).collect::<Result<_, _>>()?;
    let system = System::with(body.moments, torques)?;
    let start = State { attitude: body.world.into_inner(), momentum: system.momentum(&body.omega) };
    let end = scene.times().end();
    let rates = rates(&system, &start, end);
    let times = compared(scene);
    let (turned, lost) = ((rates.spin * end).max(1.0), rates.loss * end);
    let stiff = rates.loss > STIFF * rates.spin.max(1.0 / end) && lost > LONG;
    let (outputs, accuracy) = (scene.outputs(), scene.accuracy());
    let trial = Trial { system: &system, start: &start, times: &times, outputs, accuracy, end, turned, lost };
    let (chosen, trials) = if end == 0.0 {
        let control = StepControl::Tolerance(first_tolerance(accuracy));
        (Chosen { control, difference: 0.0, steps: 0 }, 0.0)
    } else {
        cheapest_tried(&trial, &candidates(&rates, stiff, scene), scene.times().count(), stiff)?
    };
    let Chosen { control, difference, steps } = chosen;
    let driven = Driven { system: system.clone(), start, control, difference, steps, trials, stiff };
    Ok(match control {
        StepControl::Tolerance(_) => Strategy::Adaptive(driven),
        StepControl::ExactDrift(_) => Strategy::ExactDrift(driven),
        StepControl::Fixed(..) => Strategy::Stiff(driven),
    })
}

/// What is worth a trial, in order.
fn candidates(rates: &Rates, stiff: bool, scene: &Scene) -> Vec<StepControl> {
    let (spin, end) = (rates.spin, scene.times().end());
    let series = StepControl::Tolerance(first_tolerance(scene.accuracy()));
    if stiff {
        // Damping shortens the steps of series, but a few may do. Of the others one takes the loss by its own
        // law, one linearises it: which is better depends on what it works against. So all are tried, each
        // only while it may be cheaper than those before.
        let step = (0.1 / spin.max(10.0 / end)).min(end / INNER);
        let fixed = |method| StepControl::Fixed(method, step);
        return vec![series, fixed(Method::MoserVeselov8), fixed(Method::LinearisedImplicit)];
    }
    let turned = (spin * end).max(1.0);
    let push = rates.push + rates.loss / spin.max(f64::MIN_POSITIVE);
    // The error of kicks goes with the square of the step, times the push.
    let radians =
        (12.0 * scene.accuracy() / (push * turned).max(f64::MIN_POSITIVE)).sqrt().min(turned / INNER);
    let drift = StepControl::ExactDrift((radians / spin).min(end / INNER));
    let states = scene.times().count();
    let price =
        |control: StepControl, radians: f64| control.price(states, (turned / radians).ceil() as usize);
    if price(drift, radians) <= price(series, prices::RADIANS) {
        // Should it not get there in reasonable steps, the series may.
        vec![drift, series]
    } else {
        vec![series]
    }
}

/// The first that is accurate enough, or of all the cheapest, with the instructions of the trial runs.
fn cheapest_tried(
    trial: &Trial<'_>,
    candidates: &[StepControl],
    states: u64,
    all: bool,
) -> Result<(Chosen, f64), Error> {
    let (mut best, mut refusal): (Option<(f64, Chosen)>, Option<Error>) = (None, None);
    let (mut left, mut trials) = (MOST_STEPS, 0.0);
    for (k, &first) in candidates.iter().enumerate() {
        if best.is_some() && !all {
            break;
        }
        let least = best.as_ref().map_or(f64::INFINITY, |(price, _)| *price);
        if first.price(states, 0) >= least {
            continue;
        }
        let share = left / (candidates.len() - k);
        let mut allowed = share;
        match trial.refined(first, &mut allowed, least / first.price_of_step()) {
            Ok(chosen) => {
                let price = chosen.control.price(states, chosen.steps);
                if best.as_ref().is_none_or(|(other, _)| price < *other) {
                    best = Some((price, chosen));
                }
            }
            Err(error) => refusal = Some(refusal.map_or(error.clone(), |other| kinder(other, error))),
        }
        left -= share - allowed;
        trials += first.price_of_step() * (share - allowed) as f64;
    }
    match (best, refusal) {
        (Some((_, chosen)), _) => Ok((chosen, trials)),
        (None, Some(error)) => Err(error),
        (None, None) => Err(Error::Disagreement { requested: trial.accuracy, steps: 0 }),
    }
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
