//! The step at a fixed rate: flips counted, stable spins kept, long steps taken in parts.

use super::{changes, free, free_motion, start};
use nalgebra::{Quaternion, UnitQuaternion, Vector3, Vector4};
use proptest::prelude::*;
use tumbling::body::named::NamedBody;
use tumbling::exact::FreeMotion;
use tumbling::solid::{Cylinder, Solid};
use tumbling::step::{Method, State, System, fixed_rate};
use tumbling::{Axis, Error, PrincipalMoments, Subject};

/// Moments of the named bodies, the box first among them: smallest, middle, largest.
fn named() -> impl Iterator<Item = (NamedBody, Vector3<f64>)> {
    NamedBody::ALL
        .into_iter()
        .map(|body| (body, body.properties().expect("a body").inertia().principal().moments()))
}

#[test]
fn a_game_counts_every_flip_of_ten_minutes_at_60_hertz() {
    let h = 1.0 / 60.0;
    let mut counted = 0;
    for (name, moments) in named() {
        let system = free(moments);
        for spin in [1.0, 6.0, 15.0] {
            for push in [0.1, 0.01, 1e-3] {
                let omega = Vector3::new(push, 1.0, push) * spin;
                let flips: Vec<f64> = free_motion(moments, &omega).flips(0.0, 600.0).unwrap().collect();
                let mut motion = start(&system, &omega);
                let mut seen = Vec::new();
                for step in 0..36_000 {
                    let next = fixed_rate(&system, &motion, h).unwrap();
                    let (before, after) = (motion.momentum.y, next.momentum.y);
                    if (before > 0.0) != (after > 0.0) {
                        seen.push(h * (f64::from(step) + before / (before - after)));
                    }
                    motion = next;
                }
                assert_eq!(seen.len(), flips.len(), "{name}, {spin} rad/s, push {push}");
                // Each within a tenth of a frame: the line between two frames misses the flip by some of
                // that.
                let late = seen.iter().zip(&flips).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
                assert!(late < 0.1 * h, "{name}, {spin} rad/s, push {push}: {late} s");
                counted += flips.len();
            }
        }
    }
    assert!(counted > 15_000, "{counted}");
}

#[test]
fn a_push_as_small_as_rounding_is_where_a_game_miscounts() {
    // The energy that parts this motion from the one that never returns is 1e-16 of the whole.
    let (_, moments) = named().next().unwrap();
    let omega = Vector3::new(1e-8, 1.0, 1e-8) * 15.0;
    let system = free(moments);
    let flips = free_motion(moments, &omega).flips(0.0, 600.0).unwrap().count();
    let mut motion = start(&system, &omega);
    let mut seen = 0;
    for _ in 0..36_000 {
        let next = fixed_rate(&system, &motion, 1.0 / 60.0).unwrap();
        seen += usize::from((motion.momentum.y > 0.0) != (next.momentum.y > 0.0));
        motion = next;
    }
    assert!(seen > flips + 3 && seen < 2 * flips, "{seen} of {flips}");
}

#[test]
fn a_stable_spin_stays_where_it_is_for_an_hour_in_a_game() {
    for (name, moments) in named() {
        let system = free(moments);
        for side in [Axis::Smallest, Axis::Largest] {
            let axis = PrincipalMoments::try_from(moments).unwrap().axis(side);
            let mut omega = Vector3::new(0.3, 0.3, 0.3);
            omega[axis] = 10.0;
            let start = start(&system, &omega);
            let angles = free_motion(moments, &omega).angles_to_momentum(side).unwrap();
            let mut motion = start;
            for _ in 0..36_000 {
                motion = fixed_rate(&system, &motion, 0.1).unwrap();
                let angle = (motion.momentum[axis] / motion.momentum.norm()).acos();
                assert!(
                    angle > angles[0] - 1e-9 && angle < angles[1] + 1e-9,
                    "{name}: {angle} off {angles:?}"
                );
            }
            let most = changes(&system, &start, &motion).into_iter().fold(0.0, f64::max);
            assert!(most < 1e-11, "{name}: {most:e}");
        }
    }
}

#[test]
fn a_step_of_many_turns_is_taken_in_parts_in_a_game() {
    let moments = Vector3::new(1.0, 2.0, 2.5);
    let omega = Vector3::new(3.0, 100.0, 20.0);
    let system = free(moments);
    let start = start(&system, &omega);
    let end = fixed_rate(&system, &start, 1.0).unwrap();
    let truth = free_motion(moments, &omega).at(1.0).unwrap();
    let off = (end.attitude.coords - truth.attitude.coords).norm();
    let off = off.min((end.attitude.coords + truth.attitude.coords).norm());
    // With `b/a` of its moments to order 8 alone it would be 7e-7.
    assert!(off < 1e-7, "{off:e}");
}

#[test]
fn a_game_steps_spheres_tops_and_bodies_of_any_mass() {
    let omega = Vector3::new(3.0, 4.0, -5.0);
    let needle = |system: System<f64>| fixed_rate(&system, &start(&system, &omega), 0.01);
    assert!(needle(free([1e-12, 1.0, 1.0])).is_ok() && needle(free([1e-13, 1.0, 1.0])).is_err());
    for shape in [[2.0, 2.0, 2.0], [2.0, 2.0, 3.0], [2.0, 3.0, 3.0], [1.0, 2.0, 2.6]] {
        for mass in [1.0, 1e-150, 1e150] {
            let moments = Vector3::from(shape) * mass;
            let system = free(moments);
            let mut motion = start(&system, &omega);
            for _ in 0..60 {
                motion = tumbling::step::fixed_rate(&system, &motion, 1.0 / 60.0).unwrap();
            }
            let truth = free_motion(moments, &omega).at(1.0).unwrap();
            let off = (motion.attitude.coords - truth.attitude.coords).norm();
            assert!(off < 1e-8, "{shape:?} {mass:e}: {off:e}");
        }
    }
}

