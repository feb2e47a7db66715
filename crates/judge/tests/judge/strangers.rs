//! Rules that the judge does not know: whatever their spin, step, precision and columns, no rule is named for
//! theirs, but the exact motion where they are exact to rounding.

use crate::common::{MOMENTS, Row};
use nalgebra::{Quaternion, Vector3};
use std::fmt::Write as _;
use tumbling::attitude::{product, turn};
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::exact::FreeMotion;
use tumbling_judge::{Confidence, Options, Rule, Verdict, judge};

type Step = fn(&Quaternion<f64>, &Vector3<f64>, f64) -> (Quaternion<f64>, Vector3<f64>);

fn rate(omega: &Vector3<f64>) -> Vector3<f64> {
    angular_acceleration(&MOMENTS, omega, &Vector3::zeros())
}

/// Heun's second order for the spin, and the turn of the mean of the old spin and the new.
fn heun(q: &Quaternion<f64>, omega: &Vector3<f64>, h: f64) -> (Quaternion<f64>, Vector3<f64>) {
    let first = rate(omega);
    let end = omega + (first + rate(&(omega + first * h))) * (h / 2.0);
    (product(q, &turn(&((omega + end) * (h / 2.0)))), end)
}

/// Kutta's third order for the spin, and the turn of the new spin.
fn kutta(q: &Quaternion<f64>, omega: &Vector3<f64>, h: f64) -> (Quaternion<f64>, Vector3<f64>) {
    let a = rate(omega);
    let b = rate(&(omega + a * (h / 2.0)));
    let c = rate(&(omega + (b * 2.0 - a) * h));
    let end = omega + (a + b * 4.0 + c) * (h / 6.0);
    (product(q, &turn(&(end * h))), end)
}

/// The exact spin, and the turn of the new spin.
fn turned_by_the_new_spin(
    q: &Quaternion<f64>,
    omega: &Vector3<f64>,
    h: f64,
) -> (Quaternion<f64>, Vector3<f64>) {
    let end = FreeMotion::new(MOMENTS.try_into().unwrap(), omega).unwrap().omega(h).unwrap();
    (product(q, &turn(&(end * h))), end)
}

/// The implicit midpoint rule after two rounds of its iteration.
fn two_rounds(q: &Quaternion<f64>, omega: &Vector3<f64>, h: f64) -> (Quaternion<f64>, Vector3<f64>) {
    let mut end = *omega;
    for _ in 0..2 {
        end = omega + rate(&((omega + end) / 2.0)) * h;
    }
    (product(q, &turn(&((omega + end) * (h / 2.0)))), end)
}

fn run(step: Step, speed: f64, h: f64, single: bool) -> Vec<Row> {
    let round = |x: f64| if single { f64::from(x as f32) } else { x };
    let mut omega = (Vector3::new(1.0, 2.0, 1.5).normalize() * speed).map(round);
    let mut q = Quaternion::from_vector(turn(&Vector3::new(0.4, -0.3, 1.1)).coords.map(round));
    let mut rows = Vec::new();
    for i in 0..120 {
        rows.push((h * f64::from(i), q, omega));
        let end = step(&q, &omega, h);
        (q, omega) = (Quaternion::from_vector(end.0.coords.map(round)), end.1.map(round));
    }
    rows
}

fn verdict(rows: &[Row], attitude: bool) -> Verdict {
    let mut text = String::from("# inertia: 1 2 2.5\n");
    text += if attitude { "t,qw,qx,qy,qz,wx,wy,wz\n" } else { "t,wx,wy,wz\n" };
    for (t, q, w) in rows {
        write!(text, "{t:?}").unwrap();
        let numbers = [q.w, q.i, q.j, q.k, w.x, w.y, w.z];
        numbers[if attitude { 0 } else { 4 }..].iter().for_each(|x| write!(text, ",{x:.16e}").unwrap());
        text.push('\n');
    }
    judge(text.as_bytes(), &Options::default()).unwrap()
}

#[test]
fn a_rule_that_is_not_known_is_named_as_no_other() {
    let rules: [(&str, Step); 4] = [
        ("Heun", heun),
        ("Kutta", kutta),
        ("turned by the new spin", turned_by_the_new_spin),
        ("two rounds", two_rounds),
    ];
    let (mut silent, mut wrong) = (0, Vec::new());
    for (name, step) in rules {
        for speed in [0.2, 0.7, 2.0] {
            for h in [1.0 / 60.0, 1.0 / 1000.0] {
                for (single, attitude) in [(false, false), (false, true), (true, false), (true, true)] {
                    let verdict = verdict(&run(step, speed, h, single), attitude);
                    let Some(diagnosis) = verdict.diagnosis else { continue };
                    let sure = matches!(diagnosis.confidence, Confidence::ToRounding | Confidence::MostSteps);
                    if sure && diagnosis.best.rule != Rule::EXACT {
                        wrong.push(format!("{name} {speed} {h} {single} {attitude}: {diagnosis}"));
                    }
                    silent += u32::from(!sure);
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(silent > 40, "{silent}");
}
