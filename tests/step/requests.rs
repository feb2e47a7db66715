//! States requested during an adaptive run do not change the run.

use super::apart as off;
use super::{adaptive, under};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::PrincipalMoments;
use tumbling::step::{State, Stepper, Torque};

/// Torques of each kind, two of most: of the gravity gradient, and of periodic ones with their own rates.
fn kinds() -> Vec<Torque<f64>> {
    let periodic = |x: f64, rate: f64| Torque::Periodic {
        amplitude: Vector3::new(0.3, 0.1 * x, 0.2 * x),
        rate,
        phase: 0.4 * x,
    };
    vec![
        Torque::InBody(Vector3::new(0.3, -0.1, 0.2)),
        Torque::InWorld(Vector3::new(-0.2, 0.1, 0.3)),
        Torque::gravity(&Vector3::new(0.1, 0.2, 0.3), 1.5),
        Torque::Damping(Vector3::new(0.02, 0.3, 0.01)),
        Torque::Damping(Vector3::new(0.0, 500.0, 0.1)),
        Torque::Dissipation(0.02),
        Torque::gravity_gradient(&Vector3::new(0.6, 0.8, 0.0), &Vector3::new(0.0, 0.1, 0.6)),
        Torque::gravity_gradient(&Vector3::new(0.0, 0.6, -0.8), &Vector3::new(0.4, 0.0, 0.2)),
        periodic(1.0, 2.0),
        periodic(-2.0, 3.1),
        periodic(0.5, 0.7),
        Torque::during(0.4, 1.3, Torque::InBody(Vector3::new(0.0, 0.5, 0.2))),
        Torque::during(0.7, 2.0, Torque::function(|time: f64, _, _| Vector3::z() * (0.3 * time).cos())),
        Torque::function(|time: f64, rotation: &Matrix3<f64>, omega: &Vector3<f64>| {
            rotation.transpose() * Vector3::new(0.1, 0.2 * (2.0 * time).sin(), 0.3) - omega * 0.05
        }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn the_end_of_a_run_does_not_depend_on_the_states_requested_on_the_way(
        chosen in prop::collection::vec(0..14_usize, 1..5), digits in 6..13_i32, frames in 1..400_u32,
        forth in any::<bool>(), omega in prop::array::uniform3(-2.0..2.0),
    ) {
        let all = kinds();
        let torques: Vec<_> = chosen.iter().map(|&kind| all[kind].clone()).collect();
        let moments = PrincipalMoments::new(1.0, 1.7, 2.4).unwrap();
        let system = under(moments, torques);
        let attitude = UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1).into_inner();
        let start = State { attitude, momentum: system.momentum(&omega.into()) };
        let (tolerance, end) = (10.0_f64.powi(-digits), if forth { 2.5 } else { -0.02 });
        let mut alone = 20_000;
        let whole = adaptive(&system, &start, end, tolerance, &mut alone).unwrap();
        let mut run = Stepper::of_system(system.clone(), &start, tolerance, 100_000).unwrap();
        for frame in 1..=frames {
            let time = end * f64::from(frame) / f64::from(frames);
            let state = run.step_to(time).unwrap();
            if frame == frames / 2 {
                let there = adaptive(&system, &start, time, 1e-2 * tolerance, &mut 20_000).unwrap();
                let steps = f64::from(20_000 - alone as u32);
                prop_assert!(off(&state, &there) < 30.0 * tolerance * steps, "{:e}", off(&state, &there));
            }
        }
        prop_assert_eq!(run.step_to(end).unwrap(), whole);
        prop_assert_eq!(run.steps_of_run(), 20_000 - alone);
    }
}
