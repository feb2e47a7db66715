//! Ways to answer for a body under torques: chosen by how strong and how fast they are, and then tried.

use super::by::By;
use super::plan::{Driven, Way};
use super::{Principal, Scene, Wants, cost};
use crate::dynamics::observe;
use crate::error::{Error, ErrorKind, Refusal};
use crate::step::{LEAST_TOLERANCE, Method, State, System, Torque};
use nalgebra::{UnitQuaternion, Vector3};

/// Whether it does nothing, at whatever attitude and spin.
pub(super) fn is_nothing(torque: &Torque<f64>) -> bool {
    let zero = Vector3::zeros();
    match torque {
        Torque::InBody(value) | Torque::InWorld(value) | Torque::Damping(value) => *value == zero,
        Torque::Aligning { arm, field } => *arm == zero || *field == zero,
        Torque::Dissipation(strength) => *strength == 0.0,
        Torque::Function(_) => false,
    }
}

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
            return Err(Refusal::Undefined {
                what: "damping that differs from axis to axis",
                why: "it is told along the principal axes, and those of a body with products of inertia have no order to go by: \
                      give the body's moments along them, without products",
            }.into());
        }
        Torque::Function(_) => {
            return Err(Refusal::Undefined {
                what: "a scene with a torque by a function",
                why: "a plan goes by how strong the torques are, which a function does not say: use a stepper",
            }
            .into());
        }
        Torque::InWorld(_) | Torque::Damping(_) | Torque::Dissipation(_) => torque.clone(),
    })
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

fn rates(system: &System<f64>, start: &State<f64>, end: f64) -> Rates {
    let omega = system.omega(&start.momentum);
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
            Torque::Function(_) => (),
            Torque::Dissipation(k) => loss = loss.max(k * start.momentum.norm_squared() * lightest),
        }
    }
    // A constant torque spins the body up; one that aligns swings it.
    let gained = (torque * lightest * end).min(if swing > 0.0 { swing } else { f64::INFINITY });
    let spin = omega.norm().max(gained).max(swing);
    let momentum = start.momentum.norm().max(spin / lightest);
    let push = if momentum * spin > 0.0 { torque / (momentum * spin) } else { 0.0 };
    Rates { spin, push, loss }
}

/// Damping is stiff if it is so many times faster than the spin,
const STIFF: f64 = 30.0;
/// and lasts for so many of its own times.
const LONG: f64 = 300.0;
/// Rounds of refinement before it is given up.
const ROUNDS: usize = 30;
/// The most steps of all runs on trial together.
const MOST_STEPS: usize = 3_000_000;
/// At so many times of those asked for the runs are compared, beside the last,
const COMPARED: u64 = 32;
/// and in so many even parts of the span. No step is longer than one, so that what is tried is what is done.
const INNER: f64 = 16.0;

