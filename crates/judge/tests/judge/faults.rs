//! Hits on the way, and a header in other words. (Other faults are the invented records'.)

use crate::common::{MOMENTS, Row, csv, exact, judged, stepped, stepped_by};
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::attitude::{product, rotation_matrix, turn};
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::step::{Method, State, System};
use tumbling_judge::{Alteration, Base, judge};

const H: f64 = 1.0 / 60.0;
const SPIN: Vector3<f64> = Vector3::new(1.0, 2.0, 1.5);

#[test]
fn three_hits_are_found_and_the_rule_is_judged_between_them() {
    let mut rows = exact(SPIN, H, 150);
    for hit in [Vector3::new(0.2, 0.0, -0.1), Vector3::new(0.0, -0.3, 0.2), Vector3::new(-0.1, 0.1, 0.4)] {
        let (t, q, spin) = rows.pop().unwrap();
        let from = exact(spin + hit, H, 150);
        let first = from[0].1.conjugate();
        rows.extend(from.iter().map(|row| (t + row.0, product(&q, &product(&first, &row.1)), row.2)));
    }
    let verdict = judged(&csv(&rows));
    let jumps: Vec<usize> = verdict.diagnosis.as_ref().unwrap().jumps.iter().map(|jump| jump.line).collect();
    assert_eq!(jumps, [153, 303, 453], "{verdict}");
    assert!(verdict.to_string().contains("Every step but 3, which are jumps, is made by: the exact motion."));
}

#[test]
fn damping_is_named_between_hits() {
    // No term: the spin of the body shrinks, and a hit is far more than that.
    let (mut rows, mut spin): (Vec<Row>, _) = (exact(SPIN, H, 0), SPIN);
    for i in 1..300 {
        spin *= 1.0 - 0.3 * H;
        spin += if i % 97 == 0 { Vector3::new(0.3, -0.2, 0.5) } else { Vector3::zeros() };
        rows.push((H * f64::from(i), product(&rows[rows.len() - 1].1, &turn(&(spin * H))), spin));
    }
    let found = judged(&csv(&rows)).diagnosis.unwrap();
    assert_eq!(found.jumps.len(), 3, "{found}");
    assert!(found.best.rule.name().starts_with("damping left on (0.3/s"), "{found}");
    assert!(found.best.rule.name().ends_with("no gyroscopic term"), "{found}");
}

#[test]
fn a_tensor_frozen_where_the_body_started_is_named_under_damping_too() {
    let (system, first) = (
        System::free(MOMENTS.try_into().unwrap()).unwrap(),
        UnitQuaternion::from_euler_angles(0.4, -0.3, 1.1),
    );
    let frozen = |now: &State<f64>| {
        // In the world, by the tensor as it stood at the first attitude.
        let world = rotation_matrix(&now.attitude) * system.omega(&now.momentum);
        let inside = first.inverse() * world;
        let rate = first * angular_acceleration(&MOMENTS, &inside, &Vector3::zeros());
        let world = (world + rate * H) * (1.0 - 0.2 * H);
        let attitude = product(&turn(&(world * H)), &now.attitude);
        State { attitude, momentum: system.momentum(&rotation_matrix(&attitude).tr_mul(&world)) }
    };
    let rows = stepped_by(SPIN, H, 400, |now| {
        let now = State { attitude: first.into_inner() * now.attitude, ..now.clone() };
        let end = frozen(&now);
        State { attitude: first.inverse().into_inner() * end.attitude, ..end }
    });
    let rows: Vec<Row> = rows.iter().map(|(t, q, w)| (*t, first.into_inner() * q, *w)).collect();
    let rule = judged(&csv(&rows)).diagnosis.unwrap().best.rule;
    assert!(matches!(rule.base, Base::FrozenTensor(..)), "{}", rule.name());
    let Some(Alteration::Damped { rate, .. }) = rule.alteration else { panic!("{}", rule.name()) };
    assert!((rate / 0.2 - 1.0).abs() < 1e-6, "{rate}");
}

