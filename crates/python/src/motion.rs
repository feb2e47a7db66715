//! Free motion in closed form.

use crate::arrays::{Array, Numbers, Order, States, array, listed, put_matrix, row, slice};
use crate::error::Answer;
use crate::inertia::Given;
use nalgebra::{UnitQuaternion, Vector3};
use numpy::PyUntypedArrayMethods;
use pyo3::prelude::*;
use tumbling_scenes::{InitialState, Start};

/// A body at the start.
pub fn initial(tensor: &tumbling::Inertia, spin: [f64; 3], attitude: UnitQuaternion<f64>) -> InitialState {
    let m = tensor.matrix();
    InitialState {
        moments: m.diagonal(),
        products: Vector3::new(m[(0, 1)], m[(0, 2)], m[(1, 2)]),
        attitude,
        start: Start::Spin(spin.into()),
    }
}

/// The motion of a body that nothing touches, in closed form: at any time, without steps.
///
/// `inertia` is an `Inertia`, three moments or a 3 x 3 tensor (kg m²); `spin` the angular velocity at time 0
/// in body axes (rad/s); `attitude` takes body to world at time 0: a quaternion x, y, z, w as from SciPy's
/// `Rotation.as_quat` (w, x, y, z with `scalar_first=True`, also in results), or a `Rotation`; the identity
/// if none is given. Times are in s from the start and may be negative.
///
/// Raises `Error` for a tensor that no body has, a quaternion whose length is not 1 to a billionth, or
/// numbers that are not finite.
///
/// >>> import numpy as np, tumbling
/// >>> motion = tumbling.FreeMotion([1, 2, 3], spin=[0, 10, 0.001])
/// >>> attitude, spin = motion.at(np.linspace(0, 10, 5))
/// >>> assert attitude.shape == (5, 4) and spin.shape == (5, 3)
/// >>> assert np.round(motion.flips(0, 10), 4).tolist() == [1.7402, 5.2207, 8.7012]
#[pyclass(frozen, module = "tumbling")]
pub struct FreeMotion {
    motion: tumbling::exact::FreeMotion,
    order: Order,
}

#[pymethods]
impl FreeMotion {
    #[new]
    #[pyo3(signature = (inertia, spin, attitude=None, *, scalar_first=false))]
    fn new(
        inertia: Given,
        spin: Numbers<'_>,
        attitude: Option<&Bound<'_, PyAny>>,
        scalar_first: bool,
    ) -> Answer<Self> {
        let order = Order { scalar_first };
        let start = initial(&inertia.0, row("spin", &spin)?, order.attitude(attitude)?);
        Ok(Self { motion: start.motion()?, order })
    }

    /// Attitude (..., 4) and spin in body axes (..., 3; rad/s) at times (...) in s.
    ///
    /// >>> import tumbling
    /// >>> attitude, spin = tumbling.FreeMotion([1, 2, 2.5], [0.1, 2, 0.3]).at(0)
    /// >>> assert list(attitude) == [0, 0, 0, 1] and list(spin) == [0.1, 2, 0.3]
    fn at<'py>(&self, py: Python<'py>, times: Numbers<'py>) -> Answer<States<'py>> {
        self.order.at_each(py, &times, |t| self.motion.at(t).map(|at| (at.attitude, at.omega)))
    }

    /// The state transition matrices (..., 6, 6) from the start to times (...): of attitude error (rad, a
    /// small rotation vector) and spin error (rad/s), both in body axes. A covariance P becomes F P F^T.
    fn state_transition<'py>(&self, py: Python<'py>, times: Numbers<'py>) -> Answer<Array<'py>> {
        let (all, mut found) = (slice(&times), Vec::new());
        py.detach(|| {
            for &t in all.iter() {
                put_matrix(&mut found, &self.motion.state_transition(t)?);
            }
            Ok::<_, tumbling::Error>(())
        })?;
        array(py, found, times.shape(), &[6, 6])
    }

    /// The state transitions and the derivatives (both (..., 6, 6)) of attitude (rad) and spin (rad/s) at
    /// times (...) by the tensor's entries xx, yy, zz, xy, xz, yz (kg m²).
    ///
    /// A heavier body of the same shape moves in the same way:
    ///
    /// >>> import numpy as np, tumbling
    /// >>> _, by_tensor = tumbling.FreeMotion([0.05, 0.03, 0.07], [0.1, -0.2, 0.3]).sensitivities(20.0)
    /// >>> change = by_tensor @ [0.05, 0.03, 0.07, 0, 0, 0]
    /// >>> assert np.linalg.norm(change) < 1e-14 * np.linalg.norm(by_tensor)
    fn sensitivities<'py>(&self, py: Python<'py>, times: Numbers<'py>) -> Answer<States<'py>> {
        let (all, mut by_start, mut by_tensor) = (slice(&times), Vec::new(), Vec::new());
        py.detach(|| {
            for &t in all.iter() {
                let (start, tensor) = self.motion.sensitivities(t)?;
                put_matrix(&mut by_start, &start);
                put_matrix(&mut by_tensor, &tensor);
            }
            Ok::<_, tumbling::Error>(())
        })?;
        let shape = times.shape();
        Ok((array(py, by_start, shape, &[6, 6])?, array(py, by_tensor, shape, &[6, 6])?))
    }

    /// The times after `start` and up to `end` (s) at which the spin about the middle axis changes its sign.
    ///
    /// Raises `Error` if there are more than memory can hold.
    fn flips<'py>(&self, py: Python<'py>, start: f64, end: f64) -> Answer<Array<'py>> {
        let flips = self.motion.flips(start, end)?;
        let count = flips.remaining();
        listed(py, flips, count)
    }

    /// The time (s) of the first flip after a time; None if there is none.
    #[pyo3(signature = (time=0.0))]
    fn next_flip(&self, time: f64) -> Answer<Option<f64>> {
        Ok(self.motion.next_flip(time)?)
    }

    /// The period of the spin in body axes, s; None if the spin is constant or does not return.
    #[getter]
    fn period(&self) -> Answer<Option<f64>> {
        Ok(self.motion.period()?)
    }
}
