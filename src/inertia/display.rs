//! Tensors and axes as text.

use super::{Axis, Inertia, PrincipalAxes};
use alloc::format;
use alloc::string::String;
use alloc::string::ToString as _;
use core::fmt;
use nalgebra::Matrix3;

fn number(x: f64, f: &fmt::Formatter<'_>) -> String {
    f.precision().map_or_else(|| x.to_string(), |digits| format!("{x:.digits$}"))
}

/// Three rows, the columns aligned to the right.
fn table(matrix: &Matrix3<f64>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let cells = matrix.map(|x| number(x, f));
    let width = cells.iter().map(String::len).max().unwrap_or(0);
    for i in 0..3 {
        let end = if i < 2 { "\n" } else { "" };
        write!(f, "{:>width$}  {:>width$}  {:>width$}{end}", cells[(i, 0)], cells[(i, 1)], cells[(i, 2)])?;
    }
    Ok(())
}

/// The matrix in kg m², a row a line; a precision goes to each entry.
///
/// ```
/// let tensor = tumbling::Inertia::new([10.0, 13.0, 5.0], [0.5, 0.0, -1.25])?;
/// assert_eq!(format!("{tensor:.1}"), "10.0   0.5   0.0\n 0.5  13.0  -1.2\n 0.0  -1.2   5.0");
/// # Ok::<(), tumbling::Error>(())
/// ```
impl fmt::Display for Inertia {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        table(&self.matrix(), f)
    }
}

/// An axis a line: its moment in kg m² and its direction in the body; a precision goes to each number.
///
/// ```
/// let axes = tumbling::Inertia::from_moments(10.0, 13.0, 5.0)?.principal();
/// assert_eq!(
///     format!("{axes:.1}"),
///     "smallest   5.0 kg m² along (0.0, 0.0, 1.0)\n\
///      middle    10.0 kg m² along (1.0, 0.0, 0.0)\n\
///      largest   13.0 kg m² along (0.0, 1.0, 0.0)"
/// );
/// # Ok::<(), tumbling::Error>(())
/// ```
impl fmt::Display for PrincipalAxes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let moments = Axis::ALL.map(|axis| number(self.moment(axis), f));
        let width = moments.iter().map(String::len).max().unwrap_or(0);
        for (axis, moment) in Axis::ALL.into_iter().zip(&moments) {
            let [x, y, z] = <[f64; 3]>::from(self.axis(axis)).map(|x| number(x, f));
            let end = if axis == Axis::Largest { "" } else { "\n" };
            write!(f, "{axis:<8}  {moment:>width$} kg m² along ({x}, {y}, {z}){end}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Smallest => "smallest",
            Self::Middle => "middle",
            Self::Largest => "largest",
        })
    }
}
