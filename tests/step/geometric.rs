//! Methods that keep the laws of motion, held against rounding, long runs, torques and nonsense.

use super::{adaptive, changes, energy};
use crate::common::*;
use nalgebra::{Quaternion, Vector3};
use proptest::prelude::*;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, State, System, Torque, fixed_rate};
use tumbling::{Error, ErrorKind, PrincipalMoments};

/// How far apart two motions are, attitude and momentum each by its own size.
fn apart(a: &State<f64>, b: &State<f64>) -> f64 {
    (a.attitude.coords - b.attitude.coords).norm() + (a.momentum - b.momentum).norm() / b.momentum.norm()
}

const GEOMETRIC: [Method; 12] = [
    Method::ImplicitMidpoint,
    Method::Gauss4,
    Method::Gauss6,
    Method::RotationSplitting2,
    Method::RotationSplitting4,
    Method::RotationSplitting6,
    Method::SymmetricTop,
    Method::MoserVeselov2,
    Method::MoserVeselov4,
    Method::MoserVeselov6,
    Method::MoserVeselov8,
    Method::MoserVeselov10,
];

fn run(
    method: Method,
    system: &System<f64>,
    start: &State<f64>,
    h: f64,
    count: usize,
) -> Result<State<f64>, Error> {
    (0..count).try_fold(*start, |motion, _| method.step(system, &motion, h))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// A hundred steps of up to a third of a radian, of any body: what is said to be kept is, to a few
    /// roundings a step.
    #[test]
    fn laws_that_are_said_to_be_kept_are_kept_to_rounding(
        moments in moments(),
        omega in generic_spin(),
        attitude in attitude(),
        h in 0.02..0.2,
    ) {
        let system = System::free(moments.try_into()?)?;
        let start = State { attitude: *attitude.quaternion(), momentum: system.momentum(&omega) };
        // Energy weighs the momentum by moments that differ; roundings of momentum count by as much.
        let bound = 100.0 * 16.0 * f64::EPSILON * moments.max() / moments.min();
        for method in GEOMETRIC {
            let end = run(method, &system, &start, h, 100)?;
            let keeps = method.info().conserved;
            let said = [keeps.energy, keeps.momentum, keeps.direction, keeps.unit];
            for (law, change) in changes(&system, &start, &end).into_iter().enumerate() {
                prop_assert!(!said[law] || change < bound, "{method:?} law {law}: {change:e}");
            }
            if keeps.reversible {
                let back = run(method, &system, &end, -h, 100)?;
                // Roundings on the way are stretched by a motion of up to 20 radians.
                prop_assert!(apart(&back, &start) < 20.0 * bound, "{method:?}: {:e}", apart(&back, &start));
            }
        }
    }

    /// Steps of a hundredth of a radian up to ten, of any body, flat and needle-like ones among them.
    #[test]
    fn a_reversible_step_that_is_taken_is_undone_by_the_step_back(
        halves in [0.0..1.0_f64, 0.0..1.0, 0.0..1.0],
        thin in prop::sample::select(vec![1.0, 1e-3, 1e-6]),
        momentum in crate::common::vector(3.0),
        turn in -2.0..1.0_f64,
    ) {
        let [x, y, z] = [halves[0], halves[1], halves[2] * thin];
        let moments = Vector3::new(y + z, z + x, x + y);
        let Ok(moments) = moments.try_into() else { return Ok(()) };
        let Ok(system) = System::free(moments) else { return Ok(()) };
        let start = State { attitude: Quaternion::identity(), momentum };
        let h = 10.0_f64.powf(turn) / system.omega(&momentum).norm();
        for &method in Method::ALL.iter().filter(|method| method.info().conserved.reversible) {
            let Ok(end) = method.step(&system, &start, h) else { continue };
            match method.step(&system, &end, -h) {
                Ok(back) => {
                    // Roundings are stretched by as much as a nudge is: long steps of thin bodies turn by
                    // many radians.
                    let nudge = Vector3::repeat(1e-9 * momentum.norm());
                    let nudged = State { momentum: end.momentum + nudge, ..end };
                    let Ok(other) = method.step(&system, &nudged, -h) else { continue };
                    let stretch = apart(&other, &back) / 1e-9;
                    // Beyond that no digit of the way back is left: nine splittings of a needle over many
                    // radians.
                    if stretch < 1e6 {
                        let bound = 1e-12 * stretch.max(1.0);
                        prop_assert!(apart(&back, &start) < bound, "{method:?} {h}: {:e}", apart(&back, &start));
                    }
                }
                // Found in this number of rounds forward, and in a few more backward.
                Err(error) if error.to_string().contains("was not found in 200 rounds") => (),
                Err(error) if error.to_string().contains("several solutions") => (),
                Err(error) => prop_assert!(false, "{method:?} {h}: {error}"),
            }
        }
    }

    #[test]
    fn any_numbers_at_all_give_a_motion_or_an_error(
        moments in any_vector(),
        momentum in any_vector(),
        torque in any_vector(),
        (w, x, y, z) in (anything(), anything(), anything(), anything()),
        h in anything(),
        driven in any::<bool>(),
    ) {
        let torques = if driven { vec![Torque::InWorld(torque), Torque::Damping(torque.abs())] } else { Vec::new() };
        let sound = System::free(PrincipalMoments::new(1.0, 2.0, 2.5)?)?;
        let given = PrincipalMoments::try_from(moments).and_then(|moments| System::with(moments, torques));
        for system in [given.unwrap_or(sound.clone()), sound] {
            let start = State { attitude: Quaternion::new(w, x, y, z), momentum };
            let finite = |motion: State<f64>| motion.attitude.coords.iter().chain(&motion.momentum).all(|x| x.is_finite());
            for method in GEOMETRIC {
                prop_assert!(method.step(&system, &start, h).map_or(true, finite), "{method:?}");
            }
            prop_assert!(fixed_rate(&system, &start, h).map_or(true, finite));
        }
    }
}

