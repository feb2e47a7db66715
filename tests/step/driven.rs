//! Adaptive runs under torques: against another integrator and what is conserved. In `crates/measure`, scenes
//! meet a table of many digits.

use super::{adaptive, apart as off, spinning, under};
use crate::common::refused;
use nalgebra::{Matrix3, Matrix6, Quaternion, UnitQuaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::step::{State, Stepper, System, Torque};
use tumbling::{Body, ErrorKind, Inertia, PrincipalMoments};

/// Amplitude, rate and phase: two of the same rate that rotate in the body; another rate; and a third.
const PUSHES: [(Vector3<f64>, f64, f64); 4] = [
    (Vector3::new(0.5, 0.0, 0.2), 2.5, 0.3),
    (Vector3::new(0.1, -0.4, 0.0), 2.5, 0.3 - std::f64::consts::FRAC_PI_2),
    (Vector3::new(0.2, 0.3, -0.6), -7.0, 1.2),
    (Vector3::new(0.3, 0.1, 0.2), 4.0, -2.0),
];

/// All kinds at once, with four world vectors, two gradients and some periodic pushes; and their sum as a
/// function, which takes another integrator.
pub(super) fn all_torques(moments: Vector3<f64>, pushes: usize) -> [Vec<Torque<f64>>; 2] {
    let (body, world) = (Vector3::new(0.1, -0.2, 0.15), Vector3::new(0.05, 0.1, -0.2));
    let arms = [Vector3::new(0.1, 0.3, -0.2), Vector3::new(-0.3, 0.1, 0.1), Vector3::new(0.2, 0.1, 0.4)];
    let fields = [Vector3::new(0.0, 0.5, 1.0), Vector3::new(1.0, 0.2, 0.0), Vector3::new(-0.4, 0.0, 0.8)];
    let (drag, loss) = (Vector3::new(0.05, 0.02, 0.08), 0.01);
    let (toward, orbit) = (Vector3::new(0.6, 0.8, 0.0), Vector3::new(0.0, 0.0, 0.7));
    let mut named = vec![
        Torque::InBody(body),
        Torque::InWorld(world),
        Torque::Damping(drag),
        Torque::Dissipation(loss),
        Torque::gravity_gradient(&toward, &orbit),
        Torque::GravityGradient { strength: 0.8, direction: Vector3::y(), orbit: Vector3::zeros() },
    ];
    named.extend((0..3).map(|k| Torque::Aligning { arm: arms[k], field: fields[k] }));
    let pushes = &PUSHES[..pushes];
    named.extend(pushes.iter().map(|&(amplitude, rate, phase)| Torque::Periodic { amplitude, rate, phase }));
    let law = move |time: f64, rotation: &Matrix3<f64>, omega: &Vector3<f64>| {
        let momentum = moments.component_mul(omega);
        let (sine, cosine) = (orbit.z * time).sin_cos();
        let n = rotation.transpose()
            * Vector3::new(cosine * toward.x - sine * toward.y, sine * toward.x + cosine * toward.y, 0.0);
        let other = rotation.transpose() * Vector3::y();
        let aligning = (0..3).map(|k| arms[k].cross(&(rotation.transpose() * fields[k]))).sum::<Vector3<_>>();
        let pushed: Vector3<f64> =
            pushes.iter().map(|(a, rate, phase)| a * (rate * time + phase).cos()).sum();
        pushed + body + rotation.transpose() * world - drag.component_mul(omega)
            + momentum.cross(&momentum.cross(omega)) * loss
            + n.cross(&moments.component_mul(&n)) * (3.0 * orbit.z * orbit.z)
            + other.cross(&moments.component_mul(&other)) * 0.8
            + aligning
    };
    [named, vec![Torque::function(law)]]
}

#[test]
fn every_named_torque_together_moves_a_body_as_the_function_that_says_the_same() {
    let moments = Vector3::new(1.0, 1.7, 2.4);
    let start = State {
        attitude: UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1).into_inner(),
        momentum: Vector3::new(0.5, 3.0, -0.4),
    };
    for pushes in [0, 1, 3, 4] {
        let [series, pair] = all_torques(moments, pushes).map(|torques| {
            let system = under(moments, torques);
            [12.0, -3.0].map(|t| {
                [1e-6, 1e-9, 1e-12]
                    .map(|tolerance| adaptive(&system, &start, t, tolerance, &mut 100_000).unwrap())
            })
        });
        for (series, pair) in series.iter().zip(&pair) {
            let apart = off(&series[2], &pair[2]);
            assert!(apart < 1e-10, "{pushes}: {apart:e}");
            for (k, tolerance) in [1e-6, 1e-9].into_iter().enumerate() {
                for one in [&series[k], &pair[k]] {
                    let apart = off(one, &series[2]);
                    assert!(apart < 300.0 * tolerance, "{pushes}, {tolerance:e}: {apart:e}");
                }
            }
        }
    }
}

