//! Lagrange's top against 40 digits, against mechanics, and to the ends of the number range.

use super::{ROUNDING, apart, numbers};
use crate::common::*;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;
use serde_json::Value;
use std::collections::BTreeMap;
use tumbling::exact::{Instant, LagrangeTop, TopRegime};
use tumbling::{Body, Error, ErrorKind, Inertia, PrincipalMoments};

fn distance(a: &[f64], b: &[f64], sign: f64) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - sign * y).powi(2)).sum::<f64>().sqrt()
}

/// The worst error of spin and attitude in each regime, in roundings times the condition of the motion.
/// Comparing with the table's `f64` costs at most half a unit.
fn judge(table: &str) -> BTreeMap<String, [f64; 2]> {
    worst(table, |case, top, most: &mut [f64; 2]| {
        for answer in case[4].as_array().unwrap() {
            let t = answer[0].as_str().unwrap().parse().unwrap();
            let Instant { omega, attitude } = top.at(t).unwrap();
            let (spin, turned) = (numbers(&answer[1]), numbers(&answer[2]));
            let ours = [attitude.w, attitude.i, attitude.j, attitude.k];
            let length = distance(&spin, &[0.0; 3], 1.0);
            let off = distance(omega.as_slice(), &spin, 1.0) / if length > 0.0 { length } else { 1.0 };
            let attitude_off = distance(&ours, &turned, 1.0).min(distance(&ours, &turned, -1.0));
            let units = |off: f64, kappa: &Value| off / (kappa.as_f64().unwrap().max(1.0) * ROUNDING);
            let units = [units(off, &answer[3]), units(attitude_off, &answer[4])];
            *most = [most[0].max(units[0]), most[1].max(units[1])];
        }
    })
}

/// What `add` makes of all cases of a table, by their regimes.
fn worst<T: Default>(table: &str, add: impl Fn(&Value, &LagrangeTop, &mut T)) -> BTreeMap<String, T> {
    let cases: Value = serde_json::from_str(table).unwrap();
    let mut worst = BTreeMap::new();
    for case in cases.as_array().unwrap() {
        add(case, &top_of(case), worst.entry(case[0].as_str().unwrap().to_owned()).or_default());
    }
    worst
}

fn top_of(case: &Value) -> LagrangeTop {
    let [body, q, w] = [1, 2, 3].map(|k| numbers(&case[k]));
    let moments = PrincipalMoments::new(body[0], body[0], body[1]).unwrap();
    let attitude = nalgebra::Quaternion::new(q[0], q[1], q[2], q[3]);
    // Directions with few digits are given with a length of their own.
    let attitude = if (attitude.norm() - 1.0).abs() < 1e-9 { attitude } else { attitude.normalize() };
    let attitude = UnitQuaternion::new_unchecked(attitude);
    let arm = Vector3::new(0.0, 0.0, body[2]);
    LagrangeTop::new(moments, attitude, &Vector3::new(w[0], w[1], w[2]), &arm, body[3]).unwrap()
}

#[test]
fn the_table_of_40_digits_is_met_in_every_regime() {
    let worst = judge(include_str!("../data/top.json"));
    // One spherical pendulum takes 9.7; all others at most 5.3.
    assert!(worst.values().flatten().all(|units| *units <= 10.0), "{worst:#?}");
}

#[test]
fn starts_next_to_the_vertical_with_a_spin_across_the_axis_meet_their_table() {
    let worst = judge(include_str!("../data/top-vertical.json"));
    assert_eq!(worst.len(), 2 * 11);
    assert!(worst.values().flatten().all(|units| *units <= 10.0), "{worst:#?}");
}

/// A number beyond 2^53 of half periods is not always an `f64`, and each of them adds a turn.
#[test]
fn a_top_keeps_its_momenta_beyond_all_half_periods_that_one_number_can_count() {
    let moments = PrincipalMoments::new(0.3, 0.3, 0.09).unwrap();
    let start = UnitQuaternion::from_euler_angles(0.4, 1.2, -0.7);
    for k in (0..60).map(f64::from) {
        let spin = Vector3::new(0.46, -1.47 + 0.05 * k, 0.1 * k);
        let top = LagrangeTop::new(moments, start, &spin, &(Vector3::z() * 0.7), 1.0).unwrap();
        let [before, after] = [0.0, 3e17 + 1e16 * k / 7.0].map(|t| top.body(t).unwrap().momentum_world());
        assert!((after.z - before.z).abs() < 1e-11 * before.norm(), "{k}: {after} {before}");
    }
}

