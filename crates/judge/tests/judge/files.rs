//! What a file may have wrong: mistakes of meaning, each made on purpose in a good record, and bad input.

use crate::common::invented::Chance;
use crate::common::{MOMENTS, Row, csv, exact, judged, refused as error, spins, stepped};
use nalgebra::{Quaternion, Vector3};
use std::f64::consts::PI;
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::step::Method;
use tumbling_judge::{FileMistake, Options, Outcome, judge};

const SPIN: Vector3<f64> = Vector3::new(1.0, 2.0, 1.5);

/// Good records: the motion itself, and two engines' rules.
fn good() -> Vec<Vec<Row>> {
    let long = stepped(Method::SemiImplicitEuler, SPIN, 0.01, 800);
    vec![
        exact(SPIN, 0.01, 600),
        exact(Vector3::new(0.2, 0.3, -6.0), 1.0 / 60.0, 600),
        stepped(Method::SemiImplicitEuler, SPIN, 0.01, 600),
        stepped(Method::ImplicitOneNewton, SPIN, 1.0 / 60.0, 600),
        stepped(Method::Rescaled, Vector3::new(-2.0, 0.5, 1.0), 1.0 / 30.0, 600),
        // With gaps.
        (0..40).flat_map(|i| long[20 * i..20 * i + 9].to_vec()).collect(),
    ]
}

fn altered(rows: &[Row], how: impl Fn(&Row) -> Row) -> Vec<Row> {
    rows.iter().map(how).collect()
}

#[test]
fn each_misread_file_made_on_purpose_is_named_and_the_rule_behind_it_too() {
    for rows in good() {
        let right = judged(&csv(&rows));
        assert_eq!(right.file_mistakes, []);
        let rule = right.diagnosis.unwrap().best.rule.method();
        let conj = |q: &Quaternion<f64>| q.conjugate();
        let in_z = |q: &Quaternion<f64>| Quaternion::new(q.w, q.i, q.j, -q.k);
        let world = |q: &Quaternion<f64>, w: &Vector3<f64>| tumbling::attitude::rotation_matrix(q) * w;
        type Mistake<'a> = (FileMistake, Box<dyn Fn(&Row) -> Row + 'a>);
        let mistakes: [Mistake<'_>; 12] = [
            (FileMistake::Frame, Box::new(|(t, q, w)| (*t, *q, world(q, w)))),
            (FileMistake::Order, Box::new(|(t, q, w)| (*t, Quaternion::new(q.i, q.j, q.k, q.w), *w))),
            (FileMistake::ScalarFirst, Box::new(|(t, q, w)| (*t, Quaternion::new(q.k, q.w, q.i, q.j), *w))),
            (FileMistake::RevolutionsPerMinute, Box::new(|(t, q, w)| (*t, *q, w * (30.0 / PI)))),
            (FileMistake::Microseconds, Box::new(|(t, q, w)| (t * 1e6, *q, *w))),
            (FileMistake::Inverse, Box::new(|(t, q, w)| (*t, conj(q), *w))),
            (FileMistake::Degrees, Box::new(|(t, q, w)| (*t, *q, w.map(f64::to_degrees)))),
            (FileMistake::Milliseconds, Box::new(|(t, q, w)| (t * 1e3, *q, *w))),
            (FileMistake::LeftHandedSpin, Box::new(|(t, q, w)| (*t, *q, -w))),
            (FileMistake::LeftHanded, Box::new(|(t, q, w)| (*t, conj(q), -w))),
            (FileMistake::MirroredComponent(1), Box::new(|(t, q, w)| (*t, *q, Vector3::new(w.x, -w.y, w.z)))),
            // One component of all, the z: half a turn about it away from the mirrored one above.
            (FileMistake::LeftHanded, Box::new(|(t, q, w)| (*t, in_z(q), Vector3::new(w.x, w.y, -w.z)))),
        ];
        for (misread, how) in mistakes {
            let verdict = judged(&csv(&altered(&rows, how)));
            assert_eq!(verdict.file_mistakes, [misread]);
            assert_eq!(verdict.outcome, Outcome::Failed);
            assert!(verdict.to_string().contains(&misread.words()[1..]));
            let diagnosis = verdict.diagnosis.unwrap();
            assert_eq!(diagnosis.best.rule.method(), rule, "{misread:?}: {diagnosis}");
        }
    }
}

/// Columns of spin alone.
fn alone(rows: &[Row]) -> String {
    spins("# inertia: 1 2 2.5", rows.iter().map(|(t, _, w)| (*t, *w))).replace(',', ";")
}

