//! The classical Runge-Kutta step, as the right engine takes it: what it keeps, and where it must be.

use super::spinning;
use crate::common::*;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;
use tumbling::step::{Engine, rk4};
use tumbling::{Body, Inertia, attitude};

proptest! {
    #[test]
    fn the_right_engine_keeps_energy_and_momentum(m in moments(), q in attitude(), omega in vector(1.0)) {
        prop_assume!(omega.norm() > 0.1);
        let start = Body::spinning(Inertia::from_moments(m.x, m.y, m.z).unwrap(), q, &omega).unwrap();
        let end = *Engine::Turned.run(&start, 0.002, 1000).unwrap().last().unwrap();
        prop_assert!((end.energy() / start.energy() - 1.0).abs() < 1e-9);
        prop_assert!((end.momentum_world() - start.momentum_world()).norm() < 1e-12);
    }
}

/// Where the book's box, started at (1, 1, 0), must be when its spin about x has vanished: energy and
/// |L|² give two linear equations for the squares of the other two components.
#[test]
fn a_quarter_period_after_the_start_the_spin_is_where_the_two_conserved_quantities_put_it() {
    let (a, b, c) = (10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0);
    let twice_energy: f64 = a + b;
    let momentum_squared = a * a + b * b;
    let y_squared = (momentum_squared - c * twice_energy) / (b * (b - c));
    let z_squared = (b * twice_energy - momentum_squared) / (c * (b - c));

    let start = spinning([a, b, c], &Vector3::new(1.0, 1.0, 0.0));
    let flight = Engine::Turned.run(&start, 0.0005, 4200).unwrap();
    let moment = flight.windows(2).find(|pair| pair[1].omega_body().x <= 0.0).unwrap();
    let (before, after) = (moment[0].omega_body(), moment[1].omega_body());
    let share = before.x / (before.x - after.x);
    let spin = before + (after - before) * share;
    assert!((spin.y - y_squared.sqrt()).abs() < 1e-6 && (spin.z + z_squared.sqrt()).abs() < 1e-6, "{spin:?}");
}

/// On a steady spin the attitude's equation is linear, and one step is the exponential to fourth order.
#[test]
fn one_step_of_a_steady_spin_is_the_exponential_series_to_fourth_order_and_no_further() {
    let spin = Vector3::new(0.6, -0.3, 0.5);
    let law = |q: &Quaternion<f64>| attitude::rate(q, &spin);
    let error = |h: f64| {
        let stepped = rk4(&Quaternion::identity(), h, law, |q, rate, h: f64| q + rate * h);
        let exact = UnitQuaternion::from_scaled_axis(spin * h).into_inner();
        (stepped.coords - exact.coords).norm()
    };
    let order = (error(0.4) / error(0.2)).log2();
    assert!((order - 5.0).abs() < 0.1, "local order {order}");
}