#[test]
fn in_a_circular_orbit_the_energy_seen_in_the_turning_frame_stays() {
    // T + 3/2 n² e.Ie - n.L, with e the direction to the earth and n the rate of the orbit.
    let (moments, orbit) = (Vector3::new(10.0, 14.0, 20.0), Vector3::new(0.0, 0.0, 0.5));
    let torque = Torque::gravity_gradient(&Vector3::x(), &orbit);
    let system = under(moments, vec![torque]);
    let start = State {
        attitude: UnitQuaternion::from_euler_angles(0.1, 0.3, -0.2).into_inner(),
        momentum: system.momentum(&Vector3::new(0.1, -0.2, 0.6)),
    };
    let jacobi = |state: &State<f64>, time: f64| {
        let rotation = UnitQuaternion::from_quaternion(state.attitude);
        let e = rotation.inverse() * Vector3::new((orbit.z * time).cos(), (orbit.z * time).sin(), 0.0);
        let potential = 1.5 * orbit.norm_squared() * e.dot(&moments.component_mul(&e));
        system.energy(state) + potential - orbit.dot(&(rotation * state.momentum))
    };
    let before = jacobi(&start, 0.0);
    for time in [1.0, 30.0, -30.0] {
        let end = adaptive(&system, &start, time, 1e-13, &mut 1000).unwrap();
        assert!((jacobi(&end, time) / before - 1.0).abs() < 1e-11, "{time}");
        assert!((system.energy(&end) / system.energy(&start) - 1.0).abs() > 1e-2);
    }
}

#[test]
fn a_thruster_acts_for_the_whole_of_its_time_and_no_longer() {
    // Along the world's z on a sphere: the momentum in the world grows by torque times time, wherever the
    // run begins and ends. A step over the switch by any smooth method misses it by a share of the step.
    let push = Torque::during(0.1, 0.7, Torque::InWorld(Vector3::new(0.0, 0.0, 2.0)));
    let system = under([1.0, 1.7, 2.4], vec![push]);
    let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.5, 2.0, -0.4) };
    let world = |state: &State<f64>| UnitQuaternion::from_quaternion(state.attitude) * state.momentum;
    for (end, time) in [(0.05, 0.0), (0.3, 0.2), (0.7, 0.6), (5.0, 0.6), (-2.0, 0.0)] {
        let there = adaptive(&system, &start, end, 1e-13, &mut 1000).unwrap();
        let gained = world(&there) - start.momentum;
        assert!((gained - Vector3::new(0.0, 0.0, 2.0 * time)).norm() < 1e-11, "{end}: {gained}");
    }
    let back = Torque::during(2.0, 1.0, Torque::InBody(Vector3::x()));
    let never = System::with(PrincipalMoments::new(1.0, 1.7, 2.4).unwrap(), vec![back]);
    refused(never, ErrorKind::OutOfBounds, "its end");
}

