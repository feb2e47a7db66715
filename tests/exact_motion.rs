//! The exact motion against 40 digits, against mathematics, and against itself across every border.

mod common;

use common::*;
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;
use serde_json::Value;
use tumbling::exact::{FreeMotion, Instant, Regime, time_between_flips};
use tumbling::{Axis, Body, ErrorKind, Inertia, PrincipalMoments};

/// The rounding of one input, relative.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Numbers of the table, to what `f64` sees of their 40 digits.
fn numbers(value: &Value) -> Vec<f64> {
    let number = |x: &Value| x.as_str().unwrap().parse().unwrap();
    value.as_array().unwrap().iter().map(number).collect()
}

fn length(v: &[f64]) -> f64 {
    let scale = v.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
    scale * v.iter().map(|x| (x / scale) * (x / scale)).sum::<f64>().sqrt()
}

/// The worst errors of spin and attitude over a table, in roundings times what the motion makes of them: `plain`
/// and `tight` as the table's condition numbers. Comparing to the table's `f64` costs at most half a unit.
fn judge(table: &str) -> [(f64, String); 4] {
    let file: Value = serde_json::from_str(table).unwrap();
    let mut worst = [(); 4].map(|()| (0.0, String::new()));
    for case in file["cases"].as_array().unwrap() {
        let vector = |field: &str| Vector3::from_vec(numbers(&case[field]));
        let motion = FreeMotion::new(vector("inertia").try_into().unwrap(), &vector("w0")).unwrap();
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
    let worst = judge(include_str!("data/free-motion.json"));
    assert!(worst.iter().all(|(units, _)| *units <= 8.0), "{worst:#?}");
}

#[test]
fn random_hard_motions_are_met_as_well() {
    let worst = judge(include_str!("data/sweep.json"));
    assert!(worst.iter().all(|(units, _)| *units <= 8.0), "{worst:#?}");
}

fn motion(moments: [f64; 3], omega: [f64; 3]) -> FreeMotion {
    FreeMotion::new(moments.try_into().unwrap(), &omega.into()).unwrap()
}

/// The angle between two attitudes is at most twice this.
fn apart(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    let (a, b) = (a.coords, b.coords);
    (a - b).norm().min((a + b).norm())
}

fn distinct(m: &Vector3<f64>) -> bool {
    (0..3).all(|i| (m[i] / m[(i + 1) % 3] - 1.0).abs() > 0.02)
}

proptest! {
    #[test]
    fn the_momentum_stays_where_it_is_in_the_world(m in moments(), omega in generic_spin(), t in -1e4..1e4_f64) {
        let at = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap().at(t).unwrap();
        let momentum = at.attitude * m.component_mul(&at.omega);
        let start = m.component_mul(&omega);
        // The direction is of the phase's doing only through the spin's: both carry errors of 1e4 turns.
        prop_assert!((momentum - start).norm() < 1e-11 * start.norm(), "{}", (momentum - start).norm());
        let energy = |w: &Vector3<f64>| m.component_mul(w).dot(w);
        prop_assert!((energy(&at.omega) / energy(&omega) - 1.0).abs() < 2e-14);
    }

    // Independent of all formulas: the equations of motion themselves, by central differences.
    #[test]
    fn spin_and_attitude_obey_the_equations_of_motion(m in moments(), omega in generic_spin(), t in -9.0..9.0_f64) {
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        let h = 1e-4;
        let [before, at, after] = [t - h, t, t + h].map(|t| motion.at(t).unwrap());
        let slope = (after.omega - before.omega) / (2.0 * h);
        let law = tumbling::dynamics::euler::angular_acceleration(&m, &at.omega, &Vector3::zeros());
        let fast = 1.0 + at.omega.norm().powi(3);
        prop_assert!((slope - law).norm() < 1e-5 * fast, "{slope} {law}");
        let sign = if before.attitude.coords.dot(&after.attitude.coords) < 0.0 { -1.0 } else { 1.0 };
        let turn = (after.attitude.coords * sign - before.attitude.coords) / (2.0 * h);
        let sign = if sign * before.attitude.coords.dot(&at.attitude.coords) < 0.0 { -1.0 } else { 1.0 };
        let rate: Quaternion<f64> = tumbling::attitude::rate(at.attitude.quaternion(), &at.omega);
        let off = (turn - rate.coords * sign).norm().min((turn + rate.coords * sign).norm());
        prop_assert!(off < 1e-5 * fast, "{off:e}");
    }

    #[test]
    fn there_and_back_is_the_start(m in moments(), omega in generic_spin(), t in -100.0..100.0_f64) {
        prop_assume!(distinct(&m));
        let there = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap().at(t).unwrap();
        let back = FreeMotion::new(m.try_into().unwrap(), &there.omega).unwrap().at(-t).unwrap();
        // A rounding at the far end grows as the motion's own sensitivity, some hundreds here.
        prop_assert!((back.omega - omega).norm() < 1e-10);
        prop_assert!(apart(&(there.attitude * back.attitude), &UnitQuaternion::identity()) < 1e-10);
    }

    #[test]
    fn two_stretches_of_time_are_one(m in moments(), omega in generic_spin(), s in -50.0..50.0_f64, t in -50.0..50.0_f64) {
        prop_assume!(distinct(&m));
        let first = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        let half = first.at(s).unwrap();
        let then = FreeMotion::new(m.try_into().unwrap(), &half.omega).unwrap().at(t).unwrap();
        let whole = first.at(s + t).unwrap();
        prop_assert!((then.omega - whole.omega).norm() < 1e-10);
        prop_assert!(apart(&(half.attitude * then.attitude), &whole.attitude) < 1e-10);
    }

    #[test]
    fn renaming_and_turning_the_axes_changes_nothing(m in moments(), omega in generic_spin(), t in -20.0..20.0_f64) {
        let at = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap().at(t).unwrap();
        // All 24 ways to lay a right-handed frame along the axes.
        for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
            for signs in 0..8 {
                let sign = [0, 1, 2].map(|k| if signs >> k & 1 == 1 { -1.0 } else { 1.0 });
                let frame = Matrix3::from_fn(|i, j| if order[i] == j { sign[i] } else { 0.0 });
                if frame.determinant() < 0.0 {
                    continue;
                }
                let other = Vector3::from_fn(|i, _| m[order[i]]);
                let turned = FreeMotion::new(other.try_into().unwrap(), &(frame * omega)).unwrap().at(t).unwrap();
                prop_assert!((turned.omega - frame * at.omega).norm() < 1e-13);
                let seen = frame * at.attitude.to_rotation_matrix().matrix() * frame.transpose();
                let seen_there = turned.attitude.to_rotation_matrix().into_inner();
                prop_assert!((seen - seen_there).norm() < 1e-12);
            }
        }
    }

    #[test]
    fn a_body_in_any_axes_and_attitude_moves_as_its_principal_axes_do(
        m in moments(), omega in generic_spin(), frame in attitude(), start in attitude(), t in -20.0..20.0_f64,
    ) {
        prop_assume!(distinct(&m));
        let plain = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap().at(t).unwrap();
        let inertia = Inertia::from_moments(m.x, m.y, m.z).unwrap().turned(frame).unwrap();
        let body = Body::spinning(inertia, start, &(frame * omega)).unwrap();
        let motion = FreeMotion::of(&body).unwrap();
        prop_assert_eq!(motion.at(0.0).unwrap(), Instant { omega: body.omega_body(), attitude: start });
        let at = motion.at(t).unwrap();
        prop_assert!((at.omega - frame * plain.omega).norm() < 1e-11);
        prop_assert!(apart(&at.attitude, &(start * frame * plain.attitude * frame.inverse())) < 1e-11);
    }

    #[test]
    fn only_ratios_of_moments_matter_and_time_runs_with_the_spin(
        m in moments(), omega in generic_spin(), t in -20.0..20.0_f64, heavier in -600..500_i32, faster in -600..490_i32,
    ) {
        let (i, w) = (2_f64.powi(heavier), 2_f64.powi(faster));
        let at = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap().at(t).unwrap();
        let scaled = FreeMotion::new((m * i).try_into().unwrap(), &(omega * w)).unwrap().at(t / w).unwrap();
        prop_assert_eq!(scaled.omega, at.omega * w);
        prop_assert_eq!(scaled.attitude, at.attitude);
    }

    #[test]
    fn flips_are_where_the_middle_spin_vanishes_one_beat_apart(m in moments(), omega in generic_spin(), from in -50.0..50.0_f64) {
        prop_assume!(distinct(&m));
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        let beat = time_between_flips(m.try_into().unwrap(), &omega).unwrap().unwrap();
        prop_assert!((motion.period().unwrap().unwrap() / beat - 2.0).abs() < 1e-15);
        let times: Vec<f64> = motion.flips(from, from + 5.5 * beat).unwrap().collect();
        prop_assert!(times.len() == 5 || times.len() == 6);
        prop_assert_eq!(motion.next_flip(from).unwrap(), Some(times[0]));
        let mut order = [0, 1, 2];
        order.sort_by(|&a: &usize, &b: &usize| m[a].total_cmp(&m[b]));
        for pair in times.windows(2) {
            prop_assert!(((pair[1] - pair[0]) / beat - 1.0).abs() < 1e-11);
        }
        for &t in &times {
            prop_assert!(t > from && motion.omega(t).unwrap()[order[1]].abs() < 1e-11, "{t}");
        }
    }

    // Independent: the smooth rate about the momentum (mathematics of the frame in the documentation), summed by
    // the midpoint rule, which for a periodic function converges faster than any power.
    #[test]
    fn the_twist_is_the_integral_of_the_rate_about_the_momentum(m in moments(), omega in generic_spin()) {
        prop_assume!(distinct(&m));
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        let Regime::Elliptic { about, complement, .. } = motion.regime() else { panic!("not circulating") };
        prop_assume!(complement > 1e-3);
        let mut order = [0, 1, 2];
        order.sort_by(|&a: &usize, &b: &usize| m[a].total_cmp(&m[b]));
        let c = order[about as usize];
        let half = motion.period().unwrap().unwrap() / 2.0;
        let momentum = m.component_mul(&omega).norm();
        let twice_energy = m.component_mul(&omega).dot(&omega);
        let rate = |t: f64| {
            let w = motion.omega(t).unwrap()[c].abs();
            (twice_energy + momentum * w) / (momentum + m[c] * w)
        };
        let count = 400;
        let sum: f64 = (0..count).map(|k| rate((f64::from(k) + 0.5) * half / f64::from(count))).sum();
        let twist = motion.twist_of_half_period().unwrap();
        prop_assert!((sum * half / f64::from(count) / twist - 1.0).abs() < 1e-11, "{twist}");
        // And what it means: the attitude after half a period.
        let mut axis = Vector3::zeros();
        axis[c] = std::f64::consts::PI;
        let start = m.component_mul(&omega);
        let expected = UnitQuaternion::from_scaled_axis(start.normalize() * (twist + std::f64::consts::PI)) * UnitQuaternion::from_scaled_axis(axis);
        let ours = motion.at(half).unwrap().attitude;
        prop_assert!(apart(&ours, &expected) < 1e-12, "{ours} {expected}");
    }

    #[test]
    fn the_angles_to_the_momentum_bound_the_whole_motion_and_are_reached(m in moments(), omega in generic_spin()) {
        prop_assume!(distinct(&m));
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        angles_bound_the_motion(&m, &motion)?;
    }

    #[test]
    fn the_herpolhode_lies_in_the_invariable_plane(m in moments(), omega in generic_spin()) {
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        let momentum = m.component_mul(&omega);
        let height = momentum.dot(&omega);
        for k in 0..50 {
            let point = motion.at(30.0 / 49.0 * f64::from(k)).unwrap().omega_world();
            prop_assert!((point.dot(&momentum) / height - 1.0).abs() < 1e-13);
        }
    }

    // Neighbours on the two sides of every border: a motion and one whose inputs differ by roundings.
    #[test]
    fn a_nearly_symmetric_body_moves_as_a_symmetric_one(
        c in 0.3..1.9_f64, omega in generic_spin(), t in -30.0..30.0_f64, power in 13..16_i32, axis in 0..3_usize,
    ) {
        let mut m = Vector3::repeat(1.0);
        m[axis] = c;
        let exact = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap().at(t).unwrap();
        m[(axis + 1) % 3] += 10_f64.powi(-power);
        let near = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap().at(t).unwrap();
        let bound = 1e3 * 10_f64.powi(-power);
        prop_assert!((near.omega - exact.omega).norm() < bound && apart(&near.attitude, &exact.attitude) < bound);
    }

    #[test]
    fn a_nearly_spherical_body_spins_as_a_sphere(omega in generic_spin(), t in -30.0..30.0_f64, a in 0..40_u32, b in 0..40_u32) {
        let step = |n: u32| 1.0 + f64::from(n) * f64::EPSILON;
        let at = FreeMotion::new(PrincipalMoments::new(1.0, step(a), step(b)).unwrap(), &omega).unwrap().at(t).unwrap();
        prop_assert!((at.omega - omega).norm() < 1e-11);
        prop_assert!(apart(&at.attitude, &UnitQuaternion::from_scaled_axis(omega * t)) < 1e-11);
    }

    #[test]
    fn a_nearly_steady_spin_about_a_stable_axis_stays(m in moments(), push in 1e-300..1e-14_f64, t in -30.0..30.0_f64) {
        prop_assume!(distinct(&m));
        let largest = m.imax();
        let mut omega = Vector3::repeat(push);
        omega[largest] = -1.0;
        let at = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap().at(t).unwrap();
        let steady = UnitQuaternion::from_scaled_axis(Vector3::from_fn(|i, _| if i == largest { -t } else { 0.0 }));
        prop_assert!(apart(&at.attitude, &steady) < 1e-12 && (at.omega[largest] + 1.0).abs() < 1e-14);
    }

    #[test]
    fn both_sides_of_the_separatrix_agree_until_the_saddle_parts_them(scale in 0.5..2.0_f64, t in -8.0..8.0_f64) {
        let exact = motion([3.0, 4.0, 6.0], [2.0 * scale, scale, scale]);
        let on = matches!(exact.regime(), Regime::Separatrix { .. });
        let at = exact.at(t).unwrap();
        for step in [f64::next_up as fn(f64) -> f64, f64::next_down] {
            let near = motion([3.0, 4.0, 6.0], [step(2.0 * scale), scale, scale]);
            let off = !matches!(near.regime(), Regime::Separatrix { .. });
            prop_assert!(on && off);
            let near = near.at(t).unwrap();
            // The difference grows from one rounding as every push does.
            let bound = 1e-14 * (exact.growth_rate().unwrap().unwrap() * t.abs()).exp();
            prop_assert!((near.omega - at.omega).norm() < bound);
            prop_assert!(apart(&near.attitude, &at.attitude) < bound);
        }
    }

    #[test]
    fn no_input_at_all_makes_it_panic_and_what_is_accepted_gives_numbers(
        m in prop_oneof![any_vector(), moments()], omega in any_vector(), t in anything(), u in anything(),
    ) {
        let Ok(motion) = PrincipalMoments::try_from(m).and_then(|m| FreeMotion::new(m, &omega)) else { return Ok(()) };
        let _ = (motion.period(), motion.growth_rate(), motion.next_flip(t), motion.regime());
        let _ = (motion.twist_of_half_period(), motion.angles_to_momentum(1));
        if let Ok(flips) = motion.flips(t, u) {
            let _ = flips.take(4).count();
        }
        match motion.at(t) {
            Ok(at) => {
                prop_assert!(t.is_finite() && at.omega.iter().all(|x| x.is_finite()), "{at:?}");
                prop_assert!((at.attitude.norm() - 1.0).abs() < 1e-15, "{at:?}");
            }
            Err(error) => {
                let named = error.kind() == ErrorKind::NotFinite;
                prop_assert!(!t.is_finite() && named, "{error}");
            }
        }
    }
}

