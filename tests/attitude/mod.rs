//! Rotations against nalgebra's. Attitudes that are refused are with the bodies and tensors that they turn.

use crate::common::{attitude, vector};
use nalgebra::UnitQuaternion;
use proptest::prelude::*;
use tumbling::attitude::{product, rate, rotation_matrix, turn};

proptest! {
    #[test]
    fn products_matrices_and_turns_are_nalgebras(p in attitude(), q in attitude(), v in vector(3.0)) {
        prop_assert!((product(&p, &q) - (p * q).into_inner()).norm() < 1e-15);
        prop_assert!((rotation_matrix(&q) - q.to_rotation_matrix().matrix()).amax() < 2e-15);
        prop_assert!((turn(&v) - UnitQuaternion::from_scaled_axis(v).into_inner()).norm() < 1e-15);
    }

    /// A spin in body axes: after a short time the attitude is the one before, times the turn by the spin.
    #[test]
    fn the_rate_of_an_attitude_is_that_of_a_small_turn_in_body_axes(q in attitude(), omega in vector(3.0)) {
        let h = 1e-5;
        let after = |h: f64| (q * UnitQuaternion::from_scaled_axis(omega * h)).into_inner();
        prop_assert!(((after(h) - after(-h)) / (2.0 * h) - rate(&q, &omega)).norm() < 1e-9);
    }
}
