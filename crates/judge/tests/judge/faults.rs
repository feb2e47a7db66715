//! Hits on the way, and a header in other words. (Other faults are the invented records'.)

use crate::common::{csv, exact, judged, stepped};
use nalgebra::Vector3;
use tumbling::attitude::product;
use tumbling::step::Method;
use tumbling_judge::judge;

const H: f64 = 1.0 / 60.0;
const SPIN: Vector3<f64> = Vector3::new(1.0, 2.0, 1.5);

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
