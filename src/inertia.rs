//! The inertia tensor: the matrix that turns spin into angular momentum, `L = I w`.
//!
//! The products of inertia carry the sign that makes `L = I w` hold: `Ixy = -sum(m x y)`. Some books
//! write the sum without the minus and the minus in the matrix; the matrix is the same.

mod frame;
mod moments;
mod possible;
mod principal;

use crate::number::functions::atan2;
pub(crate) use frame::Frame;
pub use moments::PrincipalMoments;
pub(crate) use moments::ascending;
pub(crate) use principal::moments_of;
pub use principal::{Axis, PrincipalAxes};

use crate::error::{Error, Refusal, Subject, finite_vector, representable};
use crate::number::{DoubleDouble, Ring, difference_of_products, exponent, times_power_of_two, ulp};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

/// The tensor turned by the rotation matrix `rotation`: `R I R^T`.
///
/// Read the product from the right: `R^T` rotates a world vector into body axes, the body's tensor acts, and
/// `R` rotates the result back. The same formula turns the inverse. It takes two matrix products, for any
/// number type.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// let quarter_turn_about_z = Matrix3::new(0, -1, 0, 1, 0, 0, 0, 0, 1);
/// let tensor = Matrix3::from_diagonal(&Vector3::new(10, 13, 5));
/// let turned = tumbling::inertia::turned(&quarter_turn_about_z, &tensor);
/// assert_eq!(turned.diagonal(), Vector3::new(13, 10, 5));
/// ```
#[must_use]
pub fn turned<T: Ring>(rotation: &Matrix3<T>, tensor: &Matrix3<T>) -> Matrix3<T> {
    rotation * tensor * rotation.transpose()
}

/// The tensor of a point mass at `offset`: `m (|d|^2 1 - d d^T)`. It is also the parallel-axis term between a
/// body's centre of mass and a point `offset` away.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// let far = tumbling::inertia::point_mass(&2, &Vector3::new(3, 1, 0));
/// assert_eq!(far, Matrix3::new(2, -6, 0, -6, 18, 0, 0, 0, 20));
/// ```
#[must_use]
pub fn point_mass<T: Ring>(mass: &T, offset: &Vector3<T>) -> Matrix3<T> {
    let [x, y, z] = [&offset.x, &offset.y, &offset.z];
    let times = |a: &T, b: &T| mass.clone() * a.clone() * b.clone();
    let (xx, yy, zz) = (times(x, x), times(y, y), times(z, z));
    let (xy, xz, yz) = (-times(x, y), -times(x, z), -times(y, z));
    Matrix3::from([
        [yy.clone() + zz.clone(), xy.clone(), xz.clone()],
        [xy, zz + xx.clone(), yz.clone()],
        [xz, yz, xx + yy],
    ])
}

/// Spin from momentum, both in world axes: `w = R J R^T L`, with `J` the body's inverse tensor.
///
/// The usual method of engines: the inverse is stored once in body axes and rotated to world axes in each
/// step. The rotation matrix `rotation` is from body to world.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// let rotation = Matrix3::identity();
/// let inverse = Matrix3::from_diagonal(&Vector3::new(0.5, 0.25, 0.125));
/// let omega = tumbling::inertia::omega_world(&rotation, &inverse, &Vector3::new(2.0, 4.0, 8.0));
/// assert_eq!(omega, Vector3::new(1.0, 1.0, 1.0));
/// ```
#[must_use]
pub fn omega_world<T: Ring>(
    rotation: &Matrix3<T>,
    inverse_body: &Matrix3<T>,
    momentum_world: &Vector3<T>,
) -> Vector3<T> {
    turned(rotation, inverse_body) * momentum_world
}

/// An inertia tensor that a real body can have, about some point and in some axes, kg m².
///
/// A moment may be zero (an ideal rod has one); such a tensor has no [`inverse`](Self::inverse).
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::Inertia;
///
/// let tensor = Inertia::from_moments(10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0)?;
/// let omega = Vector3::new(1.0, 1.0, 0.0);
/// assert_eq!(tensor.momentum(&omega), Vector3::new(10.0 / 12.0, 13.0 / 12.0, 0.0));
/// assert_eq!(format!("{:.1}", tensor.angle_to_momentum(&omega)?.to_degrees()), "7.4");
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inertia {
    tensor: Matrix3<f64>,
}

impl Inertia {
    /// A diagonal tensor: the moments about the three body axes, which are then principal.
    ///
    /// # Errors
    /// A moment that is not finite or is negative; three zero moments; or a largest moment above the sum of
    /// the other two by more than rounding.
    pub fn from_moments(ixx: f64, iyy: f64, izz: f64) -> Result<Self, Error> {
        Self::new([ixx, iyy, izz], [0.0; 3])
    }

