//! What the caller may choose: limits for each law; and the points that the run is drawn by.

use crate::common::{MOMENTS, Row, csv, judged, stepped};
use nalgebra::Vector3;
use tumbling::attitude::rotation_matrix;
use tumbling::exact::FreeMotion;
use tumbling::step::Method;
use tumbling_judge::{LawName, Options, Outcome, Verdict, judge};

const SPIN: Vector3<f64> = Vector3::new(0.1, 3.0, 0.2);

fn most(verdict: &Verdict, name: LawName) -> f64 {
    verdict.laws.iter().find(|law| law.name == name).unwrap().most
}

#[test]
fn the_phase_may_have_a_limit_of_its_own() {
    let text = csv(&stepped(Method::ImplicitOneNewton, SPIN, 0.001, 2000));
    let with = |options: Options| judge(text.as_bytes(), &options).unwrap();
    // The phase is held to nothing, unless a limit is given.
    let phase = most(&with(Options::default()), LawName::Phase);
    let strict = with(Options::default().with(LawName::Phase, 0.9 * phase));
    assert_eq!(strict.outcome, Outcome::Failed);
    assert!(strict.broken().map(|law| law.name).eq([LawName::Phase]));
    assert_eq!(with(Options::default().with(LawName::Phase, 1.1 * phase)).outcome, Outcome::Passed);
}

#[test]
fn the_points_to_draw_a_run_by_are_the_rows_and_the_exact_motion() {
    // However many rows there are, in at most 256 points.
    for (count, each) in [(100, 1), (256, 1), (257, 2), (512, 2), (5000, 32), (3001, 16)] {
        let rows = stepped(Method::SemiImplicitEuler, SPIN, 0.02, count - 1);
        let verdict = judged(&csv(&rows));
        drawn(&verdict, &rows, each);
        if count == 3001 {
            the_json_has_the_same(&verdict);
        }
    }
}

/// That each point of the run's drawing is of its rows.
fn drawn(verdict: &Verdict, rows: &[Row], each: usize) {
    let motion = FreeMotion::new(MOMENTS.try_into().unwrap(), &SPIN).unwrap();
    let energy = |w: &Vector3<f64>| w.dot(&MOMENTS.component_mul(w));
    assert_eq!(verdict.curve.len(), rows.len().div_ceil(each));
    let in_world = |row: &Row| rotation_matrix(&row.1) * MOMENTS.component_mul(&row.2);
    let start = in_world(&rows[0]);
    for (point, rows) in verdict.curve.iter().zip(rows.chunks(each)) {
        assert_eq!((point.time, point.spin), (rows[0].0, rows[0].2));
        assert!((point.exact - motion.omega(rows[0].0).unwrap()).norm() < 1e-9);
        let off = rows.iter().map(|row| energy(&row.2) / energy(&SPIN) - 1.0);
        let largest = off.fold(0.0_f64, |a, b| if b.abs() > a.abs() { b } else { a });
        assert!((point.energy - largest).abs() < 1e-12, "{} {largest}", point.energy);
        let spins = rows.iter().map(|row| row.2).fold([rows[0].2; 2], |[a, b], w| [a.inf(&w), b.sup(&w)]);
        assert_eq!(point.spin_range, spins);
        let exact = rows.iter().map(|row| motion.omega(row.0).unwrap());
        let exact = exact.fold([point.exact; 2], |[a, b], w| [a.inf(&w), b.sup(&w)]);
        assert!((0..2).all(|i| (point.exact_range[i] - exact[i]).norm() < 1e-9));
        let turned = rows.iter().map(|row| in_world(row).angle(&start)).fold(0.0, f64::max);
        assert!((point.direction.unwrap() - turned).abs() < 1e-6, "{point:?} {turned}");
    }
}

fn the_json_has_the_same(verdict: &Verdict) {
    let json = verdict.json();
    let curve = &json["curve"];
    let one = ["time", "energy", "momentum", "direction", "phase"].map(|name| vec![&curve[name]]);
    let three = ["spin", "exact", "spin_least", "spin_greatest", "exact_least", "exact_greatest"]
        .map(|name| [0, 1, 2].map(|axis| &curve[name][axis]).to_vec());
    let lengths = one.iter().chain(&three).flatten().map(|all| all.as_array().unwrap().len());
    assert!(lengths.eq([verdict.curve.len(); 23]));
    assert_eq!(curve["spin"][1][0].as_f64(), Some(3.0));
    let flips = verdict.flips.as_ref().unwrap();
    assert_eq!(flips.times.len() as u64, flips.found);
    assert_eq!(json["flips"]["times"][0].as_f64(), flips.first);
}
