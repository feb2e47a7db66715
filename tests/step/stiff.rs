//! Damping far faster than the motion: steps as long as the motion permits.

use super::apart as off;
use super::{adaptive, start, under};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::PrincipalMoments;
use tumbling::step::{State, Stepper, System, Torque};

fn system(torques: Vec<Torque<f64>>) -> System<f64> {
    under([1.0, 2.0, 2.5], torques)
}

fn spinning(system: &System<f64>, omega: [f64; 3]) -> State<f64> {
    start(system, &omega.into())
}

/// The state after 8 s is from two programs with 40 digits, one by Taylor series and one by extrapolation.
#[test]
fn uneven_damping_of_512_a_second_takes_few_steps() {
    let system = system(vec![Torque::Damping(Vector3::new(0.03125, 1024.0, 0.0625))]);
    let start = spinning(&system, [2.0, 1.0, 3.0]);
    let truth = State {
        attitude: [0.13296153888482644, 0.018435839968535622, 0.20774093163020804, 0.9689298500445977].into(),
        momentum: Vector3::new(1.4901783296099346, 0.010568728642485697, 6.051328833472498),
    };
    let bounds = [(1e-4, 3e-5, 30), (1e-8, 1e-8, 30), (1e-12, 1e-11, 30), (1e-14, 1e-13, 60)];
    for (tolerance, bound, steps) in bounds {
        let end = adaptive(&system, &start, 8.0, tolerance, &mut { steps }).unwrap();
        assert!(off(&end, &truth) < bound, "{tolerance:e}: {:e}", off(&end, &truth));
    }
}

/// With damping of 1e9 N m s about one axis, only the slow decay about the other axes remains.
#[test]
fn an_axis_held_by_its_damping_leaves_the_others_to_decay() {
    let system = system(vec![Torque::Damping(Vector3::new(1e9, 1.0, 1e-3))]);
    let start = spinning(&system, [1.0, 1.0, 1.2]);
    let end = adaptive(&system, &start, 1.0, 1e-10, &mut 100).unwrap();
    let expected =
        Vector3::new(-0.6e-9, 2.0, 3.0).component_mul(&Vector3::new(-0.5, -0.5, -4e-4).map(f64::exp));
    assert!((end.momentum - expected).norm() < 1e-8, "{:?}", end.momentum);
    assert!((end.momentum.x / expected.x - 1.0).abs() < 1e-3, "{:?}", end.momentum);
}

