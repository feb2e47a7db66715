//! The steppers under gravity, judged by the closed form of Lagrange's top.

use super::adaptive;
use nalgebra::{UnitQuaternion, Vector3};
use tumbling::exact::LagrangeTop;
use tumbling::step::{Method, State, Stepper, System, Torque};
use tumbling::{Body, Inertia};

const ARM: Vector3<f64> = Vector3::new(0.0, 0.0, 0.4);
const WEIGHT: f64 = 1.7;

/// A top that loops.
fn looping() -> (Body, LagrangeTop) {
    let leaning = UnitQuaternion::from_euler_angles(0.6, 0.3, -0.8);
    let inertia = Inertia::from_moments(0.9, 0.9, 0.5).unwrap();
    let body = Body::spinning(inertia, leaning, &Vector3::new(-0.7, 0.2, 4.0)).unwrap();
    (body, LagrangeTop::of(&body, &ARM, WEIGHT).unwrap())
}

fn apart(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    (a.coords - b.coords).norm().min((a.coords + b.coords).norm())
}

#[test]
fn methods_of_high_order_converge_to_the_closed_form_of_the_top() {
    let (body, top) = looping();
    for (method, order, counts) in
        [(Method::Gauss6, 6, [40, 80]), (Method::RungeKutta4, 4, [100, 200]), (Method::Gauss4, 4, [60, 120])]
    {
        let [coarse, fine] = counts.map(|count| {
            let torques = [Torque::gravity(&ARM, WEIGHT)];
            let mut stepper = Stepper::new(&body, method).unwrap().with_torques(torques).unwrap();
            stepper
                .run(6.0 / f64::from(count), count as usize)
                .try_for_each(|state| state.map(drop))
                .unwrap();
            apart(&stepper.body().unwrap().attitude(), &top.attitude(6.0).unwrap())
        });
        let seen = (coarse / fine).log2();
        assert!((seen - f64::from(order)).abs() < 0.4, "{method:?}: {seen}, {coarse:e} {fine:e}");
    }
}

#[test]
fn a_controlled_run_meets_the_closed_form_of_the_top() {
    let (body, top) = looping();
    let moments = Vector3::new(0.9, 0.9, 0.5).try_into().unwrap();
    let system = System::with(moments, vec![Torque::gravity(&ARM, WEIGHT)]).unwrap();
    for t in [9.0, -9.0] {
        for tolerance in [1e-4, 1e-8, 1e-12] {
            let State { attitude, .. } =
                adaptive(&system, &body.state(), t, tolerance, &mut 1_000_000).unwrap();
            let off = apart(&UnitQuaternion::new_unchecked(attitude), &top.attitude(t).unwrap());
            assert!(off < 16.0 * tolerance + 1e-13, "{tolerance:e}: {off:e}");
        }
    }
}