#[test]
fn a_term_that_is_cut_off_is_no_mistake_of_two_units() {
    // A rate of 0.025 rad/s^2 where the body's own is 4: a ratio that revolutions and milliseconds have too.
    let (mut spin, mut text) =
        (Vector3::new(0.01, -0.04, 6.0), String::from("# inertia: 1 2 2.5\nt,wx,wy,wz\n"));
    for i in 0..400 {
        text += &format!("{:?},{:?},{:?},{:?}\n", H * f64::from(i), spin.x, spin.y, spin.z);
        let rate = angular_acceleration(&MOMENTS, &spin, &Vector3::zeros());
        spin += rate * (0.001 * std::f64::consts::TAU * 1.03 * H);
    }
    assert_eq!(judged(&text).file_mistakes, []);
}

#[test]
fn an_inertia_that_is_not_three_moments_is_refused_with_its_line() {
    for (head, says) in [
        ("inertia: 1 2 2.5 3", "line 1: 4 numbers are given for the inertia"),
        ("inertia: 2", "line 1: 1 number is given for the inertia"),
        ("Ixx: 1, Iyy: 2, Izz: 2.5, Ixy: 0.3", "line 1: the product `ixy` is not zero"),
        ("inertia: 1 2 2.5\n# moments: 1 2 3", "line 2: the moments differ from those in line 1"),
        ("inertia: 1 -2 2.5", "line 1: a principal moment is -2"),
    ] {
        let text = format!("# {head}\nt,wx,wy,wz\n0,1,2,3\n1,1,2,3\n");
        let error = judge(text.as_bytes(), &tumbling_judge::Options::default()).unwrap_err().to_string();
        assert!(error.starts_with(says), "{error}");
    }
}

#[test]
fn quoted_numbers_rates_in_hertz_and_what_c_prints_for_no_number_are_read() {
    let text = csv(&stepped(Method::SemiImplicitEuler, SPIN, H, 100));
    let quoted = text.lines().map(|line| match line.starts_with('#') {
        true => format!("{line}; dt: 60 Hz\n"),
        false => format!("\"{}\"\n", line.replace(',', "\",\"")),
    });
    let verdict = judged(&quoted.collect::<String>());
    assert_eq!((verdict.record.step, &verdict.record.notes[..]), (Some(H), &[][..]));
    let ended = judged(&format!("{text}2,-nan(ind),0,0,0,0,0,0\n"));
    assert!(ended.to_string().contains("the value is -nan(ind): from here on there is no motion"), "{ended}");
}

#[test]
fn a_tensor_may_be_written_in_six_or_nine_numbers_and_a_step_in_place_of_times() {
    let text = csv(&stepped(Method::ConstantSpin, SPIN, H, 100));
    let times = |line: &str| match line.split_once(',') {
        Some((t, rest)) if !t.starts_with('#') => format!("{rest}\n"),
        _ => format!("{line}\n"),
    };
    let untimed = text.lines().map(times).collect::<String>();
    let with = |inertia: &str, text: &str| {
        let text = text.replacen("# inertia: 1 2 2.5 kg m2", inertia, 1);
        judge(text.as_bytes(), &tumbling_judge::Options::default()).map(|verdict| verdict.moments)
    };
    for good in
        ["# inertia: 1 0 0, 0 2 0, 0 0 2.5", "# inertia: 1 2 2.5 0 0 0", "# Ixx: 1\n# Iyy: 2\n# Izz: 2.5"]
    {
        assert_eq!(with(good, &text).unwrap(), Vector3::new(1.0, 2.0, 2.5), "{good}");
    }
    let error = with("# inertia: 1 2 2.5 0 0.1 0", &text).unwrap_err().to_string();
    assert!(error.contains("line 1: 6 numbers are given") && error.contains("principal"), "{error}");
    assert!(with("# inertia: 1 2 2.5; dt: 1/60", &untimed).is_ok());
    assert!(with("# inertia: 1 2 2.5", &untimed).unwrap_err().to_string().contains("`# dt: 1/60`"));
}
