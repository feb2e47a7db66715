//! The position stage of an engine: no energy from nothing, flips at the right times, any body, any step.
//! These tests take millions of steps, and generic code is optimised with the crate that uses it: so they are
//! here.

use super::{PositionStage, Stepped};
use crate::body::named::NamedBody;
use crate::exact::FreeMotion;
use crate::number::Field;
use alloc::vec::Vec;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use num_traits::Float;
use proptest::prelude::*;

trait Real: Field + Float + From<f32> + Into<f64> {}
impl<T: Field + Float + From<f32> + Into<f64>> Real for T {}

fn real<T: Real>(x: f64) -> T {
    <T as num_traits::NumCast>::from(x).unwrap()
}

fn free_motion(moments: Vector3<f64>, omega: &Vector3<f64>) -> FreeMotion {
    FreeMotion::new(moments.try_into().unwrap(), omega).unwrap()
}

/// A motion in `f64`: the attitude with length 1, the spin and the momentum along the principal axes.
struct Seen {
    attitude: UnitQuaternion<f64>,
    omega: Vector3<f64>,
    momentum: Vector3<f64>,
}

fn seen<T: Real>(moments: &Vector3<f64>, motion: &Stepped<T>) -> Seen {
    let [x, y, z, w] = [0, 1, 2, 3].map(|i| motion.attitude.coords[i].into());
    let attitude = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
    let omega = attitude.inverse() * Vector3::from_fn(|i, _| motion.omega[i].into());
    Seen { attitude, omega, momentum: moments.component_mul(&omega) }
}

fn energy<T: Real>(moments: &Vector3<f64>, motion: &Stepped<T>) -> f64 {
    let seen = seen(moments, motion);
    seen.omega.dot(&seen.momentum) / 2.0
}

fn momentum_world<T: Real>(moments: &Vector3<f64>, motion: &Stepped<T>) -> Vector3<f64> {
    let seen = seen(moments, motion);
    seen.attitude * seen.momentum
}

fn start<T: Real>(omega: [f64; 3]) -> Stepped<T> {
    let attitude = Quaternion::new(0.5, 0.5, -0.5, 0.5).coords.map(real::<T>);
    let turned = UnitQuaternion::new_unchecked(Quaternion::new(0.5, 0.5, -0.5, 0.5)) * Vector3::from(omega);
    Stepped { attitude: Quaternion::from_vector(attitude), omega: turned.map(real::<T>), parts: 1 }
}

fn body<T: Real>(moments: &Vector3<f64>) -> PositionStage<T> {
    PositionStage::new(&moments.map(real::<T>)).unwrap()
}

fn stepped<T: Real>(body: &PositionStage<T>, from: &Stepped<T>, h: f64) -> Stepped<T> {
    let end = body.step(&from.attitude, &from.omega, real(h));
    assert!(end.parts > 0, "{from:?}");
    end
}

/// Bodies of every kind: flat, long, round, nearly round, thin.
const BODIES: [[f64; 3]; 8] = [
    [10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0],
    [2.0, 1.0, 3.0],
    [1e-3, 1.0, 1.0005],
    [1.0, 1.0, 1.0],
    [2.0, 3.0, 2.0],
    [1.0, 1.0 + 1e-6, 1.0 + 2e-6],
    [0.002, 0.01, 0.0115],
    [3.0, 1.0, 9.0],
];

#[test]
fn the_motion_is_the_exact_one_at_sixty_hertz() {
    for moments in &BODIES[..7] {
        let moments = Vector3::from(*moments);
        for omega in [[0.1, 10.0, 0.2], [3.0, -4.0, 6.0]] {
            let body = body::<f64>(&moments);
            let mut motion = start(omega);
            let from = seen(&moments, &motion);
            for _ in 0..600 {
                motion = stepped(&body, &motion, 1.0 / 60.0);
            }
            let truth = free_motion(moments, &from.omega).at(10.0).unwrap();
            let end = seen(&moments, &motion);
            let off = (end.omega - truth.omega).norm() / from.omega.norm();
            assert!(off < 1e-9, "{moments}: spin off by {off:e}");
            let off = end.attitude.angle_to(&(from.attitude * truth.attitude));
            assert!(off < 3e-6, "{moments}: attitude off by {off:e}");
        }
    }
}