#[test]
fn laws_that_are_said_to_be_broken_are_broken_by_far_more_than_rounding() {
    let system = System::free(PrincipalMoments::new(1.0, 2.0, 2.5).unwrap()).unwrap();
    let start =
        State { attitude: Quaternion::identity(), momentum: system.momentum(&Vector3::new(1.0, 1.5, -0.8)) };
    for method in GEOMETRIC {
        let keeps = method.info().conserved;
        let said = [keeps.energy, keeps.momentum, keeps.direction, keeps.unit];
        // Where they happen to stand after any one step may be right by chance.
        let mut most = [0.0_f64; 4];
        let mut motion = start;
        for _ in 0..50 {
            motion = method.step(&system, &motion, 0.3).unwrap();
            for (most, change) in most.iter_mut().zip(changes(&system, &start, &motion)) {
                *most = most.max(change);
            }
        }
        for (law, most) in most.into_iter().enumerate() {
            assert!(said[law] || most > 1e-7, "{method:?} law {law}: {most:e}");
        }
    }
}

#[test]
fn the_energy_of_the_splittings_swings_and_does_not_grow() {
    let system = System::free(PrincipalMoments::new(1.0, 2.0, 2.5).unwrap()).unwrap();
    let start =
        State { attitude: Quaternion::identity(), momentum: system.momentum(&Vector3::new(1.0, 1.5, -0.8)) };
    for method in [
        Method::RotationSplitting2,
        Method::RotationSplitting4,
        Method::RotationSplitting6,
        Method::SymmetricTop,
    ] {
        let mut worst = [0.0_f64; 2];
        let mut motion = start;
        for k in 0..20_000 {
            motion = method.step(&system, &motion, 0.1).unwrap();
            let off = (energy(&system, &motion) / energy(&system, &start) - 1.0).abs();
            worst[k / 10_000] = worst[k / 10_000].max(off);
        }
        assert!(worst[1] < 1.01 * worst[0], "{method:?}: {worst:?}");
    }
}

/// The error after one second at two steps, the second half the first: its ratio is two to the power of the
/// order.
fn order_of(
    method: Method,
    error: impl Fn(&State<f64>) -> f64,
    end: impl Fn(f64, usize) -> State<f64>,
    n: usize,
) -> f64 {
    let errors = [n, 2 * n].map(|n| error(&end(1.0 / n as f64, n)));
    assert!(errors[1] > 1e-13, "{method:?}: {errors:?} is rounding");
    (errors[0] / errors[1]).log2()
}

