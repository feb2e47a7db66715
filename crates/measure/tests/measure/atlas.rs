//! The hard cases under torques: that their table is true, and that the adaptive run is right on them.

use tumbling::exact::FreeMotion;
use tumbling_measure::atlas::{CHARTS, Fate, cases};
use tumbling_measure::errors::turn;

#[test]
fn the_cases_stand_in_the_order_of_the_charts() {
    let mut charts: Vec<String> = cases().unwrap().into_iter().map(|case| case.chart).collect();
    charts.dedup();
    assert_eq!(charts, CHARTS);
}

/// A torque against the momentum, constant in the world, slows the free motion's clock: after `t` of the
/// two seconds that it takes to rest, the body is where it was, free, after `t - t^2/4`.
#[test]
fn the_table_has_a_tumbling_body_at_rest_where_the_closed_form_has_it() {
    for (name, time) in [("tumbling, at rest", 1.0), ("tumbling, through rest", 0.0)] {
        let case = cases().unwrap().into_iter().find(|case| case.name == name).unwrap();
        let motion = FreeMotion::new(case.moments.try_into().unwrap(), &case.omega.into()).unwrap();
        let there = motion.at(time).unwrap().attitude;
        assert!(turn(&case.truth().unwrap().attitude, &there) < 1e-14, "{name}");
    }
}

#[test]
fn the_adaptive_run_is_right_to_many_digits_on_every_hard_case() {
    for case in cases().unwrap() {
        let end = case.run(None, 1e-10).unwrap();
        let off = case.off(&end, &case.truth().unwrap());
        assert!(off[0].max(off[1]) < 1e-6, "{}, {}: {off:?}", case.chart, case.name);
        assert_eq!(case.fate(None).unwrap(), Fate::Right);
    }
}
