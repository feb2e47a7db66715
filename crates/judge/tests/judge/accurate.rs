//! Rules that are none of those known: which are accurate, and which are not.

use crate::common::{MOMENTS, judged, spins};
use nalgebra::Vector3;
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::exact::FreeMotion;
use tumbling_judge::{Confidence, Outcome, Verdict};

type Spin = Vector3<f64>;
/// A step of the spin in this number of seconds.
type Step = fn(Spin, f64) -> Spin;

fn rate(omega: &Spin) -> Spin {
    angular_acceleration(&MOMENTS, omega, &Vector3::zeros())
}

/// An explicit Runge-Kutta step with this tableau; its last stage may be that of an embedded rule.
fn explicit(stages: &[&[f64]], weights: &[f64], omega: Spin, h: f64, rate: impl Fn(&Spin) -> Spin) -> Spin {
    let mut rates = Vec::new();
    for stage in stages {
        let at = stage.iter().zip(&rates).fold(omega, |at, (share, rate)| at + rate * (h * share));
        rates.push(rate(&at));
    }
    weights.iter().zip(&rates).fold(omega, |end, (share, rate)| end + rate * (h * share))
}

const THIRD: f64 = 1.0 / 3.0;
const EIGHTHS: [&[f64]; 4] = [&[], &[THIRD], &[-THIRD, 1.0], &[1.0, -1.0, 1.0]];
const OF_EIGHTHS: [f64; 4] = [0.125, 0.375, 0.375, 0.125];

fn eighths(omega: Spin, h: f64) -> Spin {
    explicit(&EIGHTHS, &OF_EIGHTHS, omega, h, rate)
}

/// Bogacki and Shampine's rule in steps that keep the error of each below this share of the spin.
fn controlled(omega: Spin, h: f64, tolerance: f64) -> Spin {
    let stages: [&[f64]; 4] = [&[], &[0.5], &[0.0, 0.75], &[2.0 / 9.0, THIRD, 4.0 / 9.0]];
    let (mut omega, mut left, mut part) = (omega, h, h);
    while left > 1e-12 * h {
        let taken = left.min(part);
        let end = explicit(&stages, &[2.0 / 9.0, THIRD, 4.0 / 9.0, 0.0], omega, taken, rate);
        let less = explicit(&stages, &[7.0 / 24.0, 0.25, THIRD, 0.125], omega, taken, rate);
        let error = (end - less).norm() / omega.norm() / tolerance;
        if error <= 1.0 {
            (omega, left) = (end, left - taken);
        }
        part = taken * (0.9 / error.cbrt()).clamp(0.2, 3.0);
    }
    omega
}

/// Accurate steps of another law: the term multiplied by a number, and a drag that grows with the speed.
fn altered(omega: Spin, h: f64, term: f64, drag: f64) -> Spin {
    (0..8).fold(omega, |omega, _| {
        explicit(&EIGHTHS, &OF_EIGHTHS, omega, h / 8.0, |w| rate(w) * term - w * (drag * w.norm()))
    })
}

const ACCURATE: [(&str, Step); 4] = [
    ("3/8 rule", eighths),
    ("tolerance 1e-4", |w, h| controlled(w, h, 1e-4)),
    ("tolerance 1e-6", |w, h| controlled(w, h, 1e-6)),
    ("tolerance 1e-9", |w, h| controlled(w, h, 1e-9)),
];

const FALSE: [(&str, Step); 5] = [
    ("term times 1.005", |w, h| altered(w, h, 1.005, 0.0)),
    ("term times -1", |w, h| altered(w, h, -1.0, 0.0)),
    ("drag 0.001", |w, h| altered(w, h, 1.0, 0.001)),
    ("explicit, 1 % of drag", |w, h| w + rate(&w) * h - w * (0.01 * h * w.norm())),
    ("explicit, half of the term", |w, h| w + rate(&w) * (0.5 * h)),
];

const STARTS: [Spin; 3] =
    [Vector3::new(0.05, 5.0, 0.1), Vector3::new(1.0, 3.0, 1.5), Vector3::new(0.3, 0.2, 4.0)];

/// The error of the middle step, as a share of what the exact motion changes in the middle step; and the
/// verdict on spins written in a unit of which this many are a radian a second.
fn tried(step: Step, omega: Spin, h: f64, unit: f64) -> (f64, Verdict) {
    let (mut now, mut rows) = (omega, Vec::new());
    let (mut errors, mut changes) = (Vec::new(), Vec::new());
    for i in 0..=600 {
        rows.push((h * f64::from(i), now * unit));
        let exact = FreeMotion::new(MOMENTS.try_into().unwrap(), &now).unwrap().omega(h).unwrap();
        let end = step(now, h);
        errors.push((end - exact).norm() / now.norm());
        changes.push((exact - now).norm() / now.norm());
        now = end;
    }
    let middle = |mut all: Vec<f64>| {
        all.sort_by(f64::total_cmp);
        all[all.len() / 2]
    };
    (middle(errors) / middle(changes), judged(&spins("# inertia: 1 2 2.5", rows)))
}

#[test]
fn a_rule_is_accurate_by_what_its_steps_leave_of_the_gyroscopic_term_and_never_beside_a_failure() {
    for (rules, accurate) in [(&ACCURATE[..], true), (&FALSE[..], false)] {
        for (name, step) in rules {
            for omega in STARTS {
                for h in [0.01, 0.05] {
                    let (share, verdict) = tried(*step, omega, h, 1.0);
                    let what = format!("{name}, {omega:?}, {h}, {share:.1e}\n{verdict}");
                    let confidence = verdict.diagnosis.as_ref().unwrap().confidence;
                    let praised = confidence == Confidence::Accurate;
                    assert!(!praised || share < 1e-4 && verdict.outcome != Outcome::Failed, "{what}");
                    assert!(!accurate || praised && share < 8e-5, "{what}");
                    if accurate {
                        let said = tried(*step, omega, h, 1f64.to_degrees()).1.to_string();
                        let is_sound = said.contains("in degrees a second") && said.contains("is sound");
                        assert!(is_sound, "{said}");
                    }
                    assert!(accurate || share > 3e-3, "{what}");
                    assert!(!verdict.to_string().contains("Nothing to do") || share > 1.9, "{what}");
                }
            }
        }
    }
}
