//! The rule that engines use today, written as they write it: the explicit gyroscopic step with the momentum
//! rescaled, then the attitude updated linearly and its length restored. Spin in world axes.

use nalgebra::{Matrix3, Quaternion, Vector3};
use num_traits::Float;
use std::fmt::Debug;
use std::ops::{AddAssign, DivAssign, MulAssign, SubAssign};

/// A body as an engine keeps it.
#[derive(Clone, Copy)]
pub struct Plain<T> {
    pub attitude: Quaternion<T>,
    pub omega: Vector3<T>,
}

pub trait Number:
    Float + Debug + AddAssign + SubAssign + MulAssign + DivAssign + From<f32> + 'static
{
}
impl<T: Float + Debug + AddAssign + SubAssign + MulAssign + DivAssign + From<f32> + 'static> Number for T {}

/// One step; moments and their inverses along the body's axes.
pub fn step<T: Number>(moments: &Vector3<T>, inverse: &Vector3<T>, start: &Plain<T>, h: T) -> Plain<T> {
    let q = &start.attitude.coords;
    let one = T::one();
    let (x2, y2, z2) = (q.x + q.x, q.y + q.y, q.z + q.z);
    let (wx, wy, wz) = (q.w * x2, q.w * y2, q.w * z2);
    let (xx, xy, xz) = (q.x * x2, q.x * y2, q.x * z2);
    let (yy, yz, zz) = (q.y * y2, q.y * z2, q.z * z2);
    let rotation = Matrix3::new(
        one - (yy + zz),
        xy - wz,
        xz + wy,
        xy + wz,
        one - (xx + zz),
        yz - wx,
        xz - wy,
        yz + wx,
        one - (xx + yy),
    );
    let omega = rotation.tr_mul(&start.omega);
    let momentum = moments.component_mul(&omega);
    let after = momentum + momentum.cross(&omega) * h;
    let square = after.dot(&after);
    let factor = if square > T::zero() { (momentum.dot(&momentum) / square).sqrt() } else { one };
    let omega = rotation * inverse.component_mul(&(after * factor));
    let half = h * <T as From<f32>>::from(0.5);
    let (a, b, c) = (omega.x * half, omega.y * half, omega.z * half);
    // The turn is in world axes, so it multiplies from the left.
    let turned = Quaternion::new(
        q.w - (a * q.x + b * q.y + c * q.z),
        q.x + (a * q.w + b * q.z - c * q.y),
        q.y + (b * q.w + c * q.x - a * q.z),
        q.z + (c * q.w + a * q.y - b * q.x),
    );
    let over = one / turned.coords.dot(&turned.coords).sqrt();
    Plain { attitude: Quaternion::from_vector(turned.coords * over), omega }
}
