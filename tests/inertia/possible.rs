//! Which tensors a body can have, to rounding, and how the others are refused.

use crate::common::*;
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;
use tumbling::{ErrorKind, Inertia};

proptest! {
    #[test]
    fn a_flat_plate_passes_at_any_scale_and_attitude(a in 0.01..2.0_f64, b in 0.01..2.0_f64, q in attitude(), scale in -200..150_i32) {
        let s = 10_f64.powi(scale);
        let (ix, iy) = (a * s, b * s);
        prop_assert!(Inertia::from_moments(ix, iy, ix + iy).is_ok());
        let r = q.to_rotation_matrix().into_inner();
        let world = r * Matrix3::from_diagonal(&Vector3::new(ix, iy, ix + iy)) * r.transpose();
        prop_assert!(Inertia::try_from(world).is_ok());
        // A thousandth of a millionth too much does not pass, at any scale either.
        prop_assert!(Inertia::from_moments(ix, iy, (ix + iy) * (1.0 + 1e-9)).is_err());
    }

    #[test]
    fn a_value_that_is_not_finite_is_named(place in 0..6_usize, bad in prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY])) {
        let mut six = [1.0, 2.0, 2.5, 0.1, 0.2, 0.3];
        six[place] = bad;
        let names = ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"];
        let error = Inertia::new([six[0], six[1], six[2]], [six[3], six[4], six[5]]).unwrap_err();
        prop_assert_eq!(error.kind(), ErrorKind::NotFinite);
        prop_assert!(error.to_string().contains(&format!("{} is {bad}:", names[place])), "{}", error);
    }
}

#[test]
fn negative_and_zero_moments_and_asymmetric_tensors_are_refused() {
    refused(Inertia::from_moments(1.0, -0.1, 1.0), ErrorKind::Impossible, "the moment Iyy is -0.1");
    refused(
        Inertia::from_moments(0.0, 0.0, 0.0),
        ErrorKind::OutOfBounds,
        "inertia is 0.0: it must be above zero",
    );
    // Off the diagonal it is the smallest principal moment that is negative.
    let negative = Inertia::new([1.0, 1.0, 2.0], [1.5, 0.0, 0.0]);
    refused(negative, ErrorKind::Impossible, "the smallest principal moment is -0.5");
    let lopsided = Matrix3::new(2.0, 0.1, 0.0, 0.1 + 1e-12, 2.0, 0.0, 0.0, 0.0, 2.0);
    let error = refused(Inertia::try_from(lopsided), ErrorKind::Impossible, "entry (0, 1) is 0.1");
    assert!(error.to_string().contains("differ by 1e-12"), "{error}");
}

#[test]
fn the_top_of_the_range_has_no_tolerance_without_end() {
    refused(
        Inertia::from_moments(1.0, 1.0, f64::MAX),
        ErrorKind::Impossible,
        "the triangle inequality 1 + 1 >= 17976931348",
    );
    let lopsided = Matrix3::new(f64::MAX, 1e300, 0.0, 0.0, f64::MAX, 0.0, 0.0, 0.0, f64::MAX);
    refused(Inertia::try_from(lopsided), ErrorKind::Impossible, "(0, 1) is 1e300, entry (1, 0) is 0.0");
    let beyond = Inertia::new([1.7e308; 3], [-1.7e308, -1.7e308, 1.7e308]);
    refused(beyond, ErrorKind::Unrepresentable, "a principal moment comes out as inf");
}

#[test]
fn mirrored_entries_one_unit_apart_are_stored_as_equal() {
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        let mut tensor = Matrix3::new(2.0, 0.1, -0.2, 0.1, 2.5, 0.3, -0.2, 0.3, 3.0);
        let above: f64 = tensor[(i, j)];
        tensor[(j, i)] = above.next_up();
        let stored = Inertia::try_from(tensor).unwrap().matrix();
        assert_eq!(stored, stored.transpose(), "({i}, {j})");
        assert!((above..=above.next_up()).contains(&stored[(i, j)]));
    }
}
