//! The order of an integrator: its step as a power series in the step size, against the exact motion's.

use crate::number::{Fraction, Series};
use crate::proof::{Mutant, Outcome, Proof, Residue, breaks, same};
use crate::symbols::{Matrix, diagonal, vector};
use nalgebra::{Matrix3, Quaternion, Vector3};
use num_traits::{One, Zero};
use tumbling::scalar::Field;
use tumbling::step::{Engine, Motion, rk4};
use tumbling::{attitude, euler};

pub(super) const PROOFS: &[Proof] = &[
    Proof {
        name: "order-of-rk4",
        part: "step",
        statement: "One step of the Runge-Kutta method agrees with the exact motion of every free body through h⁴, in every component \
                    of attitude and momentum, and not through h⁵: its order is 4 and no more.",
        check: || order_is(4, rk4),
        mutants: &[
            Mutant { change: "said to be 5", check: || order_is(5, rk4) },
            Mutant { change: "said to be 3", check: || order_is(3, rk4) },
            Mutant {
                change: "the step a hundredth longer",
                check: || {
                    order_is(4, |start, h, law| {
                        rk4(start, &(h.clone() * Series::constant(Fraction::ratio(101, 100))), law)
                    })
                },
            },
            Mutant {
                change: "a single slope, as in Euler's method",
                check: || {
                    order_is(4, |start, h, law| {
                        // With the slope frozen, all four stages are the first.
                        let slope = law(start);
                        rk4(start, h, |_| slope.clone())
                    })
                },
            },
        ],
    },
    Proof {
        name: "the-engine-s-law",
        part: "step",
        statement: "The law that the right engine integrates, with the momentum in the world, is the one in the body: the same attitude \
                    to h⁴ for every body, the momentum being carried out by it.",
        check: || same_motion(Engine::Turned),
        mutants: &[Mutant { change: "the frozen tensor", check: || same_motion(Engine::Frozen) }],
    },
];

type Number = Series<Fraction>;
type Law = fn(&Motion<Number>) -> Motion<Number>;

fn constant(x: &Fraction) -> Number {
    Series::constant(x.clone())
}

/// At the start the body's axes are the world's, which loses nothing: the world's are ours to choose.
fn start() -> Motion<Number> {
    let [one, zero] = [Number::one(), Number::zero()];
    let attitude = Quaternion::new(one, zero.clone(), zero.clone(), zero);
    Motion { attitude, vector: vector("L").map(|x| constant(&x)) }
}

fn inverse() -> Matrix3<Number> {
    let inverse: Matrix = diagonal(&vector("J"));
    inverse.map(|x| constant(&x))
}

/// The free body, its momentum in its own axes.
fn law(m: &Motion<Number>) -> Motion<Number> {
    let omega = inverse() * &m.vector;
    Motion {
        attitude: attitude::rate(&m.attitude, &omega),
        vector: euler::momentum_rate(&inverse(), &m.vector, &Vector3::zeros()),
    }
}

/// The exact motion under a law, to the power `order`: each round of `y = y0 + ∫ law(y)` settles one more.
pub(super) fn exact<T: Field>(
    start: &Motion<Series<T>>,
    order: usize,
    law: impl Fn(&Motion<Series<T>>) -> Motion<Series<T>>,
) -> Motion<Series<T>> {
    let cut = |m: &Motion<Series<T>>, order: usize| Motion {
        attitude: Quaternion::from_vector(m.attitude.coords.map(|x| x.cut(order))),
        vector: m.vector.map(|x| x.cut(order)),
    };
    let mut motion = cut(start, 0);
    for _ in 0..order {
        let rate = law(&motion);
        motion = Motion {
            attitude: Quaternion::from_vector(
                start.attitude.coords.zip_map(&rate.attitude.coords, |y, f| y + f.integral()),
            ),
            vector: start.vector.zip_map(&rate.vector, |y, f| y + f.integral()),
        };
    }
    motion
}

/// That two motions agree in every component at the given power of the step.
fn agree(a: &Motion<Number>, b: &Motion<Number>, power: usize) -> Outcome {
    let components = |m: &Motion<Number>| {
        let all: Vec<Number> = m.attitude.coords.iter().chain(m.vector.iter()).cloned().collect();
        all
    };
    for (x, y) in components(a).iter().zip(components(b)) {
        let claim = format!("the power {power} of the step");
        match x.coefficient(power).zip(y.coefficient(power)) {
            Some((x, y)) => same(&claim, &x, &y)?,
            None => return Err(Residue::Missing { claim }),
        }
    }
    Ok(())
}

fn order_is(order: usize, step: impl Fn(&Motion<Number>, &Number, Law) -> Motion<Number>) -> Outcome {
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
    let in_world = |m: &Motion<Number>| engine.rate(m, &tensor, &inverse());
    let mut start = start();
    let body = exact(&start, ORDER, law);
    if engine.carried_rate(&tensor, &inverse(), &start.vector) != Vector3::zeros() {
        // What changes with time is the spin.
        start.vector = inverse() * start.vector;
    }
    let mut world = exact(&start, ORDER, in_world);
    // The momentum that the body has, in its own axes.
    let rotation = attitude::rotation_matrix(&world.attitude);
    let omega = engine.omega_world(&rotation, &tensor, &inverse(), &world.vector);
    world.vector = &tensor * (rotation.transpose() * omega);
    (0..=ORDER).try_for_each(|power| agree(&world, &body, power))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    #[test]
    fn the_exact_motion_of_a_steady_spin_is_sine_and_cosine() {
        let [one, zero] = [Series::<Rational>::one(), Series::zero()];
        let start = Motion {
            attitude: Quaternion::new(one, zero.clone(), zero.clone(), zero.clone()),
            vector: Vector3::new(zero.clone(), zero, Series::constant(Rational::from(2))),
        };
        let law = |m: &Motion<Series<Rational>>| Motion {
            attitude: attitude::rate(&m.attitude, &m.vector),
            vector: Vector3::zeros(),
        };
        let end = exact(&start, 5, law);
        assert_eq!(end.attitude.coords.w.to_string(), "1 - 1/2 h^2 + 1/24 h^4 + ...");
        assert_eq!(end.attitude.coords.z.to_string(), "h - 1/6 h^3 + 1/120 h^5 + ...");
    }
}
