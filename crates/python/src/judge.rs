//! The judge on arrays, and its verdict.

use crate::arrays::{Numbers, Order, each, row, rows, slice};
use crate::error::{Answer, Refused};
use crate::inertia::Given;
use crate::picture;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use numpy::PyUntypedArrayMethods;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::HashMap;
use tumbling_judge::{Description, Kind, LawName, Motion, Options, Outcome, Row, judge_described};

/// The judge's verdict on a record. `str()` gives the whole verdict in words, the outcome first; a notebook
/// shows it with a picture of the spin.
#[pyclass(frozen, module = "tumbling")]
pub struct Verdict {
    pub verdict: tumbling_judge::Verdict,
}

#[pymethods]
impl Verdict {
    /// Whether the record is valid and every law that it can show is kept within the threshold.
    #[getter]
    fn passed(&self) -> bool {
        self.verdict.outcome == Outcome::Passed
    }

    /// 'passed', 'failed', 'nothing to judge' or 'too short to judge'.
    #[getter]
    fn outcome(&self) -> &'static str {
        self.verdict.outcome.key()
    }

    /// The rule that made the steps; None if the judge is not certain of one (`str()` has more).
    #[getter]
    fn rule(&self) -> Option<String> {
        let diagnosis = self.verdict.diagnosis.as_ref()?;
        diagnosis.confidence.names_a_rule().then(|| diagnosis.best.rule.name())
    }

    /// The engines that use this rule.
    #[getter]
    fn engines(&self) -> Vec<String> {
        let named = self.verdict.diagnosis.as_ref().filter(|found| found.confidence.names_a_rule());
        named.map_or_else(Vec::new, |found| found.engines.iter().map(ToString::to_string).collect())
    }

    /// What to change, if something should be changed.
    #[getter]
    fn advice(&self) -> Option<String> {
        let diagnosis = self.verdict.diagnosis.as_ref()?;
        let words: Vec<String> = diagnosis.advice.iter().map(|advice| advice.words.to_string()).collect();
        (!words.is_empty()).then(|| words.join(" "))
    }

    /// The errors of the record, law by law, as in the JSON: a list of dicts with `law`, `words`, `grade`,
    /// `most`, `last`, `allowed` and more.
    #[getter]
    fn laws<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        py.import("json")?.call_method1("loads", (self.verdict.json()["laws"].to_string(),))
    }

    /// The whole verdict as JSON text, the same as `tumbling-judge --json` prints.
    fn json(&self) -> String {
        format!("{:#}", self.verdict.json())
    }

    fn __str__(&self) -> String {
        self.verdict.to_string()
    }

    fn __repr__(&self) -> String {
        format!("<Verdict: {}>", self.outcome())
    }

    fn _repr_html_(&self) -> String {
        picture::page(&self.verdict)
    }
}

/// The largest error allowed: one number for every law, or one for each law by its key.
#[derive(FromPyObject)]
pub enum Threshold {
    All(f64),
    Each(HashMap<String, f64>),
}

fn options(threshold: Option<Threshold>) -> Answer<Options> {
    let options = Options::default();
    match threshold {
        None => Ok(options),
        Some(Threshold::All(threshold)) => Ok(Options { threshold, ..options }),
        Some(Threshold::Each(own)) => own.into_iter().try_fold(options, |options, (key, most)| {
            let law = LawName::ALL.into_iter().find(|law| law.key() == key);
            let keys = LawName::ALL.map(LawName::key).join(", ");
            let unknown =
                || Refused::new("Undefined", "the law", format!("`{key}` is no law: these are {keys}"));
            Ok(options.with(law.ok_or_else(unknown)?, most))
        }),
    }
}

/// The principal moments, and the principal axes where they are not the body's own.
fn principal(inertia: &Given) -> ([f64; 3], Option<UnitQuaternion<f64>>) {
    let m = inertia.0.matrix();
    if m == Matrix3::from_diagonal(&m.diagonal()) {
        return (m.diagonal().into(), None);
    }
    let axes = inertia.0.principal();
    let frame = Rotation3::from_matrix_unchecked(axes.frame());
    (axes.moments().into(), Some(UnitQuaternion::from_rotation_matrix(&frame)))
}

/// Whether single precision holds all of these.
fn are_single<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> bool {
    numbers.into_iter().all(|x| f64::from(*x as f32) == *x)
}

