//! Derivatives of the exact motion against differences taken with 160 digits, and against what must hold.

mod common;

use common::*;
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;
use serde_json::Value;
use tumbling::exact::FreeMotion;

#[test]
fn the_derivatives_agree_with_differences_of_160_digits_in_every_regime() {
    let file: Value = serde_json::from_str(include_str!("data/sensitivity.json")).unwrap();
    let number = |x: &Value| x.as_str().unwrap().parse::<f64>().unwrap();
    let vector = |x: &Value| Vector3::from_iterator(x.as_array().unwrap().iter().map(number));
    for case in file["cases"].as_array().unwrap() {
        let (moments, omega) = (vector(&case["inertia"]), vector(&case["w0"]));
        let change = FreeMotion::new(&moments, &omega).unwrap().sensitivity(number(&case["t"])).unwrap();
        for (k, column) in case["columns"].as_array().unwrap().iter().enumerate() {
            let exact: Vec<f64> = column.as_array().unwrap().iter().map(number).collect();
            let (by_spin, by_moment) = if k < 3 {
                (change.omega_by_omega, change.turn_by_omega)
            } else {
                (change.omega_by_moments, change.turn_by_moments)
            };
            let spin = by_spin.column(k % 3) - Vector3::from_column_slice(&exact[..3]);
            let turn = by_moment.column(k % 3) - Vector3::from_column_slice(&exact[3..]);
            let sizes = [&exact[..3], &exact[3..]].map(|x| x.iter().map(|a| a * a).sum::<f64>().sqrt());
            let bound = 1e-9 + 10.0 * change.error;
            assert!(bound < 1e-6, "{case} {bound:e}");
            assert!(spin.norm() <= bound * (sizes[0] + 1e-3), "{k} {spin} {exact:?} {case}");
            assert!(turn.norm() <= bound * (sizes[1] + 1e-3), "{k} {turn} {exact:?} {case}");
        }
    }
}

proptest! {
    // The momentum in the world is the start's, so its change is too: R (I dw + dI w) + turn x L = dL, with R
    // and the turn ours. Mathematics; nothing of it is used by the differences.
    #[test]
    fn the_change_of_momentum_in_the_world_is_that_of_the_start(m in moments(), omega in generic_spin(), t in -10.0..10.0_f64) {
        let motion = FreeMotion::new(&m, &omega).unwrap();
        let (at, change) = (motion.at(t).unwrap(), motion.sensitivity(t).unwrap());
        let rotation = at.attitude.to_rotation_matrix().into_inner();
        let tensor = Matrix3::from_diagonal(&m);
        let momentum = m.component_mul(&omega);
        let turned = |turn: &Matrix3<f64>| -momentum.cross_matrix() * turn;
        let by_spin = rotation * tensor * change.omega_by_omega + turned(&change.turn_by_omega);
        let by_moments = rotation * (tensor * change.omega_by_moments + Matrix3::from_diagonal(&at.omega))
            + turned(&change.turn_by_moments);
        let size = 1.0 + change.omega_by_omega.norm() + change.omega_by_moments.norm();
        let bound = size * (1e-9 + 10.0 * change.error);
        prop_assert!((by_spin - tensor).norm() < bound, "{by_spin}");
        prop_assert!((by_moments - Matrix3::from_diagonal(&omega)).norm() < bound, "{by_moments}");
    }

    #[test]
    fn no_input_makes_the_derivatives_panic(m in any_vector(), omega in any_vector(), t in anything()) {
        if let Ok(motion) = FreeMotion::new(&m, &omega)
            && let Ok(change) = motion.sensitivity(t)
        {
            prop_assert!(change.omega_by_omega.iter().all(|x| x.is_finite()));
        }
    }
}
