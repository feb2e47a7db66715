//! SPIRAL in its synchronous form [Val24](crate::references): a turn by the spin, then one by how it changes;
//! the spin by a Runge-Kutta method of third order.

use crate::body::State;
use crate::number::Analytic;
use crate::step::system::System;
use crate::{attitude, dynamics::euler};
use nalgebra::Vector3;

/// Its authors call it of third order: so is its spin, but the error of its attitude falls with the square of
/// the step, as a test on power series shows. The order of a method is that of the worst.
/// With a torque, between two half kicks of it: a torque held for the whole step would cost an order.
pub(crate) fn step<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let half = h.clone() / T::integer(2);
    let start = system.kick(start, half.clone());
    let omega = system.omega(&start.momentum);
    let none = Vector3::from_fn(|_, _| T::zero());
    let change = |omega: &Vector3<T>| {
        euler::angular_acceleration(system.moments(), omega, &none).map(|x| x * h.clone())
    };
    let over = |x: &Vector3<T>, n: u32| x.map(|x| x / T::integer(n));
    let k1 = change(&omega);
    let k2 = change(&(&omega + &k1));
    let k3 = change(&(&omega + over(&(&k1 + &k2), 4)));
    let end = &omega + over(&(&k1 + &k2), 6) + over(&k3, 6).map(|x| x * T::integer(4));
    let first = attitude::turn(&omega.map(|x| x * h.clone()));
    let second = attitude::turn(&k1.map(|x| x * h.clone() / T::integer(2)));
    let turned = attitude::product(&first, &second);
    let end =
        State { attitude: attitude::product(&start.attitude, &turned), momentum: system.momentum(&end) };
    system.adjoint_kick(&end, half)
}
