//! The tensor: the angle between spin and momentum against exact arithmetic, parallel axes, turning.

use super::any_tensor;
use crate::common::*;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use num_traits::Signed;
use proptest::prelude::*;
use tumbling::solid::Compound;
use tumbling::{Body, ErrorKind, Inertia, MassProperties, PrincipalMoments};

/// The angle of the very numbers given, with no rounding before the last step.
fn exact_angle(inertia: &Inertia, omega: &Vector3<f64>) -> f64 {
    let w = exact_vector(omega);
    let l = times(&exact_matrix(&inertia.matrix()), &w);
    let c = cross(&w, &l);
    // tan² of the angle is rational; its root is taken after rounding.
    let tangent_squared = dot(&c, &c) / (dot(&w, &l) * dot(&w, &l));
    rounded(&tangent_squared).sqrt().atan()
}

/// Eight roundings on the way (three components, a length, a dot product, the angle; root and angle of the
/// truth), each of half a unit in the last place at most.
const ANGLE_MARGIN: f64 = 4.0 * f64::EPSILON;

proptest! {
    // Along an axis as the library finds it the angle is rounding; tilt by 1e-12 and it must still be right.
    #[test]
    fn the_angle_is_right_to_its_last_digits_far_from_the_principal_axes_and_a_hair_off_one(
        inertia in any_tensor(), off in vector(1.0), exponent in prop_oneof![Just(1), -14..0_i32],
        axis in 0..3_usize, size in -150..150_i32,
    ) {
        let along = inertia.principal().frame().column(axis).into_owned();
        let omega = (along + off * 10_f64.powi(exponent)) * 10_f64.powi(size);
        let (ours, truth) = (inertia.angle_to_momentum(&omega).unwrap(), exact_angle(&inertia, &omega));
        prop_assert!((ours - truth).abs() <= ANGLE_MARGIN * truth, "{ours:e} {truth:e}");
    }

    #[test]
    fn turning_to_the_world_keeps_the_moments_and_carries_momentum_along(
        inertia in any_tensor(), q in attitude(), omega in vector(2.0),
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
    fn the_moment_about_an_axis_does_not_depend_on_the_axis_vectors_length(inertia in any_tensor(), axis in vector(1.0)) {
        let moment = inertia.about_axis(&axis).unwrap();
        for factor in [1e-300, 1e-10, 1e300] {
            prop_assert!((inertia.about_axis(&(axis * factor)).unwrap() - moment).abs() < 1e-14);
        }
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
fn along_a_turned_rod_there_is_no_momentum_and_so_no_angle() {
    let q = UnitQuaternion::from_euler_angles(0.5, -0.6, 2.7);
    let rod = Inertia::from_moments(1.0, 1.0, 0.0).unwrap().turned(q).unwrap();
    refused(
        rod.angle_to_momentum(&(q * Vector3::z())),
        ErrorKind::Undefined,
        "the angular momentum is the zero vector",
    );
    // A needle of 1e-12 is no rod: along itself it has momentum, and the angle is small.
    let needle = Inertia::from_moments(1.0, 1.0, 1e-12).unwrap();
    assert_eq!(needle.angle_to_momentum(&Vector3::z()).unwrap(), 0.0);
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
fn a_spin_without_direction_has_no_angle() {
    let tensor = Inertia::from_moments(1.0, 2.0, 2.5).unwrap();
    refused(tensor.angle_to_momentum(&Vector3::zeros()), ErrorKind::Undefined, "the spin is the zero vector");
    refused(tensor.about_axis(&Vector3::zeros()), ErrorKind::Undefined, "the axis is the zero vector");
    assert!(exact(tensor.angle_to_momentum(&Vector3::new(1.0, 5e-324, 0.0)).unwrap()).is_positive());
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

/// Bodies of all shapes: solid, flat, needles, of all sizes.
fn body_of_any_shape() -> impl Strategy<Value = Inertia> {
    let flat = prop_oneof![Just(0.0), Just(1e-9), 0.0..1.0_f64];
    (flat, 0.001..1.0_f64, 0.001..1.0_f64, -60..60_i32).prop_map(|(a, b, c, scale)| {
        let [a, b, c] = [a, b, c].map(|x| x * 10_f64.powi(scale));
        Inertia::from_moments(b + c, a + c, a + b).unwrap()
    })
}

/// Whether the checked constructor takes the result of another function.
fn holds(tensor: Inertia) -> Result<(), TestCaseError> {
    prop_assert_eq!(Inertia::try_from(tensor.matrix()).map_err(|e| e.to_string()), Ok(tensor));
    if let Ok(moments) = PrincipalMoments::try_from(tensor.principal()) {
        prop_assert!(PrincipalMoments::try_from(moments.vector()).is_ok(), "{moments:?}");
        prop_assert!(Inertia::try_from(Inertia::from(moments).matrix()).is_ok(), "{moments:?}");
    }
    Ok(())
}

proptest! {
    #[test]
    fn every_tensor_that_is_returned_is_one_that_can_be_given(
        tensor in body_of_any_shape(), turns in prop::array::uniform2(attitude()), far in -3..12_i32,
        direction in prop::array::uniform3(-1.0..1.0_f64), mass in 0.01..100.0_f64,
    ) {
        let size = (tensor.matrix().amax() / mass).sqrt();
        let offset = Vector3::from(direction) * size * 10_f64.powi(far);
        let turned = tensor.turned(turns[0]).unwrap();
        holds(turned)?;
        holds(turned.turned(turns[1]).unwrap())?;
        let body = MassProperties::new(mass, &offset, turned).unwrap();
        holds(body.turned(turns[1]).unwrap().inertia())?;
        let about = body.about(&Vector3::zeros()).unwrap();
        holds(about)?;
        let pair = Compound::new().at(body, &-offset).at(body, &(offset * 0.7));
        holds(pair.properties().unwrap().inertia())?;
        if let Ok((nearest, _)) = Inertia::within(&(turned.matrix() * 1.001), 0.1) {
            holds(nearest)?;
        }
    }
}
