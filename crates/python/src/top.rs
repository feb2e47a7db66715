//! Lagrange's top in closed form.

use crate::arrays::{Numbers, Order, States, row};
use crate::error::Answer;
use crate::inertia::Given;
use pyo3::prelude::*;
use tumbling::Body;

/// A symmetric top under its weight, in closed form at any time.
///
/// `inertia` is the tensor about the fixed point (kg m²), `arm` is the vector from there to the centre of
/// mass (m, body axes), `weight` (N) pulls along the world's -z. `spin` (body axes, rad/s) and `attitude` are
/// as for `FreeMotion`.
///
/// Raises `Error` if the two moments across the arm differ, or if the arm is not along a principal axis.
///
/// >>> import math, numpy as np, tumbling
/// >>> leaning = [math.sin(0.25), 0, 0, math.cos(0.25)]  # by 0.5 rad
/// >>> moments, arm = [2e-4, 2e-4, 5e-5], [0, 0, 0.04]
/// >>> top = tumbling.LagrangeTop(moments, [0, 0, 200], arm, weight=0.981, attitude=leaning)
/// >>> assert abs(top.lean[0] - 0.5) < 1e-12 and abs(top.lean[1] - 0.5947) < 1e-4
/// >>> attitude, spin = top.at([0.0, top.period])
/// >>> assert abs(spin[1, 2] - 200) < 1e-12
#[pyclass(frozen, module = "tumbling")]
pub struct LagrangeTop {
    top: tumbling::exact::LagrangeTop,
    order: Order,
}

#[pymethods]
impl LagrangeTop {
    #[new]
    #[pyo3(signature = (inertia, spin, arm, weight, attitude=None, *, scalar_first=false))]
    fn new(
        inertia: Given,
        spin: Numbers<'_>,
        arm: Numbers<'_>,
        weight: f64,
        attitude: Option<&Bound<'_, PyAny>>,
        scalar_first: bool,
    ) -> Answer<Self> {
        let order = Order { scalar_first };
        let body = Body::spinning(inertia.0, order.attitude(attitude)?, &row("spin", &spin)?.into())?;
        let top = tumbling::exact::LagrangeTop::of(&body, &row("arm", &arm)?.into(), weight)?;
        Ok(Self { top, order })
    }

    /// Attitude (..., 4) and spin in body axes (..., 3; rad/s) at times (...) in s.
    fn at<'py>(&self, py: Python<'py>, times: Numbers<'py>) -> Answer<States<'py>> {
        self.order.at_each(py, &times, |t| self.top.at(t).map(|at| (at.attitude, at.omega)))
    }

    /// The least and the greatest angle between the vertical and the arm, rad.
    #[getter]
    fn lean(&self) -> (f64, f64) {
        self.top.lean().into()
    }

    /// The mean rate at which the arm precesses about the vertical, rad/s.
    #[getter]
    fn precession_rate(&self) -> f64 {
        self.top.precession_rate()
    }

    /// The time from one highest position of the arm to the next, s; None if the lean is constant.
    #[getter]
    fn period(&self) -> Answer<Option<f64>> {
        Ok(self.top.period()?)
    }
}
