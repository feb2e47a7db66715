//! The kinds of free motion and their borders: spheres, tops, steady spins, the separatrix.

use super::{apart, distinct, motion};
use crate::common::*;
use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::Axis;
use tumbling::exact::Regime;

proptest! {
    // Neighbours on both sides of every border: a motion and one whose inputs differ by roundings.
    #[test]
    fn a_nearly_symmetric_body_moves_as_a_symmetric_one(
        c in 0.3..1.9_f64, omega in generic_spin(), t in -30.0..30.0_f64, power in 13..16_i32, axis in 0..3_usize,
    ) {
        let mut m = Vector3::repeat(1.0);
        m[axis] = c;
        let exact = free_motion(m, &omega).at(t).unwrap();
        m[(axis + 1) % 3] += 10_f64.powi(-power);
        let near = free_motion(m, &omega).at(t).unwrap();
        let bound = 1e3 * 10_f64.powi(-power);
        prop_assert!((near.omega - exact.omega).norm() < bound && apart(&near.attitude, &exact.attitude) < bound);
    }

    #[test]
    fn a_nearly_spherical_body_spins_as_a_sphere(omega in generic_spin(), t in -30.0..30.0_f64, a in 0..40_u32, b in 0..40_u32) {
        let step = |n: u32| 1.0 + f64::from(n) * f64::EPSILON;
        let at = free_motion([1.0, step(a), step(b)], &omega).at(t).unwrap();
        prop_assert!((at.omega - omega).norm() < 1e-11);
        prop_assert!(apart(&at.attitude, &UnitQuaternion::from_scaled_axis(omega * t)) < 1e-11);
    }

    #[test]
    fn a_nearly_steady_spin_about_a_stable_axis_stays(m in moments(), push in 1e-300..1e-14_f64, t in -30.0..30.0_f64) {
        prop_assume!(distinct(&m));
        let largest = m.imax();
        let mut omega = Vector3::repeat(push);
        omega[largest] = -1.0;
        let at = free_motion(m, &omega).at(t).unwrap();
        let steady = UnitQuaternion::from_scaled_axis(Vector3::from_fn(|i, _| if i == largest { -t } else { 0.0 }));
        prop_assert!(apart(&at.attitude, &steady) < 1e-12 && (at.omega[largest] + 1.0).abs() < 1e-14);
    }

    #[test]
    fn both_sides_of_the_separatrix_agree_until_the_saddle_parts_them(scale in 0.5..2.0_f64, t in -8.0..8.0_f64) {
        let exact = motion([3.0, 4.0, 6.0], [2.0 * scale, scale, scale]);
        let Regime::Separatrix { rate } = exact.regime() else { panic!("{:?}", exact.regime()) };
        let at = exact.at(t).unwrap();
        for step in [f64::next_up as fn(f64) -> f64, f64::next_down] {
            let near = motion([3.0, 4.0, 6.0], [step(2.0 * scale), scale, scale]);
            let off = !matches!(near.regime(), Regime::Separatrix { .. });
            prop_assert!(off);
            let near = near.at(t).unwrap();
            // The difference grows from one rounding, like every deviation.
            let bound = 1e-14 * (rate * t.abs()).exp();
            prop_assert!((near.omega - at.omega).norm() < bound);
            prop_assert!(apart(&near.attitude, &at.attitude) < bound);
        }
    }
}

