//! The engines, right and wrong: which laws of motion each obeys, and the residue of each law that it breaks.

use crate::number::{Derivation, Fraction, Relations};
use crate::proof::{Outcome, Residue, same_entries_under, vanishes};
use crate::symbols::{Matrix, Vector, attitude, changing, diagonal, inverse_diagonal, turning, vector};
use crate::tex::Scope;
use nalgebra::Quaternion;
use num_rational::BigRational;
use num_traits::Zero;
use tumbling::attitude::{rate, rotation_matrix};
use tumbling::dynamics::euler::tensor_times_acceleration;
use tumbling::inertia::turned;
use tumbling::step::Engine;

/// A law that the motion of a free body obeys, and that an engine may break.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kept {
    /// The true momentum of the body's mass, `R I R^T w`, is constant.
    Momentum,
    /// Its length is constant.
    LengthOfMomentum,
    /// The true energy of the body, half of `w . R I R^T w`, is constant.
    Energy,
    /// Euler's equations: `I w' = (I w) x w` in the body.
    Euler,
    /// If the engine's state vector is meant as momentum, it is the body's true momentum.
    SpinFromMomentum,
}

impl Kept {
    /// Whether the law applies to an engine: the last law applies only to those that store a momentum.
    #[must_use]
    fn applies_to(self, engine: Engine) -> bool {
        self != Self::SpinFromMomentum || matches!(engine, Engine::Turned | Engine::MomentumForSpin)
    }

    /// All five.
    const ALL: [Self; 5] =
        [Self::Momentum, Self::LengthOfMomentum, Self::Energy, Self::Euler, Self::SpinFromMomentum];
}

proofs! {
    "step" {
        "right-engine": turns(Engine::Turned).and_then(|()| laws(Engine::Turned)),
            r"The law of the right engine keeps the momentum, its length, energy and Euler's equations, $P = M = E = F = 1$, the spin belongs to its momentum, $S = 1$, and the attitude turns at that spin.";
            but "the frozen tensor in its place": laws(Engine::Frozen),
        "frozen-tensor": laws(Engine::Frozen),
            r"With the tensor frozen in the world (pitfall 1), what is left over of momentum, its length, energy and Euler's equations is not zero for all bodies, spins and attitudes: all four laws break, $P = M = E = F = 0$.";
            but "the right engine in its place": laws(Engine::Turned),
        "momentum-for-spin": laws(Engine::MomentumForSpin),
            r"With momentum taken for spin (pitfall 2) energy and the length of momentum stay, $E = M = 1$, but the body's own momentum turns away, is not the one carried, and Euler's equations break, $P = S = F = 0$.";
            but "the frozen tensor in its place": laws(Engine::Frozen),
        "no-gyroscopic-term": laws(Engine::NoGyroscopicTerm),
            r"With constant spin (pitfall 3) energy and the length of momentum stay, $E = M = 1$, which is why it looks right, but momentum itself does not, and Euler's equations break, $P = F = 0$.";
            but "the frozen tensor in its place": laws(Engine::Frozen),
        "wrong-engines-are-right-for-a-ball": ball(&[0, 0, 0]),
            r"For a body with three equal moments the law of every engine, right or wrong, keeps every law that applies to it, $P = M = E = F = 1$ and $S = 1$.";
            but "one moment larger": ball(&[0, 1, 0]),
    }
}

/// A free body as an engine moves it: tensor and attitude, spin, and the rate of change with time.
struct Run {
    unit: Relations,
    rotation: Matrix,
    tensor: Matrix,
    carried: Vector,
    omega: Vector,
    time: Derivation,
}

impl Run {
    fn new(engine: Engine, moments: &Vector) -> Self {
        let (q, unit) = attitude();
        let reduced = |v: Vector| v.map(|x| unit.reduce_fraction(&x));
        let rotation = rotation_matrix(&q);
        let (tensor, inverse) = (diagonal(moments), inverse_diagonal(moments));
        let carried = vector("v");
        let omega = reduced(engine.omega_world(&rotation, &tensor, &inverse, &carried));
        let (q_rate, v_rate) = engine.rate(&tensor, &inverse, &q, &carried);
        let q_rate = Quaternion::from_vector(q_rate.coords.map(|x| unit.reduce_fraction(&x)));
        let time = changing(turning(&q_rate), "v", &v_rate);
        Self { unit, rotation, tensor, carried, omega, time }
    }

