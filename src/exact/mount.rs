//! The rotation from principal axes to body axes, and from the body to the world.

use crate::attitude::product;
use crate::body::Body;
use crate::error::{Error, Subject, representable};
use crate::inertia::{Frame, Inertia, PrincipalMoments};
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
    let omega = if frame.is_body() {
        body.momentum_body().component_div(&moments.vector())
    } else {
        frame.along(&body.omega_body())
    };
    representable(Subject::GreatestSpin, omega.as_slice()).map(|()| omega)
}

impl Mount {
    pub(super) fn new(frame: Frame, attitude: UnitQuaternion<f64>, omega: Vector3<f64>) -> Self {
        Self { frame, world: attitude * frame.to_body(), attitude, omega, body: None }
    }

    // Not inlined: most motions have none, and are faster without this code.
    #[inline(never)]
    pub(super) fn in_body(&self, omega: Vector3<f64>) -> Vector3<f64> {
        self.frame.in_body(omega)
    }

    #[inline(never)]
    pub(super) fn in_world(&self, turn: Quaternion<f64>) -> Quaternion<f64> {
        self.frame.attitude_of_body(product(&self.world, &turn))
    }
}
