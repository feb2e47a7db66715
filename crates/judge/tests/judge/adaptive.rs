//! Rules that are none of those known, and steps whose lengths are chosen by their errors.

use crate::common::{MOMENTS, Row, csv, judged};
use nalgebra::{Quaternion, SVector, Vector3};
use tumbling::attitude::product;
use tumbling::dynamics::euler::angular_acceleration;
use tumbling_judge::Confidence;

type State = SVector<f64, 7>;

fn rate(state: &State) -> State {
    let q = Quaternion::new(state[0], state[1], state[2], state[3]);
    let w = Vector3::new(state[4], state[5], state[6]);
    let turn = product(&q, &Quaternion::from_imag(w / 2.0));
    let spin = angular_acceleration(&MOMENTS, &w, &Vector3::zeros());
    State::from([turn.w, turn.i, turn.j, turn.k, spin.x, spin.y, spin.z])
}

/// Bogacki and Shampine's step of order 3, and its error.
fn third_order(x: &State, h: f64) -> (State, f64) {
    let k1 = rate(x);
    let k2 = rate(&(x + k1 * (h / 2.0)));
    let k3 = rate(&(x + k2 * (0.75 * h)));
    let end = x + (k1 * 2.0 + k2 * 3.0 + k3 * 4.0) * (h / 9.0);
    let k4 = rate(&end);
    let second = x + (k1 * 7.0 + k2 * 6.0 + k3 * 8.0 + k4 * 3.0) * (h / 24.0);
    (end, (end - second).norm())
}

/// Rows of that rule: in steps of one length, or in steps that keep the error of each below a tolerance, the
/// last before each row shortened to end there.
fn rows(omega: Vector3<f64>, apart: f64, count: u32, tolerance: Option<f64>) -> Vec<Row> {
    let mut x = State::from([1.0, 0.0, 0.0, 0.0, omega.x, omega.y, omega.z]);
    let (mut rows, mut h) = (Vec::new(), apart);
    for i in 0..=count {
        let q = Quaternion::new(x[0], x[1], x[2], x[3]);
        rows.push((apart * f64::from(i), q, Vector3::new(x[4], x[5], x[6])));
        let mut left = apart;
        while left > 0.0 {
            let taken = if tolerance.is_some() { h.min(left) } else { apart };
            let (end, error) = third_order(&x, taken);
            let allowed = tolerance.unwrap_or(f64::INFINITY);
            if error <= allowed {
                x = end;
                left -= taken;
                left = if left < 1e-12 { 0.0 } else { left };
            }
            if error > allowed || taken == h {
                h = taken * (0.9 * (allowed / error).cbrt()).clamp(0.2, 3.0);
            }
        }
    }
    rows
}

/// The spins of an explicit rule with this tableau, in steps of one length.
fn explicit(stages: &[&[f64]], weights: &[f64], omega: Vector3<f64>, h: f64, count: u32) -> String {
    let mut text = String::from("# inertia: 1 2 2.5\nt,wx,wy,wz\n");
    let mut w = omega;
    for i in 0..=count {
        text += &format!("{:e},{:e},{:e},{:e}\n", h * f64::from(i), w.x, w.y, w.z);
        let mut rates = Vec::new();
        for stage in stages {
            let at = stage.iter().zip(&rates).fold(w, |at, (share, rate)| at + rate * (h * share));
            rates.push(angular_acceleration(&MOMENTS, &at, &Vector3::zeros()));
        }
        w = weights.iter().zip(&rates).fold(w, |end, (share, rate)| end + rate * (h * share));
    }
    text
}

#[test]
fn the_order_of_a_rule_that_is_none_of_those_known_shows_in_its_errors() {
    let third = 1.0 / 3.0;
    let heun: (&[&[f64]], &[f64]) = (&[&[], &[1.0]], &[0.5, 0.5]);
    let kutta: (&[&[f64]], &[f64]) = (&[&[], &[0.5], &[-1.0, 2.0]], &[0.5 * third, 2.0 * third, 0.5 * third]);
    let eighths: (&[&[f64]], &[f64]) =
        (&[&[], &[third], &[-third, 1.0], &[1.0, -1.0, 1.0]], &[0.125, 0.375, 0.375, 0.125]);
    for (order, (stages, weights)) in [(2, heun), (3, kutta), (4, eighths)] {
        for omega in [Vector3::new(0.05, 5.0, 0.1), Vector3::new(1.0, 3.0, 1.5)] {
            let verdict = judged(&explicit(stages, weights, omega, 0.01, 2000));
            let diagnosis = verdict.diagnosis.as_ref().unwrap();
            assert_eq!(diagnosis.confidence, Confidence::Accurate, "{verdict}");
            let accuracy = diagnosis.accuracy.unwrap();
            assert_eq!((accuracy.order, accuracy.controlled), (Some(order), false), "{verdict}");
            assert!(verdict.to_string().contains(&format!("order about {order}")), "{verdict}");
        }
    }
}

#[test]
fn steps_chosen_by_their_errors_are_known_as_such_and_not_taken_for_the_exact_motion() {
    for tolerance in [1e-3, 1e-5, 1e-8] {
        let verdict = judged(&csv(&rows(Vector3::new(0.05, 5.0, 0.1), 0.1, 600, Some(tolerance))));
        let diagnosis = verdict.diagnosis.as_ref().unwrap();
        assert_eq!(diagnosis.confidence, Confidence::Accurate, "{tolerance}\n{verdict}");
        let accuracy = diagnosis.accuracy.unwrap();
        assert!(accuracy.controlled, "{tolerance}\n{verdict}");
        assert!(accuracy.per_second < tolerance, "{tolerance}\n{verdict}");
        assert!(!verdict.to_string().contains("Nothing to do"), "{verdict}");
    }
    // Steps of one length, as long as the rows are apart.
    let verdict = judged(&csv(&rows(Vector3::new(0.05, 5.0, 0.1), 1.0 / 60.0, 1200, None)));
    assert_eq!(verdict.diagnosis.unwrap().accuracy.unwrap().order, Some(3));
}
