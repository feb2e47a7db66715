//! Rules written out here, by nothing of the library's steps: the judge has to name them.

use crate::common::{self, judged};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use tumbling::step::{Engine, Method};
use tumbling::{Body, Inertia};
use tumbling_judge::{Confidence, Outcome};

const MOMENTS: [f64; 3] = [1.0, 2.0, 2.7];
const H: f64 = 1.0 / 60.0;

type State = (UnitQuaternion<f64>, Vector3<f64>);
/// A rule, whether its attitudes are written too, and what it may be called.
type Case<'a> = (fn(&State) -> State, bool, &'a [Method]);

fn tensor() -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::from(MOMENTS))
}

/// `J (-w x I w)` in the axes that the tensor is given in.
fn acceleration(w: &Vector3<f64>) -> Vector3<f64> {
    let [a, b, c] = MOMENTS;
    Vector3::new((b - c) * w.y * w.z / a, (c - a) * w.z * w.x / b, (a - b) * w.x * w.y / c)
}

fn turned(q: &UnitQuaternion<f64>, w: &Vector3<f64>) -> UnitQuaternion<f64> {
    q * UnitQuaternion::from_scaled_axis(w * H)
}

fn explicit((q, w): &State) -> State {
    let w = w + acceleration(w) * H;
    (turned(q, &w), w)
}

fn without_term((q, w): &State) -> State {
    (turned(q, w), *w)
}

fn one_newton((q, w): &State) -> State {
    let moment = tensor() * w;
    let jacobian = tensor() + (w.cross_matrix() * tensor() - moment.cross_matrix()) * H;
    let w = w - jacobian.try_inverse().unwrap() * w.cross(&moment) * H;
    (turned(q, &w), w)
}

fn start() -> State {
    (UnitQuaternion::from_quaternion(Quaternion::new(0.8, 0.2, -0.4, 0.4)), Vector3::new(1.0, 2.0, 1.5))
}

fn written(rows: impl Iterator<Item = (f64, State)>, attitude: bool) -> String {
    let rows: Vec<_> = rows.map(|(t, (q, w))| (t, q.into_inner(), w)).collect();
    let text = common::written("# inertia: 1 2 2.7", &rows, |t| t.to_string(), |x| x.to_string());
    if attitude { text } else { text.replacen("qw,qx,qy,qz", "a,b,c,d", 1) }
}

fn run(rule: fn(&State) -> State, from: State) -> impl Iterator<Item = (f64, State)> {
    let states = std::iter::successors(Some(from), move |state| Some(rule(state)));
    states.take(300).enumerate().map(|(i, state)| (H * i as f64, state))
}

#[test]
fn rules_written_out_by_hand_are_the_best_and_to_rounding() {
    // Spins alone for the first: how the attitude is turned is its own question.
    let cases: [Case<'_>; 3] = [
        (explicit, false, &[Method::SemiImplicitEuler, Method::ExplicitEuler]),
        (one_newton, true, &[Method::ImplicitOneNewton, Method::LinearisedImplicit]),
        (without_term, true, &[Method::ConstantSpin]),
    ];
    for (rule, attitude, methods) in cases {
        let verdict = judged(&written(run(rule, start()), attitude));
        assert_eq!((verdict.outcome, &verdict.file_mistakes[..]), (Outcome::Failed, &[][..]), "{verdict}");
        let diagnosis = verdict.diagnosis.as_ref().unwrap();
        assert_eq!(diagnosis.confidence, Confidence::ToRounding, "{diagnosis}");
        let (method, parts) = diagnosis.best.rule.method().unwrap();
        assert!(methods.contains(&method) && parts == 1, "{diagnosis}");
    }
}

/// The first pitfall: the tensor of the body in the equation of the world.
#[test]
fn the_tensor_that_never_turned_is_named_whatever_steps_it() {
    let [a, b, c] = MOMENTS;
    let (q, w) = start();
    let mut body = Body::spinning(Inertia::from_moments(a, b, c).unwrap(), q, &w).unwrap();
    let mut rows = vec![(0.0, (q, w))];
    for i in 1..300 {
        body = Engine::Frozen.run(&body, H, 1).unwrap()[1];
        rows.push((H * f64::from(i), (body.attitude(), body.omega_body())));
    }
    let verdict = judged(&written(rows.into_iter(), true));
    let said = verdict.to_string();
    assert!(verdict.outcome == Outcome::Failed && said.contains("a tensor frozen in the world"), "{said}");
}

#[test]
fn a_slow_body_put_back_to_its_start_is_seen() {
    // A fine step of the law, so that nothing but the reset is off.
    let fine = |state: &State| -> State {
        (0..20).fold(*state, |(q, w), _| {
            let h = H / 20.0;
            let middle = w + acceleration(&w) * (h / 2.0);
            (q * UnitQuaternion::from_scaled_axis(middle * h), w + acceleration(&middle) * h)
        })
    };
    for attitude in [true, false] {
        let rows: Vec<(f64, State)> = run(fine, (start().0, Vector3::new(0.04, 0.07, 0.05))).collect();
        let twice = rows[..200].iter().chain(&rows[..100]).enumerate().map(|(i, row)| (H * i as f64, row.1));
        let verdict = judged(&written(twice, attitude));
        assert_eq!(verdict.resets.len(), 1, "{verdict}");
        // Two lines above the rows.
        assert_eq!(verdict.resets[0].line, 203, "{verdict}");
        assert_eq!(verdict.outcome, Outcome::Failed);
    }
    // A spin that stays is back at its start in each row, also where rows are missing.
    let rows: Vec<(f64, State)> = run(without_term, start()).collect();
    let verdict = judged(&written([&rows[..100], &rows[106..]].concat().into_iter(), false));
    assert!(verdict.resets.is_empty(), "{verdict}");
}
