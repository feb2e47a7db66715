//! Lengths, angles and turns of intervals.

use super::Interval;
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;
use tumbling::number::Ring;

/// The length of a vector.
#[must_use]
pub fn length(v: &Vector3<Interval>) -> Interval {
    v.iter().fold(Interval::zero(), |sum, x| sum + x.square()).sqrt()
}

/// The angle between two vectors, from their cross product, in radians.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling_proofs::{Interval, given, interval::geometry::angle};
/// let a = Vector3::<Interval>::new(given!(1), given!(0), given!(0));
/// let b = Vector3::new(given!(1), given!(1), given!(0));
/// assert_eq!(format!("{:.9}", angle(&a, &b).to_degrees()), "45.000000000");
/// ```
#[must_use]
pub fn angle(a: &Vector3<Interval>, b: &Vector3<Interval>) -> Interval {
    length(&a.cross(b)).atan2(a.dot(b))
}

/// The matrix of a turn by this angle (radians) about the z axis.
#[must_use]
pub fn about_z(angle: Interval) -> Matrix3<Interval> {
    let (sine, cosine) = angle.sin_cos();
    let (zero, one) = (Interval::zero(), Interval::integer(1));
    Matrix3::new(cosine, -sine, zero, sine, cosine, zero, zero, zero, one)
}
