//! The rotation between a body's principal axes and its body axes.

use crate::attitude::{product, rotate_inverse, rotation_matrix, unit};
use crate::number::{Gather, Ring, Rounding};
use alloc::vec::Vec;
use nalgebra::{Matrix3, Quaternion, Scalar, UnitQuaternion, Vector3};

/// The rotation of principal axes relative to body axes, of one body or of the bodies in the lanes of `T`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame<T = f64> {
    /// The rotation of coordinates from body axes to principal axes; `None` where they are the same.
    to_principal: Option<Quaternion<T>>,
}

impl<T: Scalar> PartialEq for Frame<T> {
    fn eq(&self, other: &Self) -> bool {
        self.to_principal == other.to_principal
    }
}

impl<T: Scalar> Frame<T> {
    /// The body's axes are principal.
    pub(crate) const BODY: Self = Self { to_principal: None };

    /// Whether the body's axes are principal.
    pub(crate) fn is_body(&self) -> bool {
        self.to_principal.is_none()
    }
}

impl<T: Ring> Frame<T> {
    /// Rotates a vector from principal axes to body axes.
    #[inline(always)]
    pub(crate) fn in_body(&self, v: Vector3<T>) -> Vector3<T> {
        if let Some(q) = &self.to_principal { rotate_inverse(q, &v) } else { v }
    }

    /// The attitude of the body from the attitude of the principal axes, with the same length.
    #[inline(always)]
    pub(crate) fn attitude_as_long(&self, axes: Quaternion<T>) -> Quaternion<T> {
        if let Some(q) = &self.to_principal { product(&axes, q) } else { axes }
    }
}

impl Frame {
    /// From the rotation of coordinates from principal axes to body axes.
    pub(crate) fn new(to_body: Quaternion<f64>) -> Self {
        let differs = to_body != Quaternion::identity();
        Self { to_principal: differs.then(|| to_body.conjugate()) }
    }

    /// The rotation of coordinates from principal axes to body axes.
    pub(crate) fn to_body(self) -> UnitQuaternion<f64> {
        let to_body = self.to_principal.map_or_else(Quaternion::identity, |q| q.conjugate());
        UnitQuaternion::new_unchecked(to_body)
    }

    /// Rotates a vector from body axes to principal axes.
    pub(crate) fn along(&self, v: &Vector3<f64>) -> Vector3<f64> {
        self.to_principal.map_or(*v, |q| rotate_inverse(&q.conjugate(), v))
    }

    /// The attitude of the principal axes, from that of the body.
    pub(crate) fn attitude_of_axes(&self, body: Quaternion<f64>) -> Quaternion<f64> {
        self.to_principal.map_or(body, |q| product(&body, &q.conjugate()))
    }

    /// The rotation matrix from body axes to principal axes; `None` where they are the same.
    pub(crate) fn matrix(&self) -> Option<Matrix3<f64>> {
        self.to_principal.as_ref().map(rotation_matrix)
    }

    /// Converts a rotation from principal axes to body axes.
    pub(crate) fn turn_in_body(&self, turn: Quaternion<f64>) -> Quaternion<f64> {
        self.to_principal.map_or(turn, |q| unit(product(&product(&q.conjugate(), &turn), &q)))
    }

    /// The same frame relative to other body axes, to which `outer` rotates the present ones.
    pub(crate) fn within(&self, outer: &UnitQuaternion<f64>) -> Self {
        Self::new(unit(product(outer.quaternion(), self.to_body().quaternion())))
    }
}

impl<T: Rounding> Frame<T> {
    /// The frames of the bodies in the lanes; the principal axes of each must differ from its body axes.
    pub(crate) fn of_lanes<'a>(frames: impl Iterator<Item = &'a Frame>) -> Self {
        let turns: Vec<_> = frames.filter_map(|frame| frame.to_principal).collect();
        Self { to_principal: Some(Quaternion::gather(&turns, |turn| turn)) }
    }

    /// The attitude of the body, of length 1, from that of the principal axes.
    #[inline(always)]
    pub(crate) fn attitude_of_body(&self, axes: Quaternion<T>) -> Quaternion<T> {
        unit(self.attitude_as_long(axes))
    }
}
