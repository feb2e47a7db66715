//! The exact motion against 40 digits, against mathematics, and to the ends of the number range.

use super::{ROUNDING, apart, motion, numbers};
use crate::common::*;
use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use proptest::strategy::ValueTree as _;
use serde_json::Value;
use tumbling::exact::{FreeMotion, Instant, Regime};
use tumbling::{Axis, Body, ErrorKind, Inertia, PrincipalMoments};

fn length(v: &[f64]) -> f64 {
    let scale = v.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
    scale * v.iter().map(|x| (x / scale) * (x / scale)).sum::<f64>().sqrt()
}

/// The worst errors of spin and attitude over a table, in roundings times the condition of the motion:
/// `plain` and `tight` are the table's condition numbers. Comparing with the table's `f64` costs at most half
/// a unit.
fn judge(table: &str) -> [(f64, String); 4] {
    let file: Value = serde_json::from_str(table).unwrap();
    let mut worst = [(); 4].map(|()| (0.0, String::new()));
    for case in file["cases"].as_array().unwrap() {
        let vector = |field: &str| Vector3::from_vec(numbers(&case[field]));
        let motion = free_motion(vector("inertia"), &vector("w0"));
        for (k, t) in numbers(&case["t"]).into_iter().enumerate() {
            let Instant { omega, attitude } = motion.at(t).unwrap();
            assert_eq!(motion.omega(t).unwrap(), omega);
            assert_eq!(motion.at(t).unwrap().attitude, attitude);
            let (w, q) = (numbers(&case["w"][k]), numbers(&case["q"][k]));
            let ours = [attitude.w, attitude.i, attitude.j, attitude.k];
            let off = |sign: f64| length(&[0, 1, 2, 3].map(|i| ours[i] - sign * q[i]));
            let spin = length(&[0, 1, 2].map(|i| omega[i] - w[i]));
            let spin = if length(&w) > 0.0 { spin / length(&w) } else { spin };
            let errors = [spin, off(1.0).min(off(-1.0))];
            for (i, (column, error)) in
                [("kappa_w", 0), ("kappa_q", 1), ("kappas_w", 0), ("kappas_q", 1)].into_iter().enumerate()
            {
                let kappa = case[column].as_array().map_or(1.0, |_| numbers(&case[column])[k]).max(1.0);
                let units = errors[error] / (kappa * ROUNDING);
                if units > worst[i].0 {
                    worst[i] = (units, format!("{} at {t:e}", case["name"]));
                }
            }
            // Exact to the rounding of the four squares' own computation here.
            assert!((length(&ours) - 1.0).abs() <= 4.0 * ROUNDING, "{} at {t:e}", case["name"]);
        }
    }
    worst
}

#[test]
fn the_table_of_40_digits_is_met_to_what_the_rounding_of_the_inputs_allows() {
    let worst = judge(include_str!("../data/free-motion.json"));
    assert!(worst.iter().all(|(units, _)| *units <= 8.0), "{worst:#?}");
}

#[test]
fn random_hard_motions_are_met_as_well() {
    let worst = judge(include_str!("../data/sweep.json"));
    assert!(worst.iter().all(|(units, _)| *units <= 8.0), "{worst:#?}");
}

proptest! {
    #[test]
    fn the_momentum_stays_where_it_is_in_the_world(m in moments(), omega in generic_spin(), t in -1e4..1e4_f64) {
        let at = free_motion(m, &omega).at(t).unwrap();
        let momentum = at.attitude * m.component_mul(&at.omega);
        let start = m.component_mul(&omega);
        // The direction is of the phase's doing only through the spin's: both carry errors of 1e4 turns.
        prop_assert!((momentum - start).norm() < 1e-11 * start.norm(), "{}", (momentum - start).norm());
        let energy = |w: &Vector3<f64>| m.component_mul(w).dot(w);
        prop_assert!((energy(&at.omega) / energy(&omega) - 1.0).abs() < 2e-14);
    }

    #[test]
    fn only_ratios_of_moments_matter_and_time_runs_with_the_spin(
        m in moments(), omega in generic_spin(), t in -20.0..20.0_f64, heavier in -600..500_i32, faster in -600..490_i32,
    ) {
        let (i, w) = (2_f64.powi(heavier), 2_f64.powi(faster));
        let at = free_motion(m, &omega).at(t).unwrap();
        let scaled = free_motion(m * i, &(omega * w)).at(t / w).unwrap();
        prop_assert_eq!(scaled.omega, at.omega * w);
        prop_assert_eq!(scaled.attitude, at.attitude);
    }
}

#[test]
fn what_no_body_can_do_is_named() {
    let new = |m: [f64; 3], w: [f64; 3]| FreeMotion::new(m.try_into()?, &w.into());
    let error = |m: [f64; 3], w: [f64; 3]| new(m, w).unwrap_err().to_string();
    assert!(error([1.0, 1.0, 1.0], [f64::NAN, 0.0, 0.0]).contains("the spin"));
    assert!(error([0.999e-100, 1.0, 1.0], [1.0, 0.5, 0.25]).contains("1e-100 of the largest moment"));
    assert!(new([1.001e-100, 1.0, 1.0], [1.0, 0.5, 0.25]).is_ok());
    assert!(error([1.0, 2.0, 2.5], [5e-324, 1e300, 0.0]).contains("the complementary modulus"));
    // It swings round to w3² + (2/3.75) w2² about the third axis (mathematics), more than can be written.
    assert!(error([1.0, 2.0, 2.5], [0.0, 1.7e308, 1.7e308]).contains("the greatest spin"));
}