/// The flips of ten minutes at 60 Hz.
struct Flips {
    counted: usize,
    /// Their number in the exact motion.
    exact: usize,
    /// Their number if, between two seconds, the motion is the exact one from the state at the first.
    piecewise: f64,
    /// The largest error in the time of a flip, s.
    late: f64,
    /// The largest change of `2 E I_2 - |L|^2`, which sets the time between two flips, relative to `|L|^2`.
    walked: f64,
}

fn flips<T: Real>(moments: &Vector3<f64>, omega: [f64; 3]) -> Flips {
    // The moments as rounded to the number type.
    let moments = &moments.map(|x| real::<T>(x).into());
    let exact: Vec<f64> = free_motion(*moments, &omega.into()).flips(0.0, 600.0).unwrap().collect();
    let form = moments.map(|moment| moment * (moments.y - moment));
    let parted = |omega: &Vector3<f64>| form.dot(&omega.component_mul(omega));
    let square = moments.component_mul(&Vector3::from(omega)).norm_squared();
    let body = body::<T>(moments);
    let mut motion = start::<T>(omega);
    // The step as rounded to the number type.
    let h: f64 = real::<T>(1.0 / 60.0).into();
    let mut flips = Flips { counted: 0, exact: exact.len(), piecewise: 0.0, late: 0.0, walked: 0.0 };
    let mut before = omega[1];
    for k in 0..36_000 {
        let now = seen(moments, &motion).omega;
        if k % 60 == 0 {
            let period = free_motion(*moments, &now).period().unwrap().unwrap();
            flips.piecewise += 60.0 * h / (period / 2.0);
            flips.walked = flips.walked.max((parted(&now) - parted(&omega.into())).abs() / square);
        }
        motion = stepped(&body, &motion, h);
        let after = seen(moments, &motion).omega.y;
        if (before > 0.0) != (after > 0.0) {
            let time = h * (f64::from(k) + before / (before - after));
            flips.late = flips.late.max(exact.get(flips.counted).map_or(0.0, |flip| (time - flip).abs()));
            flips.counted += 1;
        }
        before = after;
    }
    flips
}

#[test]
fn every_flip_of_ten_minutes_comes_at_its_time() {
    for name in NamedBody::ALL {
        let moments = name.properties().unwrap().inertia().principal().moments();
        for push in [0.1, 1e-3] {
            let Flips { counted, exact, late, .. } = flips::<f64>(&moments, [15.0 * push, 15.0, 15.0 * push]);
            assert!(
                counted == exact && late < 0.1 / 60.0,
                "{name}, push {push}: {counted}/{exact}, {late} s"
            );
        }
        // The rounding of the energy in single precision changes the time between flips, and nothing else.
        let Flips { counted, exact, piecewise, walked, .. } = flips::<f32>(&moments, [0.6, 6.0, 0.6]);
        assert!((counted as f64 - piecewise).abs() < 1.0, "{name}: {counted} of {piecewise}, exact {exact}");
        assert!(counted.abs_diff(exact) <= 2, "{name}: {counted}, not {exact}");
        assert!(walked < 3e-5, "{name}: {walked:e}");
    }
}

