//! The energy under torques that have a potential, and flips where runs meet.

use super::spinning;
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::step::{Stepper, Torque};
use tumbling::{Body, Inertia};

fn body() -> Body {
    let inertia = Inertia::from_moments(1.0, 2.0, 2.5).unwrap();
    let attitude = UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1);
    Body::spinning(inertia, attitude, &Vector3::new(0.4, 1.8, -0.3)).unwrap()
}

fn driven(torques: impl IntoIterator<Item = Torque<f64>>) -> Stepper {
    Stepper::adaptive(&body(), 1e-12, 10_000).unwrap().with_torques(torques).unwrap()
}

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
        let mut stepper = driven(acting.to_vec());
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

/// A spin about the middle axis that a torque has brought to exactly zero at 1 s.
fn at_rest() -> Stepper {
    let body = spinning([1.0, 2.0, 3.0], &Vector3::y());
    let stepper = Stepper::adaptive(&body, 1e-12, 1000).unwrap();
    let mut stepper = stepper.with_torques([Torque::InBody(Vector3::y() * -2.0)]).unwrap();
    assert!(stepper.flips(1.0).unwrap().is_empty());
    assert_eq!(stepper.omega(), Vector3::zeros());
    stepper
}

#[test]
fn a_flip_where_one_call_ends_and_the_next_begins_is_one_flip() {
    assert_eq!(at_rest().flips(2.0).unwrap(), [1.0]);
    // Back the way it came there is none.
    assert!(at_rest().flips(0.5).unwrap().is_empty());
    // A run in pieces that end at the flips, or next to them, has those of the whole.
    let whole = driven([]).flips(40.0).unwrap();
    assert!(whole.len() > 4);
    for off in [0.0, 1e-15, -1e-15, 1e-12, -1e-12] {
        let mut stepper = driven([]);
        let mut found = Vec::new();
        for time in whole.iter().map(|time| time * (1.0 + off)).chain([40.0]) {
            found.extend(stepper.flips(time).unwrap());
        }
        assert_eq!(found.len(), whole.len(), "{off}: {found:?} {whole:?}");
        for (one, other) in found.iter().zip(&whole) {
            assert!((one - other).abs() < 1e-10, "{off}: {one} {other}");
        }
    }
}
