//! Verdicts that were wrong of records that engines make: rows written at the display's rate, single
//! precision, needles, starts on an axis.

use crate::common::invented::Chance;
use crate::common::{MOMENTS, Row, csv, exact, exact_of, judged, stepped, stepped_by, written};
use nalgebra::{Quaternion, Vector3};
use std::fmt::Write as _;
use tumbling::attitude::{product, turn};
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::exact::FreeMotion;
use tumbling::step::{Method, State, System};
use tumbling_judge::{Confidence, LawName, Note, Options, Outcome, judge};

const SPIN: Vector3<f64> = Vector3::new(1.0, 2.0, 1.5);

/// Every `n`th row, below a header of one's own.
fn every(n: usize, header: &str, rows: &[Row]) -> String {
    let rows: Vec<Row> = rows.iter().step_by(n).copied().collect();
    format!("{header}{}", csv(&rows))
}

/// A record of these moments, each number as its shortest decimal; in single precision or not.
fn printed(moments: [f64; 3], rows: &[Row], single: bool) -> String {
    let [a, b, c] = moments;
    let number = |x: f64| if single { format!("{:?}", x as f32) } else { format!("{x:?}") };
    written(&format!("# inertia: {a:e} {b:e} {c:e}"), rows, |t| format!("{t:?}"), number)
}

#[test]
fn a_spin_that_starts_without_a_middle_component_is_not_held_to_a_flip_at_the_start() {
    let mut chance = Chance(7);
    let mut random = || chance.share();
    for _ in 0..60 {
        let (a, b) = (1.0 + random(), 2.5 + random());
        let moments = [a, b, b + 0.9 * a * random()];
        let sign = |x: f64| if x < 0.5 { -1.0 } else { 1.0 };
        let omega = Vector3::new(sign(random()) * (1.0 + 3.0 * random()), 0.0, sign(random()) * 0.3);
        // Too short for a flip, and not too short to judge.
        let verdict = judged(&printed(moments, &exact_of(moments, omega, 0.02, 100), false));
        assert_eq!(verdict.outcome, Outcome::Passed, "{verdict}");
        let flips = verdict.flips.unwrap();
        assert_eq!(flips.found, flips.exact, "{moments:?} {omega}");
    }
}

#[test]
fn a_step_of_the_header_that_is_a_part_of_the_row_s_is_named_so_and_another_is_not_dropped_silently() {
    let rows = stepped(Method::SemiImplicitEuler, SPIN, 1.0 / 240.0, 1200);
    let few: Vec<Row> = rows.iter().step_by(4).copied().collect();
    let verdict =
        judged(&written("# inertia: 1 2 2.5; dt: 1/240", &few, |t| format!("{t:.4}"), |x| x.to_string()));
    let is_fourth = |note: &Note| matches!(note, Note::StepsPerRow(_, 4));
    assert!(verdict.record.notes.iter().any(is_fourth), "{verdict}");
    assert!(!verdict.to_string().contains("is not used"), "{verdict}");
    assert_eq!(verdict.record.step.map(|step| (step * 60.0 * 1e9).round()), Some(1e9));
    let verdict = judged(&every(4, "# dt: 0.007\n", &rows));
    assert!(verdict.record.notes.iter().any(|note| matches!(note, Note::OtherStep(..))), "{verdict}");
}

