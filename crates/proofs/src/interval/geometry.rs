//! Lengths, angles and principal axes of intervals.

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

/// The smallest principal moment of a positive tensor.
///
/// Left of its smallest root, the characteristic polynomial (of three real roots) is positive, decreasing and
/// convex; nowhere else is it all of these. So two of its values enclose the root, and bisection narrows the
/// enclosure.
///
/// ```
/// use nalgebra::Matrix3;
/// use tumbling_proofs::{Interval, Rational, interval::geometry::smallest_moment};
/// let tensor = Matrix3::new(6, 1, 0, 1, 6, 0, 0, 0, 9).map(|n: i64| Interval::from(Rational::from(n)));
/// assert_eq!(format!("{:.9}", smallest_moment(&tensor)), "5.000000000");
/// ```
#[must_use]
pub fn smallest_moment(tensor: &Matrix3<Interval>) -> Interval {
    let at = |x: Interval| {
        let m = tensor - Matrix3::from_diagonal_element(x);
        let minor = |i: usize, j: usize| m[(i, i)] * m[(j, j)] - m[(i, j)] * m[(j, i)];
        let cross = |i: usize, j: usize| m[(1, i)] * m[(2, j)] - m[(1, j)] * m[(2, i)];
        let value = m[(0, 0)] * cross(1, 2) - m[(0, 1)] * cross(0, 2) + m[(0, 2)] * cross(0, 1);
        (value, minor(0, 1) + minor(1, 2) + minor(0, 2), m[(0, 0)] + m[(1, 1)] + m[(2, 2)])
    };
    let zero = Interval::zero();
    let trace = tensor[(0, 0)] + tensor[(1, 1)] + tensor[(2, 2)];
    let (mut low, mut high) = (0.0, trace.high());
    let mut sure = false;
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        let (value, minus_slope, bend) = at(Interval { low: middle, high: middle });
        // Beyond the first bend the polynomial may be of either sign: such a point lies above the root.
        if value > zero && minus_slope > zero && bend > zero {
            low = middle;
        } else if value < zero || minus_slope < zero || bend < zero {
            high = middle;
            sure = true;
        } else {
            break;
        }
    }
    if sure { Interval { low, high } } else { Interval::ALL }
}

/// The direction of the axis with this moment: at a right angle to two rows of the tensor without it.
///
/// Its sign has no meaning. If the two rows may be parallel, all vectors are possible.
#[must_use]
pub fn axis_of(tensor: &Matrix3<Interval>, moment: Interval) -> Vector3<Interval> {
    let rest = tensor - Matrix3::from_diagonal_element(moment);
    let row = |i: usize| rest.row(i).transpose();
    row(0).cross(&row(1))
}

/// The matrix of a turn by this angle (radians) about the z axis.
#[must_use]
pub fn about_z(angle: Interval) -> Matrix3<Interval> {
    let (sine, cosine) = angle.sin_cos();
    let (zero, one) = (Interval::zero(), Interval::integer(1));
    Matrix3::new(cosine, -sine, zero, sine, cosine, zero, zero, zero, one)
}
