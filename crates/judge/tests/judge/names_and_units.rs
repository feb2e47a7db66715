//! What is read from column names, units and comments, and what is said of those that are not read.

use crate::common::{MOMENTS, Row, csv, exact, judged, refused as error, stepped, written};
use nalgebra::{Quaternion, Vector3};
use tumbling::{attitude::rotation_matrix, step::Method};
use tumbling_judge::{FileMistake, Options, Outcome, Verdict, judge};

const SPIN: Vector3<f64> = Vector3::new(1.0, 2.0, 1.5);
const H: f64 = 1.0 / 60.0;

fn good() -> Vec<Row> {
    exact(SPIN, H, 400)
}

fn altered(how: impl Fn(&Row) -> Row) -> Vec<Row> {
    good().iter().map(how).collect()
}

fn named(rows: &[Row], names: &str) -> String {
    csv(rows).replace("t,qw,qx,qy,qz,wx,wy,wz", names)
}

fn sound(verdict: &Verdict) {
    assert_eq!(verdict.outcome, Outcome::Passed, "{verdict}");
    assert_eq!((&verdict.file_mistakes[..], &verdict.record.ignored[..]), (&[][..], &[][..]), "{verdict}");
}

#[test]
fn the_names_that_engines_use_are_read() {
    for names in [
        "timestamp,q0,q1,q2,q3,ang_vel_x,ang_vel_y,ang_vel_z",
        "t_s,quat_w,quat_x,quat_y,quat_z,angvel_x,angvel_y,angvel_z",
        "time_s,orientation_w,orientation_x,orientation_y,orientation_z,p,q,r",
        "t,rot_w,rot_x,rot_y,rot_z,omega_body_x,omega_body_y,omega_body_z",
        "t,qw,qi,qj,qk,angular_velocity_x,angular_velocity_y,angular_velocity_z",
    ] {
        sound(&judged(&named(&good(), names)));
    }
}

#[test]
fn the_units_that_names_tell_are_honoured() {
    let each = |unit: &str| format!("t,qw,qx,qy,qz,wx [{unit}],wy [{unit}],wz [{unit}]");
    for (unit, size) in [("deg/s", 180.0), ("°/s", 180.0), ("dps", 180.0), ("rpm", 30.0), ("rev/s", 0.5)] {
        let rows = altered(|(t, q, w)| (*t, *q, w * (size / std::f64::consts::PI)));
        sound(&judged(&named(&rows, &each(unit))));
    }
    let rows = altered(|(t, q, w)| (t * 1e3, *q, *w));
    sound(&judged(&named(&rows, "t [ms],qw,qx,qy,qz,wx,wy,wz")));
    sound(&judged(&named(&rows, "time_ms,qw,qx,qy,qz,wx,wy,wz")));
    let mixed = error(named(&good(), "t,qw,qx,qy,qz,wx [deg/s],wy [deg/s],wz [rad/s]"));
    assert!(mixed.contains("`wz [rad/s]` is not in the unit of `wx [deg/s]`"), "{mixed}");
    assert!(error(named(&good(), &each("furlong"))).contains("the unit of `wx [furlong]` is not known"));
    assert!(error(named(&good(), "t [weeks],qw,qx,qy,qz,wx,wy,wz")).contains("the unit of `t [weeks]`"));
}

#[test]
fn spin_and_time_both_in_units_of_their_own_are_named() {
    let rows = altered(|(t, q, w)| (t * 1e3, *q, w.map(f64::to_degrees)));
    let verdict = judged(&csv(&rows));
    assert_eq!(verdict.outcome, Outcome::Failed);
    assert_eq!(verdict.file_mistakes, [FileMistake::Degrees, FileMistake::Milliseconds], "{verdict}");
    // Times a hundred times too long are in no unit.
    let verdict = judged(&csv(&altered(|(t, q, w)| (t * 100.0, *q, *w))));
    assert_eq!(verdict.outcome, Outcome::Failed, "{verdict}");
    let [FileMistake::Times(times)] = verdict.file_mistakes[..] else { panic!("{verdict}") };
    assert!((times - 0.01).abs() < 1e-4, "{verdict}");
}

