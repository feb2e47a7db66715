//! Scenes of bodies under torques: the method follows from the torque and the accuracy, and it is right.

use crate::common::{BOTH, SPIN, apart, one, states};
use nalgebra::Vector3;
use tumbling::step::{Stepper, Torque};
use tumbling_scenes::{InitialState, Outputs, Strategy, Times};

/// A push so weak that one step would do: two runs met at the one requested instant, and both were wrong by
/// three times what was requested.
#[test]
fn runs_are_compared_between_the_times_requested_too() {
    let (moments, omega) = (Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.1, 3.0, 0.2));
    let field = Vector3::new(0.0, 0.0, -0.001_254_310_970_579_529_5);
    let torque = Torque::Aligning { arm: Vector3::new(0.125, 0.0, 0.5), field };
    let at = |accuracy| {
        let times = Times::Given(vec![7.907_675_008_433_149]);
        let scene = one(InitialState::spinning(moments, omega), vec![torque.clone()], times, BOTH, accuracy);
        let plan = scene.plan(0).unwrap();
        assert!(plan.driven().unwrap().observed_difference() <= 0.5 * accuracy, "{}", plan.explain());
        states(&plan)[0]
    };
    assert!(apart(&at(1e-2), &at(1e-9)) < 1e-2);
}

/// Where nothing that moves is requested, a torque costs nothing either.
#[test]
fn a_driven_scene_of_which_nothing_is_requested_computes_nothing() {
    let damped = vec![Torque::Damping(Vector3::new(1.0, 2.0, 3.0))];
    let body = InitialState::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(3.0, 5.0, 2.0));
    let scene = one(body, damped.clone(), Times::every(0.1, 100.0), Outputs::NOTHING, 1e-9);
    let plan = scene.plan(0).unwrap();
    let spinning = one(body, damped.clone(), Times::every(0.1, 100.0), SPIN, 1e-9);
    let spin = spinning.plan(0).unwrap();
    assert!(plan.strategy() == Strategy::Nothing && plan.driven().is_none(), "{}", plan.explain());
    assert!(plan.cost().once < 0.1 * spin.cost().once, "{} {}", plan.explain(), spin.explain());
    // And the attitude, not requested, refines no step.
    let cost = |outputs| {
        one(body, damped.clone(), Times::every(0.1, 5.0), outputs, 1e-7).plan(0).unwrap().cost().state
    };
    assert!(cost(SPIN) <= cost(BOTH));
}

/// Against the flips of an adaptive run of the same body, which the library's tests hold against closed
/// forms.
#[test]
fn flips_under_torques_are_those_of_the_bodys_steps() {
    let body = InitialState::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.2, 3.0, 0.1));
    let top = Torque::gravity(&Vector3::new(0.125, 0.25, 0.5), 1.5);
    let push = Torque::during(2.0, 5.0, Torque::InBody(Vector3::new(0.1, -0.2, 0.3)));
    let outputs = Outputs { flips: true, ..Outputs::NOTHING };
    for torques in [
        vec![Torque::Damping(Vector3::new(0.02, 0.04, 0.05))],
        vec![top.clone(), push],
        vec![top, Torque::Dissipation(0.002)],
    ] {
        let stepper = Stepper::adaptive(&body.body().unwrap(), 1e-12, 10_000).unwrap();
        let expected = stepper.with_torques(torques.clone()).unwrap().flips(20.0).unwrap();
        let scene = one(body, torques, Times::Given(vec![20.0]), outputs, 1e-8);
        let flips: Vec<f64> = scene.plan(0).unwrap().flips().unwrap().collect();
        assert!(flips.len() >= 3 && flips.len() == expected.len(), "{flips:?} {expected:?}");
        assert!(flips.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-7), "{flips:?} {expected:?}");
    }
    // With two equal moments there is no middle axis.
    let coin = InitialState::spinning(Vector3::new(1.0, 1.0, 2.0), Vector3::new(1.0, 2.0, 3.0));
    let scene = one(coin, vec![Torque::InBody(Vector3::x())], Times::every(1.0, 10.0), outputs, 1e-6);
    assert_eq!(scene.plan(0).unwrap().flips().unwrap().remaining(), 0);
}

/// Two strong torques, hardly a digit requested, and ten thousand seconds: the way there is longer than
/// anybody waits. And damping of 3e46 N m s about one axis, with a torque that spins the body up about
/// another: each step is a collocation, of which fewer are tried.
#[test]
fn trials_end_after_a_number_of_steps_in_all() {
    let body = InitialState::spinning(Vector3::new(1.794, 1.112, 1.532), Vector3::new(0.368, -0.454, 0.189));
    let (arm, field) = (Vector3::new(-2.64, 5.36, 2.48), Vector3::new(-8.12, -9.62, 3.27));
    let weight = [Torque::InWorld(Vector3::new(4.42, 4.05, -3.34)), Torque::Aligning { arm, field }];
    let damping = Torque::Damping(Vector3::new(0.001, 3e46, 1e-30));
    let damped = [damping, Torque::InWorld(Vector3::new(8867.2, 0.0, 22584.8))];
    for (torques, end, most) in [(weight, 1e4, 3_000_000), (damped, 10.0, 150_000)] {
        let scene = one(body, torques.to_vec(), Times::every(end, end), SPIN, 0.5);
        let message = scene.plan(0).unwrap_err().to_string();
        assert!(message.contains(&format!("the trial runs took {most} steps")), "{message}");
    }
}

/// Steady torques of this size would turn the body a thousand million times: a thruster in the last second,
/// two pulses that cancel, and a drag that holds the spin at 1 rad/s.
#[test]
fn torques_that_turn_a_body_less_than_their_size_says_are_answered() {
    let body = InitialState::spinning(Vector3::new(1.0, 1.5, 0.75), Vector3::zeros());
    let push = Vector3::x() * 100.0;
    let during = |from, push| Torque::during(from, from + 1.0, Torque::InBody(push));
    for (torques, last) in [
        (vec![during(99_999.0, push)], 100.0),
        (vec![during(10.0, push), during(11.0, -push)], 0.0),
        (vec![Torque::InBody(push), Torque::Damping(Vector3::repeat(100.0))], 1.0),
    ] {
        let scene = one(body, torques, Times::every(1e5, 1e5), SPIN, 1e-6);
        let spin = states(&scene.plan(0).unwrap())[1].spin.unwrap();
        assert!((spin - Vector3::x() * last).norm() < 1e-4, "{spin}");
    }
}
