//! A fit by least squares.

use crate::thresholds::*;
use nalgebra::{SMatrix, SVector, Vector3};

fn dot(a: &[Vector3<f64>], b: &[Vector3<f64>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}

/// By how much numbers of order 1 miss a record; none of numbers that cannot be.
pub(crate) type Misses<'a, const N: usize> = &'a dyn Fn(&SVector<f64, N>) -> Option<Vec<Vector3<f64>>>;

/// How what is missed changes with each number.
pub(crate) fn slopes<const N: usize>(
    at: &SVector<f64, N>,
    here: &[Vector3<f64>],
    misses: Misses<'_, N>,
) -> Option<Vec<Vec<Vector3<f64>>>> {
    let along = |i: usize| {
        let jolted = |by: f64| {
            let mut other = *at;
            other[i] += by;
            let change = |(there, here): (&Vector3<f64>, &Vector3<f64>)| (there - here) / by;
            misses(&other).map(|there| there.iter().zip(here).map(change).collect::<Vec<_>>())
        };
        jolted(JOLT).or_else(|| jolted(-JOLT))
    };
    (0..N).map(along).collect()
}

/// The products of these changes.
pub(crate) fn normal<const N: usize>(along: &[Vec<Vector3<f64>>]) -> SMatrix<f64, N, N> {
    let products = SMatrix::<f64, N, N>::from_fn(|i, j| dot(&along[i], &along[j]));
    // Numbers on which nothing depends stay as they are.
    products + SMatrix::identity() * (GAIN * products.diagonal().amax())
}

/// Gauss and Newton's way to the numbers that miss a record least, up to where a round gains less than a
/// share of the squares; `inside` leads back from numbers that cannot be.
pub(crate) fn least<const N: usize>(
    start: SVector<f64, N>,
    misses: Misses<'_, N>,
    inside: &dyn Fn(SVector<f64, N>) -> SVector<f64, N>,
    gain: f64,
) -> Option<SVector<f64, N>> {
    let mut at = start;
    let mut here = misses(&at)?;
    for _ in 0..FIT_ROUNDS {
        let along = slopes(&at, &here, misses)?;
        let side = SVector::<f64, N>::from_fn(|i, _| dot(&along[i], &here));
        let step = normal::<N>(&along).cholesky()?.solve(&side);
        let before = dot(&here, &here);
        // Shorter steps where the whole one leads away.
        let better = FIT_SHARES.iter().find_map(|share| {
            let next = inside(at - step * *share);
            let there = misses(&next)?;
            let now = dot(&there, &there);
            (now < before).then_some((next, there, now))
        });
        let Some((next, there, now)) = better else { break };
        (at, here) = (next, there);
        if now > before * (1.0 - gain) {
            break;
        }
    }
    Some(at)
}
