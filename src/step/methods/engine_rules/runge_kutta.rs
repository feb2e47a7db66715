//! The classical Runge-Kutta method for the spin, with the attitude turned and not added to; with the rates
//! of the turn corrected, or not.

use super::turn::turned;
use crate::attitude;
use crate::body::State;
use crate::number::Analytic;
use crate::step::methods::rk4::{Turning, rk4_in_time};
use crate::step::system::System;
use nalgebra::Vector3;

pub(crate) fn mean_spin<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    stepped(system, start, h, |_, omega| omega.clone())
}

pub(crate) fn corrected<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    stepped(system, start, h, turn_rate)
}

/// Runge-Kutta 4 for the momentum in body axes and for the turn since the start, whose rate is
/// `turn_rate(turn, spin)`.
fn stepped<T: Analytic>(
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
fn turn_rate<T: Analytic>(turn: &Vector3<T>, omega: &Vector3<T>) -> Vector3<T> {
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
