//! What a scene refuses, counts and explains.

use crate::common::{ALL, BOTH, one, states};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::step::Torque;
use tumbling_scenes::{Error, Field, InitialState, Outputs, Scene, Times};

/// Multiples of a step that no sum of doubles meets, and counts so large that a share of them is many.
#[test]
fn as_many_states_as_steps_fit_the_span_and_one() {
    for (step, span, count) in [
        (0.1, 0.3, 4),
        (0.1, 10.0, 101),
        (0.1, 0.299, 3),
        (1.0 / 3.0, 1e3, 3001),
        (1.0, 1e9 - 0.5, 1_000_000_000),
        (1.0, 1e10, 10_000_000_001),
        (1e-3, 1e12, 1_000_000_000_000_001),
    ] {
        let times = Times::every(step, span);
        assert_eq!(times.count(), count, "{step} {span}");
        assert!(times.nth(count - 1) <= span && times.nth(count) <= span);
    }
    assert_eq!(Times::every(0.1, 0.3).nth(3), 0.3);
    // None that a scene refuses is counted, and none overflows.
    for (step, span) in
        [(1e-300, 1.0), (f64::NAN, 1.0), (1.0, f64::NAN), (-0.1, -1.0), (0.0, 1.0), (0.0, 0.0)]
    {
        let times = Times::every(step, span);
        assert!(times.validate().is_err() && times.count() == 0, "{step:e} {span}");
        let _ = times.nth(3);
    }
    assert_eq!(Times::every(f64::EPSILON, 1.0).count(), (1 << 52) + 1);
}

#[test]
fn refusals_are_plain_sentences() {
    let refused = |body: InitialState, torques, time, accuracy| {
        let scene = Scene::new(vec![body], torques, Times::Given(vec![time]), ALL, accuracy);
        scene.and_then(|scene| scene.plan(0).map(drop)).unwrap_err().to_string()
    };
    let slow = InitialState::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.1, 5.0, 0.2));
    let fast = InitialState::spinning(
        Vector3::new(1.37e299, 1.42e299, 1.06e299),
        Vector3::new(-4e299, -8e299, 2e298),
    );
    assert_eq!(refused(slow, vec![], 1.0, 1.0), "the accuracy is 1.0: it must be below 1");
    let message = refused(fast, vec![], 1e9, 1e-9);
    assert!(message.starts_with("body 0: the angle turned up to the last time is inf"), "{message}");
    let push = Torque::InBody(Vector3::new(0.1, 0.0, 0.0));
    let message = refused(slow, vec![push], 10.0, 1e-15);
    let share: f64 = message.rsplit(' ').next().unwrap().parse().unwrap();
    assert!((1e-14..1e-10).contains(&share), "{message}");
}

#[test]
fn what_cannot_be_answered_is_refused_and_says_why() {
    let body = InitialState::spinning(Vector3::new(1.0, 2.0, 2.5), Vector3::new(0.1, 1.0, 0.2));
    let times = Times::every(1.0, 2.0);
    let new = |bodies: Vec<InitialState>, times: &Times, accuracy: f64| {
        Scene::new(bodies, vec![], times.clone(), BOTH, accuracy)
    };
    assert!(matches!(
        new(vec![], &times, 1e-9),
        Err(Error::Value { what: "the number of bodies", value: 0.0, .. })
    ));
    let unsorted = Times::Given(vec![0.0, 2.0, 1.0]);
    assert!(matches!(new(vec![body], &unsorted, 1e-9), Err(Error::Value { what: "a time", value: 2.0, .. })));
    for bad in [Times::Given(vec![]), Times::Given(vec![-1.0]), Times::Given(vec![f64::NAN])] {
        assert!(new(vec![body], &bad, 1e-9).is_err());
    }
    assert!(new(vec![body], &Times::every(1.0, f64::INFINITY), 1e-9).is_err());
    for bad in [0.0, -1.0, 1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(new(vec![body], &times, bad), Err(Error::Value { what: "the accuracy", .. })));
    }
    assert!(matches!(new(vec![body], &times, 1e-17), Err(Error::Unattainable { .. })));
    let source = |scene: &Scene| match scene.plan(0) {
        Err(Error::Body { index: 0, source }) => *source,
        other => panic!("{other:?}"),
    };
    let outputs = Outputs { polhode: true, ..Outputs::NOTHING };
    let drag = || vec![Torque::Damping(Vector3::new(1.0, 1.0, 1.0))];
    assert!(matches!(
        source(&one(body, drag(), times.clone(), outputs, 1e-9)),
        Error::Undefined { what: "the polhode", .. }
    ));
    let still = InitialState::spinning(body.moments, Vector3::zeros());
    let angle_to_momentum = Outputs { angle_to_momentum: true, ..Outputs::NOTHING };
    assert!(matches!(
        source(&one(still, vec![], times.clone(), angle_to_momentum, 1e-9)),
        Error::Undefined { .. }
    ));
    let long =
        InitialState { attitude: UnitQuaternion::new_unchecked(Quaternion::new(2.0, 0.0, 0.0, 0.0)), ..body };
    assert_eq!(source(&one(long, vec![], times, BOTH, 1e-9)).field(), Some(Field::Attitude));
    assert!(one(body, vec![], Times::every(1.0, 2.0), BOTH, 1e-9).plan(7).is_err());
}

#[test]
fn a_span_of_zero_answers_the_start() {
    // A needle across two axes: its spin is not found again from its momentum.
    let (moments, products) = (Vector3::new(0.500_000_5, 0.500_000_5, 1.0), Vector3::x() * -0.499_999_5);
    let body = InitialState { products, ..InitialState::spinning(moments, Vector3::new(0.1, 1.0, 0.2)) };
    for torques in [vec![], vec![Torque::InBody(Vector3::x())]] {
        let scene = one(body, torques, Times::every(1.0, 0.0), ALL, 1e-6);
        let plan = scene.plan(0).unwrap();
        let [state] = states(&plan)[..] else { panic!() };
        assert_eq!(
            (state.time, state.spin, state.attitude),
            (0.0, Some(Vector3::new(0.1, 1.0, 0.2)), Some(body.attitude))
        );
    }
}

/// The other kinds of plan say what they leave out in the chapter `only-what-you-need`.
#[test]
fn a_plan_explains_itself_in_words() {
    for (omega, torques, words) in [
        ([0.0, 1.0, 0.0], vec![], "along a principal axis"),
        ([0.1, 1.0, 0.5], vec![Torque::InBody(Vector3::x())], "since a torque acts"),
        ([0.1, 1.0, 0.5], vec![Torque::Damping(Vector3::repeat(8.0))], "since damping acts"),
    ] {
        let body = InitialState::spinning(Vector3::new(1.0, 2.0, 2.5), omega.into());
        let scene = one(body, torques, Times::every(0.5, 5.0), BOTH, 1e-6);
        let text = scene.plan(0).unwrap().explain();
        assert!(text.contains(words), "{text}");
        let heads = text.lines().zip(["chosen: ", "left out: ", "accuracy: ", "cost: "]);
        assert!(text.lines().count() == 4 && heads.into_iter().all(|(line, head)| line.starts_with(head)));
    }
}
