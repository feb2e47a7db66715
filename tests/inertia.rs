//! The tensor against exact arithmetic, and what it refuses.

mod common;

use common::*;
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use num_traits::Signed;
use proptest::prelude::*;
use tumbling::{Body, ErrorKind, Inertia, MassProperties, PrincipalMoments, State};

fn tensor() -> impl Strategy<Value = Inertia> {
    (moments(), attitude())
        .prop_map(|(m, q)| Inertia::from_moments(m.x, m.y, m.z).unwrap().turned(q).unwrap())
}

/// The gap of the very numbers given, with no rounding before the last step.
fn exact_gap(inertia: &Inertia, omega: &Vector3<f64>) -> f64 {
    let w = exact_vector(omega);
    let l = times(&exact_matrix(&inertia.matrix()), &w);
    let c = cross(&w, &l);
    // tan² of the gap is rational; its root is taken after rounding.
    let tangent_squared = dot(&c, &c) / (dot(&w, &l) * dot(&w, &l));
    rounded(&tangent_squared).sqrt().atan()
}

/// Eight roundings on the way (three components, a length, a dot product, the angle; root and angle of the
/// truth), each of half a unit in the last place at most.
const GAP_MARGIN: f64 = 4.0 * f64::EPSILON;

/// The tensor about a point `offset` from the centre of a body of this mass.
fn about(inertia: Inertia, mass: f64, offset: &Vector3<f64>) -> Result<Inertia, tumbling::Error> {
    MassProperties::new(mass, &Vector3::zeros(), inertia)?.about(offset)
}

