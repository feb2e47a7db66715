//! The account of the energy under torques: work done, and potential energy where there is one.

use crate::common::refused;
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::step::{Method, Stepper, Torque};
use tumbling::{Body, ErrorKind, Inertia};

fn body() -> Body {
    let inertia = Inertia::from_moments(1.0, 2.0, 2.5).unwrap();
    let attitude = UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1);
    Body::spinning(inertia, attitude, &Vector3::new(0.4, 1.8, -0.3)).unwrap()
}

fn driven(torques: impl IntoIterator<Item = Torque<f64>>) -> Stepper<f64> {
    Stepper::<f64>::adaptive(&body(), 1e-12, 10_000).unwrap().with_torques(torques).unwrap()
}

fn torques() -> Vec<Torque<f64>> {
    let v = Vector3::new;
    vec![
        Torque::InBody(v(0.3, -0.2, 0.5)),
        Torque::InWorld(v(-0.1, 0.4, 0.2)),
        Torque::gravity(&v(0.1, 0.2, 0.3), 4.0),
        Torque::spring(&v(0.3, -0.2, 0.9), &v(0.1, 0.7, 0.6), 2.0),
        Torque::magnetic(&v(0.5, 0.1, -0.4), &v(0.3, 2.0, 0.1)),
        Torque::Damping(v(0.1, 0.3, 0.2)),
        Torque::Dissipation(0.05),
        Torque::gravity_gradient(&Vector3::x(), &v(0.0, 0.0, 0.7)),
        Torque::GravityGradient { strength: 1.5, direction: Vector3::y(), orbit: Vector3::zeros() },
        Torque::during(0.3, 0.9, Torque::InBody(v(2.0, -1.0, 0.5))),
        Torque::function(|time: f64, _, w: &Vector3<f64>| w * (-0.1 * w.norm()) + Vector3::x() * time.sin()),
    ]
}

#[test]
fn what_each_torque_does_as_work_the_body_has_in_energy() {
    for torque in torques() {
        for h in [3.0, -2.0] {
            let mut stepper = driven([torque.clone()]);
            let _ = stepper.step(h).unwrap();
            let work = stepper.work().unwrap();
            let gained = stepper.body().unwrap().energy() - body().energy();
            assert!((work[0] - gained).abs() < 1e-10, "{torque:?} {h}: {work:?}, gained {gained}");
        }
    }
}

#[test]
fn the_work_of_all_torques_together_closes_the_account_however_they_switch() {
    let mut all = torques();
    // Two gradients and a function go by another way than series; here these alone.
    all.truncate(8);
    for (start, end) in [(0.1, 0.25), (0.6, 1.9), (2.999, 7.0)] {
        all.push(Torque::during(start, end, Torque::InBody(Vector3::new(1.0, 2.0, -3.0))));
    }
    let mut stepper = driven(all);
    let mut before = stepper.body().unwrap().energy();
    for _ in 0..2 {
        let _ = stepper.step(3.0).unwrap();
        let work = stepper.work().unwrap();
        let after = stepper.body().unwrap().energy();
        assert_eq!(work.len(), 11);
        assert!((work.iter().sum::<f64>() - (after - before)).abs() < 1e-9, "{work:?}");
        // Losses lose, whatever the others do.
        assert!(work[5] < 0.0 && work[6] < 0.0, "{work:?}");
        before = after;
    }
    // A step of no time does no work, and fixed steps have no account.
    let _ = stepper.step(0.0).unwrap();
    assert_eq!(stepper.work().unwrap(), vec![0.0; 11]);
    let fixed = Stepper::<f64>::new(&body(), Method::Gauss6).unwrap();
    refused(fixed.work(), ErrorKind::Undefined, "fixed method");
}

#[test]
fn kinetic_and_potential_energy_together_stay_where_each_torque_has_a_potential() {
    let with_potential: Vec<Torque<f64>> =
        torques().into_iter().enumerate().filter(|(k, _)| [2, 3, 4, 8].contains(k)).map(|(_, t)| t).collect();
    let mut stepper = driven(with_potential.clone());
    let whole = |stepper: &Stepper<f64>| [stepper.body().unwrap().energy(), stepper.potential().unwrap()];
    let before = whole(&stepper);
    for _ in 0..4 {
        let _ = stepper.step(1.7).unwrap();
        let now = whole(&stepper);
        assert!((now[0] - before[0]).abs() > 1e-3);
        assert!((now[0] + now[1] - before[0] - before[1]).abs() < 1e-10, "{now:?} {before:?}");
        let work: f64 = stepper.work().unwrap().iter().sum();
        assert!(work.is_finite());
    }
    for (k, torque) in torques().into_iter().enumerate() {
        assert_eq!(driven([torque]).potential().is_some(), [2, 3, 4, 8].contains(&k), "{k}");
    }
}

/// A spin about the middle axis that a torque has brought to exactly zero at 1 s.
fn at_rest() -> Stepper<f64> {
    let inertia = Inertia::from_moments(1.0, 2.0, 3.0).unwrap();
    let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::y()).unwrap();
    let stepper = Stepper::<f64>::adaptive(&body, 1e-12, 1000).unwrap();
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

/// Two quadratures that both miss a loss which is over at once agree on no work at all.
#[test]
fn a_loss_that_is_over_at_once_is_found_whole() {
    let before = body().energy();
    for rate in [300.0, 5000.0] {
        let mut stepper = Stepper::<f64>::adaptive(&body(), 1e-9, 1_000_000)
            .unwrap()
            .with_torques([Torque::Damping(Vector3::new(1.0, 2.0, 2.5) * rate)])
            .unwrap();
        let _ = stepper.step(1.0).unwrap();
        let work = stepper.work().unwrap();
        assert!((work[0] + before).abs() < 1e-5 * before, "{rate}: {work:?}");
    }
}
