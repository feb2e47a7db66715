//! What a hobby engine does, its records with few digits or many, and records that say too little.

use crate::common::{Row, judged, spins, stepped_by, written};
use nalgebra::{Quaternion, Vector3};
use tumbling::attitude::product;
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::step::{Method, State, System};
use tumbling_judge::{Base, Confidence, LawName, Outcome, Rule};

const SPIN: Vector3<f64> = Vector3::new(0.5, 6.0, 0.5);
const BODY: Vector3<f64> = crate::common::MOMENTS;
const H: f64 = 1.0 / 60.0;

/// The commonest rule of all: the spin straight by the gyroscopic term, then the attitude straight by the
/// spin.
fn plain(gyroscopic: bool, by_old: bool, count: u32) -> Vec<Row> {
    let system = System::free(BODY.try_into().unwrap()).unwrap();
    stepped_by(SPIN, H, count, |motion| {
        let old = system.omega(&motion.momentum);
        let rate = angular_acceleration(&BODY, &old, &Vector3::zeros());
        let new = if gyroscopic { old + rate * H } else { old };
        let by = if by_old { old } else { new };
        let q = motion.attitude + product(&motion.attitude, &Quaternion::from_imag(by * (H / 2.0)));
        State { attitude: q / q.norm(), momentum: system.momentum(&new) }
    })
}

/// A number with this number of significant digits, as `%.5g` would have it but for the exponent.
fn significant(x: f64, digits: usize) -> String {
    format!("{x:.*e}", digits - 1)
}

fn text(rows: &[Row], number: impl Fn(f64) -> String) -> String {
    let steps = |t: f64| (t / H).round().to_string();
    written("# inertia: 1 2 2.5; dt: 1/60", rows, steps, number).replacen("t,", "step,", 1)
}

#[test]
fn the_rule_of_a_plain_engine_is_named_whichever_spin_it_turns_by() {
    let named = |rows: &[Row]| {
        let diagnosis = judged(&text(rows, |x| significant(x, 17))).diagnosis.unwrap();
        assert_eq!(diagnosis.confidence, Confidence::ToRounding, "{diagnosis}");
        diagnosis.best.rule
    };
    assert_eq!(named(&plain(true, false, 600)), Rule::plain(Base::Straight(Method::SemiImplicitEuler, 1)));
    assert_eq!(named(&plain(false, false, 600)), Rule::plain(Base::Straight(Method::ConstantSpin, 1)));
    assert_eq!(named(&plain(true, true, 600)).method(), Some((Method::ExplicitEuler, 1)));
}

#[test]
fn a_spin_without_its_gyroscopic_term_fails_however_few_its_digits() {
    let verdict = judged(&text(&plain(false, false, 1200), |x| format!("{x:.4}")));
    assert_eq!(verdict.outcome, Outcome::Failed, "{verdict}");
    let diagnosis = verdict.diagnosis.unwrap();
    let (best, straight) = (diagnosis.best.rule, Rule::plain(Base::Straight(Method::ConstantSpin, 1)));
    assert!(best.method() == Some((Method::ConstantSpin, 1)) || best == straight, "{diagnosis}");
    // Stepped slowly enough for no single step to show it.
    let slow: String =
        (0..4000).map(|i| format!("{:.3},0.0100,0.1200,0.0100\n", 0.01 * f64::from(i))).collect();
    let verdict = judged(&format!("# inertia: 1 2 2.5\nt,wx,wy,wz\n{slow}"));
    assert_eq!(verdict.outcome, Outcome::Failed, "{verdict}");
}

#[test]
fn an_error_beyond_the_limit_is_never_kept_to_rounding_and_a_great_one_never_bounded() {
    for digits in [4, 5, 6] {
        let verdict = judged(&text(&plain(true, false, 1200), |x| significant(x, digits)));
        assert!(verdict.broken().all(|law| law.growth.rank() > 0), "{verdict}");
    }
    // A momentum that grows without end turns about as it pleases, and digits do not excuse that.
    let system = System::free(BODY.try_into().unwrap()).unwrap();
    let pushed = stepped_by(SPIN * 3.0, 0.1, 20, |motion| {
        Method::SemiImplicitEuler.step(&system, motion, 0.1).unwrap_or(*motion)
    });
    let verdict = judged(&crate::common::csv(&pushed));
    let direction = verdict.laws.iter().find(|law| law.name == LawName::Direction).unwrap();
    assert!(direction.most > 1.0 && direction.growth.rank() > 0, "{verdict}");
    // An energy that grows a millionfold in a second, and stays there.
    let rows = (0..600).map(|i| {
        let t = 0.01 * f64::from(i);
        (t, Vector3::new(0.1, 3.0, 0.2) * (7.0 * t.min(1.0)).exp())
    });
    let verdict = judged(&spins("# inertia: 1 2 2.5", rows));
    let energy = verdict.laws.iter().find(|law| law.name == LawName::Energy).unwrap();
    assert!(energy.most > 1e6 && energy.growth.name() == "changed, then stayed", "{energy}");
    assert_eq!(energy.growth.rank(), 5);
}

#[test]
fn a_record_that_says_too_little_is_not_passed() {
    let exact = crate::common::exact(SPIN, 0.01, 400);
    for rows in [2, 3, 5] {
        let verdict = judged(&crate::common::csv(&exact[..rows]));
        assert_eq!(verdict.outcome, Outcome::TooShort, "{rows}: {verdict}");
        assert!(verdict.to_string().contains("TOO SHORT TO JUDGE"));
    }
    assert_eq!(judged(&crate::common::csv(&exact)).outcome, Outcome::Passed);
}

#[test]
fn a_record_whose_numbers_end_is_judged_up_to_there_and_fails() {
    let good = crate::common::csv(&crate::common::exact(SPIN, 0.01, 400));
    for end in ["NaN", "inf", "1e999", "-NAN(IND)", "-nan(ind)", "1.#QNAN"] {
        let verdict = judged(&format!("{good}4.01,1,0,0,0,1,{end},0\n4.02,NaN,NaN,NaN,NaN,NaN,NaN,NaN\n"));
        assert_eq!((verdict.outcome, verdict.record.rows), (Outcome::Failed, 401));
        let said = verdict.to_string();
        assert!(said.contains("line 404, column 7 (`wy`)") && said.contains("udged up to there"), "{said}");
    }
}