proptest! {
    #[test]
    fn the_gap_is_right_to_its_last_digits_for_any_spin(inertia in tensor(), omega in vector(3.0)) {
        let (ours, truth) = (inertia.angle_to_momentum(&omega).unwrap(), exact_gap(&inertia, &omega));
        prop_assert!((ours - truth).abs() <= GAP_MARGIN * truth, "{ours:e} {truth:e}");
    }

    // Along an axis as the library finds it the gap is rounding; tilt by 1e-12 and it must still be right.
    #[test]
    fn the_gap_is_right_to_its_last_digits_a_hair_off_a_principal_axis(
        inertia in tensor(), hair in vector(1.0), exponent in -14..-3_i32, axis in 0..3_usize, size in -150..150_i32,
    ) {
        let along = inertia.principal().frame().column(axis).into_owned();
        let omega = (along + hair * 10_f64.powi(exponent)) * 10_f64.powi(size);
        let (ours, truth) = (inertia.angle_to_momentum(&omega).unwrap(), exact_gap(&inertia, &omega));
        prop_assert!((ours - truth).abs() <= GAP_MARGIN * truth, "{ours:e} {truth:e}");
    }

    #[test]
    fn the_inverse_is_the_exact_inverse_of_the_matrix_given(inertia in tensor()) {
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

    #[test]
    fn a_needles_inverse_is_right_however_the_needle_lies(q in attitude(), thin in -11.0..0.0_f64) {
        let needle = Inertia::from_moments(10_f64.powf(thin), 1.0, 1.0).unwrap().turned(q).unwrap();
        let m = exact_matrix(&needle.matrix());
        let det = determinant(&m);
        let inverse = needle.inverse().unwrap();
        let c = cross(&m[1], &m[2]);
        let truth = rounded(&(c[0].clone() / det));
        prop_assert!((inverse[(0, 0)] - truth).abs() <= 3.0 * ulp(inverse.amax()));
    }

    #[test]
    fn parallel_axes_there_and_back_is_the_same_tensor(
        inertia in tensor(), mass in 0.1..3.0_f64, offset in vector(2.0),
    ) {
        let there = about(inertia, mass, &offset).unwrap();
        let back = there.shifted_to_centre(mass, &offset).unwrap();
        prop_assert!((back.matrix() - inertia.matrix()).amax() <= 8.0 * ulp(there.matrix().amax()));
        // Away from the centre every moment is larger, by mass times squared distance from the axis.
        let axis = Vector3::new(1.0, -2.0, 0.5);
        let n = axis.normalize();
        let more = there.about_axis(&axis).unwrap() - inertia.about_axis(&axis).unwrap();
        prop_assert!((more - mass * offset.cross(&n).norm_squared()).abs() < 1e-13);
    }

    #[test]
    fn turning_to_the_world_keeps_the_moments_and_carries_momentum_along(
        inertia in tensor(), q in attitude(), omega in vector(2.0),
    ) {
        let world = inertia.turned(q).unwrap();
        let before = inertia.principal().moments();
        prop_assert!((world.principal().moments() - before).amax() < 1e-14);
        prop_assert!((world.momentum(&(q * omega)) - q * inertia.momentum(&omega)).norm() < 1e-14);
        let r = q.to_rotation_matrix().into_inner();
        let inverse = tumbling::inertia::turned(&r, &inertia.inverse().unwrap());
        prop_assert!((inverse * world.momentum(&omega) - omega).norm() < 1e-12);
    }

    #[test]
    fn the_moment_about_an_axis_does_not_depend_on_the_axis_vectors_length(inertia in tensor(), axis in vector(1.0)) {
        let moment = inertia.about_axis(&axis).unwrap();
        for factor in [1e-300, 1e-10, 1e300] {
            prop_assert!((inertia.about_axis(&(axis * factor)).unwrap() - moment).abs() < 1e-14);
        }
    }

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
    fn no_public_function_panics_on_anything(
        m in any_vector(), p in any_vector(), v in any_vector(), w in any_vector(), mass in anything(),
        q in (anything(), anything(), anything(), anything()), e in anything(),
    ) {
        let attitude = UnitQuaternion::new_unchecked(Quaternion::new(q.0, q.1, q.2, q.3));
        let whole = Matrix3::new(m.x, p.x, p.y, p.x, m.y, p.z, p.y, e, m.z);
        let _ = Inertia::try_from(whole);
        let sane = Inertia::from_moments(1.0, 2.0, 2.5);
        for inertia in [Inertia::new(m.into(), p.into()), Inertia::from_moments(m.x, m.y, m.z), sane].into_iter().flatten() {
            let _ = (inertia.angle_to_momentum(&v), inertia.about_axis(&v), inertia.momentum(&v), inertia.principal().frame());
            let _ = (about(inertia, mass, &v), inertia.shifted_to_centre(mass, &v), inertia.turned(attitude));
            let _ = inertia.inverse();
            for body in [
                Body::new(inertia, attitude, &v),
                Body::spinning(inertia, attitude, &v),
                Body::spinning(inertia, UnitQuaternion::identity(), &v),
            ].into_iter().flatten() {
                let _ = (body.energy(), body.omega_body(), body.omega_world(), body.momentum_body());
                let _ = body.with_state(&State { attitude: attitude.into_inner(), momentum: w });
                for engine in tumbling::step::Engine::ALL {
                    let _ = engine.run(&body, mass, 3);
                }
            }
        }
        if let Ok(moments) = PrincipalMoments::try_from(m) {
            let _ = tumbling::exact::time_between_flips(moments, &v);
            for axis in tumbling::Axis::ALL {
                let _ = tumbling::dynamics::stability::of_spin(moments, axis, mass);
            }
        }
        let _ = tumbling::dynamics::observe::sign_changes([(m.x, v.x), (m.y, v.y), (m.z, v.z)]);
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
fn real_violators_of_the_triangle_inequality_are_refused_with_the_margin() {
    // The first is from a robot's model file, refused by a simulator; the last two differ by little or much.
    for (moments, excess) in [
        ([1.486e-6, 2e-7, 8.31e-7], 1.486e-6 - 2e-7 - 8.31e-7),
        ([1.11, 100.11, 1.01], 97.99),
        ([1.0, 2.0, 3.0 + 1e-9], 1e-9),
    ] {
        let error = Inertia::from_moments(moments[0], moments[1], moments[2]).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::Impossible);
        let mut named = moments;
        named.sort_by(f64::total_cmp);
        let [a, b, largest] = named;
        let found = number_after(&error, "fails by ");
        assert!((found - excess).abs() < 1e-15 * excess.max(1.0), "{found} {excess}");
        assert!(number_after(&error, "rounding (") < 1e-13 * largest);
        assert!(error.to_string().contains(&format!("moments {a}, {b}, {largest}")), "{error}");
    }
}

#[test]
fn what_rounding_alone_breaks_is_let_through() {
    for moments in [[1e-12, 1.0, 1.0 + 1e-12], [0.3, 0.7, 1.0], [0.1, 0.2, 0.3]] {
        assert!(Inertia::from_moments(moments[0], moments[1], moments[2]).is_ok(), "{moments:?}");
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
fn an_ideal_rod_has_no_inverse_but_a_thin_one_has() {
    let rod = Inertia::from_moments(1.0, 1.0, 0.0).unwrap();
    refused(rod.inverse(), ErrorKind::NotInvertible, "moment, 0.0, is zero relative to the largest, 1.0");
    let askew = rod.turned(UnitQuaternion::from_euler_angles(0.5, 0.6, 0.7)).unwrap();
    refused(askew.inverse(), ErrorKind::NotInvertible, "momentum does not determine spin");
    let thin = Inertia::from_moments(1.0, 1.0, 1e-30).unwrap();
    assert_eq!(thin.inverse().unwrap().m33, 1.0 / 1e-30);
    let tiny = Inertia::from_moments(1e-310, 1e-310, 1e-310).unwrap();
    refused(tiny.inverse(), ErrorKind::Unrepresentable, "an inverse moment comes out as inf");
}

#[test]
fn the_inverse_of_a_tensor_times_the_tensor_is_one_over_the_whole_range_of_scales() {
    let q = UnitQuaternion::from_euler_angles(0.5, -0.6, 2.7);
    for scale in [1e-200, 1e-100, 1.0, 1e150] {
        let tensor = Inertia::from_moments(0.5 * scale, 0.9 * scale, 1.2 * scale).unwrap().turned(q).unwrap();
        let one = tensor.inverse().unwrap() * tensor.matrix();
        assert!((one - Matrix3::identity()).amax() < 4e-15, "{scale:e}");
    }
}

#[test]
fn turning_at_the_end_of_the_range_is_finite_or_refused() {
    let q = UnitQuaternion::from_euler_angles(0.5, -0.6, 2.7);
    for scale in [1e-320, 1e-308, 1e307, 1.5e308] {
        let Ok(inertia) = Inertia::from_moments(scale, scale, 1.1 * scale) else {
            panic!("a body at {scale:e}")
        };
        match inertia.turned(q) {
            Ok(turned) => assert!(turned.matrix().iter().all(|x| x.is_finite()), "{scale:e}"),
            Err(error) => assert_eq!(error.kind(), ErrorKind::Unrepresentable, "{error}"),
        }
    }
}

#[test]
fn flat_and_thin_bodies_come_back_from_a_far_point_where_the_rounding_is_that_of_the_far_tensor() {
    for q in [UnitQuaternion::identity(), UnitQuaternion::from_euler_angles(0.5, -0.6, 2.7)] {
        for (ix, iy) in [(0.1369 / 12.0, 0.01 / 12.0), (0.2, 1e-9), (0.3, 0.0)] {
            let body = Inertia::from_moments(ix, iy, ix + iy).unwrap().turned(q).unwrap();
            for offset in [Vector3::new(0.0, 0.0, 1.0), Vector3::new(3.0, -2.0, 0.5)] {
                let far = about(body, 1.0, &offset).unwrap();
                let back = far.shifted_to_centre(1.0, &offset).unwrap();
                assert!((back.matrix() - body.matrix()).amax() <= 8.0 * ulp(far.matrix().amax()));
            }
        }
    }
}

#[test]
fn a_tensor_about_a_point_too_far_from_the_centre_is_refused_for_that_distance() {
    let near = Inertia::from_moments(1.0, 1.0, 1.0).unwrap();
    let cases = [
        (near, Vector3::new(1.0, 1.0, 0.0), "1.0 kg with its centre of mass 1.4142135623730951 m away"),
        (near, Vector3::new(1e200, 0.0, 0.0), "1.0 kg with its centre of mass 1e200 m away"),
        // Of a point mass nothing is left about its centre: zero exactly, which is not beyond what f64 holds.
        (
            Inertia::from_moments(0.0, 1.0, 1.0).unwrap(),
            Vector3::x(),
            "about that centre, the largest moment of inertia is 0.0",
        ),
    ];
    for (tensor, offset, words) in cases {
        refused(tensor.shifted_to_centre(1.0, &offset), ErrorKind::Impossible, words);
    }
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
fn along_a_turned_rod_there_is_no_momentum_and_so_no_gap() {
    let q = UnitQuaternion::from_euler_angles(0.5, -0.6, 2.7);
    let rod = Inertia::from_moments(1.0, 1.0, 0.0).unwrap().turned(q).unwrap();
    refused(
        rod.angle_to_momentum(&(q * Vector3::z())),
        ErrorKind::Undefined,
        "the angular momentum is the zero vector",
    );
    // A needle of 1e-12 is no rod: along itself it has momentum, and the gap is small.
    let needle = Inertia::from_moments(1.0, 1.0, 1e-12).unwrap();
    assert_eq!(needle.angle_to_momentum(&Vector3::z()).unwrap(), 0.0);
}

#[test]
fn a_body_whose_spin_or_momentum_leaves_the_range_is_refused() {
    let light = Inertia::from_moments(1e-200, 1.2e-200, 1.5e-200).unwrap();
    let upright = UnitQuaternion::identity();
    let askew = UnitQuaternion::from_euler_angles(0.5, -0.6, 2.7);
    for inertia in [light, light.turned(askew).unwrap()] {
        let heavy = Body::new(inertia, upright, &Vector3::new(1e150, -1e150, 1e150));
        refused(heavy, ErrorKind::Unrepresentable, "the spin comes out as");
        let still = Body::spinning(inertia, upright, &Vector3::new(1e-130, 0.0, 0.0));
        refused(still, ErrorKind::Unrepresentable, "the angular momentum comes out as 0.0");
    }
}

#[test]
fn an_attitude_that_has_drifted_turns_as_its_direction_says_and_one_far_off_is_refused() {
    let tensor = Inertia::from_moments(1.0, 2.0, 2.5).unwrap();
    let (true_one, omega) = (UnitQuaternion::from_euler_angles(0.4, 0.3, -1.0), Vector3::new(1.0, 1.0, 0.0));
    let stretched = |by: f64| UnitQuaternion::new_unchecked(true_one.into_inner() * by);
    let body = Body::spinning(tensor, stretched(1.0 + 9e-10), &omega).unwrap();
    // To the rounding of a turn there and back; without it the stretch itself would show, at 4e-9.
    assert!((body.energy() - 1.5).abs() < 5e-15 && (body.omega_body() - omega).norm() < 5e-15);
    let run = tumbling::step::Engine::Turned.run(&body, 0.01, 1).unwrap();
    assert!((run[0].energy() - 1.5).abs() < 5e-15);
    for by in [1.0 + 2e-9, 1.0 - 2e-9, 0.5, 0.0] {
        let body = Body::spinning(tensor, stretched(by), &omega);
        refused(body, ErrorKind::OutOfBounds, "it must be 1 to within 1e-9");
    }
}

#[test]
fn a_spin_without_direction_has_no_gap() {
    let tensor = Inertia::from_moments(1.0, 2.0, 2.5).unwrap();
    refused(tensor.angle_to_momentum(&Vector3::zeros()), ErrorKind::Undefined, "the spin is the zero vector");
    refused(tensor.about_axis(&Vector3::zeros()), ErrorKind::Undefined, "the axis is the zero vector");
    let rod = Inertia::from_moments(1.0, 1.0, 0.0).unwrap();
    refused(
        rod.angle_to_momentum(&Vector3::z()),
        ErrorKind::Undefined,
        "the angular momentum is the zero vector",
    );
    assert!(exact(tensor.angle_to_momentum(&Vector3::new(1.0, 5e-324, 0.0)).unwrap()).is_positive());
}

// A tensor that is known to a unit in the last place of its largest moment has no smallest moment below that.
#[test]
fn a_turned_tensor_is_singular_within_two_units_in_the_last_place_and_not_beyond() {
    // One moment of 1 along z; in the plane across it 0.5 and 1.5, turned by 3-4-5: about as turned as can be.
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

#[test]
fn a_turned_rod_is_a_body_though_rounding_puts_its_smallest_moment_below_zero() {
    let mut below = 0;
    for i in 0..400 {
        let q = UnitQuaternion::from_euler_angles(
            0.1 + 0.37 * f64::from(i),
            1.3 * f64::from(i),
            -0.7 * f64::from(i),
        );
        let r = q.to_rotation_matrix().into_inner();
        let tensor = r * Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 0.0)) * r.transpose();
        let rod = Inertia::try_from(tensor);
        assert!(rod.is_ok(), "{i}: {rod:?}");
        below += usize::from(rod.unwrap().principal().moments()[0] < 0.0);
    }
    assert!(below > 0, "no turned rod fell below zero");
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

#[test]
fn a_needles_tensor_turned_by_half_a_turn_is_a_body_though_an_entry_is_a_rounding_below_zero() {
    let mut below = 0;
    for i in 0..400 {
        // Half a turn about the line between the needle and x lays the needle along x, where its moment is the rounding of terms of size 1.
        let q = UnitQuaternion::from_euler_angles(0.0, 0.7 * f64::from(i), 0.37 * f64::from(i));
        let needle = Inertia::from_moments(0.0, 1.0, 1.0).unwrap().turned(q).unwrap().matrix();
        let between = nalgebra::Unit::new_normalize(q * Vector3::x() + Vector3::x());
        let half = UnitQuaternion::from_axis_angle(&between, std::f64::consts::PI).to_rotation_matrix();
        let turned = half.matrix() * needle * half.matrix().transpose();
        below += usize::from(turned.diagonal().min() < 0.0);
        let body = Inertia::try_from(turned);
        assert!(body.is_ok(), "{turned:e}: {body:?}");
    }
    assert!(below > 0, "no entry came out below zero");
    // What was given on the diagonal and below zero was not computed, and is refused.
    refused(Inertia::from_moments(-1e-17, 1.0, 1.0), ErrorKind::Impossible, "the moment Ixx is -1e-17");
}

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
        let nearest = Inertia::within(&given, 1e-3).unwrap();
        assert!((nearest.moved / moved - 1.0).abs() < 1e-6, "{:e}, not {moved:e}", nearest.moved);
        // A third of the excess on each moment: the foot of the perpendicular on the plane of the flat bodies.
        let change = (nearest.value.matrix() - given).diagonal();
        assert!(change.iter().all(|x| (x.abs() / (excess / 3.0) - 1.0).abs() < 1e-6), "{change:e}");
        refused(
            Inertia::within(&given, 0.9 * moved),
            ErrorKind::Impossible,
            "of the largest moment away, more than the tolerance",
        );
        let again = Inertia::within(&nearest.value.matrix(), 0.0).unwrap();
        assert_eq!((again.value, again.moved), (nearest.value, 0.0));
    }
    // By a large margin the digits are not to blame, and the message does not say so.
    let error = Inertia::from_moments(1.0, 2.0, 3.5).unwrap_err();
    assert!(!error.to_string().contains("within"), "{error}");
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

#[test]
fn the_energy_of_a_body_whose_products_leave_the_range_is_infinite_or_right_but_never_nan() {
    let tensor = Inertia::new([0.9, 0.9, 1.2], [0.4, -0.2, 0.2]).unwrap();
    let omega = Vector3::new(1e155, -2e154, 5e154);
    let body = Body::spinning(tensor, UnitQuaternion::identity(), &omega).unwrap();
    assert_eq!(body.energy(), f64::INFINITY);
    // The terms w_i L_i are 2.4e308 and -1.6e308, the energy is half of their sum.
    let tensor = Inertia::new([1.0, 0.25, 1.245], [0.49, 0.0, 0.0]).unwrap();
    let body =
        Body::spinning(tensor, UnitQuaternion::identity(), &Vector3::new(3e154, -4.5e154, 0.0)).unwrap();
    let expected = 0.5 * 0.0925 * 9.0;
    assert!((body.energy() / 1e308 - expected).abs() < 1e-13, "{:e}", body.energy());
}

#[test]
fn zeros_of_a_tensor_its_inverse_and_its_axes_have_no_sign() {
    let signed = |m: &Matrix3<f64>| m.iter().any(|x| *x == 0.0 && x.is_sign_negative());
    let half = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), std::f64::consts::PI);
    for (moments, products) in [
        ([2.0, 3.0, 4.0], [-0.0, -0.0, -0.0]),
        ([2.0, 3.0, 4.0], [-0.5, 0.0, 0.0]),
        ([2.0, 3.0, 4.0], [0.0, -0.5, 0.0]),
        ([4.0, 3.0, 2.0], [0.0, 0.0, -0.5]),
        ([-0.0, 1.0, 1.0], [0.0; 3]),
    ] {
        let tensor = Inertia::new(moments, products).unwrap();
        for tensor in [tensor, tensor.turned(half).unwrap()] {
            assert!(!signed(&tensor.matrix()), "{:?}", tensor.matrix());
            assert!(!signed(&tensor.principal().frame()), "{:?}", tensor.principal().frame());
            if let Ok(inverse) = tensor.inverse() {
                assert!(!signed(&inverse), "{inverse:?}");
            }
        }
    }
}

proptest! {
    /// The tensors of bodies are a convex cone: the nearest one `p` to `s` has `(s - p) . p = 0` and `(s - p) . b <= 0` for every body `b`.
    #[test]
    fn the_nearest_tensor_meets_the_conditions_of_a_projection_onto_the_cone_of_bodies(
        six in prop::array::uniform9(-1.0..1.0_f64), scale in -200..150_i32, bodies in prop::collection::vec(tensor(), 8),
    ) {
        let size = 10_f64.powi(scale);
        // Rows that differ from columns too: the antisymmetric part is across every body's tensor.
        let given = (Matrix3::from_row_slice(&six) + Matrix3::identity()) * size;
        if let Ok(nearest) = Inertia::within(&given, 10.0) {
            let (p, s) = (nearest.value.matrix() / size, given / size);
            let off = s - p;
            let largest = ((s + s.transpose()) * 0.5).symmetric_eigenvalues().max();
            prop_assert!((nearest.moved - off.norm() / largest).abs() <= 1e-14 * (1.0 + nearest.moved));
            prop_assert!(off.dot(&p).abs() <= 1e-13, "{:e}", off.dot(&p));
            for body in &bodies {
                prop_assert!(off.dot(&body.matrix()) <= 1e-13, "{:e}", off.dot(&body.matrix()));
            }
            // The principal axes stay.
            let middle = (s + s.transpose()) * 0.5;
            prop_assert!((middle * p - p * middle).amax() <= 1e-14);
        }
    }
}

#[test]
fn a_leaning_tensor_is_moved_along_its_own_principal_axes_and_no_farther_than_its_moments() {
    // A panel with four printed digits, in axes that no turn of a coordinate axis gives.
    let axes = nalgebra::UnitQuaternion::from_euler_angles(0.3, -0.4, 0.9).to_rotation_matrix().into_inner();
    let printed = [0.003333, 0.01333, 0.01667];
    let leaning = |moments: Vector3<f64>| {
        let tensor = axes * Matrix3::from_diagonal(&moments) * axes.transpose();
        (tensor + tensor.transpose()) * 0.5
    };
    let along = tumbling::PrincipalMoments::within(printed, 1e-3).unwrap();
    let nearest = Inertia::within(&leaning(printed.into()), 1e-3).unwrap();
    let off = (nearest.value.matrix() - leaning(along.value.vector())).amax();
    assert!(off < 1e-15, "{off:e}");
    assert!((nearest.moved - along.moved).abs() < 1e-13, "{} {}", nearest.moved, along.moved);
}

#[test]
fn a_body_takes_its_own_state_up_to_the_largest_numbers() {
    let turn = UnitQuaternion::from_euler_angles(0.4, -1.1, 2.0);
    let inertia = Inertia::from_moments(1.0, 1.5, 2.0).unwrap();
    for tensor in [inertia, inertia.turned(UnitQuaternion::from_euler_angles(1.0, 0.2, -0.5)).unwrap()] {
        for momentum in [Vector3::new(f64::MAX, 0.0, 0.0), Vector3::new(1.0, 0.9, -1.1) * 1e308] {
            for size in [1.0, 1.0 - 1e-11, 0.5] {
                let Ok(body) = Body::new(tensor, turn, &(momentum * size)) else { continue };
                let same = body.with_state(&body.state()).unwrap();
                let off = (same.momentum_world() * 0.25 - body.momentum_world() * 0.25).amax();
                assert!(off <= 1e-15 * f64::MAX, "{off:e}");
                assert!(body.omega_world().iter().chain(&body.omega_body()).all(|x| x.is_finite()));
            }
        }
    }
    let nearly = Body::new(inertia, turn, &Vector3::new(0.999 * f64::MAX, 0.0, 0.0));
    assert!(nearly.is_ok(), "{nearly:?}");
}
