//! One law, many numbers: the library's own functions, unchanged, on every kind of number.

use nalgebra::{Matrix3, Quaternion, Vector3};
use num_dual::Dual64;
use num_traits::{One, Zero};
use tumbling::laws::Rate;
use tumbling::number::Field;
use tumbling::step::{State, rk4};
use tumbling::{attitude, dynamics::euler, dynamics::observe, dynamics::stability, inertia, laws};
use tumbling_proofs::counted::Counted;
use tumbling_proofs::{Fraction, Rational, Series};

/// A slow book of moments 2, 3, 4 at a given spin, one step of free motion from a tilted attitude, and what
/// the library says about it: every law that is a polynomial or a fraction, in one list.
fn laws<T: Field>(spin: Vector3<T>, h: T) -> Vec<T> {
    let n = |n: u32| T::integer(n);
    let moments = Vector3::new(n(2), n(3), n(4));
    let tensor = Matrix3::from_fn(|i, j| if i == j { moments[i].clone() } else { T::zero() })
        + inertia::point_mass(&(T::one() / n(8)), &Vector3::new(n(1), n(2), n(3)));
    let inverse = Matrix3::from_fn(|i, j| if i == j { T::one() / moments[i].clone() } else { T::zero() });
    let torque = Vector3::new(n(1), n(0), n(5));
    // Of length 1: 4² + 2² + 2² + 1² = 5².
    let tilted = Quaternion::new(n(4) / n(5), n(2) / n(5), n(2) / n(5), n(1) / n(5));
    let rotation = attitude::rotation_matrix(&tilted);
    let momentum = spin.component_mul(&moments);
    let start = State { attitude: tilted.clone(), momentum: momentum.clone() };
    let law = |m: &State<T>| Rate {
        attitude: attitude::rate(&m.attitude, &(&inverse * &m.momentum)),
        momentum: laws::momentum_rate(&inverse, &m.momentum, &torque),
    };
    let end = rk4(&start, h, law, State::plus);
    let mut all = Vec::new();
    all.extend(euler::angular_acceleration(&moments, &spin, &torque).iter().cloned());
    all.extend(euler::tensor_times_acceleration(&tensor, &spin, &torque).iter().cloned());
    all.extend(inertia::turned(&rotation, &tensor).iter().cloned());
    all.extend(inertia::omega_world(&rotation, &inverse, &momentum).iter().cloned());
    all.extend(end.attitude.coords.iter().cloned());
    all.extend(end.momentum.iter().cloned());
    all.push(observe::energy(&spin, &momentum));
    all.push(stability::rate_squared(&spin.y, &moments.y, &moments.x, &moments.z));
    all
}

/// Spins whose floats are exact, so that the exact computation starts from the same numbers.
const SPINS: [[f64; 3]; 4] = [[0.5, 10.0, 0.125], [-1.0, 0.25, 3.0], [2.0, -2.0, 0.0625], [0.0, 1.0, -0.5]];
const STEP: f64 = 0.03125;

fn exactly(spin: [f64; 3]) -> Vec<Rational> {
    laws(Vector3::from(spin).map(Rational::of_f64), Rational::of_f64(STEP))
}

/// That floats are within `ulps` roundings of the exact values, relative to the largest of them.
fn close(floats: &[f64], exact: &[Rational], epsilon: f64, ulps: f64) {
    assert_eq!(floats.len(), exact.len());
    let largest = exact.iter().map(|x| x.to_f64().abs()).fold(0.0, f64::max);
    for (i, (float, exact)) in floats.iter().zip(exact).enumerate() {
        let error = (Rational::of_f64(*float) - exact).to_f64().abs();
        assert!(error <= ulps * epsilon * largest, "law {i}: {float} against {exact}, off by {error:e}");
    }
}

#[test]
fn floats_of_either_precision_follow_the_exact_laws_to_their_rounding() {
    for spin in SPINS {
        close(&laws(spin.into(), STEP), &exactly(spin), f64::EPSILON, 4.0);
        let single = laws(Vector3::from(spin).map(|x| x as f32), STEP as f32);
        let widened: Vec<f64> = single.into_iter().map(f64::from).collect();
        close(&widened, &exactly(spin), f32::EPSILON.into(), 4.0);
    }
}

#[test]
fn duals_carry_the_derivative_that_fractions_find() {
    // By the spin about the middle axis.
    for spin in SPINS {
        let dual = |i: usize| if i == 1 { Dual64::new(spin[i], 1.0) } else { Dual64::from_re(spin[i]) };
        let duals = laws(Vector3::new(dual(0), dual(1), dual(2)), Dual64::from_re(STEP));
        let exact = |x: f64| Fraction::from(Rational::of_f64(x));
        let y = Fraction::variable("y");
        let symbolic = laws(Vector3::new(exact(spin[0]), y, exact(spin[2])), exact(STEP));
        let at = [("y", Rational::of_f64(spin[1]))];
        let values: Vec<_> = symbolic.iter().map(|f| f.at(&at)).collect();
        let slopes: Vec<_> = symbolic.iter().map(|f| f.derivative(&"y".into()).at(&at)).collect();
        close(&duals.iter().map(|d| d.re).collect::<Vec<_>>(), &values, f64::EPSILON, 4.0);
        close(&duals.iter().map(|d| d.eps).collect::<Vec<_>>(), &slopes, f64::EPSILON, 4.0);
    }
}

#[test]
fn a_series_in_the_step_summed_up_is_the_step() {
    for spin in SPINS {
        let number = |x: f64| Series::constant(Rational::of_f64(x));
        let series = laws(Vector3::from(spin).map(number), Series::step(40));
        let h = Rational::of_f64(STEP);
        let sum = |s: &Series<Rational>| {
            (0..=40).rev().fold(Rational::zero(), |sum, n| sum * h.clone() + s.coefficient(n).unwrap())
        };
        assert_eq!(series.iter().map(sum).collect::<Vec<_>>(), exactly(spin));
    }
}

#[test]
fn a_counting_number_compares_by_its_value() {
    assert_eq!(Counted::new(1.0), Counted::one());
    assert!(Counted::new(1.0).is_one());
    assert!(Counted::new(0.5) < Counted::one());
}
