//! Attitude: the orientation of a body, as a quaternion that takes body coordinates to world.

use crate::error::{Error, Refusal, Subject, finite};
use crate::number::functions::atan2;
use crate::number::{Analytic, Field, Ring, Rounding};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

/// How far an attitude's length may be from 1: the drift after a million products of unit quaternions, and
/// far less than the effect of a mistake.
const UNIT_TOLERANCE: f64 = 1e-9;

/// The quaternion product `p q`, for any number type: first turn by `q`, then by `p`.
///
/// ```
/// use nalgebra::Quaternion;
/// use tumbling::attitude::product;
/// let (i, j, k) = (Quaternion::new(0, 1, 0, 0), Quaternion::new(0, 0, 1, 0), Quaternion::new(0, 0, 0, 1));
/// assert_eq!(product(&i, &j), k);
/// assert_eq!(product(&j, &i), Quaternion::new(0, 0, 0, -1));
/// ```
#[must_use]
#[inline(always)]
pub fn product<T: Ring>(p: &Quaternion<T>, q: &Quaternion<T>) -> Quaternion<T> {
    let [a, b, c, d] = [&p.coords.w, &p.coords.x, &p.coords.y, &p.coords.z];
    let [e, f, g, h] = [&q.coords.w, &q.coords.x, &q.coords.y, &q.coords.z];
    let t = |x: &T, y: &T| x.clone() * y.clone();
    Quaternion::new(
        t(a, e) - t(b, f) - t(c, g) - t(d, h),
        t(a, f) + t(b, e) + t(c, h) - t(d, g),
        t(a, g) - t(b, h) + t(c, e) + t(d, f),
        t(a, h) + t(b, g) - t(c, f) + t(d, e),
    )
}

/// The rotation matrix of a unit quaternion, body to world, for any number type.
///
/// For any other quaternion, the result is the rotation matrix times the square of its length: every entry is
/// a sum of products of two components, so that `R R^T = |q|^4` holds for all quaternions.
///
/// ```
/// use nalgebra::{Matrix3, Quaternion};
/// let half_turn_about_x = tumbling::attitude::rotation_matrix(&Quaternion::new(0, 1, 0, 0));
/// assert_eq!(half_turn_about_x, Matrix3::new(1, 0, 0, 0, -1, 0, 0, 0, -1));
/// ```
#[must_use]
pub fn rotation_matrix<T: Ring>(q: &Quaternion<T>) -> Matrix3<T> {
    let [w, x, y, z] = [&q.coords.w, &q.coords.x, &q.coords.y, &q.coords.z];
    let t = |a: &T, b: &T| a.clone() * b.clone();
    let twice = |a: T| a.clone() + a;
    let (ww, xx, yy, zz) = (t(w, w), t(x, x), t(y, y), t(z, z));
    let (wx, wy, wz) = (t(w, x), t(w, y), t(w, z));
    let (xy, xz, yz) = (t(x, y), t(x, z), t(y, z));
    Matrix3::new(
        ww.clone() + xx.clone() - yy.clone() - zz.clone(),
        twice(xy.clone() - wz.clone()),
        twice(xz.clone() + wy.clone()),
        twice(xy + wz),
        ww.clone() - xx.clone() + yy.clone() - zz.clone(),
        twice(yz.clone() - wx.clone()),
        twice(xz - wy),
        twice(yz + wx),
        ww - xx - yy + zz,
    )
}

/// How fast the attitude changes: `q' = q (0, w) / 2`, with the spin in body axes, rad/s.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// let rate = tumbling::attitude::rate(&Quaternion::identity(), &Vector3::new(0.0, 0.0, 3.0));
/// assert_eq!(rate, Quaternion::new(0.0, 0.0, 0.0, 1.5));
/// ```
#[must_use]
pub fn rate<T: Field>(attitude: &Quaternion<T>, omega_body: &Vector3<T>) -> Quaternion<T> {
    // The product without the terms of a scalar part that is zero.
    let [a, b, c, d] = [&attitude.coords.w, &attitude.coords.x, &attitude.coords.y, &attitude.coords.z];
    let [x, y, z] = [&omega_body.x, &omega_body.y, &omega_body.z];
    let two = T::integer(2);
    let t = |x: &T, y: &T| x.clone() * y.clone();
    let half = |x: T| x / two.clone();
    Quaternion::new(
        half(-t(b, x) - t(c, y) - t(d, z)),
        half(t(a, x) + t(c, z) - t(d, y)),
        half(t(a, y) - t(b, z) + t(d, x)),
        half(t(a, z) + t(b, y) - t(c, x)),
    )
}

