//! What a record passes and fails by, besides the laws that the exact motion keeps.

use crate::common::{MOMENTS, Row, csv, exact, judged, spins, stepped};
use nalgebra::{Quaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::step::Method;
use tumbling_judge::{LawName, Options, Outcome, Verdict, judge};

const HEADER: &str = "# inertia: 1 2 2.5";
const H: f64 = 1.0 / 60.0;
const SPIN: Vector3<f64> = Vector3::new(1.0, 2.0, 1.5);

fn complains(verdict: &Verdict, word: &str) -> bool {
    verdict.complaints.iter().any(|complaint| complaint.to_string().contains(word))
}

#[test]
fn a_spin_that_stands_still_where_it_should_go_round_fails_though_energy_and_momentum_are_kept() {
    let cases = [
        ("1 1 1.8", Vector3::new(0.5, 0.0, 3.0)),
        ("1 2 2.7", SPIN),
        ("1 2 2.7", Vector3::new(0.0, 0.5, 4.0)),
    ];
    for (moments, spin) in cases {
        for count in [60, 600] {
            let verdict = judged(&spins(
                &format!("# inertia: {moments}"),
                (0..count).map(|i| (H * f64::from(i), spin)),
            ));
            assert_eq!(verdict.outcome, Outcome::Failed, "{moments} {count}\n{verdict}");
            assert!(complains(&verdict, "no gyroscopic term"), "{verdict}");
            assert!(verdict.broken().next().is_none(), "{verdict}");
        }
    }
}

#[test]
fn the_exact_motion_at_another_pace_fails_and_at_its_own_passes() {
    let motion = FreeMotion::new(MOMENTS.try_into().unwrap(), &SPIN).unwrap();
    for pace in [1.0, 0.5, 2.0] {
        let rows = (0..=600).map(|i| (H * f64::from(i), motion.omega(H * f64::from(i) * pace).unwrap()));
        // An error that no rule makes to rounding, so that the pace alone decides.
        let rows = rows.enumerate().map(|(i, (t, w))| (t, w * (1.0 + 1e-9 * (i as f64 * 0.7).sin())));
        let text = spins(HEADER, rows);
        let verdict = judged(&text);
        if pace == 1.0 {
            assert_eq!(verdict.outcome, Outcome::Passed, "{verdict}");
            continue;
        }
        assert_eq!(verdict.outcome, Outcome::Failed, "{verdict}");
        assert!(complains(&verdict, "periods of the exact motion"), "{verdict}");
        // The caller's own limit takes the place of the usual one.
        let verdict = judge(text.as_bytes(), &Options::default().with(LawName::Phase, 1e3)).unwrap();
        assert_eq!(verdict.outcome, Outcome::Passed, "{verdict}");
    }
}

#[test]
fn a_spin_too_fast_to_follow_is_never_passed_nor_said_to_be_right() {
    let spin = Vector3::new(1.0, 2.0, 3.0);
    let mut lost = 0;
    for power in [3, 10, 16, 20, 30, 50, 100, 150, 153, 155, 200, 300, 307] {
        let w = spin * format!("1e{power}").parse::<f64>().unwrap();
        let text = spins("# inertia: 1 2 3", (0..40).map(|i| (0.1 * f64::from(i), w)));
        // Beyond what numbers hold the record may be refused.
        let Ok(verdict) = judge(text.as_bytes(), &Options::default()) else { continue };
        assert!(!verdict.to_string().contains("correct for this start"), "1e{power}\n{verdict}");
        match verdict.outcome {
            Outcome::Failed => {}
            Outcome::NothingToJudge => {
                assert!(verdict.untraceable && power > 13, "1e{power}\n{verdict}");
                assert!(verdict.reasons()[0].contains("turns so far"), "{verdict}");
                lost += 1;
            }
            other => panic!("1e{power}: {other:?}\n{verdict}"),
        }
    }
    assert!(lost > 0);
    // About an axis it is right at any speed; and a motion that can be followed is.
    let axis = (0..40).map(|i| (0.1 * f64::from(i), Vector3::new(0.0, 0.0, 1e100)));
    let verdict = judged(&spins("# inertia: 1 2 3", axis));
    assert!(verdict.outcome == Outcome::NothingToJudge && !verdict.untraceable, "{verdict}");
    assert!(!judged(&csv(&exact(SPIN, H, 600))).untraceable);
}

#[test]
fn right_rules_of_second_order_do_not_fail_by_their_phase() {
    for method in [Method::ImplicitMidpoint, Method::Buss] {
        for spin in [SPIN, Vector3::new(0.1, 3.0, 0.2), Vector3::new(4.0, 0.5, 0.3)] {
            let verdict = judged(&csv(&stepped(method, spin, H, 1200)));
            assert!(!complains(&verdict, "periods of the exact motion"), "{method:?} {spin}\n{verdict}");
        }
    }
}

#[test]
fn a_constant_spin_with_a_wrong_attitude_is_not_right() {
    let right = exact(Vector3::new(0.0, 0.0, 3.0), H, 200);
    assert_eq!(judged(&csv(&right)).outcome, Outcome::NothingToJudge);
    let long: Vec<Row> = right.iter().map(|(t, q, w)| (*t, q * 1.5, *w)).collect();
    let still: Vec<Row> = right.iter().map(|(t, _, w)| (*t, Quaternion::identity(), *w)).collect();
    for rows in [long, still] {
        let verdict = judged(&csv(&rows));
        assert_eq!(verdict.outcome, Outcome::Failed, "{verdict}");
        assert!(!verdict.to_string().contains("correct for this start"), "{verdict}");
    }
}

#[test]
fn the_law_that_is_kept_worst_is_said_with_how_it_is_broken() {
    let rows = exact(SPIN, H, 240);
    // The energy goes as the square of the spin: of the two that grow alike it grows by more.
    for (length, size, wanted) in [
        (0.0, 0.0, "within rounding error."),
        (0.01, 0.0, "is quaternion's length: linear."),
        (0.0, 0.1, "is energy: exponential."),
    ] {
        let row = |(t, q, w): &Row| (*t, q * (1.0 + length * t), w * (size * t).exp());
        let said = judged(&csv(&rows.iter().map(row).collect::<Vec<_>>())).to_string();
        let worst = said.lines().find(|line| line.contains("The worst of the conserved quantities"));
        assert!(worst.unwrap().ends_with(wanted), "{said}");
    }
}

#[test]
fn flips_that_come_late_by_a_time_or_a_share_are_said_to_and_others_are_not() {
    let spin = Vector3::new(0.3, -0.4, 5.0);
    let motion = FreeMotion::new(MOMENTS.try_into().unwrap(), &spin).unwrap();
    let said = |start: f64, time: fn(f64) -> f64| {
        let rows = (0..=600).map(|i| (H * f64::from(i), motion.omega(time(H * f64::from(i))).unwrap()));
        let rows = rows.enumerate().map(|(i, (t, w))| (start + t, if i == 0 { spin } else { w }));
        judged(&spins(HEADER, rows)).to_string()
    };
    // However late the clock is at the start.
    assert!(said(1e4, |t| t - 0.05).contains("; they come later by 0.0500 s."));
    assert!(said(0.0, |t| t / 0.99).contains("; they come earlier by 1.00 % of the time since the start."));
    // Beside its smallest moment's axis a spin that is noise has many more changes of sign than the motion.
    let noise = |i: u32| Vector3::new(5.0, 1e-5 * f64::from(i * i % 7) - 3e-5, 0.0);
    let noisy = judged(&spins(HEADER, (0..600).map(|i| (H * f64::from(i), noise(i)))));
    // No flips are farther apart than the record is long.
    assert!(noisy.flips.as_ref().unwrap().apart < noisy.record.duration, "{noisy}");
    for other in [said(0.0, |t| t - 1e-3 * t * t), said(-100.0, |t| t - 0.1 * H), noisy.to_string()] {
        assert!(other.contains("s apart.") && !other.contains("they come"), "{other}");
    }
}