#[test]
fn a_torque_within_a_torque_acts_while_both_of_them_do() {
    // 2000 N m for a thousandth of a second on 4 kg m², from rest; it is over before the outer interval ends.
    let body = spinning([2.0, 3.0, 4.0], &Vector3::zeros());
    let push = || Torque::InBody(Vector3::z() * 2000.0);
    for (first, inner, expected) in [
        ([0.0, 10.0], [3.0, 3.001], 0.5),
        ([3.0, 3.001], [0.0, 10.0], 0.5),
        ([2.0, 3.0], [2.9995, 4.0], 0.25),
        ([0.0, 1.0], [2.0, 3.0], 0.0),
    ] {
        let inner = Torque::during(inner[0], inner[1], push());
        let nested = Torque::during(first[0], first[1], inner);
        let stepper = Stepper::adaptive(&body, 1e-12, 1000).unwrap();
        let mut stepper = stepper.with_torques([nested]).unwrap();
        let _ = stepper.step(10.0).unwrap();
        assert!((stepper.omega().z - expected).abs() < 1e-12, "{first:?}: {}", stepper.omega());
        // The time between 0 and 10 s goes by series, which have flips.
        assert!(stepper.flips(0.0).unwrap().is_empty());
    }
}

#[test]
fn a_refused_adaptive_run_says_what_is_in_the_way() {
    let moments = PrincipalMoments::new(1.0, 2.0, 2.5).unwrap();
    let drag = Stepper::adaptive(&tilted(), 1e-9, 1000).unwrap();
    let mut drag = drag.with_torques([Torque::function(|_, _, omega| -omega)]).unwrap();
    refused(drag.flips(1.0), ErrorKind::Undefined, "no series");
    refused(drag.step_with_transition(1.0), ErrorKind::Undefined, "no derivatives");
    refused(drag.expected_error(1.0), ErrorKind::Undefined, "no derivatives");
    // A direction of another length would be another strength.
    let long = Torque::gravity_gradient(&Vector3::new(0.6, 0.8, 0.1), &Vector3::new(0.0, 0.0, 0.3));
    let long = refused(System::with(moments, vec![long]), ErrorKind::OutOfBounds, "off 1 by 0.00499");
    assert!(long.to_string().contains("direction"), "{long}");
    // Rates that overflow leave no step.
    let lossy = under(moments, vec![Torque::Dissipation(1e300)]);
    let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(1.0, 2.0, 3.0) };
    let lost = adaptive(&lossy, &start, 1.0, 1e-9, &mut 1000);
    let lost = refused(lost, ErrorKind::NotConverged, "no step at 0e0 s meets the tolerance").to_string();
    assert!(!lost.contains("NaN") && !lost.contains("moved"), "{lost}");
}

#[test]
fn a_step_by_the_pair_may_be_as_short_as_numbers_allow() {
    let moments = PrincipalMoments::new(1.0, 2.0, 2.5).unwrap();
    let push = Torque::function(|_, _, w: &Vector3<f64>| Vector3::new(0.1, -0.2, 0.3) - w);
    let system = under(moments, vec![push]);
    let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.3, 2.0, 0.7) };
    for h in [1e-160, 1e-200, 1e-300] {
        let end = adaptive(&system, &start, h, 1e-9, &mut 1000).unwrap();
        let half = system.omega(&start.momentum) * (0.5 * h);
        assert!((end.attitude.imag() / h - half / h).norm() < 1e-14, "{h:e}: {end:?}");
        assert_eq!((end.attitude.w, end.momentum), (1.0, start.momentum));
    }
}

pub(super) fn tilted() -> Body {
    let inertia = Inertia::from_moments(1.0, 2.0, 2.5).unwrap();
    let inertia = inertia.turned(UnitQuaternion::from_euler_angles(0.2, 0.1, -0.3)).unwrap();
    let attitude = UnitQuaternion::from_euler_angles(1.0, 0.3, 0.2);
    Body::spinning(inertia, attitude, &Vector3::new(0.4, 1.8, -0.3)).unwrap()
}

