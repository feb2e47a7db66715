//! Records in memory: rows from an iterator, without text.

use crate::error::{Error, not_later};
use crate::judge::judge_rows;
use crate::options::Options;
use crate::read::{Exact, Kind, Printed, Raw, Said, Source, significant_bits};
use crate::thresholds::*;
use crate::verdict::Verdict;
use nalgebra::{Quaternion, RealField, Vector3};

/// The precision of an engine's numbers: `f64`, `f32`, or any other real number that converts to `f64`.
pub trait Precision: RealField + Into<f64> + Copy {}

impl<T: RealField + Into<f64> + Copy> Precision for T {}

/// A body at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row<T> {
    /// The time, s.
    pub time: f64,
    /// The attitude as a quaternion w, x, y, z, body to world; `None` where the engine gives none.
    pub attitude: Option<[T; 4]>,
    /// The spin in body axes, rad/s, unless the [`Description`] names another vector.
    pub spin: [T; 3],
}

/// A description of rows in memory, in place of a file's header and column names.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Description {
    /// The meaning of a row's three numbers; not read if the record has attitudes alone.
    pub kind: Kind,
    /// The engine's name.
    pub engine: Option<String>,
    /// The engine's step, s.
    pub step: Option<f64>,
    /// A torque that is constant in the world, N m.
    pub torque: Option<Vector3<f64>>,
}

/// Judges rows in memory, of a body with these principal moments (kg m², about its axes x, y and z).
///
/// [`Options::inertia`] takes precedence over the moments. The verdict counts rows from 1 and calls them
/// lines.
///
/// ```
/// use tumbling_judge::{Options, Outcome, Row, judge_in_memory};
/// // A body without a gyroscopic term, in single precision.
/// let rows = (0..100).map(|i| Row { time: 0.1 * f64::from(i), attitude: None, spin: [0.1_f32, 2.0, 0.1] });
/// let verdict = judge_in_memory([1.0, 2.0, 3.0], rows, &Options::default())?;
/// assert_eq!(verdict.outcome, Outcome::Failed);
/// assert_eq!(verdict.diagnosis.unwrap().best.rule.name(), "no gyroscopic term");
/// # Ok::<(), tumbling_judge::Error>(())
/// ```
///
/// # Errors
/// Moments that no body has, fewer than two rows, a time that does not increase, a number that is not finite
/// in one of the first two rows, attitudes in some rows alone.
pub fn judge_in_memory<T: Precision>(
    moments: [f64; 3],
    rows: impl IntoIterator<Item = Row<T>>,
    options: &Options,
) -> Result<Verdict, Error> {
    judge_described(moments, Description::default(), rows, options)
}

/// Judges rows in memory with a description, as [`judge_in_memory`] does without one.
///
/// ```
/// use tumbling_judge::{Description, Kind, Options, Row, judge_described};
/// // A quarter turn about x, and a spin that stands still in the world: about y there, about -z in the body.
/// let (half, world) = (0.5_f64.sqrt(), Description { kind: Kind::SpinWorld, ..Description::default() });
/// let row = |time: f64| Row { time, attitude: Some([half, half, 0.0, 0.0]), spin: [0.0, 2.0, 0.0] };
/// let verdict = judge_described([1.0, 2.0, 3.0], world, [0.0, 0.1, 0.2].map(row), &Options::default())?;
/// assert!((verdict.curve[0].spin - nalgebra::Vector3::new(0.0, 0.0, -2.0)).norm() < 1e-15);
/// # Ok::<(), tumbling_judge::Error>(())
/// ```
///
/// # Errors
/// As [`judge_in_memory`]; also vectors in world axes, or attitudes alone, where the first row has no
/// attitude.
pub fn judge_described<T: Precision>(
    moments: [f64; 3],
    description: Description,
    rows: impl IntoIterator<Item = Row<T>>,
    options: &Options,
) -> Result<Verdict, Error> {
    let mut rows = rows.into_iter().peekable();
    let first = rows.peek().ok_or(Error::NoRows)?;
    let Description { kind, engine, step, torque } = description;
    let attitudes = first.attitude.is_some();
    if !attitudes && (kind.in_world() || kind == Kind::Attitude) {
        let problem = "a vector in world axes cannot be used without an attitude".into();
        return Err(Error::Row { row: 1, problem });
    }
    let moments = options.inertia.or_else(|| Some(moments.into()));
    let torque = torque.filter(|torque| *torque != Vector3::zeros());
    let said = Said { kind, engine, step, torque, moments, ..Said::default() };
    judge_rows(&mut Memory::of(rows, attitudes), said, options)
}

/// Rows of an iterator.
pub(crate) struct Memory<I> {
    rows: I,
    attitudes: bool,
    count: usize,
    last: f64,
    ended: Option<Error>,
}

impl<I> Memory<I> {
    pub(crate) const fn of(rows: I, attitudes: bool) -> Self {
        Self { rows, attitudes, count: 0, last: f64::NEG_INFINITY, ended: None }
    }
}

impl<T: Precision, I: Iterator<Item = Row<T>>> Source for Memory<I> {
    fn next(&mut self) -> Result<Option<Raw>, Error> {
        let next = if self.ended.is_none() { self.rows.next() } else { None };
        let Some(row) = next else { return Ok(None) };
        self.count += 1;
        let wrong = |problem: String| Error::Row { row: self.count, problem };
        let spin = Vector3::from(row.spin.map(Into::into));
        let attitude = row.attitude.map(|q| {
            let [w, x, y, z] = q.map(Into::into);
            Quaternion::new(w, x, y, z)
        });
        if attitude.is_some() != self.attitudes {
            return Err(wrong("some rows have an attitude, but others have none".into()));
        }
        let numbers = || spin.iter().chain(attitude.iter().flat_map(|q| q.coords.iter())).copied();
        let bad = numbers().chain([row.time]).find(|x| !x.is_finite()).map(|bad| format!("a value is {bad}"));
        let none =
            || attitude.filter(|q| q.coords.amax() == 0.0).map(|_| "the quaternion has no length".into());
        if let Some(bad) = bad.or_else(none) {
            let ended = wrong(format!("{bad}: from here on there is no motion"));
            if (self.count as u64) <= ROWS_BEFORE_THE_END {
                return Err(ended);
            }
            self.ended = Some(ended);
            return Ok(None);
        }
        if row.time <= self.last {
            return Err(wrong(not_later(row.time, self.last)));
        }
        self.last = row.time;
        Ok(Some(Raw {
            line: self.count,
            t: row.time,
            attitude,
            vector: spin,
            position: Vector3::zeros(),
            printed: Printed::default(),
            exact: [&row.attitude.map_or(Vec::new(), Vec::from)[..], &row.spin[..]].map(|numbers| Exact {
                digits: MOST_DIGITS,
                bits: numbers.iter().map(|x| significant_bits((*x).into())).max().unwrap_or(0),
                place: f64::INFINITY,
            }),
        }))
    }

    fn ended(&mut self) -> Option<Error> {
        self.ended.take()
    }
}
