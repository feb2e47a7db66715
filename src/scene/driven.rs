//! Ways to answer for a body under torques: chosen by how strong and how fast they are, and then tried.

use super::plan::{By, Driven, Way};
use super::{Principal, Scene, cost};
use crate::error::Error;
use crate::flow;
use crate::step::{LEAST_TOLERANCE, Method, Motion, System, Torque, controlled};
use nalgebra::{UnitQuaternion, Vector3};

/// Whether it does nothing, at whatever attitude and spin.
pub(super) fn is_nothing(torque: &Torque<f64>) -> bool {
    let zero = Vector3::zeros();
    match torque {
        Torque::InBody(value) | Torque::InWorld(value) | Torque::Damping(value) => *value == zero,
        Torque::Aligning { arm, field } => *arm == zero || *field == zero,
        Torque::Dissipation(strength) => *strength == 0.0,
    }
}

/// A torque given in body axes, along the principal axes. Damping is along them already.
fn along(body: &Principal, torque: &Torque<f64>) -> Torque<f64> {
    let turned = |v: &Vector3<f64>| body.frame.map_or(*v, |frame| frame.inverse() * v);
    match torque {
        Torque::InBody(value) => Torque::InBody(turned(value)),
        Torque::Aligning { arm, field } => Torque::Aligning { arm: turned(arm), field: *field },
        Torque::InWorld(_) | Torque::Damping(_) | Torque::Dissipation(_) => torque.clone(),
    }
}

/// How fast the torques change the motion, 1/s.
struct Rates {
    /// The spin, or what the torques make of it in the scene's time where that is more.
    spin: f64,
    /// What the torques that are no loss do, beside the spin: their change of the momentum in the time of a radian, as its share.
    push: f64,
    /// The fastest loss.
    loss: f64,
}

fn rates(system: &System<f64>, start: &Motion<f64>, end: f64) -> Rates {
    let omega = system.omega(&start.vector);
    let (mut torque, mut loss, mut swing) = (0.0_f64, 0.0_f64, 0.0_f64);
    let lightest = system.inverse().max();
    for one in system.torques() {
        match one {
            Torque::InBody(value) | Torque::InWorld(value) => torque += value.norm(),
            Torque::Aligning { arm, field } => {
                torque += arm.norm() * field.norm();
                swing = swing.max((arm.norm() * field.norm() * lightest).sqrt());
            }
            Torque::Damping(c) => loss = loss.max(c.component_mul(system.inverse()).max()),
            Torque::Dissipation(k) => loss = loss.max(k * start.vector.norm_squared() * lightest),
        }
    }
    // A constant torque spins the body up; one that aligns swings it.
    let gained = (torque * lightest * end).min(if swing > 0.0 { swing } else { f64::INFINITY });
    let spin = omega.norm().max(gained).max(swing);
    let momentum = start.vector.norm().max(spin / lightest);
    let push = if momentum * spin > 0.0 { torque / (momentum * spin) } else { 0.0 };
    Rates { spin, push, loss }
}

/// Damping is stiff if it is so many times faster than the spin,
const STIFF: f64 = 30.0;
/// and lasts for so many of its own times.
const LONG: f64 = 300.0;
/// Rounds of refinement before it is given up.
const ROUNDS: usize = 30;
/// The most steps of one run on trial.
const MOST_STEPS: f64 = 3e6;
/// At so many times the runs are compared, beside the last.
const COMPARED: u64 = 32;

