//! Random scenes under torques, planned by the library and held against DOP853 of `differential-equations`:
//! how many answers are off by more than requested, and by how much.

use crate::law::Packed;
use differential_equations::prelude::*;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::step::Torque;
use tumbling_measure::story::Wrong;
use tumbling_scenes::{InitialState, Outputs, Scene, Times};

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

impl Trial {
    /// A box of any sides, spun about any axis, under one torque or two of any strength.
    fn by(chance: &mut Chance) -> Self {
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
        Self { moments, omega, torques, end, accuracy, size: momentum.norm() }
    }

    fn scene(&self) -> Result<Scene, tumbling_scenes::Error> {
        let outputs = Outputs { spin: true, attitude: true, ..Outputs::NOTHING };
        let times = Times::every(self.end / 8.0, self.end);
        let body = InitialState::spinning(self.moments, self.omega);
        Scene::new([body], self.torques.clone(), times, outputs, self.accuracy)
    }

    /// Attitude and spin at the end, by DOP853.
    fn reference(&self, tolerance: f64) -> Option<(UnitQuaternion<f64>, Vector3<f64>)> {
        let l = self.moments.component_mul(&self.omega) / self.size;
        let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(1_000_000);
        let start = [1.0, 0.0, 0.0, 0.0, l.x, l.y, l.z];
        let solution = IVP::ode(self, 0.0, self.end, start).method(method).solve().ok()?;
        let [w, x, y, z, l, m, n] = *solution.y.last()?;
        let spin = (Vector3::new(l, m, n) * self.size).component_div(&self.moments);
        Some((UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)), spin))
    }
}

impl ODE<f64, Packed> for Trial {
    fn diff(&self, _t: f64, y: &Packed, dydt: &mut Packed) {
        let q = Quaternion::new(y[0], y[1], y[2], y[3]);
        let to_body = UnitQuaternion::from_quaternion(q).inverse();
        let l = Vector3::new(y[4], y[5], y[6]) * self.size;
        let w = l.component_div(&self.moments);
        let turn = q * Quaternion::from_imag(w) * 0.5;
        let mut rate = l.cross(&w);
        for torque in &self.torques {
            rate += match torque {
                Torque::InBody(v) => *v,
                Torque::InWorld(v) => to_body * v,
                Torque::Aligning { arm, field } => arm.cross(&(to_body * field)),
                Torque::Damping(c) => -c.component_mul(&w),
                Torque::Dissipation(k) => l.cross(&l.cross(&w)) * *k,
                _ => Vector3::repeat(f64::NAN),
            };
        }
        rate /= self.size;
        *dydt = [turn.w, turn.i, turn.j, turn.k, rate.x, rate.y, rate.z];
    }
}

/// The larger of the angle between two attitudes and the difference of two spins as a share.
fn apart(a: &(UnitQuaternion<f64>, Vector3<f64>), b: &(UnitQuaternion<f64>, Vector3<f64>)) -> f64 {
    a.0.angle_to(&b.0).max((a.1 - b.1).norm() / b.1.norm())
}

/// As many random scenes: what became of them.
pub fn run(count: u64, seed: u64) -> Result<String, Wrong> {
    let (mut right, mut refused, mut without, mut off) = (0_u64, 0_u64, 0_u64, Vec::new());
    let mut shares = Vec::new();
    for at in 0..count {
        let trial = Trial::by(&mut Chance(seed.wrapping_add(at).wrapping_mul(0xd134_2543_de82_ef95)));
        let scene = trial.scene()?;
        let Some(last) = scene.plan(0).ok().and_then(|plan| plan.states().last()?.ok()) else {
            refused += 1;
            continue;
        };
        let (Some(attitude), Some(spin)) = (last.attitude, last.spin) else { return Err("no state".into()) };
        let references = [1e-14, 1e-13].map(|tolerance| trial.reference(tolerance));
        let [Some(fine), Some(coarse)] = references else {
            without += 1;
            continue;
        };
        if apart(&fine, &coarse) > 0.05 * trial.accuracy {
            without += 1;
            continue;
        }
        let share = apart(&(attitude, spin), &fine) / trial.accuracy;
        shares.push(share);
        if share <= 1.0 {
            right += 1;
        } else {
            let Trial { moments, omega, torques, end, accuracy, .. } = &trial;
            off.push(format!(
                "  number {at}: {share:.2} times {accuracy:.1e} after {end} s, moments {moments:?}, spin {omega:?}, {torques:?}"
            ));
        }
    }
    shares.sort_by(f64::total_cmp);
    let of = |part: f64| {
        shares.get((part * shares.len() as f64) as usize).or(shares.last()).copied().unwrap_or(0.0)
    };
    Ok(format!(
        "{count} scenes from seed {seed}: {right} right, {} off by more than requested, {refused} refused, {without} that DOP853 leaves \
         uncertain.\nError over request: median {:.1e}, 99 in 100 below {:.1e}, worst {:.2}.\n{}",
        off.len(),
        of(0.5),
        of(0.99),
        of(1.0),
        off.join("\n")
    ))
}
