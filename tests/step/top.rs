//! Adaptive runs under gravity next to its equilibria.

use crate::exact::apart;
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::exact::LagrangeTop;
use tumbling::step::{Stepper, Torque};
use tumbling::{Body, Inertia};

const ARM: Vector3<f64> = Vector3::new(0.0, 0.0, 0.4);

/// The weight is parallel to the arm, so that it has no torque but by the lean, which grows by e^20 and more.
#[test]
fn a_top_released_next_to_the_vertical_falls_as_its_closed_form_at_every_tolerance() {
    let inertia = Inertia::from_moments(1.0, 1.0, 0.3).unwrap();
    for (lean, tolerance) in [(1e-9, 1e-3), (1e-9, 1e-4), (1e-12, 1e-6), (1e-14, 1e-8)] {
        let leaning = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), lean);
        let body = Body::spinning(inertia, leaning, &Vector3::new(lean, lean / 2.0, 0.0)).unwrap();
        let top = LagrangeTop::of(&body, &ARM, 2.0).unwrap();
        let torques = [Torque::gravity(&ARM, 2.0)];
        let mut stepper = Stepper::adaptive(&body, tolerance, 1000).unwrap().with_torques(torques).unwrap();
        stepper.step(25.0).unwrap();
        let off = apart(&stepper.body().unwrap().attitude(), &top.at(25.0).unwrap().attitude);
        assert!(off < tolerance, "lean {lean:e} to {tolerance:e}: {off:e}");
    }
}

/// Its torques cancel but for rounding, by which alone it moves.
#[test]
fn a_body_that_hangs_at_rest_takes_few_steps() {
    let hanging = UnitQuaternion::from_euler_angles(0.3, 0.0, 0.7);
    let arm = hanging.inverse() * Vector3::new(0.0, 0.0, -0.3);
    let inertia = Inertia::from_moments(1.0, 2.0, 2.5).unwrap();
    for spin in [0.0, 1e-14, 1e-10, 1e-8] {
        for tolerance in [1e-8, 1e-12, 1e-14] {
            let body = Body::spinning(inertia, hanging, &Vector3::new(spin, spin, spin / 2.0)).unwrap();
            let torques = [Torque::gravity(&arm, 10.0)];
            let mut stepper = Stepper::adaptive(&body, tolerance, 50).unwrap().with_torques(torques).unwrap();
            stepper.step(1.0).unwrap();
            let off = apart(&stepper.body().unwrap().attitude(), &hanging);
            assert!(off < 2.0 * spin + 1e-12, "spin {spin:e} to {tolerance:e}: {off:e}");
        }
    }
}
