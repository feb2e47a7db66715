//! The motions that methods are compared with.

use nalgebra::{Quaternion, Vector3};
use num_traits::{One, Zero};
use tumbling::attitude;
use tumbling::laws::Rate;
use tumbling::number::Analytic;
use tumbling::step::{Method, State};
use tumbling_proofs::tested::{TESTED, cases, exact};
use tumbling_proofs::{Fraction, Rational, Series};

type Number = Series<Fraction>;

#[test]
fn the_exact_motion_of_a_steady_spin_is_sine_and_cosine() {
    let [one, zero] = [Series::<Rational>::one(), Series::zero()];
    let start = State {
        attitude: Quaternion::new(one, zero.clone(), zero.clone(), zero.clone()),
        momentum: Vector3::new(zero.clone(), zero, Series::constant(Rational::from(2))),
    };
    let turning = |m: &State<Series<Rational>>| attitude::rate(&m.attitude, &m.momentum);
    let end = exact(&start, 5, |m| Rate { attitude: turning(m), momentum: Vector3::zeros() });
    assert_eq!(end.attitude.coords.w.to_string(), "1 - 1/2 h^2 + 1/24 h^4 + ...");
    assert_eq!(end.attitude.coords.z.to_string(), "h - 1/6 h^3 + 1/120 h^5 + ...");
}

#[test]
fn every_method_is_tested() {
    assert!(Method::ALL.iter().all(|method| TESTED.contains(method)));
}

#[test]
fn spiral_loses_an_order_in_the_attitude_alone() {
    for (system, start) in &cases() {
        let end = Method::Spiral.step(system, start, Number::step(4)).unwrap();
        let truth = exact(start, 4, |motion| system.rate(motion));
        let agree = |a: &[Number], b: &[Number], power: usize| {
            a.iter().zip(b).all(|(a, b)| a.coefficient(power) == b.coefficient(power))
        };
        let spin = |power| agree(end.momentum.as_slice(), truth.momentum.as_slice(), power);
        let attitude = |power| agree(end.attitude.coords.as_slice(), truth.attitude.coords.as_slice(), power);
        assert_eq!([1, 2, 3, 4].map(spin), [true, true, true, false]);
        assert_eq!([1, 2, 3].map(attitude), [true, true, false]);
    }
}

#[test]
fn the_starts_have_lengths_without_a_root() {
    for (system, start) in &cases() {
        let omega = system.omega(&start.momentum);
        for square in [omega.dot(&omega), start.momentum.dot(&start.momentum)] {
            assert_eq!(square.sqrt() * square.sqrt(), square);
        }
        assert_eq!(start.attitude.coords.dot(&start.attitude.coords), Number::one());
        assert!(!start.momentum.iter().any(Zero::is_zero));
    }
}
