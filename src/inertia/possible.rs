//! Which tensors a body can have, to rounding, and the nearest of them.

use super::{Inertia, PrincipalAxes, ascending, in_range, is_diagonal, moments_of, symmetrized, turned};
use crate::error::{Error, ErrorKind, Refusal, Subject, finite, not_negative, positive, representable};
use crate::number::{exponent, times_power_of_two, ulp};
use nalgebra::{Matrix3, Vector3};

/// The number of units in the last place of the largest moment that count as rounding: twice what was
/// observed when flat plates, turned to three million attitudes and back, came out of `R I R^T` (16.5).
const ROUNDING_ULPS: f64 = 32.0;

/// What counts as rounding for a diagonal tensor, whose moments come from a sum or two.
pub(super) const DIAGONAL_ROUNDING_ULPS: f64 = 4.0;

/// How far relative to the largest entry a tensor may be from a possible one for the message to point at
/// [`Inertia::within`]: what two printed digits leave open.
const PRINTED: f64 = 1e-2;

/// What the entries of the matrix are called, by columns.
const ENTRIES: [Subject; 9] = {
    use Subject::{Ixx, Ixy, Ixz, Iyy, Iyz, Izz};
    [Ixx, Ixy, Ixz, Ixy, Iyy, Iyz, Ixz, Iyz, Izz]
};

impl Inertia {
    /// A tensor summed up by this library from real masses: possible by construction, to whatever rounding
    /// its sums have, so only its range is checked.
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
        // Moments that were given are as exact as they stand; those of a turned tensor carry the rounding of
        // a turn.
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

    /// The tensor nearest to one whose digits were rounded, as printed tables, files in single precision and
    /// other programs give it: symmetric, without a negative moment, and within the triangle inequality.
    ///
    /// What `try_from` takes is taken as there. Otherwise it is the tensor with the
    /// least distance in the Frobenius norm: mirrored entries get their mean, the principal axes stay, and
    /// the principal moments go to the nearest that a body can have. A flat body or a rod comes out where the
    /// given one was impossible.
    ///
    /// Returns the tensor and its distance from the given one, relative to the largest principal moment given
    /// and at most `relative_tolerance`; four digits want about 1e-3.
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
    /// An entry that is not finite, a tolerance that is not finite or below zero, a nearest tensor that is
    /// farther away than the tolerance or zero, or moments beyond `f64`.
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

/// That `moments`, smallest first, can belong to a body: none below zero, and no one above the sum of
/// the other two, to rounding.
pub(super) fn physically_possible(moments: &Vector3<f64>, tolerance: f64) -> Result<(), Error> {
    not_below_zero(Subject::SmallestMoment, moments[0], moments[2], tolerance)?;
    let excess = (moments[2] - moments[1]) - moments[0];
    let (moments, printed) = ((*moments).into(), excess <= PRINTED * moments[2]);
    Refusal::TriangleInequality { moments, excess, tolerance, printed }.when(excess > tolerance)
}

fn not_below_zero(what: Subject, value: f64, largest: f64, tolerance: f64) -> Result<(), Error> {
    Refusal::NegativeMoment { what, value, printed: -value <= PRINTED * largest }.when(value < -tolerance)
}

/// The moments nearest to `moments`, in any order, that a body can have: none below zero, none above the sum
/// of the other two.
///
/// Possible moments form a cone whose edges are the rods, (0, 1, 1) and its like, and whose faces are the
/// flat bodies. What lies outside is projected onto the flat bodies; if that leaves a moment below zero, onto
/// the rods; and if they are all on the far side, onto zero.
///
/// They also give the nearest tensor in the Frobenius norm, with the principal axes of the one given: no two
/// symmetric matrices are nearer than their sorted eigenvalues are [HW53](crate::references).
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