#[test]
fn errors_of_free_motion_fall_with_the_order_in_floating_point_too() {
    let moments = Vector3::new(1.0, 2.0, 2.5);
    let omega = Vector3::new(1.0, 1.5, -0.8);
    let system = System::free(moments.try_into().unwrap()).unwrap();
    let start = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
    let truth = FreeMotion::new(moments.try_into().unwrap(), &omega).unwrap().at(1.0).unwrap();
    let truth = State { attitude: truth.attitude.into_inner(), momentum: system.momentum(&truth.omega) };
    for method in GEOMETRIC {
        // The higher the order, the coarser the steps that still show it above rounding.
        let n = match method.info().order {
            2 => 100,
            4 => 24,
            6 => 6,
            8 => 4,
            _ => 3,
        };
        let order =
            order_of(method, |m| apart(m, &truth), |h, n| run(method, &system, &start, h, n).unwrap(), n);
        let said = f64::from(method.info().order);
        // At the coarsest steps the next power of the error still shows.
        let bound = if said > 4.0 { 0.3 } else { 0.05 };
        assert!((order - said).abs() < bound, "{method:?}: {order}");
    }
}

#[test]
fn with_a_torque_gauss_keeps_its_order_and_the_others_have_two() {
    let torques = vec![
        Torque::gravity(&Vector3::new(0.1, 0.0, 0.5), 3.0),
        Torque::InBody(Vector3::new(0.2, -0.1, 0.3)),
        Torque::Damping(Vector3::new(0.1, 0.2, 0.3)),
    ];
    let system = System::with(PrincipalMoments::new(1.0, 2.0, 2.5).unwrap(), torques).unwrap();
    let vector = system.momentum(&Vector3::new(1.0, 1.5, -0.8));
    let start = State { attitude: Quaternion::identity(), momentum: vector };
    let truth = adaptive(&system, &start, 1.0, 1e-14, &mut 1_000_000).unwrap();
    for method in GEOMETRIC {
        let (said, n) = match method {
            Method::Gauss4 => (4.0, 24),
            Method::Gauss6 => (6.0, 8),
            _ => (2.0, 100),
        };
        let order =
            order_of(method, |m| apart(m, &truth), |h, n| run(method, &system, &start, h, n).unwrap(), n);
        assert!((order - said).abs() < 0.1, "{method:?}: {order}");
    }
    type Step = dyn Fn(&System<f64>, &State<f64>, f64) -> Result<State<f64>, Error>;
    let others: [&Step; 2] = [&fixed_rate, &|system, motion, h| Method::Buss.step(system, motion, h)];
    for (k, step) in others.into_iter().enumerate() {
        let played = |n: usize| (0..n).try_fold(start, |m, _| step(&system, &m, 1.0 / n as f64)).unwrap();
        let errors = [100, 200].map(|n| apart(&played(n), &truth));
        assert!(((errors[0] / errors[1]).log2() - 2.0).abs() < 0.1, "{k}: {errors:?}");
    }
}

#[test]
fn a_step_too_long_for_an_implicit_method_is_refused() {
    let system = System::free(PrincipalMoments::new(1.0, 2.0, 2.5).unwrap()).unwrap();
    let start =
        State { attitude: Quaternion::identity(), momentum: system.momentum(&Vector3::new(1.0, 1.5, -0.8)) };
    // A turn by p takes h L / 2 = p0 K p + p x K p, whose size is at most that of K p: with |L| about 3.7, no
    // turn takes a step of 3 s.
    refused(Method::MoserVeselov2.step(&system, &start, 3.0), ErrorKind::NotConverged, "was not found in");
    refused(
        Method::MoserVeselov2.step(&system, &start, 3.0),
        ErrorKind::NotConverged,
        "a Moser-Veselov step",
    );
    refused(fixed_rate(&system, &start, 1000.0), ErrorKind::OutOfBounds, "it must be below 500");
}