/// The cheapest way that was seen to be accurate enough.
#[allow(clippy::cast_precision_loss)]
pub(super) fn way(body: &Principal, scene: &Scene) -> Result<Way, Error> {
    let torques = scene.torques.iter().map(|torque| along(body, torque)).collect::<Result<_, _>>()?;
    let system = System::with(body.moments, torques)?;
    let start = State { attitude: body.world.into_inner(), momentum: system.momentum(&body.omega) };
    let (end, accuracy) = (scene.times.end(), scene.accuracy);
    let Rates { spin, push, loss } = rates(&system, &start, end);
    let times = compared(scene);
    let (turned, lost) = ((spin * end).max(1.0), loss * end);
    let wants = scene.wants;
    let trial = Trial { system: &system, start: &start, times: &times, wants, accuracy, end, turned, lost };
    let stiff = loss > STIFF * spin.max(1.0 / end) && lost > LONG;
    let way = |(by, seen, steps): Settled, trials: f64| {
        let driven = Driven { system: system.clone(), start, by, seen, steps, trials, stiff };
        match by {
            By::Control(_) => Way::Controlled(driven),
            By::Flow(_) => Way::Flow(driven),
            By::Steps(..) if stiff => Way::Stiff(driven),
            By::Steps(..) => Way::Stepper(driven),
        }
    };
    let pair = By::Control(first_tolerance(accuracy));
    if end == 0.0 {
        return Ok(way((pair, 0.0, 0), 0.0));
    }
    let tried = if stiff {
        // Damping shortens the pair's steps, but its few may do. Of the others one takes the loss by its own law, one linearises it: which
        // is better depends on what it works against. So all are tried, each only while it may be cheaper than those before.
        let step = (0.1 / spin.max(10.0 / end)).min(end / INNER);
        vec![pair, By::Steps(Method::MoserVeselov8, step), By::Steps(Method::LinearisedImplicit, step)]
    } else {
        match cheapest(spin, push + loss / spin.max(f64::MIN_POSITIVE), end, scene) {
            By::Control(_) => vec![pair],
            // Should it not get there in reasonable steps, the pair may.
            other => vec![other, pair],
        }
    };
    let states = scene.times.count();
    let (mut best, mut refusal): (Option<(f64, Settled)>, Option<Error>) = (None, None);
    let (mut left, mut trials) = (MOST_STEPS, 0.0);
    for (k, &first) in tried.iter().enumerate() {
        if best.is_some() && !stiff {
            break;
        }
        let least = best.as_ref().map_or(f64::INFINITY, |(price, _)| *price);
        if first.price(states, 0) >= least {
            continue;
        }
        let share = left / (tried.len() - k);
        let mut allowed = share;
        match trial.settled(first, &mut allowed, least / first.price_of_step()) {
            Ok(settled) => {
                let price = settled.0.price(states, settled.2);
                if best.as_ref().is_none_or(|(other, _)| price < *other) {
                    best = Some((price, settled));
                }
            }
            Err(error) => refusal = Some(refusal.map_or(error.clone(), |other| kinder(other, error))),
        }
        left -= share - allowed;
        trials += first.price_of_step() * (share - allowed) as f64;
    }
    match (best, refusal) {
        (Some((_, settled)), _) => Ok(way(settled, trials)),
        (None, Some(error)) => Err(error),
        (None, None) => Err(Refusal::Disagreement { asked: accuracy, steps: 0 }.into()),
    }
}

/// Of two refusals the one that offers more.
fn kinder(one: Error, other: Error) -> Error {
    match (one.refusal(), other.refusal()) {
        (Refusal::Unattainable { attainable: a, .. }, Refusal::Unattainable { attainable: b, .. })
            if b < a =>
        {
            other
        }
        (Refusal::Unattainable { .. }, _) => one,
        _ => other,
    }
}

/// Leaves room for a finer tolerance, so that there are two runs to compare.
fn first_tolerance(accuracy: f64) -> f64 {
    (0.03 * accuracy).max(8.0 * LEAST_TOLERANCE)
}

