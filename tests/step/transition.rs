//! State transitions under torques, also about equilibria, where the motion is constant and only its
//! derivatives change.

use nalgebra::{Matrix6, UnitQuaternion, Vector3, Vector6};
use tumbling::step::{Stepper, Torque};
use tumbling::{Body, Inertia};

const MOMENTS: [f64; 3] = [1.0, 2.0, 2.5];

/// A stepper from this spin, with errors of attitude and spin added.
fn stepper(omega: Vector3<f64>, torques: &[Torque<f64>], off: Vector6<f64>) -> Stepper {
    let [a, b, c] = MOMENTS;
    let attitude = UnitQuaternion::from_scaled_axis(off.fixed_rows::<3>(0).into_owned());
    let omega = omega + off.fixed_rows::<3>(3);
    let body = Body::spinning(Inertia::from_moments(a, b, c).unwrap(), attitude, &omega).unwrap();
    let free = Stepper::adaptive(&body, 1e-12, 10_000).unwrap();
    free.with_torques(torques.to_vec()).unwrap()
}

fn differences(omega: Vector3<f64>, torques: &[Torque<f64>], h: f64) -> Matrix6<f64> {
    let mut matrix = Matrix6::zeros();
    for axis in 0..6 {
        let [ahead, behind] = [1e-4, -1e-4].map(|by| {
            let mut off = Vector6::zeros();
            off[axis] = by;
            let mut stepper = stepper(omega, torques, off);
            let _ = stepper.step(h).unwrap();
            stepper.body().unwrap()
        });
        let turned = (behind.attitude().inverse() * ahead.attitude()).scaled_axis() / 2e-4;
        let faster = (ahead.omega_body() - behind.omega_body()) / 2e-4;
        matrix.fixed_view_mut::<3, 1>(0, axis).copy_from(&turned);
        matrix.fixed_view_mut::<3, 1>(3, axis).copy_from(&faster);
    }
    matrix
}

/// The error of each column is within a fraction of its length.
fn agree(found: &Matrix6<f64>, expected: &Matrix6<f64>, within: f64, torques: &[Torque<f64>]) {
    for axis in 0..6 {
        let off = (found.column(axis) - expected.column(axis)).norm() / expected.column(axis).norm();
        assert!(off < within, "{torques:?} {axis}: {off:e}");
    }
}

#[test]
fn the_state_transition_is_the_limit_of_differences_at_an_equilibrium_too() {
    let (none, x, z) = (Vector3::zeros(), Vector3::x(), Vector3::z());
    let cases = [
        (none, vec![], 3.0),
        (none, vec![Torque::gravity(&-z, 4.0)], 3.0),
        (none, vec![Torque::spring(&x, &x, 8.0)], 3.0),
        (none, vec![Torque::Damping(Vector3::new(1.0, 1.0, 1.0))], 1.0),
        (z, vec![Torque::gravity_gradient(&x, &z)], 3.0),
        (none, vec![Torque::Periodic { amplitude: x + z, rate: 2.0, phase: 0.4 }], 3.0),
        // Back to before the weight acts: from there on the attitude matters no more, but has mattered.
        (x + z, vec![Torque::during(-1.0, 1.0, Torque::gravity(&x, 4.0)), Torque::Dissipation(0.1)], -3.0),
    ];
    let [every_kind, _] = super::driven::all_torques(Vector3::from(MOMENTS), 0);
    let driven = (Vector3::new(0.5, 1.9, -0.2), every_kind, 2.0);
    for (omega, torques, h) in cases.into_iter().chain([driven]) {
        let expected = differences(omega, &torques, h);
        let found = stepper(omega, &torques, Vector6::zeros()).step_with_transition(h).unwrap();
        agree(&found, &expected, 1e-6, &torques);
    }
}

#[test]
fn errors_of_a_pendulum_upright_at_rest_grow_as_hyperbolic_functions() {
    // About x and y they obey I e'' = 4 e, and about the vertical they turn on evenly.
    for h in [0.5, 3.0, 10.0] {
        let torques = [Torque::gravity(&Vector3::z(), 4.0)];
        let found = stepper(Vector3::zeros(), &torques, Vector6::zeros()).step_with_transition(h).unwrap();
        let mut expected = Matrix6::identity();
        expected[(2, 5)] = h;
        for i in 0..2 {
            let rate = (4.0 / MOMENTS[i]).sqrt();
            let (sinh, cosh) = ((rate * h).sinh(), (rate * h).cosh());
            (expected[(i, i)], expected[(i, 3 + i)]) = (cosh, sinh / rate);
            (expected[(3 + i, i)], expected[(3 + i, 3 + i)]) = (rate * sinh, cosh);
        }
        agree(&found, &expected, 1e-9, &torques);
    }
}

#[test]
fn nothing_is_left_of_errors_once_damping_has_brought_a_body_to_rest() {
    let (x, none) = (Vector3::x(), Vector6::zeros());
    let drag = [Torque::Damping(Vector3::new(3.0, 2.0, 5.0))];
    let hanging = [Torque::gravity(&-Vector3::z(), 4.0), Torque::spring(&x, &x, 8.0), drag[0].clone()];
    let found = stepper(x, &hanging, none).step_with_transition(3000.0).unwrap();
    assert!(found.amax() < 1e-290, "{:e}", found.amax());
    // The attitude where drag alone leaves it keeps the error that it has there.
    let [soon, late] = [1e3, 1e4].map(|h| stepper(x, &drag, none).expected_error(h).unwrap());
    assert_eq!(soon, late);
}
