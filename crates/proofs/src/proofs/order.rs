//! The exact motion as a power series in the time, by the laws in body and in world.

use crate::number::{Fraction, Series};
use crate::proof::{Outcome, Residue, same};
use crate::symbols::{Matrix, diagonal, vector};
use nalgebra::{Matrix3, Quaternion, Vector3};
use num_traits::{One, Zero};
use tumbling::laws::Rate;
use tumbling::number::Field;
use tumbling::step::{Engine, State};
use tumbling::{attitude, dynamics::euler};

proofs! {
    "step" {
        "the-engine-s-law": same_motion(Engine::Turned),
            "The law that the right engine integrates, with the momentum in the world, gives the same attitude and momentum to h⁴ as that in the body, from the attitude 1, for every free body.";
            but "the frozen tensor": same_motion(Engine::Frozen),
    }
}

pub(super) type Number = Series<Fraction>;
pub(super) fn constant(x: &Fraction) -> Number {
    Series::constant(x.clone())
}

/// At the start the body's axes are the world's, which loses nothing: the world's are ours to choose.
pub(super) fn start() -> State<Number> {
    let [one, zero] = [Number::one(), Number::zero()];
    let attitude = Quaternion::new(one, zero.clone(), zero.clone(), zero);
    State { attitude, momentum: vector("L").map(|x| constant(&x)) }
}

fn inverse() -> Matrix3<Number> {
    let inverse: Matrix = diagonal(&vector("J"));
    inverse.map(|x| constant(&x))
}

/// The free body, its momentum in its own axes.
fn law(m: &State<Number>) -> Rate<Number> {
    let omega = inverse() * &m.momentum;
    Rate {
        attitude: attitude::rate(&m.attitude, &omega),
        momentum: euler::momentum_rate(&inverse(), &m.momentum, &Vector3::zeros()),
    }
}

type Pair<T> = (Quaternion<Series<T>>, Vector3<Series<T>>);

/// An attitude and a vector as they move under a law, to the power `order`: each round of `y = y0 + ∫ law(y)`
/// settles one more.
fn solved<T: Field>(start: &Pair<T>, order: usize, law: impl Fn(Pair<T>) -> Pair<T>) -> Pair<T> {
    let (attitude, vector) = (&start.0.coords, &start.1);
    let mut motion = (Quaternion::from_vector(attitude.map(|x| x.cut(0))), vector.map(|x| x.cut(0)));
    for _ in 0..order {
        let (turn, change) = law(motion);
        motion = (
            Quaternion::from_vector(attitude.zip_map(&turn.coords, |y, f| y + f.integral())),
            vector.zip_map(&change, |y, f| y + f.integral()),
        );
    }
    motion
}

/// The exact motion of a state under a law, to the power `order`.
pub(super) fn exact<T: Field>(
    start: &State<Series<T>>,
    order: usize,
    law: impl Fn(&State<Series<T>>) -> Rate<Series<T>>,
) -> State<Series<T>> {
    let start = (start.attitude.clone(), start.momentum.clone());
    let (attitude, momentum) = solved(&start, order, |(attitude, momentum)| {
        let rate = law(&State { attitude, momentum });
        (rate.attitude, rate.momentum)
    });
    State { attitude, momentum }
}

/// Attitude and momentum.
pub(super) fn components<T: Field>(m: &State<Series<T>>) -> Vec<Series<T>> {
    m.attitude.coords.iter().chain(&m.momentum).cloned().collect()
}

/// That two motions agree in every component at the given power of the step.
fn agree(a: &State<Number>, b: &State<Number>, power: usize) -> Outcome {
    for (x, y) in components(a).iter().zip(components(b)) {
        let claim = format!("the power {power} of the step");
        match x.coefficient(power).zip(y.coefficient(power)) {
            Some((x, y)) => same(&claim, &x, &y)?,
            None => return Err(Residue::Missing { claim }),
        }
    }
    Ok(())
}

fn same_motion(engine: Engine) -> Outcome {
    const ORDER: usize = 4;
    let tensor = Matrix3::from_diagonal(&vector("J").map(|x| constant(&(Fraction::one() / x))));
    let in_world = |(attitude, vector)| engine.rate(&tensor, &inverse(), &attitude, &vector);
    let start = start();
    let body = exact(&start, ORDER, law);
    let mut carried = start.momentum;
    if engine.rate(&tensor, &inverse(), &start.attitude, &carried).1 != Vector3::zeros() {
        // What changes with time is the spin.
        carried = inverse() * carried;
    }
    let (attitude, carried) = solved(&(start.attitude, carried), ORDER, in_world);
    // The momentum that the body has, in its own axes.
    let rotation = attitude::rotation_matrix(&attitude);
    let omega = engine.omega_world(&rotation, &tensor, &inverse(), &carried);
    let world = State { attitude, momentum: &tensor * (rotation.transpose() * omega) };
    (0..=ORDER).try_for_each(|power| agree(&world, &body, power))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    #[test]
    fn the_exact_motion_of_a_steady_spin_is_sine_and_cosine() {
        let [one, zero] = [Series::<Rational>::one(), Series::zero()];
        let start = State {
            attitude: Quaternion::new(one, zero.clone(), zero.clone(), zero.clone()),
            momentum: Vector3::new(zero.clone(), zero, Series::constant(Rational::from(2))),
        };
        let law = |m: &State<Series<Rational>>| Rate {
            attitude: attitude::rate(&m.attitude, &m.momentum),
            momentum: Vector3::zeros(),
        };
        let end = exact(&start, 5, law);
        assert_eq!(end.attitude.coords.w.to_string(), "1 - 1/2 h^2 + 1/24 h^4 + ...");
        assert_eq!(end.attitude.coords.z.to_string(), "h - 1/6 h^3 + 1/120 h^5 + ...");
    }
}
