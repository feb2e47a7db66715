//! A motion that jumps.

use crate::common::{csv, exact, judged};
use nalgebra::Vector3;
use tumbling_judge::{Outcome, Rule};

const H: f64 = 1.0 / 60.0;
const SPIN: Vector3<f64> = Vector3::new(1.0, 2.0, 1.5);

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
