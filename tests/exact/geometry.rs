//! What is read off a whole motion: its angles to the momentum, its twist, its rate of growth.

use super::{apart, distinct, motion};
use crate::common::*;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use std::f64::consts::PI;
use tumbling::exact::{FreeMotion, Instant, Regime};
use tumbling::{Axis, Body, Inertia, PrincipalMoments};

/// A body with two equal moments, spun askew.
fn top() -> impl Strategy<Value = (Vector3<f64>, Vector3<f64>, usize)> {
    (0.2..1.9_f64, generic_spin(), 0..3_usize).prop_filter_map("a sphere", |(c, omega, axis)| {
        let mut moments = Vector3::repeat(1.0);
        moments[axis] = c;
        ((c - 1.0).abs() > 0.05).then_some((moments, omega, axis))
    })
}

proptest! {
    // Independent: the smooth rate about the momentum (mathematics of the frame in the documentation), summed
    // by the midpoint rule, which for a periodic function converges faster than any power.
    #[test]
    fn the_twist_is_the_integral_of_the_rate_about_the_momentum(m in moments(), omega in generic_spin()) {
        prop_assume!(distinct(&m));
        let motion = free_motion(m, &omega);
        let Regime::Elliptic { about, complement, .. } = motion.regime() else { panic!("not elliptic") };
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
        let turned = UnitQuaternion::from_scaled_axis(axis) * omega;
        prop_assert!((motion.omega(half).unwrap() - turned).norm() < 1e-11);
    }

    // Independent: the angles seen along the way. Of a top's three axes the middle is met by none of the
    // others' rules.
    #[test]
    fn the_angles_to_the_momentum_bound_the_whole_motion_and_are_reached(
        (m, omega) in prop_oneof![
            (moments().prop_filter("alike", distinct), generic_spin()),
            top().prop_map(|(m, omega, _)| (m, omega)),
        ],
    ) {
        let motion = free_motion(m, &omega);
        let period = motion.period().unwrap().unwrap();
        let spins: Vec<_> = (0..2000).map(|k| motion.omega(period / 2000.0 * f64::from(k)).unwrap()).collect();
        for axis in Axis::ALL {
            let [least, most] = motion.angles_to_momentum(axis).unwrap();
            let axis = PrincipalMoments::try_from(m).unwrap().axis(axis);
            let mut seen = [f64::INFINITY, 0.0_f64];
            for w in &spins {
                let momentum = m.component_mul(w);
                let angle = (momentum[axis] / momentum.norm()).acos();
                seen = [seen[0].min(angle), seen[1].max(angle)];
            }
            prop_assert!(seen[0] > least - 1e-7 && seen[1] < most + 1e-7, "{seen:?} {least} {most}");
            prop_assert!(seen[0] < least + 0.02 && seen[1] > most - 0.02, "{seen:?} {least} {most}");
        }
    }

    // The rate about the momentum, (2E + L w)/(L + I w), is constant here; and what the twist means for the
    // attitude.
    #[test]
    fn a_tops_twist_is_its_rate_about_the_momentum_for_half_a_period((m, omega, axis) in top()) {
        let motion = free_motion(m, &omega);
        let half = motion.period().unwrap().unwrap() / 2.0;
        let start = m.component_mul(&omega);
        let (momentum, along) = (start.norm(), omega[axis].abs());
        let rate = (start.dot(&omega) + momentum * along) / (momentum + m[axis] * along);
        let twist = motion.twist_of_half_period().unwrap();
        prop_assert!((rate * half / twist - 1.0).abs() < 1e-13, "{twist}");
        let mut about = Vector3::zeros();
        about[axis] = PI;
        let expected = UnitQuaternion::from_scaled_axis(start / momentum * (twist + PI)) * UnitQuaternion::from_scaled_axis(about);
        prop_assert!(apart(&motion.at(half).unwrap().attitude, &expected) < 1e-13 * (1.0 + twist));
    }
}

/// The top's greatest component is the radius of its circle: for (1, 1) it is sqrt(2).
#[test]
fn a_top_that_swings_beyond_the_range_is_refused() {
    let new = |w: f64| FreeMotion::new(PrincipalMoments::new(1.0, 1.0, 1.5)?, &Vector3::new(w, w, 1.0));
    assert!(new(1.27e308).is_ok());
    assert!(new(1.28e308).unwrap_err().to_string().contains("the greatest spin"));
}

/// A small libration about a spin near the end of the range: with moments (1, 1.9, 2) the push along the
/// first axis comes along the second sqrt(1/0.19) = 2.3 times as great, which is still nothing relative to
/// the spin.
#[test]
fn a_small_libration_of_the_fastest_spin_is_within_the_range() {
    for push in [1e200, 1e-100, 5e-324] {
        let motion = motion([1.0, 1.9, 2.0], [push, 0.0, 1.7e308]);
        let quarter = motion.omega(0.25 * motion.period().unwrap().unwrap()).unwrap();
        assert!(
            quarter.z == 1.7e308 && (quarter.y.abs() / push - 0.19_f64.sqrt().recip()).abs() < 0.5,
            "{quarter:?}"
        );
    }
}