/// By what their errors and costs are known to be: kicks err as the square of the step times what they do, the pair as the fifth power.
#[allow(clippy::cast_precision_loss)]
fn cheapest(spin: f64, push: f64, end: f64, scene: &Scene) -> By {
    let (accuracy, turned) = (scene.accuracy, (spin * end).max(1.0));
    let least = scene.times.count() as f64;
    let radians = (12.0 * accuracy / (push * turned).max(f64::MIN_POSITIVE)).sqrt().min(turned / INNER);
    let price = |each: f64, radians: f64, least: f64| each * (turned / radians).max(least);
    let turn = radians.min(0.25);
    let step = |radians: f64| (radians / spin).min(end / INNER);
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

/// Times at which runs are compared, in order: of those asked for some evenly chosen, with the last, and ever closer to the first, where what
/// fades fast is still there; and some between, for at one instant alone two wrong runs may meet.
fn compared(scene: &Scene) -> Vec<f64> {
    let last = scene.times.count().saturating_sub(1);
    let every = scene.times.count().div_ceil(COMPARED).max(1);
    let doubled = (0..64).map(|k| 1_u64 << k);
    let mut places: Vec<u64> =
        (0..COMPARED).map(|k| k * every).chain(doubled).filter(|n| *n < last).collect();
    places.push(last);
    places.sort_unstable();
    places.dedup();
    let end = scene.times.end();
    let inner = (1..INNER as u32).map(|k| end * (f64::from(k) / INNER));
    let mut times: Vec<f64> = places.into_iter().map(|n| scene.times.nth(n)).chain(inner).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// How it is stepped, how far from a coarser run, in how many steps.
type Settled = (By, f64, usize);

struct Trial<'a> {
    system: &'a System<f64>,
    start: &'a State<f64>,
    times: &'a [f64],
    /// What is asked for.
    wants: Wants,
    accuracy: f64,
    end: f64,
    /// Radians from start to end.
    turned: f64,
    /// Times of the loss from start to end.
    lost: f64,
}

impl Trial<'_> {
    /// How many steps a run will take, about.
    fn steps(&self, by: By) -> f64 {
        match by {
            By::Steps(_, step) | By::Flow(step) => self.end / step,
            By::Control(tolerance) => 0.3 * (self.turned / tolerance.powf(0.2)).max(self.lost),
        }
    }

    /// Refines until two runs agree to half of the accuracy, and takes the finer, or to a tenth, and takes the coarser; by so many steps in all, none of a run that is
    /// known to take more than `most`.
    #[allow(clippy::cast_precision_loss)]
    fn settled(&self, first: By, left: &mut usize, most: f64) -> Result<Settled, Error> {
        let steps = self.steps(first);
        if steps.is_nan() {
            return Err(Refusal::OutOfRange {
                what: "the number of steps that the torques ask for",
                value: steps,
            }
            .into());
        }
        if steps > *left as f64 {
            return Err(Refusal::Order {
                smaller: "the number of steps that the torques ask for",
                small: steps,
                larger: "the most that are tried",
                large: *left as f64,
            }
            .into());
        }
        let all = *left;
        let mut by = first;
        let (mut best, mut before) = (f64::INFINITY, 0.0);
        let mut coarse = self.run(by, None, left, most);
        for _ in 0..ROUNDS {
            if coarse.as_ref().is_err_and(|error| error.kind() == ErrorKind::TooMany) {
                break;
            }
            let seen = coarse.as_ref().map_or(f64::INFINITY, |_| best);
            let finer = by.finer(if seen.is_finite() { 0.5 * self.accuracy / seen } else { 0.0 });
            if finer == by || self.steps(finer) > (*left as f64).min(most) {
                break;
            }
            let fine = self.run(finer, Some(by), left, most);
            let difference = match (&coarse, &fine) {
                (Ok((a, _)), Ok((b, _))) => self.apart(a, b),
                _ => f64::INFINITY,
            };
            // Steps that a loss is over within do not yet show how their errors fall: two differences must.
            let shown = difference <= 0.6 * before || !self.outrun(by);
            before = difference;
            // Halving the step halves an error at least: what is so much better than asked is right by the coarser run already.
            if shown
                && difference <= 0.1 * self.accuracy
                && let Ok((_, steps)) = &coarse
            {
                return Ok((by, difference, *steps));
            }
            if shown
                && difference <= 0.5 * self.accuracy
                && let Ok((_, steps)) = &fine
            {
                return Ok((finer, difference, *steps));
            }
            best = best.min(difference);
            // What was cut for the comparison alone is put back before it is compared with the next.
            coarse = if self.cuts(finer, by) { self.run(finer, None, left, most) } else { fine };
            by = finer;
        }
        match coarse {
            _ if 2.0 * best < 1.0 => {
                Err(Refusal::Unattainable { asked: self.accuracy, attainable: 2.0 * best }.into())
            }
            Err(error) if best.is_infinite() && error.kind() != ErrorKind::TooMany => Err(error),
            _ => Err(Refusal::Disagreement { asked: self.accuracy, steps: all - *left }.into()),
        }
    }

    /// Whether a loss is over within one step.
    fn outrun(&self, by: By) -> bool {
        let (By::Steps(_, step) | By::Flow(step)) = by else { return false };
        self.lost * step > self.end
    }

    /// Whether a finer step is not finer everywhere: between some of the times both are one step, or as many.
    fn cuts(&self, finer: By, coarser: By) -> bool {
        let mut from = 0.0;
        self.times.iter().any(|&to| {
            let between = to - std::mem::replace(&mut from, to);
            between > 0.0 && finer.count(between) < coarser.count(between).map(|count| 2 * count)
        })
    }

    /// With `over` a coarser step, at least twice as many between each two times: what takes one step either way would agree with itself.
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)] // saturates
    fn run(
        &self,
        by: By,
        over: Option<By>,
        left: &mut usize,
        most: f64,
    ) -> Result<(Vec<State<f64>>, usize), Error> {
        let (mut now, mut motion) = (0.0, *self.start);
        let whole = (*left).min(most as usize);
        let mut of_run = whole;
        let mut seen = Vec::with_capacity(self.times.len());
        let mut on = |of_run: &mut usize| {
            for &time in self.times {
                if time > now {
                    let between = time - now;
                    let least = over.and_then(|coarser| coarser.count(between)).map_or(1, |count| 2 * count);
                    (motion, now) = (by.on(self.system, &motion, between, least, of_run)?, time);
                }
                seen.push(motion);
            }
            Ok(())
        };
        let done = on(&mut of_run);
        let taken = whole - of_run;
        *left -= taken;
        done.map(|()| (seen, taken))
    }

    /// The largest angle between two runs' attitudes, or difference of spin, or of energy, beside the largest so far; of attitude and energy
    /// where they are asked for.
    fn apart(&self, a: &[State<f64>], b: &[State<f64>]) -> f64 {
        let (mut fastest, mut richest, mut worst) = (0.0_f64, 0.0_f64, 0.0_f64);
        let over = |x: f64, y: f64| if y > 0.0 { x / y } else { 0.0 };
        for (one, other) in a.iter().zip(b) {
            let (w, v) = (self.system.omega(&one.momentum), self.system.omega(&other.momentum));
            fastest = fastest.max(v.norm());
            let spin = over((w - v).norm(), fastest);
            let energy = if self.wants.energy {
                let [d, e] = [(&w, one), (&v, other)].map(|(w, motion)| observe::energy(w, &motion.momentum));
                richest = richest.max(e);
                over((d - e).abs(), richest)
            } else {
                0.0
            };
            let [p, q] = [one, other].map(|motion| UnitQuaternion::from_quaternion(motion.attitude));
            let turn = if self.wants.attitude { p.angle_to(&q) } else { 0.0 };
            worst = worst.max(spin).max(energy).max(turn);
            // A difference that is not a number is no agreement.
            if spin.is_nan() || energy.is_nan() || turn.is_nan() {
                return f64::INFINITY;
            }
        }
        worst
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Quaternion;

    /// A needle turns fast about its light axis, and its energy is in the heavy ones: a percent of the spin is two thirds of it.
    #[test]
    fn runs_that_agree_in_spin_and_not_in_energy_are_apart_where_energy_is_asked_for() {
        let system = System::free([1e-4, 1.0, 1.0].try_into().unwrap()).unwrap();
        let [a, b] = [0.1, 0.2].map(|heavy| State {
            attitude: Quaternion::identity(),
            momentum: system.momentum(&Vector3::new(10.0, heavy, 0.0)),
        });
        let apart = |energy| {
            let (times, accuracy, end, turned, lost) = (&[1.0][..], 0.1, 1.0, 10.0, 0.0);
            let wants = Wants { spin: true, energy, ..Wants::NOTHING };
            let trial = Trial { system: &system, start: &a, times, wants, accuracy, end, turned, lost };
            trial.apart(std::slice::from_ref(&a), std::slice::from_ref(&b))
        };
        assert!((apart(false) - 0.01).abs() < 1e-5);
        // 0.005 + 0.005 J and 0.005 + 0.02 J.
        assert!((apart(true) - 0.6).abs() < 1e-12);
    }

    /// Between times that are closer than a step two runs would take the same one, and agree whatever it is worth.
    #[test]
    fn a_finer_run_has_twice_the_steps_between_any_two_times() {
        let system = System::free([1.0, 2.0, 2.5].try_into().unwrap()).unwrap();
        let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.1, 2.0, 0.3) };
        let times = &[0.01, 0.02, 1.0][..];
        let (accuracy, end, turned, lost) = (0.1, 1.0, 1.0, 0.0);
        let wants = Wants { spin: true, ..Wants::NOTHING };
        let trial = Trial { system: &system, start: &start, times, wants, accuracy, end, turned, lost };
        let [coarse, fine] = [0.5, 0.25].map(|step| By::Steps(Method::MoserVeselov8, step));
        let steps = |by, over| trial.run(by, over, &mut { 1000 }, f64::INFINITY).unwrap().1;
        assert_eq!((steps(coarse, None), steps(fine, None), steps(fine, Some(coarse))), (4, 6, 8));
        assert!(trial.cuts(fine, coarse) && !trial.cuts(By::Steps(Method::MoserVeselov8, 0.005), coarse));
    }
}
