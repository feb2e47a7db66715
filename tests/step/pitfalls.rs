//! Each of the three wrong engines must err in the way that its pitfall describes.

use crate::common::*;
use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::step::Engine;
use tumbling::{Body, Inertia};

fn start(moments: &Vector3<f64>, q: UnitQuaternion<f64>, omega: &Vector3<f64>) -> Body {
    Body::spinning(Inertia::from_moments(moments.x, moments.y, moments.z).unwrap(), q, omega).unwrap()
}

/// The errors of a motion: in energy, and in the direction of the momentum.
fn strays(bodies: &[Body]) -> (f64, f64) {
    let first = bodies[0];
    let energy = |b: &Body| (b.energy() / first.energy() - 1.0).abs();
    let turn = |b: &Body| b.momentum_world().angle(&first.momentum_world());
    (bodies.iter().map(energy).fold(0.0, f64::max), bodies.iter().map(turn).fold(0.0, f64::max))
}

proptest! {
    // The frozen tensor solves Euler's equations for the wrong axes: the world components of its spin are the
    // body components of the true one.
    #[test]
    fn the_frozen_tensor_takes_body_components_for_world_ones(omega in generic_spin()) {
        let body = start(&Vector3::new(10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0), UnitQuaternion::identity(), &omega);
        let (right, wrong) = (Engine::Turned.run(&body, 0.005, 400).unwrap(), Engine::Frozen.run(&body, 0.005, 400).unwrap());
        prop_assert!((right[400].omega_body() - wrong[400].omega_world()).norm() < 1e-8);
        let (energy, turn) = strays(&wrong);
        prop_assert!(energy > 1e-3 && turn > 1e-2, "{energy} {turn}");
        let (energy, turn) = strays(&right);
        prop_assert!(energy < 1e-9 && turn < 1e-6, "{energy} {turn}");
    }
}

#[test]
fn a_run_starts_with_the_body_itself_and_refuses_a_step_that_is_no_number() {
    let body = start(&Vector3::new(1.0, 2.0, 2.5), UnitQuaternion::identity(), &Vector3::new(0.3, 1.0, -0.2));
    let run = Engine::Turned.run(&body, 0.1, 0).unwrap();
    assert_eq!(run.len(), 1);
    assert_eq!(run[0].attitude(), body.attitude());
    assert!(Engine::Turned.run(&body, f64::NAN, 1).is_err());
    assert!(Engine::Turned.run(&body, f64::INFINITY, 1).is_err());
    refused(
        Engine::Turned.run(&body, 0.01, usize::MAX),
        tumbling::ErrorKind::TooMany,
        "18446744073709551615 steps",
    );
    // So coarse that the attitude overflows: an error, not a NaN carried on.
    assert!(Engine::Turned.run(&body, 1e200, 3).is_err());
}
