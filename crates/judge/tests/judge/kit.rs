//! The kit's stories: the library's exact motion gives every answer, the file agrees with itself, and a
//! method of second order stays within the tolerance of a step.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde_json::Value;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, State, System};
use tumbling::{attitude, dynamics::observe};
use tumbling_judge::{Answer, Story};

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let all: Vec<f64> = value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    all.try_into().unwrap()
}

fn quaternion([w, x, y, z]: [f64; 4]) -> UnitQuaternion<f64> {
    let q = Quaternion::new(w, x, y, z);
    assert!((q.norm() - 1.0).abs() < 4e-16, "{q}");
    UnitQuaternion::new_normalize(q)
}

/// The steps; and the stories, with what the file says of each besides.
fn kit() -> (Vec<String>, Vec<(Story, Value)>) {
    let kit: Value = serde_json::from_str(include_str!("../../kit/stories.json")).unwrap();
    let steps = kit["steps"].as_array().unwrap().iter().map(|x| x.as_str().unwrap().to_owned()).collect();
    let (read, stories) = (Story::all(), kit["stories"].as_array().unwrap().clone());
    assert_eq!(read.len(), stories.len());
    (steps, read.into_iter().zip(stories).collect())
}

fn exact(story: &Story) -> FreeMotion {
    FreeMotion::new(Vector3::from(story.moments).try_into().unwrap(), &story.spin.into()).unwrap()
}

/// Seconds of a step given as a fraction.
fn seconds(step: &str) -> f64 {
    let (over, under) = step.split_once('/').unwrap();
    over.parse::<f64>().unwrap() / under.parse::<f64>().unwrap()
}

/// The errors of spin (relative to its length) and attitude (rad).
fn errors(answer: &Answer, spin: &Vector3<f64>, q: &Quaternion<f64>) -> [f64; 2] {
    let between = attitude::product(&quaternion(answer.attitude).conjugate().into_inner(), q);
    let stated = Vector3::from(answer.spin);
    [(spin - stated).norm() / stated.norm(), 2.0 * between.imag().norm().atan2(between.w.abs())]
}

#[test]
fn the_exact_motion_gives_every_answer_of_the_kit_as_well_as_rounded_inputs_allow() {
    for (story, json) in kit().1 {
        let motion = exact(&story);
        assert_eq!(story.answers.len(), json["answers"].as_array().unwrap().len());
        for (answer, json) in story.answers.iter().zip(json["answers"].as_array().unwrap()) {
            let now = motion.at(answer.time).unwrap();
            let q = (quaternion(story.attitude) * now.attitude).into_inner();
            let allowed: [f64; 2] = numbers(&json["within"]["f64"]);
            for (error, allowed) in errors(answer, &now.omega, &q).into_iter().zip(allowed) {
                // The inputs' rounding, and that of the answer as it is written and compared.
                let share = error / (allowed + 4.0 * f64::EPSILON);
                assert!(share < 2.0, "{} at {}: {error:e}, allowed {allowed:e}", story.name, answer.time);
            }
        }
    }
}

#[test]
fn the_kit_s_flips_are_those_of_the_exact_motion() {
    for (story, json) in kit().1 {
        let (Some(stated), motion) = (&story.flips, exact(&story)) else { continue };
        // A spin that starts in the plane of the other two axes passes there at the start, and does not count
        // it.
        let found: Vec<f64> = motion.flips(0.0, story.duration).unwrap().filter(|&t| t > 0.0).collect();
        assert_eq!(found.len(), stated.len(), "{}", story.name);
        let Some(within) = json["flips_within"]["f64"].as_array() else {
            assert!(stated.is_empty());
            continue;
        };
        let most = within.iter().map(|x| x.as_f64().unwrap()).fold(0.0, f64::max);
        for (found, stated) in found.iter().zip(stated) {
            let allowed = 2.0 * most + 4.0 * f64::EPSILON * stated;
            assert!((found - stated).abs() <= allowed, "{}: {found} {stated} {most:e}", story.name);
        }
    }
}

