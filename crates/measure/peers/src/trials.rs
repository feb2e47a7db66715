//! Random scenes under torques, planned by the library and held against DOP853 of `differential-equations`:
//! how many answers are off by more than requested, and by how much.

use crate::law::Packed;
use differential_equations::prelude::*;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::step::Torque;
use tumbling_measure::story::Wrong;
use tumbling_scenes::{Answer, InitialState, Outputs, Scene, Times};

/// Numbers by chance: SplitMix64.
struct Chance(u64);

impl Chance {
    /// From 0 to 1.
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Even in the logarithm, from a power of ten to another.
    fn power(&mut self, from: f64, to: f64) -> f64 {
        10_f64.powf(from + (to - from) * self.share())
    }

    fn vector(&mut self, size: f64) -> Vector3<f64> {
        let mut part = || 2.0 * self.share() - 1.0;
        let v = Vector3::new(part(), part(), part());
        if v.norm() > 1e-3 { v.normalize() * size } else { Vector3::x() * size }
    }
}

/// A body under torques, its momentum in units of its size at the start.
struct Trial {
    moments: Vector3<f64>,
    omega: Vector3<f64>,
    torques: Vec<Torque<f64>>,
    end: f64,
    accuracy: f64,
    size: f64,
}

/// At how many times answers are compared.
const TIMES: usize = 8;

impl Trial {
    /// A box of any sides, spun about any axis, under one torque or two of any strength; with `more`, a
    /// gravity gradient too, or a push from one time to another.
    fn by(chance: &mut Chance, more: bool) -> Self {
        let squares = [(); 3].map(|()| chance.power(-1.5, 1.5));
        let moments = Vector3::from_fn(|i, _| squares[(i + 1) % 3] + squares[(i + 2) % 3]);
        let speed = chance.power(-1.0, 1.0);
        let omega = chance.vector(speed);
        let momentum = moments.component_mul(&omega);
        let energy = momentum.dot(&omega) / 2.0;
        let mut fastest = speed;
        let mut torques = Vec::new();
        for _ in 0..=usize::from(chance.share() < 0.4) {
            let strength = chance.power(-3.0, 1.5) * energy;
            torques.push(match (chance.share() * 5.0) as u32 {
                0 => Torque::InBody(chance.vector(strength)),
                1 => Torque::InWorld(chance.vector(strength)),
                2 => Torque::Aligning { arm: chance.vector(1.0), field: chance.vector(strength) },
                3 => Torque::Damping(Vector3::from_fn(|i, _| moments[i] * speed * chance.power(-3.0, 1.0))),
                _ => Torque::Dissipation(
                    chance.power(-3.0, 0.5) * speed / momentum.norm_squared() * moments.min(),
                ),
            });
            fastest = fastest.max((strength / moments.min()).sqrt());
        }
        let end = (2.0 + 38.0 * chance.share()) / fastest;
        let accuracy = chance.power(-10.0, -2.0);
        if more && chance.share() < 0.5 {
            let rate = speed * chance.power(-2.0, 0.0);
            let orbit = chance.vector(rate);
            let strength = chance.power(-2.0, 0.5) * speed * speed;
            torques.push(Torque::GravityGradient { strength, direction: chance.vector(1.0), orbit });
        } else if more {
            let (from, to) = (end * chance.share(), end * chance.share());
            let strength = chance.power(-2.0, 1.0) * energy;
            let push = chance.vector(strength);
            let push = if chance.share() < 0.5 { Torque::InBody(push) } else { Torque::InWorld(push) };
            torques.push(Torque::during(from.min(to), from.max(to), push));
        }
        Self { moments, omega, torques, end, accuracy, size: momentum.norm() }
    }

    /// The times at which answers are compared.
    fn times(&self) -> Vec<f64> {
        (1..=TIMES).map(|n| self.end * (n as f64 / TIMES as f64)).collect()
    }

    fn scene(&self) -> Result<Scene, tumbling_scenes::Error> {
        let outputs = Outputs { spin: true, attitude: true, ..Outputs::NOTHING };
        let body = InitialState::spinning(self.moments, self.omega);
        Scene::new([body], self.torques.clone(), Times::Given(self.times()), outputs, self.accuracy)
    }

    /// Attitude and spin at each of the times, by DOP853, which steps from one to the next and stops where a
    /// torque begins or ends.
    fn reference(&self, tolerance: f64) -> Option<Vec<Found>> {
        let times = self.times();
        let mut stops = times.clone();
        for torque in &self.torques {
            if let Torque::During { start, end, .. } = torque {
                stops.extend([*start, *end]);
            }
        }
        stops.sort_by(f64::total_cmp);
        let l = self.moments.component_mul(&self.omega) / self.size;
        let (mut now, mut state) = (0.0, [1.0, 0.0, 0.0, 0.0, l.x, l.y, l.z]);
        let mut found = Vec::new();
        for stop in stops {
            if stop > now {
                let method =
                    ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(1_000_000);
                let acting = Acting { trial: self, middle: (now + stop) / 2.0 };
                state = *IVP::ode(&acting, now, stop, state).method(method).solve().ok()?.y.last()?;
                now = stop;
            }
            if times.contains(&stop) {
                let [w, x, y, z, l, m, n] = state;
                let spin = (Vector3::new(l, m, n) * self.size).component_div(&self.moments);
                found.push((UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)), spin));
            }
        }
        Some(found)
    }

    /// The largest angle between the attitudes of two runs, or difference of spin relative to the largest so
    /// far: what a scene's accuracy bounds.
    fn apart(&self, a: &[Found], b: &[Found]) -> f64 {
        let mut fastest = self.omega.norm();
        let worse = |worst: f64, (one, other): (&Found, &Found)| {
            fastest = fastest.max(other.1.norm());
            worst.max(one.0.angle_to(&other.0)).max((one.1 - other.1).norm() / fastest)
        };
        a.iter().zip(b).fold(0.0, worse)
    }
}

