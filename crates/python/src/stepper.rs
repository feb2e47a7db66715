//! One body under torques, stepped within a tolerance.

use crate::arrays::{Array, Numbers, Order, States, array, listed, put_matrix, row};
use crate::error::Answer;
use crate::inertia::Given;
use crate::torque::{Torque, laws};
use nalgebra::UnitQuaternion;
use pyo3::prelude::*;
use tumbling::Body;

/// A body under torques, with adaptive internal steps that keep the error of each below `tolerance`. A call
/// that needs more than `budget` internal steps raises `Error`.
///
/// `inertia`, `spin` and `attitude` are as for `FreeMotion`; torques act in the order of the list. The
/// tolerance applies to each internal step: `expected_error` says how far errors may accumulate.
///
/// Raises `Error` for a body or a torque that is not valid, and if the steps cannot continue.
///
/// Damping in proportion to the tensor slows the spin down and does nothing else:
///
/// >>> import math, numpy as np, tumbling
/// >>> drag = tumbling.Torque.damping(0.1 * np.array([1, 2, 2.5]))
/// >>> stepper = tumbling.Stepper([1, 2, 2.5], [0, 0, 3], torques=[drag])
/// >>> attitude, spin = stepper.run([5.0, 10.0])
/// >>> assert abs(spin[1, 2] - 3 * math.exp(-1)) < 1e-11
#[pyclass(module = "tumbling")]
pub struct Stepper {
    stepper: tumbling::step::Stepper,
    order: Order,
}

#[pymethods]
impl Stepper {
    #[new]
    #[pyo3(signature = (
        inertia, spin, attitude=None, *, torques=vec![], tolerance=1e-12, budget=100_000, scalar_first=false
    ))]
    fn new(
        inertia: Given,
        spin: Numbers<'_>,
        attitude: Option<&Bound<'_, PyAny>>,
        torques: Vec<Bound<'_, Torque>>,
        tolerance: f64,
        budget: usize,
        scalar_first: bool,
    ) -> Answer<Self> {
        let order = Order { scalar_first };
        let body = Body::spinning(inertia.0, order.attitude(attitude)?, &row("spin", &spin)?.into())?;
        let stepper = tumbling::step::Stepper::adaptive(&body, tolerance, budget)?;
        Ok(Self { stepper: stepper.with_torques(laws(torques))?, order })
    }

    /// Advances to each of the times (...) in turn, forward or backward, and returns attitude (..., 4) and
    /// spin in body axes (..., 3; rad/s).
    fn run<'py>(&mut self, py: Python<'py>, times: Numbers<'py>) -> Answer<States<'py>> {
        let Self { stepper, order } = self;
        order.at_each(py, &times, |t| {
            let state = stepper.step_to(t)?;
            Ok((UnitQuaternion::new_unchecked(state.attitude), stepper.omega()))
        })
    }

    /// Advances to the time `end` (s) and returns the times on the way at which the spin about the middle
    /// axis changes its sign, each accurate to rounding.
    fn flips<'py>(&mut self, py: Python<'py>, end: f64) -> Answer<Array<'py>> {
        let flips = py.detach(|| self.stepper.flips(end))?;
        let count = flips.len() as u64;
        listed(py, flips.into_iter(), count)
    }

    /// Advances by `h` seconds and returns the state transition matrix (6, 6) of that step, as in
    /// `FreeMotion`.
    ///
    /// Without torques it equals that of the free motion:
    ///
    /// >>> import numpy as np, tumbling
    /// >>> body = dict(inertia=[1, 2, 2.5], spin=[0.1, 2, 0.3])
    /// >>> one, other = tumbling.Stepper(**body), tumbling.FreeMotion(**body)
    /// >>> off = one.step_with_transition(3.0) - other.state_transition(3.0)
    /// >>> assert abs(off).max() < 1e-10
    fn step_with_transition<'py>(&mut self, py: Python<'py>, h: f64) -> Answer<Array<'py>> {
        let (found, mut all) = (py.detach(|| self.stepper.step_with_transition(h))?, Vec::new());
        put_matrix(&mut all, &found);
        array(py, all, &[6, 6], &[])
    }

    /// An estimate of the error of the attitude after a step of `h` seconds, rad. The stepper does not
    /// advance.
    fn expected_error(&self, py: Python<'_>, h: f64) -> Answer<f64> {
        Ok(py.detach(|| self.stepper.expected_error(h))?)
    }

    /// The time since the start, s.
    #[getter]
    fn time(&self) -> f64 {
        self.stepper.time()
    }
}