/// A tensor given askew has each entry rounded relative to the largest moment, and the smallest moment of a
/// needle with it: what the documentation of `FreeMotion::of` says.
#[test]
fn a_needle_given_askew_is_known_to_a_few_roundings_over_its_thinness() {
    let mut random = proptest::test_runner::TestRunner::deterministic();
    let mut value = |range: std::ops::Range<f64>| range.new_tree(&mut random).unwrap().current();
    for thin in [1e-6, 1e-12] {
        let mut worst = [0.0_f64; 2];
        for _ in 0..200 {
            let m = Vector3::new(thin, 1.0, 1.0 + 0.4 * thin);
            let turned =
                UnitQuaternion::from_euler_angles(value(0.0..6.0), value(-1.5..1.5), value(0.0..6.0));
            let omega = Vector3::from_fn(|_, _| value(-0.5..0.5));
            let inertia = Inertia::from_moments(m.x, m.y, m.z).unwrap().turned(turned).unwrap();
            let body = Body::spinning(inertia, turned.inverse(), &(turned * omega)).unwrap();
            let askew = FreeMotion::of(&body).unwrap();
            let t = value(0.0..3.0);
            let (at, plain) = (askew.at(t).unwrap(), free_motion(m, &omega).at(t).unwrap());
            let spin = (at.omega - turned * plain.omega).norm() / omega.norm();
            let attitude = apart(&at.attitude, &(plain.attitude * turned.inverse()));
            worst = [
                worst[0].max((inertia.principal().moments().min() / thin - 1.0).abs()),
                worst[1].max(spin.max(attitude)),
            ];
        }
        let unit = 0.5 * f64::EPSILON / thin;
        assert!(worst[0] < 4.0 * unit && worst[1] < 8.0 * unit, "{thin:e}: {worst:?}");
        // The error is not smaller either: the sentence in the documentation is not an arbitrary bound.
        assert!(worst[0] > unit && worst[1] > unit, "{thin:e}: {worst:?}");
    }
}

#[test]
fn a_spin_too_fast_to_be_turned_is_refused_and_none_comes_out_infinite() {
    // Along its principal axes a motion may reach the largest numbers; a turn of its axes needs room for a
    // sum of products.
    let principal = Vector3::new(1.1, 0.46, 1.05);
    let fast = Vector3::new(0.3, 1.1, -0.2) * 1e308;
    let along = motion(principal.into(), fast.into());
    assert!(along.omega(1e-309).unwrap().iter().all(|x| x.is_finite()));
    let axes = UnitQuaternion::from_euler_angles(0.3, -0.4, 0.9);
    let leaning = Inertia::from_moments(principal.x, principal.y, principal.z).unwrap().turned(axes).unwrap();
    let body = Body::spinning(leaning, UnitQuaternion::identity(), &fast).unwrap();
    refused(FreeMotion::of(&body), ErrorKind::Unrepresentable, "the greatest spin");
    let slower = Body::spinning(leaning, UnitQuaternion::identity(), &(fast * 0.05)).unwrap();
    assert!(FreeMotion::of(&slower).unwrap().omega(1e-307).unwrap().iter().all(|x| x.is_finite()));
    let sphere = PrincipalMoments::new(1.0, 1.0, 1.0).unwrap();
    let speed = FreeMotion::new(sphere, &Vector3::new(-1.4e308, 1.5e308, 0.0));
    refused(speed, ErrorKind::Unrepresentable, "the greatest spin");
}

#[test]
fn a_top_that_precesses_faster_than_any_number_is_refused() {
    let moments = PrincipalMoments::new(1.0, 1.5, 1.0).unwrap();
    let spin = Vector3::new(1.42e308, -8.1e307, 0.0);
    refused(FreeMotion::new(moments, &spin), ErrorKind::Unrepresentable, "the greatest spin");
    let slower = free_motion(moments, &(spin * 0.9)).regime();
    let Regime::SymmetricTop { precession, nutation, .. } = slower else { panic!("{slower:?}") };
    assert!(precession.is_finite() && nutation.is_finite(), "{slower:?}");
}

#[test]
fn the_least_angle_to_the_momentum_is_never_above_the_greatest() {
    // Two nearly equal moments: the angle of the third axis hardly changes, and each end of it is rounded on
    // its own.
    let moments = [1.5463115524768785, 0.15793951781592125, 1.546311552476878];
    let motion = motion(moments, [2.9443699667069355e-12, 0.008461038541345722, 2.337619889869514e-12]);
    for axis in Axis::ALL {
        let [least, most] = motion.angles_to_momentum(axis).unwrap();
        assert!(least <= most, "{axis:?}: {least:?} {most:?}");
    }
}
