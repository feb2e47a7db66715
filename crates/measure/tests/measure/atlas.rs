//! The hard cases under torques: that their table is true, and that the adaptive run is right on them.

use tumbling::exact::FreeMotion;
use tumbling_measure::atlas::{CHARTS, Case, Fate, cases};
use tumbling_measure::drive::{Components, Drive};
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

/// The body that single precision is given, of rounded numbers; tiny ones stay as they are.
fn in_single(case: &Case) -> Case {
    let number = |x: f64| if (x as f32).is_normal() { f64::from(x as f32) } else { x };
    let vector = |v: Components| v.map(number);
    let Drive { arm, weight, .. } = case.drive.clone();
    let drive = Drive { arm: vector(arm), weight: number(weight), ..case.drive.clone() };
    Case { moments: vector(case.moments), omega: vector(case.omega), drive, ..case.clone() }
}

/// The two larger moments of these needles and strips differ by a millionth or less: rounding changes the
/// difference, and the truth by up to half a radian.
#[test]
fn in_single_precision_a_needle_with_a_weight_is_another_body_of_which_the_run_is_right() {
    let mut another = Vec::new();
    for case in cases().unwrap().into_iter().filter(|case| case.chart == "shapes") {
        let given = in_single(&case);
        let truth = given.run::<f64>(None, 1e-10).unwrap();
        let off = given.off(&given.run::<f32>(None, 1e-5).unwrap(), &truth);
        assert!(off[0].max(off[1]) < 5e-5, "{}: {off:?}", case.name);
        if case.off(&case.truth().unwrap(), &truth)[1] > 0.01 {
            another.push(case.name);
        }
    }
    assert!(another.len() > 3, "{another:?}");
}

#[test]
fn the_adaptive_run_is_right_to_many_digits_on_every_hard_case() {
    for case in cases().unwrap() {
        let end = case.run::<f64>(None, 1e-10).unwrap();
        let off = case.off(&end, &case.truth().unwrap());
        assert!(off[0].max(off[1]) < 1e-6, "{}, {}: {off:?}", case.chart, case.name);
        assert_eq!(case.fate(None).unwrap(), Fate::Right);
    }
}
