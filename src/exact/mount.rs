//! How principal axes are mounted in a body, and the body in the world.

use super::kernel::unit;
use crate::attitude::{product, rotate_inverse};
use crate::error::{Error, Refusal, Subject};
use crate::number::Lane;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// A start that is not along the principal axes and the world's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mount {
    /// Principal axes to body axes.
    pub(super) frame: UnitQuaternion<f64>,
    /// Body axes to principal ones, where they differ.
    pub(super) to_principal: Option<Quaternion<f64>>,
    /// Principal axes to world at the start.
    pub(super) world: UnitQuaternion<f64>,
    /// Body to world at the start.
    pub(super) attitude: UnitQuaternion<f64>,
    /// The spin at the start in body axes, rad/s.
    pub(super) omega: Vector3<f64>,
}

/// A vector is turned without overflow if this times its largest component is finite.
pub(super) const ROOM_TO_TURN: f64 = 8.0;

/// The spin along principal axes that `frame` takes to the body's.
pub(super) fn along(frame: &UnitQuaternion<f64>, omega: &Vector3<f64>) -> Result<Vector3<f64>, Error> {
    let along = frame.inverse() * omega;
    match along.iter().find(|x| !x.is_finite()) {
        Some(&value) => Err(Refusal::OutOfRange { what: Subject::GreatestSpin, value }.into()),
        None => Ok(along),
    }
}

impl Mount {
    pub(super) fn new(
        frame: UnitQuaternion<f64>,
        attitude: UnitQuaternion<f64>,
        omega: Vector3<f64>,
    ) -> Self {
        let differs = frame != UnitQuaternion::identity();
        let to_principal = differs.then(|| frame.conjugate().into_inner());
        Self { frame, to_principal, world: attitude * frame, attitude, omega }
    }

    // Not inlined: most motions have none, and the way without one is the shorter for it.
    #[inline(never)]
    pub(super) fn in_body(&self, omega: Vector3<f64>) -> Vector3<f64> {
        in_body(self.to_principal.as_ref(), omega)
    }

    #[inline(never)]
    pub(super) fn in_world(&self, turn: Quaternion<f64>) -> Quaternion<f64> {
        in_world(&self.world, self.to_principal.as_ref(), turn)
    }
}

/// The spin in body axes, from that along the principal axes and the quaternion that takes body axes to
/// those.
#[inline(always)]
pub(super) fn in_body<T: Lane>(to_principal: Option<&Quaternion<T>>, omega: Vector3<T>) -> Vector3<T> {
    to_principal.map_or(omega, |to_principal| rotate_inverse(to_principal, &omega))
}

/// The body's attitude in the world, from the turn of its principal axes since the start, where these stand
/// in the world at the start, and the quaternion that takes body axes to them.
#[inline(always)]
pub(super) fn in_world<T: Lane>(
    world: &Quaternion<T>,
    to_principal: Option<&Quaternion<T>>,
    turn: Quaternion<T>,
) -> Quaternion<T> {
    let turned = product(world, &turn);
    unit(to_principal.map_or(turned, |to_principal| product(&turned, to_principal)))
}
