//! Many bodies, free or under torques, on all cores.

use crate::arrays::{Array, Numbers, Order, States, array, each, listed, room, rows, slice};
use crate::error::{Answer, Refused};
use crate::inertia::Given;
use crate::motion::initial;
use crate::torque::{Torque, laws};
use nalgebra::Matrix3;
use numpy::PyUntypedArrayMethods;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::ops::ControlFlow;
use tumbling::Body;
use tumbling_scenes::{Error, InitialState, Outputs, Scene, Times, batch};

/// Many bodies at once, on all cores: free bodies in closed form; under torques, each body by an adaptive run
/// that is refined until two runs agree to `accuracy` (rad for the attitude, relative for the spin).
///
/// `inertia` is the same for all bodies (an `Inertia`, or three moments) or one for each: moments (n, 3) or
/// tensors (n, 3, 3), kg m²; `spin` (3,) or (n, 3) in body axes, rad/s; `attitude` None, (4,), (n, 4) or
/// SciPy's `Rotation`. All bodies are under the same torques.
///
/// Raises `Error`, with the number of the body, at the first body that is not valid or whose accuracy cannot
/// be reached.
///
/// >>> import numpy as np, tumbling
/// >>> spins = np.column_stack([np.zeros(1000), np.linspace(1, 5, 1000), np.full(1000, 0.01)])
/// >>> attitude, spin = tumbling.Batch([1, 2, 3], spins).at([0.0, 30.0, 60.0])
/// >>> assert attitude.shape == (3, 1000, 4) and spin.shape == (3, 1000, 3)
/// >>> alone = tumbling.FreeMotion([1, 2, 3], spins[700]).at(60.0)
/// >>> assert np.array_equal(spin[2, 700], alone[1]) and np.array_equal(attitude[2, 700], alone[0])
#[pyclass(frozen, module = "tumbling")]
pub struct Batch {
    bodies: Vec<InitialState>,
    torques: Vec<tumbling::step::Torque<f64>>,
    accuracy: f64,
    order: Order,
}

/// The error of a body, with its number.
fn of_body(index: usize) -> impl Fn(tumbling::Error) -> Error {
    move |error| Error::Body { index, source: Box::new(error.into()) }
}

/// The tensors, one or one for each body.
fn tensors(given: &Bound<'_, PyAny>) -> Answer<Vec<tumbling::Inertia>> {
    type Tensor = Result<tumbling::Inertia, tumbling::Error>;
    let each = |(body, tensor): (usize, Tensor)| tensor.map_err(of_body(body));
    let Ok(numbers) = given.extract::<Numbers<'_>>() else { return Ok(vec![given.extract::<Given>()?.0]) };
    if let [_, 3, 3] = numbers.shape() {
        let all = slice(&numbers);
        let matrices = all.as_chunks::<9>().0.iter().map(|m| Matrix3::from_row_slice(m).try_into());
        return Ok(matrices.enumerate().map(each).collect::<Result<_, _>>()?);
    }
    if let Ok(m) = <[f64; 9]>::try_from(&*slice(&numbers))
        && (m[1], m[2], m[5]) == (m[3], m[6], m[7])
        && (m[0], m[1]) != (m[1], m[4])
    {
        let sentence = "inertia is one symmetric matrix, which may be three bodies' moments or one body's tensor T: give T[None] or \
                        Inertia(T) for the one, three Inertia of moments as (3, 3, 3) tensors for the others";
        return Err(Refused::new("Shape", "inertia", sentence.into()));
    }
    let (moments, _) = rows("inertia", &numbers)?;
    let all = moments.into_iter().map(|[a, b, c]| tumbling::Inertia::from_moments(a, b, c));
    Ok(all.enumerate().map(each).collect::<Result<_, _>>()?)
}

impl Batch {
    fn scene(&self, times: Vec<f64>, outputs: Outputs) -> Result<Scene, Error> {
        let bodies = self.bodies.iter().copied();
        Scene::new(bodies, self.torques.clone(), Times::Given(times), outputs, self.accuracy)
    }

