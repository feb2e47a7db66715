//! A body: its energy, spin and momentum in both frames, and what is refused.

mod named;

use crate::common::*;
use crate::inertia::about;
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::dynamics::observe;
use tumbling::{Body, ErrorKind, Inertia};

proptest! {
    #[test]
    fn energy_and_momentum_are_the_same_in_body_and_world(m in moments(), q in attitude(), omega in vector(2.0)) {
        let body = Body::spinning(Inertia::from_moments(m.x, m.y, m.z).unwrap(), q, &omega).unwrap();
        prop_assert!((body.omega_body() - omega).norm() < 1e-13);
        prop_assert!((body.omega_world() - q * omega).norm() < 1e-13);
        let in_world = observe::energy(&body.omega_world(), &body.momentum_world());
        let in_body = 0.5 * (m.x * omega.x * omega.x + m.y * omega.y * omega.y + m.z * omega.z * omega.z);
        prop_assert!((body.energy() - in_body).abs() < 1e-13 && (in_world - in_body).abs() < 1e-13);
    }
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
fn a_needles_tensor_turned_by_half_a_turn_is_a_body_though_an_entry_is_a_rounding_below_zero() {
    let mut below = 0;
    for i in 0..400 {
        // Half a turn about the line between the needle and x lays the needle along x, where its moment is
        // the rounding of terms of size 1.
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

proptest! {
    #[test]
    fn no_numbers_make_a_body_or_its_tensor_panic(
        m in any_vector(), p in any_vector(), v in any_vector(), mass in anything(),
        q in (anything(), anything(), anything(), anything()), e in anything(),
    ) {
        let attitude = UnitQuaternion::new_unchecked(Quaternion::new(q.0, q.1, q.2, q.3));
        let whole = Matrix3::new(m.x, p.x, p.y, p.x, m.y, p.z, p.y, e, m.z);
        let _ = Inertia::try_from(whole);
        let sane = Inertia::from_moments(1.0, 2.0, 2.5);
        for inertia in [Inertia::new(m.into(), p.into()), Inertia::from_moments(m.x, m.y, m.z), sane].into_iter().flatten() {
            let _ = (inertia.angle_to_momentum(&v), inertia.about_axis(&v), inertia.momentum(&v), inertia.principal().frame());
            let _ = (about(inertia, mass, &v), inertia.turned(attitude));
            let _ = inertia.inverse();
            for body in [
                Body::new(inertia, attitude, &v),
                Body::spinning(inertia, attitude, &v),
                Body::spinning(inertia, UnitQuaternion::identity(), &v),
            ].into_iter().flatten() {
                let _ = (body.energy(), body.omega_body(), body.omega_world(), body.momentum_body());
            }
        }
    }
}