#[test]
fn damping_in_each_step_is_named_where_only_every_third_is_written() {
    let system = System::free(MOMENTS.try_into().unwrap()).unwrap();
    let (h, rate) = (1.0 / 60.0, 0.1);
    for method in [Method::SemiImplicitEuler, Method::Rescaled, Method::LinearisedImplicit] {
        let rows = stepped_by(SPIN, h, 900, |motion| {
            let end = method.step(&system, motion, h).unwrap();
            State { momentum: end.momentum * (1.0 - rate * h), ..end }
        });
        // A drag beside the term takes its share of the spin before the step.
        let beside = stepped_by(SPIN, h, 300, |motion| {
            let momentum = method.step(&system, motion, h).unwrap().momentum - motion.momentum * (rate * h);
            let attitude = product(&motion.attitude, &turn(&(system.omega(&momentum) * h)));
            State { attitude, momentum }
        });
        let said = judged(&csv(&beside)).to_string();
        assert!(
            said.contains("rounding, with: damping left on (0.1/s: 1.667e-3 of the spin each step, with"),
            "{said}"
        );
        for header in ["", "# dt: 1/60\n"] {
            let said = judged(&every(3, header, &rows)).to_string();
            let rule =
                format!("(0.1/s: 1.667e-3 of the spin each step, after the turn), {}, 3", method.info().name);
            assert!(
                said.contains(&format!("to the record's rounding, with: damping left on {rule}")),
                "{said}"
            );
        }
    }
}

const ATTITUDE: &str = "t,qw,qx,qy,qz,";
const NO_ATTITUDE: &str = "t,a,b,c,d,";

/// The rows at these places of a run, under times of their own, between rows on the straight line.
fn placed(rows: &[Row], places: impl Iterator<Item = f64>) -> String {
    let at = |(i, place): (usize, f64)| {
        let (a, b, share) = (rows[place as usize], rows[place.ceil() as usize], place.fract());
        let spin = a.2 * (1.0 - share) + b.2 * share;
        (0.01 * i as f64, a.1 * (1.0 - share) + b.1 * share, spin)
    };
    csv(&places.enumerate().map(at).collect::<Vec<_>>())
}

#[test]
fn rows_that_are_written_again_or_interpolated_name_no_rule_however_many() {
    for method in [Method::Gauss4, Method::SemiImplicitEuler] {
        let rows = stepped(method, SPIN, 0.01, 3000);
        let is_in = |columns: &str, wanted: Confidence, places: &mut dyn Iterator<Item = f64>| {
            let verdict = judged(&placed(&rows, places).replacen(ATTITUDE, columns, 1));
            let (said, found) = (verdict.to_string(), verdict.diagnosis.unwrap());
            let rule = ["Nearest", "Used by", "about the spin"].iter().any(|words| said.contains(words));
            assert!(found.confidence == wanted && !rule, "{said}");
        };
        is_in(NO_ATTITUDE, Confidence::Repeated, &mut (0..1800).map(|i: u32| f64::from(i / 60)));
        for (copies, count) in [(2, 1200), (3, 1200), (20, 1200), (25, 1200), (2, 6000)] {
            is_in(ATTITUDE, Confidence::Repeated, &mut (0..count).map(|i: u32| f64::from(i / copies)));
        }
        for (columns, every, long) in [(ATTITUDE, 200, 31), (NO_ATTITUDE, 10, 2)] {
            let stalls = |i| vec![f64::from(i); if i % every == 5 { long } else { 1 }];
            is_in(columns, Confidence::Repeated, &mut (0..600).flat_map(stalls));
        }
        for (count, parts) in [(500, 2.0), (3000, 2.0), (3000, 5.0)] {
            let count = count * parts as u32;
            is_in(ATTITUDE, Confidence::Interpolated, &mut (0..count).map(|i| f64::from(i) / parts));
        }
    }
}

#[test]
fn a_few_rows_that_are_written_again_or_for_the_next_leave_the_rule_as_it_is() {
    let runs = [Method::SemiImplicitEuler, Method::ImplicitMidpoint].map(|by| stepped(by, SPIN, 0.01, 600));
    for (k, rows) in runs.into_iter().chain([exact(SPIN, 0.01, 600)]).enumerate() {
        for (columns, late) in [(ATTITUDE, 0), (ATTITUDE, 1), (NO_ATTITUDE, 0), (NO_ATTITUDE, 1)] {
            let again = |i: u32| u32::from(i % 300 == 5);
            let row = |i| vec![f64::from(i - late * again(i)); (1 + again(i) * (1 - late)) as usize];
            let text = placed(&rows, (0..600).flat_map(row)).replacen(ATTITUDE, columns, 1);
            let said = judged(&text).to_string();
            let wanted = ["row before them: 2, first in", "Every step tried agrees", "engine's steps, once"];
            let has = |words: &&str| said.contains(words);
            assert!(wanted.iter().all(has), "{said}");
            assert!(!["errors below that", "jumps", "acts on"].iter().any(has), "{said}");
            assert_eq!(said.contains("The rule is sound"), k == 1 && columns == ATTITUDE, "{said}");
        }
    }
}

