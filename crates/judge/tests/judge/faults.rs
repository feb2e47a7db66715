//! Hits on the way, and a header in other words. (Other faults are the invented records'.)

use crate::common::{MOMENTS, Row, csv, exact, judged, stepped};
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::attitude::{product, rotation_matrix, turn};
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::step::Method;
use tumbling_judge::{Options, judge};

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
    let said = verdict.to_string();
    assert!(said.contains("jumps (3 of 600 steps tried) all agree to rounding with: the exact"), "{said}");
}

#[test]
fn damping_is_named_between_hits() {
    // No term: the spin of the body shrinks, and a hit is far more than that.
    let (mut rows, mut spin): (Vec<Row>, _) = (exact(SPIN, H, 0), SPIN);
    for i in 1..300 {
        let hit = if i % 97 == 0 { Vector3::new(0.3, -0.2, 0.5) } else { Vector3::zeros() };
        spin = spin * (1.0 - 0.3 * H) + hit;
        rows.push((H * f64::from(i), product(&rows[rows.len() - 1].1, &turn(&(spin * H))), spin));
    }
    let found = judged(&csv(&rows)).diagnosis.unwrap();
    let name = found.best.rule.name();
    assert!(name.starts_with("damping left on (0.3/s") && name.ends_with("no gyroscopic term"), "{found}");
    assert_eq!(found.jumps.len(), 3, "{found}");
}

#[test]
fn a_wrong_gyroscopic_term_is_named_under_strong_damping_too() {
    for (rate, term, words) in [(5.0, 0.5, "half of the gyroscopic term"), (0.5, -1.0, "with the wrong sign")]
    {
        let mut rows: Vec<Row> = exact(SPIN, H, 0);
        for i in 1..300 {
            let (_, q, spin) = rows[rows.len() - 1];
            let change = angular_acceleration(&MOMENTS, &spin, &Vector3::zeros()) * (term * H);
            let spin = (spin + change) * (1.0 - rate * H);
            rows.push((H * f64::from(i), product(&q, &turn(&(spin * H))), spin));
        }
        let found = judged(&csv(&rows)).diagnosis.unwrap();
        let name = found.best.rule.name();
        assert!(name.starts_with(&format!("damping left on ({rate}/s")) && name.contains(words), "{found}");
        let advised = |words: &str| found.advice.iter().any(|advice| advice.words.contains(words));
        assert!(advised("angular damping to 0") && advised("is not that of the body"), "{found}");
    }
}

#[test]
fn a_tensor_frozen_where_the_body_started_is_named_under_damping_too() {
    let first = UnitQuaternion::from_euler_angles(0.4, -0.3, 1.1);
    let (mut rows, mut q, mut world) = (Vec::<Row>::new(), first.into_inner(), first * SPIN);
    for i in 0..400 {
        rows.push((H * f64::from(i), q, rotation_matrix(&q).tr_mul(&world)));
        // In the world, by the tensor as it stood at the first attitude.
        let rate = first * angular_acceleration(&MOMENTS, &(first.inverse() * world), &Vector3::zeros());
        world = (world + rate * H) * (1.0 - 0.2 * H);
        q = product(&turn(&(world * H)), &q);
    }
    let name = judged(&csv(&rows)).diagnosis.unwrap().best.rule.name();
    let frozen = name.ends_with("a tensor frozen in the world");
    assert!(name.starts_with("damping left on (0.2/s") && frozen, "{name}");
}

const GIVEN: &str = "torque: x=0 y=0 z=1|torque: Mz = 0.1|torque: constant, 0.1 N m|torque about z: 0 0 1";
const IN_BODY: &str = "torque (body): 0 0 1|torque: 0 0 1 in the body frame; world: y up|torque: 0 0 1; in body axes|\
     torque: body-fixed 0 0 1|torque [body]: 0 0 1|torque (N m, body): 0 0 1|torque: 0 0 1, on the body's axes|\
     body torque: 0 0 1|torque in body axes: 0 0 1|torque: body 0 0 1|torque: [0; 0; 1] in the frame of the body|\
     torque (local): 0 0 1|torque (principal axes): 0 0 1|torque, local frame: 0 0 1|torque in rotating axes: 0 0 1";

