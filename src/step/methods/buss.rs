//! Buss's augmented method of second order [Bus00](crate::references): one turn a step by an averaged spin,
//! with the term by which turns do not commute.

use crate::body::State;
use crate::number::Analytic;
use crate::step::system::System;
use crate::{attitude, dynamics::euler};
use nalgebra::Vector3;

/// With a torque, between two half kicks of it.
pub(crate) fn step<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let half = h.clone() / T::integer(2);
    let start = system.kick(start, half.clone());
    let omega = system.omega(&start.momentum);
    let none = Vector3::from_fn(|_, _| T::zero());
    let change = euler::angular_acceleration(system.moments(), &omega, &none);
    // h (w + h w'/2 + h^2 w' x w / 12), along the axes at the start.
    let twelfth = h.clone() * h.clone() / T::integer(12);
    let mean = &omega + change.map(|x| x * half.clone()) + change.cross(&omega).map(|x| x * twelfth.clone());
    let turned = attitude::turn(&mean.map(|x| x * h.clone()));
    let momentum = attitude::rotate_inverse(&turned, &start.momentum);
    system.adjoint_kick(&State { attitude: attitude::product(&start.attitude, &turned), momentum }, half)
}
