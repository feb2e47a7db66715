//! Attitude and angular momentum at one instant: what moves, and all that a step needs to know of the past.

use crate::error::{Error, Refusal};
use crate::number::{Analytic, Field};
use nalgebra::{Quaternion, Vector3};

/// What a stepper moves: an attitude, and a vector that the attitude's rate depends on. For a
/// [`Method`](crate::step::Method) that is the angular momentum in body axes; for an [`Engine`](crate::step::Engine) momentum or spin in
/// the world. Also the rates of both.
#[derive(Debug, Clone, PartialEq)]
pub struct State<T: nalgebra::Scalar> {
    /// Body to world; of length 1 where a body stands, of any length inside a step.
    pub attitude: Quaternion<T>,
    /// The vector carried along.
    pub momentum: Vector3<T>,
}

impl<T: Field> State<T> {
    /// `self + other * factor`.
    pub(crate) fn plus(&self, other: &Self, factor: &T) -> Self {
        let along = |x: &T, y: T| x.clone() + y * factor.clone();
        Self {
            attitude: Quaternion::from_vector(
                self.attitude.coords.zip_map(&other.attitude.coords, |x, y| along(&x, y)),
            ),
            momentum: self.momentum.zip_map(&other.momentum, |x, y| along(&x, y)),
        }
    }
}

impl<T: Analytic> State<T> {
    /// The motion, if all its numbers are finite.
    pub(crate) fn whole(self) -> Result<Self, Error> {
        let size = self.attitude.coords.iter().chain(&self.momentum).map(Analytic::size).sum::<f64>();
        if size.is_finite() {
            Ok(self)
        } else {
            Err(Refusal::OutOfRange { what: "the motion after a step", value: size }.into())
        }
    }
}
