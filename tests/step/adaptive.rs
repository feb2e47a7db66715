//! Runs whose steps are chosen by their error.

use super::{adaptive, free, free_motion, start, under};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use tumbling::step::{State, Stepper, Torque};
use tumbling::{Body, ErrorKind, PrincipalMoments};

#[test]
fn the_error_of_a_controlled_run_follows_its_tolerance() {
    let (moments, omega) = (Vector3::new(5.0 / 6.0, 13.0 / 12.0, 5.0 / 12.0), Vector3::new(1.0, 0.01, 0.01));
    let system = free(moments);
    for t in [40.0, -40.0] {
        let truth = free_motion(moments, &omega).at(t).unwrap();
        let tolerances = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
        let steps = tolerances.map(|tolerance| {
            let mut left = 1_000_000;
            let end = adaptive(&system, &start(&system, &omega), t, tolerance, &mut left).unwrap();
            let off = (end.attitude.coords - truth.attitude.coords).norm();
            // Errors add up over the steps, but each is less than its estimate, which gives the next term of
            // the series; the last number is what roundings grow to in the flips.
            assert!(off < 0.8 * tolerance + 4e-11, "{tolerance:e}: {off:e}");
            1_000_000 - left
        });
        // The order increases with the number of digits, so the number of steps hardly does.
        assert!(steps[4] > steps[0] && steps[4] < 2 * steps[0], "{steps:?}");
    }
    let error = adaptive(&system, &start(&system, &omega), 40.0, 1e-17, &mut 99).unwrap_err().to_string();
    assert!(error.contains("rounding") && error.contains("1e-17"), "{error}");
}

#[test]
fn the_motion_between_the_ends_of_steps_meets_where_two_steps_meet() {
    let body = super::driven::tilted();
    // The last time in the first step of a run, to a billionth of a second, and the first in the second.
    let [mut before, mut after] = [0.01, 10.0];
    let at = |t: f64| {
        let mut stepper = Stepper::adaptive(&body, 1e-4, 100).unwrap();
        (stepper.step_to(t).unwrap(), stepper.steps_of_run())
    };
    while after - before > 1e-9 {
        let middle = 0.5 * (before + after);
        *(if at(middle).1 == 1 { &mut before } else { &mut after }) = middle;
    }
    let [(one, 1), (other, 2)] = [before, after].map(at) else { panic!("{before} {after}") };
    let apart = (one.attitude.coords - other.attitude.coords).norm();
    assert!(apart < 1e-7, "{apart:e}");
}

#[test]
fn an_adaptive_run_is_finite_or_refused_and_soon() {
    let moments = Vector3::new(1.0, 2.0, 2.5);
    let start = |l: Vector3<f64>| State { attitude: Quaternion::identity(), momentum: l };
    let lossy = |torque| under(moments, vec![torque]);
    // These gave NaN once, because an error that was NaN counted as none.
    let fast = start(Vector3::new(1.0, 1e6, 1.0));
    let refused = adaptive(&lossy(Torque::Dissipation(1.0)), &fast, 6e-3, 1e-4, &mut 1_000_000).unwrap_err();
    assert_eq!(refused.kind(), ErrorKind::TooMany, "{refused}");
    assert!(refused.to_string().contains("dissipation"), "{refused}");
    let vast = start(Vector3::new(1.0, 2.0, 3.0) * 1e203);
    assert!(adaptive(&free(moments), &vast, 1e-200, 1e-4, &mut 1_000_000).is_err());
    // Stiff, and backward in time: each took half a minute once.
    let slow = start(Vector3::new(1.0, 2.0, 3.0));
    for (torque, duration) in [(Torque::Dissipation(1e9), 1.0), (Torque::Dissipation(1e9), -1.0)] {
        let mut budget = 1_000_000;
        let run = adaptive(&lossy(torque.clone()), &slow, duration, 1e-6, &mut budget);
        assert_eq!(run.unwrap_err().kind(), ErrorKind::TooMany, "{torque:?} {duration}");
        // Detected long before the budget is used up.
        assert!(budget > 990_000, "{torque:?} {duration}: {budget} left");
    }
    // Damping accelerates the body without bound: the law is not stiff, the spin is fast, and the budget is
    // used up.
    let wound = adaptive(&lossy(Torque::Damping(moments * 1e9)), &slow, -1.0, 1e-6, &mut 20_000);
    assert_eq!(wound.unwrap_err().kind(), ErrorKind::TooMany);
}

