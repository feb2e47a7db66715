//! Conversion of arrays: times of any shape, rows of three or four numbers, attitudes with the scalar first
//! or last.

use crate::error::{Answer, Refused};
use nalgebra::{Matrix6, Quaternion, UnitQuaternion, Vector3};
use numpy::{
    AllowTypeChange, IntoPyArray, PyArrayDyn, PyArrayLikeDyn, PyArrayMethods, PyUntypedArrayMethods,
};
use pyo3::Borrowed;
use pyo3::prelude::*;
use std::borrow::Cow;
use std::ops::Deref;

/// Real numbers: an array of any real type, or any object that NumPy converts to one.
pub struct Numbers<'py>(PyArrayLikeDyn<'py, f64, AllowTypeChange>);

impl<'py> Deref for Numbers<'py> {
    type Target = PyArrayLikeDyn<'py, f64, AllowTypeChange>;
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl<'a, 'py> FromPyObject<'a, 'py> for Numbers<'py> {
    type Error = PyErr;

    fn extract(given: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        let numpy = given.py().import("numpy")?;
        // NumPy itself would drop the imaginary parts, the units of time and the mask.
        let masked = given.is_instance(&numpy.getattr("ma")?.getattr("MaskedArray")?)?;
        let array = numpy.call_method1("asarray", (given,))?;
        let dtype = array.getattr("dtype")?;
        let kind: String = dtype.getattr("kind")?.extract()?;
        // "O" are Python objects; each of them tells whether it is a real number.
        if masked || !"biufO".contains(&kind) {
            let found = if masked { "a masked array".into() } else { format!("an array of {dtype}") };
            let sentence = format!("{found} is not taken for numbers: give an array of real ones");
            return Err(Refused::new("Type", "numbers", sentence).into());
        }
        array.extract().map(Self)
    }
}

pub type Array<'py> = Bound<'py, PyArrayDyn<f64>>;
/// Attitudes and spins.
pub type States<'py> = (Array<'py>, Array<'py>);

/// The numbers row by row: without a copy if they are stored so. (Column-major arrays are contiguous too, so
/// the order must be checked.)
pub fn slice<'a>(numbers: &'a Numbers<'_>) -> Cow<'a, [f64]> {
    match numbers.as_slice() {
        Ok(there) if numbers.is_c_contiguous() => Cow::Borrowed(there),
        _ => Cow::Owned(numbers.as_array().iter().copied().collect()),
    }
}

/// An array of this shape that takes ownership of the numbers.
pub fn array<'py>(py: Python<'py>, numbers: Vec<f64>, shape: &[usize], last: &[usize]) -> Answer<Array<'py>> {
    Ok(numbers.into_pyarray(py).reshape([shape, last].concat())?)
}

/// Rows of `N` numbers, and whether the array is one row alone.
pub fn rows<const N: usize>(what: &str, numbers: &Numbers<'_>) -> Answer<(Vec<[f64; N]>, bool)> {
    let shape = numbers.shape();
    if !matches!(shape, [n] | [_, n] if *n == N) {
        let sentence = format!("{what} has the shape {shape:?}: it must be ({N},) or (n, {N})");
        return Err(Refused::new("Shape", what, sentence));
    }
    Ok((slice(numbers).as_chunks().0.to_vec(), shape.len() == 1))
}

/// One row of `N` numbers.
pub fn row<const N: usize>(what: &str, numbers: &Numbers<'_>) -> Answer<[f64; N]> {
    match rows(what, numbers)? {
        (one, true) => Ok(one[0]),
        _ => Err(Refused::new("Shape", what, format!("{what} has several rows: it must be ({N},)"))),
    }
}

/// One row for each of `count` bodies, or one row for all of them.
pub fn each<T: Copy>(what: &str, rows: Vec<T>, count: usize) -> Answer<Vec<T>> {
    match rows.len() {
        1 => Ok(vec![rows[0]; count]),
        n if n == count => Ok(rows),
        n => Err(Refused::new("Shape", what, format!("{what} is of {n} bodies, and others are of {count}"))),
    }
}

/// A quaternion in the given order: x, y, z, w, or the scalar first.
#[derive(Clone, Copy)]
pub struct Order {
    pub scalar_first: bool,
}

impl Order {
    pub fn read(self, q: [f64; 4]) -> UnitQuaternion<f64> {
        let [w, x, y, z] = if self.scalar_first { q } else { [q[3], q[0], q[1], q[2]] };
        UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z))
    }

    pub fn write(self, q: &Quaternion<f64>) -> [f64; 4] {
        if self.scalar_first { [q.w, q.i, q.j, q.k] } else { [q.i, q.j, q.k, q.w] }
    }

    /// Attitudes: numbers in this order, or SciPy's `Rotation`, which defines its own order; the identity if
    /// none is given.
    pub fn attitudes(self, given: Option<&Bound<'_, PyAny>>) -> Answer<(Vec<UnitQuaternion<f64>>, bool)> {
        let Some(given) = given else { return Ok((vec![UnitQuaternion::identity()], true)) };
        let (numbers, order) = if given.hasattr("as_quat")? {
            (given.call_method0("as_quat")?.extract::<Numbers<'_>>()?, Self { scalar_first: false })
        } else {
            (given.extract::<Numbers<'_>>()?, self)
        };
        let (rows, alone) = rows("attitude", &numbers)?;
        Ok((rows.into_iter().map(|q| order.read(q)).collect(), alone))
    }

    pub fn attitude(self, given: Option<&Bound<'_, PyAny>>) -> Answer<UnitQuaternion<f64>> {
        match self.attitudes(given)? {
            (one, true) => Ok(one[0]),
            _ => Err(Refused::new("Shape", "attitude", "attitude is of several bodies: one is meant".into())),
        }
    }

    /// The states at each time; the interpreter's lock is released meanwhile.
    pub fn at_each<'py>(
        self,
        py: Python<'py>,
        times: &Numbers<'py>,
        mut state: impl FnMut(f64) -> Result<(UnitQuaternion<f64>, Vector3<f64>), tumbling::Error> + Send,
    ) -> Answer<States<'py>> {
        let (all, shape) = (slice(times), times.shape());
        let (q, w) = py.detach(|| {
            let (mut q, mut w) = (Vec::with_capacity(4 * all.len()), Vec::with_capacity(3 * all.len()));
            for &t in all.iter() {
                let (attitude, omega) = state(t)?;
                q.extend(self.write(&attitude));
                w.extend(omega.iter());
            }
            Ok::<_, tumbling::Error>((q, w))
        })?;
        Ok((array(py, q, shape, &[4])?, array(py, w, shape, &[3])?))
    }
}

/// Row by row.
pub fn put_matrix(into: &mut Vec<f64>, matrix: &Matrix6<f64>) {
    into.extend(matrix.transpose().iter());
}

/// Allocates memory for this many numbers, or fails.
pub fn room(what: &str, count: u64) -> Answer<Vec<f64>> {
    let mut all = Vec::new();
    match usize::try_from(count).map(|count| all.try_reserve_exact(count)) {
        Ok(Ok(())) => Ok(all),
        _ => {
            let sentence = format!("{what} are {count} numbers: more than there is memory to hold");
            Err(Refused::new("TooMany", what, sentence))
        }
    }
}

/// Times of flips, if they fit in memory.
pub fn listed<'py>(py: Python<'py>, times: impl Iterator<Item = f64>, count: u64) -> Answer<Array<'py>> {
    let mut all = room("the times of flips", count)?;
    all.extend(times);
    let count = all.len();
    array(py, all, &[count], &[])
}