#[test]
fn a_steady_spin_keeps_its_angles() {
    let angles = |m: [f64; 3], w: [f64; 3], axis| motion(m, w).angles_to_momentum(axis).unwrap();
    assert_eq!(angles([1.0, 2.0, 3.0], [0.0, -2.0, 0.0], Axis::Middle), [PI; 2]);
    assert_eq!(angles([1.0, 2.0, 3.0], [0.0, 2.0, 0.0], Axis::Middle), [0.0; 2]);
    let [least, most] = angles([2.0, 2.0, 2.0], [3.0, 0.0, -4.0], Axis::Largest);
    assert!(least == most && (least.cos() + 0.8).abs() < 1e-15);
}

#[test]
fn a_top_that_hardly_leaves_its_plane_turns_too_far_in_a_period_to_say() {
    // It turns 1e459 times while the spin goes round once.
    for omega in [[-3.8e-159, 1e300, 0.0], [5e-324, 0.3, 0.7]] {
        let top = motion([0.66, 1.0, 1.0], omega);
        assert_eq!(top.twist_of_half_period(), None);
    }
}

/// A tensor's principal axes come in the order of the moments as soon as one product is not zero.
#[test]
fn a_product_of_inertia_next_to_zero_exchanges_no_axes() {
    for (moments, omega) in [([3.0, 1.0, 2.0], [0.3, 1.0, -0.2]), ([2.0, 2.0, 1.0], [0.3, 1.0, -0.2])] {
        let motion = |product: f64| {
            let mut tensor = Matrix3::from_diagonal(&moments.into());
            (tensor[(1, 2)], tensor[(2, 1)]) = (product, product);
            let inertia = Inertia::try_from(tensor).unwrap();
            let body = Body::spinning(inertia, UnitQuaternion::identity(), &omega.into()).unwrap();
            FreeMotion::of(&body).unwrap()
        };
        let (plain, tilted) = (motion(0.0), motion(1e-12));
        for axis in Axis::ALL {
            let [a, b] = [&plain, &tilted].map(|motion| motion.angles_to_momentum(axis).unwrap());
            let direct = moments[0] != moments[1] || axis == Axis::Smallest;
            assert!(!direct || (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) < 1e-9, "{axis:?} {a:?} {b:?}");
        }
    }
    let round = FreeMotion::new(PrincipalMoments::new(2.0, 2.0, 1.0).unwrap(), &Vector3::new(0.3, 1.0, -0.2));
    assert!(matches!(round.unwrap().regime(), Regime::SymmetricTop { axis: Axis::Smallest, .. }));
}

proptest! {
    #[test]
    fn a_body_keeps_its_momentum_to_the_bit_and_its_energy(
        m in moments(), frame in attitude(), start in attitude(), omega in generic_spin(), t in -1e3..1e3_f64,
    ) {
        let inertia = Inertia::from_moments(m.x, m.y, m.z).unwrap().turned(frame).unwrap();
        let body = Body::spinning(inertia, start, &omega).unwrap();
        let motion = FreeMotion::of(&body).unwrap();
        prop_assert_eq!(motion.at(0.0).unwrap(), Instant { omega: body.omega_body(), attitude: start });
        let after = motion.body(t).unwrap();
        prop_assert_eq!((after.inertia(), after.momentum_world()), (inertia, body.momentum_world()));
        prop_assert!((motion.energy() / body.energy() - 1.0).abs() < 1e-14);
        prop_assert!((after.energy() / body.energy() - 1.0).abs() < 1e-13);
        prop_assert!((after.omega_body() - motion.omega(t).unwrap()).norm() < 1e-13 * omega.norm());
        // From another attitude the body turns with its momentum.
        let other = motion.with_attitude(frame).unwrap().body(t).unwrap();
        prop_assert!((other.momentum_body() - after.momentum_body()).norm() < 1e-14 * after.momentum_world().norm());
    }
}

fn motion_near_the_middle(push: f64) -> FreeMotion {
    motion([1.0, 2.0, 3.0], [0.0, 10.0, push])
}

/// Next to the middle axis a push grows at the rate of the linear law, sqrt((I3-I2)(I2-I1)/(I1 I3)) w2, but
/// for what the finite push changes.
#[test]
fn a_push_off_the_middle_axis_grows_at_the_rate_of_the_regime() {
    let saddle = 10.0 / 3_f64.sqrt();
    for push in [0.5, 1e-3, 1e-9, 1e-300, 5e-324] {
        let regime = motion_near_the_middle(push).regime();
        let Regime::Elliptic { rate, .. } = regime else { panic!("{regime:?}") };
        // rate² = (I3-I2)(L² - 2 E I1)/(I1 I2 I3), with L² - 2 E I1 = 200 + 6 push² here.
        let rate_by_law = saddle * (1.0 + 0.03 * push * push).sqrt();
        assert!((rate / rate_by_law - 1.0).abs() <= 1e-15, "{push:e}: {rate}");
    }
}
