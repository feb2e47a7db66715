//! A body of any tensor stepped in its own axes, under torques given by functions of time, attitude and spin.

use super::{apart, by, finite, free, in_axes, seen_along, spinning, steppers};
use crate::common::*;
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::step::{Method, State, Stepper, System, Torque, fixed_rate};
use tumbling::{Body, Error, ErrorKind, Inertia, Subject};

type Rule = fn(&Body) -> Result<Stepper, Error>;

/// The ways to step a body.
const RULES: [(&str, Rule); 6] = [
    ("Runge-Kutta", |body| Stepper::new(body, Method::RungeKutta4)),
    ("splitting", |body| Stepper::new(body, Method::RotationSplitting2)),
    ("Gauss", |body| Stepper::new(body, Method::Gauss4)),
    ("Moser-Veselov", |body| Stepper::new(body, Method::MoserVeselov8)),
    ("fixed rate", |body| Stepper::fixed_rate(body)),
    ("adaptive", |body| Stepper::adaptive(body, 1e-10, 10_000)),
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn a_turn_of_the_bodys_axes_turns_the_answer_and_nothing_else(
        moments in moments(), axes in attitude(), q in attitude(), omega in generic_spin(), force in crate::common::vector(1.0),
    ) {
        // Every kind of torque, in the axes of the body.
        let torques = |turn: UnitQuaternion<f64>| {
            let here = move |v: Vector3<f64>| turn.inverse() * v;
            [
                Torque::InBody(here(force)),
                Torque::InWorld(force.yzx()),
                Torque::Aligning { arm: here(force.zxy()), field: Vector3::new(0.3, -0.2, 0.5) },
                Torque::Damping(Vector3::repeat(0.2)),
                Torque::Dissipation(0.1),
                Torque::Periodic { amplitude: here(force.yxz()), rate: 2.0, phase: 0.5 },
                Torque::gravity_gradient(&Vector3::new(0.6, 0.8, 0.0), &Vector3::new(0.0, 0.0, 0.7)),
                Torque::during(-1.0, 2.0, Torque::InBody(here(force.zyx()))),
                Torque::function(move |time: f64, rotation, omega| {
                    let (rotation, omega) = (rotation * turn.inverse().to_rotation_matrix(), turn * omega);
                    let wind = Vector3::new((3.0 * time).sin(), 0.4, -0.3);
                    here(rotation.tr_mul(&wind) - omega.component_mul(&Vector3::new(0.1, 0.3, 0.2)))
                }),
            ]
        };
        let principal = Inertia::from_moments(moments.x, moments.y, moments.z).unwrap();
        let plain = Body::spinning(principal, q, &omega).unwrap();
        let turned = Body::spinning(in_axes(moments, &axes.inverse()), q * axes, &(axes.inverse() * omega)).unwrap();
        for (name, stepper) in RULES {
            let mut a = stepper(&plain).unwrap().with_torques(torques(UnitQuaternion::identity())).unwrap();
            let mut b = stepper(&turned).unwrap().with_torques(torques(axes)).unwrap();
            for (a, b) in a.run(0.02, 50).zip(b.run(0.02, 50)) {
                let (a, b) = (seen_along(&a.unwrap(), &axes), b.unwrap());
                // Two splittings of the same body differ if its axes have another order.
                let bound = if name == "splitting" { 2e-2 } else { 1e-6 };
                prop_assert!(apart(&a, &b) < bound, "{name} {}", apart(&a, &b));
            }
        }
    }
}

#[test]
fn of_a_diagonal_tensor_a_stepper_is_the_method_itself_to_the_bit() {
    let moments = Vector3::new(2.5, 1.0, 2.0);
    let system = free(moments);
    let q = UnitQuaternion::from_euler_angles(0.2, -0.5, 1.0);
    let body = Body::spinning(Inertia::from_moments(2.5, 1.0, 2.0).unwrap(), q, &Vector3::new(0.2, 1.0, 0.4))
        .unwrap();
    for &method in Method::ALL {
        let mut stepper = Stepper::new(&body, method).unwrap();
        let mut state = body.state();
        for stepped in stepper.run(0.03, 20) {
            state = method.step(&system, &state, 0.03).unwrap();
            assert_eq!(stepped.unwrap(), state, "{method:?}");
        }
    }
    let mut stepper = Stepper::fixed_rate(&body).unwrap();
    let once = tumbling::step::fixed_rate(&system, &body.state(), 0.1).unwrap();
    assert_eq!(stepper.step(0.1).unwrap(), once);
}