/// A spin about one axis with a little about the others.
fn stable<T: Real>(axis: impl Fn(&Vector3<f64>) -> usize, bodies: &[[f64; 3]], seconds: u32, bound: f64) {
    for moments in bodies {
        let moments = Vector3::from(*moments);
        let body = body::<T>(&moments);
        let mut spin = [0.3; 3];
        spin[axis(&moments)] = 10.0;
        let mut motion = start::<T>(spin);
        let (energy_0, momentum_0) = (energy(&moments, &motion), momentum_world(&moments, &motion));
        for _ in 0..60 * seconds {
            motion = stepped(&body, &motion, 1.0 / 60.0);
        }
        let gained = energy(&moments, &motion) / energy_0 - 1.0;
        let turned = (momentum_world(&moments, &motion) - momentum_0).norm() / momentum_0.norm();
        assert!(gained.abs() < bound && turned < bound, "{moments}: {gained:e}, {turned:e}");
    }
}

#[test]
fn a_stable_spin_keeps_energy_and_momentum_for_an_hour() {
    stable::<f64>(Vector3::imax, &BODIES, 3600, 1e-12);
    stable::<f32>(Vector3::imax, &BODIES, 3600, 1e-3);
    stable::<f64>(Vector3::imin, &BODIES, 600, 1e-12);
    // A needle is left out: the length of its spin is rounded to the share that its momentum has of it.
    let thick: Vec<_> = BODIES.into_iter().filter(|moments| moments[0] > 1e-2 || moments[1] < 0.1).collect();
    assert_eq!(thick.len(), 7);
    stable::<f32>(Vector3::imin, &thick, 600, 1e-3);
}

#[derive(Debug, Clone)]
enum Event {
    Kick([f64; 3]),
    Impulse([f64; 3]),
    Damping(f64),
    Step(f64),
}

fn event() -> impl Strategy<Value = Event> {
    let vector = || [-1.0..1.0, -1.0..1.0, -1.0..1.0_f64];
    prop_oneof![
        vector().prop_map(Event::Kick),
        vector().prop_map(Event::Impulse),
        (0.0..0.3).prop_map(Event::Damping),
        // From a hundredth of a radian to a hundred.
        (-2.0..2.0_f64).prop_map(|x| Event::Step(10_f64.powf(x))),
    ]
}

/// The energy gained beyond the work done, in units of rounding and of the number of parts: the stages of an
/// engine do work on the spin, and any other energy comes from nowhere. A relative rounding of the spin
/// changes the energy by the same fraction of `|omega| |L|`.
fn from_nowhere<T: Real>(moments: [f64; 3], events: &[Event]) -> f64 {
    let moments = Vector3::from(moments);
    let body = body::<T>(&moments);
    let mut motion = start::<T>([2.0, -7.0, 3.0]);
    let (from, mut work, mut most, mut parts) = (energy(&moments, &motion), 0.0, 0.0_f64, 0);
    let unit = |now: &Seen| now.omega.norm() * now.momentum.norm() / 2.0;
    for event in events {
        let before = energy(&moments, &motion);
        let now = seen(&moments, &motion);
        most = most.max(unit(&now));
        let kicked =
            |momentum: Vector3<f64>| (now.attitude * momentum.component_div(&moments)).map(real::<T>);
        let size = now.momentum.norm() / 4.0;
        match event {
            Event::Kick(impulse) => motion.omega += kicked(Vector3::from(*impulse) * size),
            Event::Impulse(impulse) => {
                motion.omega += kicked(now.attitude.inverse() * Vector3::from(*impulse) * size);
            }
            Event::Damping(share) => motion.omega *= real::<T>(1.0 - share),
            Event::Step(turn) => {
                // The fastest spin at this energy, so that the turn is at most as stated.
                let h = turn / now.omega.norm().max((2.0 * before / moments.min()).sqrt());
                motion = stepped(&body, &motion, h);
                parts += motion.parts;
                continue;
            }
        }
        work += energy(&moments, &motion) - before;
    }
    most = most.max(unit(&seen(&moments, &motion)));
    let rounding: f64 = T::epsilon().into();
    (energy(&moments, &motion) - from - work) / (most * rounding * f64::from(parts.max(1)))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_energy_gained_is_the_work_done_whatever_acts_and_however_long_the_steps(
        which in 0..8_usize, events in prop::collection::vec(event(), 1..60),
    ) {
        // A few roundings a part, of the attitude and of the spin.
        let double = from_nowhere::<f64>(BODIES[which], &events);
        prop_assert!(double.abs() < 4.0, "f64: {}", double);
        let single = from_nowhere::<f32>(BODIES[which], &events);
        prop_assert!(single.abs() < 4.0, "f32: {}", single);
    }
}

