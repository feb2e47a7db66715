//! A start fitted to the first rows, for records of few digits.

use crate::error::Error;
use crate::read::Row;
use crate::thresholds::{FIT_BOTTOM, FIT_GAIN, FIT_LEFT, FIT_ROUNDS, FIT_SHARE};
use nalgebra::{Matrix3, Vector3};
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

/// The squares of what is left of the rows' spins by the exact motion from this one, summed.
fn left(moments: &Vector3<f64>, rows: &[Row], omega: &Vector3<f64>) -> Result<f64, tumbling::Error> {
    let motion = FreeMotion::new((*moments).try_into()?, omega)?;
    rows.iter()
        .try_fold(0.0, |sum, row| Ok(sum + (motion.omega(row.t - rows[0].t)? - row.omega).norm_squared()))
}

/// The step of Gauss and Newton's way; none where the rows do not determine it.
fn step(
    moments: &Vector3<f64>,
    rows: &[Row],
    omega: &Vector3<f64>,
) -> Result<Option<Vector3<f64>>, tumbling::Error> {
    let motion = FreeMotion::new((*moments).try_into()?, omega)?;
    let (mut normal, mut side) = (Matrix3::zeros(), Vector3::zeros());
    for row in rows {
        let t = row.t - rows[0].t;
        let by_start = motion.state_transition(t)?.fixed_view::<3, 3>(3, 3).into_owned();
        normal += by_start.tr_mul(&by_start);
        side += by_start.tr_mul(&(row.omega - motion.omega(t)?));
    }
    Ok(normal.cholesky().map(|root| root.solve(&side)))
}

/// The spin at the time of the first row whose exact motion is nearest to the spins of all of them, in the
/// least squares.
pub(crate) fn fitted_start(moments: &Vector3<f64>, rows: &[Row]) -> Result<(Vector3<f64>, Fit), Error> {
    let none = |problem: &str| Error::Fit { rows: rows.len(), problem: problem.into() };
    let [first, .., last] = rows else { return Err(none("it takes two rows at least")) };
    let mut omega = first.omega;
    let mut least = left(moments, rows, &omega)?;
    let speed = rows.iter().map(|row| row.omega.norm()).fold(0.0, f64::max);
    let enough = f64::EPSILON * speed;
    let mut settled = speed == 0.0;
    for _ in 0..FIT_ROUNDS {
        if settled {
            break;
        }
        let Some(step) = step(moments, rows, &omega)? else {
            return Err(none("the rows do not determine the three components of a start"));
        };
        // Shorter steps where the whole one leads away.
        let mut share = 1.0;
        let mut better = None;
        while share > FIT_SHARE && better.is_none() {
            let next = omega + step * share;
            better = left(moments, rows, &next).ok().filter(|now| *now < least).map(|now| (next, now));
            share /= 2.0;
        }
        if let Some((next, now)) = better {
            settled = (next - omega).norm() <= enough || now > least * (1.0 - FIT_GAIN);
            (omega, least) = (next, now);
            continue;
        }
        // At the bottom no step leads further down: by rounding only, or it is no bottom.
        settled = step.norm() <= FIT_BOTTOM * speed;
        if !settled {
            return Err(none("it does not converge: no start near the first row's comes nearer to the rows"));
        }
    }
    if !settled {
        return Err(none("it does not converge in the rounds that it has"));
    }
    let left = (least / rows.len() as f64).sqrt();
    let moved = (omega - first.omega).norm();
    // What is left must be rounding or an engine's error, not another motion.
    if left > FIT_LEFT * speed {
        let over = last.t - first.t;
        return Err(none(&format!(
            "no free motion comes near to these rows: {left:.2e} rad/s are left of {speed:.2e} over {over:.3e} s. Take fewer rows"
        )));
    }
    Ok((omega, Fit { rows: rows.len(), left, moved }))
}
