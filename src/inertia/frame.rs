//! Where a body's principal axes lie in its own.

use crate::attitude::{product, rotate_inverse, rotation_matrix, unit};
use crate::number::{Gather, Ring, Rounding};
use alloc::vec::Vec;
use nalgebra::{Matrix3, Quaternion, Scalar, UnitQuaternion, Vector3};

/// How principal axes are turned relative to the body's own: of one body, or of those in the lanes of `T`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame<T = f64> {
    /// Takes coordinates along the body's axes to those along the principal axes, where these differ.
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
    /// A vector along the principal axes in body axes.
    #[inline(always)]
    pub(crate) fn in_body(&self, v: Vector3<T>) -> Vector3<T> {
        if let Some(q) = &self.to_principal { rotate_inverse(q, &v) } else { v }
    }

    /// The attitude of the body, from that of the principal axes: as long as this.
    #[inline(always)]
    pub(crate) fn attitude_as_long(&self, axes: Quaternion<T>) -> Quaternion<T> {
        if let Some(q) = &self.to_principal { product(&axes, q) } else { axes }
    }
}

impl Frame {
    /// From the turn that takes coordinates along the principal axes to those along the body's.
    pub(crate) fn new(to_body: Quaternion<f64>) -> Self {
        let differs = to_body != Quaternion::identity();
        Self { to_principal: differs.then(|| to_body.conjugate()) }
    }

    /// The turn that takes coordinates along the principal axes to those along the body's.
    pub(crate) fn to_body(self) -> UnitQuaternion<f64> {
        let to_body = self.to_principal.map_or_else(Quaternion::identity, |q| q.conjugate());
        UnitQuaternion::new_unchecked(to_body)
    }

    /// A vector in body axes along the principal axes.
    pub(crate) fn along(&self, v: &Vector3<f64>) -> Vector3<f64> {
        self.to_principal.map_or(*v, |q| rotate_inverse(&q.conjugate(), v))
    }

    /// The attitude of the principal axes, from that of the body.
    pub(crate) fn attitude_of_axes(&self, body: Quaternion<f64>) -> Quaternion<f64> {
        self.to_principal.map_or(body, |q| product(&body, &q.conjugate()))
    }

    /// Takes vectors in body axes to those along the principal axes, where these differ.
    pub(crate) fn matrix(&self) -> Option<Matrix3<f64>> {
        self.to_principal.as_ref().map(rotation_matrix)
    }

    /// A turn along the principal axes as one along the body's.
    pub(crate) fn turn_in_body(&self, turn: Quaternion<f64>) -> Quaternion<f64> {
        self.to_principal.map_or(turn, |q| unit(product(&product(&q.conjugate(), &turn), &q)))
    }

    /// The frame in a body whose axes `outer` takes this one's to.
    pub(crate) fn within(&self, outer: &UnitQuaternion<f64>) -> Self {
        Self::new(unit(product(outer.quaternion(), self.to_body().quaternion())))
    }
}

impl<T: Rounding> Frame<T> {
    /// Those of the bodies in the lanes, none of which has principal axes of its own.
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