    /// Attitudes and spins, all bodies at the first time, then all at the next.
    fn states(&self, times: Vec<f64>) -> Answer<(Vec<f64>, Vec<f64>)> {
        let zeros = |each: u64| {
            let count = each.saturating_mul(times.len() as u64).saturating_mul(self.bodies.len() as u64);
            let mut all = room("the states", count)?;
            all.resize(count as usize, 0.0);
            Ok::<_, Refused>(all)
        };
        let (mut q, mut w) = (zeros(4)?, zeros(3)?);
        let scene = self.scene(times, Outputs { spin: true, attitude: true, ..Outputs::NOTHING })?;
        let mut wrong = None;
        let taken = |block: &batch::Block<'_>| {
            let states = block.answers.iter().flatten().filter_map(|state| {
                Some((self.order.write(state.attitude?.quaternion()), <[f64; 3]>::from(state.spin?)))
            });
            let (bodies, first) = (block.bodies.clone(), block.times.start as usize);
            (bodies, first, states.collect::<Vec<_>>(), block.wrong.first().map(|wrong| wrong.1.clone()))
        };
        batch::run(&scene, taken, |(bodies, first, states, failed)| {
            if let Some(failed) = failed {
                wrong = Some(failed);
                return ControlFlow::Break(());
            }
            for (i, (attitude, spin)) in states.into_iter().enumerate() {
                let slot = (first + i / bodies.len()) * self.bodies.len() + bodies.start + i % bodies.len();
                q[4 * slot..][..4].copy_from_slice(&attitude);
                w[3 * slot..][..3].copy_from_slice(&spin);
            }
            ControlFlow::Continue(())
        });
        wrong.map_or(Ok((q, w)), |wrong: Error| Err(wrong.into()))
    }
}

#[pymethods]
impl Batch {
    #[new]
    #[pyo3(signature = (inertia, spin, attitude=None, *, torques=vec![], accuracy=1e-9, scalar_first=false))]
    fn new(
        inertia: &Bound<'_, PyAny>,
        spin: Numbers<'_>,
        attitude: Option<&Bound<'_, PyAny>>,
        torques: Vec<Bound<'_, Torque>>,
        accuracy: f64,
        scalar_first: bool,
    ) -> Answer<Self> {
        let order = Order { scalar_first };
        let (tensors, (spins, _), (attitudes, _)) =
            (tensors(inertia)?, rows("spin", &spin)?, order.attitudes(attitude)?);
        let count = tensors.len().max(spins.len()).max(attitudes.len());
        let attitudes = each("attitude", attitudes, count)?;
        let starts = each("inertia", tensors, count)?.into_iter().zip(each("spin", spins, count)?);
        let checked = |(body, ((tensor, spin), q)): (usize, ((tumbling::Inertia, [f64; 3]), _))| {
            Body::spinning(tensor, q, &spin.into()).map_err(of_body(body))?;
            Ok::<_, Error>(initial(&tensor, spin, q))
        };
        let bodies = starts.zip(attitudes).enumerate().map(checked).collect::<Result<_, _>>()?;
        let batch = Self { bodies, torques: laws(torques), accuracy, order };
        batch.scene(vec![0.0], Outputs::NOTHING)?;
        Ok(batch)
    }

    /// Attitude (m, n, 4) and spin in body axes (m, n, 3; rad/s) of each body at each of m times, in s from
    /// the start and in ascending order. The interpreter's lock is released meanwhile.
    fn at<'py>(&self, py: Python<'py>, times: Numbers<'py>) -> Answer<States<'py>> {
        let all = slice(&times).into_owned();
        let shape = [all.len(), self.bodies.len()];
        let (q, w) = py.detach(|| self.states(all))?;
        Ok((array(py, q, &shape, &[4])?, array(py, w, &shape, &[3])?))
    }

    /// A list of arrays: the times up to `end` (s) at which the spin of each body about its middle axis
    /// changes its sign, under torques too.
    ///
    /// >>> import tumbling
    /// >>> flips = tumbling.Batch([1, 2, 3], [[0, 10, 0.001], [0, 0, 1]]).flips(10.0)
    /// >>> assert [len(times) for times in flips] == [3, 0]
    fn flips<'py>(&self, py: Python<'py>, end: f64) -> Answer<Vec<Array<'py>>> {
        let of_bodies = || {
            let scene = self.scene(vec![end], Outputs { flips: true, ..Outputs::NOTHING })?;
            let each = (0..self.bodies.len()).into_par_iter().map(|body| scene.plan(body)?.flips());
            each.collect::<Result<Vec<_>, Error>>()
        };
        let flips = py.detach(of_bodies).map_err(Refused::from)?;
        flips
            .into_iter()
            .map(|times| {
                let count = times.remaining();
                listed(py, times, count)
            })
            .collect()
    }

    fn __len__(&self) -> usize {
        self.bodies.len()
    }
}