/// With moments 2, 3, 4 the distance from the separatrix is L² - 2 E I_M = 4 w3² - 2 w1², and for Pell's
/// numbers w1² - 2 w3² is 1 and -1 in turn: two terms of 32 digits that differ by 2. With moments that have
/// more digits (the same ratios) the terms have 56, and differ further down than twice the precision sees.
#[test]
fn the_side_of_the_separatrix_is_decided_without_rounding() {
    let (mut w3, mut w1) = (1_u64, 1_u64);
    let mut sides = Vec::new();
    let heavy = 1.0 + 2_f64.powi(-37) + 2_f64.powi(-20) + 2_f64.powi(-9);
    while w3 + w1 < 1 << 53 && 2 * w3 + w1 < 1 << 53 {
        (w3, w1) = (w3 + w1, 2 * w3 + w1);
        let above = i128::from(w1).pow(2) - 2 * i128::from(w3).pow(2);
        let (x, z) = (w1 as f64, w3 as f64);
        let Regime::Elliptic { about, complement, .. } =
            motion([2.0, 3.0, 4.0].map(|i| heavy * i), [x, x, z]).regime()
        else {
            panic!("on the separatrix")
        };
        assert_eq!(about, if above > 0 { Axis::Smallest } else { Axis::Largest }, "{w1} {w3}");
        // k'² = d_CX |D|/(d_CM Q²) with |D| = 2, d_CX = 2, d_CM = 1 and Q² = I_M d_MX w_M² + I_C d_CX w_C².
        let round = if above > 0 { 3.0 * x * x + 4.0 * x * x } else { 3.0 * x * x + 8.0 * z * z };
        assert!((complement / (4.0 / round).sqrt() - 1.0).abs() < 1e-15, "{w1} {w3} {complement:e}");
        sides.push(about);
    }
    assert!(sides.len() > 38 && w1 > 1 << 51);
}

#[test]
fn a_sphere_and_a_symmetric_top_move_as_their_elementary_formulas_say() {
    let sphere = motion([2.0, 2.0, 2.0], [0.3, -0.4, 1.2]);
    assert!(matches!(sphere.regime(), Regime::Steady { speed } if (speed - 1.3).abs() < 1e-15));
    let half_turn = sphere.at(std::f64::consts::PI / 1.3).unwrap().attitude;
    assert!(half_turn.w.abs() < 1e-15 && (half_turn.k - 12.0 / 13.0).abs() < 1e-15);
    // (I3 - I1) w3/I1 = 0.5 * 2 = 1 rad/s: a quarter turn of the spin in pi/2 s; L/I1 = |(1, 0, 3)|.
    let top = motion([1.0, 1.0, 1.5], [1.0, 0.0, 2.0]);
    let Regime::SymmetricTop { axis: Axis::Largest, nutation, precession } = top.regime() else {
        panic!("not a top")
    };
    assert!((nutation - 1.0).abs() < 1e-15 && (precession - 10_f64.sqrt()).abs() < 1e-15);
    let at = top.omega(std::f64::consts::FRAC_PI_2).unwrap();
    assert!((at - Vector3::new(0.0, 1.0, 2.0)).norm() < 1e-15, "{at}");
}

/// Exactly on the separatrix of (3, 4, 6) the spin comes to rest on the middle axis, at L/I2 = sqrt(88)/4.
#[test]
fn on_the_separatrix_the_spin_is_on_the_middle_axis_however_late_one_asks() {
    let end = 88_f64.sqrt() / 4.0;
    for spin in [1.0, -1.0, 1e100] {
        let motion = free_motion([3.0, 4.0, 6.0], &(Vector3::new(2.0, 1.0, 1.0) * spin));
        assert!(matches!(motion.regime(), Regime::Separatrix { .. }));
        for power in [3, 16, 17, 38, 39, 40, 42, 43, 59, 100, 200, 300, 307, 308] {
            for t in [10_f64.powi(power), -(10_f64.powi(power))] {
                let at = motion.at(t).unwrap();
                let spun = at.omega / spin.abs();
                assert_eq!(at.omega, motion.omega(t).unwrap());
                assert!(spun.x.abs() < 1e-100 && spun.z.abs() < 1e-100, "{t:e}: {spun:?}");
                assert!((spun.y.abs() - end).abs() < 1e-14, "{t:e}: {spun:?}");
                assert!((at.attitude.norm() - 1.0).abs() < 1e-15, "{t:e}");
            }
        }
    }
}

/// A modulus is at most 1, and where it is 1 to rounding the complement still separates the motion from the
/// separatrix.
#[test]
fn the_modulus_next_to_the_separatrix_is_not_above_one() {
    let moments = [1.438952918759294, 2.0351257746035527, 3.054333979342899];
    let omega = [-2.803572890169369e-10, 1.4128433977268962, 4.337202859078787e-10];
    let regime = motion(moments, omega).regime();
    let Regime::Elliptic { modulus, complement, .. } = regime else { panic!("{regime:?}") };
    assert!(modulus == 1.0 && complement > 0.0, "{modulus:?} {complement:e}");
}