/// A motor to and fro at 7 rad/s and a gravity gradient that turns about a leaning axis at the square root of
/// 0.5, each as far on where it begins: the angles are those at these times, modulo a turn, in 40 digits.
#[test]
fn torques_of_late_times_take_as_many_steps_as_those_of_early_ones() {
    let early = [(0.0, 0.4, 0.4), (1e3, -0.131_567_801_940_664_7, -2.990_026_782_433_847)];
    let late =
        [(1e6, 2.902_949_169_600_145, -2.989_901_864_049_72), (1e9, 2.64141734266989, -2.864_983_479_927_5)];
    // By extrapolation of the midpoint rule with 40 digits.
    let truth = Vector3::new(-0.6287245968130628, 0.8420227311316513, -0.41004911383575565);
    let steps = [early, late].concat().into_iter().map(|(from, phase, angle): (f64, f64, f64)| {
        let motor = Torque::Periodic { amplitude: Vector3::new(0.3, 0.8, -0.5), rate: 7.0, phase };
        let ahead = Vector3::new(-0.3, 0.4, 0.5) * (2.0_f64.sqrt() * angle.sin());
        let toward = Vector3::new(0.8, 0.6, 0.0) * angle.cos() + ahead;
        let pull = Torque::gravity_gradient(&toward, &Vector3::new(0.3, -0.4, 0.5));
        let both = [motor, pull].map(|torque| Torque::during(from, 2e9, torque)).into();
        let (system, mut left) = (under(Vector3::new(1.0, 2.0, 2.6), both), 200);
        let rest = start(&system, &Vector3::zeros());
        let off = adaptive(&system, &rest, from + 20.0, 1e-13, &mut left).unwrap().momentum - truth;
        assert!(off.norm() < 200.0 * 1e-13, "{from:e}: {off}");
        // One step leads to where they begin.
        200 - left - usize::from(from > 0.0)
    });
    assert!(steps.collect::<std::collections::HashSet<_>>().len() == 1, "one number of steps");
}

/// From rest about a principal axis the momentum is the motor's impulse, or what is left of it by a decay of
/// a thousandth of a second. By series, by the pair and by collocation.
#[test]
fn a_motor_keeps_its_phase_for_long_and_from_late_whatever_acts_beside_it() {
    let (nothing, damping) =
        (Torque::InBody(Vector3::zeros()), Torque::Damping(Vector3::new(2e3, 1e3, 2.6e3)));
    let function = Torque::function(|_, _, _| Vector3::zeros());
    let soon = [(&nothing, 0.0, 1e4, 40_000, 1e-12), (&function, 0.0, 1e3, 40_000, 1e-13)];
    let late = [(&function, 1e9, 20.0, 1_000, 1e-14), (&damping, 1e9, 20.0, 100, 1e-16)];
    for (other, from, time, most, bound) in [soon, late].concat() {
        // The phase is zero when the motor begins.
        let phase = if from == 0.0 { 0.0 } else { 2.24141734266989 };
        let motor = Torque::Periodic { amplitude: Vector3::z() * 0.7, rate: 7.0, phase };
        let both = [motor, other.clone()].map(|torque| Torque::during(from, 2e9, torque)).into();
        let (system, mut left) = (under(Vector3::new(1.0, 2.0, 2.6), both), most);
        let rest = start(&system, &Vector3::zeros());
        let end = adaptive(&system, &rest, from + time, 1e-13, &mut left).unwrap().momentum.z;
        let ((sine, cosine), damped) = (f64::sin_cos(7.0 * time), *other == damping);
        let truth = if damped { 0.7 * (1e3 * cosine + 7.0 * sine) / 1_000_049.0 } else { 0.1 * sine };
        assert!((end - truth).abs() < bound, "{other:?} from {from:e} s: {:e}", end - truth);
    }
}

