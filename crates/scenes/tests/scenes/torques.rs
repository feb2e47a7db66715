//! A scene under torques against steps of the same body, and what a scene makes of its torques.

use crate::common::{ALL, BOTH, one, states};
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::step::{Stepper, Torque};
use tumbling_scenes::{InitialState, Scene, Start, Strategy, Times};

/// Measured in axes other than its principal ones, and turned in the world.
fn lopsided() -> InitialState {
    InitialState {
        moments: Vector3::new(1.0, 1.75, 2.25),
        products: Vector3::new(0.125, -0.25, 0.0625),
        attitude: UnitQuaternion::from_euler_angles(0.3, -0.7, 1.9),
        start: Start::Spin(Vector3::new(0.5, 1.5, -0.75)),
    }
}

const ARM: Vector3<f64> = Vector3::new(0.3, -0.5, 0.8);
const REST: Vector3<f64> = Vector3::new(0.0, 0.6, 0.8);
const ORBIT: Vector3<f64> = Vector3::new(0.5, 0.25, -0.25);

/// One thruster within the first second, one across two of the times, a spring that lets go; and for all of
/// the time a magnet in its field, a body that goes round and one that stands still, and a push to and fro.
/// That the steps follow the laws of these torques, the library's tests show.
#[test]
fn torques_of_every_kind_at_once_move_a_body_as_its_steps_do() {
    let torques = [
        Torque::during(0.5, 0.75, Torque::InBody(ARM * 5.0)),
        Torque::during(1.5, 2.625, Torque::InWorld(REST * -2.0)),
        Torque::during(f64::NEG_INFINITY, 2.0, Torque::spring(&ARM, &REST, 4.0)),
        Torque::Aligning { arm: ARM * 2.0, field: REST * 1.5 },
        Torque::gravity_gradient(&ORBIT.cross(&Vector3::x()).normalize(), &ORBIT),
        Torque::GravityGradient { strength: 2.0, direction: REST, orbit: Vector3::zeros() },
        Torque::Periodic { amplitude: ARM * 3.0, rate: 2.5, phase: 0.75 },
    ];
    for accuracy in [1e-3, 1e-6, 1e-9] {
        let stepper = Stepper::adaptive(&lopsided().body().unwrap(), 1e-14, 10_000).unwrap();
        let mut stepper = stepper.with_torques(torques.clone()).unwrap();
        let times = Times::Given(vec![0.25, 1.0, 1.75, 2.5, 4.0]);
        let scene = one(lopsided(), torques.to_vec(), times, ALL, accuracy);
        let plan = scene.plan(0).unwrap();
        let mut fastest = 0.0_f64;
        for state in states(&plan) {
            let there = UnitQuaternion::new_unchecked(stepper.step_to(state.time).unwrap().attitude);
            let spin = stepper.omega();
            fastest = fastest.max(spin.norm());
            let turned = state.attitude.unwrap().angle_to(&there);
            let off = turned.max((state.spin.unwrap() - spin).norm() / fastest);
            assert!(off < accuracy, "{off:e} of {accuracy:e} at {} s: {}", state.time, plan.explain());
        }
    }
}

#[test]
fn what_never_acts_is_left_out_and_windows_within_windows_are_one() {
    let push = || Torque::InBody(Vector3::x());
    let scene = |torques: Vec<Torque<f64>>| one(lopsided(), torques, Times::every(1.0, 2.0), BOTH, 1e-9);
    let kept = |torque: Torque<f64>| scene(vec![torque]).torques().to_vec();
    assert_eq!(kept(Torque::during(1.0, 1.0, push())), []);
    assert_eq!(kept(Torque::during(0.0, 1.0, Torque::during(2.0, 3.0, push()))), []);
    assert_eq!(kept(Torque::during(0.0, 1.0, Torque::InBody(Vector3::zeros()))), []);
    let still = Torque::GravityGradient { strength: 0.0, direction: REST, orbit: ORBIT };
    assert_eq!(kept(still), []);
    for nothing in
        [Torque::gravity(&Vector3::z(), 0.0), Torque::Damping(Vector3::zeros()), Torque::Dissipation(0.0)]
    {
        assert_eq!(kept(nothing), []);
    }
    assert_eq!(kept(Torque::during(f64::NEG_INFINITY, f64::INFINITY, push())), [push()]);
    let nested = Torque::during(0.0, 2.0, Torque::during(1.0, 3.0, push()));
    assert_eq!(kept(nested), [Torque::during(1.0, 2.0, push())]);
    // A body that no torque moves is answered in closed form.
    let scene = scene(vec![Torque::during(1.0, 1.0, push())]);
    assert_eq!(scene.plan(0).unwrap().strategy(), Strategy::Elliptic);
}

#[test]
fn a_function_is_refused_in_a_window_too_and_what_is_not_valid_by_its_number() {
    let new = |torque| Scene::new([lopsided()], vec![torque], Times::every(1.0, 2.0), BOTH, 1e-9);
    let law = Torque::function(|_, _, _| Vector3::x());
    let scene = new(Torque::during(0.0, 1.0, law)).unwrap();
    let message = scene.plan(0).unwrap_err().to_string();
    assert!(message.starts_with("body 0: the motion under a torque given by a function"), "{message}");
    let uneven = Torque::Damping(Vector3::new(1.0, 2.0, 2.0));
    let message = new(Torque::during(0.0, 1.0, uneven)).unwrap().plan(0).unwrap_err().to_string();
    assert!(message.starts_with("body 0: damping that differs from axis to axis"), "{message}");
    let message = new(Torque::during(2.0, 1.0, Torque::InBody(ARM))).unwrap_err().to_string();
    assert!(message.starts_with("torque 0: the start of a torque"), "{message}");
}
