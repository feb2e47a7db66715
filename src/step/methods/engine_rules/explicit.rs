//! The rules that take the gyroscopic term as it stands at the start of the step, or leave it out.

use super::turn::{turned, turned_straight};
use crate::body::State;
use crate::number::Analytic;
use crate::step::system::System;
use nalgebra::Vector3;

/// The momentum after the torques alone, at their value at the start.
fn pushed<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> Vector3<T> {
    &start.momentum + system.torque(start).map(|x| x * h.clone())
}

pub(crate) fn constant_spin<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    // A turn about the spin leaves the spin's body components alone: constant in the world, it is constant in
    // the body.
    let momentum = pushed(system, start, h);
    State { attitude: turned(&start.attitude, &system.omega(&momentum), h), momentum }
}

pub(crate) fn semi_implicit<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let momentum = start.plus(&system.rate(start), h.clone()).momentum;
    State { attitude: turned(&start.attitude, &system.omega(&momentum), h), momentum }
}

/// The torques, then the gyroscopic term, then the length as it was between the two.
fn rescaled_momentum<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> Vector3<T> {
    let before = pushed(system, start, h);
    let gyroscopic = before.cross(&system.omega(&before));
    let after = &before + gyroscopic.map(|x| x * h.clone());
    let square = after.dot(&after);
    if square.size() == 0.0 {
        return before;
    }
    let factor = (before.dot(&before) / square).sqrt();
    after.map(|x| x * factor.clone())
}

pub(crate) fn rescaled<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let momentum = rescaled_momentum(system, start, h);
    State { attitude: turned(&start.attitude, &system.omega(&momentum), h), momentum }
}

pub(crate) fn rescaled_straight<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let momentum = rescaled_momentum(system, start, h);
    State { attitude: turned_straight(&start.attitude, &system.omega(&momentum), h), momentum }
}