/// The effect of rounding on an attitude after a time: the distance of motions whose moments or momentum
/// differ by a rounding.
fn left_by_rounding(moments: &Vector3<f64>, omega: &Vector3<f64>, time: f64, rounding: f64) -> f64 {
    let at = |moments: Vector3<f64>, omega: Vector3<f64>| {
        let motion = FreeMotion::new(PrincipalMoments::try_from(moments).ok()?, &omega).ok()?;
        Some(motion.at(time).ok()?.attitude.quaternion().coords)
    };
    let truth = at(*moments, *omega).expect("a motion");
    let nudge = |i: usize, by: f64| Vector3::from_fn(|k, _| if k == i { by } else { 0.0 });
    let momentum = moments.component_mul(omega).norm();
    // Where there is no such body the others must do.
    let far = |q: Option<Vector4<f64>>| q.map_or(0.0, |q| (q - truth).norm().min((q + truth).norm()));
    (0..3)
        .flat_map(|i| {
            let stretched = moments + nudge(i, moments[i] * rounding);
            [
                far(at(stretched, *omega)),
                far(at(*moments, omega + nudge(i, rounding * momentum / moments[i]))),
            ]
        })
        .sum()
}

/// A solid rod's moments are as 1/8 to `x²/12 + 1/16`, with `x` its length in diameters: 1000 roundings at
/// 112.17.
#[test]
fn a_rod_longer_than_112_diameters_is_stepped_in_double_precision() {
    let off = |length: f64, method: Option<Method>| {
        let moments = Cylinder::new(0.5, length)?.with_mass(1.0)?.inertia().matrix().diagonal();
        let omega = Vector3::new(0.3, 1.0, 10.0);
        let system = System::of_numbers(moments.cast::<f32>(), Vec::new());
        let momentum = system.momentum(&omega.cast::<f32>());
        let mut motion = State { attitude: Quaternion::identity(), momentum };
        for _ in 0..600 {
            let next = method.map(|method| method.step(&system, &motion, 1.0 / 60.0));
            motion = next.unwrap_or_else(|| fixed_rate(&system, &motion, 1.0 / 60.0))?;
        }
        let end = UnitQuaternion::from_quaternion(Quaternion::from(motion.attitude.coords.cast::<f64>()));
        Ok::<_, Error>(end.angle_to(&free_motion(moments, &omega).attitude(10.0)?))
    };
    assert!(off(112.1, None).unwrap() < 3e-3);
    assert_eq!(off(112.2, None).unwrap_err().subject(), Subject::MomentRatio);
    // Others refuse none: a splitting turns it further and further off, Gauss's collocation does not.
    let split = [112.2, 1e3, 1e4].map(|length| off(length, Some(Method::RotationSplitting4)).unwrap());
    assert!(split[0] < 3e-3 && split[1] > 0.1 && split[2] > 0.5, "{split:?}");
    assert!(off(1e4, Some(Method::Gauss6)).unwrap() < 0.01);
    assert!(off(100.0, Some(Method::MuntheKaas4)).unwrap() > 1.0);
}

proptest! {
    /// Sums over inverse moments cancel in needles: computed as written they were off by a radian.
    #[test]
    fn a_game_steps_a_needle_as_well_as_its_moments_are_known(
        thin in -9.0..0.0_f64,
        apart in -1.0..1.0_f64,
        [x, y, z] in Just([0_usize, 1, 2]).prop_shuffle(),
        omega in crate::common::vector(10.0),
    ) {
        let thin = 10.0_f64.powf(thin);
        let mut moments = Vector3::zeros();
        (moments[x], moments[y], moments[z]) = (thin, 1.0, 1.0 + apart * thin);
        let Ok(principal) = PrincipalMoments::try_from(moments) else { return Ok(()) };
        let system = System::free(principal).unwrap();
        let end = fixed_rate(&system, &start(&system, &omega), 0.4).unwrap();
        let truth = free_motion(moments, &omega).at(0.4).unwrap().attitude.quaternion().coords;
        let off = (end.attitude.coords - truth).norm().min((end.attitude.coords + truth).norm());
        let bound = 1e-7 + 10.0 * left_by_rounding(&moments, &omega, 0.4, f64::EPSILON);
        prop_assert!(off < bound, "{off:e} of {bound:e}");
        let single = System::of_numbers(moments.map(|x| x as f32), Vec::new());
        let momentum = single.momentum(&omega.map(|x| x as f32));
        let step = fixed_rate(&single, &State { attitude: Quaternion::identity(), momentum }, 0.4);
        // 1000 roundings: below, the momentum has no digits of the spin about the length.
        if thin < 1.3e-4 {
            prop_assert!(step.is_err() == (thin < 1.19e-4) || thin > 1.18e-4);
            return Ok(());
        }
        let end = step.unwrap().attitude.coords.map(f64::from);
        let off = (end - truth).norm().min((end + truth).norm());
        let bound = 1e-5 + 10.0 * left_by_rounding(&moments, &omega, 0.4, f64::from(f32::EPSILON));
        prop_assert!(off < bound, "in single precision {off:e} of {bound:e}");
    }
}
