//! The possible tensor nearest to one whose printed digits were rounded.

use super::any_tensor;
use crate::common::*;
use nalgebra::{Matrix3, Vector3};
use num_traits::Signed;
use proptest::prelude::*;
use tumbling::{ErrorKind, Inertia};

#[test]
fn digits_that_were_printed_are_refused_by_default_and_taken_within_a_stated_tolerance() {
    let tenth = f64::from(0.1_f32 + 0.2_f32);
    for (m, excess, moved) in [
        ([0.003333, 0.01333, 0.01667], 7e-6, 7e-6 / 3_f64.sqrt() / 0.01667),
        ([tenth, 0.1, 0.2], 1.192_092_895_5e-8, 1.192_092_895_5e-8 / 3_f64.sqrt() / tenth),
    ] {
        let error = refused(
            Inertia::from_moments(m[0], m[1], m[2]),
            ErrorKind::Impossible,
            "`within` takes a tolerance",
        );
        assert!((number_after(&error, "fails by ") / excess - 1.0).abs() < 1e-6, "{error}");
        let given = Matrix3::from_diagonal(&m.into());
        let (nearest, distance) = Inertia::within(&given, 1e-3).unwrap();
        assert!((distance / moved - 1.0).abs() < 1e-6, "{:e}, not {moved:e}", distance);
        // A third of the excess on each moment: the foot of the perpendicular on the plane of the flat
        // bodies.
        let change = (nearest.matrix() - given).diagonal();
        assert!(change.iter().all(|x| (x.abs() / (excess / 3.0) - 1.0).abs() < 1e-6), "{change:e}");
        refused(
            Inertia::within(&given, 0.9 * moved),
            ErrorKind::Impossible,
            "of the largest moment away, more than the tolerance",
        );
        let (again, again_by) = Inertia::within(&nearest.matrix(), 0.0).unwrap();
        assert_eq!((again, again_by), (nearest, 0.0));
    }
    for bad in [f64::NAN, -1e-3, f64::INFINITY] {
        assert!(Inertia::within(&Matrix3::identity(), bad).is_err(), "{bad}");
    }
    refused(
        Inertia::within(&Matrix3::zeros(), 0.5),
        ErrorKind::OutOfBounds,
        "the largest moment of inertia is 0.0",
    );
    refused(Inertia::within(&-Matrix3::identity(), 5.0), ErrorKind::Impossible, "the moment Ixx is -1");
    let unfinite = Matrix3::from_diagonal(&Vector3::new(1.0, f64::NAN, 1.0));
    refused(Inertia::within(&unfinite, 0.5), ErrorKind::NotFinite, "the moment Iyy is NaN");
}

proptest! {
    /// The tensors of bodies are a convex cone: the nearest one `p` to `s` has `(s - p) . p = 0` and
    /// `(s - p) . b <= 0` for every body `b`.
    #[test]
    fn the_nearest_tensor_meets_the_conditions_of_a_projection_onto_the_cone_of_bodies(
        six in prop::array::uniform9(-1.0..1.0_f64), scale in -200..150_i32, bodies in prop::collection::vec(any_tensor(), 8),
    ) {
        let size = 10_f64.powi(scale);
        // Rows that differ from columns too: the antisymmetric part is across every body's tensor.
        let given = (Matrix3::from_row_slice(&six) + Matrix3::identity()) * size;
        let (nearest, distance) = Inertia::within(&given, f64::MAX).unwrap();
        let (p, s) = (nearest.matrix() / size, given / size);
        let off = s - p;
        let middle = (s + s.transpose()) * 0.5;
        prop_assert!((distance - off.norm() / middle.symmetric_eigenvalues().max()).abs() <= 1e-14 * (1.0 + distance));
        prop_assert!(off.dot(&p).abs() <= 1e-13, "{:e}", off.dot(&p));
        for body in &bodies {
            prop_assert!(off.dot(&body.matrix()) <= 1e-13, "{:e}", off.dot(&body.matrix()));
        }
        // The principal axes stay.
        prop_assert!((middle * p - p * middle).amax() <= 1e-14);
    }
}