/// Attitude, and spin in body axes.
type Found = (UnitQuaternion<f64>, Vector3<f64>);

/// The law of a trial between two times without a switch, of which this is the middle.
struct Acting<'a> {
    trial: &'a Trial,
    middle: f64,
}

impl ODE<f64, Packed> for Acting<'_> {
    fn diff(&self, t: f64, y: &Packed, dydt: &mut Packed) {
        let Trial { moments, size, torques, .. } = self.trial;
        let q = Quaternion::new(y[0], y[1], y[2], y[3]);
        let to_body = UnitQuaternion::from_quaternion(q).inverse();
        let l = Vector3::new(y[4], y[5], y[6]) * *size;
        let w = l.component_div(moments);
        let turn = q * Quaternion::from_imag(w) * 0.5;
        let mut rate = l.cross(&w);
        for torque in torques {
            let torque = match torque {
                Torque::During { start, end, torque } if *start < self.middle && self.middle < *end => torque,
                Torque::During { .. } => continue,
                torque => torque,
            };
            rate += match torque {
                Torque::InBody(v) => *v,
                Torque::InWorld(v) => to_body * v,
                Torque::Aligning { arm, field } => arm.cross(&(to_body * field)),
                Torque::Damping(c) => -c.component_mul(&w),
                Torque::Dissipation(k) => l.cross(&l.cross(&w)) * *k,
                Torque::GravityGradient { strength, direction, orbit } => {
                    let n = to_body * (UnitQuaternion::from_scaled_axis(orbit * t) * direction);
                    n.cross(&moments.component_mul(&n)) * *strength
                }
                _ => Vector3::repeat(f64::NAN),
            };
        }
        rate /= *size;
        *dydt = [turn.w, turn.i, turn.j, turn.k, rate.x, rate.y, rate.z];
    }
}

/// What became of a trial.
enum Outcome {
    Refused,
    /// DOP853 at two tolerances is too far apart to judge.
    Uncertain,
    /// The error as a share of the accuracy requested.
    Answered(f64),
}

fn outcome(trial: &Trial) -> Result<Outcome, Wrong> {
    let scene = trial.scene()?;
    let states = scene.plan(0).and_then(|plan| plan.states().collect::<Result<Vec<_>, _>>());
    let Ok(states) = states else { return Ok(Outcome::Refused) };
    let both = |state: &Answer| Some((state.attitude?, state.spin?));
    let found = states.iter().map(both).collect::<Option<Vec<_>>>().ok_or("no state")?;
    let [Some(fine), Some(coarse)] = [1e-14, 1e-13].map(|tolerance| trial.reference(tolerance)) else {
        return Ok(Outcome::Uncertain);
    };
    if trial.apart(&coarse, &fine) > 0.05 * trial.accuracy {
        return Ok(Outcome::Uncertain);
    }
    Ok(Outcome::Answered(trial.apart(&found, &fine) / trial.accuracy))
}

/// As many random scenes: what became of them. With `more` each has another torque, that depends on the time.
pub fn run(count: u64, seed: u64, more: bool) -> Result<String, Wrong> {
    let (mut refused, mut without, mut off) = (0_u64, 0_u64, Vec::new());
    let mut shares = Vec::new();
    for at in 0..count {
        let number = seed.wrapping_add(at).wrapping_mul(0xd134_2543_de82_ef95);
        let trial = Trial::by(&mut Chance(number), more);
        match outcome(&trial)? {
            Outcome::Refused => refused += 1,
            Outcome::Uncertain => without += 1,
            Outcome::Answered(share) => {
                shares.push(share);
                if share > 1.0 {
                    let Trial { moments, omega, torques, end, accuracy, .. } = &trial;
                    off.push(format!(
                        "  number {at}: {share:.2} times {accuracy:.1e} after {end} s, moments {moments:?}, spin {omega:?}, \
                         {torques:?}"
                    ));
                }
            }
        }
    }
    shares.sort_by(f64::total_cmp);
    let of = |part: f64| {
        shares.get((part * shares.len() as f64) as usize).or(shares.last()).copied().unwrap_or(0.0)
    };
    Ok(format!(
        "{count} scenes from seed {seed}: {} right, {} off by more than requested, {refused} refused, {without} that DOP853 leaves \
         uncertain.\nError over request: median {:.1e}, 999 in 1000 below {:.1e}, worst {:.2}.\n{}",
        shares.len() - off.len(),
        off.len(),
        of(0.5),
        of(0.999),
        of(1.0),
        off.join("\n")
    ))
}
