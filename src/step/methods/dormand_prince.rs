//! The embedded pair of Dormand and Prince, orders 5 and 4 [DP80](crate::references).

use crate::body::{Rate, State};
use crate::number::Analytic;
use crate::step::system::System;
use nalgebra::{Quaternion, Vector3};

/// An integer over another.
type Ratio = (i32, u32);

/// Each stage's weights of the slopes before it. The last row is the step of order 5.
const STAGES: [&[Ratio]; 6] = [
    &[(1, 5)],
    &[(3, 40), (9, 40)],
    &[(44, 45), (-56, 15), (32, 9)],
    &[(19_372, 6561), (-25_360, 2187), (64_448, 6561), (-212, 729)],
    &[(9017, 3168), (-355, 33), (46_732, 5247), (49, 176), (-5103, 18_656)],
    &[(35, 384), (0, 1), (500, 1113), (125, 192), (-2187, 6784), (11, 84)],
];

/// Weights of the seven slopes in the difference of the two orders: the estimate of the error.
const ERROR: [Ratio; 7] =
    [(71, 57_600), (0, 1), (-71, 16_695), (71, 1920), (-17_253, 339_200), (22, 525), (-1, 40)];

fn number<T: Analytic>((n, d): Ratio) -> T {
    let size = T::integer(n.unsigned_abs()) / T::integer(d);
    if n < 0 { -size } else { size }
}

fn combined<T: Analytic>(start: &State<T>, slopes: &[Rate<T>], weights: &[Ratio], h: &T) -> State<T> {
    slopes
        .iter()
        .zip(weights)
        .filter(|(_, weight)| weight.0 != 0)
        .fold(start.clone(), |sum, (slope, &weight)| sum.plus(slope, h.clone() * number::<T>(weight)))
}

/// The times of the stages after the first as fractions of the step: the sums of their weights.
const NODES: [Ratio; 6] = [(1, 5), (3, 10), (4, 5), (8, 9), (1, 1), (1, 1)];

/// A step with its first six slopes.
pub(crate) struct Stages<T: nalgebra::Scalar> {
    pub(crate) end: State<T>,
    /// The state of which the last slope was taken: the end too, by weights of a lower order.
    pub(crate) near: State<T>,
    pub(crate) slopes: [Rate<T>; 6],
}

impl<T: Analytic> Stages<T> {
    /// The step from `start` to `h` seconds later, given the slope at `start`; `time` seconds have gone by
    /// since the system's time.
    pub(crate) fn new(system: &System<T>, start: &State<T>, first: Rate<T>, time: &T, h: &T) -> Self {
        let mut slopes: [Rate<T>; 6] = core::array::from_fn(|_| first.clone());
        let mut near = start.clone();
        let [inner @ .., last] = &STAGES;
        for (k, weights) in inner.iter().enumerate() {
            near = combined(start, &slopes, weights, h);
            let then = time.clone() + number::<T>(NODES[k]) * h.clone();
            slopes[k + 1] = system.rate_after(&near, &then);
        }
        Self { end: combined(start, &slopes, last, h), near, slopes }
    }

    /// The estimated errors of attitude and momentum, given the slope at the end.
    pub(crate) fn error(&self, end_slope: &Rate<T>, h: &T) -> State<T> {
        let zero = T::zero;
        let nothing = State {
            attitude: Quaternion::new(zero(), zero(), zero(), zero()),
            momentum: Vector3::from_fn(|_, _| zero()),
        };
        let [inner @ .., last] = &ERROR;
        combined(&nothing, &self.slopes, inner, h).plus(end_slope, h.clone() * number::<T>(*last))
    }
}

pub(crate) fn step<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    Stages::new(system, start, system.rate(start), &T::zero(), h).end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_stage_stands_at_the_sum_of_its_weights_and_the_errors_weights_cancel() {
        let value = |&(n, d): &Ratio| f64::from(n) / f64::from(d);
        for (weights, node) in STAGES.iter().zip(&NODES) {
            let sum: f64 = weights.iter().map(value).sum();
            assert!((sum - value(node)).abs() < 1e-14, "{weights:?}");
        }
        assert!(ERROR.iter().map(value).sum::<f64>().abs() < 1e-15);
    }
}