    fn reduced(&self, v: &Vector) -> Vector {
        v.map(|x| self.unit.reduce_fraction(&x))
    }

    /// The residue of each law, which is zero where the law holds, at the current attitude.
    fn left_over(&self, law: Kept) -> Vector {
        let body_spin = self.reduced(&(self.rotation.transpose() * &self.omega));
        let body_momentum = &self.tensor * &body_spin;
        let only = |x: Fraction| Vector::new(x, Fraction::zero(), Fraction::zero());
        match law {
            Kept::Momentum => {
                let momentum = self.reduced(&(&self.rotation * &body_momentum));
                momentum.map(|x| self.time.of(&x))
            }
            Kept::LengthOfMomentum => only(self.time.of(&body_momentum.dot(&body_momentum))),
            Kept::Energy => {
                only(self.time.of(&tumbling::dynamics::observe::energy(&body_spin, &body_momentum)))
            }
            Kept::Euler => {
                let acceleration = body_spin.map(|x| self.time.of(&x));
                &self.tensor * acceleration
                    - tensor_times_acceleration(&self.tensor, &body_spin, &Vector::zeros())
            }
            Kept::SpinFromMomentum => turned(&self.rotation, &self.tensor) * &self.omega - &self.carried,
        }
    }
}

/// Checks that the attitude turns at the spin.
fn turns(engine: Engine) -> Outcome {
    let run = Run::new(engine, &vector("I"));
    let (q, spin) = (attitude().0, run.reduced(&(run.rotation.transpose() * &run.omega)));
    let moved = q.coords.map(|x| run.time.of(&x));
    same_entries_under(&run.unit, "the attitude's rate", &moved, &rate(&q, &spin).coords)
}

/// Whether a law holds for every attitude and spin.
///
/// # Errors
/// The residue of a law that does not hold: after a quarter turn about z if it is not zero there, otherwise
/// at any attitude. In it, `v` is the vector that the engine stores, along the world's axes.
fn keeps(run: &Run, law: Kept) -> Outcome {
    // Reduced, it is made of even powers of w, x, y, z; after a quarter turn about z, w and z are both the
    // root of one half.
    let half = Relations::new(vec![("w", BigRational::new(1.into(), 2.into()).into())]).unwrap_or_default();
    let w = Fraction::variable("w");
    let quarter_turn = [("x", Fraction::zero()), ("y", Fraction::zero()), ("z", w)];
    let (claim, left) = (format!("{law:?}"), run.left_over(law));
    for x in &left {
        let there = quarter_turn.iter().fold(x.clone(), |x, (name, w)| x.substitute(&(*name).into(), w));
        vanishes(&claim, &there, &half)?;
    }
    same_entries_under(&run.unit, &claim, &left, &Vector::zeros())
}

/// For each law that applies to the engine, 1 where it holds and 0 where there is a residue.
fn laws_with(engine: Engine, moments: &Vector) -> Result<Scope, Residue> {
    let run = Run::new(engine, moments);
    let named = Kept::ALL.into_iter().zip(["P", "M", "E", "F", "S"]);
    named.filter(|(law, _)| law.applies_to(engine)).try_fold(Scope::default(), |scope, (law, name)| {
        match keeps(&run, law) {
            Ok(()) => Ok(scope.with(name, Fraction::from(1))),
            Err(Residue::NotZero { .. }) => Ok(scope.with(name, Fraction::zero())),
            Err(residue) => Err(residue),
        }
    })
}

/// For every body.
fn laws(engine: Engine) -> Result<Scope, Residue> {
    laws_with(engine, &vector("I"))
}

/// Of every engine, if the moments are one and the same, but for what is added to each.
fn ball(added: &[i64; 3]) -> Result<Vec<Scope>, Residue> {
    let moment = Fraction::variable("I");
    let moments = Vector::from_fn(|i, _| &moment + Fraction::from(added[i]));
    Engine::ALL.into_iter().map(|engine| laws_with(engine, &moments)).collect()
}
