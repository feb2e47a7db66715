//! Implicit Euler, cut short after one Newton step: with a torque outside it, and with the torque inside.

use super::turn::turned;
use crate::body::State;
use crate::number::Analytic;
use crate::step::methods::implicit::cramer;
use crate::step::system::System;
use nalgebra::Vector3;

/// The change of spin that solves `(I + h D + h C) dw = impulse`, with `D = [w]x I - [I w]x` the derivative
/// of `w x I w` and `C` the drag along each axis.
fn solved<T: Analytic>(
    system: &System<T>,
    start: &State<T>,
    h: &T,
    impulse: &Vector3<T>,
    drag: &Vector3<T>,
) -> Vector3<T> {
    let omega = system.omega(&start.momentum);
    let columns: [Vector3<T>; 3] = core::array::from_fn(|k| {
        let axis = Vector3::from_fn(|i, _| if i == k { T::one() } else { T::zero() });
        let moment = axis.map(|x| x * system.moments()[k].clone());
        let rate = omega.cross(&moment) - start.momentum.cross(&axis) + axis.map(|x| x * drag[k].clone());
        moment + rate.map(|x| x * h.clone())
    });
    cramer(columns, impulse)
}

fn ended<T: Analytic>(system: &System<T>, start: &State<T>, h: &T, change: &Vector3<T>) -> State<T> {
    let omega = system.omega(&start.momentum) + change;
    State { attitude: turned(&start.attitude, &omega, h), momentum: system.momentum(&omega) }
}

pub(crate) fn one_newton<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let gyroscopic = start.momentum.cross(&system.omega(&start.momentum));
    let none = Vector3::from_fn(|_, _| T::zero());
    let turned = solved(system, start, h, &gyroscopic.map(|x| x * h.clone()), &none);
    let pushed = system.omega(&system.torque(start)).map(|x| x * h.clone());
    ended(system, start, h, &(turned + pushed))
}

pub(crate) fn linearised<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let impulse = system.rate(start).momentum.map(|x| x * h.clone());
    let change = solved(system, start, h, &impulse, &system.sum_of_torques().damping);
    ended(system, start, h, &change)
}