    /// From the moments `[ixx, iyy, izz]` and the products `[ixy, ixz, iyz]`, with the sign that makes
    /// `L = I w` hold.
    ///
    /// # Errors
    /// A value that is not finite, a moment below zero, or a tensor that no distribution of mass has.
    pub fn new(moments: [f64; 3], products: [f64; 3]) -> Result<Self, Error> {
        let [ixx, iyy, izz] = moments;
        let [ixy, ixz, iyz] = products;
        Self::try_from(Matrix3::new(ixx, ixy, ixz, ixy, iyy, iyz, ixz, iyz, izz))
    }

    /// The tensor's matrix, kg m².
    #[must_use]
    pub fn matrix(&self) -> Matrix3<f64> {
        self.tensor
    }

    /// Angular momentum `L = I w`, kg m²/s, in the axes of `omega` (rad/s), which must be the axes of the
    /// tensor.
    #[must_use]
    pub fn momentum(&self, omega: &Vector3<f64>) -> Vector3<f64> {
        self.tensor * omega
    }

    /// The angle between a spin and its momentum, radians, from 0 to at most a right angle.
    ///
    /// The error is a few units in the last place, however small the angle: the cross product is summed in
    /// twice the precision, because near a principal axis it is a small difference of large terms.
    ///
    /// # Errors
    /// A spin that is not finite or is zero, or a spin along an ideal rod, which has no momentum.
    pub fn angle_to_momentum(&self, omega: &Vector3<f64>) -> Result<f64, Error> {
        finite_vector(Subject::Spin, omega)?;
        Refusal::ZeroVector { what: Subject::Spin }.when(*omega == Vector3::zeros())?;
        // The sizes do not change the angle: both are scaled to about 1, so that no product overflows.
        let unit = |x: f64, largest: f64| times_power_of_two(x, -exponent(largest));
        let w = omega.map(|x| DoubleDouble::from(unit(x, omega.amax())));
        let tensor = self.tensor.map(|x| DoubleDouble::from(unit(x, self.tensor.amax())));
        let row = |i: usize| tensor[(i, 0)] * w.x + tensor[(i, 1)] * w.y + tensor[(i, 2)] * w.z;
        let l = [row(0), row(1), row(2)];
        // A turned rod has rounding in its entries: a momentum below that rounding counts as zero.
        let rounding = if is_diagonal(&self.tensor) { 0.0 } else { 8.0 * f64::EPSILON };
        Refusal::ZeroVector { what: Subject::AngularMomentum }
            .when(l.iter().all(|x| x.hi().abs() <= rounding))?;
        let cross = Vector3::new(
            (w.y * l[2] - w.z * l[1]).hi(),
            (w.z * l[0] - w.x * l[2]).hi(),
            (w.x * l[1] - w.y * l[0]).hi(),
        );
        let dot = (w.x * l[0] + w.y * l[1] + w.z * l[2]).hi();
        Ok(atan2(length(&cross), dot))
    }

    /// The moment about the axis along `direction` (any length) through the same point, kg m².
    ///
    /// # Errors
    /// A direction that is not finite or is zero, or a moment beyond `f64`.
    pub fn about_axis(&self, direction: &Vector3<f64>) -> Result<f64, Error> {
        let n = unit(Subject::Axis, direction)?;
        let moment = n.dot(&(self.tensor * n));
        representable(Subject::MomentAboutAxis, &[moment]).map(|()| moment)
    }

    /// The tensor in axes turned by `attitude`: `R I R^T`, in world axes if `attitude` is from body to world.
    ///
    /// # Errors
    /// An attitude that is not finite or not of length 1, or entries beyond `f64`.
    pub fn turned(&self, attitude: UnitQuaternion<f64>) -> Result<Self, Error> {
        let rotation = crate::attitude::matrix(attitude)?;
        // The tensor was valid before, so it is valid now; only mirrored entries may differ by rounding.
        let tensor = symmetrized(&turned(&rotation, &self.tensor));
        in_range(Subject::TurnedMoment, &tensor)?;
        Ok(Self { tensor })
    }

    /// The inverse matrix `J` in 1/(kg m²), `w = J L`, in the same axes. Compute it once and turn it, instead
    /// of inverting in each step.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// let inverse = tumbling::Inertia::from_moments(2.0, 4.0, 5.0)?.inverse()?;
    /// assert_eq!(inverse * Vector3::new(2.0, 2.0, 0.0), Vector3::new(1.0, 0.5, 0.0));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A smallest moment that is zero to rounding (an ideal rod), or an inverse beyond `f64`.
    pub fn inverse(&self) -> Result<Matrix3<f64>, Error> {
        let m = &self.tensor;
        let diagonal = is_diagonal(m);
        let moments = moments_of(m);
        // The moments of a diagonal tensor are exact: only an exact zero is singular there.
        let rounding = if diagonal { 0.0 } else { 2.0 * ulp(moments[2]) };
        Refusal::Singular { smallest: moments[0], largest: moments[2] }.when(moments[0] <= rounding)?;
        let inverse = if diagonal {
            Matrix3::from_diagonal(&m.diagonal().map(|x| 1.0 / x))
        } else {
            adjugate_inverse(m)
        };
        in_range(Subject::InverseMoment, &inverse)?;
        Ok(inverse)
    }