#[test]
fn columns_that_are_not_read_are_listed() {
    let verdict = judged(&named(&good(), "t,qw,qx,qy,qz,foo_x,foo_y,foo_z"));
    assert_eq!(verdict.record.ignored, ["foo_x", "foo_y", "foo_z"]);
    assert!(verdict.to_string().contains("Ignored: the columns foo_x, foo_y, foo_z"), "{verdict}");
    assert_eq!(verdict.json()["ignored"][2], "foo_z");
}

#[test]
fn times_of_few_digits_are_taken_for_the_steps_that_they_are_rounded_from() {
    let text = |head: &str, time: &dyn Fn(f64) -> String| {
        written(&format!("# inertia: 1 2 2.5\n{head}"), &good(), time, |x| format!("{x:.16e}"))
    };
    let fixed = |decimals: usize, head: &str| text(head, &|t| format!("{t:.decimals$}"));
    let heads = [(3, "# dt: 1/60 s"), (2, "# dt: 1/60 s"), (2, "# dt: 16.666666666666667 ms"), (3, "")];
    let all = heads.map(|(decimals, head)| fixed(decimals, head));
    // With a fixed number of significant digits, zeros at the end left off: later times are coarser.
    let short = |digits: usize, t: f64| format!("{t:.*e}", digits - 1).parse::<f64>().unwrap().to_string();
    let coarser = [4, 5, 6].map(|digits| text("# dt: 1/60 s", &|t| short(digits, t)));
    for text in all.iter().chain(&coarser) {
        let verdict = judged(text);
        assert_eq!((verdict.outcome, verdict.record.gaps), (Outcome::Passed, None), "{verdict}");
        assert_eq!(verdict.diagnosis.as_ref().unwrap().best.rule, tumbling_judge::Rule::EXACT, "{verdict}");
        assert!(verdict.laws.iter().all(|law| law.growth.rank() == 0), "{verdict}");
        assert!(verdict.record.notes.iter().any(|note| note.to_string().contains("few digits")), "{verdict}");
    }
    // A step that does not explain the times is not used.
    let verdict = judged(&fixed(3, "# dt: 1/50 s"));
    assert!(verdict.to_string().contains("that is their mean"), "{verdict}");
}

#[test]
fn a_comment_that_denies_a_torque_makes_none_and_one_that_is_not_understood_is_noted() {
    let with = |comment: &str| judged(&format!("# {comment}\n{}", csv(&good())));
    assert_eq!(with("no torque: 1 2 3").torque, None);
    let given = " (4 runs): 1 2 3| (world, on the body): 1 2 3| 1 2 3; body: a| 1 2 3 (rigid body)| on the body: 1 2 3| on the body in space axes: 1 2 3|\
                 \x20in world axes (N m): 1 2 3| vector: 1 2 3| in space axes: 1 2 3| 1 2 3; moments about principal axes|\
                 s: 1 2 3|: 1 2 3; the body is a box|: 1 2 3 about the centre of the body|\
                 : 1 2 3 applied to the body in the inertial frame";
    for said in given.split('|') {
        assert_eq!(with(&format!("torque{said}")).torque, Some(Vector3::new(1.0, 2.0, 3.0)), "{said}");
    }
    assert_eq!(with("tau: 1 2 3").torque, Some(Vector3::new(1.0, 2.0, 3.0)));
    for said in " unknown|: off (body since 2024)|: none since t=0|: so, v2| 2 on the rigid body".split('|') {
        assert!(with(&format!("torque{said}")).record.notes[0].to_string().contains("mentions `torque`"));
    }
    let (header, count) = ("# step size 1/60\n# inertia: 1 2 2.5", |t| format!("{:.0}", t / H));
    let steps = written(header, &good(), count, |x| format!("{x:.16e}"));
    let verdict = judged(&steps.replacen("t,qw,qx,qy,qz", "step,a,b,c,d", 1));
    assert!((verdict.record.step.unwrap() - H).abs() < 1e-15, "{verdict}");
    assert_eq!(verdict.outcome, Outcome::Passed, "{verdict}");
}

