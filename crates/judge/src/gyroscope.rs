//! A body's moments and principal axes, fitted to the record of a gyroscope.

use crate::error::{Error, not_later};
use crate::read::{least, normal, slopes};
use crate::rule::{inside, tensor};
use crate::thresholds::*;
use nalgebra::{Matrix3, SVector, UnitQuaternion, Vector3};
use tumbling::exact::FreeMotion;
use tumbling::{Body, Inertia};

/// The inertia of a free body, as its spins determine it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedInertia {
    /// The principal moments, smallest first, with sum 1: a free motion determines only their ratios.
    pub moments: Vector3<f64>,
    /// The principal axes in the sensor's, as columns.
    pub axes: Matrix3<f64>,
    /// Of which two moments are alike within their errors, so that any two axes in their plane are principal
    /// ones: 0 and 1, or 1 and 2; `None` where all three axes are determined.
    pub alike: Option<[usize; 2]>,
    /// The standard errors of the moments.
    pub errors: Vector3<f64>,
    /// The root mean square residual of a component of the spins, rad/s.
    pub residual: f64,
}

/// Fits, by least squares, the body whose free motion is nearest to these times (s) and spins (rad/s, in the
/// sensor's axes). Without a guess it starts from Euler's equations, integrated over about a radian.
///
/// ```
/// use nalgebra::{Rotation3, Vector3};
/// use tumbling::{PrincipalMoments, exact::FreeMotion};
/// let motion = FreeMotion::new(PrincipalMoments::new(1.0, 2.0, 3.0)?, &Vector3::new(0.5, 2.0, 0.1))?;
/// let sensor = Rotation3::from_euler_angles(0.3, -0.2, 0.4);
/// let row = |i: i32| motion.omega(f64::from(i) / 50.0).map(|spin| (f64::from(i) / 50.0, sensor * spin));
/// let rows = (0..500).map(row).collect::<Result<Vec<_>, _>>()?;
/// let fitted = tumbling_judge::fit_inertia(&rows, None)?;
/// assert!((fitted.moments * 6.0 - Vector3::new(1.0, 2.0, 3.0)).norm() < 1e-6);
/// assert!((fitted.axes - sensor.matrix()).norm() < 1e-6 && fitted.residual < 1e-9);
/// let steady = [0.0, 1.0, 2.0, 3.0].map(|t| (t, Vector3::z()));
/// assert!(tumbling_judge::fit_inertia(&steady, None).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Fewer than four rows, a number that is not finite, a time that does not increase, spins that no free
/// motion comes near to, or that do not determine the moments: a steady spin.
pub fn fit_inertia(rows: &[(f64, Vector3<f64>)], guess: Option<&Inertia>) -> Result<FittedInertia, Error> {
    check(rows)?;
    let fail = |problem: String| Error::Fit { rows: rows.len(), problem };
    let speed = rows.iter().map(|row| row.1.norm()).fold(f64::MIN_POSITIVE, f64::max);
    let none = |left: f64| fail(no_motion(left * speed, speed));
    let squares = |all: &[Vector3<f64>]| all.iter().map(Vector3::norm_squared).sum::<f64>();
    let rms = |all: &[Vector3<f64>]| (squares(all) / (3 * rows.len() - 8) as f64).sqrt();
    let mean = rows.iter().map(|row| row.1).sum::<Vector3<f64>>() / rows.len() as f64;
    let swing = rms(&rows.iter().map(|row| (row.1 - mean) / speed).collect::<Vec<_>>());
    let steady = |left: f64| {
        // For noise alone the mean is the smaller.
        if swing * speed > mean.norm() {
            return none(swing);
        }
        fail(is_steady(swing * speed, left * speed))
    };
    let start = match guess.map(Inertia::matrix) {
        Some(m) => {
            Some([m[(0, 0)], m[(1, 1)], m[(1, 2)], m[(0, 2)], m[(0, 1)]].map(|x| x / m.trace()).into())
        }
        None => {
            let third = 1.0 / 3.0;
            least([third, third, 0.0, 0.0, 0.0].into(), &|numbers| Some(summed(rows, numbers)), &inside, GAIN)
        }
    };
    let mut at = with_spin(&start.ok_or_else(|| steady(0.0))?, &(rows[0].1 / speed));
    for part in FIT_PARTS {
        let some = &rows[..(rows.len() / part).max(FIT_PART_ROWS).min(rows.len())];
        let inside = |at: SVector<f64, 8>| with_spin(&inside(body(&at)), &at.fixed_rows::<3>(5).into());
        at = least(at, &|at| misses(some, speed, at), &inside, GAIN).unwrap_or(at);
    }
    // In principal axes the fitted numbers are the moments, and their errors those of the moments.
    let principal = Inertia::try_from(tensor(&inside(body(&at))))?.principal();
    let (moments, axes) = (principal.moments(), principal.frame());
    let turned: Vec<_> = rows.iter().map(|(t, spin)| (*t, axes.tr_mul(spin))).collect();
    let along = [moments.x, moments.y, 0.0, 0.0, 0.0].into();
    let at = with_spin(&along, &axes.tr_mul(&at.fixed_rows::<3>(5)));
    let here = misses(&turned, speed, &at).ok_or_else(|| steady(0.0))?;
    let left = rms(&here);
    if left > FIT_LEFT {
        return Err(none(left));
    }
    if swing <= (STEADY * left).max(FIT_FLOOR) {
        return Err(steady(left));
    }
    let along = slopes(&at, &here, &|at| misses(&turned, speed, at)).ok_or_else(|| steady(left))?;
    let c = normal::<8>(&along).cholesky().ok_or_else(|| steady(left))?.inverse();
    let unit = Vector3::new(c[(0, 0)], c[(1, 1)], c[(0, 0)] + c[(1, 1)] + 2.0 * c[(0, 1)]).map(f64::sqrt);
    let known = unit * left.max(FIT_FLOOR);
    if known.max() > UNDETERMINED {
        return Err(fail(format!(
            "the motion does not determine the moments: the standard error of one is {:.2e} of their sum, and must be at \
             most {UNDETERMINED}",
            known.max()
        )));
    }
    let is_alike = |[i, j]: &[usize; 2]| moments[*j] - moments[*i] < MOMENTS_APART * known[*i].max(known[*j]);
    let alike = [[0, 1], [1, 2]].into_iter().find(is_alike);
    Ok(FittedInertia { moments, axes, alike, errors: unit * left, residual: left * speed })
}

