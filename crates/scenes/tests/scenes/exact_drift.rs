//! The exact drift between kicks, against motions that are known exactly.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::exact::FreeMotion;
use tumbling::step::{State, System, Torque};
use tumbling_scenes::exact_drift;

fn apart(a: &State<f64>, b: &State<f64>) -> f64 {
    let (p, q) = (a.attitude.coords, b.attitude.coords);
    (p - q).norm().min((p + q).norm()) + (a.momentum - b.momentum).norm() / b.momentum.norm()
}

/// That it goes to the truth with the square of the step.
fn goes_to(truth: &State<f64>, system: &System<f64>, from: &State<f64>, t: f64) {
    let errors = [500, 1000, 2000].map(|count| {
        let end =
            (0..count).try_fold(*from, |state, _| exact_drift::step(system, &state, t / f64::from(count)));
        apart(&end.unwrap(), truth)
    });
    for pair in errors.windows(2) {
        assert!((pair[0] / pair[1] - 4.0).abs() < 0.1, "{errors:?}");
    }
}

#[test]
fn drag_in_proportion_to_the_momentum_slows_the_free_motion_down() {
    // L' = L x w - c L: the spin is e^(-ct) times the free one at the time (1 - e^(-ct))/c. Substitute and
    // see.
    let (moments, omega, c, t) = (Vector3::new(1.0, 2.0, 2.6), Vector3::new(0.4, 1.5, -0.3), 0.3_f64, 4.0);
    let system = System::with(moments.try_into().unwrap(), vec![Torque::Damping(moments * c)]).unwrap();
    let left = (-c * t).exp();
    let free = FreeMotion::new(moments.try_into().unwrap(), &omega).unwrap().at((1.0 - left) / c).unwrap();
    let truth =
        State { attitude: free.attitude.into_inner(), momentum: system.momentum(&(free.omega * left)) };
    let from = State { attitude: Quaternion::identity(), momentum: system.momentum(&omega) };
    goes_to(&truth, &system, &from, t);
}

#[test]
fn a_heavy_top_precesses_steadily_where_weight_and_spin_balance() {
    // Tilt theta, precession P about the vertical, spin s about the axis: (C - A) P^2 cos theta + C s P =
    // weight times arm.
    let (a, c, tilt, precession, spin, t) = (2.0, 1.0, 0.6_f64, 1.3, 5.0, 3.0);
    let pull = (c - a) * precession * precession * tilt.cos() + c * spin * precession;
    let arm = 0.25;
    let gravity = Torque::gravity(&Vector3::new(0.0, 0.0, arm), pull / arm);
    let system = System::with([a, a, c].try_into().unwrap(), vec![gravity]).unwrap();
    let about = UnitQuaternion::from_axis_angle;
    let at = |t: f64| {
        let attitude = about(&Vector3::z_axis(), precession * t)
            * about(&Vector3::x_axis(), tilt)
            * about(&Vector3::z_axis(), spin * t);
        let omega = attitude.inverse() * Vector3::z() * precession + Vector3::z() * spin;
        State { attitude: attitude.into_inner(), momentum: system.momentum(&omega) }
    };
    goes_to(&at(t), &system, &at(0.0), t);
}

#[test]
fn loss_inside_a_body_keeps_its_momentum_and_ends_on_the_largest_moment() {
    // Explorer 1, 1958: spun about its long axis, it ended tumbling end over end.
    let moments = Vector3::new(0.2, 2.0, 2.1);
    let system = System::with(moments.try_into().unwrap(), vec![Torque::Dissipation(2.0)]).unwrap();
    let from = State { attitude: Quaternion::identity(), momentum: Vector3::new(1.0, 0.01, 0.02) };
    let l = from.momentum.norm();
    let energy = |motion: &State<f64>| 0.5 * motion.momentum.dot(&system.omega(&motion.momentum));
    let mut motion = from;
    let mut before = energy(&motion);
    for _ in 0..60_000 {
        motion = exact_drift::step(&system, &motion, 0.01).unwrap();
        let now = energy(&motion);
        assert!(now <= before * (1.0 + 1e-14), "{now} after {before}");
        before = now;
    }
    assert!((motion.momentum.norm() / l - 1.0).abs() < 1e-10);
    assert!((before / (0.5 * l * l / 2.1) - 1.0).abs() < 1e-6, "{before}");
}

#[test]
fn a_body_that_drag_brings_to_rest_stays_there_however_long() {
    // Ten minutes at 60 Hz: the momentum falls by e^-600, below where squares of it are numbers.
    let moments = Vector3::new(1.0, 2.0, 2.6);
    let system =
        System::with(moments.try_into().unwrap(), vec![Torque::Damping(moments), Torque::Dissipation(0.1)])
            .unwrap();
    let mut state = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.1, 2.0, 0.3) };
    for _ in 0..60 * 800 {
        state = exact_drift::step(&system, &state, 1.0 / 60.0).unwrap();
    }
    assert!(state.momentum.norm() < 1e-300 && (state.attitude.norm() - 1.0).abs() < 1e-9, "{state:?}");
}

proptest! {
    #[test]
    fn no_input_makes_it_panic_and_no_answer_is_infinite(
        moments in prop::array::uniform3(any::<f64>()), momentum in prop::array::uniform3(any::<f64>()),
        q in prop::array::uniform4(any::<f64>()), h in any::<f64>(),
    ) {
        let from = State { attitude: Quaternion::new(q[0], q[1], q[2], q[3]), momentum: momentum.into() };
        let system = System::of_numbers(moments.into(), vec![Torque::InBody(Vector3::x())]);
        if let Ok(end) = exact_drift::step(&system, &from, h) {
            prop_assert!(end.attitude.coords.iter().chain(&end.momentum).all(|x| x.is_finite()), "{end:?}");
        }
    }
}
