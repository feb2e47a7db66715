//! The order of an integrator: its step as a power series in the step size, against the exact motion's.

use crate::number::{Fraction, Series};
use crate::proof::{Outcome, Residue, breaks, same};
use crate::symbols::{Matrix, diagonal, vector};
use nalgebra::{Matrix3, Quaternion, Vector3};
use num_traits::{One, Zero};
use tumbling::laws::Rate;
use tumbling::number::Field;
use tumbling::step::{Engine, State, rk4};
use tumbling::{attitude, dynamics::euler};

proofs! {
    "step" {
        "order-of-rk4": order_is(4, runge_kutta),
            "One step of the Runge-Kutta method from the attitude 1 agrees with the exact motion of every free body through h⁴, in every component of attitude and momentum, and not through h⁵: its order \
            is 4 and no more.";
            but "said to be 5": order_is(5, runge_kutta),
            but "said to be 3": order_is(3, runge_kutta),
            but "the step a hundredth longer": order_is(4, |start, h, law| runge_kutta(start, &(h.clone() * Series::constant(Fraction::ratio(101, 100))), law)),
            but "a single slope, as in Euler's method": {
                    order_is(4, |start, h, law| {
                        // With the slope frozen, all four stages are the first.
                        let slope = law(start);
                        rk4(start, h.clone(), |_| slope.clone(), State::plus)
                    })
                },
        "the-engine-s-law": same_motion(Engine::Turned),
            "The law that the right engine integrates, with the momentum in the world, gives the same attitude and momentum to h⁴ as that in the body, from the attitude 1, for every free body.";
            but "the frozen tensor": same_motion(Engine::Frozen),
    }
}

type Number = Series<Fraction>;
type RateLaw = fn(&State<Number>) -> Rate<Number>;

fn runge_kutta(start: &State<Number>, h: &Number, law: RateLaw) -> State<Number> {
    rk4(start, h.clone(), law, State::plus)
}

fn constant(x: &Fraction) -> Number {
    Series::constant(x.clone())
}

/// At the start the body's axes are the world's, which loses nothing: the world's are ours to choose.
fn start() -> State<Number> {
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

fn order_is(order: usize, step: impl Fn(&State<Number>, &Number, RateLaw) -> State<Number>) -> Outcome {
    let (start, h) = (start(), Number::step(order + 1));
    let (stepped, truth) = (step(&start, &h, law), exact(&start, order + 1, law));
    for power in 0..=order {
        agree(&stepped, &truth, power)?;
    }
    breaks("the next power does not agree", agree(&stepped, &truth, order + 1))
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