#[test]
fn without_an_attitude_the_law_determines_units_and_hand() {
    for rows in good() {
        assert_eq!(judged(&alone(&rows)).file_mistakes, []);
        for (misread, how) in [
            (
                FileMistake::Degrees,
                &(|(t, q, w): &Row| (*t, *q, w.map(f64::to_degrees))) as &dyn Fn(&Row) -> Row,
            ),
            (FileMistake::Milliseconds, &|(t, q, w)| (t * 1e3, *q, *w)),
            (FileMistake::LeftHandedSpin, &|(t, q, w)| (*t, *q, -w)),
        ] {
            assert_eq!(judged(&alone(&altered(&rows, how))).file_mistakes, [misread]);
        }
    }
    // A term that is cut off is no mistake of two units, though 2 pi / 1000 is near.
    let mut spin = Vector3::new(0.01, -0.04, 6.0);
    let cut = (0..400).map(|i| {
        spin += angular_acceleration(&MOMENTS, &spin, &Vector3::zeros()) * (6.47e-3 * 0.01);
        (0.01 * f64::from(i), spin)
    });
    assert_eq!(judged(&spins("# inertia: 1 2 2.5", cut)).file_mistakes, []);
}

#[test]
fn spin_in_world_axes_and_momentum_in_either_are_judged_alike() {
    let rows = stepped(Method::SemiImplicitEuler, SPIN, 0.01, 300);
    let expected = judged(&csv(&rows)).diagnosis.unwrap().best.rule;
    let world = |q: &Quaternion<f64>, v: &Vector3<f64>| tumbling::attitude::rotation_matrix(q) * v;
    for (names, how) in [
        ("wxw,wyw,wzw", &(|(t, q, w): &Row| (*t, *q, world(q, w))) as &dyn Fn(&Row) -> Row),
        ("lx,ly,lz", &|(t, q, w)| (*t, *q, w.component_mul(&MOMENTS))),
        ("Lx_world,Ly_world,Lz_world", &|(t, q, w)| (*t, *q, world(q, &w.component_mul(&MOMENTS)))),
    ] {
        let verdict = judged(&csv(&altered(&rows, how)).replace("wx,wy,wz", names));
        assert_eq!(verdict.file_mistakes, [], "{names}");
        assert_eq!(verdict.diagnosis.unwrap().best.rule, expected, "{names}");
    }
}

#[test]
fn the_order_of_columns_the_separator_and_comments_do_not_matter() {
    let rows = stepped(Method::ImplicitOneNewton, SPIN, 0.01, 200);
    let expected = judged(&csv(&rows));
    for (separator, end) in [(",", "\n"), (";", "\r\n"), ("\t", "\n"), ("   ", "\n")] {
        let mut text = format!("\u{feff}# a run{end}# inertia = (1, 2, 2.5) kg m2{end}{end}");
        text += &(["note", "wz", "q_z", "Time[s]", "\"qx\"", "wx", "qw", "wy", "qy"].join(separator) + end);
        for (t, q, w) in &rows {
            let fields = [w.z, q.k, *t, q.i, w.x, q.w, w.y, q.j].map(|x| format!("{x:?}"));
            text += &format!("left{separator}{}{end}# between{end}", fields.join(separator));
        }
        let verdict = judged(&text);
        assert_eq!(verdict.laws, expected.laws);
        assert_eq!(verdict.diagnosis, expected.diagnosis);
    }
}

#[test]
fn a_spin_that_is_constant_and_should_be_is_nothing_to_judge() {
    for spin in [Vector3::new(0.0, 2.0, 0.0), Vector3::zeros()] {
        let verdict = judged(&csv(&stepped(Method::SemiImplicitEuler, spin, 0.01, 200)));
        assert_eq!(verdict.outcome, Outcome::NothingToJudge);
        assert_eq!(verdict.diagnosis, None);
        assert!(verdict.to_string().contains("The spin is constant"));
    }
    // One that is constant and should not be is judged.
    assert_eq!(judged(&csv(&stepped(Method::ConstantSpin, SPIN, 0.01, 200))).outcome, Outcome::Failed);
}

#[test]
fn missing_rows_are_counted_and_a_varying_step_is_said() {
    let mut rows = exact(SPIN, 0.01, 300);
    rows.drain(100..110);
    rows.remove(50);
    let verdict = judged(&csv(&rows));
    let gaps = verdict.record.gaps.unwrap();
    assert_eq!((gaps.count, gaps.longest.round()), (2, 11.0));
    // Two lines before the rows; the first row missing is the 51st.
    assert_eq!(gaps.line, 53);
    assert_eq!(verdict.outcome, Outcome::Passed);
    let motion = tumbling::exact::FreeMotion::new(MOMENTS.try_into().unwrap(), &SPIN).unwrap();
    let uneven = (0..300).map(|i| {
        let t = 0.01 * f64::from(i) + 0.003 * f64::from(i).sin();
        let now = motion.at(t).unwrap();
        (t, now.attitude.into_inner(), now.omega)
    });
    let verdict = judged(&csv(&uneven.collect::<Vec<Row>>()));
    assert_eq!(verdict.record.step, None);
    assert_eq!(verdict.outcome, Outcome::Passed);
}

