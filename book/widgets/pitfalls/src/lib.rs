//! Wrong and right: the engines of the three pitfalls and the right one, stepped from one start. The exact
//! motion shown with them comes from another module, the tumble's.
//!
//! The page keeps each engine's state between two questions, and does not use it itself.

use exchange::Numbers;
use nalgebra::{Matrix3, Quaternion, Vector3};
use tumbling::attitude::rotation_matrix;
use tumbling::dynamics::observe::{energy, sign_changes};
use tumbling::step::{Engine, rk4};

/// The attitude, and the vector that is the engine's state.
type Motion = (Quaternion<f64>, Vector3<f64>);

/// The most steps in one answer.
const MOST: usize = 1000;

/// What comes before the samples in an answer on an engine.
const HEAD: usize = 24;

/// Where a question has the step, and where the state.
const STEP: usize = 7;
const STATE: usize = 10;

/// Both questions begin with a body's moments about x, y and z, kg m², and the spin along them, rad/s.
///
/// Question 0, the start of an engine: which of [`Engine::ALL`]. Question 1, its continuation: which engine,
/// the step in seconds, the number of steps taken before, the number of steps to take now, and the state from
/// the last answer.
///
/// Both are answered by: how many steps were taken, fewer than asked where the motion leaves what an
/// `f64` holds; the state, nine numbers; the energy and the length of the momentum, relative to the
/// first, and the momentum's angle from where it was, degrees, as a measurement on the body would find
/// them; the least and the greatest energy of these steps; how many flips there were, and the time of the
/// first; how far the spin's direction is from that at the start, degrees; spin and momentum in the
/// world, as a measurement would find them; and for each step (at the start: for it) the spin about x.
pub fn answer(what: u32, row: &Numbers) -> usize {
    let (moments, omega) = (Vector3::from(row.take::<3>(0)), Vector3::from(row.take::<3>(3)));
    let engine = Engine::ALL.get(row.get(6) as usize).copied().unwrap_or(Engine::Turned);
    let here = Run::new(engine, &moments, &omega);
    if what == 0 { here.start(row) } else { here.go_on(row) }
}

/// One engine with one body from one start.
struct Run {
    engine: Engine,
    tensor: Matrix3<f64>,
    inverse: Matrix3<f64>,
    omega: Vector3<f64>,
    momentum: Vector3<f64>,
}

impl Run {
    fn new(engine: Engine, moments: &Vector3<f64>, omega: &Vector3<f64>) -> Self {
        Self {
            engine,
            tensor: Matrix3::from_diagonal(moments),
            inverse: Matrix3::from_diagonal(&moments.map(f64::recip)),
            omega: *omega,
            momentum: moments.component_mul(omega),
        }
    }

    /// The start, with the body's axes along the world's: the engine carries the spin, or the momentum.
    fn start(&self, row: &Numbers) -> usize {
        let vector = match self.engine {
            Engine::Frozen | Engine::NoGyroscopicTerm => self.omega,
            _ => self.momentum,
        };
        for (place, number) in [1.0, 0.0, 0.0, 0.0, vector.x, vector.y, vector.z].into_iter().enumerate() {
            row.set(STATE + place, number);
        }
        // No step is taken, so that neither its length nor what came before it matters.
        for place in STEP..STATE {
            row.set(place, 0.0);
        }
        let x = self.measured(&self.motion(row)).spin;
        row.set(STATE + 7, x);
        row.set(STATE + 8, sign(x, 0.0));
        let count = self.go_on(row);
        row.set(count, x);
        count + 1
    }

    /// The state as the page returns it: the attitude, real part first, and the engine's vector.
    fn motion(&self, row: &Numbers) -> Motion {
        let [w, i, j, k, x, y, z] = row.take(STATE);
        (Quaternion::new(w, i, j, k), Vector3::new(x, y, z))
    }