/// The rotation by a rotation vector: about its direction, by its length in radians. This is the exponential
/// map.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// let turn = tumbling::attitude::turn(&Vector3::new(0.0, 0.0, 3.0));
/// assert!((turn - Quaternion::new(1.5_f64.cos(), 0.0, 0.0, 1.5_f64.sin())).norm() < 1e-15);
/// ```
#[must_use]
pub fn turn<T: Analytic>(vector: &Vector3<T>) -> Quaternion<T> {
    let half = vector.map(|x| x / T::integer(2));
    let (cosine, sinc) = half.dot(&half).cos_sinc_of_root();
    let [x, y, z] = [0, 1, 2].map(|i| half[i].clone() * sinc.clone());
    Quaternion::new(cosine, x, y, z)
}

/// `vector` rotated by the inverse of the unit quaternion `q`: from world to body axes, if `q` is an
/// attitude.
pub(crate) fn rotate_inverse<T: Ring>(q: &Quaternion<T>, vector: &Vector3<T>) -> Vector3<T> {
    // v - 2 w (u x v) + 2 u x (u x v), with u the vector part: no matrix.
    let part = Vector3::new(q.coords.x.clone(), q.coords.y.clone(), q.coords.z.clone());
    let across = part.cross(vector);
    let across = &across + &across;
    vector - across.map(|x| x * q.coords.w.clone()) + part.cross(&across)
}

/// The angle of the turn from one attitude to another, radians, from 0 to pi; accurate for the smallest
/// angles too.
///
/// ```
/// use nalgebra::{UnitQuaternion, Vector3};
/// let (a, b) = (0.3, 0.3 + 1e-9);
/// let [a, b] = [a, b].map(|angle| UnitQuaternion::from_scaled_axis(Vector3::new(0.0, angle, 0.0)));
/// assert!((tumbling::attitude::angle_between(&a, &b) - 1e-9).abs() < 1e-15);
/// ```
#[must_use]
pub fn angle_between(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    let turn = product(&a.conjugate(), b);
    2.0 * atan2(turn.imag().norm(), turn.coords.w.abs())
}

/// The rotation matrix of an attitude.
pub(crate) fn matrix(attitude: UnitQuaternion<f64>) -> Result<Matrix3<f64>, Error> {
    Ok(rotation_matrix(checked(attitude)?.quaternion()))
}

/// An attitude scaled to length 1. Only the direction of a quaternion determines the rotation, so a length
/// that has drifted a little is divided out; a length that is far from 1 is refused.
///
/// # Errors
/// A length that is not finite, or not 1 to a billionth.
pub fn checked(attitude: UnitQuaternion<f64>) -> Result<UnitQuaternion<f64>, Error> {
    let q = attitude.quaternion();
    let norm = finite(Subject::AttitudeLength, q.norm())?;
    Refusal::NotUnit { what: Subject::Attitude, length: norm, tolerance: UNIT_TOLERANCE }
        .when((norm - 1.0).abs() > UNIT_TOLERANCE)?;
    let drifted = (norm - 1.0).abs() > 2.0 * f64::EPSILON;
    Ok(if drifted { UnitQuaternion::new_unchecked(q / norm) } else { attitude })
}

/// A quaternion of length 1 to a few roundings brought to length 1 as near as its components can be.
#[inline(always)]
pub(crate) fn unit<T: Rounding>(q: Quaternion<T>) -> Quaternion<T> {
    let (w, x, y, z) = (q.coords.w, q.coords.x, q.coords.y, q.coords.z);
    // Sorted into pairs so that the sum stays short; the excess itself has all the digits it needs.
    let excess = ((w * w - 0.5) + x * x) + ((y * y - 0.5) + z * z);
    let factor = -(excess * 0.5) + 1.0;
    Quaternion::new(w * factor, x * factor, y * factor, z * factor)
}
