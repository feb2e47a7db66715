//! Rotations against nalgebra's, and the attitudes that are refused.

use crate::common::{attitude, refused, vector};
use nalgebra::{Quaternion, UnitQuaternion};
use proptest::prelude::*;
use tumbling::ErrorKind;
use tumbling::attitude::{checked, product, rate, rotate_inverse, rotation_matrix, turn};

proptest! {
    #[test]
    fn products_matrices_and_turns_are_nalgebras(p in attitude(), q in attitude(), v in vector(3.0)) {
        prop_assert!((product(&p, &q) - (p * q).into_inner()).norm() < 1e-15);
        prop_assert!((rotation_matrix(&q) - q.to_rotation_matrix().matrix()).amax() < 2e-15);
        prop_assert!((rotate_inverse(&q, &v) - q.inverse() * v).norm() < 1e-14);
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

#[test]
fn an_attitude_is_a_direction_and_a_length_far_from_one_is_refused() {
    let q = Quaternion::new(0.1, -0.7, 0.5, 0.5);
    let drifted = UnitQuaternion::new_unchecked(q * (1.0 + 1e-10));
    assert!((checked(&drifted).unwrap().norm() - 1.0).abs() < 4e-16);
    for bad in [q * 1.00001, q * 0.0] {
        refused(checked(&UnitQuaternion::new_unchecked(bad)), ErrorKind::OutOfBounds, "attitude");
    }
    let unfinite = UnitQuaternion::new_unchecked(q * f64::NAN);
    refused(checked(&unfinite), ErrorKind::NotFinite, "the length of the attitude quaternion");
}
