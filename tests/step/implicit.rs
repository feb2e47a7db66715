//! The implicit midpoint rule and Gauss's methods: roundings of long runs, and steps that plain iteration
//! does not find.

use super::{energy, free, start, under};
use crate::common::refused;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::ErrorKind;
use tumbling::step::{Method, State, System, Torque};

const IMPLICIT: [Method; 3] = [Method::ImplicitMidpoint, Method::Gauss4, Method::Gauss6];

#[test]
fn roundings_of_what_is_conserved_walk_at_random_and_do_not_drift() {
    // Each step rounds its conserved quantities by less than a unit; a random walk of this number of steps
    // goes as far as the square root of the number.
    const STEPS: u32 = 50_000;
    let walk = f64::EPSILON * f64::from(STEPS).sqrt();
    for method in IMPLICIT {
        let mut squares = [0.0; 2];
        for k in 0..3 {
            let k = f64::from(k);
            let system = free([1.0 + 0.13 * k, 2.0, 2.5]);
            let omega = Vector3::new(0.6 + 0.07 * k, 0.5, 0.7 - 0.05 * k);
            let from = start(&system, &omega);
            let h = std::f64::consts::TAU / (6.0 * omega.norm());
            let end = (0..STEPS).fold(from, |state, _| method.step(&system, &state, h).unwrap());
            squares[0] += (energy(&system, &end) / energy(&system, &from) - 1.0).powi(2) / 3.0;
            squares[1] += (end.attitude.norm() - 1.0).powi(2) / 3.0;
        }
        for (what, square) in ["energy", "attitude"].into_iter().zip(squares) {
            let walks = square.sqrt() / walk;
            assert!(walks < 1.5, "{method:?}: {what} off by {walks} random walks");
        }
    }
}

/// The residue of `L' - L = h (M x w + torque)` at the means of momentum and attitude.
fn midpoint_misses(system: &System<f64>, from: &State<f64>, end: &State<f64>, h: f64) -> f64 {
    let mean = State {
        attitude: (from.attitude + end.attitude).normalize(),
        momentum: (from.momentum + end.momentum) / 2.0,
    };
    let push = system.rate(&mean).momentum;
    (end.momentum - from.momentum - push * h).norm() / (end.momentum.norm() + push.norm() * h)
}

#[test]
fn a_step_too_long_for_iteration_is_found_by_newtons_method() {
    // Eight radians about an axis near that of the largest moment.
    let system = free([1.0, 2.0, 2.5]);
    let from = start(&system, &Vector3::new(0.1, 0.2, 2.0));
    let end = Method::ImplicitMidpoint.step(&system, &from, 4.0).unwrap();
    assert!(midpoint_misses(&system, &from, &end, 4.0) < 1e-15);
    for method in IMPLICIT {
        let end = method.step(&system, &from, 4.0).unwrap();
        assert!((energy(&system, &end) / energy(&system, &from) - 1.0).abs() < 1e-14, "{method:?}");
        assert!((end.momentum.norm() / from.momentum.norm() - 1.0).abs() < 1e-14, "{method:?}");
        assert!((end.attitude.norm() - 1.0).abs() < 1e-14, "{method:?}");
        let back = method.step(&system, &end, -4.0).unwrap();
        let off = (back.momentum - from.momentum).norm() + (back.attitude - from.attitude).norm();
        assert!(off < 1e-13, "{method:?}: {off:e}");
    }
}

#[test]
fn a_stiff_damping_and_a_stiff_spring_are_stepped_over_by_the_equations_of_the_method() {
    let moments = Vector3::new(1.0, 2.0, 2.5);
    for decay in [10.0, 1e3, 1e6] {
        // Damping about z alone: each step multiplies the spin by Padé's fraction of the exponential.
        let drag = Torque::Damping(Vector3::new(0.5, 1.5, 1.0) * decay * moments.z);
        let system = under(moments, vec![drag.clone()]);
        let from = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.0, 0.0, 3.0) };
        let z = decay;
        let shares = [
            (1.0 - z / 2.0) / (1.0 + z / 2.0),
            (1.0 - z / 2.0 + z * z / 12.0) / (1.0 + z / 2.0 + z * z / 12.0),
            (1.0 - z / 2.0 + z * z / 10.0 - z.powi(3) / 120.0)
                / (1.0 + z / 2.0 + z * z / 10.0 + z.powi(3) / 120.0),
        ];
        for (method, share) in IMPLICIT.into_iter().zip(shares) {
            let end = method.step(&system, &from, 1.0).unwrap();
            let off = (end.momentum.z / 3.0 - share).abs();
            assert!(off < 1e-13, "{method:?} {decay}: {off:e}");
        }
        // Tumbling under it, leaning under a spring.
        let spring = Torque::spring(&Vector3::new(0.3, -0.2, 0.9), &Vector3::new(0.1, 0.7, 0.6), 50.0);
        let system = under(moments, vec![drag, spring]);
        let attitude = UnitQuaternion::from_euler_angles(0.4, -0.3, 0.2).into_inner();
        let from = State { attitude, momentum: Vector3::new(0.4, 3.0, -1.2) };
        let end = Method::ImplicitMidpoint.step(&system, &from, 0.5).unwrap();
        let off = midpoint_misses(&system, &from, &end, 0.5);
        // The mean is small relative to the momenta from which it is computed.
        assert!(off < 4e-15 * (1.0 + decay), "{decay}: {off:e}");
    }
}

#[test]
fn a_step_so_long_that_its_way_back_is_another_is_refused() {
    let system = free([0.355_483_082_714_671_7, 0.301_507_070_183_904, 0.656_621_176_938_606_1]);
    let momentum = Vector3::new(2.101_930_418_563_104_5, -2.564_531_492_599_056, 1.665_766_856_754_197_9);
    let from = State { attitude: Quaternion::identity(), momentum };
    let step = Method::ImplicitMidpoint.step(&system, &from, 0.873_439_484_679_532_7);
    refused(step, ErrorKind::Undefined, "the step back finds another");
}
