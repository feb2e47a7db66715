//! The implicit midpoint rule in a form that keeps every law, and Gauss's collocation of orders 4 and 6
//! ([But64](crate::references), [HLW06](crate::references)), solved by iteration to rounding.

use super::decimal::{ROOT_OF_3, ROOT_OF_15};
use crate::body::{Rate, State};
use crate::error::{Error, Refusal};
use crate::number::Analytic;
use crate::step::system::System;
use crate::{attitude, dynamics::euler};
use nalgebra::{Quaternion, Vector3};

/// The most rounds of an iteration. Where it converges at all it gains a digit in a few rounds.
const ROUNDS: usize = 200;

/// The fixed point of `next`, iterated until it moves by no more than rounding. On power series each round
/// settles one power, until nothing moves at all.
fn fixed_point<S>(
    what: &'static str,
    mut guess: S,
    scale: f64,
    mut next: impl FnMut(&S) -> (S, f64),
    rounding: f64,
) -> Result<S, Error> {
    let mut moved = f64::INFINITY;
    for _ in 0..ROUNDS {
        let before = moved;
        (guess, moved) = next(&guess);
        let at_rounding = moved <= 64.0 * rounding * scale;
        if moved == 0.0 || (at_rounding && moved >= 0.5 * before) {
            return Ok(guess);
        }
        if !moved.is_finite() {
            break;
        }
    }
    Err(Refusal::NotConverged { what, iterations: ROUNDS, residual: moved }.into())
}

fn size<T: Analytic>(v: &Vector3<T>) -> f64 {
    v.as_slice().iter().map(Analytic::size).sum()
}

/// `L' - L = h (M x w + torque)` with `M` the mean of the momenta and `w = J M`, and a turn by half-angle
/// tangents `h w / 2`. That turn, without a torque, is what the rule itself makes of the momentum; so
/// attitude and momentum move as one, and the momentum stays in the world. The torque is taken at the mean of
/// the attitudes.
pub(crate) fn midpoint<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> Result<State<T>, Error> {
    let half = h.clone() / T::integer(2);
    let turn = |mean: &Vector3<T>| {
        let c = system.omega(mean).map(|x| x * half.clone());
        let over = T::one() / (T::one() + c.dot(&c)).sqrt();
        let [x, y, z] = [&c.x, &c.y, &c.z].map(|x| x.clone() * over.clone());
        Quaternion::new(over, x, y, z)
    };
    let kick = |mean: &Vector3<T>| {
        if system.is_free() {
            return Vector3::from_fn(|_, _| T::zero());
        }
        let mut sum = turn(mean).coords;
        sum.w += T::one();
        let length = sum.dot(&sum).sqrt();
        let middle = Quaternion::from_vector(sum.map(|x| x / length.clone()));
        let here = State { attitude: attitude::product(&start.attitude, &middle), momentum: mean.clone() };
        system.torque_after(&here, &half).map(|x| x * half.clone())
    };
    let next = |mean: &Vector3<T>| {
        // By differences of moments, as Euler wrote it: of a needle's products of momentum and spin two
        // nearly cancel.
        let turned = euler::coupling(system.moments(), &system.omega(mean));
        let better = &start.momentum + turned.map(|x| x * half.clone()) + kick(mean);
        let moved = size(&(&better - mean));
        (better, moved)
    };
    let scale = size(&start.momentum);
    let mean = fixed_point("the midpoint of a step", start.momentum.clone(), scale, next, T::rounding())?;
    let turned = turn(&mean);
    let momentum = if system.is_free() {
        attitude::rotate_inverse(&turned, &start.momentum)
    } else {
        &mean + &mean - &start.momentum
    };
    Ok(State { attitude: attitude::product(&start.attitude, &turned), momentum })
}

pub(crate) fn gauss_4<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> Result<State<T>, Error> {
    let quarter = T::one() / T::integer(4);
    let away = ROOT_OF_3.value::<T>() / T::integer(6);
    let half = T::one() / T::integer(2);
    collocated(
        system,
        start,
        h,
        &[[quarter.clone(), quarter.clone() - away.clone()], [quarter.clone() + away, quarter]],
        &[half.clone(), half],
    )
}

pub(crate) fn gauss_6<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> Result<State<T>, Error> {
    let part = |n: u32, below: u32| T::integer(n) / T::integer(below);
    let root = ROOT_OF_15.value::<T>();
    let over = |below: u32| root.clone() / T::integer(below);
    let (side, middle) = (part(5, 36), part(2, 9));
    collocated(
        system,
        start,
        h,
        &[
            [side.clone(), middle.clone() - over(15), side.clone() - over(30)],
            [side.clone() + over(24), middle.clone(), side.clone() - over(24)],
            [side.clone() + over(30), middle + over(15), side],
        ],
        &[part(5, 18), part(4, 9), part(5, 18)],
    )
}

/// The Runge-Kutta method with these coefficients.
fn collocated<T: Analytic, const N: usize>(
    system: &System<T>,
    start: &State<T>,
    h: &T,
    stages: &[[T; N]; N],
    weights: &[T; N],
) -> Result<State<T>, Error> {
    let first = system.rate(start);
    let along = |slopes: &[Rate<T>; N], weights: &[T; N]| {
        slopes
            .iter()
            .zip(weights)
            .fold(start.clone(), |sum, (slope, weight)| sum.plus(slope, h.clone() * weight.clone()))
    };
    // A stage stands at the sum of its weights.
    let times = stages.each_ref().map(|row| row.iter().fold(T::zero(), |sum, x| sum + x.clone()) * h.clone());
    // Both in units of their own: the attitude's length, the momentum's.
    let momentum = match size(&start.momentum) + h.size() * size(&first.momentum) {
        0.0 => 1.0,
        size => size,
    };
    let next = |slopes: &[Rate<T>; N]| {
        let better = core::array::from_fn(|i| system.rate_after(&along(slopes, &stages[i]), &times[i]));
        let moved = slopes.iter().zip(&better).fold(0.0, |sum, (before, after)| {
            let turn = after.attitude.coords.clone() - &before.attitude.coords;
            let turn = turn.iter().map(Analytic::size).sum::<f64>();
            sum + h.size() * (turn + size(&(&after.momentum - &before.momentum)) / momentum)
        });
        (better, moved)
    };
    let guess: [Rate<T>; N] = core::array::from_fn(|_| first.clone());
    let slopes = fixed_point("the stages of a collocation step", guess, 1.0, next, T::rounding())?;
    Ok(along(&slopes, weights))
}
