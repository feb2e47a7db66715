//! The rate at which a state changes.

use crate::number::Field;
use nalgebra::{Quaternion, SVector, Vector3};

/// The rate at which a [`State`](crate::State) changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rate<T: nalgebra::Scalar> {
    /// `q' = q w / 2`, 1/s.
    pub attitude: Quaternion<T>,
    /// `L' = L x w + torque` in body axes, N m.
    pub momentum: Vector3<T>,
}

impl<T: Field> Rate<T> {
    /// `self + other times`.
    pub(crate) fn plus(&self, other: &Self, times: T) -> Self {
        Self {
            attitude: Quaternion::from_vector(along(&self.attitude.coords, &other.attitude.coords, &times)),
            momentum: along(&self.momentum, &other.momentum, &times),
        }
    }

    /// The change in this time along it.
    pub(crate) fn times(&self, h: &T) -> Self {
        Self {
            attitude: Quaternion::from_vector(self.attitude.coords.map(|x| x * h.clone())),
            momentum: self.momentum.map(|x| x * h.clone()),
        }
    }
}

/// `start + rate h`.
pub(crate) fn along<T: Field, const N: usize>(
    start: &SVector<T, N>,
    rate: &SVector<T, N>,
    h: &T,
) -> SVector<T, N> {
    start.zip_map(rate, |x, y| x + y * h.clone())
}