#[test]
fn what_acts_in_some_of_the_steps_is_neither_said_to_be_interpolated_nor_repeated() {
    let run = |change: &dyn Fn(u32, Vector3<f64>, Vector3<f64>) -> Vector3<f64>| {
        let (mut q, mut w, mut rate) = (Quaternion::identity(), SPIN, Vector3::zeros());
        let row = |i: u32| {
            let row = (f64::from(i) / 60.0, q, w);
            rate = change(i, rate, angular_acceleration(&MOMENTS, &w, &Vector3::zeros()));
            w += rate / 60.0;
            q = product(&q, &turn(&(w / 60.0)));
            row
        };
        csv(&(0..600).map(row).collect::<Vec<_>>())
    };
    let contains = |text: String, words: &str| {
        let said = judged(&text).to_string();
        assert!(said.contains(words), "{said}");
    };
    let torque = run(&|_, _, new| new * 1.24).replacen('\n', "; torque: 0 0 0.001\n", 1);
    assert!(!judged(&torque).to_string().contains("that of the gyroscopic term"));
    let push =
        |i: u32| if i % 15 == 14 { Vector3::new(9.0, 7.0, f64::from(i).sin()) } else { Vector3::zeros() };
    let still = run(&|i, _, _| push(i) * f64::from(i).cos()).replacen(ATTITUDE, NO_ATTITUDE, 1);
    contains(still, "Except for jumps (39 of 599 steps tried) all agree to rounding with: no gyro");
    contains(run(&|i, _, new| new + push(i)), "(39 of 599 steps tried) all agree to rounding with: explicit");
    contains(run(&|i, old, new| if i % 2 == 0 { new } else { old }), "None of the known rules fits");
}

#[test]
fn rows_made_equal_by_rounding_are_not_said_to_repeat() {
    for (slow, digits) in [(0.1, 4), (0.3, 3)] {
        let rows = exact(SPIN * slow, 1.0 / 240.0, 1500);
        let text = written("# inertia: 1 2 2.5", &rows, |t| t.to_string(), |x| format!("{x:.digits$}"));
        let said = judged(&text.replacen(ATTITUDE, NO_ATTITUDE, 1)).to_string();
        assert!(!said.contains("repeat"), "{said}");
    }
}

#[test]
fn pushes_in_the_run_of_an_accurate_rule_that_is_not_known_are_seen_with_their_times() {
    let system = System::free(MOMENTS.try_into().unwrap()).unwrap();
    let h = 1.0 / 60.0;
    let (count, push) = (std::cell::Cell::new(0), Vector3::new(0.3, -0.4, 0.6));
    let rows = stepped_by(SPIN, h, 400, |motion| {
        let parts = [0.4, 0.6].into_iter();
        let end = parts.fold(*motion, |now, part| Method::RungeKutta4.step(&system, &now, part * h).unwrap());
        count.set(count.get() + 1);
        let push = if [150, 250].contains(&count.get()) { push } else { Vector3::zeros() };
        State { momentum: end.momentum + push, ..end }
    });
    let verdict = judged(&csv(&rows));
    let (said, found) = (verdict.to_string(), verdict.diagnosis.unwrap());
    let times: Vec<f64> = found.jumps.iter().map(|jump| (jump.time / h).round()).collect();
    assert!(times == [150.0, 250.0] && !found.confidence.names_a_rule(), "{said}");
    assert!(said.contains("the body jumps 2 times in"), "{said}");
}