    fn go_on(&self, row: &Numbers) -> usize {
        let [step, before, count] = row.take(STEP);
        let mut motion = self.motion(row);
        let [last, mut side] = row.take(STATE + 7);
        let mut taken = 0;
        let mut found = self.measured(&motion);
        let [mut low, mut high] = [found.energy; 2];
        while taken < (count as usize).min(MOST) {
            let law = |(q, v): &Motion| self.engine.rate(&self.tensor, &self.inverse, q, v);
            let plus = |(q, v): &Motion, rate: &Motion, h: f64| (q + rate.0 * h, v + rate.1 * h);
            let mut next = rk4(&motion, step, law, plus);
            let length = next.0.norm();
            next.0 /= length;
            let now = self.measured(&next);
            if !(length > 0.0 && now.held()) {
                break;
            }
            (motion, found) = (next, now);
            side = sign(found.spin, side);
            row.set(HEAD + taken, found.spin);
            taken += 1;
            low = low.min(found.energy);
            high = high.max(found.energy);
        }
        // The side of the spin before these steps applies to all samples before the last.
        let earlier = [(step * (before - 1.0), row.get(STATE + 8)), (step * before, last)];
        let samples = (0..taken).map(|i| (step * (before + (i + 1) as f64), row.get(HEAD + i)));
        let flips = sign_changes(earlier.into_iter().chain(samples));
        let (q, v) = &motion;
        let last = if taken == 0 { last } else { row.get(HEAD + taken - 1) };
        let first = flips.first().copied().unwrap_or(0.0);
        let at = row.fill(&[taken as f64, q.w, q.i, q.j, q.k, v.x, v.y, v.z, last, side]);
        let at = row.fill_from(at, &[found.energy, found.length, found.angle, low, high]);
        let at = row.fill_from(at, &[flips.len() as f64, first, found.off]);
        row.fill_from(row.fill_from(at, found.omega.as_slice()), found.momentum.as_slice());
        HEAD + taken
    }

    /// What a measurement on the body would show, whatever the engine stores.
    fn measured(&self, (attitude, carried): &Motion) -> Measured {
        let rotation = rotation_matrix(attitude);
        let omega = self.engine.omega_world(&rotation, &self.tensor, &self.inverse, carried);
        let momentum = tumbling::inertia::turned(&rotation, &self.tensor) * omega;
        Measured {
            spin: (rotation.transpose() * omega).x,
            energy: energy(&omega, &momentum) / energy(&self.omega, &self.momentum),
            length: momentum.norm() / self.momentum.norm(),
            angle: between(&momentum, &self.momentum),
            off: between(&omega, &self.omega),
            omega,
            momentum,
        }
    }
}

/// The angle between two vectors, degrees, good to rounding where it is small.
fn between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    a.cross(b).norm().atan2(a.dot(b)).to_degrees()
}

struct Measured {
    spin: f64,
    energy: f64,
    length: f64,
    angle: f64,
    off: f64,
    omega: Vector3<f64>,
    momentum: Vector3<f64>,
}

impl Measured {
    fn held(&self) -> bool {
        [self.spin, self.energy, self.length, self.angle, self.off].iter().all(|x| x.is_finite())
    }
}

/// The side of the spin; for zero, the side before.
fn sign(spin: f64, before: f64) -> f64 {
    if spin == 0.0 { before } else { spin.signum() }
}

exchange::page!(answer);

#[cfg(test)]
mod tests {
    use super::*;

    use nalgebra::UnitQuaternion;
    use tumbling::{Body, body::named};

    /// Numbers in a state.
    const SIZE: usize = 9;

    /// Moments of a body, kg m²: the box, the phone, a ball.
    fn moments(which: usize) -> [f64; 3] {
        [[10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0], [3.1e-4, 3.8e-4, 7.4e-5], [0.1; 3]][which]
    }

