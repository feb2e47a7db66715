//! Wrong and right: the engines of the three pitfalls and the right one, stepped from one start. The exact
//! motion beside them is another module's, the tumble's.
//!
//! The page keeps each engine's state between two questions, and never looks into it.

use exchange::Numbers;
use nalgebra::{Matrix3, Vector3};
use tumbling::attitude::rotation_matrix;
use tumbling::body::named::{self, Even};
use tumbling::dynamics::observe::energy;
use tumbling::solid::{Ball, Cuboid, Shape};
use tumbling::step::{Carried, Engine, rk4};

/// The most steps in one answer.
const MOST: usize = 1000;

/// What comes before the samples in an answer on an engine.
const HEAD: usize = 18;

fn cuboid(body: &Even<3>) -> Vector3<f64> {
    Cuboid::moments(&body.mass, body.sizes.each_ref())
}

/// The moments of a body, kg m². The bodies are those of the book; of each but the ball the middle axis is x.
fn body(which: f64) -> Vector3<f64> {
    match which as u32 {
        0 => cuboid(&named::THE_BOX),
        1 => cuboid(&named::BOOK),
        2 => cuboid(&named::PHONE),
        _ => Ball::moments(&named::BALL.mass, named::BALL.sizes.each_ref()),
    }
}

/// All questions begin with the body (the box, the book, the phone, a ball) and the spin along its axes,
/// rad/s.
///
/// 0, how an engine starts: which of [`Engine::ALL`]. 1, how it goes on: which, the step in seconds, how many
/// steps were taken before, how many to take now, and the state as it was answered last.
///
/// Both are answered by: how many steps were taken, fewer than asked where the motion leaves what an `f64`
/// holds; the state, nine numbers; the energy and the length of the momentum, relative to the first, and the
/// momentum's angle from where it was, degrees, as a measurement on the body would find them; the least and
/// the greatest energy of these steps; how many flips there were, and the time of the first; how far the
/// spin's direction is from that at the start, degrees; and for each step (at the start: for it) the spin
/// about x.
///
/// 2, the body's moments, kg m².
pub fn answer(what: u32, row: &Numbers) -> usize {
    let [which, x, y, z] = row.take(0);
    let (moments, omega) = (body(which), Vector3::new(x, y, z));
    if what == 2 {
        return row.fill(&[moments.x, moments.y, moments.z]);
    }
    let engine = Engine::ALL.get(row.get(4) as usize).copied().unwrap_or(Engine::Turned);
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
            row.set(8 + place, number);
        }
        // No step is taken, so that neither its length nor what came before it matters.
        for place in 5..8 {
            row.set(place, 0.0);
        }
        let x = self.measured(&self.motion(row)).spin;
        row.set(15, x);
        row.set(16, sign(x, 0.0));
        let count = self.go_on(row);
        row.set(count, x);
        count + 1
    }

    /// What the page brings back: eight numbers into the row the attitude, real part first, and the carried
    /// vector.
    fn motion(&self, row: &Numbers) -> Carried<f64> {
        let [w, i, j, k, x, y, z] = row.take(8);
        Carried { attitude: nalgebra::Quaternion::new(w, i, j, k), vector: Vector3::new(x, y, z) }
    }

    fn go_on(&self, row: &Numbers) -> usize {
        let [step, before, count] = row.take(5);
        let mut motion = self.motion(row);
        let [mut last, mut side] = row.take(15);
        let (mut taken, mut flips, mut first) = (0, 0.0, 0.0);
        let mut found = self.measured(&motion);
        let [mut low, mut high] = [found.energy; 2];
        while taken < (count as usize).min(MOST) {
            let mut next =
                rk4(&motion, step, |m| self.engine.rate(&self.tensor, &self.inverse, m), Carried::plus);
            let length = next.attitude.norm();
            next.attitude /= length;
            let now = self.measured(&next);
            if !(length > 0.0 && now.held()) {
                break;
            }
            (motion, found) = (next, now);
            // A flip is a change of sign, its time by a straight line: as
            // `tumbling::dynamics::observe::sign_changes`, which wants memory that this module else has no
            // need of. `tests` below hold it to that.
            if sign(found.spin, side) * side < 0.0 {
                if flips == 0.0 {
                    let share = if last == 0.0 { 0.0 } else { 1.0 / (1.0 + (found.spin / last).abs()) };
                    first = step * (before + taken as f64 + share);
                }
                flips += 1.0;
            }
            (last, side) = (found.spin, sign(found.spin, side));
            row.set(HEAD + taken, found.spin);
            taken += 1;
            low = low.min(found.energy);
            high = high.max(found.energy);
        }
        let (q, v) = (&motion.attitude, &motion.vector);
        row.fill(&[
            taken as f64,
            q.w,
            q.i,
            q.j,
            q.k,
            v.x,
            v.y,
            v.z,
            last,
            side,
            found.energy,
            found.length,
            found.angle,
            low,
            high,
            flips,
            first,
            found.off,
        ]);
        HEAD + taken
    }

    /// What a measurement on the body would find, whatever the engine believes.
    fn measured(&self, motion: &Carried<f64>) -> Measured {
        let rotation = rotation_matrix(&motion.attitude);
        let omega = self.engine.omega_world(&rotation, &self.tensor, &self.inverse, &motion.vector);
        let momentum = tumbling::inertia::turned(&rotation, &self.tensor) * omega;
        Measured {
            spin: (rotation.transpose() * omega).x,
            energy: energy(&omega, &momentum) / energy(&self.omega, &self.momentum),
            length: momentum.norm() / self.momentum.norm(),
            angle: between(&momentum, &self.momentum),
            off: between(&omega, &self.omega),
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
}

impl Measured {
    fn held(&self) -> bool {
        [self.spin, self.energy, self.length, self.angle, self.off].iter().all(|x| x.is_finite())
    }
}

/// The side that a spin is on: of zero it is the one before.
fn sign(spin: f64, before: f64) -> f64 {
    if spin == 0.0 { before } else { spin.signum() }
}

exchange::page!(answer);

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers in a state.
    use nalgebra::UnitQuaternion;
    use tumbling::dynamics::observe::sign_changes;
    use tumbling::{Body, Inertia, body::named};

    /// Numbers in a state.
    const STATE: usize = 9;

    /// An engine as the page has it: started, then stepped in pieces. The last answer's head, all spins, and
    /// the flips that came first in their pieces.
    fn paged(
        which: usize,
        omega: [f64; 3],
        step: f64,
        count: usize,
        piece: usize,
    ) -> ([f64; HEAD], Vec<f64>, Vec<f64>) {
        let row = Numbers::new();
        row.fill(&[0.0, omega[0], omega[1], omega[2], which as f64]);
        let places = answer(0, &row);
        let mut spins = vec![row.get(places - 1)];
        let mut flips = Vec::new();
        while spins.len() <= count {
            let state: [f64; STATE] = row.take(1);
            let asked = [
                0.0,
                omega[0],
                omega[1],
                omega[2],
                which as f64,
                step,
                (spins.len() - 1) as f64,
                piece as f64,
            ];
            row.fill(&asked);
            state.iter().enumerate().for_each(|(i, x)| row.set(8 + i, *x));
            let places = answer(1, &row);
            spins.extend((HEAD..places).map(|place| row.get(place)));
            (0..row.get(15) as usize).for_each(|_| flips.push(row.get(16)));
        }
        (row.take(0), spins, flips)
    }

    #[test]
    fn stepped_in_pieces_an_engine_goes_where_the_library_says() {
        let inertia = named::NamedBody::TheBox.properties().unwrap().inertia();
        for (which, engine) in Engine::ALL.into_iter().enumerate() {
            for (omega, step) in [([10.0, 0.1, 0.1], 0.001), ([1.0, 1.0, 1.0], 0.01)] {
                let vector = Vector3::from(omega);
                let start = Body::spinning(inertia, UnitQuaternion::identity(), &vector).unwrap();
                let run = engine.run(&start, step, 4000).unwrap();
                let (head, spins, flips) = paged(which, omega, step, 4000, 250);
                for (i, (body, spin)) in run.iter().zip(&spins).enumerate() {
                    let off = (body.omega_body().x - spin).abs();
                    assert!(off < 1e-9 * vector.norm(), "{engine:?} {omega:?} step {i}: {off}");
                }
                if engine == Engine::Turned {
                    assert!(head[12] < 1e-12, "the right engine's momentum stays: {}", head[12]);
                }
                assert!((head[10] - run[4000].energy() / start.energy()).abs() < 1e-9, "{engine:?}");
                let times = (0..).map(|i| step * f64::from(i));
                let whole = sign_changes(times.zip(run.iter().map(|body| body.omega_body().x)));
                assert_eq!(flips.len(), whole.len(), "{engine:?} {omega:?}");
                for (ours, theirs) in flips.iter().zip(&whole) {
                    assert!((ours - theirs).abs() < 1e-9, "{engine:?} {omega:?}: {ours} {theirs}");
                }
            }
        }
    }

    #[test]
    fn energy_and_momentum_are_told_as_the_librarys_run_has_them() {
        let inertia = named::NamedBody::TheBox.properties().unwrap().inertia();
        let mut broken = 0;
        for (which, engine) in Engine::ALL.into_iter().enumerate() {
            for (omega, step, count) in [([1.0, 1.0, 1.0], 0.01, 700), ([2.0, 0.3, -1.1], 0.02, 300)] {
                let start =
                    Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::from(omega)).unwrap();
                let run = engine.run(&start, step, count).unwrap();
                let (head, ..) = paged(which, omega, step, count, count);
                let [energy, length, angle, low, high] = std::array::from_fn(|i| head[10 + i]);
                let off = head[17];

                let energies: Vec<f64> = run.iter().map(|body| body.energy() / run[0].energy()).collect();
                let least = energies.iter().copied().fold(f64::MAX, f64::min);
                let greatest = energies.iter().copied().fold(f64::MIN, f64::max);
                let [first, last] = [&run[0], &run[count]];
                let (now, spins) = (last.momentum_world(), last.omega_world());
                // What the engine makes of its start differs from the start: pitfall two's spin is another
                // from the first.
                let scale = first.energy() / start.energy();
                let same = |what: &str, ours: f64, theirs: f64| {
                    assert!(
                        (ours - theirs).abs() < 1e-9 * theirs.abs().max(1.0),
                        "{engine:?} {omega:?}, {what}: {ours}, the library {theirs}"
                    );
                };
                same("energy", energy, scale * energies[count]);
                same("least energy", low, scale * least);
                same("greatest energy", high, scale * greatest);
                same("length", length, now.norm() / start.momentum_world().norm());
                same("angle", angle, now.angle(&start.momentum_world()).to_degrees());
                same("spin", off, spins.angle(&start.omega_world()).to_degrees());
                broken += usize::from((length - 1.0).abs() > 0.01 && high > 1.01);
            }
        }
        assert!(broken >= 3, "wrong engines break both laws, or nothing is told apart here: {broken}");
    }

    #[test]
    fn a_run_in_pieces_is_a_run_in_one() {
        for which in 0..4 {
            let one = paged(which, [10.0, 0.1, 0.1], 0.005, 1000, 1000);
            for piece in [1, 8, 100] {
                let pieces = paged(which, [10.0, 0.1, 0.1], 0.005, 1000, piece);
                assert_eq!(one.1, pieces.1);
                assert_eq!(one.2.len(), pieces.2.len());
                assert_eq!(one.2.first(), pieces.2.first());
                assert_eq!(one.0[1..13], pieces.0[1..13]);
            }
        }
    }

    #[test]
    fn x_is_the_middle_axis_of_the_books_bodies() {
        let same = |which: f64, inertia: Inertia| {
            let [ours, theirs] = [body(which), inertia.matrix().diagonal()];
            assert!((ours - theirs).amax() <= 4.0 * f64::EPSILON * theirs.amax(), "{which}: {ours} {theirs}");
            assert!(ours.z < ours.x && ours.x < ours.y);
        };
        same(0.0, named::NamedBody::TheBox.properties().unwrap().inertia());
        same(1.0, named::NamedBody::Book.properties().unwrap().inertia());
        same(2.0, named::NamedBody::Phone.properties().unwrap().inertia());
    }
}