#[test]
fn a_step_back_undoes_a_step() {
    for moments in BODIES {
        let moments = Vector3::from(moments);
        let body = body::<f64>(&moments);
        let from = start::<f64>([2.0, -7.0, 3.0]);
        for h in [1e-3, 0.03, 1.0] {
            let there = stepped(&body, &from, h);
            let back = stepped(&body, &there, -h);
            let (spin, turn) = ((back.omega - from.omega).norm(), (back.attitude - from.attitude).norm());
            assert!(spin < 1e-11 && turn < 1e-11, "{moments}, {h}: {spin:e}, {turn:e}");
        }
    }
}

#[test]
fn a_tensor_in_any_frame_moves_as_in_its_own() {
    let moments = Vector3::new(2.0, 1.0, 2.7);
    let frame = UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -1.1, 0.7));
    let own = body::<f64>(&moments);
    let framed = own.in_frame(*frame.quaternion()).unwrap();
    let mut a = start::<f64>([1.0, 5.0, -2.0]);
    let mut b = Stepped { attitude: a.attitude * frame.inverse().quaternion(), ..a };
    for _ in 0..100 {
        a = stepped(&own, &a, 0.02);
        b = stepped(&framed, &b, 0.02);
    }
    assert!((a.omega - b.omega).norm() < 1e-12);
    assert!((a.attitude.coords - (b.attitude * frame.quaternion()).coords).norm() < 1e-12);
}

/// Powers of two, so that only overflow and underflow could make a difference.
fn frames_of_any_length<T: Real + core::fmt::Debug>(exponents: core::ops::RangeInclusive<i32>) {
    let own = body::<T>(&Vector3::new(0.3, 0.5, 0.7));
    let from = start::<T>([1.0, 4.0, -2.0]);
    let frame = |size: T| own.in_frame(Quaternion::new(size, -size, size, size));
    let expected = stepped(&frame(T::one()).unwrap(), &from, 0.0625);
    assert!(expected != stepped(&own, &from, 0.0625));
    for exponent in exponents {
        let size = real::<T>(2.0).powi(exponent);
        assert_eq!(stepped(&frame(size).unwrap(), &from, 0.0625), expected, "2^{exponent}");
    }
    for size in [T::zero(), T::nan(), T::infinity(), T::neg_infinity()] {
        assert!(frame(size).is_err(), "{size:?}");
    }
    let none = Quaternion::new(T::one(), T::zero(), T::nan(), T::zero());
    assert_eq!(own.in_frame(none).unwrap_err().kind(), crate::ErrorKind::NotFinite);
}

#[test]
fn a_frame_of_any_length_stands_for_its_direction_and_one_of_none_is_refused() {
    frames_of_any_length::<f64>(-1022..=1023);
    frames_of_any_length::<f32>(-126..=127);
}

#[test]
fn moments_whose_ratios_have_no_number_are_refused() {
    for moments in [[1e-300, 1.0, 1e300], [1e-308, 1.0, 1.5], [1.0, 1e300, 1.0], [1.0, 1e200, 1e-200]] {
        let refused = PositionStage::new(&Vector3::from(moments)).unwrap_err();
        assert_eq!(refused.kind(), crate::ErrorKind::Unrepresentable, "{moments:?}");
        let inverse = Vector3::from(moments.map(|x| 1.0 / x));
        assert!(PositionStage::of_inverse(&inverse).is_err(), "{moments:?}");
    }
    let needle = body::<f64>(&Vector3::new(1e-100, 1.0, 1.0));
    assert_eq!(stepped(&needle, &start([0.0, 4.0, -2.0]), 0.01).parts, 1);
}

