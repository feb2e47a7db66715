//! The rotation from a top's own axes, with its axis of symmetry last, to the axes of the body.

use crate::attitude::product;
use crate::error::{Error, Refusal, Subject};
use crate::inertia::{Frame, Inertia, PrincipalMoments};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// The tolerance on the difference of two moments, and on the arm's distance from its axis, relative.
pub(super) const ROUNDING: f64 = 1e-14;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mounted {
    /// The moments across the axis of symmetry and about it, kg m².
    pub(super) across: f64,
    pub(super) polar: f64,
    /// The arm along the principal axis; the top's own axis points along it.
    pub(super) arm: f64,
    /// The rotation of the top's own axes in the body.
    pub(super) frame: Frame,
}

impl Mounted {
    pub(super) fn new(moments: PrincipalMoments, arm: &Vector3<f64>) -> Result<Self, Error> {
        let largest = arm.amax();
        let axis = if largest > 0.0 { arm.iamax() } else { axis_of(moments) };
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        let off = arm[next].abs().max(arm[last].abs()) / largest.max(f64::MIN_POSITIVE);
        let apart = (moments[next] - moments[last]).abs() / moments[next].max(moments[last]);
        for (what, value) in [(Subject::ArmOffAxis, off), (Subject::MomentDifference, apart)] {
            Refusal::NotBelow { what, value, limit: ROUNDING }.when(value > ROUNDING)?;
        }
        let cyclic = match axis {
            0 => Quaternion::new(0.5, 0.5, 0.5, 0.5),
            1 => Quaternion::new(0.5, -0.5, -0.5, -0.5),
            _ => Quaternion::identity(),
        };
        let frame =
            if arm[axis] < 0.0 { product(&cyclic, &Quaternion::new(0.0, 1.0, 0.0, 0.0)) } else { cyclic };
        Ok(Self {
            across: 0.5 * moments[next] + 0.5 * moments[last],
            polar: moments[axis],
            arm: arm[axis],
            frame: Frame::new(frame),
        })
    }

    /// The same top, in a body to whose axes `outer` takes coordinates along the principal axes.
    pub(super) fn within(self, outer: &UnitQuaternion<f64>) -> Self {
        Self { frame: self.frame.within(outer), ..self }
    }

    /// The tensor in the body's axes.
    pub(super) fn inertia(&self) -> Result<Inertia, Error> {
        let inertia = Inertia::from_moments(self.across, self.across, self.polar)?;
        if self.frame.is_body() { Ok(inertia) } else { inertia.turned(self.frame.to_body()) }
    }
}

/// The small rotation of a tensor's principal axes, within its rounding, that moves the axis next to the arm
/// onto the arm; and the arm in the turned axes.
pub(super) fn onto_arm(
    moments: PrincipalMoments,
    arm: &Vector3<f64>,
) -> Result<(UnitQuaternion<f64>, Vector3<f64>), Error> {
    let largest = arm.amax();
    if largest == 0.0 {
        return Ok((UnitQuaternion::identity(), *arm));
    }
    let axis = arm.iamax();
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    let scaled = arm / largest;
    let apart =
        [next, last].map(|other| (moments[axis] - moments[other]).abs() / moments[axis].max(moments[other]));
    let (value, limit) = (scaled[next].abs().max(scaled[last].abs()), ROUNDING / apart[0].min(apart[1]));
    Refusal::NotBelow { what: Subject::ArmOffAxis, value, limit }.when(value > limit)?;
    let mut along = Vector3::zeros();
    along[axis] = 1_f64.copysign(arm[axis]);
    let length = scaled.norm();
    let sideways = along.cross(&scaled);
    let turn = Quaternion::new(length + along.dot(&scaled), sideways.x, sideways.y, sideways.z);
    Ok((UnitQuaternion::new_normalize(turn), along * (largest * length)))
}

/// The axis of symmetry of a body without an arm: the axis whose other two moments are most nearly equal.
fn axis_of(moments: PrincipalMoments) -> usize {
    let apart = |axis: usize| (moments[(axis + 1) % 3] - moments[(axis + 2) % 3]).abs();
    (0..3).rev().min_by(|&a, &b| apart(a).total_cmp(&apart(b))).unwrap_or(2)
}