#[test]
fn the_start_comes_back_to_the_bit() {
    let omega = Vector3::new(0.1, -0.7, 0.3);
    let at = FreeMotion::new(PrincipalMoments::new(1.0, 2.0, 2.5).unwrap(), &omega).unwrap().at(0.0).unwrap();
    assert_eq!(at, Instant { omega, attitude: UnitQuaternion::identity() });
}

/// A push of the smallest number there is: after the saddle has been left, cn = 1/cosh of the time to the flip, and the
/// flip comes ln(4/k')/rate after the start (mathematics, to terms of the order of the push).
#[test]
fn a_subnormal_push_flips_when_the_logarithm_says() {
    let motion = motion([1.0, 2.0, 3.0], [0.0, 10.0, 5e-324]);
    let rate = 10.0 / 3_f64.sqrt();
    // k'² = 2 (3 push²)/(200), see tests/stability.rs; the spin starts in the middle between two flips.
    let expected = (4_f64.ln() - 0.5 * 0.03_f64.ln() - f64::ln(5e-324)) / rate;
    let flip = motion.next_flip(0.0).unwrap().unwrap();
    assert!((flip / expected - 1.0).abs() < 1e-14, "{flip} {expected}");
    // As it passes, the spin is all across and around: on the separatrix, w1² = 3 w3² and energy is shared.
    let across = motion.omega(flip).unwrap();
    assert!(across.y.abs() < 1e-9 && (across.x.abs() / (3_f64.sqrt() * across.z.abs()) - 1.0).abs() < 1e-12);
    assert!((motion.omega(2.0 * flip).unwrap().y + 10.0).abs() < 1e-13);
    // Before it is felt, the push grows as cosh of the rate.
    let early = motion.omega(3.0).unwrap().z;
    assert!((early / ((rate * 3.0).cosh() * 5e-324) - 1.0).abs() < 1e-7, "{early:e}");
}