/// Times as they are given, or the multiples of a step.
pub fn times(t: &Numbers<'_>, count: usize) -> Answer<(Vec<f64>, Option<f64>)> {
    let given = slice(t);
    match t.shape() {
        [] => Ok(((0..count).map(|i| i as f64 * given[0]).collect(), Some(given[0]))),
        [n] if *n == count => Ok((given.into_owned(), None)),
        shape => {
            let sentence =
                format!("t has the shape {shape:?}: it must be ({count},) as the rows are, or one step");
            Err(Refused::new("Shape", "t", sentence))
        }
    }
}

/// The kind of spins in this frame.
pub fn kind(frame: &str) -> Answer<Kind> {
    match frame {
        "world" => Ok(Kind::SpinWorld),
        "body" => Ok(Kind::SpinBody),
        _ => {
            let sentence = format!("frame is '{frame}': it must be 'world' or 'body'");
            Err(Refused::new("Undefined", "frame", sentence))
        }
    }
}

/// Times, the step if only that is given, the frame of the spins, attitudes and spins.
type Record = (Vec<f64>, Option<f64>, Kind, Option<Vec<UnitQuaternion<f64>>>, Vec<[f64; 3]>);

fn record(
    t: &Numbers<'_>,
    q: Option<&Bound<'_, PyAny>>,
    w: Option<Numbers<'_>>,
    frame: &str,
    scalar_first: bool,
) -> Answer<Record> {
    let attitudes = q.map(|q| Order { scalar_first }.attitudes(Some(q))).transpose()?.map(|q| q.0);
    let spins = w.map(|w| rows::<3>("w", &w)).transpose()?.map(|w| w.0);
    let count = attitudes.as_ref().map(Vec::len).or(spins.as_ref().map(Vec::len)).unwrap_or_default();
    if count == 0 {
        return Err(Refused::new("Shape", "q and w", "neither attitudes nor spins are given".into()));
    }
    let (times, step) = times(t, count)?;
    let kind = if spins.is_some() { kind(frame)? } else { Kind::Attitude };
    let spins = each("w", spins.unwrap_or_else(|| vec![[0.0; 3]]), count)?;
    Ok((times, step, kind, attitudes, spins))
}

/// Judges how an engine turns a body that nothing touches, from arrays that it recorded.
///
/// `t`: the times (n,), s, or the step as one number. `q`: attitudes (n, 4), body to world, x, y, z, w (with
/// `scalar_first=True` w, x, y, z, as in MuJoCo) or SciPy's `Rotation`. `w`: spins (n, 3), rad/s, in the axes
/// that `frame` names, 'world' or 'body'. One of `q` and `w` may be missing; a spin in world axes needs `q`.
/// `inertia`: the moments about the body's axes, or the tensor, kg m²; if the tensor has products, the record
/// is turned to its principal axes. Numbers of single precision are judged as such: pass the arrays without
/// converting them.
///
/// `engine` is the name of the engine that made the record. `threshold` is the largest error allowed, as one
/// number for every law or as a dict by law ('energy', 'momentum', 'direction', 'unit', 'separatrix',
/// 'phase', 'consistency'). `torque` is a torque that is constant in the world, N m.
///
/// Raises `Error` for a record that cannot be judged: a number that is not finite in the first two rows, or a
/// time that does not increase. If a later row has a number that is not finite, the rows before it are
/// judged, and the verdict says so.
///
/// >>> import numpy as np, tumbling
/// >>> t = np.arange(300) / 60
/// >>> q, w = tumbling.FreeMotion([1, 2, 3], spin=[0.5, 0.5, 10]).at(t)
/// >>> assert tumbling.judge(t, q, w, inertia=[1, 2, 3], frame='body').passed
/// >>> stuck = tumbling.judge(t, w=np.tile([0.5, 0.5, 10], (300, 1)), inertia=[1, 2, 3], frame='body')
/// >>> assert stuck.outcome == 'failed' and stuck.rule == 'no gyroscopic term'
#[pyfunction]
#[pyo3(signature = (
    t, q=None, w=None, *, inertia, frame="world", scalar_first=false, engine=None, torque=None,
    threshold=None
))]
pub fn judge(
    py: Python<'_>,
    t: Numbers<'_>,
    q: Option<&Bound<'_, PyAny>>,
    w: Option<Numbers<'_>>,
    inertia: Given,
    frame: &str,
    scalar_first: bool,
    engine: Option<String>,
    torque: Option<Numbers<'_>>,
    threshold: Option<Threshold>,
) -> Answer<Verdict> {
    let (times, step, kind, attitudes, spins) = record(&t, q, w, frame, scalar_first)?;
    let torque = torque.map(|torque| row("torque", &torque)).transpose()?.map(Vector3::from);
    let ((moments, axes), options) = (principal(&inertia), options(threshold)?);
    let single = axes.is_some()
        && are_single(spins.iter().flatten())
        && attitudes.iter().flatten().all(|q| are_single(&q.coords));
    let round = |x: f64| if single { f64::from(x as f32) } else { x };
    let rows = times.into_iter().zip(spins).enumerate().map(|(i, (time, spin))| {
        let attitude = attitudes.as_ref().map(|all| axes.map_or(all[i], |axes| all[i] * axes));
        let attitude = attitude.map(|q| [q.w, q.i, q.j, q.k].map(round));
        let turned = axes.filter(|_| kind == Kind::SpinBody).map(|axes| axes.inverse() * Vector3::from(spin));
        Row { time, attitude, spin: turned.map_or(spin, |spin| spin.map(round).into()) }
    });
    let description = Description { kind, engine, step, torque };
    Ok(Verdict { verdict: py.detach(|| judge_described(moments, description, rows, &options))? })
}