/// The plane is that of the vertical and the world's second axis.
#[test]
fn a_plane_pendulum_stays_in_its_plane_for_ever() {
    let moments = PrincipalMoments::new(1.2, 1.2, 0.7).unwrap();
    for (lean, rate) in
        [(0.3, 0.0), (1.9, 0.0), (3.1, 0.0), (0.9, 1.7), (2.0, -2.5), (1.0, 4.0), (3.0, 0.02), (0.01, 0.0)]
    {
        let start = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), lean);
        let top = LagrangeTop::new(moments, start, &Vector3::new(rate, 0.0, 0.0), &(Vector3::z() * 0.4), 2.1)
            .unwrap();
        assert_eq!(top.precession_rate(), 0.0);
        for t in [0.7, 1e3, -1e6, 1e9, 1e12, 1e15] {
            let Instant { omega, attitude } = top.at(t).unwrap();
            let off = [attitude.j, attitude.k, omega.y, omega.z].map(f64::abs);
            let bound = 8.0 * ROUNDING * omega.norm().max(1.0);
            assert!(off.iter().all(|off| *off < bound), "{lean} {rate} {t}: {off:?}");
        }
    }
}

/// Period, mean rate, and the highest and lowest lean: the worst relative error of each in each regime, in
/// roundings times its condition number. Zero and infinite values must be exact.
fn judge_observables(table: &str) -> BTreeMap<String, [f64; 4]> {
    worst(table, |case, top, most: &mut [f64; 4]| {
        let [highest, lowest] = top.lean();
        let period = top.period().unwrap().unwrap_or(f64::NAN);
        for (k, ours) in [period, top.precession_rate(), highest, lowest].into_iter().enumerate() {
            let truth: f64 = case[4][k][0].as_str().unwrap().parse().unwrap();
            if k == 0 && top.regime() == TopRegime::SteadyPrecession {
                continue;
            }
            let units = if truth == 0.0 {
                if ours == 0.0 { 0.0 } else { f64::INFINITY }
            } else {
                (ours / truth - 1.0).abs() / (case[4][k][1].as_f64().unwrap().max(1.0) * ROUNDING)
            };
            assert!(units < 1e300, "{k}: {ours}, not {truth}: {case}");
            most[k] = most[k].max(units);
        }
    })
}

#[test]
fn period_mean_rate_and_lean_meet_their_table_in_every_regime() {
    let worst = judge_observables(include_str!("../data/top-observables.json"));
    // The mean rate of one top that falls from nearly upright takes 5.9; all others at most 4.
    assert!(worst.values().flatten().all(|units| *units <= 8.0), "{worst:#?}");
}

/// A top without special symmetry of its motion, about its third axis.
fn any_top() -> impl Strategy<Value = (LagrangeTop, f64)> {
    (0.3..2.0_f64, 0.1..1.9_f64, attitude(), generic_spin(), 0.1..1.0_f64, 0.3..2.0_f64).prop_map(
        |(across, ratio, start, omega, arm, weight)| {
            let moments = PrincipalMoments::new(across, across, across * ratio).unwrap();
            let arm = Vector3::new(0.0, 0.0, arm);
            let spin = omega.component_mul(&Vector3::new(2.0, 2.0, 6.0));
            (LagrangeTop::new(moments, start, &spin, &arm, weight).unwrap(), weight * arm.z)
        },
    )
}