#[test]
fn a_run_makes_no_room_for_its_steps_and_a_refused_one_leaves_the_body_where_it_was() {
    let body = spinning([1.0, 2.0, 2.5], &Vector3::new(0.1, 2.0, 0.3));
    let mut stepper = Stepper::new(&body, Method::Gauss6).unwrap();
    // As many steps as there are numbers for are begun.
    assert_eq!(stepper.clone().run(1e-3, usize::MAX).take(3).filter(Result::is_ok).count(), 3);
    let before = stepper.state();
    assert!(stepper.step(1e6).is_err());
    assert_eq!((stepper.state(), stepper.time()), (before, 0.0));
    assert_eq!(stepper.run(1e6, 10).count(), 1);
}

#[test]
fn a_gravity_gradient_that_begins_too_late_is_refused_for_its_phase_and_not_for_its_torque() {
    let (strength, direction, orbit) = (3.8e-6, Vector3::x(), Vector3::new(2e-4, -3e-4, 1.1e-3));
    let torque = Torque::GravityGradient { strength, direction, orbit };
    let (body, from) = (spinning([1.0, 2.0, 2.5], &Vector3::zeros()), 1e200);
    for (name, rule) in RULES {
        for torque in [torque.clone(), Torque::during(from, 2.0 * from, torque.clone())] {
            let mut stepper = rule(&body).unwrap();
            stepper.step_to(from).unwrap();
            let text = stepper.with_torques([torque]).unwrap().step_to(1.01 * from).unwrap_err().to_string();
            let why = if name == "adaptive" { "its budget of steps is used up" } else { "takes phases" };
            assert!(text.contains(why), "{name}: {text}");
        }
    }
}

#[test]
fn a_body_at_rest_stays_there_for_the_shortest_time() {
    let body = spinning([1.0, 2.0, 2.5], &Vector3::zeros());
    for time in [5e-324, 1e-320, -1e-310, 1.0] {
        for (name, rule) in RULES {
            assert_eq!(rule(&body).unwrap().step_to(time), Ok(body.state()), "{name}, {time:e} s");
        }
    }
}

#[test]
fn single_precision_follows_double_for_every_method_and_at_a_fixed_rate() {
    let moments = Vector3::new(1.0, 2.0, 2.5);
    let double = System::of_numbers(moments, vec![Torque::gravity(&Vector3::x(), 0.1)]);
    let single = System::of_numbers(moments.cast::<f32>(), vec![Torque::gravity(&Vector3::x(), 0.1)]);
    let attitude = UnitQuaternion::from_euler_angles(0.3, 0.8, -0.4).into_inner();
    let start = State { attitude, momentum: double.momentum(&Vector3::new(0.5, 1.0, -0.25)) };
    for method in Method::ALL.iter().copied().map(Some).chain([None]) {
        let momentum = start.momentum.cast::<f32>();
        let (mut a, mut b) = (State { attitude: attitude.coords.cast().into(), momentum }, start);
        for _ in 0..100 {
            (a, b) = match method {
                Some(method) => {
                    (method.step(&single, &a, 0.0625).unwrap(), method.step(&double, &b, 0.0625).unwrap())
                }
                None => (fixed_rate(&single, &a, 0.0625).unwrap(), fixed_rate(&double, &b, 0.0625).unwrap()),
            };
            let a = State { attitude: a.attitude.coords.cast().into(), momentum: a.momentum.cast() };
            assert!(apart(&a, &b) < 1e-4, "{method:?} {}", apart(&a, &b));
        }
    }
}

#[test]
fn a_kick_by_a_law_without_the_spin_leaves_a_reversible_method_reversible() {
    let body = spinning([1.0, 2.0, 2.5], &Vector3::new(0.9, 1.1, -0.7));
    let wind = Torque::function(|time: f64, rotation, _| {
        rotation.tr_mul(&Vector3::new(time.sin(), 0.3, time * 0.1))
    });
    for method in
        [Method::RotationSplitting4, Method::MoserVeselov10, Method::SymmetricTop, Method::ImplicitMidpoint]
    {
        let mut stepper = Stepper::new(&body, method).unwrap().with_torques([wind.clone()]).unwrap();
        assert_eq!(stepper.run(0.1, 50).chain([]).filter(Result::is_ok).count(), 50);
        assert!(apart(&stepper.state(), &body.state()) > 0.1);
        assert_eq!(stepper.run(-0.1, 50).filter(Result::is_ok).count(), 50);
        assert!(apart(&stepper.state(), &body.state()) < 1e-12, "{method:?}");
    }
}

