//! Principal axes: the three perpendicular directions about which a body can spin steadily.

use super::{Inertia, PrincipalMoments, ascending, is_diagonal};
use crate::error::Error;
use crate::number::functions::hypot;
use crate::number::{exponent, times_power_of_two, ulp};
use core::fmt;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// One of a body's three principal axes, named by its moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Axis {
    /// The axis with the smallest moment.
    Smallest,
    /// The axis with the middle moment: a spin about it is unstable.
    Middle,
    /// The axis with the largest moment.
    Largest,
}

impl Axis {
    /// The three axes, smallest moment first.
    pub const ALL: [Self; 3] = [Self::Smallest, Self::Middle, Self::Largest];

    /// Its index among the sorted moments: 0, 1 or 2.
    pub(crate) const fn index(self) -> usize {
        self as usize
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

/// The principal moments and axes of an inertia tensor, from
/// [`Inertia::principal`](crate::Inertia::principal).
///
/// The frame is right-handed and reproducible. With three different moments, the sign of each of the first
/// two axes makes its first large component (above 0.57) positive, and the third axis completes the frame.
/// Where two moments are equal to rounding, this rule sets the sign of the third moment's axis. Any direction
/// perpendicular to it is principal then; the first of the other two axes is the one nearest to the body axis
/// that is most nearly perpendicular to it. Where all three are equal, the frame is the body axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalAxes {
    moments: Vector3<f64>,
    frame: Matrix3<f64>,
}

impl PrincipalAxes {
    /// The moments in kg m², smallest first. The first moment of an ideal rod is zero to rounding, and may be
    /// negative by a few units in the last place of the largest.
    #[must_use]
    pub fn moments(&self) -> Vector3<f64> {
        self.moments
    }

    /// The moment about `axis`, kg m².
    #[must_use]
    pub fn moment(&self, axis: Axis) -> f64 {
        self.moments[axis.index()]
    }

    /// The unit vector along `axis`, in the body frame of the tensor.
    #[must_use]
    pub fn axis(&self, axis: Axis) -> Vector3<f64> {
        self.frame.column(axis.index()).into_owned()
    }

    /// The three axes as columns, smallest moment first: the rotation matrix from principal axes to body
    /// axes.
    #[must_use]
    pub fn frame(&self) -> Matrix3<f64> {
        self.frame
    }

    /// The rotation of [`frame`](Self::frame) as a unit quaternion.
    pub(crate) fn rotation(&self) -> UnitQuaternion<f64> {
        UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(self.frame))
    }

    /// The principal axes of a symmetric, finite, nonzero matrix.
    pub(super) fn of(tensor: &Matrix3<f64>) -> Self {
        let (scale, (moments, axes)) = if is_diagonal(tensor) {
            (0, (tensor.diagonal(), Matrix3::identity()))
        } else {
            let scale = exponent(tensor.amax());
            (scale, diagonalized(tensor.map(|x| times_power_of_two(x, -scale))))
        };
        let order = ascending(&moments);
        let moments = Vector3::from(order.map(|i| moments[i]));
        let axes = order.map(|i| axes.column(i).into_owned());
        Self {
            frame: canonical_frame(&moments, &axes),
            moments: moments.map(|x| times_power_of_two(x, scale)),
        }
    }
}

impl Inertia {
    /// The moments along the body axes if these are principal, otherwise along the principal axes; with the
    /// rotation from the axes of the moments to the body axes.
    ///
    /// # Errors
    /// A smallest moment that is not positive, as in an ideal rod.
    pub(crate) fn along_principal_axes(
        &self,
    ) -> Result<(PrincipalMoments, Option<UnitQuaternion<f64>>), Error> {
        if is_diagonal(&self.tensor) {
            return Ok((PrincipalMoments::of_tensor(self.tensor.diagonal())?, None));
        }
        let principal = self.principal();
        Ok((principal.try_into()?, Some(principal.rotation())))
    }
}

/// The moments of a body that can turn about each axis, smallest first.
///
/// # Errors
/// A smallest moment that is not positive, as in an ideal rod.
impl TryFrom<PrincipalAxes> for PrincipalMoments {
    type Error = Error;

    fn try_from(axes: PrincipalAxes) -> Result<Self, Error> {
        Self::of_tensor(axes.moments)
    }
}

