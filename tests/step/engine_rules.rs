//! The rules by which physics engines turn a free body: the laws that each keeps and breaks.

use super::{energy, free, free_motion, start, under};
use crate::common::{attitude, generic_spin};
use nalgebra::Vector3;
use proptest::prelude::*;
use tumbling::step::{Method, State, System, Torque};

#[test]
fn one_newton_step_of_implicit_euler_can_add_energy_to_a_rod_that_turns_by_an_eighth_of_a_radian() {
    let system = free([0.61281739, 0.00620431, 0.61012591]);
    let omega = Vector3::new(0.79206796, 0.00766532, -0.61038478);
    let start = start(&system, &omega);
    let end = Method::ImplicitOneNewton.step(&system, &start, 0.1316947).unwrap();
    // By MuJoCo 4.0.0 itself, implicitfast: 4.17863e-6.
    let gain = energy(&system, &end) / energy(&system, &start) - 1.0;
    assert!((gain / 4.17863e-6 - 1.0).abs() < 1e-4, "{gain:e}");
}

/// Bodies with three well different moments, turned and spun every way.
fn body() -> impl Strategy<Value = (System<f64>, State<f64>)> {
    ((0.1..0.3, 0.4..0.6, 0.7..1.0), attitude(), generic_spin()).prop_map(|(half, q, omega)| {
        let (x, y, z): (f64, f64, f64) = half;
        let moments = Vector3::new(y + z, z + x, x + y);
        let vector = moments.component_mul(&omega);
        (free(moments), State { attitude: q.into_inner(), momentum: vector })
    })
}

proptest! {
    // L x w is at right angles to both, so that an explicit step along it lengthens both measures.
    #[test]
    fn every_explicit_gyroscopic_step_adds_energy_and_momentum((system, start) in body(), h in 0.01..3.0_f64) {
        let end = Method::SemiImplicitEuler.step(&system, &start, h).unwrap();
        let rate = system.rate(&start).momentum;
        let gain = h * h * rate.dot(&system.omega(&rate)) / 2.0;
        prop_assert!((energy(&system, &end) - energy(&system, &start) - gain).abs() < 1e-13 * energy(&system, &end));
        let longer = end.momentum.norm_squared() - start.momentum.norm_squared() - (h * rate).norm_squared();
        prop_assert!(longer.abs() < 1e-13 * end.momentum.norm_squared());
    }

    #[test]
    fn one_newton_step_of_implicit_euler_takes_energy_while_moments_differ_well_and_steps_turn_little((system, start) in body()) {
        let end = Method::ImplicitOneNewton.step(&system, &start, 0.1).unwrap();
        prop_assert!(energy(&system, &end) < energy(&system, &start));
    }

    #[test]
    fn a_body_without_gyroscopic_term_never_flips(q in attitude(), push in 1e-3..0.1_f64) {
        let system = free([1.0, 2.0, 3.0]);
        let start = State { attitude: q.into_inner(), momentum: system.momentum(&Vector3::new(push, 10.0, push)) };
        let mut motion = start;
        for _ in 0..600 {
            motion = Method::ConstantSpin.step(&system, &motion, 1.0 / 60.0).unwrap();
        }
        prop_assert!((system.omega(&motion.momentum) - system.omega(&start.momentum)).norm() < 1e-13);
        // The exact one flips within these 10 s.
        let exact = free_motion(*system.moments(), &system.omega(&start.momentum));
        prop_assert!(exact.flips(0.0, 10.0).unwrap().count() > 0);
    }

    // Two rules for a free body that differ in their torque alone.
    #[test]
    fn one_newton_step_and_the_linearised_rule_are_one_for_a_free_body_and_two_under_a_torque((system, start) in body()) {
        let both = |system: &System<f64>| {
            [Method::ImplicitOneNewton, Method::LinearisedImplicit].map(|method| method.step(system, &start, 1.0 / 60.0).unwrap())
        };
        let [a, b] = both(&system);
        prop_assert!((a.momentum - b.momentum).norm() <= 8.0 * f64::EPSILON * start.momentum.norm());
        let pushed = under(*system.moments(), vec![Torque::InBody(Vector3::new(1.0, 2.0, -1.0))]);
        let [a, b] = both(&pushed);
        prop_assert!((a.momentum - b.momentum).norm() > 1e-6);
    }
}