#[test]
fn no_rule_is_named_from_a_few_of_the_rows() {
    // A spacing of a step and a half throughout, but for one of half a step.
    let motion = FreeMotion::new(MOMENTS.try_into().unwrap(), &SPIN).unwrap();
    let mut t = 0.0;
    let mut rows = Vec::new();
    for i in 0..405 {
        let now = motion.at(t).unwrap();
        // Off by far more than rounding, but for the two rows that are half a step apart.
        let off = if (200..=201).contains(&i) { 1.0 } else { 1.0 + 1e-5 * f64::from(i % 7 - 3) };
        rows.push((t, now.attitude.into_inner(), now.omega * off));
        t += if i == 200 { 0.005 } else { 0.015 };
    }
    let verdict = judged(&csv(&rows));
    assert!(verdict.diagnosis.as_ref().unwrap().steps > 300, "{verdict}");
    assert!(!verdict.to_string().contains("Every step"), "{verdict}");
}

/// A rule whose state is rounded to single precision after every step.
fn single(method: Method, moments: [f64; 3], omega: Vector3<f64>, h: f64, count: u32) -> Vec<Row> {
    let system = System::free(Vector3::from(moments).try_into().unwrap()).unwrap();
    let round = |x: f64| f64::from(x as f32);
    let mut state = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
    let row = |i| {
        let spin = system.omega(&state.momentum).map(round);
        let row = (f64::from(h as f32) * f64::from(i), state.attitude, spin);
        let from = State { attitude: state.attitude, momentum: system.momentum(&spin) };
        let next = method.step(&system, &from, f64::from(h as f32)).unwrap();
        state = State { attitude: Quaternion::from_vector(next.attitude.coords.map(round)), ..next };
        row
    };
    (0..=count).map(row).collect()
}

#[test]
fn advice_never_says_that_there_is_nothing_to_do_where_a_law_is_broken() {
    // Steps of single precision so short that each is exact to its rounding, and a limit that they break.
    let rows = single(Method::Gauss4, [1.0, 2.0, 2.5], SPIN, 1e-3, 20_000);
    let text = printed([1.0, 2.0, 2.5], &rows, true);
    let strict = Options { threshold: 1e-6, ..Options::default() };
    let verdict = judge(text.as_bytes(), &strict).unwrap();
    assert_eq!(verdict.outcome, Outcome::Failed, "{verdict}");
    let words = verdict.to_string();
    assert!(!words.contains("Nothing to do") && words.contains("single precision"), "{words}");
    let loose = judged(&text);
    assert_eq!(loose.outcome, Outcome::Passed, "{loose}");
    assert!(loose.to_string().contains("single precision"), "{loose}");
}

#[test]
fn a_rule_is_not_said_to_keep_a_length_that_jumps_between_its_steps() {
    let system = System::free(MOMENTS.try_into().unwrap()).unwrap();
    let mut rows = Vec::new();
    let mut state = State { attitude: Quaternion::identity(), momentum: system.momentum(&(SPIN * 4.0)) };
    for i in 0..=1200 {
        rows.push((f64::from(i) / 60.0, state.attitude, system.omega(&state.momentum)));
        state = Method::Rescaled.step(&system, &state, 1.0 / 60.0).unwrap();
        state.momentum *= if (i + 1) % 40 == 0 { 1.01 } else { 1.0 };
    }
    let verdict = judged(&csv(&rows));
    let grows = verdict.laws.iter().any(|law| law.name == LawName::Momentum && law.growth.rank() > 2);
    assert!(grows, "{verdict}");
    let said = verdict.to_string();
    assert!(said.contains("(30 of 1200 steps tried) all agree to rounding with: explicit, resc"), "{said}");
    assert!(said.contains("acts on the body") && said.contains("length is set back to its old"), "{said}");
}

