//! Runge-Kutta methods: for attitude and momentum, of orders 1, 4 [Kut01](crate::references) and 5
//! [DP80](crate::references); and of order 4 for the rotation vector since the start of the step
//! [MK98](crate::references).

use super::implicit::ratio;
use crate::attitude;
use crate::body::{Rate, State, along};
use crate::number::{Analytic, Field};
use crate::step::system::System;
use nalgebra::Vector3;

/// Straight ahead along the rates at the start.
pub(crate) fn euler<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    start.plus(&system.rate(start), h.clone())
}

/// One step of `h` seconds from `start` under the law `rate`, where `plus` moves a state along a rate. Errors
/// fall as `h^4`.
///
/// The length of the attitude is not restored: its drift shows the size of the error.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// use tumbling::{PrincipalMoments, step::{State, System, rk4}};
/// let system = System::free(PrincipalMoments::new(1.0, 2.0, 2.5)?)?;
/// // A steady spin of 2 rad/s about z, for 0.1 s: a turn by 0.2 rad.
/// let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.0, 0.0, 5.0) };
/// let end = rk4(&start, 0.1, |state| system.rate(state), State::plus);
/// assert!((end.attitude.k - 0.1_f64.sin()).abs() < 1e-7);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[must_use]
pub fn rk4<S, R, T: Field>(start: &S, h: T, rate: impl Fn(&S) -> R, plus: impl Fn(&S, &R, T) -> S) -> S {
    let half = h.clone() / T::integer(2);
    let k1 = rate(start);
    let k2 = rate(&plus(start, &k1, half.clone()));
    let k3 = rate(&plus(start, &k2, half));
    let k4 = rate(&plus(start, &k3, h.clone()));
    let sixth = h.clone() / T::integer(6);
    let third = h / T::integer(3);
    let first = plus(start, &k1, sixth.clone());
    plus(&plus(&plus(&first, &k2, third.clone()), &k3, third), &k4, sixth)
}

/// [`rk4`] under a law of the time since the start too.
pub(super) fn rk4_in_time<S: Clone, R, T: Field>(
    start: &S,
    h: &T,
    rate: impl Fn(&S, &T) -> R,
    plus: impl Fn(&S, &R, T) -> S,
) -> S {
    let rate = |(state, time): &(S, T)| rate(state, time);
    let plus = |(state, time): &(S, T), rate: &R, h: T| (plus(state, rate, h.clone()), time.clone() + h);
    rk4(&(start.clone(), T::zero()), h.clone(), rate, plus).0
}

/// One step of a body.
pub(crate) fn rk4_step<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    rk4_in_time(start, h, |state, time| system.rate_after(state, time), State::plus)
}

/// The turn since the start of a step, by axis and angle, and a momentum; or their rates.
#[derive(Clone)]
pub(crate) struct Turning<T: nalgebra::Scalar> {
    pub(crate) turn: Vector3<T>,
    pub(crate) momentum: Vector3<T>,
}

impl<T: Analytic> Turning<T> {
    /// The start of a step from this momentum.
    pub(crate) fn from(momentum: &Vector3<T>) -> Self {
        Self { turn: Vector3::from_fn(|_, _| T::zero()), momentum: momentum.clone() }
    }

    pub(crate) fn plus(&self, rate: &Self, h: T) -> Self {
        Self { turn: along(&self.turn, &rate.turn, &h), momentum: along(&self.momentum, &rate.momentum, &h) }
    }
}

/// The momentum is seen from the body's axes at the start.
pub(crate) fn munthe_kaas<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
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

/// An integer over another.
type Ratio = (i32, u32);

/// Each stage's weights of the rates before it. The last row is the step of order 5.
const STAGES: [&[Ratio]; 6] = [
    &[(1, 5)],
    &[(3, 40), (9, 40)],
    &[(44, 45), (-56, 15), (32, 9)],
    &[(19_372, 6561), (-25_360, 2187), (64_448, 6561), (-212, 729)],
    &[(9017, 3168), (-355, 33), (46_732, 5247), (49, 176), (-5103, 18_656)],
    &[(35, 384), (0, 1), (500, 1113), (125, 192), (-2187, 6784), (11, 84)],
];

fn combined<T: Analytic>(start: &State<T>, rates: &[Rate<T>], weights: &[Ratio], h: &T) -> State<T> {
    rates
        .iter()
        .zip(weights)
        .filter(|(_, weight)| weight.0 != 0)
        .fold(start.clone(), |sum, (rate, &weight)| {
            sum.plus(rate, h.clone() * ratio::<T>(weight.0, weight.1))
        })
}

/// The times of the stages after the first as fractions of the step: the sums of their weights.
const NODES: [Ratio; 6] = [(1, 5), (3, 10), (4, 5), (8, 9), (1, 1), (1, 1)];

pub(crate) fn dormand_prince<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let first = system.rate(start);
    let mut rates: [Rate<T>; 6] = core::array::from_fn(|_| first.clone());
    let [inner @ .., last] = &STAGES;
    for (k, weights) in inner.iter().enumerate() {
        let near = combined(start, &rates, weights, h);
        rates[k + 1] = system.rate_after(&near, &(ratio::<T>(NODES[k].0, NODES[k].1) * h.clone()));
    }
    combined(start, &rates, last, h)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_stage_stands_at_the_sum_of_its_weights() {
        let value = |&(n, d): &Ratio| f64::from(n) / f64::from(d);
        for (weights, node) in STAGES.iter().zip(&NODES) {
            let sum: f64 = weights.iter().map(value).sum();
            assert!((sum - value(node)).abs() < 1e-14, "{weights:?}");
        }
    }
}
