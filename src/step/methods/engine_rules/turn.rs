//! Turning an attitude by a spin.

use crate::attitude;
use crate::number::Analytic;
use nalgebra::{Quaternion, Vector3};

/// A quaternion brought to length 1.
fn unit<T: Analytic>(q: &Quaternion<T>) -> Quaternion<T> {
    let norm = q.coords.dot(&q.coords).sqrt();
    Quaternion::from_vector(q.coords.map(|x| x / norm.clone()))
}

/// `start` turned by the constant spin `omega` (body axes) for the time `h`: the exponential map.
pub(crate) fn turned<T: Analytic>(start: &Quaternion<T>, omega: &Vector3<T>, h: &T) -> Quaternion<T> {
    unit(&attitude::product(start, &attitude::turn(&omega.map(|x| x * h.clone()))))
}

/// `start` moved straight along its rate for the time `h` and brought back to length 1. It turns about the
/// right axis, by `2 atan(|w| h / 2)` instead of `|w| h`.
pub(crate) fn turned_straight<T: Analytic>(
    start: &Quaternion<T>,
    omega: &Vector3<T>,
    h: &T,
) -> Quaternion<T> {
    let half = h.clone() / T::integer(2);
    let [x, y, z] = [0, 1, 2].map(|i| omega[i].clone() * half.clone());
    unit(&attitude::product(start, &Quaternion::new(T::one(), x, y, z)))
}