#[test]
fn damping_by_axis_of_a_body_with_products_of_inertia_is_refused() {
    let axes = UnitQuaternion::from_euler_angles(0.3, 0.8, -0.4);
    let body = Body::spinning(in_axes(Vector3::new(1.0, 2.0, 2.5), &axes), axes, &Vector3::x()).unwrap();
    let stepper = Stepper::new(&body, Method::Buss).unwrap();
    let by_axis = stepper.clone().with_torques([Torque::Damping(Vector3::new(0.1, 0.2, 0.3))]);
    refused(by_axis, ErrorKind::Undefined, "damping");
    assert!(stepper.with_torques([Torque::Damping(Vector3::repeat(0.1))]).is_ok());
}

/// A coin, whose two equal moments leave its axes undetermined, keeps the axes in which it was given.
#[test]
fn damping_by_axis_of_a_body_with_two_equal_moments_acts_along_the_axes_of_its_tensor() {
    let damping = Torque::Damping(Vector3::new(0.1, 0.2, 0.3));
    for moments in [[2.0, 2.0, 3.0], [3.0, 2.0, 2.0], [2.0, 3.0, 2.0], [2.0, 2.0, 2.0]] {
        for axis in 0..3 {
            let body = spinning(moments, &Vector3::ith(axis, 1.5));
            let stepper = Stepper::adaptive(&body, 1e-12, 1000).unwrap();
            let mut stepper = stepper.with_torques([damping.clone()]).unwrap();
            let _ = stepper.step(4.0).unwrap();
            let left = 1.5 * (-[0.1_f64, 0.2, 0.3][axis] * 4.0 / moments[axis]).exp();
            assert!((stepper.omega() - Vector3::ith(axis, left)).norm() < 1e-11, "{moments:?} {axis}");
        }
    }
    // With the equal ones turned against each other by hardly anything, its axes are no longer known.
    let turned = Matrix3::new(2.0, 1e-12, 0.0, 1e-12, 2.0, 0.0, 0.0, 0.0, 3.0);
    let body = Body::spinning(turned.try_into().unwrap(), UnitQuaternion::identity(), &Vector3::x()).unwrap();
    let refused = Stepper::fixed_rate(&body).unwrap().with_torques([damping]);
    assert_eq!(refused.unwrap_err().kind(), tumbling::ErrorKind::Undefined);
}

#[test]
fn a_torque_that_is_not_a_number_is_named_as_the_cause_by_every_method() {
    let body = spinning([1.0, 2.0, 2.5], &Vector3::new(0.1, 2.0, 0.3));
    // A thruster whose law ends at 0.25 s.
    let law = |time: f64, _: &Matrix3<f64>, _: &Vector3<f64>| Vector3::y() * (0.25 - time).sqrt();
    for method in steppers() {
        let mut stepper = by(&body, method).unwrap().with_torques([Torque::function(law)]).unwrap();
        let error = stepper.run(0.1, 4).find_map(Result::err).unwrap();
        assert_eq!(error.kind(), ErrorKind::NotFinite, "{method:?}: {error}");
        assert_eq!(error.subject(), Subject::Torque, "{method:?}");
        assert!(stepper.time() < 0.35 && finite(&stepper.state()), "{method:?}");
    }
}

#[test]
fn a_step_to_a_spin_or_a_time_beyond_its_numbers_fails_and_leaves_the_body_where_it_was() {
    let body = spinning([1e-300, 1.2e-300, 0.9e-300], &Vector3::new(0.2, 1.0, -0.3));
    // The momentum stays far within range, the spin does not.
    let push = Torque::InBody(Vector3::new(1e12, 2e12, 3e12));
    let mut stepper = Stepper::new(&body, Method::ExplicitEuler).unwrap().with_torques([push]).unwrap();
    let before = stepper.clone();
    refused(stepper.step(0.01), ErrorKind::Unrepresentable, "the spin");
    assert_eq!((stepper.state(), stepper.time()), (before.state(), before.time()));

    let resting = spinning([1e-30, 1.2e-30, 0.9e-30], &Vector3::zeros());
    let mut stepper = Stepper::new(&resting, Method::ExplicitEuler).unwrap();
    stepper.step(1e308).unwrap();
    refused(stepper.step(1e308), ErrorKind::Unrepresentable, "the time after a step");
    assert_eq!(stepper.time(), 1e308);

    // A spin whose turn to the body's axes leaves the range.
    let axes = UnitQuaternion::from_euler_angles(0.3, -0.4, 0.9);
    let leaning = in_axes(Vector3::new(1.1, 0.46, 1.05), &axes);
    let fast = Body::spinning(leaning, UnitQuaternion::identity(), &Vector3::new(0.3e308, 1.1e308, -0.2e308))
        .unwrap();
    refused(Stepper::new(&fast, Method::Buss), ErrorKind::Unrepresentable, "the spin comes out as");
}
