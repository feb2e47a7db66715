//! Extreme inputs: every answer is finite, with a unit attitude where that is promised; everything else is
//! refused.

use super::{by, finite, steppers};
use crate::common::{anything, attitude, generic_spin, moments};
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::step::{Engine, Method, PositionStage, State, Stepper, System, Torque, fixed_rate};
use tumbling::{Body, Inertia, PrincipalMoments};

/// A number of any size, its logarithm spread evenly.
fn of_any_size() -> impl Strategy<Value = f64> {
    (-320.0..308.0_f64, any::<bool>()).prop_map(|(x, less)| 10.0_f64.powf(x) * if less { -1.0 } else { 1.0 })
}

fn vector_of_any_size() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(of_any_size()).prop_map(Vector3::from)
}

/// Once in a while no number at all.
fn given() -> impl Strategy<Value = f64> {
    let none = prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY]);
    prop_oneof![18 => of_any_size(), 1 => anything(), 1 => none]
}

/// Of a top, a satellite, a motor and drag.
fn torques(v: Vector3<f64>, w: Vector3<f64>, x: f64) -> Vec<Torque<f64>> {
    vec![
        Torque::InBody(v),
        Torque::InWorld(v),
        Torque::Aligning { arm: v, field: w },
        Torque::Damping(v.abs()),
        Torque::Dissipation(x.abs()),
        Torque::GravityGradient { strength: x.abs(), direction: Vector3::y(), orbit: w },
        Torque::Periodic { amplitude: v, rate: x, phase: w.x },
        Torque::during(-1.0, x.abs(), Torque::InBody(w)),
        Torque::function(move |time, rotation, omega| {
            rotation.transpose() * v + omega.component_mul(&w) * time
        }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3_000))]

    #[test]
    fn a_step_of_fixed_rate_ends_in_a_unit_attitude_or_is_refused(
        moments in moments(), omega in generic_spin(), length in of_any_size(), unit in attitude(),
        kind in 0..10_usize, v in vector_of_any_size(), w in vector_of_any_size(), h in of_any_size(),
    ) {
        let acting = torques(v, w, h).into_iter().skip(kind).take(1).collect();
        let system = System::with(moments.try_into().unwrap(), acting);
        prop_assume!(system.is_ok());
        let system = system.unwrap();
        let start = State { attitude: unit.into_inner() * length, momentum: system.momentum(&omega) };
        for h in [1.0 / 60.0, h] {
            if let Ok(end) = fixed_rate(&system, &start, h) {
                prop_assert!(finite(&end) && (end.attitude.norm() - 1.0).abs() < 1e-14, "{:?}", end);
            }
        }
        // A free body's motion does not depend on the length of its attitude, if that has its digits.
        if kind == 9 && length.abs() > 1e-290 {
            let one = State { attitude: unit.into_inner(), ..start };
            let (one, other) = (fixed_rate(&system, &one, 0.01), fixed_rate(&system, &start, 0.01));
            if let (Ok(one), Ok(other)) = (&one, &other) {
                prop_assert!((one.momentum - other.momentum).norm() <= 1e-14 * one.momentum.norm());
                let turned = one.attitude.coords - other.attitude.coords * length.signum();
                prop_assert!(turned.norm() < 1e-13, "{:?} {:?}", one, other);
            }
            prop_assert_eq!(one.is_ok(), other.is_ok(), "{:e}", length);
        }
    }

    #[test]
    fn a_step_of_every_method_is_finite_or_refused(
        a in given(), b in given(), c in given(), momentum in prop::array::uniform3(given()).prop_map(Vector3::from),
        unit in attitude(), length in given(), kind in 0..10_usize, v in vector_of_any_size(),
        w in vector_of_any_size(), h in given(), leaning in prop::option::of(attitude()),
    ) {
        // Numbers that the constructor refuses, too.
        let unchecked = System::of_numbers(Vector3::new(a, b, c), Vec::new());
        let start = State { attitude: unit.into_inner() * length, momentum };
        for &method in Method::ALL {
            prop_assert!(method.step(&unchecked, &start, h).map_or(true, |end| finite(&end)), "{:?}", method);
        }
        prop_assert!(fixed_rate(&unchecked, &start, h).map_or(true, |end| finite(&end)));
        let moments = PrincipalMoments::new(a.abs(), b.abs(), c.abs())
            .or_else(|_| PrincipalMoments::new(a.abs(), 1.5 * a.abs(), 0.7 * a.abs()));
        let Ok(moments) = moments else { return Ok(()) };
        let system = System::with(moments, torques(v, w, h).into_iter().skip(kind).take(1).collect());
        prop_assume!(system.is_ok());
        let system = system.unwrap();
        for length in [1.0, length] {
            let start = State { attitude: unit.into_inner() * length, momentum };
            for &method in Method::ALL {
                if let Ok(end) = method.step(&system, &start, h) {
                    prop_assert!(finite(&end), "{:?}: {:?}", method, end);
                }
            }
        }
        let inertia = Inertia::from(moments);
        let inertia = leaning.map_or(Ok(inertia), |axes| inertia.turned(axes));
        if let Ok(body) = inertia.and_then(|inertia| Body::new(inertia, unit, &momentum)) {
            for method in steppers() {
                let stepper = by(&body, method).and_then(|stepper| stepper.with_torques(system.torques().to_vec()));
                for state in stepper.into_iter().flat_map(|mut stepper| stepper.run(h, 2).collect::<Vec<_>>()) {
                    prop_assert!(state.as_ref().map_or(true, finite), "{method:?}: {state:?}");
                }
                let single = System::of_numbers(moments.vector().cast::<f32>(), Vec::new());
                let start = State { attitude: unit.coords.cast().into(), momentum: momentum.cast::<f32>() };
                let end = match method {
                    Some(method) => method.step(&single, &start, h as f32),
                    None => fixed_rate(&single, &start, h as f32),
                };
                prop_assert!(end.map_or(true, |end| end.momentum.iter().all(|x| x.is_finite())), "{method:?}");
            }
            for tolerance in [1e-3, 1e-12] {
                let Ok(stepper) = Stepper::adaptive(&body, tolerance, 30) else { continue };
                let Ok(mut stepper) = stepper.with_torques(system.torques().to_vec()) else { continue };
                if let Ok(end) = stepper.step(h) {
                    prop_assert!(finite(&end) && (end.attitude.norm() - 1.0).abs() < 1e-14, "{:?}", end);
                    prop_assert!(stepper.omega().iter().all(|x| x.is_finite()));
                    prop_assert!(stepper.body().is_ok());
                }
                if let Ok(transition) = stepper.step_with_transition(h) {
                    prop_assert!(transition.iter().all(|x| x.is_finite()));
                }
            }
        }
    }

    #[test]
    fn a_position_stage_and_an_engine_end_in_finite_unit_attitudes_or_say_that_they_took_no_step(
        a in of_any_size(), b in of_any_size(), unit in attitude(), omega in vector_of_any_size(),
        h in of_any_size(),
    ) {
        let moments = Vector3::new(a.abs(), b.abs(), 0.4 * (a.abs() + b.abs()));
        if let Ok(stage) = PositionStage::new(&moments) {
            let end = stage.step(&unit.into_inner(), &omega, h);
            prop_assert!(end.parts == 0 || end.omega.iter().all(|x| x.is_finite()), "{:?}", end);
            prop_assert!((end.attitude.norm() - 1.0).abs() < 1e-12, "{:?}", end);
        }
        let Ok(moments) = PrincipalMoments::try_from(moments) else { return Ok(()) };
        let Ok(body) = Body::spinning(moments.into(), unit, &omega) else { return Ok(()) };
        for engine in [Engine::Turned, Engine::Frozen, Engine::MomentumForSpin, Engine::NoGyroscopicTerm] {
            for end in engine.run(&body, h, 2).unwrap_or_default() {
                prop_assert!((end.attitude().norm() - 1.0).abs() < 1e-12, "{:?}", end);
                prop_assert!(end.momentum_world().iter().all(|x| x.is_finite()), "{:?}", end);
            }
        }
    }
}