/// The cheapest way that was seen to be accurate enough.
pub(super) fn way(body: &Principal, scene: &Scene) -> Result<Way, Error> {
    let torques = scene.torques.iter().map(|torque| along(body, torque)).collect();
    let system = System::with(&body.moments, torques)?;
    let start = Motion { attitude: body.world.into_inner(), vector: system.momentum(&body.omega) };
    let (end, accuracy) = (scene.times.end(), scene.accuracy);
    let Rates { spin, push, loss } = rates(&system, &start, end);
    let times = compared(scene);
    let turned = (spin * end).max(loss * end).max(1.0);
    let trial = Trial { system: &system, start: &start, times: &times, accuracy, end, turned };
    let driven =
        |(by, seen, steps): Settled| Driven { system: system.clone(), start: start.clone(), by, seen, steps };
    if end == 0.0 {
        return Ok(Way::Controlled(driven((By::Control(accuracy.max(LEAST_TOLERANCE)), 0.0, 0))));
    }
    if loss > STIFF * spin.max(1.0 / end) && loss * end > LONG {
        // One takes the loss by its own law, the other linearises it: which is better depends on what it works against.
        let step = 0.1 / spin.max(10.0 / end);
        let tried = [Method::MoserVeselov8, Method::LinearisedImplicit]
            .map(|method| trial.settled(By::Steps(method, step)));
        let [kicked, implicit] = tried;
        let best = match (kicked, implicit) {
            (Ok(a), Ok(b)) => {
                if a.2 <= b.2 {
                    a
                } else {
                    b
                }
            }
            (Ok(one), Err(_)) | (Err(_), Ok(one)) => one,
            (Err(error), Err(_)) => return Err(error),
        };
        return Ok(Way::Stiff(driven(best)));
    }
    let way = cheapest(spin, push + loss / spin.max(f64::MIN_POSITIVE), end, scene);
    let settled = trial.settled(way);
    match (way, settled) {
        (By::Steps(..), Ok(settled)) => Ok(Way::Stepper(driven(settled))),
        (By::Flow(_), Ok(settled)) => Ok(Way::Flow(driven(settled))),
        (By::Control(_), Ok(settled)) => Ok(Way::Controlled(driven(settled))),
        // Kicks that do not get there in reasonable steps: the controlled pair may.
        (By::Steps(..) | By::Flow(_), Err(_)) => trial
            .settled(By::Control(first_tolerance(accuracy)))
            .map(|settled| Way::Controlled(driven(settled))),
        (By::Control(_), Err(error)) => Err(error),
    }
}

fn first_tolerance(accuracy: f64) -> f64 {
    (0.03 * accuracy).max(LEAST_TOLERANCE)
}

/// By what their errors and costs are known to be: kicks err as the square of the step times what they do, the pair as the fifth power.
#[allow(clippy::cast_precision_loss)]
fn cheapest(spin: f64, push: f64, end: f64, scene: &Scene) -> By {
    let (accuracy, turned) = (scene.accuracy, (spin * end).max(1.0));
    let least = scene.times.count() as f64;
    let radians = (12.0 * accuracy / (push * turned).max(f64::MIN_POSITIVE)).sqrt();
    let price = |each: f64, radians: f64, least: f64| each * (turned / radians).max(least);
    let turn = radians.min(0.25);
    let step = |radians: f64| (radians / spin).min(end);
    let tolerance = first_tolerance(accuracy);
    let by_pair = price(cost::PAIR, 2.0 * tolerance.powf(0.2), cost::ANEW * least);
    let by_steps = price(cost::KICKED, turn, least);
    let by_flow = price(cost::FLOW, radians, least);
    if by_steps <= by_pair && by_steps <= by_flow {
        By::Steps(Method::MoserVeselov8, step(turn))
    } else if by_flow <= by_pair {
        By::Flow(step(radians))
    } else {
        By::Control(tolerance)
    }
}

/// Some of the times asked for, and the last.
fn compared(scene: &Scene) -> Vec<f64> {
    let count = scene.times.count();
    let every = count.div_ceil(COMPARED).max(1);
    let mut times: Vec<f64> = (1..=COMPARED).map(|k| scene.times.nth(k * every)).collect();
    times.push(scene.times.end());
    times.dedup();
    times
}

/// How it is stepped, how far from a coarser run, in how many steps.
type Settled = (By, f64, usize);

struct Trial<'a> {
    system: &'a System<f64>,
    start: &'a Motion<f64>,
    times: &'a [f64],
    accuracy: f64,
    end: f64,
    /// Radians, or times of the loss, from start to end.
    turned: f64,
}