#[test]
fn a_body_with_locked_axes_keeps_its_spin_and_turns_about_it() {
    for inverse in [[0.0, 0.5, 2.0], [0.0, 0.0, 2.0], [0.0, 0.0, 0.0]] {
        let body = PositionStage::of_inverse(&Vector3::from(inverse)).unwrap();
        let mut omega = [3.0, 2.0, 1.0];
        // No spin about a locked axis, but of a body that a script moves.
        for i in 0..3 {
            omega[i] = if inverse[i] == 0.0 && inverse != [0.0; 3] { 0.0 } else { omega[i] };
        }
        let from = start::<f64>(omega);
        let end = stepped(&body, &from, 0.1);
        assert_eq!(end.omega, from.omega);
        let turn = UnitQuaternion::from_scaled_axis(from.omega * 0.1);
        assert!(((turn.quaternion() * from.attitude).coords - end.attitude.coords).norm() < 1e-7);
    }
}

/// The engine's solver has left no spin about the locked axes of the world.
#[test]
fn with_two_axes_of_the_world_locked_the_motion_is_exact_and_with_one_it_keeps_the_energy() {
    let moments = Vector3::new(1.0, 2.0, 2.5);
    let body = PositionStage::of_inverse(&Vector3::zeros()).unwrap();
    let tilted = Quaternion::new(0.5, 0.1, -0.7, 0.5);
    let attitude = Quaternion::from_vector(tilted.coords / tilted.norm());
    let along = |motion: &Stepped<f64>, i: usize| momentum_world(&moments, motion)[i];
    let moved = |omega: Vector3<f64>| {
        let from = Stepped { attitude, omega, parts: 1 };
        (from, (0..50).fold(from, |at, _| stepped(&body, &at, 0.02)))
    };
    // About z alone: the moment about it is the same all the way round, so the exact spin is constant.
    let (from, end) = moved(Vector3::new(0.0, 0.0, 3.0));
    assert_eq!(end.omega, from.omega);
    assert!((along(&end, 2) - along(&from, 2)).abs() < 1e-12);
    let turn = UnitQuaternion::from_scaled_axis(from.omega);
    assert!(
        (UnitQuaternion::from_quaternion(end.attitude)
            .angle_to(&(turn * UnitQuaternion::from_quaternion(attitude))))
            < 1e-5
    );
    // About y and z: the energy stays, but an exact motion would keep the momentum about both.
    let (from, end) = moved(Vector3::new(0.0, 2.0, 3.0));
    assert!((energy(&moments, &end) - energy(&moments, &from)).abs() < 1e-12);
    assert!((along(&end, 1) - along(&from, 1)).abs() > 0.1);
}

/// Both terms of the series for the turn about the momentum, and their product.
#[test]
fn the_attitude_is_of_sixth_order_and_the_spin_better() {
    let moments = Vector3::new(2.0, 1.0, 3.0);
    let body = body::<f64>(&moments);
    let off = |h: f64| {
        let from = start::<f64>([2.0, -4.0, 3.0]);
        let start = seen(&moments, &from);
        let steps = (1.0 / h).round() as u32;
        let end = (0..steps).fold(from, |at, _| stepped(&body, &at, h));
        let truth = free_motion(moments, &start.omega).at(1.0).unwrap();
        let end = seen(&moments, &end);
        ((end.omega - truth.omega).norm(), end.attitude.angle_to(&(start.attitude * truth.attitude)))
    };
    let ((spin, attitude), (_, half_attitude)) = (off(1.0 / 24.0), off(1.0 / 48.0));
    assert!(spin < 1e-12 && (5.5e-8..6.6e-8).contains(&attitude), "{spin:e} {attitude:e}");
    assert!((50.0..80.0).contains(&(attitude / half_attitude)));
}