proptest! {
    #[test]
    fn energy_and_both_momenta_of_a_top_stay((top, pull) in any_top(), digits in -3.0..17.0_f64, back in any::<bool>()) {
        let time = 10_f64.powf(digits);
        let body = top.body(if back { -time } else { time }).unwrap();
        let axis = body.attitude() * Vector3::z();
        let energy = body.energy() + pull * axis.z;
        let size = top.energy().abs() + pull;
        prop_assert!((energy - top.energy()).abs() < 1e-13 * size, "{energy} {}", top.energy());
        let momentum = body.momentum_world();
        // The direction of the spin carries the error of all turns.
        let size = 1e-11 * momentum.norm();
        let vertical = (momentum.z - top.body(0.0).unwrap().momentum_world().z).abs();
        let bound = if time < 1e15 { 40.0 * ROUNDING * momentum.norm() } else { size };
        prop_assert!(vertical < bound, "{vertical} at {time}: {:?}", top.regime());
        prop_assert!((momentum.dot(&axis) - top.momentum_about_axis()).abs() < size);
        let [least, most] = top.lean();
        prop_assert!((least - 1e-9..most + 1e-9).contains(&axis.z.acos()));
    }

    #[test]
    fn the_axis_comes_back_to_its_lean_after_a_period_and_has_gone_round((top, _) in any_top(), t in -9.0..9.0_f64) {
        prop_assume!(top.regime() != TopRegime::Free);
        let period = top.period().unwrap().unwrap();
        let axis = |t: f64| top.at(t).unwrap().attitude * Vector3::z();
        let (here, there) = (axis(t), axis(t + period));
        prop_assert!((here.z - there.z).abs() < 1e-11);
        let round = top.precession_rate() * period;
        let gone = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), round) * here;
        prop_assert!((gone - there).norm() < 1e-10, "{round}");
    }

    #[test]
    fn a_top_about_any_axis_moves_alike(start in attitude(), omega in generic_spin(), t in -9.0..9.0_f64) {
        let (moments, arm) = (Vector3::new(0.9, 0.9, 0.5), Vector3::new(0.0, 0.0, -0.4));
        let plain = LagrangeTop::new(moments.try_into().unwrap(), start, &omega, &arm, 1.7).unwrap();
        let at = plain.at(t).unwrap();
        // Each cyclic order of the axes, and any turned tensor.
        for shift in [1, 2] {
            let turned = |v: &Vector3<f64>| Vector3::from_fn(|i, _| v[(i + shift) % 3]);
            let s = if shift == 1 { -0.5 } else { 0.5 };
            let q = UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(0.5, s, s, s));
            prop_assert!((q * omega - turned(&omega)).norm() < 1e-15);
            let other = LagrangeTop::new(turned(&moments).try_into().unwrap(), start * q.inverse(), &turned(&omega), &turned(&arm), 1.7);
            let there = other.unwrap().at(t).unwrap();
            prop_assert!(apart(&(there.attitude * q), &at.attitude) < 1e-12);
            prop_assert!((there.omega - turned(&at.omega)).norm() < 1e-12);
        }
    }

    #[test]
    fn without_weight_a_top_is_a_free_body(start in attitude(), omega in generic_spin(), t in -99.0..99.0_f64) {
        let moments = PrincipalMoments::new(1.1, 1.1, 0.7).unwrap();
        let top = LagrangeTop::new(moments, start, &omega, &Vector3::z(), 0.0).unwrap();
        let free = free_motion(moments, &omega).with_attitude(start).unwrap().at(t).unwrap();
        let at = top.at(t).unwrap();
        prop_assert!(apart(&at.attitude, &free.attitude) < 1e-13);
        prop_assert!((at.omega - free.omega).norm() < 1e-13);
        prop_assert_eq!(top.regime(), TopRegime::Free);
    }
}

#[test]
fn what_is_no_lagrange_top_is_named() {
    let (start, spin) = (UnitQuaternion::identity(), Vector3::new(0.1, 0.2, 3.0));
    let new = |moments: [f64; 3], arm: [f64; 3], weight: f64| {
        LagrangeTop::new(moments.try_into()?, start, &spin, &arm.into(), weight)
    };
    refused(new([1.0, 1.1, 0.5], [0.0, 0.0, 1.0], 1.0), ErrorKind::OutOfBounds, "across the top's axis");
    refused(new([1.0, 1.0, 0.5], [0.0, 0.1, 1.0], 1.0), ErrorKind::OutOfBounds, "the part of the arm");
    refused(new([1.0, 1.0, 0.5], [0.0, 0.0, 1.0], -1.0), ErrorKind::OutOfBounds, "the weight");
    refused(new([1.0, 1.0, 0.5], [0.0, f64::NAN, 1.0], 1.0), ErrorKind::NotFinite, "the arm");
    refused(new([1.0, 1.0, 0.5], [0.0, 0.0, 1.0], 1e-300), ErrorKind::Unrepresentable, "the weight's torque");
}