#[test]
fn the_state_transition_of_a_free_body_in_steps_is_that_of_the_closed_form() {
    let body = tilted();
    let exact = FreeMotion::of(&body).unwrap();
    let mut stepper = Stepper::adaptive(&body, 1e-13, 10_000).unwrap();
    let mut whole = Matrix6::identity();
    for h in [1.7, 6.3, 4.0] {
        whole = stepper.step_with_transition(h).unwrap() * whole;
    }
    let truth = exact.state_transition(12.0).unwrap();
    assert!((whole - truth).norm() < 1e-10 * truth.norm(), "{:e}", (whole - truth).norm() / truth.norm());
}

/// A body at rest under 2 N m about z has the momentum `2 t`; the torque of the second second is none.
#[test]
fn a_run_that_was_refused_on_its_way_stays_where_its_last_step_took_it() {
    let torques = vec![
        Torque::during(0.0, 1.0, Torque::InBody(Vector3::new(0.0, 0.0, 2.0))),
        Torque::during(1.0, 2.0, Torque::function(|_, _, _| Vector3::repeat(f64::NAN))),
    ];
    let system = under([1.0, 2.0, 2.5], torques);
    let rest = State { attitude: Quaternion::identity(), momentum: Vector3::zeros() };
    let mut run = Stepper::of_system(system.clone(), &rest, 1e-12, 100_000).unwrap();
    for _ in 0..3 {
        assert!(run.step_to(1.5).is_err());
        let there = run.step_to(1.0).unwrap();
        assert!((there.momentum - Vector3::new(0.0, 0.0, 2.0)).norm() < 1e-12, "{there:?}");
    }
    // A body that stiff dissipation stops has no states except those of its last step.
    let torques = vec![Torque::Dissipation(30.0), Torque::gravity(&Vector3::new(0.1, 0.2, 0.3), 10.0)];
    let system = under([1.0, 2.0, 2.5], torques);
    let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(1.0, 2.0, 3.0) };
    let mut run = Stepper::of_system(system.clone(), &start, 1e-14, 100).unwrap();
    let error = run.step_to(10.0).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::TooMany);
    for k in 0..1000 {
        let time = 1.2 * f64::from(k) / 1000.0;
        let Ok(state) = run.at(time) else { continue };
        let truth = adaptive(&system, &start, time, 1e-13, &mut 10_000).unwrap();
        assert!(off(&state, &truth) < 1e-10, "{time}: {}", off(&state, &truth));
    }
}

/// 2.5 kg m² under 4 N m for a second.
#[test]
fn a_torque_added_on_the_way_acts_by_the_time_of_the_stepper() {
    let resting = spinning([1.0, 2.0, 2.5], &Vector3::zeros());
    let push = Torque::InBody(Vector3::new(0.0, 0.0, 4.0));
    let mut stepper = Stepper::adaptive(&resting, 1e-12, 1000).unwrap();
    let _ = stepper.step(3.0).unwrap();
    let mut later = stepper.clone().with_torques([Torque::during(4.0, 5.0, push.clone())]).unwrap();
    let _ = later.step(3.0).unwrap();
    assert!((later.omega().z - 4.0 / 2.5).abs() < 1e-12);
    // Earlier times are no longer available.
    let added = stepper.with_torques([push]).unwrap();
    assert!(added.at(1.5).is_err());
}

#[test]
fn a_refusal_counts_from_the_start_of_the_run() {
    let push = Torque::during(5.0, 6.0, Torque::InBody(Vector3::x()));
    let system = under([1.0, 2.0, 2.5], vec![push]);
    let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(1.0, 20.0, 3.0) };
    let mut whole = 100_000;
    adaptive(&system, &start, 10.0, 1e-12, &mut whole).unwrap();
    let steps = 100_000 - whole - 3;
    let error = adaptive(&system, &start, 10.0, 1e-12, &mut { steps }).unwrap_err().to_string();
    assert!(error.contains("of 1e1 s") && error.contains(&format!("{steps} steps")), "{error}");
}