/// After a billion flips the phase is as good as the rate: half a unit in each input, times the phase.
#[test]
fn after_a_billion_flips_the_spin_is_where_the_count_of_flips_says() {
    let motion = motion([1.0, 2.0, 3.0], [0.3, 1.0, -0.2]);
    let half = motion.period().unwrap().unwrap() / 2.0;
    let far = motion.next_flip(1e9 * half).unwrap().unwrap();
    let spin = motion.omega(far).unwrap();
    // The time itself is rounded to 2e-7 of a second, which turns the phase by as much.
    assert!(spin.y.abs() < 4.0 * ulp(far), "{}", spin.y);
    let near = motion.next_flip(0.0).unwrap().unwrap();
    assert!((motion.omega(near).unwrap().x.abs() - spin.x.abs()).abs() < 1e-6);
}

#[test]
fn a_billion_flips_take_no_room_and_the_last_can_be_asked_for() {
    let motion = motion([1.0, 2.0, 3.0], [0.3, 1.0, -0.2]);
    let half = motion.period().unwrap().unwrap() / 2.0;
    let from = 1e9 * half;
    let late: Vec<f64> = motion.flips(from, from + 3.2 * half).unwrap().collect();
    assert_eq!(late.len(), 3);
    let all = motion.flips(-from, from).unwrap();
    assert!(all.take(1000).is_sorted());
    assert!(motion.flips(0.0, 1e300).is_err());
}

