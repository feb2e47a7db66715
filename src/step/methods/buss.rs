//! Buss's augmented method of second order [Bus00](crate::references): one turn a step by an averaged spin, with the term by which turns do
//! not commute.

use super::method::{About, Keeps};
use super::rk4::Motion;
use super::system::System;
use crate::scalar::Analytic;
use crate::{attitude, euler};
use nalgebra::Vector3;

pub(super) const ABOUT: About = About {
    name: "Buss's augmented",
    order: 2,
    implicit: false,
    keeps: Keeps { momentum: true, direction: true, unit: true, ..Keeps::NOTHING },
    source: "Bus00",
};

/// With a torque, between two half kicks of it.
pub(super) fn step<T: Analytic>(system: &System<T>, start: &Motion<T>, h: &T) -> Motion<T> {
    let half = h.clone() / T::integer(2);
    let start = system.kicked(start, &half);
    let omega = system.omega(&start.vector);
    let none = Vector3::from_fn(|_, _| T::zero());
    let change = euler::angular_acceleration(system.moments(), &omega, &none);
    // h (w + h w'/2 + h^2 w' x w / 12), along the axes at the start.
    let twelfth = h.clone() * h.clone() / T::integer(12);
    let mean = &omega + change.map(|x| x * half.clone()) + change.cross(&omega).map(|x| x * twelfth.clone());
    let turned = attitude::turn(&mean.map(|x| x * h.clone()));
    let vector = attitude::seen_from(&turned, &start.vector);
    system.kicked_back(&Motion { attitude: attitude::product(&start.attitude, &turned), vector }, &half)
}
