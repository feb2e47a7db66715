//! How principal axes are mounted in a body, and the body in the world.

use crate::attitude::{product, rotate_inverse, unit};
use crate::body::Body;
use crate::error::{Error, Refusal, Subject};
use crate::inertia::{Frame, Inertia, PrincipalMoments};
use crate::number::Lane;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// A start that is not along the principal axes and the world's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mount {
    pub(super) frame: Frame,
    /// Principal axes to world at the start.
    pub(super) world: UnitQuaternion<f64>,
    /// Body to world at the start.
    pub(super) attitude: UnitQuaternion<f64>,
    /// The spin at the start in body axes, rad/s.
    pub(super) omega: Vector3<f64>,
    /// The tensor of the body of which this is the motion, and its momentum in the world.
    pub(super) body: Option<(Inertia, Vector3<f64>)>,
}

/// A vector is turned without overflow if this times its largest component is finite.
pub(super) const ROOM_TO_TURN: f64 = 8.0;

/// The spin of a body along its principal axes: its momentum over the moments where the body's axes are
/// principal. Elsewhere the body's inverse tensor has more digits of a needle than its rounded axes.
pub(super) fn spin_along(
    body: &Body,
    moments: PrincipalMoments,
    frame: &Frame,
) -> Result<Vector3<f64>, Error> {
    let omega = if *frame == Frame::SAME {
        body.momentum_body().component_div(&moments.vector())
    } else {
        frame.along(&body.omega_body())
    };
    match omega.iter().find(|x| !x.is_finite()) {
        Some(&value) => Err(Refusal::OutOfRange { what: Subject::GreatestSpin, value }.into()),
        None => Ok(omega),
    }
}

impl Mount {
    pub(super) fn new(frame: Frame, attitude: UnitQuaternion<f64>, omega: Vector3<f64>) -> Self {
        Self { frame, world: attitude * frame.to_body(), attitude, omega, body: None }
    }

    // Not inlined: most motions have none, and the way without one is the shorter for it.
    #[inline(never)]
    pub(super) fn in_body(&self, omega: Vector3<f64>) -> Vector3<f64> {
        self.frame.in_body(omega)
    }

    #[inline(never)]
    pub(super) fn in_world(&self, turn: Quaternion<f64>) -> Quaternion<f64> {
        in_world(&self.world, self.frame.body_to_principal(), turn)
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
