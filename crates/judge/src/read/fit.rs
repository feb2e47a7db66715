//! A fit by least squares; and a start fitted to the first rows, for records of few digits.

use crate::error::Error;
use crate::read::Row;
use crate::thresholds::*;
use nalgebra::{SMatrix, SVector, Vector3};
use serde::Serialize;
use tumbling::exact::FreeMotion;

/// How a start was fitted.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Fit {
    /// To how many rows.
    pub rows: usize,
    /// The root of the mean square of what is left of their spins, rad/s.
    pub left: f64,
    /// How far the fitted spin is from the first row's, rad/s.
    pub moved: f64,
}

fn dot(a: &[Vector3<f64>], b: &[Vector3<f64>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}

/// How what is missed changes with each number.
pub(crate) fn slopes<const N: usize>(
    at: &SVector<f64, N>,
    here: &[Vector3<f64>],
    misses: impl Fn(&SVector<f64, N>) -> Option<Vec<Vector3<f64>>>,
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
    products + SMatrix::identity() * (FIT_GAIN * products.diagonal().amax())
}

/// Gauss and Newton's way to the numbers of order 1 that miss a record least; `misses` has none of numbers
/// that cannot be, and `inside` leads back from there.
pub(crate) fn least<const N: usize>(
    start: SVector<f64, N>,
    misses: impl Fn(&SVector<f64, N>) -> Option<Vec<Vector3<f64>>>,
    inside: impl Fn(SVector<f64, N>) -> SVector<f64, N>,
) -> Option<SVector<f64, N>> {
    let mut at = start;
    let mut here = misses(&at)?;
    for _ in 0..FIT_ROUNDS {
        let along = slopes(&at, &here, &misses)?;
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
        if now > before * (1.0 - FIT_GAIN) {
            break;
        }
    }
    Some(at)
}

/// The spin at the time of the first row whose exact motion is nearest to the spins of all of them, in the
/// least squares.
pub(crate) fn fitted_start(moments: &Vector3<f64>, rows: &[Row]) -> Result<(Vector3<f64>, Fit), Error> {
    let none = |problem: &str| Error::Fit { rows: rows.len(), problem: problem.into() };
    let [first, .., last] = rows else { return Err(none("it takes two rows at least")) };
    let speed = rows.iter().map(|row| row.omega.norm()).fold(f64::MIN_POSITIVE, f64::max);
    let misses = |spin: &Vector3<f64>| -> Option<Vec<Vector3<f64>>> {
        let motion = FreeMotion::new((*moments).try_into().ok()?, &(spin * speed)).ok()?;
        let miss = |row: &Row| Some((motion.omega(row.t - first.t).ok()? - row.omega) / speed);
        rows.iter().map(miss).collect()
    };
    let unknown = || none("the rows do not determine the three components of a start");
    let spin = least(first.omega / speed, misses, |spin| spin).ok_or_else(unknown)?;
    let sum: f64 = misses(&spin).ok_or_else(unknown)?.iter().map(Vector3::norm_squared).sum();
    let (omega, left) = (spin * speed, speed * (sum / rows.len() as f64).sqrt());
    // What is left must be rounding or an engine's error, not another motion.
    if left > FIT_LEFT * speed {
        let over = last.t - first.t;
        return Err(none(&format!(
            "no free motion comes near to these rows: {left:.2e} rad/s are left of {speed:.2e} over {over:.3e} s. Take fewer rows"
        )));
    }
    Ok((omega, Fit { rows: rows.len(), left, moved: (omega - first.omega).norm() }))
}