/// Whether records of one object show the same motion. `str()` gives the whole result in words.
#[pyclass(frozen, module = "tumbling")]
pub struct Comparison(tumbling_judge::Comparison);

#[pymethods]
impl Comparison {
    /// Whether all records show the same motion.
    #[getter]
    fn passed(&self) -> bool {
        self.0.others.is_empty()
    }

    /// The whole result as JSON text, the same as `tumbling-judge --json` prints for several files.
    fn json(&self) -> String {
        format!("{:#}", self.0.json())
    }

    fn __str__(&self) -> String {
        self.0.to_string()
    }
}

/// Compares records of one object that was described to an engine in several ways: as a single body, with
/// fixed children, with its origin off the centre, with its axes turned. All must show the same motion.
///
/// `records`: a dict by name of tuples (t, q) or (t, q, w), each as for `judge`. `threshold` is the largest
/// difference allowed: relative to the fastest spin for spins, in rad for attitudes. By default it
/// corresponds to a third of the digits.
///
/// Raises `Error` for a record that cannot be read, and for two with fewer than two times in common.
///
/// >>> import numpy as np, tumbling
/// >>> t, half = np.arange(300) / 60, np.sqrt(0.5)
/// >>> one = tumbling.FreeMotion([1, 2, 3], [0.5, 4, 0.7])
/// >>> turned = tumbling.FreeMotion([2, 1, 3], [4, -0.5, 0.7], [0, 0, half, half])
/// >>> records = {'one': (t, *one.at(t)), 'turned': (t, *turned.at(t))}
/// >>> assert tumbling.compare(records, frame='body').passed
#[pyfunction]
#[pyo3(signature = (records, *, frame="world", scalar_first=false, threshold=None))]
pub fn compare(
    py: Python<'_>,
    records: &Bound<'_, PyDict>,
    frame: &str,
    scalar_first: bool,
    threshold: Option<f64>,
) -> Answer<Comparison> {
    let mut all = Vec::new();
    for (name, given) in records {
        let (name, given): (String, Vec<Bound<'_, PyAny>>) = (name.extract()?, given.extract()?);
        let wrong = || Refused::new("Shape", &name, format!("{name} is not (t, q) or (t, q, w)"));
        let (t, more) = given.split_first().filter(|more| more.1.len() <= 2).ok_or_else(wrong)?;
        let w = more.get(1).map(|w| w.extract()).transpose()?;
        let (times, _, kind, attitudes, spins) = record(&t.extract()?, more.first(), w, frame, scalar_first)?;
        let attitudes = attitudes.ok_or_else(wrong)?;
        let rows = times.into_iter().zip(attitudes).zip(spins);
        let row = |((time, q), spin): ((_, UnitQuaternion<f64>), _)| {
            let attitude = Some([q.w, q.i, q.j, q.k]);
            Row { time, attitude, spin }
        };
        all.push((name, Motion::in_memory(kind, rows.map(row))?));
    }
    Ok(Comparison(py.detach(|| tumbling_judge::compare(&all, threshold))?))
}
