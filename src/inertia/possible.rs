//! Which tensors a body can have, up to rounding, and the nearest possible tensor.

use super::{Inertia, PrincipalAxes, ascending, in_range, is_diagonal, moments_of, symmetrized, turned};
use crate::error::{Error, ErrorKind, Refusal, Subject, finite, not_negative, positive, representable};
use crate::number::{exponent, times_power_of_two, ulp};
use nalgebra::{Matrix3, Vector3};

/// The number of units in the last place of the largest moment that count as rounding: twice the largest
/// error observed (16.5) when tensors of flat plates were turned to three million attitudes and back by `R I
/// R^T`.
const ROUNDING_ULPS: f64 = 32.0;

/// The same for a diagonal tensor, whose moments are the sums of a few terms.
pub(super) const DIAGONAL_ROUNDING_ULPS: f64 = 4.0;

/// If a tensor is nearer than this to a possible one, relative to the largest entry, the error message
/// mentions [`Inertia::within`]: about the rounding of two printed digits.
const PRINTED: f64 = 1e-2;

/// The names of the entries of the matrix, by columns.
const ENTRIES: [Subject; 9] = {
    use Subject::{Ixx, Ixy, Ixz, Iyy, Iyz, Izz};
    [Ixx, Ixy, Ixz, Ixy, Iyy, Iyz, Ixz, Iyz, Izz]
};

impl Inertia {
    /// A tensor that this library has summed from masses. It is possible by construction, up to the rounding
    /// of its sums, so only its range is checked.
    pub(crate) fn of_masses(tensor: Matrix3<f64>) -> Result<Self, Error> {
        in_range(Subject::Moment, &tensor)?;
        representable(Subject::PrincipalMoment, moments_of(&tensor).as_slice())?;
        Ok(Self { tensor: symmetrized(&tensor) })
    }

    /// The tensor with this matrix, whose entries may be off by rounding.
    pub(super) fn rounded(tensor: &Matrix3<f64>) -> Result<Self, Error> {
        tensor.iter().zip(ENTRIES).try_for_each(|(&entry, what)| finite(what, entry).map(drop))?;
        let tolerance = ROUNDING_ULPS * ulp(tensor.amax());
        for (row, column) in [(0, 1), (0, 2), (1, 2)] {
            let (value, mirrored) = (tensor[(row, column)], tensor[(column, row)]);
            let difference = (value - mirrored).abs();
            let printed = difference <= PRINTED * tensor.amax();
            Refusal::Asymmetric { row, column, value, mirrored, tolerance, printed }
                .when(difference > tolerance)?;
        }
        let tensor = symmetrized(tensor);
        // Given moments have only their own rounding; moments of a turned tensor also have the rounding of
        // the rotation.
        let (ulps, tolerance) =
            if is_diagonal(&tensor) { (DIAGONAL_ROUNDING_ULPS, 0.0) } else { (ROUNDING_ULPS, tolerance) };
        for axis in 0..3 {
            not_below_zero(ENTRIES[4 * axis], tensor[(axis, axis)], tensor.amax(), tolerance)?;
        }
        positive(Subject::LargestMoment, tensor.diagonal().max())?;
        let moments = moments_of(&tensor);
        // The largest can exceed every entry of the tensor.
        representable(Subject::PrincipalMoment, moments.as_slice())?;
        physically_possible(&moments, ulps * ulp(moments[2]))?;
        Ok(Self { tensor })
    }