    /// The principal moments and axes.
    #[must_use]
    pub fn principal(&self) -> PrincipalAxes {
        PrincipalAxes::of(&self.tensor)
    }
}

/// From the whole matrix, kg m². If mirrored entries differ by rounding, as they do after `R I R^T`, both get
/// their mean.
///
/// # Errors
/// An entry that is not finite, mirrored entries that differ by more than rounding, a moment below zero, or a
/// tensor that no distribution of mass has.
impl TryFrom<Matrix3<f64>> for Inertia {
    type Error = Error;

    fn try_from(tensor: Matrix3<f64>) -> Result<Self, Error> {
        Self::rounded(&tensor)
    }
}

/// The mean of the matrix and its transpose. Entries are halved before they are added, so that large ones do
/// not overflow; equal entries are unchanged, so that small ones keep their last bit. Negative zeros become
/// positive.
fn symmetrized(m: &Matrix3<f64>) -> Matrix3<f64> {
    m.zip_map(&m.transpose(), |a, b| if a == b { a } else { 0.5 * a + 0.5 * b } + 0.0)
}

fn is_diagonal(m: &Matrix3<f64>) -> bool {
    m[(0, 1)] == 0.0 && m[(0, 2)] == 0.0 && m[(1, 2)] == 0.0
}

/// Checks that a computed tensor is finite and not zero; `what` names one of its entries.
fn in_range(what: Subject, tensor: &Matrix3<f64>) -> Result<(), Error> {
    representable(what, tensor.as_slice())?;
    Refusal::OutOfRange { what, value: 0.0 }.when(tensor.diagonal() == Vector3::zeros())?;
    Ok(())
}

/// `matrix * vector`, infinite only where the result is beyond `f64`.
pub(crate) fn product(matrix: &Matrix3<f64>, vector: &Vector3<f64>) -> Vector3<f64> {
    let plain = matrix * vector;
    if plain.iter().all(|x| x.is_finite()) {
        return plain;
    }
    let (a, b) = (exponent(matrix.amax()), exponent(vector.amax()));
    let scaled = matrix.map(|x| times_power_of_two(x, -a)) * vector.map(|x| times_power_of_two(x, -b));
    scaled.map(|x| times_power_of_two(x, a + b))
}

/// The length of a vector, without overflow or underflow in between.
pub(crate) fn length(v: &Vector3<f64>) -> f64 {
    let scale = exponent(v.amax());
    times_power_of_two(v.map(|x| times_power_of_two(x, -scale)).norm(), scale)
}

/// The unit vector along `v`, whose length may be any size in `f64`.
pub(crate) fn unit(what: Subject, v: &Vector3<f64>) -> Result<Vector3<f64>, Error> {
    finite_vector(what, v)?;
    Refusal::ZeroVector { what }.when(*v == Vector3::zeros())?;
    let scale = exponent(v.amax());
    Ok(v.map(|x| times_power_of_two(x, -scale)).normalize())
}

/// The inverse by cofactors. For a needle's tensor each cofactor is a difference of products that nearly
/// cancels, so it is computed in twice the precision; the matrix is scaled so that no cofactor underflows.
/// Negative zeros become positive.
fn adjugate_inverse(m: &Matrix3<f64>) -> Matrix3<f64> {
    let scale = exponent(m.amax());
    let a = m.map(|x| times_power_of_two(x, -scale));
    let cofactor = |i: usize, j: usize| {
        let (r, s) = ((i + 1) % 3, (i + 2) % 3);
        let (p, q) = ((j + 1) % 3, (j + 2) % 3);
        difference_of_products(a[(r, p)], a[(s, q)], a[(r, q)], a[(s, p)])
    };
    let determinant = (DoubleDouble::from(a[(0, 0)]) * cofactor(0, 0)
        + DoubleDouble::from(a[(0, 1)]) * cofactor(0, 1)
        + DoubleDouble::from(a[(0, 2)]) * cofactor(0, 2))
    .hi();
    Matrix3::from_fn(|i, j| {
        let (i, j) = (i.min(j), i.max(j));
        times_power_of_two(cofactor(i, j).hi() / determinant, -scale) + 0.0
    })
}