fn is_steady(swing: f64, left: f64) -> String {
    format!(
        "the spin is steady, which does not determine the moments: it differs by {swing:.2e} rad/s from its mean, and must by \
         more than {STEADY} times the residual, {left:.2e}"
    )
}

fn no_motion(left: f64, speed: f64) -> String {
    format!("no free motion comes near to these rows: the residual is {left:.2e} rad/s of {speed:.2e}")
}

fn check(rows: &[(f64, Vector3<f64>)]) -> Result<(), Error> {
    if rows.len() < 4 {
        return Err(Error::Fit { rows: rows.len(), problem: "it needs at least four rows".into() });
    }
    let mut last = f64::NEG_INFINITY;
    for (i, (t, spin)) in rows.iter().enumerate() {
        let wrong = |problem| Err(Error::Row { row: i + 1, problem });
        if let Some(bad) = spin.iter().chain([t]).find(|x| !x.is_finite()) {
            return wrong(format!("a value is {bad}: all must be finite"));
        }
        if *t <= last {
            return wrong(not_later(*t, last));
        }
        last = *t;
    }
    Ok(())
}

/// The numbers of a tensor, as [`tensor`] takes them, and the first spin.
fn with_spin(body: &SVector<f64, 5>, spin: &Vector3<f64>) -> SVector<f64, 8> {
    SVector::from_fn(|i, _| if i < 5 { body[i] } else { spin[i - 5] })
}

fn body(at: &SVector<f64, 8>) -> SVector<f64, 5> {
    at.fixed_rows::<5>(0).into()
}

/// By how much Euler's equations, summed from row to row, miss the change of momentum in the body.
fn summed(rows: &[(f64, Vector3<f64>)], numbers: &SVector<f64, 5>) -> Vec<Vector3<f64>> {
    let tensor = tensor(numbers);
    let (mut all, mut sum, mut angle, mut first) = (Vec::new(), Vector3::zeros(), 0.0, rows[0].1);
    for two in rows.windows(2) {
        let ((t, from), (end, to)) = (two[0], two[1]);
        sum += (from.cross(&(tensor * from)) + to.cross(&(tensor * to))) * ((end - t) / 2.0);
        angle += (from.norm() + to.norm()) * ((end - t) / 2.0);
        if angle > FIT_ANGLE {
            all.push((tensor * (to - first) + sum) / to.norm().max(f64::MIN_POSITIVE));
            (sum, angle, first) = (Vector3::zeros(), 0.0, to);
        }
    }
    all
}

/// By how much the exact motion misses the spins, in the fastest.
fn misses(rows: &[(f64, Vector3<f64>)], speed: f64, at: &SVector<f64, 8>) -> Option<Vec<Vector3<f64>>> {
    // A flat body's products change its moments in the second order alone.
    let held = inside(body(at));
    if (held - body(at)).norm() > JOLT * FIT_FLOOR.sqrt() {
        return None;
    }
    let (tensor, spin) = (Inertia::try_from(tensor(&held)).ok()?, at.fixed_rows::<3>(5) * speed);
    let motion = FreeMotion::of(&Body::spinning(tensor, UnitQuaternion::identity(), &spin).ok()?).ok()?;
    rows.iter().map(|(t, spin)| Some((motion.omega(t - rows[0].0).ok()? - spin) / speed)).collect()
}