#[test]
fn a_tensor_may_be_written_in_six_or_nine_numbers_and_a_step_in_place_of_times() {
    let text = csv(&stepped(Method::ConstantSpin, SPIN, H, 100));
    let times = |line: &str| match line.split_once(',') {
        Some((t, rest)) if !t.starts_with('#') => format!("{rest}\n"),
        _ => format!("{line}\n"),
    };
    const UNTIMED: &str = "line 2: the column `t` is missing: add it, or a comment line `# dt: 1/60`";
    let untimed = text.lines().map(times).collect::<String>();
    let with = |inertia, comment: &str| {
        let text = text.replacen("# inertia: 1 2 2.5 kg m2", comment, 1);
        judge(text.as_bytes(), &Options { inertia, ..Options::default() }).map(|verdict| verdict.moments)
    };
    for good in [
        "# inertia: 1 0 0, 0 2 0, 0 0 2.5",
        "# inertia: 1 2 2.5 0 0 5e-9",
        "# Ixx: 1\n# Iyy: 2\n# Izz: 2.5\n# Ixy=1e-17",
        "# inertia: 1 2 2.5\n# moments: 2 contacts at t = 1\n# moments 2 3 4 are when it was hit",
        "\"# inertia: 1, 2, 2.5\",,,",
    ] {
        assert_eq!(with(None, good).unwrap(), Vector3::new(1.0, 2.0, 2.5), "{good}");
    }
    for (bad, says) in [
        ("# inertia: 1 2 2.5 0 0.1 0", "line 1: a product of inertia is 0.1, more than 1e-9 of"),
        ("# inertia: 1 2 2.5 3", "line 1: 4 numbers are given for the inertia: give the three principal"),
        ("# inertia: 2", "line 1: 1 number is given for the inertia"),
        ("# inertia: 2 boxes, 1 2 3", "line 1: 1 number is given for the inertia: give the three"),
        ("# Ixx: 1\n# Iyy: 2,5\n# Izz: 2.5", "line 2: a number has a decimal comma: write a point"),
        ("# inertia: 1 2 2.5\n# Ixy: 0,1", "line 2: a number has a decimal comma: write a point"),
        (
            "# Ixx: 1, Iyy: 2, Izz: 2.5, Ixy: 0.3",
            "line 1: a product of inertia is 0.3, more than 1e-9 of the sum of the moments, 5.5",
        ),
        ("# inertia: 1 2 2.5\n# moments: 1 2 3", "line 2: the moments differ from those in line 1"),
        ("# inertia: 1 2 2.5\n# Ixx: 1, Iyy: 2, Izz: 3", "line 2: the moments differ from those in line 1"),
        ("# Ixx: 1\n# Ixx: 1.5", "line 2: the moments differ from those in line 1"),
        ("# inertia: 1 -2 2.5", "line 1: a principal moment is -2"),
    ] {
        let error = with(None, bad).unwrap_err().to_string();
        assert!(error.starts_with(says), "{error}");
        assert!(with(Some(Vector3::new(1.0, 2.0, 2.5)), bad).is_ok(), "{bad}");
    }
    let times = "dt: 1/60|dt: 1 / 60 s|dt: 1 / 60|step: 1 / 60 (s)|timestep: 1 / 60|time step: 1 / 60|\
                 time_step: 1 / 60|step size: 1 / 60";
    for (all, says) in [
        (times, "Some(0.01666"),
        ("step 3 of the tutorial|Step 1: integrate|step: 3 of 10|step: 3 / 10", UNTIMED),
        ("dt: 1/60 Hz", "line 1: the step is given as 1/60 Hz, a fraction of a frequency: write"),
        ("dt: 1 / 2 kHz", "line 1: the step is given as 1/2 kHz, a fraction of a frequency: write"),
        ("dt: 5 ms / frame", "Some(0.005"),
        ("dt: 100Hz|dt: 0.1 kHz|dt: 100 fps|dt: 10ms", "Some(0.01"),
        ("dt: (0.5 s)|dt: 0.5 (1/2)|dt: 0.5 fixed|dt: 2 hertz", "Some(0.5)"),
        ("dt: 0 Hz", "line 1: the step is given as 0 Hz: it must be above zero"),
        ("dt: 100 MHz", "line 1: the unit `MHz` is not known: s, ms"),
        ("torque: 0,5 0 0|torque: [0,5; 0; 0] N m", "line 1: a number has a decimal comma"),
        (
            "torque: 1 2 3 4",
            "line 1: a torque has three numbers after its name, as in `torque: 0 0 0.1`, but 4",
        ),
        (GIVEN, "line 1: a torque has three numbers after its name, as in `torque: 0 0 0.1`, but 0"),
        (IN_BODY, "line 1: the torque seems to be in axes that turn with the body"),
    ] {
        for said in all.split('|') {
            let text = untimed.replacen("2.5 kg m2", &format!("2.5; {said}"), 1);
            let found = judge(text.as_bytes(), &Options::default());
            let found = found.map_or_else(|wrong| wrong.to_string(), |x| format!("{:?}", x.record.step));
            assert!(found.starts_with(says), "{said}: {found}");
        }
    }
}
