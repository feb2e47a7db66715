//! Principal axes against exact arithmetic and against their own laws.

use crate::common::*;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::{Axis, Inertia};

/// The largest entry of `F diag(moments) F^T - tensor`, in units in the last place of the largest moment.
fn misfit(inertia: &Inertia) -> f64 {
    let axes = inertia.principal();
    let f = axes.frame();
    let back = f * Matrix3::from_diagonal(&axes.moments()) * f.transpose();
    (back - inertia.matrix()).amax() / ulp(axes.moments()[2])
}

/// Moments that differ by a few units in the last place up to about 1e-14.
fn nearly_equal() -> impl Strategy<Value = Vector3<f64>> {
    (0..200_u8, 0..200_u8).prop_map(|(a, b)| Vector3::new(0, a, b).map(|n| 1.0 + f64::from(n) * f64::EPSILON))
}

fn right_handed(frame: &Matrix3<f64>) -> bool {
    (frame.transpose() * frame - Matrix3::identity()).amax() < 4e-15
        && (frame.determinant() - 1.0).abs() < 4e-15
}

proptest! {
    // Exact: the characteristic polynomial, in rational numbers, changes sign within a few units in the last
    // place of each moment found, so a true eigenvalue of the given matrix lies there.
    #[test]
    fn each_principal_moment_brackets_an_exact_eigenvalue(moments in moments(), attitude in attitude()) {
        let mut sorted: [f64; 3] = moments.into();
        sorted.sort_by(f64::total_cmp);
        // Near-equal moments need no bracket (two roots may lie inside); the next tests see to them.
        prop_assume!(sorted[1] - sorted[0] > 1e-9 && sorted[2] - sorted[1] > 1e-9);
        let inertia = Inertia::try_from(turned(&moments, attitude)).unwrap();
        let matrix = exact_matrix(&inertia.matrix());
        let found = inertia.principal().moments();
        for moment in &found {
            let margin = 6.0 * ulp(found[2]);
            let below = characteristic(&matrix, &exact(moment - margin));
            let above = characteristic(&matrix, &exact(moment + margin));
            prop_assert!(below * above < crate::common::exact(0.0), "no eigenvalue near {moment}");
        }
    }

    #[test]
    fn the_frame_is_right_handed_and_gives_the_tensor_back(
        moments in prop_oneof![moments(), nearly_equal()], attitude in attitude(),
    ) {
        let inertia = Inertia::try_from(turned(&moments, attitude)).unwrap();
        prop_assert!(right_handed(&inertia.principal().frame()));
        prop_assert!(misfit(&inertia) < 24.0, "{} ulps", misfit(&inertia));
        let found = inertia.principal().moments();
        prop_assert!(found[0] <= found[1] && found[1] <= found[2]);
    }

    #[test]
    fn a_scale_by_a_power_of_two_changes_the_moments_by_it_and_the_frame_not_at_all(
        moments in moments(), attitude in attitude(), power in prop::sample::select(vec![-660, -60, 60, 495]),
    ) {
        let tensor = turned(&moments, attitude);
        let factor = 2_f64.powi(power);
        let (plain, scaled) =
            (Inertia::try_from(tensor).unwrap().principal(), Inertia::try_from(tensor * factor).unwrap().principal());
        prop_assert_eq!(plain.moments() * factor, scaled.moments());
        prop_assert_eq!(plain.frame(), scaled.frame());
    }

    #[test]
    fn a_diagonal_tensor_keeps_its_moments_bit_for_bit_and_its_own_axes(moments in moments()) {
        let axes = Inertia::from_moments(moments.x, moments.y, moments.z).unwrap().principal();
        for axis in Axis::ALL {
            let own = axes.axis(axis).map(f64::abs).imax();
            prop_assert_eq!(axes.axis(axis).amax(), 1.0);
            prop_assert_eq!(axes.moment(axis), moments[own]);
        }
    }

    // A symmetric top turned about its own axis is the same body: the frame must not follow the turn.
    #[test]
    fn a_symmetric_top_has_one_frame_however_it_is_turned_about_its_axis(
        across in 0.2..1.0_f64, along in 0.0..1.0_f64, tilt in attitude(), about in -3.0..3.0_f64, flat in any::<bool>(),
    ) {
        let own = if flat { across * (1.05 + 0.9 * along) } else { across * 0.9 * along };
        let moments = Vector3::new(across, across, own);
        let spin = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), about);
        let [one, other] = [tilt, tilt * spin].map(|q| Inertia::try_from(turned(&moments, q)).unwrap().principal());
        // A component at the very threshold of the sign rule may fall on either side of it.
        prop_assume!(one.frame().iter().all(|x| (x.abs() - 0.57).abs() > 1e-9));
        // The lone axis is known to rounding over the relative difference of the moments.
        let sensitivity = across.max(own) / (across - own).abs();
        prop_assert!((one.frame() - other.frame()).amax() < 1e-14 * sensitivity);
    }

    // The small moment of a tensor given in a graded frame is known to relative accuracy, and kept to it.
    #[test]
    fn a_needles_small_moment_keeps_its_relative_accuracy(
        small in -12.0..-1.0_f64, xy in -0.4..0.4_f64, xz in -0.4..0.4_f64, yz in -0.4..0.4_f64,
    ) {
        // D A D with D = diag(1, 1, thin): a needle leaning a little from z, its two large moments apart by
        // no more than the small one, as the triangle inequality demands.
        let thin = 10_f64.powf(small / 2.0);
        let xy = 0.2 * xy * thin * thin;
        let tensor = Matrix3::new(1.0, xy, xz * thin, xy, 1.0, yz * thin, xz * thin, yz * thin, thin * thin);
        let inertia = Inertia::try_from(tensor).unwrap();
        let matrix = exact_matrix(&tensor);
        let moment = inertia.principal().moment(Axis::Smallest);
        let below = characteristic(&matrix, &exact(moment * (1.0 - 4e-15)));
        let above = characteristic(&matrix, &exact(moment * (1.0 + 4e-15)));
        prop_assert!(below * above < exact(0.0), "{moment:e}");
    }
}