    /// The possible tensor nearest to a matrix whose digits were rounded, for instance from a printed table,
    /// a file in single precision or another program. A possible tensor is symmetric, has no negative moment,
    /// and satisfies the triangle inequality.
    ///
    /// A matrix that `try_from` accepts gives the same tensor here. Otherwise the result is the possible
    /// tensor at the least distance in the Frobenius norm: mirrored entries are replaced by their mean, the
    /// principal axes stay the same, and the principal moments become the nearest that a body can have. An
    /// impossible matrix gives a flat body or a rod.
    ///
    /// Returns the tensor and its distance from the given one, relative to the given largest principal
    /// moment. The distance is at most `relative_tolerance`; for values of four digits use about 1e-3.
    ///
    /// ```
    /// use nalgebra::{Matrix3, Vector3};
    /// use tumbling::Inertia;
    /// // A flat panel with four digits: the largest moment exceeds the sum of the others by 7e-6.
    /// let printed = Matrix3::from_diagonal(&Vector3::new(0.003333, 0.01333, 0.01667));
    /// assert!(Inertia::try_from(printed).is_err());
    /// let (panel, moved) = Inertia::within(&printed, 1e-3)?;
    /// assert_eq!(format!("{moved:.1e}"), "2.4e-4");
    /// assert_eq!(format!("{:.6}", panel.matrix().m33), "0.016668");
    /// assert!(Inertia::within(&printed, 1e-4).is_err());
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// An entry that is not finite; a tolerance that is not finite or is negative; a nearest tensor that is
    /// farther than the tolerance or is zero; or moments beyond `f64`.
    pub fn within(tensor: &Matrix3<f64>, relative_tolerance: f64) -> Result<(Self, f64), Error> {
        not_negative(Subject::RelativeTolerance, relative_tolerance)?;
        let strict = Self::rounded(tensor);
        if strict.as_ref().is_err_and(|error| error.kind() == ErrorKind::NotFinite) || tensor.amax() == 0.0 {
            return strict.map(|value| (value, 0.0));
        }
        let scale = exponent(tensor.amax());
        let given = tensor.map(|x| times_power_of_two(x, -scale));
        let symmetric = symmetrized(&given);
        let moments = moments_of(&symmetric);
        if moments[2] <= 0.0 {
            return strict.map(|value| (value, 0.0));
        }
        let distance = |nearest: &Matrix3<f64>| (nearest - given).norm() / moments[2];
        if let Ok(value) = strict {
            return Ok((value, distance(&symmetric)));
        }
        let adjusted = if is_diagonal(&symmetric) {
            Matrix3::from_diagonal(&nearest_possible(&symmetric.diagonal()))
        } else {
            let change = nearest_possible(&moments) - moments;
            let frame = PrincipalAxes::of(&symmetric).frame();
            symmetrized(&(symmetric + turned(&frame, &Matrix3::from_diagonal(&change))))
        };
        let (moved, tolerance) = (distance(&adjusted), relative_tolerance);
        Refusal::TooFar { moved, tolerance }.when(moved > tolerance)?;
        let value = Self::try_from(adjusted.map(|x| times_power_of_two(x, scale)))?;
        Ok((value, moved))
    }
}

/// Checks that `moments`, smallest first, can belong to a body: none is negative, and none exceeds the sum of
/// the other two, up to rounding.
pub(super) fn physically_possible(moments: &Vector3<f64>, tolerance: f64) -> Result<(), Error> {
    not_below_zero(Subject::SmallestMoment, moments[0], moments[2], tolerance)?;
    let excess = (moments[2] - moments[1]) - moments[0];
    let (moments, printed) = ((*moments).into(), excess <= PRINTED * moments[2]);
    Refusal::TriangleInequality { moments, excess, tolerance, printed }.when(excess > tolerance)
}

fn not_below_zero(what: Subject, value: f64, largest: f64, tolerance: f64) -> Result<(), Error> {
    Refusal::NegativeMoment { what, value, printed: -value <= PRINTED * largest }.when(value < -tolerance)
}

/// The possible moments nearest to `moments`, which may be in any order. Possible means that none is negative
/// and none exceeds the sum of the other two.
///
/// Possible moments form a cone. Its edges are the rods, such as (0, 1, 1), and its faces are the flat
/// bodies. Moments outside the cone are projected onto a face; if the projection has a negative moment, onto
/// an edge; and if that is negative too, onto zero.
///
/// With the principal axes of the given tensor, they also give the nearest tensor in the Frobenius norm: the
/// distance of two symmetric matrices is at least the distance of their sorted eigenvalues
/// [HW53](crate::references).
pub(super) fn nearest_possible(moments: &Vector3<f64>) -> Vector3<f64> {
    let order = ascending(moments);
    let [a, b, c] = order.map(|i| moments[i]);
    let excess = (c - b) - a;
    let sorted = if excess <= 0.0 {
        [a, b, c]
    } else if a + excess / 3.0 > 0.0 {
        let (a, b) = (a + excess / 3.0, b + excess / 3.0);
        [a, b, a + b]
    } else {
        let rod = (0.5 * b + 0.5 * c).max(0.0);
        [0.0, rod, rod]
    };
    let mut nearest = Vector3::zeros();
    for (place, moment) in order.into_iter().zip(sorted) {
        nearest[place] = moment;
    }
    nearest
}
