//! The kit's stories, run with a step function of the user.

use crate::arrays::{Numbers, Order, row};
use crate::error::{Answer, Refused};
use crate::judge::{Verdict, kind};
use nalgebra::{Quaternion, Vector3};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use tumbling::attitude::rotation_matrix;
use tumbling_judge::{Description, Kind, Row, judge_described};

/// More steps than this would take too long.
const MOST_STEPS: f64 = 1e8;

/// A test case of the judge's kit: a free body with its start.
///
/// >>> import tumbling
/// >>> story = tumbling.Story.named('box-5')
/// >>> def step(state, dt):
/// ...     attitude, spin = state  # x, y, z, w; body axes, rad/s
/// ...     return tumbling.FreeMotion(story.moments, spin, attitude / sum(attitude**2)**0.5).at(dt)
/// >>> verdict = story.run(step, dt=1/60)
/// >>> assert verdict.passed, verdict
#[pyclass(frozen, module = "tumbling")]
pub struct Story {
    story: tumbling_judge::Story,
}

#[pymethods]
impl Story {
    /// All stories.
    #[staticmethod]
    fn all() -> Vec<Self> {
        tumbling_judge::Story::all().into_iter().map(|story| Self { story }).collect()
    }

    /// The story with this name. Raises `Error` if there is none.
    #[staticmethod]
    fn named(name: &str) -> Answer<Self> {
        let names = || Self::all().iter().map(|one| one.name().to_string()).collect::<Vec<_>>().join(", ");
        let none =
            || Refused::new("Undefined", "the story", format!("there is no `{name}`, but {}", names()));
        Ok(Self { story: tumbling_judge::Story::named(name).ok_or_else(none)? })
    }

    /// Its name, such as 'box-5'.
    #[getter]
    fn name(&self) -> &str {
        &self.story.name
    }

    /// The principal moments about the body's axes, kg m².
    #[getter]
    fn moments(&self) -> [f64; 3] {
        self.story.moments
    }

    /// Runs the story in steps of `dt` seconds and returns the verdict. `step` takes a pair (attitude (4,),
    /// spin (3,)) and `dt`, and returns the pair one step further.
    ///
    /// The attitude is x, y, z, w (with `scalar_first=True` w, x, y, z), body to world; the spin is in the
    /// axes that `frame` names, rad/s; both are arrays of `dtype`. The limits are those of the kit.
    #[pyo3(signature = (step, dt, *, frame="body", scalar_first=false, dtype=None))]
    fn run(
        &self,
        py: Python<'_>,
        step: &Bound<'_, PyAny>,
        dt: f64,
        frame: &str,
        scalar_first: bool,
        dtype: Option<&Bound<'_, PyAny>>,
    ) -> Answer<Verdict> {
        let (order, story) = (Order { scalar_first }, &self.story);
        let count = (story.duration / dt).round();
        if !(1.0..=MOST_STEPS).contains(&count) {
            let sentence =
                format!("the step is {dt:?} s: it must be above zero and below {} s", story.duration);
            return Err(Refused::new("OutOfBounds", "the step", sentence));
        }
        let kind = kind(frame)?;
        let [w, x, y, z] = story.attitude;
        let (attitude, mut spin) = (Quaternion::new(w, x, y, z), Vector3::from(story.spin));
        if kind == Kind::SpinWorld {
            spin = rotation_matrix(&attitude) * spin;
        }
        let typed = |numbers: &[f64]| numbers.to_vec().into_pyarray(py).call_method1("astype", (dtype,));
        let mut state = (typed(&order.write(&attitude))?, typed(spin.as_slice())?);
        let mut all = Vec::new();
        for i in 0..=count as u32 {
            let q = order.attitude(Some(&state.0))?;
            let spin = row("spin", &state.1.extract::<Numbers<'_>>()?)?;
            all.push(Row { time: f64::from(i) * dt, attitude: Some([q.w, q.i, q.j, q.k]), spin });
            if f64::from(i) < count {
                state = step.call1((state, dt))?.extract()?;
            }
        }
        let description = Description { kind, step: Some(dt), ..Description::default() };
        let options = story.options(dt);
        let verdict = py.detach(|| judge_described(story.moments, description, all, &options))?;
        Ok(Verdict { verdict })
    }
}
