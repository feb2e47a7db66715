//! The rules by which physics engines turn a free body.
//!
//! They differ in what they do with the gyroscopic term `L x w`: they take it as it stands at the start of
//! the step, or leave it out; they solve implicit Euler's equation by one Newton step, with a torque outside
//! it or inside; or they take the classical Runge-Kutta method for the spin. Those turn the attitude by the
//! spins of their stages, the others by the new spin; all bring it back to length 1 after each step, as the
//! engines do. Torques act as they stand at the start of the step, except in the Runge-Kutta rules.

use super::implicit::cramer;
use super::runge_kutta::{Turning, rk4_in_time};
use crate::attitude;
use crate::body::State;
use crate::number::Analytic;
use crate::step::system::System;
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

/// Applies the torques, then the gyroscopic term, then restores the length that the momentum had between the
/// two; `turned` turns the attitude by the new spin.
pub(crate) fn rescaled<T: Analytic>(
    system: &System<T>,
    start: &State<T>,
    h: &T,
    turned: impl Fn(&Quaternion<T>, &Vector3<T>, &T) -> Quaternion<T>,
) -> State<T> {
    let before = pushed(system, start, h);
    let gyroscopic = before.cross(&system.omega(&before));
    let after = &before + gyroscopic.map(|x| x * h.clone());
    let square = after.dot(&after);
    let momentum = if square.size() == 0.0 {
        before
    } else {
        let factor = (before.dot(&before) / square).sqrt();
        after.map(|x| x * factor.clone())
    };
    State { attitude: turned(&start.attitude, &system.omega(&momentum), h), momentum }
}

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
    let change = solved(system, start, h, &impulse, &system.sum.damping);
    ended(system, start, h, &change)
}

/// Runge-Kutta 4 for the momentum in body axes and for the turn since the start, whose rate is
/// `turn_rate(turn, spin)`.
pub(crate) fn runge_kutta_4<T: Analytic>(
    system: &System<T>,
    start: &State<T>,
    h: &T,
    turn_rate: impl Fn(&Vector3<T>, &Vector3<T>) -> Vector3<T>,
) -> State<T> {
    let rate = |Turning { turn, momentum }: &Turning<T>, time: &T| {
        // A free body's momentum does not depend on the attitude.
        let attitude = if system.is_free() {
            start.attitude.clone()
        } else {
            attitude::product(&start.attitude, &attitude::turn(turn))
        };
        let here = State { attitude, momentum: momentum.clone() };
        Turning {
            turn: turn_rate(turn, &system.omega(momentum)),
            momentum: system.rate_after(&here, time).momentum,
        }
    };
    let end = rk4_in_time(&Turning::from(&start.momentum), h, rate, Turning::plus);
    State { attitude: turned(&start.attitude, &end.turn, &T::one()), momentum: end.momentum }
}

/// The rate of the rotation vector `v`, for the spin `w` in the axes that it turns: `w + v x w / 2 + c v x
/// (v x w)`, with `c = (1 - (|v|/2) cot(|v|/2)) / |v|^2`. It is infinite at whole turns.
pub(crate) fn turn_rate<T: Analytic>(turn: &Vector3<T>, omega: &Vector3<T>) -> Vector3<T> {
    let once = turn.cross(omega);
    let half = turn.map(|x| x / T::integer(2));
    let square = half.dot(&half);
    let quarter = curvature(&square) / T::integer(4);
    let twice = turn.cross(&once).map(|x| x * quarter.clone());
    omega + once.map(|x| x / T::integer(2)) + twice
}

/// Coefficients of `(1 - x cot x) / x^2` in powers of `x^2`, numerator and two factors of the denominator
/// ([DLMF](crate::references), 4.19.6).
const COEFFICIENTS: [[u32; 3]; 10] = [
    [1, 3, 1],
    [1, 45, 1],
    [2, 945, 1],
    [1, 4725, 1],
    [2, 93_555, 1],
    [1382, 638_512_875, 1],
    [4, 18_243_225, 1],
    [3617, 66_976_875, 2431],
    [87_734, 843_908_625, 46_189],
    [349_222, 3_013_959_375, 508_079],
];

/// `(1 - x cot x) / x^2` from the square of `x`.
fn curvature<T: Analytic>(square: &T) -> T {
    // Where the difference cancels, its series: each term is below 1/39 of the one before.
    if square.size() <= 0.25 {
        return COEFFICIENTS.iter().rev().fold(T::zero(), |sum, &[n, d, e]| {
            sum * square.clone() + T::integer(n) / (T::integer(d) * T::integer(e))
        });
    }
    let (cosine, sinc) = square.cos_sinc_of_root();
    (T::one() - cosine / sinc) / square.clone()
}

#[cfg(test)]
mod tests {
    use super::*;

    // u = x cot x solves x u' = u - u^2 - x^2, so that (2n + 1) b_n = [n = 1] + sum b_k b_(n-k).
    #[test]
    fn the_coefficients_of_the_cotangent_follow_from_its_differential_equation() {
        let b = COEFFICIENTS.map(|[n, d, e]| f64::from(n) / (f64::from(d) * f64::from(e)));
        for n in 1..=b.len() {
            let crossed: f64 = (1..n).map(|k| b[k - 1] * b[n - k - 1]).sum();
            let first = if n == 1 { 1.0 } else { 0.0 };
            let odd = f64::from(u32::try_from(2 * n + 1).unwrap());
            assert!((odd * b[n - 1] / (first + crossed) - 1.0).abs() < 1e-14, "{n}");
        }
    }

    #[test]
    fn the_series_of_the_cotangent_and_the_cotangent_meet() {
        for x in [0.5_f64, 0.499, 0.4] {
            let direct = (1.0 - x / x.tan()) / (x * x);
            assert!((curvature(&(x * x)) / direct - 1.0).abs() < 1e-14);
        }
        let x = 0.5_f64.next_up();
        assert!((curvature(&(x * x)) / curvature(&0.25) - 1.0).abs() < 1e-14);
    }
}
