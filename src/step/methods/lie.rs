//! Runge-Kutta in the turn itself, after Munthe-Kaas [MK98](crate::references): the attitude stays a
//! rotation, and the momentum stays where it was in the world.

use crate::attitude;
use crate::body::State;
use crate::number::Analytic;
use crate::step::system::System;
use nalgebra::Vector3;

/// Seen from the body's axes at the start: the turn since then, and the momentum.
struct Part<T: nalgebra::Scalar> {
    turn: Vector3<T>,
    momentum: Vector3<T>,
}

pub(crate) fn step<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let none = Vector3::from_fn(|_, _| T::zero());
    let at = |turn: &Vector3<T>, momentum: &Vector3<T>| {
        let turned = attitude::turn(turn);
        let momentum = attitude::rotate_inverse(&turned, momentum);
        State { attitude: attitude::product(&start.attitude, &turned), momentum }
    };
    // The rate of a rotation momentum v for a spin w in the turning axes: w + v x w / 2 + v x (v x w) / 12
    // and terms that the fourth order does not see.
    let rate = |turn: &Vector3<T>, momentum: &Vector3<T>, time: &T| {
        let here = at(turn, momentum);
        let omega = system.omega(&here.momentum);
        let across = turn.cross(&omega);
        let again = turn.cross(&across);
        let part = |x: &T, n: u32| x.clone() / T::integer(n);
        let slope = omega + across.map(|x| part(&x, 2)) + again.map(|x| part(&x, 12));
        // Without torque the momentum does not move, seen from axes that do not.
        let push = if system.is_free() {
            none.clone()
        } else {
            let back = attitude::turn(&-turn.clone_owned());
            attitude::rotate_inverse(&back, &system.torque_after(&here, time))
        };
        Part { turn: slope, momentum: push }
    };
    let along = |k: &Part<T>, time: &T| {
        let turn = k.turn.map(|x| x * time.clone());
        (turn, &start.momentum + k.momentum.map(|x| x * time.clone()))
    };
    let half = h.clone() / T::integer(2);
    let k1 = rate(&none, &start.momentum, &T::zero());
    let (turn, momentum) = along(&k1, &half);
    let k2 = rate(&turn, &momentum, &half);
    let (turn, momentum) = along(&k2, &half);
    let k3 = rate(&turn, &momentum, &half);
    let (turn, momentum) = along(&k3, h);
    let k4 = rate(&turn, &momentum, h);
    let mean = |a: &Vector3<T>, b: &Vector3<T>, c: &Vector3<T>, d: &Vector3<T>| {
        let middle = b + c;
        (a + d + &middle + &middle).map(|x| x * h.clone() / T::integer(6))
    };
    let turn = mean(&k1.turn, &k2.turn, &k3.turn, &k4.turn);
    let push = mean(&k1.momentum, &k2.momentum, &k3.momentum, &k4.momentum);
    at(&turn, &(&start.momentum + push))
}
