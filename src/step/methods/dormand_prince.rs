//! The step of order 5 of the pair of Dormand and Prince of orders 5 and 4 [DP80](crate::references).

use super::implicit::ratio;
use crate::body::{Rate, State};
use crate::number::Analytic;
use crate::step::system::System;

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

pub(crate) fn step<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
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
