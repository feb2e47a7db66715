//! The error that an adaptive run reports for itself, against the closed forms of a pendulum and of a top.

use super::spinning;
use crate::common::refused;
use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};
use tumbling::exact::FreeMotion;
use tumbling::step::{Stepper, Torque};
use tumbling::{Body, ErrorKind, Inertia};

fn stepper(body: &Body, tolerance: f64, torques: Vec<Torque<f64>>) -> Stepper {
    Stepper::adaptive(body, tolerance, 100_000).unwrap().with_torques(torques).unwrap()
}

/// The angle by which a step of this time is off, and the one expected.
fn off_and_expected(stepper: &Stepper, time: f64, truth: &UnitQuaternion<f64>) -> [f64; 2] {
    let expected = stepper.expected_error(time).unwrap();
    let mut stepper = stepper.clone();
    let _ = stepper.step(time).unwrap();
    [stepper.body().unwrap().attitude().angle_to(truth), expected]
}

/// A pendulum about y, released at `angle` from the upright, is there again after each period.
fn pendulum(angle: f64, tolerance: f64, periods: f64) -> [f64; 2] {
    let (moment, pull) = (2.0_f64, 9.8_f64);
    let inertia = Inertia::from_moments(1.0, moment, 1.5).unwrap();
    let leaning = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), angle);
    let body = Body::spinning(inertia, leaning, &Vector3::zeros()).unwrap();
    // Through the arithmetic-geometric mean of 1 and the sine of half the angle.
    let (mut a, mut g) = (1.0_f64, (0.5 * angle).sin());
    for _ in 0..12 {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    let period = TAU * (moment / pull).sqrt() / a;
    let stepper = stepper(&body, tolerance, vec![Torque::gravity(&Vector3::z(), pull)]);
    off_and_expected(&stepper, periods * period, &leaning)
}

#[test]
fn a_pendulum_let_go_next_to_the_upright_says_that_its_end_is_not_known() {
    for angle in [1e-7, 1e-8, 1e-10] {
        for tolerance in [1e-10, 1e-14] {
            let [off, expected] = pendulum(angle, tolerance, 2.0);
            assert!(off < 10.0 * expected, "{angle:e} {tolerance:e}: {off:e} {expected:e}");
            assert!(expected > 0.1, "{angle:e} {tolerance:e}: {off:e} {expected:e}");
        }
    }
    // Far from it, it is known: through the upright a swing is unstable against errors across it too.
    for angle in [2.2, 2.5, 3.0] {
        for tolerance in [1e-6, 1e-10, 1e-14] {
            let [off, expected] = pendulum(angle, tolerance, 3.0);
            assert!(off < 10.0 * expected, "{angle} {tolerance:e}: {off:e} {expected:e}");
            assert!(expected < 1e4 * tolerance, "{angle} {tolerance:e}: {off:e} {expected:e}");
        }
    }
}

#[test]
fn damping_far_faster_than_the_motion_adds_no_error_and_is_named_where_it_takes_the_steps() {
    let body = spinning([1.0, 2.0, 2.5], &Vector3::new(0.5, 2.0, 0.3));
    let heavy = Torque::gravity(&Vector3::new(0.1, 0.2, 0.3), 4.0);
    let torques = [Torque::Damping(Vector3::new(1e3, 2e3, 1.5e3)), heavy];
    let run = |tolerance: f64| stepper(&body, tolerance, torques.to_vec());
    let truth = UnitQuaternion::from_quaternion(run(1e-14).step(300.0).unwrap().attitude);
    for tolerance in [1e-6, 1e-10] {
        let [off, expected] = off_and_expected(&run(tolerance), 300.0, &truth);
        assert!(off < 10.0 * expected && expected < 50.0 * tolerance, "{off:e} {expected:e}");
        let few = Stepper::adaptive(&body, tolerance, 20_000).unwrap().with_torques(torques.to_vec());
        refused(few.unwrap().expected_error(1e4), ErrorKind::TooMany, "damping");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_error_of_a_free_body_is_what_its_run_expects_at_most_tenfold(
        omega in crate::common::generic_spin(), digits in 6..14_i32, time in 1.0..40.0_f64,
    ) {
        let inertia = Inertia::from_moments(1.0, 1.7, 2.4).unwrap();
        let attitude = UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1);
        let body = Body::spinning(inertia, attitude, &(omega * 3.0)).unwrap();
        let truth = FreeMotion::of(&body).unwrap().attitude(time).unwrap();
        let stepper = stepper(&body, 10.0_f64.powi(-digits), vec![]);
        let [off, expected] = off_and_expected(&stepper, time, &truth);
        prop_assert!(off < 10.0 * expected, "{:e} {:e}", off, expected);
    }
}

#[test]
fn an_error_is_expected_of_adaptive_runs_alone_and_is_at_most_half_a_turn() {
    // A tumble next to the separatrix, at a loose tolerance.
    let body = spinning([1.0, 1.7, 2.4], &Vector3::new(1e-9, 5.0, 1e-9));
    let loose = stepper(&body, 1e-5, vec![]);
    assert_eq!(loose.expected_error(200.0).unwrap(), PI);
    assert!(loose.expected_error(0.0).unwrap() < 1e-15 && loose.time() == 0.0);
    let fixed = Stepper::fixed_rate(&body).unwrap();
    assert_eq!(fixed.expected_error(1.0).unwrap_err().kind(), ErrorKind::Undefined);
    assert!(loose.expected_error(f64::NAN).is_err() && loose.expected_error(f64::INFINITY).is_err());
    // As `step`, where the square of the spin has no digits.
    let slow = stepper(&spinning([1.0, 1.7, 2.4], &Vector3::new(1e-300, 0.0, 0.0)), 1e-9, vec![]);
    refused(slow.expected_error(1e300), ErrorKind::Unrepresentable, "spin");
}
