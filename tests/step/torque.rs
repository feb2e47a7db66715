//! Bodies under torques, against motions with exact solutions.

use super::{free, under};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::PrincipalMoments;
use tumbling::step::{Method, State, Stepper, System, Torque};

/// A torque of this size, from two vectors.
type Kind = fn(f64, Vector3<f64>, Vector3<f64>) -> Torque<f64>;

/// At 1 s a step ends and the next begins; then only the second of two torques acts.
#[test]
fn a_torque_that_takes_over_from_another_is_the_other_one_for_longer() {
    let (moments, push) = (PrincipalMoments::new(1.0, 2.0, 2.6).unwrap(), Vector3::new(0.3, -0.2, 0.5));
    let end = |method, times: &[[f64; 2]]| {
        let torques = times.iter().map(|&[start, end]| Torque::during(start, end, Torque::InBody(push)));
        let body = super::spinning(moments.vector().into(), &Vector3::new(0.4, 1.5, -0.3));
        let mut stepper = Stepper::new(&body, method).unwrap().with_torques(torques).unwrap();
        stepper.run(0.25, 8).last().unwrap().unwrap()
    };
    for method in [Method::RungeKutta4, Method::RotationSplitting2, Method::MoserVeselov8] {
        let [two, one] = [&[[0.0, 1.0], [1.0, 3.0]][..], &[[0.0, 3.0]]].map(|times| end(method, times));
        assert!(super::apart(&two, &one) < 1e-14, "{method:?}: {two:?} {one:?}");
        let short = end(method, &[[0.0, 1.0]]);
        assert!(super::apart(&short, &one) > 0.05, "{method:?}: {short:?}");
    }
}

#[test]
fn bad_torques_are_refused_by_name() {
    let moments = Vector3::new(1.0, 2.0, 2.6);
    for (torque, word) in [
        (Torque::Damping(Vector3::new(0.1, -0.1, 0.1)), "damping"),
        (Torque::Dissipation(-1.0), "dissipation"),
        (Torque::InBody(Vector3::new(f64::NAN, 0.0, 0.0)), "torque"),
        (Torque::gravity(&Vector3::new(f64::INFINITY, 0.0, 0.0), 1.0), "arm"),
        (Torque::during(f64::NAN, 1.0, Torque::InBody(Vector3::y())), "the start of a torque"),
        (Torque::Periodic { amplitude: Vector3::y(), rate: f64::NAN, phase: 0.0 }, "of a periodic torque"),
        (
            Torque::Periodic { amplitude: Vector3::y(), rate: 1.0, phase: f64::INFINITY },
            "of a periodic torque",
        ),
    ] {
        let error = System::with(moments.try_into().unwrap(), vec![torque]).unwrap_err().to_string();
        assert!(error.contains(word), "{error}");
    }
}

#[test]
fn a_body_that_drag_brings_to_rest_stays_there_however_long() {
    // Ten minutes at 60 Hz: the momentum falls by e^-600, below where squares of it are numbers.
    let moments = Vector3::new(1.0, 2.0, 2.6);
    let torques = vec![Torque::Damping(moments), Torque::Dissipation(0.1)];
    let system = under(moments, torques);
    let from = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.1, 2.0, 0.3) };
    let h = 1.0 / 60.0;
    for fixed in [true, false] {
        let mut motion = from;
        for _ in 0..60 * 800 {
            motion = match fixed {
                true => tumbling::step::fixed_rate(&system, &motion, h).unwrap(),
                false => Method::RotationSplitting2.step(&system, &motion, h).unwrap(),
            };
        }
        assert!(motion.momentum.norm() < 1e-300, "{fixed}: {motion:?}");
        assert!((motion.attitude.norm() - 1.0).abs() < 1e-9, "{fixed}: {motion:?}");
    }
}

#[test]
fn implicit_euler_with_the_damping_inside_never_turns_the_momentum_round() {
    let moments = Vector3::new(1.0, 2.0, 2.6);
    let from = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.0, 0.0, 1.0) };
    for strength in [0.1, 2.0, 1e3, 1e6] {
        let system = under(moments, vec![Torque::Damping(moments * strength)]);
        let end = Method::LinearisedImplicit.step(&system, &from, 1.0).unwrap();
        // L (1 + c h) = L before.
        // What is left of a difference from one.
        assert!((end.momentum.z - 1.0 / (1.0 + strength)).abs() < 1e-15, "{strength}: {end:?}");
        assert!(end.momentum.z > 0.0);
    }
}

/// Two equal torques act as one of twice the size, in values and in kicks.
#[test]
fn two_torques_of_a_kind_are_one_of_twice_the_size() {
    let (x, y) = (Vector3::new(0.3, -0.2, 0.7), Vector3::new(-0.1, 0.8, 0.4));
    let kinds: [Kind; 8] = [
        |size, x, _| Torque::InBody(x * size),
        |size, x, _| Torque::InWorld(x * size),
        |size, x, y| Torque::Aligning { arm: x * size, field: y },
        |size, x, _| Torque::Damping(x.abs() * size),
        |size, _, _| Torque::Dissipation(0.1 * size),
        |size, x, y| Torque::GravityGradient { strength: size, direction: x.normalize(), orbit: y },
        |size, x, _| Torque::Periodic { amplitude: x * size, rate: 2.0, phase: 0.3 },
        |size, x, _| Torque::during(-1.0, 1.0, Torque::InBody(x * size)),
    ];
    for (number, kind) in kinds.iter().enumerate() {
        let moments: PrincipalMoments = Vector3::new(1.0, 2.0, 2.6).try_into().unwrap();
        let [both, one] =
            [vec![kind(1.0, x, y); 2], vec![kind(2.0, x, y)]].map(|torques| under(moments, torques));
        let attitude = UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -1.1, 0.6)).into_inner();
        let state = State { attitude, momentum: Vector3::new(0.9, -0.4, 1.3) };
        let [free, rate, other] = [&free(moments), &one, &both].map(|system| system.rate(&state).momentum);
        assert!((rate - free).norm() > 0.01 && (other - rate).norm() < 1e-15, "{number}");
        // By kicks.
        let [end, other] =
            [&one, &both].map(|system| Method::RotationSplitting2.step(system, &state, 0.1).unwrap());
        assert!((other.momentum - end.momentum).norm() < 1e-14, "{number}");
    }
}

#[test]
fn torques_whose_sum_no_number_holds_are_refused() {
    let moments: PrincipalMoments = Vector3::new(1.0, 2.0, 2.6).try_into().unwrap();
    let large = Vector3::new(1e308, -1e308, 0.0);
    for torques in [
        vec![Torque::InBody(large); 2],
        vec![Torque::InBody(large), Torque::InWorld(large)],
        vec![Torque::Aligning { arm: large, field: large.yxz() }],
        vec![Torque::during(0.0, 1.0, Torque::InBody(large)), Torque::InBody(large)],
        vec![Torque::Damping(large.abs()); 2],
    ] {
        assert!(System::with(moments, torques.clone()).is_err(), "{torques:?}");
    }
}