/// The principal moments of a symmetric, finite, nonzero matrix, smallest first.
pub(crate) fn moments_of(tensor: &Matrix3<f64>) -> Vector3<f64> {
    if is_diagonal(tensor) {
        let diagonal = tensor.diagonal();
        return ascending(&diagonal).map(|i| diagonal[i]).into();
    }
    PrincipalAxes::of(tensor).moments
}

/// The principal moments and axes, by columns, in any order, by Jacobi's method [Jac46](crate::references).
/// Each rotation zeroes one product. The small moment of a needle keeps the relative accuracy of the entries
/// [DV92](crate::references); the usual reduction to tridiagonal form loses it.
fn diagonalized(mut a: Matrix3<f64>) -> (Vector3<f64>, Matrix3<f64>) {
    let mut v = Matrix3::identity();
    // Convergence is quadratic: ten sweeps are several times the number that the worst matrix needs.
    for _ in 0..10 {
        let mut clean = true;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            clean &= !rotate(&mut a, &mut v, p, q);
        }
        if clean {
            break;
        }
    }
    (a.diagonal(), v)
}

/// One Jacobi rotation in the plane of axes `p` and `q`. Returns `false` if their product was already zero to
/// rounding, relative to both moments.
fn rotate(a: &mut Matrix3<f64>, v: &mut Matrix3<f64>, p: usize, q: usize) -> bool {
    let product = a[(p, q)];
    let (mp, mq) = (a[(p, p)], a[(q, q)]);
    // Relative to the geometric mean, so that a large moment does not hide a small one.
    let negligible = f64::EPSILON * 0.125 * mp.abs().sqrt() * mq.abs().sqrt();
    if product == 0.0 {
        return false;
    }
    let swamped = mp + product == mp && mq + product == mq;
    if product.abs() <= negligible || (mp.min(mq) <= 0.0 && swamped) {
        a[(p, q)] = 0.0;
        a[(q, p)] = 0.0;
        return false;
    }
    let theta = (mq - mp) / (2.0 * product);
    let t = theta.signum() / (theta.abs() + hypot(theta, 1.0));
    let c = 1.0 / hypot(t, 1.0);
    let s = t * c;
    a[(p, p)] = mp - t * product;
    a[(q, q)] = mq + t * product;
    a[(p, q)] = 0.0;
    a[(q, p)] = 0.0;
    let r = 3 - p - q;
    let (rp, rq) = (a[(r, p)], a[(r, q)]);
    a[(r, p)] = c * rp - s * rq;
    a[(r, q)] = s * rp + c * rq;
    a[(p, r)] = a[(r, p)];
    a[(q, r)] = a[(r, q)];
    for i in 0..3 {
        let (ip, iq) = (v[(i, p)], v[(i, q)]);
        v[(i, p)] = c * ip - s * iq;
        v[(i, q)] = s * ip + c * iq;
    }
    true
}

fn canonical_frame(moments: &Vector3<f64>, axes: &[Vector3<f64>; 3]) -> Matrix3<f64> {
    let rounding = 8.0 * ulp(moments[2]);
    let equal = |i: usize, j: usize| (moments[i] - moments[j]).abs() <= rounding;
    let [smallest, middle, largest] = axes.each_ref().map(pointing);
    let [a, b, c] = match (equal(0, 1), equal(1, 2)) {
        (true, true) => return Matrix3::identity(),
        (true, false) => {
            let [first, second] = plane(&largest);
            [first, second, largest]
        }
        (false, true) => {
            let [first, second] = plane(&smallest);
            [smallest, first, second]
        }
        (false, false) => [smallest, middle, smallest.cross(&middle)],
    };
    // Adding zero turns -0 into 0, so that equal frames also print the same.
    Matrix3::from_columns(&[a, b, c]).map(|x| x + 0.0)
}

/// The axis or its opposite, such that its first component above 0.57 is positive. Every unit vector has such
/// a component: the largest is at least 1/sqrt(3) = 0.577...
fn pointing(axis: &Vector3<f64>) -> Vector3<f64> {
    let negative = axis.iter().find(|x| x.abs() > 0.57).is_some_and(|&x| x < 0.0);
    if negative { -axis } else { *axis }
}

/// Two unit vectors that complete `lone` to a right-handed frame `(first, second, lone)`.
fn plane(lone: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let least = lone.map(f64::abs).imin();
    let mut along = Vector3::zeros();
    along[least] = 1.0;
    let first = (along - lone * lone[least]).normalize();
    [first, lone.cross(&first)]
}
