//! What is read off a motion, and its corners: half a period, two equal moments, the smallest numbers.

mod common;

use common::*;
use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use proptest::strategy::ValueTree as _;
use std::f64::consts::PI;
use tumbling::exact::{FreeMotion, Instant, Regime};
use tumbling::{Axis, Body, ErrorKind, Inertia, PrincipalMoments};

fn motion(moments: [f64; 3], omega: [f64; 3]) -> FreeMotion {
    FreeMotion::new(moments.try_into().unwrap(), &omega.into()).unwrap()
}

/// The angle between two attitudes is at most twice this.
fn apart(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    let (a, b) = (a.coords, b.coords);
    (a - b).norm().min((a + b).norm())
}

#[test]
fn half_a_period_turns_the_spin_half_round_the_axis_that_it_circles() {
    let motion = motion([1.0, 2.0, 2.5], [0.3, 1.0, -0.4]);
    let period = motion.period().unwrap().unwrap();
    // It circles the third axis (L² is above 2 E I2): half round, the other two components have changed sign.
    let half = motion.omega(0.5 * period).unwrap();
    assert!((half - Vector3::new(-0.3, -1.0, -0.4)).norm() < 1e-14);
}

/// A body with two equal moments, spun askew.
fn top() -> impl Strategy<Value = (Vector3<f64>, Vector3<f64>, usize)> {
    (0.2..1.9_f64, generic_spin(), 0..3_usize).prop_filter_map("a sphere", |(c, omega, axis)| {
        let mut moments = Vector3::repeat(1.0);
        moments[axis] = c;
        ((c - 1.0).abs() > 0.05).then_some((moments, omega, axis))
    })
}

proptest! {
    // Independent: the angles seen along the way. Of a top's three axes the middle is met by none of the others' rules.
    #[test]
    fn a_tops_angles_to_the_momentum_bound_its_motion_and_are_reached((m, omega, _) in top()) {
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        angles_bound_the_motion(&m, &motion)?;
    }

    // The rate about the momentum, (2E + L w)/(L + I w), is constant here; and what the twist means for the attitude.
    #[test]
    fn a_tops_twist_is_its_rate_about_the_momentum_for_half_a_period((m, omega, axis) in top()) {
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
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

/// With I1 (I2 - I1) next to I3 (I3 - I2) and two pushes alike, the motion is nearer to the separatrix by far than the push is
/// to nothing: the least spin it passes is below all numbers, and the scale that undoes it has to come in two parts.
#[test]
fn the_least_push_beside_a_slow_spin_grows_to_a_whole_flip() {
    // 0.7 · 0.3 = c (c - 1) for c = (1 + sqrt(1.84))/2.
    let c = 0.5 * (1.0 + 1.84_f64.sqrt());
    for (push, power) in [(5e-324, -99), (-5e-324, -100), (5e-324, -101), (5e-324, -102)] {
        let slow = 2_f64.powi(power);
        let motion = motion([0.7, 1.0, c], [5e-324, slow, push]);
        let Regime::Elliptic { complement, .. } = motion.regime() else { panic!("{:?}", motion.regime()) };
        assert!(complement < 1e-298, "{complement:e}");
        let flip = motion.next_flip(0.0).unwrap().unwrap();
        let w = motion.omega(flip).unwrap() / slow;
        // All of energy and momentum is across and around: I1 w1² + I3 w3² = 1 and I1² w1² + I3² w3² = 1.
        let [x, z] = [(c - 1.0) / (0.7 * (c - 0.7)), 0.3 / (c * (c - 0.7))].map(f64::sqrt);
        assert!(
            w.y.abs() < 1e-12 && (w.x.abs() / x - 1.0).abs() < 1e-13 && (w.z.abs() / z - 1.0).abs() < 1e-13,
            "{w:?}"
        );
    }
}

/// A tensor given askew has each entry rounded beside the largest moment, and the smallest moment of a needle with
/// it: what the documentation of `FreeMotion::of` says.
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
            let (at, plain) = (
                askew.at(t).unwrap(),
                FreeMotion::new(m.try_into().unwrap(), &omega).unwrap().at(t).unwrap(),
            );
            let spin = (at.omega - turned * plain.omega).norm() / omega.norm();
            let attitude = apart(&at.attitude, &(plain.attitude * turned.inverse()));
            worst = [
                worst[0].max((askew.moments().vector().min() / thin - 1.0).abs()),
                worst[1].max(spin.max(attitude)),
            ];
        }
        let unit = 0.5 * f64::EPSILON / thin;
        assert!(worst[0] < 4.0 * unit && worst[1] < 8.0 * unit, "{thin:e}: {worst:?}");
        // And not better: the sentence is no bound out of the air.
        assert!(worst[0] > unit && worst[1] > unit, "{thin:e}: {worst:?}");
    }
}