impl Trial<'_> {
    /// How many steps a run will take, about.
    fn steps(&self, by: By) -> f64 {
        match by {
            By::Steps(_, step) | By::Flow(step) => self.end / step,
            By::Control(tolerance) => 0.3 * self.turned / tolerance.powf(0.2),
        }
    }

    /// Refines until two runs agree to half of the accuracy, and takes the finer.
    fn settled(&self, first: By) -> Result<Settled, Error> {
        let steps = self.steps(first);
        if steps.is_nan() || steps > MOST_STEPS {
            return Err(Error::Order {
                smaller: "the number of steps that the torques ask for",
                small: steps,
                larger: "the most that are tried",
                large: MOST_STEPS,
            });
        }
        let mut by = first;
        let mut best = f64::INFINITY;
        let mut coarse = self.run(by);
        for _ in 0..ROUNDS {
            let seen = coarse.as_ref().map_or(f64::INFINITY, |_| best);
            let finer = by.finer(if seen.is_finite() { 0.5 * self.accuracy / seen } else { 0.0 });
            if finer == by || self.steps(finer) > MOST_STEPS {
                break;
            }
            let fine = self.run(finer);
            let difference = match (&coarse, &fine) {
                (Ok((a, _)), Ok((b, _))) => apart(self.system, a, b),
                _ => f64::INFINITY,
            };
            if difference <= 0.5 * self.accuracy
                && let Ok((_, steps)) = &fine
            {
                return Ok((finer, difference, *steps));
            }
            best = best.min(difference);
            (by, coarse) = (finer, fine);
        }
        match coarse {
            Err(error) if best.is_infinite() => Err(error),
            _ => Err(Error::Unattainable { asked: self.accuracy, attainable: 2.0 * best }),
        }
    }

    fn run(&self, by: By) -> Result<(Vec<Motion<f64>>, usize), Error> {
        let (mut now, mut motion, mut steps) = (0.0, self.start.clone(), 0_usize);
        let mut seen = Vec::with_capacity(self.times.len());
        for &time in self.times {
            if time > now {
                let (end, taken) = by.on(self.system, &motion, time - now)?;
                (motion, steps, now) = (end, steps + taken, time);
            }
            seen.push(motion.clone());
        }
        Ok((seen, steps))
    }
}

/// The largest angle between two runs' attitudes, or difference of spin beside the largest spin so far.
fn apart(system: &System<f64>, a: &[Motion<f64>], b: &[Motion<f64>]) -> f64 {
    let (mut largest, mut worst) = (0.0_f64, 0.0_f64);
    for (one, other) in a.iter().zip(b) {
        let (w, v) = (system.omega(&one.vector), system.omega(&other.vector));
        largest = largest.max(v.norm());
        let spin = if largest > 0.0 { (w - v).norm() / largest } else { 0.0 };
        let [p, q] = [one, other].map(|motion| UnitQuaternion::from_quaternion(motion.attitude));
        worst = worst.max(spin).max(p.angle_to(&q));
        // A difference that is not a number is no agreement.
        if spin.is_nan() {
            return f64::INFINITY;
        }
    }
    worst
}

impl By {
    /// `duration` seconds on: the motion, and in how many steps.
    pub(super) fn on(
        self,
        system: &System<f64>,
        start: &Motion<f64>,
        duration: f64,
    ) -> Result<(Motion<f64>, usize), Error> {
        let (step, method) = match self {
            Self::Control(tolerance) => {
                let run = controlled(system, start, duration, tolerance)?;
                return Ok((run.end, run.steps + run.rejected));
            }
            Self::Steps(method, step) => (step, Some(method)),
            Self::Flow(step) => (step, None),
        };
        let (count, h) = parts(duration, step)?;
        let mut motion = start.clone();
        for _ in 0..count {
            motion = match method {
                Some(method) => method.step(system, &motion, &h)?,
                None => flow::step(system, &motion, h)?,
            };
        }
        Ok((motion, count))
    }

    /// The same, finer: by half or more, aiming at an error so many times as large.
    fn finer(self, share: f64) -> Self {
        let by = |order: i32| (0.8 * share.powf(1.0 / f64::from(order))).clamp(1e-2, 0.5);
        match self {
            Self::Steps(method @ Method::LinearisedImplicit, step) => Self::Steps(method, step * by(1)),
            Self::Steps(method, step) => Self::Steps(method, step * if share > 0.0 { by(2) } else { 0.5 }),
            Self::Flow(step) => Self::Flow(step * if share > 0.0 { by(2) } else { 0.5 }),
            Self::Control(tolerance) => {
                Self::Control((tolerance * if share > 0.0 { by(1) } else { 0.1 }).max(LEAST_TOLERANCE))
            }
        }
    }
}

/// In how many equal parts none is longer than `step`.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, and below 2^53
fn parts(duration: f64, step: f64) -> Result<(usize, f64), Error> {
    let count = (duration / step).ceil().max(1.0);
    if count.is_nan() || count > 1.0 / f64::EPSILON {
        return Err(Error::OutOfRange { what: "the number of steps", value: count });
    }
    Ok((count as usize, duration / count))
}
