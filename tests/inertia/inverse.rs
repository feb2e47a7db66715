//! The inverse tensor against exact arithmetic, and the tensors that have none.

use super::any_tensor;
use crate::common::*;
use nalgebra::{Matrix3, UnitQuaternion};
use proptest::prelude::*;
use tumbling::{ErrorKind, Inertia};

proptest! {
    #[test]
    fn the_inverse_is_the_exact_inverse_of_the_matrix_given(
        any in any_tensor(), q in attitude(), thin in -11.0..0.0_f64, is_needle: bool, power in -660..500_i32,
    ) {
        let needle = || Inertia::from_moments(10_f64.powf(thin), 1.0, 1.0).unwrap().turned(q).unwrap();
        let inertia = if is_needle { needle() } else { any };
        let inertia = Inertia::try_from(inertia.matrix() * 2_f64.powi(power)).unwrap();
        let m = exact_matrix(&inertia.matrix());
        let det = determinant(&m);
        let inverse = inertia.inverse().unwrap();
        // Three roundings (cofactor, determinant, quotient), half a unit each of up to two ulps.
        let margin = 3.0 * ulp(inverse.amax());
        for i in 0..3 {
            for j in 0..3 {
                let c = cross(&m[(j + 1) % 3], &m[(j + 2) % 3]);
                let truth = rounded(&(c[i].clone() / det.clone()));
                prop_assert!((inverse[(i, j)] - truth).abs() <= margin, "({i},{j})");
            }
        }
    }

}

#[test]
fn an_ideal_rod_has_no_inverse_but_a_thin_one_has() {
    let rod = Inertia::from_moments(1.0, 1.0, 0.0).unwrap();
    refused(rod.inverse(), ErrorKind::NotInvertible, "moment, 0.0, is zero relative to the largest, 1.0");
    let askew = rod.turned(UnitQuaternion::from_euler_angles(0.5, 0.6, 0.7)).unwrap();
    refused(askew.inverse(), ErrorKind::NotInvertible, "momentum does not determine spin");
    let thin = Inertia::from_moments(1.0, 1.0, 1e-30).unwrap();
    assert_eq!(thin.inverse().unwrap().m33, 1.0 / 1e-30);
    // No scale is common to these: the smallest relative to the largest is below every f64.
    let far = Inertia::from_moments(1e300, 1e300, 1e-300).unwrap();
    assert_eq!(far.inverse().unwrap().diagonal(), nalgebra::Vector3::new(1e-300, 1e-300, 1.0 / 1e-300));
    assert_eq!(far.principal().moments(), nalgebra::Vector3::from([1e-300, 1e300, 1e300]));
    let tiny = Inertia::from_moments(1e-310, 1e-310, 1e-310).unwrap();
    refused(tiny.inverse(), ErrorKind::Unrepresentable, "an inverse moment comes out as inf");
}

// A tensor that is known to a unit in the last place of its largest moment has no smallest moment below that.
#[test]
fn a_turned_tensor_is_singular_within_two_units_in_the_last_place_and_not_beyond() {
    // One moment of 1 along z; in the plane across it 0.5 and 1.5, turned by 3-4-5: about as turned as can
    // be.
    let block = |small: f64| {
        // large (0.6, 0.8)(0.6, 0.8)^T + small (0.8, -0.6)(0.8, -0.6)^T
        let (xx, xy, yy) = (0.36 + 0.64 * small, 0.48 - 0.48 * small, 0.64 + 0.36 * small);
        Inertia::try_from(Matrix3::new(xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, 1.0)).unwrap()
    };
    for ulps in [20.0, 100.0, 400.0] {
        let inverse = block(ulps * f64::EPSILON).inverse();
        assert!(inverse.is_ok(), "{ulps}: {inverse:?}");
    }
    // Below half a unit of its entries the moment is what rounding left, above or below zero.
    let mut above = 0;
    for i in 0..400 {
        let q = UnitQuaternion::from_euler_angles(
            0.1 + 0.37 * f64::from(i),
            1.3 * f64::from(i),
            -0.7 * f64::from(i),
        );
        let rod = Inertia::from_moments(1.0, 1.0, 0.0).unwrap().turned(q).unwrap();
        let smallest = rod.principal().moments()[0];
        if smallest.abs() <= 2.0 * f64::EPSILON {
            refused(rod.inverse(), ErrorKind::NotInvertible, "is zero relative to the largest");
            above += usize::from(smallest > 0.0);
        }
    }
    assert!(above > 0, "no turned rod kept a moment above zero");
}