/// Which end of its swing is whose, by hand: with moments (1, 2, 3) and the spin (0, 0.03, -1) the third axis is 2/100 off at
/// the start and 1/100 a quarter period later, seen from behind.
#[test]
fn a_spin_the_other_way_round_swings_about_the_opposite_of_the_momentum() {
    let motion = motion([1.0, 2.0, 3.0], [0.0, 0.03, -1.0]);
    let [least, most] = motion.angles_to_momentum(2).unwrap().map(|a| PI - a);
    assert!((least - 0.02).abs() < 1e-5 && (most - 0.01).abs() < 1e-5, "{least} {most}");
    assert!(matches!(motion.regime(), Regime::Elliptic { about: Axis::Largest, rate, .. } if rate > 0.0));
}

/// The top's greatest component is the radius of its circle: for (1, 1) it is sqrt(2).
#[test]
fn a_top_that_swings_beyond_the_range_is_refused() {
    let new = |w: f64| FreeMotion::new(PrincipalMoments::new(1.0, 1.0, 1.5)?, &Vector3::new(w, w, 1.0));
    assert!(new(1.27e308).is_ok());
    assert!(new(1.28e308).unwrap_err().to_string().contains("the greatest spin"));
}

/// A wobble beside a spin near the end of the range: with moments (1, 1.9, 2) the push along the first axis comes along the
/// second sqrt(1/0.19) = 2.3 times as great, which is still nothing beside the spin.
#[test]
fn a_small_wobble_of_the_fastest_spin_is_within_the_range() {
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
fn a_steady_spin_keeps_its_angles_and_grows_about_the_middle_axis_alone() {
    let angles = |m: [f64; 3], w: [f64; 3], axis| motion(m, w).angles_to_momentum(axis).unwrap();
    assert_eq!(angles([1.0, 2.0, 3.0], [0.0, -2.0, 0.0], 1), [PI; 2]);
    assert_eq!(angles([1.0, 2.0, 3.0], [0.0, 2.0, 0.0], 1), [0.0; 2]);
    let [least, most] = angles([2.0, 2.0, 2.0], [3.0, 0.0, -4.0], 2);
    assert!(least == most && (least.cos() + 0.8).abs() < 1e-15);
    let growth = |w: [f64; 3]| motion([1.0, 3.0, 2.0], w).growth_rate().unwrap();
    assert_eq!((growth([2.0, 0.0, 0.0]), growth([0.0, 2.0, 0.0])), (None, None));
    // sqrt((3-2)(2-1)/(3·1)) of the spin.
    assert!((growth([0.0, 0.0, -2.0]).unwrap() - 2.0 / 3_f64.sqrt()).abs() < 1e-15);
}

#[test]
fn the_thinnest_needle_is_as_thin_as_the_documentation_says() {
    let new =
        |thin: f64| FreeMotion::new(PrincipalMoments::new(thin, 1.0, 1.0)?, &Vector3::new(1.0, 0.5, 0.25));
    assert!(new(1.001e-100).is_ok());
    assert!(new(0.999e-100).unwrap_err().to_string().contains("1e-100 of the largest moment"));
}

proptest! {
    // Continuity: the motion is prepared so that it starts where it was told to, to the few roundings that any answer may have.
    #[test]
    fn an_instant_after_the_start_the_spin_is_still_the_starts(m in moments(), omega in generic_spin()) {
        let motion = FreeMotion::new(m.try_into().unwrap(), &omega).unwrap();
        let soon = motion.omega(1e-300).unwrap();
        let off = (soon - omega).norm() / (omega.norm() * 0.5 * f64::EPSILON);
        prop_assert!(off <= 8.0, "{off}");
    }
}

/// A modulus is at most 1, and where it is 1 to rounding the complement still tells the motion from the separatrix.
#[test]
fn the_modulus_next_to_the_separatrix_is_not_above_one() {
    for (moments, omega) in [
        (
            [1.438952918759294, 2.0351257746035527, 3.054333979342899],
            [-2.803572890169369e-10, 1.4128433977268962, 4.337202859078787e-10],
        ),
        (
            [1.4560894309137202, 2.640236159616809, 3.181192674717668],
            [-2.1973103005059826e-13, 1.1949140362241835, 9.800867417548897e-15],
        ),
        (
            [1.9149007781432585, 2.7781989565381853, 3.416671648272757],
            [-1.4142360841877147e-15, 1.2921435889791737, -1.7173859936859786e-16],
        ),
    ] {
        let regime = motion(moments, omega).regime();
        let Regime::Elliptic { modulus, complement, .. } = regime else { panic!("{regime:?}") };
        assert!(modulus == 1.0 && complement > 0.0, "{modulus:?} {complement:e}");
    }
}

#[test]
fn a_spin_too_fast_to_be_turned_is_refused_and_none_comes_out_infinite() {
    // Along its principal axes a motion may reach the largest numbers; a turn of its axes needs room for a sum of products.
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
    // In the world.
    for moments in [[1.1, 0.46, 1.05], [1.0, 1.0, 1.0]] {
        let motion = motion(moments, [1.5e308, 0.0, 0.2e308]);
        for k in 0..5 {
            let world = motion.at(0.25e-300 * f64::from(k)).unwrap().omega_world();
            assert!(world.iter().all(|x| x.is_finite()), "{world:?}");
        }
    }
    let sphere = PrincipalMoments::new(1.0, 1.0, 1.0).unwrap();
    let speed = FreeMotion::new(sphere, &Vector3::new(-1.4e308, 1.5e308, 0.0));
    refused(speed, ErrorKind::Unrepresentable, "the greatest spin");
}

#[test]
fn a_top_that_hardly_leaves_its_plane_turns_too_far_in_a_period_to_say() {
    // It turns 1e459 times while the spin goes round once.
    for omega in [[-3.8e-159, 1e300, 0.0], [5e-324, 0.3, 0.7]] {
        let top = motion([0.66, 1.0, 1.0], omega);
        assert_eq!(top.twist_of_half_period(), None);
    }
}

#[test]
fn a_top_that_precesses_faster_than_any_number_is_refused() {
    let moments = PrincipalMoments::new(1.0, 1.5, 1.0).unwrap();
    let spin = Vector3::new(1.42e308, -8.1e307, 0.0);
    refused(FreeMotion::new(moments, &spin), ErrorKind::Unrepresentable, "the greatest spin");
    let slower = FreeMotion::new(moments, &(spin * 0.9)).unwrap().regime();
    let Regime::SymmetricTop { precession, nutation, .. } = slower else { panic!("{slower:?}") };
    assert!(precession.is_finite() && nutation.is_finite(), "{slower:?}");
}

#[test]
fn a_spin_near_the_largest_number_is_seen_from_the_world_without_overflow_on_the_way() {
    let attitude = UnitQuaternion::from_euler_angles(0.4, -1.1, 2.0);
    for omega in [Vector3::new(1.2e308, -0.9e308, 0.4e308), Vector3::new(0.0, 0.0, f64::MAX)] {
        let seen = Instant { omega, attitude }.omega_world();
        // The same at a size where nothing can overflow.
        let expected = (attitude * (omega * 2_f64.powi(-100))) * 2_f64.powi(100);
        assert!((seen - expected).amax() <= 1e-15 * f64::MAX, "{seen:?} {expected:?}");
    }
}

#[test]
fn the_least_angle_to_the_momentum_is_never_above_the_greatest() {
    // Two nearly equal moments: the angle of the third axis hardly changes, and each end of it is rounded on its own.
    for (moments, spin) in [
        (
            [1.5463115524768785, 0.15793951781592125, 1.546311552476878],
            [2.9443699667069355e-12, 0.008461038541345722, 2.337619889869514e-12],
        ),
        (
            [0.32208655359701216, 1.5075885918855068, 1.5075885918855072],
            [0.3305833545466712, -1.3463766437893453e-13, 2.9300662807181733e-12],
        ),
        (
            [0.1599023396688262, 1.5881908226623311, 1.5881908226623322],
            [0.0048208142785995944, 1.9955963649353153e-7, 1.6650504418126145e-7],
        ),
    ] {
        let motion = motion(moments, spin);
        for axis in 0..3 {
            let [least, most] = motion.angles_to_momentum(axis).unwrap();
            assert!(least <= most, "{moments:?} {axis}: {least:?} {most:?}");
        }
    }
}