#[test]
fn the_separatrix_flips_once() {
    let motion = motion([3.0, 4.0, 6.0], [2.0, 1.0, 1.0]);
    assert!(matches!(motion.regime(), Regime::Separatrix { .. }));
    assert_eq!(motion.period().unwrap(), None);
    let times: Vec<f64> = motion.flips(-1e6, 1e6).unwrap().collect();
    assert_eq!(times.len(), 1);
    assert!(motion.omega(times[0]).unwrap().y.abs() < 1e-15);
    assert_eq!(motion.next_flip(times[0]).unwrap(), None);
    // It ends along the middle axis, with all the momentum it had: |L|² = 6² + 4² + 6².
    let late = motion.omega(300.0).unwrap();
    assert!((late.y.abs() - 88_f64.sqrt() / 4.0).abs() < 1e-15 && late.x.abs() < 1e-100);
    let early = motion.omega(-300.0).unwrap();
    assert!((early.y + late.y).abs() < 1e-15);
    assert_eq!(
        motion.growth_rate().unwrap(),
        Some(match motion.regime() {
            Regime::Separatrix { rate } => rate,
            _ => panic!("not the separatrix"),
        })
    );
}

/// With moments 2, 3, 4 the distance from the separatrix is L² - 2 E I_M = 4 w3² - 2 w1², and for Pell's numbers
/// w1² - 2 w3² is 1 and -1 in turn: two terms of 32 digits that differ by 2. With moments that have more digits (the
/// same ratios) the terms have 56, and differ further down than twice the precision sees.
#[test]
fn the_side_of_the_separatrix_is_decided_without_rounding() {
    let (mut w3, mut w1) = (1_u64, 1_u64);
    let mut sides = Vec::new();
    let heavy = 1.0 + 2_f64.powi(-37) + 2_f64.powi(-20) + 2_f64.powi(-9);
    while w3 + w1 < 1 << 53 && 2 * w3 + w1 < 1 << 53 {
        (w3, w1) = (w3 + w1, 2 * w3 + w1);
        let above = i128::from(w1).pow(2) - 2 * i128::from(w3).pow(2);
        #[allow(clippy::cast_precision_loss)]
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
    let Regime::SymmetricTop { axis: 2, nutation, precession } = top.regime() else { panic!("not a top") };
    assert!((nutation - 1.0).abs() < 1e-15 && (precession - 10_f64.sqrt()).abs() < 1e-15);
    let at = top.omega(std::f64::consts::FRAC_PI_2).unwrap();
    assert!((at - Vector3::new(0.0, 1.0, 2.0)).norm() < 1e-15, "{at}");
}

#[test]
fn what_no_body_can_do_is_named() {
    let new = |m: [f64; 3], w: [f64; 3]| FreeMotion::new(m.try_into()?, &w.into());
    let error = |m: [f64; 3], w: [f64; 3]| new(m, w).unwrap_err().to_string();
    assert!(error([1.0, 1.0, 3.0], [1.0, 0.0, 0.0]).contains("triangle inequality"));
    assert!(error([0.0, 1.0, 1.0], [1.0, 0.0, 0.0]).contains("principal moment"));
    assert!(error([1.0, 1.0, 1.0], [f64::NAN, 0.0, 0.0]).contains("the spin"));
    assert!(error([1e-120, 1.0, 1.0], [1.0, 0.0, 0.0]).contains("1e-100 of the largest moment"));
    assert!(error([1.0, 2.0, 2.5], [5e-324, 1e300, 0.0]).contains("how close to the separatrix"));
    // It swings round to w3² + (2/3.75) w2² about the third axis (mathematics), more than can be written.
    assert!(error([1.0, 2.0, 2.5], [0.0, 1.7e308, 1.7e308]).contains("the greatest spin"));
}

/// Exactly on the separatrix of (3, 4, 6) the spin comes to rest on the middle axis, at L/I2 = sqrt(88)/4.
#[test]
fn on_the_separatrix_the_spin_is_on_the_middle_axis_however_late_one_asks() {
    let end = 88_f64.sqrt() / 4.0;
    for spin in [1.0, -1.0, 1e100] {
        let motion = FreeMotion::new(
            PrincipalMoments::new(3.0, 4.0, 6.0).unwrap(),
            &(Vector3::new(2.0, 1.0, 1.0) * spin),
        )
        .unwrap();
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