#[test]
fn a_sphere_has_the_bodys_own_axes() {
    let q = UnitQuaternion::from_euler_angles(0.4, -1.0, 2.2);
    let sphere = Inertia::try_from(turned(&Vector3::repeat(0.7), q)).unwrap();
    assert_eq!(sphere.principal().frame(), Matrix3::identity());
}

#[test]
fn a_turned_needle_and_an_ideal_rod_are_found_to_rounding_of_their_largest_moment() {
    let q = UnitQuaternion::from_euler_angles(0.3, 1.1, -2.0);
    for (thin, scale) in [(1e-12, 1e-200), (1e-12, 1.0), (1e-12, 1e150), (0.0, 2.0)] {
        let moments = Vector3::new(thin * scale, scale, scale);
        let axes = Inertia::try_from(turned(&moments, q)).unwrap().principal();
        assert!((axes.moment(Axis::Smallest) - thin * scale).abs() < 2e-15 * scale);
        let along = q * Vector3::x();
        assert!(axes.axis(Axis::Smallest).cross(&along).norm() < 1e-15);
    }
}

// [[1, p], [p, s]]: the smaller moment is s - p²/(1 - s) to first order. Beside the larger moment p is
// nothing; relative to their geometric mean it is a tenth, and drops the smaller moment by a hundredth.
#[test]
fn a_product_that_is_nothing_relative_to_the_large_moment_still_counts_for_the_small_one() {
    let (small, product) = (1e-34, 1e-18);
    let tensor = Matrix3::new(1.0, 0.0, product, 0.0, 1.0, 0.0, product, 0.0, small);
    let moment = Inertia::try_from(tensor).unwrap().principal().moment(Axis::Smallest);
    assert!((moment / 0.99e-34 - 1.0).abs() < 1e-14, "{moment:e}");
}

/// A tensor with the given moments about the columns of a rotation matrix.
fn along(moments: [f64; 3], axes: Matrix3<f64>) -> Inertia {
    Inertia::try_from(turned(&moments.into(), axes)).unwrap()
}

// (2, 3, 6)/7, (3, -6, 2)/7, (6, 2, -3)/7 are perpendicular and right-handed in this order.
const SEVENTHS: [[f64; 3]; 3] = [[2.0, 3.0, 6.0], [3.0, -6.0, 2.0], [6.0, 2.0, -3.0]];

fn seventh(i: usize) -> Vector3<f64> {
    Vector3::from(SEVENTHS[i]) / 7.0
}

#[test]
fn each_axis_points_so_that_its_first_large_component_is_positive() {
    let axes = Matrix3::from_columns(&[seventh(0), seventh(1), seventh(2)]);
    assert!((axes.determinant() - 1.0).abs() < 1e-15);
    let frame = along([0.8, 1.0, 1.3], axes).principal().frame();
    // Of (3, -6, 2)/7 the 6/7 is the first above 0.57, not the 3/7: the axis is (-3, 6, -2)/7.
    let expected = [seventh(0), -seventh(1), -seventh(2)];
    for (i, axis) in expected.iter().enumerate() {
        assert!((frame.column(i) - axis).amax() < 1e-14, "{frame}");
    }
}

// The body axis that leans least on the lone one, with what leans taken off, and the third to make a right
// hand.
#[test]
fn two_equal_moments_take_the_direction_nearest_the_axis_that_leans_least() {
    // The lone axis (6, 2, -3)/7 leans least on y; it comes first of two larger, last of two smaller.
    let lone = seventh(2);
    let axes = Matrix3::from_columns(&[seventh(0), seventh(1), lone]);
    let first = (Vector3::y() - lone * (2.0 / 7.0)).normalize();
    let second = lone.cross(&first);
    let two_large = along([1.0, 1.0, 0.4], axes).principal();
    let two_small = along([1.0, 1.0, 1.6], axes).principal();
    for (axes, expected) in [(two_large, [lone, first, second]), (two_small, [first, second, lone])] {
        for (i, axis) in expected.iter().enumerate() {
            assert!((axes.frame().column(i) - axis).amax() < 1e-14, "{}", axes.frame());
        }
        assert!(right_handed(&axes.frame()));
    }
}