#[test]
fn a_rod_without_thickness_turns_over_and_its_own_spin_weighs_nothing() {
    let rod = body::<f64>(&Vector3::new(0.0, 2.0, 2.0));
    let thin = body::<f64>(&Vector3::new(1e-12, 2.0, 2.0));
    let from = start::<f64>([1.5, 4.0, -3.0]);
    let (a, b) = (stepped(&rod, &from, 0.1), stepped(&thin, &from, 0.1));
    assert!((a.omega - b.omega).norm() < 1e-10 && (a.attitude - b.attitude).norm() < 1e-10);
    assert!(PositionStage::new(&Vector3::new(0.0, 2.0, 2.1)).is_err());
}

#[test]
fn what_cannot_be_stepped_stays_as_it_was_and_says_so() {
    let body = body::<f32>(&Vector3::new(1.0, 2.0, 2.5));
    let unit = Quaternion::new(1.0, 0.0, 0.0, 0.0);
    let (slow, fast) = (Vector3::new(1.0_f32, 2.0, 3.0), Vector3::new(1e6_f32, 2.0, 3.0));
    let none = Vector3::repeat(f32::NAN);
    let endless = Vector3::repeat(f32::INFINITY);
    let zero = Quaternion::new(0.0, 0.0, 0.0, 0.0);
    for (attitude, omega, h) in [
        (unit, fast, 1.0),
        (unit, none, 0.01),
        (unit, endless, 0.01),
        (zero, slow, 0.01),
        (unit, slow, f32::NAN),
        (unit, slow, f32::INFINITY),
        (Quaternion::new(f32::NAN, 0.0, 0.0, 0.0), slow, 0.01),
    ] {
        let end = body.step(&attitude, &omega, h);
        assert_eq!(end.parts, 0);
        let same = |a: &[f32], b: &[f32]| a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits());
        assert!(same(end.omega.as_slice(), omega.as_slice()));
        assert!(same(end.attitude.coords.as_slice(), attitude.coords.as_slice()));
    }
    assert_eq!(body.step(&unit, &slow, 0.0).omega, slow);
    // An attitude of another length stands for its direction.
    let long = body.step(&Quaternion::new(3.0, 0.0, 0.0, 0.0), &slow, 0.01);
    assert_eq!(long, body.step(&unit, &slow, 0.01));
    for moments in [[-1.0, 1.0, 1.0], [1.0, f32::NAN, 1.0], [1.0, 1.0, f32::INFINITY]] {
        assert!(PositionStage::new(&Vector3::from(moments)).is_err());
    }
    assert!(PositionStage::of_inverse(&Vector3::new(1.0, -1.0, 1.0)).is_err());
}

/// Independent: the exponential map of nalgebra.
#[test]
fn a_round_body_and_one_slower_than_rounding_turn_about_the_spin_that_they_keep() {
    let spin = Vector3::new(3.0, -4.0, 6.0);
    for (moments, speed, h) in [([2.0; 3], 1.0, 0.1 / 7.8), ([1.0, 2.0, 3.0], 1e-17, 1.0 / 60.0)] {
        for frame in [Quaternion::identity(), Quaternion::new(0.6, 0.0, -0.8, 0.1)] {
            let body = body::<f64>(&Vector3::from(moments)).in_frame(frame).unwrap();
            let from = Stepped { omega: spin * speed, ..start([0.0; 3]) };
            let end = stepped(&body, &from, h);
            assert_eq!(end.omega, from.omega);
            let exact = UnitQuaternion::from_scaled_axis(from.omega * h).into_inner() * from.attitude;
            assert!((end.attitude - exact).norm() < 1e-12 * (from.omega.norm() * h).max(1e-3));
        }
    }
}
