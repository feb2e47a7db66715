//! Plans of scenes against the table of truth: 30 digits of bodies free and under torques.

use tumbling_measure::story::{Story, all};
use tumbling_scenes::{Answer, Error, InitialState, Outputs, Scene, Times};

/// How far the last answer is from the truth: the angle of the attitudes, or the difference of the spins as a
/// share.
fn off(story: &Story, last: &Answer) -> f64 {
    let spin = story.system.omega(&story.truth.motion.momentum);
    let truth = nalgebra::UnitQuaternion::from_quaternion(story.truth.motion.attitude);
    last.attitude.unwrap().angle_to(&truth).max((last.spin.unwrap() - spin).norm() / spin.norm())
}

#[test]
fn scenes_are_as_accurate_as_requested_against_the_truth() {
    let mut driven = 0;
    for story in all().unwrap() {
        let body = InitialState::spinning(*story.system.moments(), story.system.omega(&story.start.momentum));
        for accuracy in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10] {
            let (times, torques) = (Times::every(0.5, story.end), story.system.torques().to_vec());
            let outputs = Outputs { spin: true, attitude: true, ..Outputs::NOTHING };
            let scene = Scene::new([body], torques, times, outputs, accuracy).unwrap();
            let plan = match scene.plan(0) {
                // A hundred flips leave less than ten digits of the attitude.
                Err(Error::Body { source, .. }) if story.is_free() => {
                    assert!(matches!(*source, Error::Unattainable { requested: 1e-10, .. }), "{source}");
                    continue;
                }
                plan => plan.unwrap(),
            };
            let last = plan.states().last().unwrap().unwrap();
            assert_eq!(last.time, story.end);
            let off = off(&story, &last);
            assert!(off < accuracy, "{}: {off:.1e}, {accuracy:e} requested: {}", story.name, plan.explain());
            driven += usize::from(!story.is_free());
        }
    }
    assert_eq!(driven, 35);
}
