//! One fault at a time, made on purpose: it is named with its number, and the rule behind it too.

use crate::common::{Row, csv, exact, judged, stepped, stepped_by};
use nalgebra::Vector3;
use tumbling::attitude::{product, turn};
use tumbling::step::{Method, State, System};
use tumbling_judge::{Alteration, Confidence, Outcome, Rule, Turn, Verdict, judge};

const H: f64 = 1.0 / 60.0;
const SPIN: Vector3<f64> = Vector3::new(1.0, 2.0, 1.5);

fn system(moments: [f64; 3]) -> System<f64> {
    System::free(Vector3::from(moments).try_into().unwrap()).unwrap()
}

/// The rule that every step is surely made by, in a record that fails.
fn sure(verdict: &Verdict) -> Rule {
    let diagnosis = verdict.diagnosis.as_ref().unwrap();
    assert_eq!(diagnosis.confidence, Confidence::ToRounding, "{verdict}");
    assert_eq!(verdict.outcome, Outcome::Failed, "{verdict}");
    diagnosis.best.rule
}

#[test]
fn a_gyroscopic_term_of_half_the_size_or_of_the_wrong_sign_fails_by_name() {
    let body = system([1.0, 2.0, 2.5]);
    for (times, words) in
        [(0.5, "half of the gyroscopic term, "), (-1.0, "the gyroscopic term with the wrong sign, ")]
    {
        let rows = stepped_by(SPIN, H, 600, |start| {
            let momentum = Method::SemiImplicitEuler.step(&body, start, times * H).unwrap().momentum;
            State { attitude: product(&start.attitude, &turn(&(body.omega(&momentum) * H))), momentum }
        });
        let text = csv(&rows);
        let found = sure(&judged(&text));
        assert_eq!(found.name(), words.to_owned() + Method::SemiImplicitEuler.info().name);
        // A spin alone is that of the other hand too.
        let spins = text.lines().map(|line| match line.split(',').collect::<Vec<_>>()[..] {
            [t, _, _, _, _, x, y, z] => format!("{t},{x},{y},{z}\n"),
            _ => format!("{line}\n"),
        });
        assert!(judged(&spins.collect::<String>()).to_string().contains(words.trim_end_matches(", ")));
    }
}

#[test]
fn an_attitude_turned_by_the_old_spin_and_a_spin_a_row_late_are_distinguished() {
    let rows = stepped(Method::ImplicitOneNewton, SPIN * 3.0, H, 600);
    let moved = |by: usize| (1..rows.len() - 1).map(|i| (rows[i].0, rows[i].1, rows[i + 1 - by].2)).collect();
    for (by, turn) in [(0, Turn::Old), (2, Turn::Late)] {
        let rows: Vec<Row> = moved(by);
        let found = judged(&csv(&rows)).diagnosis.unwrap().best.rule;
        assert_eq!(found.alteration, Some(Alteration::Turned(turn)), "{}", found.name());
    }
}

#[test]
fn three_hits_are_found_and_the_rule_is_judged_between_them() {
    let mut rows = exact(SPIN, H, 150);
    for hit in [Vector3::new(0.2, 0.0, -0.1), Vector3::new(0.0, -0.3, 0.2), Vector3::new(-0.1, 0.1, 0.4)] {
        let (t, q, spin) = rows.pop().unwrap();
        let from = exact(spin + hit, H, 150);
        let first = from[0].1.conjugate();
        rows.extend(from.iter().map(|row| (t + row.0, product(&q, &product(&first, &row.1)), row.2)));
    }
    let verdict = judged(&csv(&rows));
    let jumps: Vec<usize> = verdict.diagnosis.as_ref().unwrap().jumps.iter().map(|jump| jump.line).collect();
    assert_eq!(jumps, [153, 303, 453], "{verdict}");
    assert!(verdict.to_string().contains("Every step but 3, which are jumps, is made by: the exact motion."));
}

#[test]
fn a_tensor_may_be_written_in_six_or_nine_numbers_and_a_step_in_place_of_times() {
    let text = csv(&stepped(Method::ConstantSpin, SPIN, H, 100));
    let times = |line: &str| match line.split_once(',') {
        Some((t, rest)) if !t.starts_with('#') => format!("{rest}\n"),
        _ => format!("{line}\n"),
    };
    let untimed = text.lines().map(times).collect::<String>();
    let with = |inertia: &str, text: &str| {
        let text = text.replacen("# inertia: 1 2 2.5 kg m2", inertia, 1);
        judge(text.as_bytes(), &tumbling_judge::Options::default()).map(|verdict| verdict.moments)
    };
    for good in
        ["# inertia: 1 0 0, 0 2 0, 0 0 2.5", "# inertia: 1 2 2.5 0 0 0", "# Ixx: 1\n# Iyy: 2\n# Izz: 2.5"]
    {
        assert_eq!(with(good, &text).unwrap(), Vector3::new(1.0, 2.0, 2.5), "{good}");
    }
    let error = with("# inertia: 1 2 2.5 0 0.1 0", &text).unwrap_err().to_string();
    assert!(error.contains("line 1: 6 numbers are given") && error.contains("principal"), "{error}");
    assert!(with("# inertia: 1 2 2.5; dt: 1/60", &untimed).is_ok());
    assert!(with("# inertia: 1 2 2.5", &untimed).unwrap_err().to_string().contains("`# dt: 1/60`"));
}
