//! Records of attitudes alone.

use crate::common::{MOMENTS, Row, SPINS, csv, exact, judged, refused, stepped, stepped_by, written};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::attitude::{product, rotation_matrix, turn};
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::step::{Method, State, System};
use tumbling_judge::{FileMistake, LawName, Outcome, Rule};

fn alone(rows: &[Row], number: impl Fn(f64) -> String) -> String {
    let text = written("# inertia: 1 2 2.5", rows, |t| format!("{t:?}"), number);
    let cut = |line: &str| line.split(',').take(5).collect::<Vec<_>>().join(",") + "\n";
    text.lines().map(cut).collect()
}

fn attitudes(rows: &[Row]) -> String {
    alone(rows, |x| format!("{x:.16e}"))
}

#[test]
fn the_exact_motion_by_its_attitudes_alone_is_kept_to_rounding_in_every_law_that_they_tell() {
    for spin in SPINS {
        for h in [1.0 / 30.0, 1.0 / 240.0] {
            let verdict = judged(&attitudes(&exact(spin.into(), h, 1500)));
            assert_eq!(verdict.outcome, Outcome::Passed, "{verdict}");
            assert_eq!(verdict.record.missing, [LawName::Consistency]);
            let kept = verdict.laws.iter().all(|law| law.growth.rank() == 0 && law.most < 1e-6);
            assert!(kept, "{spin:?} {h}: {verdict}");
            let names: Vec<LawName> = verdict.laws.iter().map(|law| law.name).collect();
            assert_eq!(names, &LawName::ALL[..6]);
            assert_eq!(verdict.diagnosis.unwrap().best.rule, Rule::EXACT);
            assert!((verdict.curve[0].spin - Vector3::from(spin)).norm() < 1e-9);
        }
    }
}

#[test]
fn the_roundings_of_few_digits_break_no_law_and_are_not_said_to_grow() {
    let said = judged(&alone(&exact(SPINS[0].into(), 0.01, 600), |x| format!("{x:.3}"))).to_string();
    assert!(said.contains("too few digits to say whether the spin changes"), "{said}");
    for (spin, digits) in SPINS.into_iter().flat_map(|spin| [2, 3, 4].map(|digits| (spin, digits))) {
        for h in [0.01, 0.1] {
            let number = |x: f64| format!("{x:.*e}", digits - 1);
            let rows = exact(spin.into(), h, 300);
            let text = written("# inertia: 1 2 2.5", &rows, |t| format!("{t:?}"), number);
            for text in [text, alone(&rows, number)] {
                let verdict = judged(&text);
                let grows = verdict.worst().is_some_and(|law| law.growth.rank() > 1);
                assert!(!grows && verdict.outcome != Outcome::Failed, "{verdict}");
                let off = verdict.laws.iter().any(|law| law.name.is_conserved() && law.most > 0.01);
                let said = verdict.to_string().contains("no more than its digits leave open");
                assert_eq!(said, off && verdict.outcome == Outcome::Passed, "{verdict}");
            }
        }
    }
}

#[test]
fn the_order_and_the_sense_of_attitudes_alone_are_determined_by_the_law() {
    for spin in [SPINS[0], SPINS[3]] {
        let rows = exact(spin.into(), 0.02, 800);
        let mistakes = |of: fn(&Quaternion<f64>) -> Quaternion<f64>| {
            let rows: Vec<Row> = rows.iter().map(|(t, q, w)| (*t, of(q), *w)).collect();
            judged(&attitudes(&rows)).file_mistakes
        };
        assert_eq!(mistakes(|q| Quaternion::new(q.i, q.j, q.k, q.w)), [FileMistake::Order]);
        // Not to be distinguished from the other: the one is the other's mirror image.
        assert_eq!(mistakes(|q| Quaternion::new(q.k, q.w, q.i, q.j)), [FileMistake::Order]);
        assert_eq!(mistakes(|q| q.conjugate()), [FileMistake::Inverse]);
        assert_eq!(judged(&attitudes(&rows)).file_mistakes, []);
    }
}

#[test]
fn steps_near_half_a_turn_are_refused_in_plain_words() {
    let text = attitudes(&exact(Vector3::new(1.0, 2.0, 1.5), 0.9, 100));
    let error = refused(text);
    assert!(error.starts_with("line 4: the attitude turns by") && error.contains("shorter steps"), "{error}");
    // A run that gets there is judged as far as its turns are known.
    let mut rows = exact(Vector3::new(1.0, 2.0, 1.5), 0.02, 400);
    rows[300].1 *= Quaternion::new(0.0, 1.0, 0.0, 0.0);
    let verdict = judged(&attitudes(&rows));
    assert_eq!(verdict.outcome, Outcome::Failed);
    let seen = verdict.complaints.iter().any(|x| x.to_string().starts_with("line 303: the attitude turns"));
    assert!(seen, "{verdict}");
    assert!((verdict.record.duration - 298.0 * 0.02).abs() < 1e-9, "{}", verdict.record.duration);
}

