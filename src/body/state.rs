//! Attitude and angular momentum at one instant: what moves, and all that a step needs to know of the past.

use crate::error::{Error, Refusal, Subject};
use crate::number::{Analytic, Field};
use nalgebra::{Quaternion, SVector, Vector3};

/// A body's attitude and angular momentum at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State<T: nalgebra::Scalar> {
    /// Body to world; of length 1 for a body, of any length inside a step.
    pub attitude: Quaternion<T>,
    /// In body axes, kg m²/s.
    pub momentum: Vector3<T>,
}

/// The rate at which a [`State`] changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rate<T: nalgebra::Scalar> {
    /// `q' = q w / 2`, 1/s.
    pub attitude: Quaternion<T>,
    /// `L' = L x w + torque` in body axes, N m.
    pub momentum: Vector3<T>,
}

impl<T: Field> State<T> {
    /// `self + rate h`: straight along the rate for `h` seconds, the attitude's length left as it comes.
    #[must_use]
    pub fn plus(&self, rate: &Rate<T>, h: T) -> Self {
        Self {
            attitude: Quaternion::from_vector(along(&self.attitude.coords, &rate.attitude.coords, &h)),
            momentum: along(&self.momentum, &rate.momentum, &h),
        }
    }
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

impl<T: Analytic> State<T> {
    /// The state, if all its numbers are finite.
    pub(crate) fn checked(self) -> Result<Self, Error> {
        // Two loops of known length: a chain of iterators costs as much as a short step.
        let sum = |sum: f64, x: &T| sum + x.size();
        let size = self.attitude.coords.as_slice().iter().fold(0.0, sum);
        let size = self.momentum.as_slice().iter().fold(size, sum);
        if size.is_finite() {
            Ok(self)
        } else {
            Err(Refusal::OutOfRange { what: Subject::MotionAfterStep, value: size }.into())
        }
    }
}
