//! The kit's stories: the library's exact motion gives every answer, the file agrees with itself, and a
//! method of second order stays within the tolerance of a step.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde_json::Value;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, State, System};
use tumbling::{attitude, dynamics::observe};

struct Answer {
    t: f64,
    spin: Vector3<f64>,
    attitude: UnitQuaternion<f64>,
    within: Value,
}

struct Story {
    name: String,
    json: Value,
    moments: Vector3<f64>,
    spin: Vector3<f64>,
    attitude: UnitQuaternion<f64>,
    answers: Vec<Answer>,
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let all: Vec<f64> = value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    all.try_into().unwrap()
}

fn quaternion(value: &Value) -> UnitQuaternion<f64> {
    let [w, x, y, z] = numbers(value);
    let q = Quaternion::new(w, x, y, z);
    assert!((q.norm() - 1.0).abs() < 4e-16, "{q}");
    UnitQuaternion::new_normalize(q)
}

fn kit() -> (Vec<String>, Vec<Story>) {
    let kit: Value = serde_json::from_str(include_str!("../../kit/stories.json")).unwrap();
    let steps = kit["steps"].as_array().unwrap().iter().map(|x| x.as_str().unwrap().to_owned()).collect();
    let story = |json: &Value| Story {
        name: json["name"].as_str().unwrap().to_owned(),
        json: json.clone(),
        moments: numbers(&json["moments"]).into(),
        spin: numbers(&json["spin"]).into(),
        attitude: quaternion(&json["attitude"]),
        answers: json["answers"]
            .as_array()
            .unwrap()
            .iter()
            .map(|answer| Answer {
                t: answer["t"].as_f64().unwrap(),
                spin: numbers(&answer["spin"]).into(),
                attitude: quaternion(&answer["attitude"]),
                within: answer["within"].clone(),
            })
            .collect(),
    };
    (steps, kit["stories"].as_array().unwrap().iter().map(story).collect())
}

/// Seconds of a step given as a fraction.
fn seconds(step: &str) -> f64 {
    let (over, under) = step.split_once('/').unwrap();
    over.parse::<f64>().unwrap() / under.parse::<f64>().unwrap()
}

/// The errors of spin (relative to its length) and attitude (rad).
fn errors(answer: &Answer, spin: &Vector3<f64>, q: &Quaternion<f64>) -> [f64; 2] {
    let between = attitude::product(&answer.attitude.conjugate().into_inner(), q);
    [(spin - answer.spin).norm() / answer.spin.norm(), 2.0 * between.imag().norm().atan2(between.w.abs())]
}

#[test]
fn the_exact_motion_gives_every_answer_of_the_kit_as_well_as_rounded_inputs_allow() {
    for story in kit().1 {
        let motion = FreeMotion::new(story.moments.try_into().unwrap(), &story.spin).unwrap();
        for answer in &story.answers {
            let now = motion.at(answer.t).unwrap();
            let q = (story.attitude * now.attitude).into_inner();
            let allowed: [f64; 2] = numbers(&answer.within["f64"]);
            for (error, allowed) in errors(answer, &now.omega, &q).into_iter().zip(allowed) {
                // The inputs' rounding, and that of the answer as it is written and compared.
                let share = error / (allowed + 4.0 * f64::EPSILON);
                assert!(share < 2.0, "{} at {}: {error:e}, allowed {allowed:e}", story.name, answer.t);
            }
        }
    }
}

#[test]
fn the_kit_s_flips_are_those_of_the_exact_motion() {
    for story in kit().1 {
        let stated = &story.json["flips"];
        if stated.is_null() {
            continue;
        }
        let stated: Vec<f64> = stated.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        let motion = FreeMotion::new(story.moments.try_into().unwrap(), &story.spin).unwrap();
        let end = story.json["duration"].as_f64().unwrap();
        // A spin that starts in the plane of the other two axes passes there at the start, and does not count
        // it.
        let found: Vec<f64> = motion.flips(0.0, end).unwrap().filter(|&t| t > 0.0).collect();
        assert_eq!(found.len(), stated.len(), "{}", story.name);
        let Some(within) = story.json["flips_within"]["f64"].as_array() else {
            assert!(stated.is_empty());
            continue;
        };
        let most = within.iter().map(|x| x.as_f64().unwrap()).fold(0.0, f64::max);
        for (found, stated) in found.iter().zip(&stated) {
            let allowed = 2.0 * most + 4.0 * f64::EPSILON * stated;
            assert!((found - stated).abs() <= allowed, "{}: {found} {stated} {most:e}", story.name);
        }
    }
}