#[test]
fn bad_input_is_an_error_with_line_and_column() {
    let head = "# inertia: 1 2 2.5\nt,wx,wy,wz\n0,1,2,3\n";
    let with = |line: &str| error(format!("{head}{line}\n"));
    assert_eq!(with("0.1,1,x2,3"), "line 4, column 3 (`wy`): `x2` is not a number");
    let nan = "line 4, column 3 (`wy`): the value is NaN: from here on there is no motion";
    assert_eq!(with("0.1,1,NaN,3"), nan);
    assert!(with("0.1,1,2,1e999").starts_with("line 4, column 4 (`wz`): the value is 1e999"));
    assert_eq!(with("0.1,1,,3"), "line 4, column 3 (`wy`): the field is empty");
    assert_eq!(with("0.1,1,2"), "line 4: there are 3 fields for 4 columns: `wz` is missing");
    assert!(with("0.1,1,2,3,4").starts_with("line 4, column 5 (``): `4` is one more field"));
    let stands = "line 4, column 1 (`t`): time does not increase: 0 s after 0 s. Write each instant once, in the order of time, and times with all their digits";
    assert_eq!(with("0,1,2,3"), stands);
    assert!(error("").contains("the file is empty"));
    assert!(error("# inertia: 1 2 3\n\n").contains("the file is empty"));
    assert!(error("t,wx,wy,wz\n").contains("no rows"));
    assert!(error(head).contains("one row"));
    assert!(error("t,wx,wy,wz\n0,1,2,3\n1,1,2,3\n").contains("moments are not known"));
    assert!(error("0,1,2,3\n1,1,2,3\n").starts_with("line 1: this must be the line of column names"));
    assert!(error("t,wx,wz\n0,1,2\n").starts_with("line 1: the column `wy` is missing"));
    assert!(error("t,wx,wx,wy,wz\n").starts_with("line 1: there are two columns `wx`"));
    assert!(error("wx,wy,wz\n0,1,2\n").starts_with("line 1: the column `t` is missing"));
    assert!(error("t,x\n").contains("neither spin nor momentum nor attitude"));
    assert!(error("t,wxw,wyw,wzw\n").contains("without its attitude"));
    assert!(error("step,wx,wy,wz\n").contains("their length is not given"));
    assert!(error("# inertia: 1 2 4\nt,wx,wy,wz\n0,1,2,3\n1,1,2,3\n").contains("2 + 1 >= 4"));
    assert!(error("# inertia: 1 2 3; dt: 0\nt,wx,wy,wz\n").starts_with("line 1: the step is given as 0"));
    let no_attitude = "# inertia: 1 2 3\nt,wx,wy,wz,qw,qx,qy,qz\n0,1,2,3,1,0,0,0\n1,1,2,3,0,0,0,0\n";
    assert_eq!(error(no_attitude), "line 4: the quaternion has no length: from here on there is no motion");
    let bytes = [head.as_bytes(), &[0xff, 0xfe, b'\n']].concat();
    assert_eq!(error(bytes), "line 4: the line is not text in UTF-8: save the file in UTF-8");
    let long = format!("{head}{}", "1".repeat(100_000));
    assert!(error(long).contains("longer than"));
}

#[test]
fn numbers_of_few_digits_are_judged_by_their_digits() {
    let rows = exact(SPIN, 0.01, 600);
    let mut text = String::from("# inertia: 1 2 2.5; dt: 0.01\nt,qw,qx,qy,qz,wx,wy,wz\n");
    for (t, q, w) in &rows {
        text +=
            &format!("{t:.2},{:.7},{:.7},{:.7},{:.7},{:.7},{:.7},{:.7}\n", q.w, q.i, q.j, q.k, w.x, w.y, w.z);
    }
    let verdict = judged(&text);
    assert_eq!(verdict.outcome, Outcome::Passed);
    assert!(verdict.record.rounding > 1e-8 && verdict.record.rounding < 1e-6);
    assert!(verdict.laws.iter().all(|law| law.growth.rank() == 0), "{verdict}");
    assert_eq!(verdict.diagnosis.unwrap().best.rule.name(), "the exact motion");
}

