//! The energy under torques that have a potential.

use super::driven::tilted;
use nalgebra::Vector3;
use tumbling::Body;
use tumbling::step::{Stepper, Torque};

/// Weight times height, or what a field and a gravity gradient take for it, J, by the textbook's formulas.
fn potential(torques: &[Torque<f64>], body: &Body) -> f64 {
    let back = body.attitude().inverse();
    let of = |torque: &Torque<f64>| match torque {
        Torque::Aligning { arm, field } => -arm.dot(&(back * field)),
        Torque::GravityGradient { strength, direction, .. } => {
            let n = back * direction;
            0.5 * strength * n.dot(&(body.inertia().matrix() * n))
        }
        other => panic!("{other:?} has no potential"),
    };
    torques.iter().map(of).sum()
}

#[test]
fn kinetic_and_potential_energy_together_stay_where_each_torque_has_a_potential() {
    let v = Vector3::new;
    let gradient =
        |strength, direction| Torque::GravityGradient { strength, direction, orbit: Vector3::zeros() };
    let torques = [
        Torque::gravity(&v(0.1, 0.2, 0.3), 4.0),
        Torque::spring(&v(0.3, -0.2, 0.9), &v(0.1, 0.7, 0.6), 2.0),
        Torque::Aligning { arm: v(0.5, 0.1, -0.4), field: v(0.3, 2.0, 0.1) },
        gradient(1.5, Vector3::y()),
        gradient(0.7, v(0.6, 0.0, -0.8)),
    ];
    for count in 1..=torques.len() {
        let acting = &torques[..count];
        let stepper = Stepper::adaptive(&tilted(), 1e-12, 10_000).unwrap();
        let mut stepper = stepper.with_torques(acting.to_vec()).unwrap();
        let whole = |stepper: &Stepper| {
            let body = stepper.body().unwrap();
            [body.energy(), potential(acting, &body)]
        };
        let before = whole(&stepper);
        for _ in 0..4 {
            let _ = stepper.step(1.7).unwrap();
            let now = whole(&stepper);
            assert!((now[0] - before[0]).abs() > 1e-3);
            assert!((now[0] + now[1] - before[0] - before[1]).abs() < 1e-10, "{now:?} {before:?}");
        }
    }
}