/// A top with its centre of mass 1 m up its axis, turned about x by an angle whose half has this cosine and
/// this sine.
fn tilted(w: f64, x: f64, omega: [f64; 3], weight: f64) -> Result<LagrangeTop, Error> {
    let attitude = UnitQuaternion::new_unchecked(Quaternion::new(w, x, 0.0, 0.0));
    let moments = PrincipalMoments::new(1.0, 1.0, 0.5)?;
    LagrangeTop::new(moments, attitude, &omega.into(), &Vector3::z(), weight)
}

/// One that leans by `lean`, with 2 N of weight.
fn leaning(lean: f64, omega: [f64; 3]) -> Result<LagrangeTop, Error> {
    let (sine, cosine) = (0.5 * lean).sin_cos();
    tilted(cosine, sine, omega, 2.0)
}

#[test]
fn next_to_a_cusp_a_top_moves_like_one_let_go_at_rest() {
    for (spin, lean) in [(1.0, 0.5), (1.0, 2.0), (0.01, 1.0), (10.0, 0.5), (-10.0, 1.0)] {
        let released = leaning(lean, [0.0, 0.0, spin]).unwrap();
        for push in [1e-60, 1e-30, 1e-20, 1e-16, 1e-14, 1e-12, 1e-9, 1e-6] {
            for [x, y] in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [0.6, 0.8], [-1.0, 1e-3]] {
                let top = leaning(lean, [push * x, push * y, spin]).unwrap();
                for t in [-3.0, 0.1, 0.7, 5.0] {
                    let off = (top.at(t).unwrap().omega - released.at(t).unwrap().omega).norm();
                    assert!(off < 1e3 * push + 3e-14, "{spin} {lean} {push} {x} {y} {t}: {off}");
                }
                assert!(
                    push > 1e-17 * spin.abs() || top.regime() == TopRegime::Cusped,
                    "{push} {x} {y} {spin}"
                );
            }
        }
    }
}

proptest! {
    // The momentum in world axes rounds: 1e-17 or so of the spin is left across the axis.
    #[test]
    fn a_body_let_go_at_rest_is_a_top_with_cusps(
        start in attitude(), spin in 0.01..10.0_f64, polar in 0.1..1.9_f64, t in -3.0..3.0_f64,
    ) {
        let (omega, arm) = (Vector3::new(0.0, 0.0, spin), Vector3::new(0.0, 0.0, -0.4));
        let body = Body::spinning(Inertia::from_moments(1.0, 1.0, polar).unwrap(), start, &omega).unwrap();
        let top = LagrangeTop::of(&body, &arm, 2.0).unwrap();
        prop_assert_eq!(top.regime(), TopRegime::Cusped);
        let plain = LagrangeTop::new(PrincipalMoments::new(1.0, 1.0, polar).unwrap(), start, &omega, &arm, 2.0);
        prop_assert!((top.at(t).unwrap().omega - plain.unwrap().at(t).unwrap().omega).norm() < 1e-11);
    }
}

#[test]
fn a_top_at_rest_upright_hanging_or_without_weight_stays_where_it_is() {
    for (w, x, weight) in [(1.0, 0.0, 2.0), (0.0, 1.0, 2.0), (0.8, 0.6, 0.0)] {
        let start = UnitQuaternion::new_unchecked(Quaternion::new(w, x, 0.0, 0.0));
        let top = tilted(w, x, [0.0; 3], weight).unwrap();
        for t in [1.5, -3e4] {
            let Instant { omega, attitude } = top.at(t).unwrap();
            assert!(apart(&attitude, &start) < 1e-15 && omega == Vector3::zeros(), "{w} {t}: {attitude}");
        }
    }
}