#[test]
fn attitudes_written_again_are_refused_or_said_to_be_the_end_and_never_a_rest() {
    let rows = exact(Vector3::new(1.0, 2.0, 1.5), 0.01, 200);
    let at = |place: fn(usize) -> usize| {
        let row = |i| (0.01 * i as f64, rows[place(i)].1, rows[place(i)].2);
        (0..240).map(row).collect::<Vec<Row>>()
    };
    for twice in [|i| i / 2, |i| i / 3] {
        let error = refused(attitudes(&at(twice)));
        assert!(error.contains("Write each instant once"), "{error}");
    }
    let stopped = at(|i| i.min(200));
    assert!(judged(&attitudes(&stopped)).to_string().contains("also a last row that repeats"));
    let said = judged(&csv(&stopped)).to_string();
    assert!(said.contains("repeat the row before them (39, from line 204 on): the run may have"), "{said}");
    assert!(said.contains("at t = 2.0000 s") && said.contains("rounding, with: the exact motion"), "{said}");
    // Spins alone go by their law up to there.
    let said = judged(&csv(&stopped).replacen("qw,qx,qy,qz", "a,b,c,d", 1)).to_string();
    assert!(said.contains("repeat the row before them (39, from line 204 on): the run may have"), "{said}");
}

#[test]
fn attitudes_of_fewer_digits_than_are_printed_are_told_from_a_turn_that_is_wrong() {
    let (a, b, c) = (Method::Rescaled, Method::TurnedRungeKutta4, Method::Gauss4);
    for (method, places) in [(a, 1e5), (a, 1e7), (b, 1e7), (c, 1e5), (c, 1e7)] {
        let mut rows = stepped(method, Vector3::new(1.0, 2.0, 1.5), 1.0 / 60.0, 400);
        for (_, q, _) in &mut rows {
            let matrix = rotation_matrix(q).map(|x| (x * places).round() / places);
            *q = UnitQuaternion::from_matrix(&matrix).into_inner();
        }
        let said = judged(&csv(&rows)).to_string();
        assert!(said.contains("off in one step and back in the next"), "{said}");
    }
}

#[test]
fn of_attitudes_alone_both_the_file_and_a_wrong_sign_are_judged_and_the_one_that_fits_is_named() {
    let rate = |w: Vector3<f64>| angular_acceleration(&MOMENTS, &w, &Vector3::zeros());
    let system = System::free(MOMENTS.try_into().unwrap()).unwrap();
    let said = |digits: usize, new: &dyn Fn(Vector3<f64>) -> Vector3<f64>| {
        let rows = stepped_by(SPINS[1].into(), 0.01, 300, |motion| {
            let w = new(system.omega(&motion.momentum));
            let attitude = product(&motion.attitude, &turn(&(w * 0.01)));
            State { attitude, momentum: system.momentum(&w) }
        });
        judged(&alone(&rows, |x| format!("{x:.*e}", digits - 1))).to_string()
    };
    let words = ["the gyroscopic term with the wrong sign", "half of the gyroscopic", "twice the gyroscopic"];
    for (times, words) in [-1.0, 0.5, 2.0].into_iter().zip(words) {
        let known = said(17, &|w| w + rate(w) * (times * 0.01));
        let is_named = known.contains(&format!("to the record's rounding, with: {words}"));
        assert!(is_named && !known.contains("Perhaps") && !known.contains("amping"), "{known}");
    }
    let heun = said(17, &|w| w - (rate(w) + rate(w - rate(w) * 0.01)) * 0.005);
    // Of five digits either may be had.
    for said in [heun, said(5, &|w| w - rate(w) * 0.01)] {
        assert!(said.contains("Perhaps the quaternion") && said.contains("with the wrong sign"), "{said}");
    }
}

#[test]
fn a_reading_that_leads_to_an_error_does_not_end_the_verdict_of_the_other() {
    // Under names of another order; behind the rows that it is seen in a push, too small for the law as named
    // to show, and a rest.
    let spin = Vector3::from(SPINS[3]);
    let (mut rows, after) = (exact(spin, 0.01, 2100), exact(spin * 1.5, 0.01, 100));
    let (end, join) = (rows[2100].0, rows[2100].1 * after[0].1.conjugate());
    rows.extend(after.iter().skip(1).map(|(t, q, w)| (end + t, join * q, *w)));
    rows[2150].1 = rows[2149].1;
    rows.iter_mut().for_each(|(_, q, _)| *q = Quaternion::new(q.i, q.j, q.k, q.w));
    let verdict = judged(&attitudes(&rows));
    assert_eq!(
        (&verdict.file_mistakes[..], verdict.resets[0].line),
        (&[FileMistake::Order][..], 2104),
        "{verdict}"
    );
}