#[test]
fn each_story_keeps_its_own_energy_momentum_and_direction() {
    for (story, json) in kit().1 {
        let energy = json["energy"].as_f64().unwrap();
        let momentum = json["momentum"].as_f64().unwrap();
        let world: Vector3<f64> = numbers(&json["momentum_world"]).into();
        assert!((world.norm() / momentum - 1.0).abs() < 4.0 * f64::EPSILON, "{}", story.name);
        let starts = std::iter::once((story.spin, story.attitude));
        for (spin, q) in starts.chain(story.answers.iter().map(|x| (x.spin, x.attitude))) {
            let (spin, q) = (Vector3::from(spin), quaternion(q));
            let angular = Vector3::from(story.moments).component_mul(&spin);
            assert!((observe::energy(&spin, &angular) / energy - 1.0).abs() < 8.0 * f64::EPSILON);
            assert!((angular.norm() / momentum - 1.0).abs() < 8.0 * f64::EPSILON, "{}", story.name);
            assert!((q * angular - world).norm() < 16.0 * f64::EPSILON * momentum, "{}", story.name);
            assert!(spin.norm() <= story.fastest, "{}", story.name);
        }
        // Between two answers the spin along the middle axis has changed its sign as often as the flips say.
        let Some(flips) = &story.flips else { continue };
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| story.moments[i].total_cmp(&story.moments[j]));
        let middle = order[1];
        for pair in story.answers.windows(2) {
            let between = flips.iter().filter(|t| (pair[0].time..pair[1].time).contains(t));
            let changed = pair[0].spin[middle] * pair[1].spin[middle] < 0.0;
            assert_eq!(between.count() % 2 == 1, changed, "{} after {}", story.name, pair[0].time);
        }
    }
}

#[test]
fn the_stories_cover_the_spins_and_their_times_fall_on_every_step() {
    let (steps, stories) = kit();
    assert_eq!(steps, ["1/30", "1/60", "1/240", "1/1000"]);
    for spin in [0.1, 1.0, 5.0, 30.0] {
        let off = |story: &Story| (Vector3::from(story.spin).norm() / spin - 1.0).abs();
        assert!(stories.iter().any(|(story, _)| off(story) < 0.01), "{spin}");
    }
    for (story, _) in &stories {
        for answer in &story.answers {
            for step in &steps {
                let count = answer.time / seconds(step);
                let off = (count - count.round()).abs();
                assert!(off < 1e-9 * count, "{} {} {step}", story.name, answer.time);
            }
        }
    }
}

#[test]
fn the_implicit_midpoint_does_what_the_kit_requires_of_a_step() {
    let (steps, stories) = kit();
    let mut held = 0;
    for (story, json) in &stories {
        let system = System::free(Vector3::from(story.moments).try_into().unwrap()).unwrap();
        // The finest step takes longest, and adds nothing.
        for step in &steps[..3] {
            let h = seconds(step);
            let (attitude, momentum) = (quaternion(story.attitude), system.momentum(&story.spin.into()));
            let mut motion = State { attitude: attitude.into_inner(), momentum };
            let mut n = 0.0;
            for (answer, json) in story.answers.iter().zip(json["answers"].as_array().unwrap()) {
                while n < (answer.time / h).round() {
                    motion = Method::ImplicitMidpoint.step(&system, &motion, h).unwrap();
                    n += 1.0;
                }
                let found = errors(answer, &system.omega(&motion.momentum), &motion.attitude);
                for (error, allowed) in found.into_iter().zip(json["within"][step].as_array().unwrap()) {
                    let Some(allowed) = allowed.as_f64() else { continue };
                    held += 1;
                    assert!(error <= allowed, "{} {step} at {}: {error:e}", story.name, answer.time);
                }
            }
        }
    }
    // Of twice 132 answers at three steps most are held.
    assert!(held > 600, "{held}");
}
