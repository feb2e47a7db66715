//! What the caller may choose: a fitted start, limits for each law; and the points that the run is drawn by.

use crate::common::{MOMENTS, Row, csv, exact, judged, stepped, written};
use nalgebra::Vector3;
use tumbling::exact::FreeMotion;
use tumbling::step::Method;
use tumbling_judge::{LawName, Options, Outcome, Verdict, judge};

const SPIN: Vector3<f64> = Vector3::new(0.1, 3.0, 0.2);

/// With this number of digits of each number.
fn rounded(rows: &[Row], digits: usize) -> String {
    written("# inertia: 1 2 2.5", rows, |t| format!("{t:.4}"), |x| format!("{x:.*e}", digits - 1))
}

fn most(verdict: &Verdict, name: LawName) -> f64 {
    verdict.laws.iter().find(|law| law.name == name).unwrap().most
}

#[test]
fn a_fit_over_the_first_rows_makes_up_for_digits_that_a_record_lacks() {
    // Six digits: the first row alone is off by up to 5e-6 of the spin, and the phase runs away from it.
    let (mut gains, mut worst) = (Vec::new(), 0.0_f64);
    for spin in
        [SPIN, Vector3::new(4.0, 0.5, -0.6), Vector3::new(0.3, -0.4, 5.0), Vector3::new(1.0, 2.0, 1.5)]
    {
        // No component is a number of six digits itself.
        let spin = spin.map(|x| x * (1.0 + 0.1 / std::f64::consts::PI));
        let rows = exact(spin, 0.01, 3000);
        let text = rounded(&rows, 6);
        let plain = judged(&text);
        let fitted = judge(text.as_bytes(), &Options { fit: Some(256), ..Options::default() }).unwrap();
        let fit = fitted.fit.unwrap();
        assert_eq!(fit.rows, 256);
        assert!(fit.left < 5e-6 * spin.norm() && fit.moved < 1e-5 * spin.norm(), "{fit:?}");
        assert_eq!(fitted.outcome, Outcome::Passed);
        gains.push(most(&plain, LawName::Phase) / most(&fitted, LawName::Phase));
        // The fitted start is nearer to the true one than a digit of the file.
        let start = fitted.curve[0].exact;
        worst = worst.max((start - spin).norm() / spin.norm());
    }
    let product: f64 = gains.iter().product();
    assert!(product.powf(0.25) > 3.0, "{gains:?}");
    assert!(worst < 1e-6, "{worst:e}");
}

#[test]
fn a_fit_to_what_is_no_free_motion_is_refused() {
    let text = csv(&stepped(Method::ConstantSpin, SPIN, 0.05, 600));
    let with = |fit: usize| {
        judge(text.as_bytes(), &Options { fit: Some(fit), ..Options::default() })
            .map(drop)
            .map_err(|e| e.to_string())
    };
    let error = with(600).unwrap_err();
    assert!(error.starts_with("a fit over the first 600 rows: "), "{error}");
    assert!(with(1).unwrap_err().contains("two rows at least"));
    assert!(with(602).unwrap_err().contains("the record has 601"));
    let long = csv(&exact(SPIN, 0.01, 2100));
    let error = judge(long.as_bytes(), &Options { fit: Some(5000), ..Options::default() }).unwrap_err();
    assert!(error.to_string().contains("more than 2048"));
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
    let rows = stepped(Method::SemiImplicitEuler, SPIN, 0.02, 3000);
    let verdict = judged(&csv(&rows));
    let motion = FreeMotion::new(MOMENTS.try_into().unwrap(), &SPIN).unwrap();
    let energy = |w: &Vector3<f64>| w.dot(&MOMENTS.component_mul(w));
    let each = 16; // 3001 rows in at most 256 points
    assert_eq!(verdict.curve.len(), 3001_usize.div_ceil(each));
    for (point, rows) in verdict.curve.iter().zip(rows.chunks(each)) {
        assert_eq!((point.time, point.spin), (rows[0].0, rows[0].2));
        assert!((point.exact - motion.omega(rows[0].0).unwrap()).norm() < 1e-9);
        let off = rows.iter().map(|row| energy(&row.2) / energy(&SPIN) - 1.0);
        let largest = off.fold(0.0_f64, |a, b| if b.abs() > a.abs() { b } else { a });
        assert!((point.energy - largest).abs() < 1e-12, "{} {largest}", point.energy);
        let greatest = rows.iter().map(|row| row.2.y).fold(f64::NEG_INFINITY, f64::max);
        assert_eq!(point.spin_range[1].y, greatest);
    }
    let json = verdict.json();
    let curve = &json["curve"];
    for name in ["time", "energy", "momentum", "direction", "phase"] {
        assert_eq!(curve[name].as_array().unwrap().len(), verdict.curve.len(), "{name}");
    }
    for name in ["spin", "exact", "spin_least", "spin_greatest", "exact_least", "exact_greatest"] {
        for axis in 0..3 {
            assert_eq!(curve[name][axis].as_array().unwrap().len(), verdict.curve.len(), "{name}");
        }
    }
    assert_eq!(curve["spin"][1][0].as_f64(), Some(3.0));
    let flips = verdict.flips.unwrap();
    assert_eq!(flips.times.len() as u64, flips.found);
    assert_eq!(json["flips"]["times"][0].as_f64(), flips.first);
}