/// A heavy body with a push from 0.7 s to 1.3 s. Its damping is given by its name and as a function; a run
/// does not recognize the function as damping, so DOP853 takes thousands of short steps.
fn held_and_pushed(fast: f64, slow: f64, weight: f64, push: f64) -> [System<f64>; 2] {
    let damping = Vector3::new(slow, fast, 0.5 * slow);
    let function = Torque::function(move |_, _, omega| -damping.component_mul(omega));
    [Torque::Damping(damping), function].map(|damping| {
        system(vec![
            Torque::gravity(&Vector3::new(0.05, 0.0, 0.1), weight),
            Torque::InBody(Vector3::new(0.0, 50.0 * push, push)),
            Torque::during(0.7, 1.3, Torque::InBody(Vector3::new(push, 0.0, 0.2))),
            damping,
        ])
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn solved_damping_moves_a_heavy_body_as_short_explicit_steps_do(
        omega in prop::array::uniform3(-2.0..2.0), fast in 300.0..2000.0, slow in 0.0..0.5, weight in 0.0..3.0,
        push in -1.0..1.0,
    ) {
        let [solved, explicit] = held_and_pushed(fast, slow, weight, push);
        let start = spinning(&solved, omega);
        let mut run = Stepper::of_system(solved, &start, 1e-11, 100_000).unwrap();
        let mut slowly = Stepper::of_system(explicit, &start, 1e-12, 100_000).unwrap();
        for time in [0.01, 0.2, 0.69, 0.71, 1.1, 1.31, 1.7, 2.0] {
            let (state, truth) = (run.step_to(time).unwrap(), slowly.step_to(time).unwrap());
            prop_assert!(off(&state, &truth) < 2e-9, "{} s: {:e}", time, off(&state, &truth));
        }
        prop_assert!(run.steps_of_run() < 200, "{} steps", run.steps_of_run());
    }
}

/// The first explicit step after 0.7 s has 5.66 decay times, where the differences from the steps of lower
/// order vanish; it was once accepted with an error of 7e-10.
#[test]
fn no_explicit_step_is_taken_for_right_where_damping_hides_its_error() {
    let [solved, explicit] = held_and_pushed(1624.9174, 0.164_920_21, 1.671_169_3, 0.175_138_14);
    let start = spinning(&solved, [1.637_048_7, 0.096_335_9, -0.977_182]);
    let [one, finer, other] = [(&explicit, 1e-12), (&explicit, 1e-14), (&solved, 1e-14)]
        .map(|(system, tolerance)| adaptive(system, &start, 0.71, tolerance, &mut 100_000).unwrap());
    assert!(off(&finer, &other) < 1e-13 && off(&one, &finer) < 1e-11, "{:e}", off(&one, &finer));
}

/// A run without an end may reach a switch, after which no step is known yet, at any count of steps.
#[test]
fn a_push_that_ends_lets_a_stiff_run_without_end_go_on() {
    let damping = Torque::Damping(Vector3::new(0.4, 570.0, 0.2));
    for k in 0..48 {
        let end = 0.5 + 0.01 * f64::from(k);
        let push = Torque::during(0.1, end, Torque::InBody(Vector3::new(0.9, 0.0, 0.2)));
        let system = system(vec![damping.clone(), push]);
        let start = spinning(&system, [-0.01, 0.2, -0.08]);
        let mut run = Stepper::of_system(system.clone(), &start, 1e-11, 100_000).unwrap();
        let whole = adaptive(&system, &start, 2.0, 1e-13, &mut 100_000).unwrap();
        let there = run.step_to(2.0).unwrap_or_else(|error| panic!("{end} s: {error}"));
        assert!(off(&there, &whole) < 1e-9, "{end} s: {:e}", off(&there, &whole));
    }
}

/// Once the body is at rest, any further time needs no steps.
#[test]
fn a_spin_that_damping_stops_at_once_is_at_rest_to_the_end() {
    let system = system(vec![Torque::Damping(Vector3::new(1e6, 2e6, 3.5e6))]);
    let start = spinning(&system, [1.0, 1.0, 1.2]);
    let end = adaptive(&system, &start, 1e4, 1e-9, &mut 1_000).unwrap();
    assert_eq!(end.momentum, Vector3::zeros());
    // It has turned by spin over rate about each axis.
    let turned = 2.0 * end.attitude.imag();
    assert!((turned - Vector3::new(1e-6, 1e-6, 1.2 / 1.4e6)).norm() < 1e-11, "{turned}");
}

/// A piece ends at 0.3 s, so near to 1 s that times from there on round.
#[test]
fn the_last_instant_before_the_end_is_reached() {
    let push = Torque::during(-1.0, 0.3, Torque::InBody(Vector3::new(0.1, 0.2, 0.3)));
    let system = system(vec![push]);
    let start = spinning(&system, [1.0, -2.0, 0.5]);
    let mut run = Stepper::of_system(system.clone(), &start, 1e-9, 100_000).unwrap();
    let before = run.step_to(1.0_f64.next_down()).unwrap();
    assert!(off(&before, &run.step_to(1.0).unwrap()) < 1e-14);
}

/// Three periodic torques, of which the series hold two: explicit steps of a pair, then collocation, then
/// the pair again once the third has pushed the body up to speed.
#[test]
fn a_run_that_changes_its_steps_gives_states_at_the_times_requested() {
    let amplitude = Vector3::new(0.3, 0.1, 0.2);
    let push = |rate: f64, size: f64| Torque::Periodic { amplitude: amplitude * size, rate, phase: 0.4 };
    let torques = |loss: Torque<f64>| vec![push(0.5, 1.0), push(0.8, -2.0), push(0.03, 60.0), loss];
    let damping = Vector3::new(0.1, 800.0, 0.2);
    let solved = system(torques(Torque::Damping(damping)));
    let explicit = system(torques(Torque::function(move |_, _, omega| -damping.component_mul(omega))));
    let start = spinning(&solved, [0.2, 0.0, 0.1]);
    let mut run = Stepper::of_system(solved.clone(), &start, 1e-10, 100_000).unwrap();
    let mut slowly = Stepper::of_system(explicit.clone(), &start, 1e-12, 100_000).unwrap();
    for k in 1..=120 {
        let time = 0.05 * f64::from(k);
        let (state, truth) = (run.step_to(time).unwrap(), slowly.step_to(time).unwrap());
        assert!(off(&state, &truth) < 1e-7, "{time}: {:e}", off(&state, &truth));
    }
}

/// A needle creeps along a field against its damping, with `tan(angle / 2)` falling as `exp(-m B t / c)`.
#[test]
fn an_overdamped_needle_creeps_in_few_steps() {
    for damping in [1e4, 1e8, 1e10] {
        let field = Torque::Aligning { arm: Vector3::x(), field: Vector3::new(0.0, damping, 0.0) };
        let system = system(vec![field, Torque::Damping(Vector3::repeat(damping))]);
        let rest = State { attitude: Quaternion::identity(), momentum: Vector3::zeros() };
        for tolerance in [1e-6, 1e-10] {
            let end = adaptive(&system, &rest, 3.0, tolerance, &mut 300).unwrap();
            let needle = UnitQuaternion::from_quaternion(end.attitude) * Vector3::x();
            let angle = 2.0 * (-3.0_f64).exp().atan();
            assert!((needle.angle(&Vector3::y()) - angle).abs() < 1e-6 + 10.0 / damping, "{damping:e}");
        }
    }
}

/// Two axes are damped in an instant, the third in a second.
#[test]
fn a_fast_spin_about_the_free_axis_is_not_refused_before_it_slows() {
    let moments = PrincipalMoments::new(1.0, 1.0, 1.5).unwrap();
    let system = under(moments, vec![Torque::Damping(Vector3::new(1e5, 1e5, 1.5))]);
    let start = spinning(&system, [0.0, 0.0, 1e4]);
    // Fewer steps than the whole would take at the rate of the first.
    let end = adaptive(&system, &start, 20.0, 1e-8, &mut 50_000).unwrap();
    assert!((end.momentum.z / (1.5e4 * (-20.0_f64).exp()) - 1.0).abs() < 1e-5, "{}", end.momentum);
}

/// `p' = P sin(w t) - k p` from rest, about a principal axis: the torque is zero at the start, so that
/// there is nothing yet to measure a momentum by.
fn pushed_from_zero(push: f64, rate: f64, decay: f64, time: f64) -> f64 {
    let (sine, cosine) = (rate * time).sin_cos();
    push * (decay * sine - rate * cosine + rate * (-decay * time).exp()) / (decay * decay + rate * rate)
}

#[test]
fn from_rest_the_first_step_under_a_growing_push_keeps_its_tolerance() {
    let (rate, axis) = (3.0, Vector3::z());
    for damping in [2e2, 3e4, 9e5] {
        for (push, decay_times) in [(1e-4, 20.0), (1.0, 100.0), (1e3, 1e3)] {
            let decay = damping / 2.5;
            let time = decay_times / decay;
            let law = Torque::function(move |t: f64, _, _| axis * (push * (rate * t).sin()));
            let late = Torque::Periodic { amplitude: axis * push, rate, phase: -std::f64::consts::FRAC_PI_2 };
            for torque in [law, late] {
                let system = system(vec![torque, Torque::Damping(Vector3::new(0.3, 0.1 * damping, damping))]);
                let rest = spinning(&system, [0.0; 3]);
                let truth = pushed_from_zero(push, rate, decay, time);
                for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
                    let mut budget = 3_000;
                    let end = adaptive(&system, &rest, time, tolerance, &mut budget).unwrap();
                    let (steps, off) = (3e3 - budget as f64, (end.momentum.z / truth - 1.0).abs());
                    assert!(off < tolerance * steps, "{damping} {push} {tolerance:e}: {off:e} in {steps}");
                }
            }
        }
    }
}

/// The tighter the tolerance, the shorter the pair's steps, down to where stability no longer holds them
/// back; the motion itself is slow.
#[test]
fn a_push_against_stiff_damping_takes_few_steps_at_every_tolerance() {
    let axis = Vector3::new(0.0, 0.0, 1.0);
    for (damping, push, time) in [(8e3, 0.4, 10.0), (5e6, 300.0, 0.4), (9e7, 8e-3, 0.5)] {
        let torque = Torque::function(move |t: f64, _, _| axis * (push * (0.9 * t).sin()));
        let system = system(vec![torque, Torque::Damping(Vector3::new(0.0, 0.3, damping))]);
        let rest = spinning(&system, [0.0; 3]);
        let truth = pushed_from_zero(push, 0.9, damping / 2.5, time);
        for (tolerance, steps) in [(1e-8, 150), (1e-10, 150), (1e-12, 200), (1e-13, 300), (1e-14, 500)] {
            let end = adaptive(&system, &rest, time, tolerance, &mut { steps }).unwrap();
            let off = (end.momentum.z / truth - 1.0).abs();
            assert!(off < 100.0 * tolerance, "{damping:e} {tolerance:e}: {off:e}");
        }
    }
}
