//! Mistakes of an engine, each made on purpose in a good rule, and named.

use crate::common::{MOMENTS, Row, csv, exact, judged, stepped_by};
use nalgebra::{Quaternion, Vector3};
use tumbling::attitude::turn;
use tumbling::step::{Method, State, System};
use tumbling_judge::{Alteration, Confidence, Diagnosis, Outcome, Rule};

const H: f64 = 1.0 / 60.0;
const SPIN: Vector3<f64> = Vector3::new(1.0, 2.0, 1.5);
const METHODS: [Method; 3] = [Method::SemiImplicitEuler, Method::ConstantSpin, Method::ImplicitOneNewton];

/// A run of a method whose step's outcome (attitude before, after, spin after) is altered.
fn altered(
    method: Method,
    spin: Vector3<f64>,
    count: u32,
    how: impl Fn(&Quaternion<f64>, Quaternion<f64>, Vector3<f64>) -> (Quaternion<f64>, Vector3<f64>),
) -> Vec<Row> {
    let system = System::free(MOMENTS.try_into().unwrap()).unwrap();
    stepped_by(spin, H, count, |motion| {
        let end = method.step(&system, motion, H).unwrap();
        let (attitude, omega) = how(&motion.attitude, end.attitude, system.omega(&end.momentum));
        State { attitude, momentum: system.momentum(&omega) }
    })
}

fn diagnosed(rows: &[Row]) -> Diagnosis {
    let verdict = judged(&csv(rows));
    assert_eq!(verdict.outcome, Outcome::Failed, "{verdict}");
    let diagnosis = verdict.diagnosis.unwrap();
    assert!(matches!(diagnosis.confidence, Confidence::ToRounding), "{diagnosis}");
    diagnosis
}