#[test]
fn a_body_at_rest_is_set_turning_by_a_torque_that_comes_later() {
    // About a principal axis the spin is the torque's integral over the moment.
    let moments = Vector3::new(1.0, 2.0, 2.5);
    type Law = fn(f64) -> f64;
    let laws: [(Law, f64); 3] = [
        (|t| 1.0 - t.cos(), 3.0 - 3.0_f64.sin()),
        (|t| (t - 1.0).max(0.0), 2.0),
        (|t| if t < 1.0 { 0.0 } else { 1.0 }, 2.0),
    ];
    for (law, expected) in laws {
        let torque = Torque::function(move |t: f64, _, _| Vector3::y() * law(t));
        let system = under(moments, vec![torque]);
        let rest = start(&system, &Vector3::zeros());
        for tolerance in [1e-4, 1e-6, 1e-10] {
            let end = adaptive(&system, &rest, 3.0, tolerance, &mut 1_000_000).unwrap();
            assert!((end.momentum.y - expected).abs() < 100.0 * tolerance, "{tolerance:e}: {}", end.momentum);
            assert_eq!((end.momentum.x, end.momentum.z), (0.0, 0.0));
        }
    }
}

#[test]
fn the_attitude_of_an_adaptive_run_stays_a_unit_quaternion_and_its_error_within_the_tolerance() {
    let moments = PrincipalMoments::new(1.0, 2.0, 2.5).unwrap();
    let omega = Vector3::new(0.3, 1.4, 0.2);
    // Once its length fell to 0.8 in 500 s; in 1e5 s the momentum grew until no step was short enough.
    let body = Body::spinning(moments.into(), UnitQuaternion::identity(), &omega).unwrap();
    let end = Stepper::adaptive(&body, 1e-3, 1_000_000).unwrap().step(1e5).unwrap();
    let (length, momentum) = (end.attitude.norm(), end.momentum.norm() / body.momentum_world().norm());
    assert!((length - 1.0).abs() < 4.0 * f64::EPSILON, "{length}");
    assert!((momentum - 1.0).abs() < 1e-12, "{momentum}");
    // A start with another length is the same attitude; a start of length zero is none.
    let system = free(moments);
    let unit = start(&system, &omega);
    let of_length = |length: f64| State { attitude: unit.attitude * length, ..unit };
    let run = |from: &State<f64>| adaptive(&system, from, 3.0, 1e-9, &mut 1000);
    let (one, other) = (run(&unit).unwrap(), run(&of_length(1.5)).unwrap());
    assert!((one.attitude - other.attitude).norm() < 1e-14 && one.momentum == other.momentum);
    assert_eq!(run(&of_length(0.0)).unwrap_err().kind(), ErrorKind::OutOfBounds);
    // Under a steady torque about the axis of the spin the body turns by a known angle, and no step is off
    // by more than the tolerance.
    let pushed = under(moments, vec![Torque::InBody(Vector3::new(0.0, 0.0, 0.5))]);
    let from = start(&pushed, &Vector3::new(0.0, 0.0, 1.0));
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let mut left = 1_000_000;
        let end = adaptive(&pushed, &from, 20.0, tolerance, &mut left).unwrap();
        let half = 0.5 * (20.0 + 0.5 * 0.2 * 20.0 * 20.0);
        let exact = Quaternion::new(f64::cos(half), 0.0, 0.0, f64::sin(half));
        let off = (end.attitude - exact).norm();
        assert!(off < tolerance * (1_000_000 - left) as f64, "{tolerance:e}: {off:e}");
    }
}

/// Some components of the momentum are below the normal numbers within the steps.
#[test]
fn a_body_of_the_least_moments_moves_within_the_steps_as_any_other() {
    let [one, least] = [1.0, 2_f64.powi(-1019)].map(|unit| {
        let body = free(Vector3::new(1.0, 2.0, 2.6) * unit);
        let spun = start(&body, &[0.3, 1.5, 0.02].into());
        let mut run = Stepper::of_system(body, &spun, 1e-12, 100).unwrap();
        run.run(0.05, 200).map(|state| state.unwrap().momentum / unit).collect::<Vec<_>>()
    });
    assert!(one.iter().zip(&least).all(|(a, b)| (a - b).norm() < 1e-11));
}