#[test]
fn a_plate_whose_rounded_moments_miss_by_a_digit_is_judged_as_flat_and_said_to_be() {
    let text = |moments: &str| csv(&good()).replace("1 2 2.5", moments);
    let verdict = judged(&text("0.333 0.333 0.667"));
    assert_eq!(verdict.moments, Vector3::new(0.333, 0.333, 0.666));
    assert!(verdict.record.notes[0].to_string().contains("printed as 0.667"), "{verdict}");
    assert_eq!(judged(&text("0.33333334 0.33333334 0.6666667")).record.notes.len(), 1);
    assert!(judge(text("0.333 0.333 0.67").as_bytes(), &Options::default()).is_err());
}

#[test]
fn a_momentum_under_the_names_of_a_spin_is_named() {
    let body = altered(|(t, q, w)| (*t, *q, MOMENTS.component_mul(w)));
    let verdict = judged(&csv(&body));
    assert_eq!(verdict.file_mistakes, [FileMistake::Momentum], "{verdict}");
    let world = altered(|(t, q, w)| (*t, *q, rotation_matrix(q) * MOMENTS.component_mul(w)));
    let verdict = judged(&csv(&world));
    assert_eq!(verdict.file_mistakes, [FileMistake::Frame, FileMistake::Momentum], "{verdict}");
    assert_eq!(verdict.diagnosis.unwrap().best.rule, tumbling_judge::Rule::EXACT);
}

#[test]
fn an_inverse_of_the_common_order_is_named_by_the_common_names() {
    let inverse = |(t, q, w): Row| (t, Quaternion::new(-q.i, -q.j, -q.k, q.w), w);
    let rows = stepped(Method::ImplicitMidpoint, SPIN, H, 400).into_iter().map(inverse);
    let verdict = judged(&csv(&rows.collect::<Vec<_>>()));
    assert_eq!(verdict.file_mistakes, [FileMistake::Order, FileMistake::Inverse], "{verdict}");
    assert!(verdict.to_string().contains("The rule is sound; what fails is listed under Why"), "{verdict}");
}

#[test]
fn moments_in_another_unit_are_read_and_an_unknown_one_is_refused() {
    let judged = |unit: &str| {
        let rows = (0..5).map(|i| format!("{i},0.1,2,0.3\n")).collect::<String>();
        let text = format!("# inertia: 210 340 470 {unit}\nt,wx,wy,wz\n{rows}");
        judge(text.as_bytes(), &Options::default()).map(|verdict| verdict.moments)
    };
    for (unit, factor) in [
        ("", 1.0),
        ("kg m2", 1.0),
        ("kg·m²", 1.0),
        ("kg*m^2 about the principal axes", 1.0),
        ("g cm2", 1e-7),
        ("kg cm^2", 1e-4),
        ("about x, y and z", 1.0),
    ] {
        let moments = judged(unit).unwrap();
        assert!((moments / factor - nalgebra::Vector3::new(210.0, 340.0, 470.0)).norm() < 1e-9, "{unit}");
    }
    let wrong = judged("lb ft2").unwrap_err().to_string();
    assert!(wrong.contains("line 1: the unit `lb ft2` is not known here"), "{wrong}");
}

#[test]
fn a_number_of_a_rule_has_five_digits_and_a_power_of_ten_where_it_is_very_small_or_large() {
    for (mass, wanted) in [
        (0.999_999_4, "1.0000"),
        (12.345_67, "12.346"),
        (-9.999_96e-4, "-0.0010000"),
        (9.999_96e-5, "0.00010000"),
        (9.9e-5, "9.9000e-5"),
        (123_456.7, "123457"),
        (2.5e9, "2.5000e9"),
        (0.0, "0"),
    ] {
        let name = tumbling_judge::Base::MomentumForSpin(mass).name();
        assert_eq!(name, format!("momentum taken for spin (divided by {wanted})"));
    }
}
