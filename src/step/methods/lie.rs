//! Runge-Kutta in the turn itself, after Munthe-Kaas [MK98](crate::references): the attitude stays a
//! rotation, and the momentum stays where it was in the world.

use super::rk4::{Turning, rk4_in_time};
use crate::attitude;
use crate::body::State;
use crate::number::Analytic;
use crate::step::system::System;

/// The momentum is seen from the body's axes at the start.
pub(crate) fn step<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let at = |Turning { turn, momentum }: &Turning<T>| {
        let turned = attitude::turn(turn);
        let momentum = attitude::rotate_inverse(&turned, momentum);
        State { attitude: attitude::product(&start.attitude, &turned), momentum }
    };
    // The rate of a rotation vector v for a spin w in the turning axes: w + v x w / 2 + v x (v x w) / 12 and
    // terms of a higher order.
    let rate = |part: &Turning<T>, time: &T| {
        let here = at(part);
        let omega = system.omega(&here.momentum);
        let once = part.turn.cross(&omega);
        let twice = part.turn.cross(&once);
        let turn = omega + once.map(|x| x / T::integer(2)) + twice.map(|x| x / T::integer(12));
        // Without torque the momentum does not move, seen from axes that do not.
        let momentum = if system.is_free() {
            turn.map(|_| T::zero())
        } else {
            let back = attitude::turn(&-part.turn.clone_owned());
            attitude::rotate_inverse(&back, &system.torque_after(&here, time))
        };
        Turning { turn, momentum }
    };
    at(&rk4_in_time(&Turning::from(&start.momentum), h, rate, Turning::plus))
}
