//! States requested during an adaptive run do not change the run.

use super::apart as off;
use super::driven::all_torques;
use super::{adaptive, under};
use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::PrincipalMoments;
use tumbling::step::{State, Stepper, Torque};

/// Torques of each kind, of most of them several; some act for a while, and one damping is stiff.
fn kinds(moments: &PrincipalMoments) -> Vec<Torque<f64>> {
    let [mut all, function] = all_torques(moments.vector(), 4);
    all.extend(function);
    all.extend([
        Torque::Damping(Vector3::new(0.0, 500.0, 0.1)),
        Torque::during(0.4, 1.3, Torque::InBody(Vector3::new(0.0, 0.5, 0.2))),
        Torque::during(0.7, 2.0, Torque::function(|time: f64, _, _| Vector3::z() * (0.3 * time).cos())),
    ]);
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn the_end_of_a_run_does_not_depend_on_the_states_requested_on_the_way(
        chosen in prop::collection::vec(any::<prop::sample::Index>(), 1..5), digits in 6..13_i32, frames in 1..400_u32,
        forth in any::<bool>(), omega in prop::array::uniform3(-2.0..2.0),
    ) {
        let moments = PrincipalMoments::new(1.0, 1.7, 2.4).unwrap();
        let all = kinds(&moments);
        let torques: Vec<_> = chosen.iter().map(|kind| kind.get(&all).clone()).collect();
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
