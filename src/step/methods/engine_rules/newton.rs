//! Implicit Euler, cut short after one Newton step: with a torque beside it, and with the torque inside.

use super::super::method::{About, Keeps};
use super::super::rk4::Motion;
use super::super::system::System;
use super::turn::turned;
use crate::scalar::Analytic;
use nalgebra::Vector3;

pub(in super::super) const ONE_NEWTON: About = About {
    name: "one Newton step",
    order: 1,
    implicit: true,
    keeps: Keeps { unit: true, ..Keeps::NOTHING },
    source: "Cat15",
};

pub(in super::super) const LINEARISED: About = About {
    name: "linearised implicit",
    order: 1,
    implicit: true,
    keeps: Keeps { unit: true, ..Keeps::NOTHING },
    source: "MuJoCo's implicit and implicitfast",
};

/// The change of spin that solves `(I + h D + h C) dw = impulse`, with `D = [w]x I - [I w]x` the derivative of `w x I w` and `C` the
/// drag along each axis.
fn solved<T: Analytic>(
    system: &System<T>,
    start: &Motion<T>,
    h: &T,
    impulse: &Vector3<T>,
    drag: &Vector3<T>,
) -> Vector3<T> {
    let omega = system.omega(&start.vector);
    let columns: [Vector3<T>; 3] = std::array::from_fn(|k| {
        let axis = Vector3::from_fn(|i, _| if i == k { T::one() } else { T::zero() });
        let moment = axis.map(|x| x * system.moments()[k].clone());
        let slope = omega.cross(&moment) - start.vector.cross(&axis) + axis.map(|x| x * drag[k].clone());
        moment + slope.map(|x| x * h.clone())
    });
    let [a, b, c] = &columns;
    // Cramer's rule: three unknowns, any number type.
    let (bc, ca, ab) = (b.cross(c), c.cross(a), a.cross(b));
    let determinant = a.dot(&bc);
    Vector3::new(bc.dot(impulse), ca.dot(impulse), ab.dot(impulse)).map(|x| x / determinant.clone())
}

fn ended<T: Analytic>(system: &System<T>, start: &Motion<T>, h: &T, change: &Vector3<T>) -> Motion<T> {
    let omega = system.omega(&start.vector) + change;
    Motion { attitude: turned(&start.attitude, &omega, h), vector: system.momentum(&omega) }
}

pub(in super::super) fn one_newton<T: Analytic>(system: &System<T>, start: &Motion<T>, h: &T) -> Motion<T> {
    let gyroscopic = start.vector.cross(&system.omega(&start.vector));
    let none = Vector3::from_fn(|_, _| T::zero());
    let turned = solved(system, start, h, &gyroscopic.map(|x| x * h.clone()), &none);
    let pushed = system.omega(&system.torque(start)).map(|x| x * h.clone());
    ended(system, start, h, &(turned + pushed))
}

pub(in super::super) fn linearised<T: Analytic>(system: &System<T>, start: &Motion<T>, h: &T) -> Motion<T> {
    let impulse = system.rate(start).vector.map(|x| x * h.clone());
    let change = solved(system, start, h, &impulse, &system.drag());
    ended(system, start, h, &change)
}