    /// An engine as the page has it: started, then stepped in pieces. The last answer's head, all spins, and
    /// the flips that came first in their pieces.
    fn paged(
        which: usize,
        omega: [f64; 3],
        step: f64,
        [count, piece]: [usize; 2],
        body: usize,
    ) -> ([f64; HEAD], Vec<f64>, Vec<f64>) {
        let row = Numbers::empty();
        let begun = [&moments(body)[..], &omega, &[which as f64]].concat();
        row.fill(&begun);
        let places = answer(0, &row);
        let mut spins = vec![row.get(places - 1)];
        let mut flips = Vec::new();
        while spins.len() <= count {
            let state: [f64; SIZE] = row.take(1);
            let go_on = [step, (spins.len() - 1) as f64, piece as f64];
            row.fill(&[&begun[..], &go_on, &state].concat());
            let places = answer(1, &row);
            spins.extend((HEAD..places).map(|place| row.get(place)));
            (0..row.get(15) as usize).for_each(|_| flips.push(row.get(16)));
        }
        (row.take(0), spins, flips)
    }

    #[test]
    fn stepped_in_pieces_an_engine_does_what_the_librarys_run_does() {
        let inertia = named::NamedBody::TheBox.properties().unwrap().inertia();
        let mut broken = 0;
        for (which, engine) in Engine::ALL.into_iter().enumerate() {
            for (omega, step, count) in
                [([10.0, 0.1, 0.1], 0.001, 4000), ([1.0, 1.0, 1.0], 0.01, 700), ([2.0, 0.3, -1.1], 0.02, 300)]
            {
                let vector = Vector3::from(omega);
                let start = Body::spinning(inertia, UnitQuaternion::identity(), &vector).unwrap();
                let run = engine.run(&start, step, count).unwrap();
                let (head, spins, flips) = paged(which, omega, step, [count, 100], 0);
                let same = |what: &str, ours: f64, theirs: f64| {
                    let off = (ours - theirs).abs() / theirs.abs().max(1.0);
                    assert!(off < 1e-9, "{engine:?} {omega:?}, {what}: {ours}, the library {theirs}");
                };
                run.iter().zip(&spins).for_each(|(body, spin)| same("spin x", *spin, body.omega_body().x));
                let times = (0..).map(|i| step * f64::from(i));
                let whole = sign_changes(times.zip(run.iter().map(|body| body.omega_body().x)));
                assert_eq!(flips.len(), whole.len(), "{engine:?} {omega:?}");
                flips.iter().zip(&whole).for_each(|(ours, theirs)| same("a flip", *ours, *theirs));

                let [energy, length, angle, low, high] = std::array::from_fn(|i| head[10 + i]);
                let energies: Vec<f64> = run.iter().map(|body| body.energy() / start.energy()).collect();
                let [now, spin] = [run[count].momentum_world(), run[count].omega_world()];
                same("energy", energy, energies[count]);
                let piece = &energies[count - 100..];
                same("least energy", low, piece.iter().copied().fold(f64::MAX, f64::min));
                same("greatest energy", high, piece.iter().copied().fold(f64::MIN, f64::max));
                same("length", length, now.norm() / start.momentum_world().norm());
                let apart =
                    |a: Vector3<f64>, b: Vector3<f64>| a.cross(&b).norm().atan2(a.dot(&b)).to_degrees();
                same("angle", angle, apart(now, start.momentum_world()));
                same("spin", head[17], apart(spin, start.omega_world()));
                assert!(engine != Engine::Turned || head[12] < 1e-12, "its momentum stays: {}", head[12]);
                broken += usize::from((length - 1.0).abs() > 0.01 && high > 1.01);
            }
        }
        assert!(broken >= 3, "wrong engines break both laws, or nothing is distinguished here: {broken}");
    }

    #[test]
    fn a_run_in_pieces_is_a_run_in_one() {
        for (which, body) in [(0, 0), (1, 1), (2, 2), (3, 1)] {
            let one = paged(which, [10.0, 0.1, 0.1], 0.005, [1000; 2], body);
            for piece in [1, 8, 100] {
                let pieces = paged(which, [10.0, 0.1, 0.1], 0.005, [1000, piece], body);
                assert_eq!(one.1, pieces.1);
                assert_eq!(one.2.len(), pieces.2.len());
                assert_eq!(one.2.first(), pieces.2.first());
                assert_eq!(one.0[1..13], pieces.0[1..13]);
            }
        }
    }
}