#[test]
fn each_story_keeps_its_own_energy_momentum_and_direction() {
    for story in kit().1 {
        let energy = story.json["energy"].as_f64().unwrap();
        let momentum = story.json["momentum"].as_f64().unwrap();
        let world: Vector3<f64> = numbers(&story.json["momentum_world"]).into();
        assert!((world.norm() / momentum - 1.0).abs() < 4.0 * f64::EPSILON, "{}", story.name);
        let fastest = story.json["fastest"].as_f64().unwrap();
        let starts = std::iter::once((&story.spin, &story.attitude));
        for (spin, q) in starts.chain(story.answers.iter().map(|x| (&x.spin, &x.attitude))) {
            let angular = story.moments.component_mul(spin);
            assert!((observe::energy(spin, &angular) / energy - 1.0).abs() < 8.0 * f64::EPSILON);
            assert!((angular.norm() / momentum - 1.0).abs() < 8.0 * f64::EPSILON, "{}", story.name);
            assert!((q * angular - world).norm() < 16.0 * f64::EPSILON * momentum, "{}", story.name);
            assert!(spin.norm() <= fastest, "{}", story.name);
        }
        // Between two answers the spin along the middle axis has changed its sign as often as the flips say.
        let Some(flips) = story.json["flips"].as_array() else { continue };
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| story.moments[i].total_cmp(&story.moments[j]));
        let middle = order[1];
        for pair in story.answers.windows(2) {
            let between = flips.iter().filter(|t| (pair[0].t..pair[1].t).contains(&t.as_f64().unwrap()));
            let changed = pair[0].spin[middle] * pair[1].spin[middle] < 0.0;
            assert_eq!(between.count() % 2 == 1, changed, "{} after {}", story.name, pair[0].t);
        }
    }
}

#[test]
fn the_stories_cover_the_spins_and_their_times_fall_on_every_step() {
    let (steps, stories) = kit();
    assert_eq!(steps, ["1/30", "1/60", "1/240", "1/1000"]);
    for spin in [0.1, 1.0, 5.0, 30.0] {
        assert!(stories.iter().any(|x| (x.spin.norm() / spin - 1.0).abs() < 0.01), "{spin}");
    }
    for story in &stories {
        for answer in &story.answers {
            for step in &steps {
                let count = answer.t / seconds(step);
                assert!((count - count.round()).abs() < 1e-9 * count, "{} {} {step}", story.name, answer.t);
            }
        }
    }
}

#[test]
fn the_implicit_midpoint_does_what_the_kit_requires_of_a_step() {
    let (steps, stories) = kit();
    let mut held = 0;
    for story in &stories {
        let system = System::free(story.moments.try_into().unwrap()).unwrap();
        // The finest step takes longest, and adds nothing.
        for step in &steps[..3] {
            let h = seconds(step);
            let mut motion =
                State { attitude: story.attitude.into_inner(), momentum: system.momentum(&story.spin) };
            let mut n = 0.0;
            for answer in &story.answers {
                while n < (answer.t / h).round() {
                    motion = Method::ImplicitMidpoint.step(&system, &motion, h).unwrap();
                    n += 1.0;
                }
                let found = errors(answer, &system.omega(&motion.momentum), &motion.attitude);
                for (error, allowed) in found.into_iter().zip(answer.within[step].as_array().unwrap()) {
                    let Some(allowed) = allowed.as_f64() else { continue };
                    held += 1;
                    assert!(error <= allowed, "{} {step} at {}: {error:e}", story.name, answer.t);
                }
            }
        }
    }
    // Of twice 132 answers at three steps most are held.
    assert!(held > 600, "{held}");
}