/// Terminal, programs and pages have the same sentences, and none of them names an option that only one has.
#[test]
fn the_json_has_the_sentences_of_the_text_and_none_names_an_option_of_the_command_line() {
    let rows = exact(SPIN, 1.0 / 60.0, 600);
    let gaps: Vec<Row> = rows.iter().enumerate().filter(|(i, _)| i % 97 != 5).map(|(_, row)| *row).collect();
    let jump = rows.iter().take(300).chain(&rows).enumerate();
    let jump: Vec<Row> = jump.map(|(i, row)| (i as f64 / 60.0, row.1, row.2)).collect();
    let mut texts: Vec<String> = [&rows, &gaps, &jump].map(|rows| csv(rows)).into();
    let half = altered(&rows, |(t, q, w)| (*t, *q, w * (180.0 / std::f64::consts::PI)));
    texts.push(csv(&half));
    texts.push(csv(&stepped(Method::ConstantSpin, SPIN, 0.01, 600)));
    texts.push(csv(&rows).replace("# inertia: 1 2 2.5 kg m2", "# inertia: 1 2 2.5 kg m2, dt about a step"));
    for text in texts {
        let verdict = judged(&text);
        let (said, json) = (verdict.to_string(), verdict.json());
        let report = json["report"].as_array().unwrap();
        let lines = report.iter().flat_map(|section| section["lines"].as_array().unwrap());
        let sentences: Vec<&str> = lines.filter_map(|x| x.as_str()).collect();
        assert!(sentences.iter().all(|sentence| said.contains(sentence)), "{sentences:?}\n{said}");
        assert!(sentences.len() > 2 && !said.contains(" `--") && !said.contains(" --"), "{said}");
    }
    let alone = csv(&rows[..1]);
    for text in ["t,wx,wy,wz\n0,1,2,3\n1,1,2,3\n", &*alone] {
        assert!(!error(text).contains("--"), "{}", error(text));
    }
}

#[test]
fn no_damage_to_a_file_makes_the_judge_panic() {
    let good = csv(&stepped(Method::SemiImplicitEuler, SPIN, 0.05, 12)).into_bytes();
    let mut chance = Chance(1);
    let mut random = |below: usize| chance.below(below);
    let mut refused = 0;
    for _ in 0..1000 {
        let mut text = good.clone();
        for _ in 0..=random(3) {
            let at = random(text.len());
            match random(4) {
                0 => text[at] = b"0123456789eE+-.,;\t \n#NaninfwxyzqtL\xff"[random(35)],
                1 => drop(text.drain(at..(at + random(40)).min(text.len()))),
                2 => text.splice(at..at, *b"e30").for_each(drop),
                _ => text.truncate(at.max(20)),
            }
        }
        match judge(&text[..], &Options::default()) {
            Ok(verdict) => drop((verdict.to_string(), verdict.json().to_string())),
            Err(error) => {
                refused += 1;
                assert!(!error.to_string().is_empty());
            }
        }
    }
    assert!(refused > 300);
}

#[test]
fn spins_from_the_slowest_to_the_fastest_that_a_number_holds_are_judged_or_refused() {
    for scale in [1e-300, 1e-160, 1e-30, 1e30, 1e100, 1e154, 1e300] {
        let rows = exact(SPIN, 0.01, 100).into_iter().map(|(t, _, w)| (t / scale, w * scale));
        let text = spins("# inertia: 1 2 2.5", rows);
        if let Ok(verdict) = judge(text.as_bytes(), &Options::default()) {
            assert!(!verdict.to_string().is_empty());
            if (1e-100..1e101).contains(&scale) {
                assert_eq!(verdict.outcome, Outcome::Passed, "{scale:e}: {verdict}");
            }
        } else {
            assert!(!(1e-100..1e101).contains(&scale), "{scale:e}");
        }
    }
}

#[test]
fn a_motion_that_jumps_is_named_with_its_place_and_judged_up_to_there() {
    let mut rows = exact(SPIN, 0.01, 300);
    let other = exact(Vector3::new(-2.0, 0.4, 1.0), 0.01, 300);
    rows.truncate(200);
    rows.extend(other.iter().skip(200).copied());
    let verdict = judged(&csv(&rows));
    assert_eq!(verdict.resets.len(), 1);
    // Two lines above the rows, and the 201st row is the first of the other motion.
    assert_eq!(verdict.resets[0].line, 203);
    assert!(!verdict.resets[0].to_rest && !verdict.resets[0].to_start);
    assert_eq!(verdict.outcome, Outcome::Failed);
    assert!(verdict.laws.iter().all(|law| law.growth.rank() == 0), "{verdict}");
    assert_eq!(verdict.diagnosis.unwrap().best.rule, tumbling_judge::Rule::EXACT);
}
