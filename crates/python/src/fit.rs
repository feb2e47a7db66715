//! A body from a gyroscope's record.

use crate::arrays::{Array, Numbers, array, rows};
use crate::error::Answer;
use crate::inertia::Given;
use crate::judge::times;
use nalgebra::Vector3;
use pyo3::prelude::*;

/// The result of `fit_inertia`.
///
/// >>> import numpy as np, tumbling
/// >>> w = tumbling.FreeMotion([1, 2, 2.5], spin=[0.5, 2, 0.1]).at(np.arange(300) / 50)[1]
/// >>> fitted = tumbling.fit_inertia(1 / 50, w)
/// >>> assert np.isclose(np.sum(fitted.moments), 1) and (fitted.stderr < 1e-6).all()
#[pyclass(frozen, module = "tumbling")]
pub struct FittedInertia(tumbling_judge::FittedInertia);

#[pymethods]
impl FittedInertia {
    /// The principal moments in ascending order, scaled to the sum 1: multiply them by the trace of the
    /// tensor if you know it.
    #[getter]
    fn moments<'py>(&self, py: Python<'py>) -> Answer<Array<'py>> {
        array(py, self.0.moments.as_slice().to_vec(), &[3], &[])
    }

    /// The principal axes in the axes of the sensor: the columns of a 3 x 3 rotation matrix, in the order of
    /// the moments.
    #[getter]
    fn axes<'py>(&self, py: Python<'py>) -> Answer<Array<'py>> {
        array(py, self.0.axes.transpose().as_slice().to_vec(), &[3, 3], &[])
    }

    /// The standard errors of the moments, from the residual of the fit.
    #[getter]
    fn stderr<'py>(&self, py: Python<'py>) -> Answer<Array<'py>> {
        array(py, self.0.errors.as_slice().to_vec(), &[3], &[])
    }

    /// The root mean square residual of a component of the spins, rad/s.
    #[getter]
    fn residual(&self) -> f64 {
        self.0.residual
    }

    fn __repr__(&self) -> String {
        let tumbling_judge::FittedInertia { moments, alike, residual, .. } = &self.0;
        let free = alike.map_or(String::new(), |[i, j]| format!(", axes {i} and {j} free in their plane"));
        format!("<FittedInertia: moments {:?}, residual {residual:e}{free}>", moments.as_slice())
    }
}

/// Fits a body's principal moments and axes to a gyroscope's record of its free motion.
///
/// `t`: the times (n,), s, or the step as one number. `w`: spins (n, 3), rad/s, in the sensor's axes, which
/// are fixed to the body; subtract a constant bias first. `guess`: an inertia in the sensor's axes, for
/// records whose rows are more than about a radian apart. A free motion determines the moments up to one
/// common factor: they are scaled to the sum 1.
///
/// Raises `Error` for fewer than four rows, a number that is not finite, a time that does not increase, spins
/// that no free motion approximates, and motions that do not determine the moments, such as a steady spin. If
/// two moments are equal, all axes in their plane are principal axes: `repr` says which moments these are.
///
/// >>> import numpy as np, tumbling
/// >>> t = np.arange(500) / 50
/// >>> w = tumbling.FreeMotion([1, 2, 3], spin=[0.5, 2, 0.1]).at(t)[1]
/// >>> fitted = tumbling.fit_inertia(t, w)
/// >>> assert np.allclose(fitted.moments, np.array([1, 2, 3]) / 6) and fitted.residual < 1e-9
/// >>> assert np.allclose(fitted.axes, np.eye(3))
#[pyfunction]
#[pyo3(signature = (t, w, guess=None))]
pub fn fit_inertia(
    py: Python<'_>,
    t: Numbers<'_>,
    w: Numbers<'_>,
    guess: Option<Given>,
) -> Answer<FittedInertia> {
    let spins = rows::<3>("w", &w)?.0.into_iter().map(Vector3::from);
    let rows: Vec<_> = times(&t, spins.len())?.0.into_iter().zip(spins).collect();
    Ok(FittedInertia(py.detach(|| tumbling_judge::fit_inertia(&rows, guess.map(|guess| guess.0).as_ref()))?))
}