#[test]
fn an_explicit_step_turned_straight_is_no_more_wrong_than_the_same_turned_exactly() {
    let straight = |h: f64, count| {
        let system = System::free(MOMENTS.try_into().unwrap()).unwrap();
        stepped_by(SPIN, h, count, |motion| {
            let old = system.omega(&motion.momentum);
            let new = old + angular_acceleration(&MOMENTS, &old, &Vector3::zeros()) * h;
            let q = motion.attitude + product(&motion.attitude, &Quaternion::from_imag(new * (h / 2.0)));
            State { attitude: q / q.norm(), momentum: system.momentum(&new) }
        })
    };
    // Errors fall with the step.
    let off = |h, count| {
        let verdict = judged(&csv(&straight(h, count)));
        verdict.laws.iter().map(|law| law.most).fold(0.0, f64::max)
    };
    assert!(off(1e-3, 3000) < 0.15 * off(1e-2, 300));
    for rows in [straight(1e-3, 3000), stepped(Method::SemiImplicitEuler, SPIN, 1e-3, 3000)] {
        let verdict = judged(&csv(&rows));
        assert_eq!((verdict.outcome, &verdict.complaints[..]), (Outcome::Passed, &[][..]), "{verdict}");
    }
}

#[test]
fn the_separatrix_is_held_relative_to_its_first_value() {
    let moments = [0.03, 1.0, 1.01];
    let spin = Vector3::new(30.0, 0.3, 0.2);
    let mut rows = exact_of(moments, spin, 1.0 / 60.0, 600);
    // A thousandth of L^2, and so of a number that reaches 33.
    rows.iter_mut().enumerate().for_each(|(i, row)| row.2.y *= 1.0 + 8e-3 * (i as f64 / 600.0));
    let verdict = judged(&printed(moments, &rows, false));
    assert!(verdict.separatrix.unwrap()[0] > 25.0);
    assert_eq!(verdict.broken().count(), 0, "{verdict}");
}

#[test]
fn no_number_is_printed_with_more_digits_than_a_reader_takes() {
    let mut text = String::from("# inertia: 1 1 1.5\nt,qw,qx,qy,qz,wx,wy,wz\n");
    for i in 0..20 {
        writeln!(text, "{},1,0,0,0,1e150,2e150,3e150", 0.01 * f64::from(i)).unwrap();
    }
    for text in [text.clone(), text.replace("1 1 1.5", "1e90 1e90 1.5e90")] {
        let words =
            judge(text.as_bytes(), &Options::default()).map_or_else(|e| e.to_string(), |v| v.to_string());
        let longest = words.split(|c: char| !c.is_ascii_digit()).map(str::len).max().unwrap();
        assert!(longest < 20, "{words}");
    }
}

#[test]
fn a_threshold_that_is_no_number_above_zero_is_refused() {
    let text = csv(&exact(SPIN, 0.01, 100));
    for wrong in [f64::NAN, -1.0, 0.0] {
        for options in [
            Options { threshold: wrong, ..Options::default() },
            Options::default().with(LawName::Phase, wrong),
        ] {
            let error = judge(text.as_bytes(), &options).unwrap_err().to_string();
            assert!(error.contains("above zero"), "{error}");
        }
    }
}

#[test]
fn moments_of_any_size_are_judged_alike() {
    let rows = exact_of([1.0, 2.0, 2.5], SPIN, 0.01, 600);
    let wrong = stepped(Method::SemiImplicitEuler, SPIN, 0.01, 600);
    for rows in [rows, wrong] {
        let usual = judged(&printed([1.0, 2.0, 2.5], &rows, false));
        for size in [1e90, 1e-90, 1e150, 1e-150] {
            let verdict = judged(&printed([size, 2.0 * size, 2.5 * size], &rows, false));
            assert_eq!(verdict.outcome, usual.outcome, "{size:e}\n{verdict}");
            let [found, wanted] =
                [&verdict, &usual].map(|x| x.diagnosis.as_ref().unwrap().best.rule.method());
            assert_eq!(found, wanted);
        }
    }
}
