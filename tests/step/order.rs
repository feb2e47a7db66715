//! The order of every method under torques that depend on time, attitude and spin. The proofs prove the
//! orders on power series; these tests observe them in `f64`.

use super::{adaptive, apart, by, in_axes, seen_along, steppers, turn_by, under};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use tumbling::Body;
use tumbling::step::{Method, State, Stepper, Torque};

/// Errors at `t` in `count` steps and in twice as many, as a power of two.
fn order(
    method: Option<Method>,
    body: &Body,
    torques: &[Torque<f64>],
    truth: &State<f64>,
    t: f64,
    count: u32,
) -> (f64, f64) {
    let error = |count: u32| {
        let mut stepper = by(body, method).unwrap().with_torques(torques.to_vec()).unwrap();
        let end = stepper.run(t / f64::from(count), count as usize).last().unwrap().unwrap();
        apart(&end, truth)
    };
    let errors = [error(count), error(2 * count)];
    ((errors[0] / errors[1]).log2(), errors[1])
}

/// The order of a method under a torque.
fn claimed(method: Option<Method>) -> f64 {
    match method {
        Some(
            Method::RungeKutta4
            | Method::DormandPrince5
            | Method::MuntheKaas4
            | Method::Gauss4
            | Method::Gauss6
            | Method::TurnedRungeKutta4,
        ) => f64::from(method.unwrap().info().order),
        Some(method) => f64::from(method.info().order.min(2)),
        None => 2.0,
    }
}

#[test]
fn driven_by_time_attitude_and_spin_every_method_has_its_order() {
    let axes = UnitQuaternion::from_euler_angles(0.3, 0.8, -0.4);
    let body =
        Body::spinning(in_axes(Vector3::new(1.0, 2.0, 2.5), &axes), axes, &Vector3::new(0.9, 1.1, -0.7))
            .unwrap();
    let law = |time: f64, rotation: &Matrix3<f64>, omega: &Vector3<f64>| {
        rotation.tr_mul(&Vector3::new((2.0 * time).sin(), 0.3, 0.5 * time.cos()))
            - omega.component_mul(&Vector3::new(0.2, 0.1, 0.3)) * omega.norm()
    };
    // The reference is a fine adaptive run along the principal axes, with the law written for them.
    let t = 1.0;
    let principal = body.inertia().principal();
    let (frame, turn) = (principal.frame(), turn_by(&principal.frame()));
    let turned = Torque::function(move |time: f64, rotation: &Matrix3<f64>, omega: &Vector3<f64>| {
        frame.tr_mul(&law(time, &(rotation * frame.transpose()), &(frame * omega)))
    });
    let system = under(principal.moments(), vec![turned]);
    let end = adaptive(&system, &seen_along(&body.state(), &turn), t, 1e-14, &mut 1_000_000).unwrap();
    let truth = seen_along(&end, &turn.inverse());
    // And torques with kicks of their own, whose truth is a run by series.
    let named = [
        Torque::gravity(&Vector3::new(0.1, 0.0, 0.5), 3.0),
        Torque::InBody(Vector3::new(0.2, -0.1, 0.3)),
        Torque::Damping(Vector3::repeat(0.2)),
        Torque::Dissipation(0.1),
    ];
    let run = Stepper::adaptive(&body, 1e-14, 1000).unwrap().with_torques(named.clone());
    let by_series = run.unwrap().step(t).unwrap();
    for method in steppers() {
        let said = claimed(method);
        let count = if said > 5.5 {
            6
        } else if said > 3.0 {
            24
        } else {
            200
        };
        for (torques, truth) in [(&[Torque::function(law)][..], &truth), (&named, &by_series)] {
            let (seen, error) = order(method, &body, torques, truth, t, count);
            assert!((seen - said).abs() < 0.3, "{method:?}: {seen} for {said}, {error:e}");
        }
    }
}
