//! Records of runs, and what is read from them.

use tumbling_measure::contestant::Group;
use tumbling_measure::record::Work;
use tumbling_measure::verdict::{kind, seconds_at, side_by_side};

fn rung(steps: u64, seconds: f64, attitude: f64) -> Work {
    Work {
        story: "box".into(),
        contestant: "one".into(),
        group: Group::Neither.word().into(),
        setting: format!("{steps} steps"),
        steps: Some(steps),
        seconds: Some(seconds),
        spread: None,
        phase: Some(1e-5),
        attitude: Some(attitude),
        energy: Some(0.0),
        momentum: Some(2e-3),
        direction: Some(3e-7),
        outcome: "right".into(),
    }
}

#[test]
fn errors_of_equal_steps_stand_side_by_side() {
    let mut rows = vec![rung(10, 1.0, 1e-2), rung(100, 10.0, 1e-4)];
    assert_eq!(side_by_side(&rows, "box", 100), ["| one | 1e-5 | 1e-4 | 0 | 2e-3 | 3e-7 |"]);
    (rows[1].phase, rows[1].outcome) = (None, "99 flips".into());
    assert_eq!(side_by_side(&rows, "box", 100), ["| one | 99 flips | 1e-4 | 0 | 2e-3 | 3e-7 |"]);
    assert!(side_by_side(&rows, "racket", 100).is_empty());
}

#[test]
fn time_to_an_error_lies_on_the_line_of_logarithms_between_two_rungs() {
    let mut rows = vec![rung(1, 1.0, 1e-2), rung(10, 10.0, 1e-4), rung(100, 100.0, 1e-6)];
    let attitude = kind("attitude").unwrap();
    let at = |rows: &[Work], error| seconds_at(rows, "box", "one", attitude, error);
    assert!((at(&rows, 1e-3).unwrap() - 10_f64.sqrt()).abs() < 1e-12);
    assert_eq!(at(&rows, 1e-1), Some(1.0));
    assert_eq!(at(&rows, 1e-7), None);
    // A rung that flipped wrongly is no way to an error, and nothing is to be read between it and the
    // next.
    rows[0].outcome = "3 flips".into();
    assert_eq!(at(&rows, 1e-3), Some(10.0));
}
