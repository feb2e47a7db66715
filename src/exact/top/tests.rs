//! The chosen numbers of the top, each from both sides.

use super::integrals::ROUNDINGS;
use super::mounted::{Mounted, ROUNDING};
use super::*;
use alloc::format;
use alloc::string::ToString as _;
use core::f64::consts::TAU;

#[test]
fn what_is_too_small_is_named_with_the_bound_and_its_square_still_has_all_digits() {
    let leaning = UnitQuaternion::new_unchecked(Quaternion::new(0.8, 0.6, 0.0, 0.0));
    let moments = PrincipalMoments::new(1.0, 1.0, 0.5).unwrap();
    // In units of a rate of 1 rad/s the pull is twice the weight.
    let top =
        |weight: f64| LagrangeTop::new(moments, leaning, &Vector3::new(0.3, 0.2, 1.0), &Vector3::z(), weight);
    assert!(top(0.51 * SMALLEST).is_ok());
    let refused = top(0.49 * SMALLEST).unwrap_err().to_string();
    assert!(refused.contains(&format!("at least {SMALLEST:e}")), "{refused}");
    const { assert!(SMALLEST * SMALLEST * f64::EPSILON > f64::MIN_POSITIVE) };
}

#[test]
fn moments_and_arm_may_be_off_by_what_is_documented() {
    let mounted = |apart: f64, off: f64| {
        let moments = PrincipalMoments::new(1.0, 1.0 + apart, 0.5).unwrap();
        Mounted::new(moments, &Vector3::new(off, 0.0, 1.0))
    };
    assert_eq!(format!("{ROUNDING:e}"), "1e-14");
    assert!(mounted(0.99 * ROUNDING, 0.0).is_ok() && mounted(0.0, 0.99 * ROUNDING).is_ok());
    assert!(mounted(1.02 * ROUNDING, 0.0).is_err() && mounted(0.0, 1.02 * ROUNDING).is_err());
}

/// Moments 1.3 and `polar`, a weight's torque of 0.7, at a lean and turned about vertical and axis, going
/// round at the slow or the fast one of the two steady rates, times `1 + push`.
fn started(polar: f64, lean: f64, spin: f64, fast: bool, push: f64) -> LagrangeTop {
    let (across, torque, momentum) = (1.3, 0.7, polar * spin);
    let root = (momentum * momentum - 4.0 * across * torque * lean.cos()).sqrt();
    let larger = momentum + root.copysign(momentum);
    let rate = if fast { larger / (2.0 * across * lean.cos()) } else { 2.0 * torque / larger };
    let about_axis = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.3 * lean);
    let leaning = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), lean);
    let about_vertical = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 1.1 + lean);
    // The vertical's part across the axis, in the body's axes.
    let up = about_axis.inverse() * Vector3::new(0.0, lean.sin(), 0.0);
    let omega = up * (rate * (1.0 + push)) + Vector3::new(0.0, 0.0, spin);
    let moments = PrincipalMoments::new(across, across, polar).unwrap();
    let attitude = about_vertical * leaning * about_axis;
    LagrangeTop::new(moments, attitude, &omega, &Vector3::z(), torque).unwrap()
}

#[test]
fn the_two_steady_rates_are_steady_to_rounding_and_a_thousand_roundings_nutate() {
    // A bound without a margin for rounding, and a bound that would accept a nutation.
    const { assert!(ROUNDINGS >= 13.0 && ROUNDINGS <= 24.0) };
    for polar in [0.11, 0.7, 2.3] {
        for lean in [0.02, 0.4, 0.9, 1.3, 2.2, 2.9] {
            for momentum in [2.2, -3.7, 41.0, -1e3, 1e6] {
                for fast in [false, true] {
                    let spin = momentum / polar;
                    let top = started(polar, lean, spin, fast, 0.0);
                    assert_eq!(
                        (top.regime(), top.period().unwrap()),
                        (TopRegime::SteadyPrecession, None),
                        "{polar} {lean} {momentum} {fast}"
                    );
                    for push in [1e3, -1e3] {
                        let top = started(polar, lean, spin, fast, push * 0.5 * f64::EPSILON);
                        assert_eq!(top.regime(), TopRegime::Nutation, "{polar} {lean} {momentum} {fast}");
                        assert!(top.period().unwrap().is_some_and(|period| period < TAU * 10.0));
                    }
                }
            }
        }
    }
}