#[test]
fn a_threshold_for_small_rotations_is_named() {
    // Between the least and the greatest turn of a step: some steps stand still, and some do not.
    let mut tried = 0;
    for method in METHODS {
        let free = altered(method, SPIN * 0.6, 600, |_, q, omega| (q, omega));
        let turns = free.iter().map(|row| row.2.norm() * H);
        let (least, most) = turns.fold((f64::MAX, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
        if most < least * 1.01 {
            continue; // the spin of a body without a gyroscopic term is constant
        }
        let limit = (least + most) / 2.0;
        let rows = altered(method, SPIN * 0.6, 600, |start, q, omega| {
            (if omega.norm() * H <= limit { *start } else { q }, omega)
        });
        let diagnosis = diagnosed(&rows);
        assert!(matches!(diagnosis.best.rule.alteration, Some(Alteration::SmallTurn(_))), "{diagnosis}");
        tried += 1;
    }
    assert_eq!(tried, 2, "the others cross the threshold");
    let rows = altered(Method::ImplicitOneNewton, SPIN * 0.3, 600, |start, _, omega| (*start, omega));
    let diagnosis = diagnosed(&rows);
    let Some(Alteration::SmallTurn(angle)) = diagnosis.best.rule.alteration else { panic!("{diagnosis}") };
    let expected = rows[1..].iter().map(|row| row.2.norm() * H).fold(0.0, f64::max);
    assert!((angle - expected).abs() < 0.01 * expected, "{angle} {expected}");
}

#[test]
fn small_spins_put_to_zero_are_named() {
    let clamp = |omega: Vector3<f64>| omega.map(|x| if x.abs() <= 0.05 { 0.0 } else { x });
    for method in [Method::SemiImplicitEuler, Method::ImplicitOneNewton] {
        // Where a component goes through zero it is held there.
        let rows = altered(method, SPIN, 600, |start, _, omega| {
            let kept = clamp(omega);
            (start * turn(&(kept * H)), kept)
        });
        let diagnosis = diagnosed(&rows);
        let Some(Alteration::Zeroed(least)) = diagnosis.best.rule.alteration else { panic!("{diagnosis}") };
        assert!(least <= 0.05 && least > 0.01, "{least}");
        // About the middle axis, with a push too small to get over the threshold, it looks like no gyroscopic
        // term at all.
        let rows = altered(method, Vector3::new(0.0, 3.0, 0.1), 400, |start, _, omega| {
            let kept = clamp(omega);
            (start * turn(&(kept * H)), kept)
        });
        let diagnosis = diagnosed(&rows);
        assert!(diagnosis.hints.iter().any(|hint| hint.to_string().contains("small spins")), "{diagnosis}");
    }
}

#[test]
fn damping_by_axis_is_named_with_its_sizes() {
    let factors = Vector3::new(0.999, 0.99, 1.0);
    for method in METHODS {
        let rows = altered(method, SPIN, 400, |start, _, omega| {
            let omega = omega.component_mul(&factors);
            (start * turn(&(omega * H)), omega)
        });
        let diagnosis = diagnosed(&rows);
        let Some(Alteration::DampedByAxis(found, _)) = diagnosis.best.rule.alteration else {
            panic!("{method:?}: {diagnosis}")
        };
        assert!((found - factors).norm() < 1e-9, "{found}");
        let system = System::free(MOMENTS.try_into().unwrap()).unwrap();
        let rows = stepped_by(SPIN, H, 400, |motion| {
            let omega = system.omega(&motion.momentum).component_mul(&factors);
            method.step(&system, &State { momentum: system.momentum(&omega), ..*motion }, H).unwrap()
        });
        let diagnosis = diagnosed(&rows);
        let Some(Alteration::DampedByAxis(found, _)) = diagnosis.best.rule.alteration else {
            panic!("{method:?}: {diagnosis}")
        };
        assert!((found - factors).norm() < 1e-9, "{found}");
    }
}

#[test]
fn a_turn_without_its_half_is_named_with_the_factor() {
    for factor in [0.5, 2.0] {
        for method in METHODS {
            let rows =
                altered(method, SPIN, 400, |start, _, omega| (start * turn(&(omega * H * factor)), omega));
            let diagnosis = diagnosed(&rows);
            let Some(Alteration::OtherTurn(found)) = diagnosis.best.rule.alteration else {
                panic!("{method:?}: {diagnosis}")
            };
            assert_eq!(found, factor);
        }
    }
}

#[test]
fn steps_of_another_length_than_stated_are_named_with_the_factor() {
    let system = System::free(MOMENTS.try_into().unwrap()).unwrap();
    for factor in [0.5, 2.0, 1.2] {
        for method in [Method::SemiImplicitEuler, Method::ImplicitOneNewton] {
            let rows = stepped_by(SPIN, H, 400, |motion| method.step(&system, motion, H * factor).unwrap());
            let diagnosis = diagnosed(&rows);
            // A body at a standstill of the turn has no other clock: the exact motion's is its base's.
            let Some(Alteration::OtherStep(found)) = diagnosis.best.rule.alteration else {
                panic!("{method:?} {factor}: {diagnosis}")
            };
            assert_eq!(found, factor);
        }
    }
}

#[test]
fn a_motion_that_jumps_is_named_with_its_place_and_judged_up_to_there() {
    let mut rows = exact(SPIN, H, 300);
    let other = exact(Vector3::new(-2.0, 0.4, 1.0), H, 300);
    rows.truncate(200);
    rows.extend(other.iter().skip(200).copied());
    let verdict = judged(&csv(&rows));
    assert_eq!(verdict.resets.len(), 1);
    // Two lines above the rows, and the 201st row is the first of the other motion.
    assert_eq!(verdict.resets[0].line, 203);
    assert!(!verdict.resets[0].to_rest && !verdict.resets[0].to_start);
    assert_eq!(verdict.outcome, Outcome::Failed);
    assert_eq!(verdict.diagnosis.unwrap().best.rule, Rule::EXACT);
    for law in &verdict.laws {
        assert_eq!(law.growth.rank(), 0, "{law}");
    }
}
