//! Euler's equations against the conservation of momentum.

use crate::common::*;
use nalgebra::{Matrix3, Quaternion, Vector3};
use proptest::prelude::*;
use tumbling::attitude;
use tumbling::dynamics::euler;

proptest! {
    // Independent of the stepper: the world momentum R I w, differenced in time, must come out constant.
    #[test]
    fn eulers_equations_keep_the_world_momentum(m in moments(), q in attitude(), omega in vector(1.0)) {
        let tensor = Matrix3::from_diagonal(&m);
        let q = q.into_inner();
        let momentum = |q: &Quaternion<f64>, w: &Vector3<f64>| attitude::rotation_matrix(q) * tensor * w;
        let h = 1e-5;
        let (dq, dw) = (attitude::rate(&q, &omega), euler::angular_acceleration(&m, &omega, &Vector3::zeros()));
        let ahead = momentum(&(q + dq * h), &(omega + dw * h));
        let behind = momentum(&(q - dq * h), &(omega - dw * h));
        prop_assert!(((ahead - behind) / (2.0 * h)).norm() < 1e-8);
    }

    #[test]
    fn a_torque_changes_the_momentum_at_its_own_rate(m in moments(), omega in vector(1.0), torque in vector(1.0)) {
        let tensor = Matrix3::from_diagonal(&m);
        let free = euler::angular_acceleration(&m, &omega, &Vector3::zeros());
        let pushed = euler::angular_acceleration(&m, &omega, &torque);
        prop_assert!((tensor * (pushed - free) - torque).norm() < 1e-14);
        let inverse = Matrix3::from_diagonal(&m.map(|x| 1.0 / x));
        let by_momentum = euler::momentum_rate(&inverse, &(tensor * omega), &torque);
        prop_assert!((tensor * pushed - by_momentum).norm() < 1e-13);
    }
}
