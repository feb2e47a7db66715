//! Turns by an averaged spin: Buss's augmented method, and SPIRAL in its synchronous form. With a torque, the
//! free step lies between two half kicks: a constant torque during the step would reduce the order.

use crate::body::State;
use crate::number::Analytic;
use crate::step::system::System;
use crate::{attitude, dynamics::euler};
use nalgebra::Vector3;

/// Buss's augmented method of second order [Bus00](crate::references): one turn for each step by an averaged
/// spin, with a term for the fact that rotations do not commute.
pub(crate) fn buss<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    system.between_half_kicks(start, h, |start| {
        let omega = system.omega(&start.momentum);
        let none = Vector3::from_fn(|_, _| T::zero());
        let change = euler::angular_acceleration(system.moments(), &omega, &none);
        // h (w + h w'/2 + h^2 w' x w / 12), along the axes at the start.
        let half = h.clone() / T::integer(2);
        let twelfth = h.clone() * h.clone() / T::integer(12);
        let mean =
            &omega + change.map(|x| x * half.clone()) + change.cross(&omega).map(|x| x * twelfth.clone());
        let turned = attitude::turn(&mean.map(|x| x * h.clone()));
        let momentum = attitude::rotate_inverse(&turned, &start.momentum);
        State { attitude: attitude::product(&start.attitude, &turned), momentum }
    })
}

/// SPIRAL in its synchronous form [Val24](crate::references): a turn by the spin, then one by how it changes;
/// the spin by a Runge-Kutta method of third order.
///
/// Its authors state third order. That holds for its spin, but the error of its attitude is of second order,
/// as a test on power series shows. The order of a method is the lowest of its orders.
pub(crate) fn spiral<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    system.between_half_kicks(start, h, |start| {
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
        State { attitude: attitude::product(&start.attitude, &turned), momentum: system.momentum(&end) }
    })
}