#[test]
fn what_is_too_small_to_square_is_refused_and_not_taken_for_zero() {
    for small in [1e-72, 1e-161, 1e-200, -1e-200, 1e-310, 5e-324] {
        for (result, words) in [
            (tilted(1.0, small, [0.0, 0.0, 3.0], 2.0), "1 less the cosine of the lean"),
            (tilted(small, 1.0, [0.0, 0.0, 3.0], 2.0), "1 plus the cosine of the lean"),
            (tilted(1.0, 0.0, [small, 0.0, 3.0], 2.0), "the square of the spin across"),
            (tilted(1.0, 0.0, [0.0, small, 3e10], 2.0), "the square of the spin across"),
        ] {
            refused(result, ErrorKind::Unrepresentable, words);
        }
    }
    for weight in [1e-141, 1e-200, 5e-324] {
        let top = tilted(1.0, 0.5e-9, [0.0, 0.0, 3.0], weight);
        refused(top, ErrorKind::Unrepresentable, "0 or at least 1e-140");
    }
    assert_eq!(
        tilted(1.0, 0.0, [0.0, -0.0, 6.0], 2.0).unwrap().regime(),
        TopRegime::Sleeping { stable: true }
    );
    assert_eq!(tilted(0.0, 1.0, [0.0, 0.0, 6.0], 2.0).unwrap().regime(), TopRegime::Hanging);
    assert!(tilted(1.0, 1e-69, [0.0, 0.0, 3.0], 2.0).is_ok());
    assert!(tilted(1.0, 1e-9, [0.0, 0.0, 3.0], 1e-138).is_ok());
}

proptest! {
    // Rounding of the tensor turns the axis by rounding over the difference of the moments.
    #[test]
    fn a_tilted_top_of_nearly_equal_moments_moves_as_in_its_own_axes(
        frame in attitude(), start in attitude(), omega in generic_spin(), digits in 0.0..12.0_f64, t in -3.0..3.0_f64,
    ) {
        let polar = 1.0 - 0.5 * 10.0_f64.powf(-digits);
        let (inertia, arm) = (Inertia::from_moments(1.0, 1.0, polar).unwrap(), Vector3::new(0.0, 0.0, 0.7));
        let turned = inertia.turned(frame).unwrap();
        let body = Body::spinning(turned, start * frame.inverse(), &(frame * omega)).unwrap();
        let top = LagrangeTop::of(&body, &(frame * arm), 2.0).unwrap();
        prop_assert_eq!(top.at(0.0).unwrap().attitude, body.attitude());
        let there = top.at(t).unwrap();
        let plain = LagrangeTop::new(PrincipalMoments::new(1.0, 1.0, polar).unwrap(), start, &omega, &arm, 2.0);
        let at = plain.unwrap().at(t).unwrap();
        prop_assert!(apart(&(there.attitude * frame), &at.attitude) < 1e-12);
        prop_assert!((there.omega - frame * at.omega).norm() < 1e-12);
        if digits < 6.0 {
            let off = frame * Vector3::new(1e-7, 0.0, 0.7);
            refused(LagrangeTop::of(&body, &off, 2.0), ErrorKind::OutOfBounds, "the part of the arm");
        }
    }
}

/// The rate at which it goes round is `n/(1 + cos)` or `-n/(1 - cos)`, of one sign.
#[test]
fn an_axis_that_passes_exactly_through_the_vertical_has_neither_cusps_nor_loops() {
    let through = |upright: bool, across: f64, spin: f64| {
        let attitude = if upright { Quaternion::identity() } else { Quaternion::new(0.0, 1.0, 0.0, 0.0) };
        let moments = PrincipalMoments::new(1.0, 1.0, 0.7).unwrap();
        let omega = Vector3::new(across, 0.3 * across, spin);
        let attitude = UnitQuaternion::new_unchecked(attitude);
        LagrangeTop::new(moments, attitude, &omega, &Vector3::z(), 2.0).unwrap()
    };
    // Fast enough to sleep, too slow, and past the lowest place.
    for (upright, across, spin) in
        [(true, 0.8, 9.0), (true, 0.8, -1.5), (false, 1.1, 3.0), (false, 0.2, -4.0)]
    {
        let top = through(upright, across, spin);
        assert_eq!(top.regime(), TopRegime::Nutation, "{upright} {across} {spin}");
        // The mean of that rate over a period, by sums that converge as powers do.
        let (n, period) = (0.7 * spin, top.period().unwrap().unwrap());
        let rate = |k: i32| {
            let axis = (top.at(period * f64::from(k) / 4000.0).unwrap().attitude * Vector3::z()).z;
            if upright { n / (1.0 + axis) } else { -n / (1.0 - axis) }
        };
        let mean = (0..4000).map(rate).sum::<f64>() / 4000.0;
        assert!((top.precession_rate() / mean - 1.0).abs() < 1e-12, "{} {mean}", top.precession_rate());
    }
}
