//! A body in motion: its inertia, attitude and angular momentum. The spin is derived from these.

pub mod named;
pub(crate) mod rate;

use crate::attitude;
use crate::error::{Error, Refusal, Subject, finite_vector, representable};
use crate::inertia::{Inertia, length, omega_world, product};
use crate::number::{Analytic, Field, exponent, times_power_of_two};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
pub(crate) use rate::{Rate, along};

/// A rigid body turning about its centre of mass, or a top about a fixed point: the constant inertia tensor
/// about that point in the body's own axes, an attitude that takes body coordinates to world, and the angular
/// momentum in the world.
///
/// The momentum is stored, since a free body conserves it; the spin follows from it by the inverse tensor,
/// which is computed once and rotated to the current attitude.
///
/// ```
/// use nalgebra::{UnitQuaternion, Vector3};
/// use tumbling::{Body, Inertia};
///
/// let inertia = Inertia::from_moments(10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0)?;
/// let body = Body::spinning(inertia, UnitQuaternion::identity(), &Vector3::new(1.0, 1.0, 0.0))?;
/// assert_eq!(body.momentum_world(), Vector3::new(10.0 / 12.0, 13.0 / 12.0, 0.0));
/// assert!((body.energy() - 23.0 / 24.0).abs() < 1e-15);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    inertia: Inertia,
    inverse: Matrix3<f64>,
    attitude: UnitQuaternion<f64>,
    rotation: Matrix3<f64>,
    momentum: Vector3<f64>,
}

impl Body {
    /// A body with the given angular momentum in world axes, kg m²/s.
    ///
    /// # Errors
    /// An inertia without inverse, an attitude whose length is not 1 to a billionth, a value that is not
    /// finite, or a momentum or spin whose length is beyond `f64`. (A length that is nearly 1 is scaled to 1:
    /// only the direction of a quaternion determines the attitude.)
    pub fn new(
        inertia: Inertia,
        attitude: UnitQuaternion<f64>,
        momentum_world: &Vector3<f64>,
    ) -> Result<Self, Error> {
        let inverse = inertia.inverse()?;
        Self::in_range(inertia, inverse, attitude, momentum_world)
    }

    /// A body whose momentum and spin are finite along all axes, and whose spin has not vanished.
    fn in_range(
        inertia: Inertia,
        inverse: Matrix3<f64>,
        attitude: UnitQuaternion<f64>,
        momentum_world: &Vector3<f64>,
    ) -> Result<Self, Error> {
        finite_vector(Subject::AngularMomentum, momentum_world)?;
        let attitude = attitude::checked(attitude)?;
        let rotation = attitude::rotation_matrix(attitude.quaternion());
        let body = Self { inertia, inverse, attitude, rotation, momentum: *momentum_world };
        let omega = body.omega_body();
        // A margin for the rounding of a rotation, so that they are finite along all axes.
        for (what, vector) in [(Subject::AngularMomentum, momentum_world), (Subject::Spin, &omega)] {
            representable(what, &[length(vector) * (1.0 + 1e-12)])?;
        }
        Refusal::OutOfRange { what: Subject::Spin, value: 0.0 }
            .when(omega == Vector3::zeros() && *momentum_world != Vector3::zeros())?;
        Ok(body)
    }

    /// A body with the given spin in body axes, rad/s.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new), or a momentum `I w` beyond `f64`.
    pub fn spinning(
        inertia: Inertia,
        attitude: UnitQuaternion<f64>,
        omega_body: &Vector3<f64>,
    ) -> Result<Self, Error> {
        finite_vector(Subject::Spin, omega_body)?;
        let momentum = product(&attitude::matrix(attitude)?, &product(&inertia.matrix(), omega_body));
        representable(Subject::AngularMomentum, momentum.as_slice())?;
        Refusal::OutOfRange { what: Subject::AngularMomentum, value: 0.0 }
            .when(momentum == Vector3::zeros() && *omega_body != Vector3::zeros())?;
        Self::new(inertia, attitude, &momentum)
    }

    /// This body with another attitude and momentum in world axes; its inverse is not computed again.
    pub(crate) fn with(
        &self,
        attitude: UnitQuaternion<f64>,
        momentum_world: &Vector3<f64>,
    ) -> Result<Self, Error> {
        Self::in_range(self.inertia, self.inverse, attitude, momentum_world)
    }

    /// The inertia tensor in the body frame, which never changes.
    #[must_use]
    pub fn inertia(&self) -> Inertia {
        self.inertia
    }

    /// The inverse of its tensor in the body frame, 1/(kg m²), computed when the body was made.
    pub(crate) fn inverse(&self) -> Matrix3<f64> {
        self.inverse
    }

    /// The attitude, body to world.
    #[must_use]
    pub fn attitude(&self) -> UnitQuaternion<f64> {
        self.attitude
    }

    /// The attitude as a rotation matrix, the book's `R`, body to world.
    #[must_use]
    pub fn rotation(&self) -> Matrix3<f64> {
        self.rotation
    }

    /// Angular momentum in world axes, kg m²/s: constant while no torque acts.
    #[must_use]
    pub fn momentum_world(&self) -> Vector3<f64> {
        self.momentum
    }

    /// Angular momentum in body axes, kg m²/s: constant in length only.
    #[must_use]
    pub fn momentum_body(&self) -> Vector3<f64> {
        product(&self.rotation.transpose(), &self.momentum)
    }

    /// Angular velocity in world axes, rad/s: `R J R^T L`.
    #[must_use]
    pub fn omega_world(&self) -> Vector3<f64> {
        let omega = omega_world(&self.rotation, &self.inverse, &self.momentum);
        // The inverse along the world's axes may be beyond `f64` where the spin is not.
        if omega.iter().all(|x| x.is_finite()) { omega } else { product(&self.rotation, &self.omega_body()) }
    }

    /// Angular velocity in body axes, rad/s.
    #[must_use]
    pub fn omega_body(&self) -> Vector3<f64> {
        product(&self.inverse, &self.momentum_body())
    }

    /// Attitude and angular momentum, the momentum in body axes.
    #[must_use]
    pub fn state(&self) -> State<f64> {
        State { attitude: self.attitude.into_inner(), momentum: self.momentum_body() }
    }

    /// This body in another state; its inverse is not computed again.
    pub(crate) fn with_state(&self, state: &State<f64>) -> Result<Self, Error> {
        let attitude = attitude::checked(UnitQuaternion::new_unchecked(state.attitude))?;
        self.with(attitude, &product(&attitude::rotation_matrix(attitude.quaternion()), &state.momentum))
    }

    /// Kinetic energy of the rotation, J: half of `w . L`. It is infinite above the range of `f64`; below the
    /// range it is zero or has lost digits.
    #[must_use]
    pub fn energy(&self) -> f64 {
        let (omega, momentum) = (self.omega_body(), self.momentum_body());
        let energy = 0.5 * omega.dot(&momentum);
        if energy.is_finite() {
            return energy;
        }
        // Terms of opposite sign are beyond `f64`: their sum may still be within it.
        let scaled =
            |v: Vector3<f64>| (v.map(|x| times_power_of_two(x, -exponent(v.amax()))), exponent(v.amax()));
        let ((omega, a), (momentum, b)) = (scaled(omega), scaled(momentum));
        times_power_of_two(0.5 * omega.dot(&momentum), a + b)
    }
}

/// A body's attitude and angular momentum at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State<T: nalgebra::Scalar> {
    /// Body to world; of length 1 for a body, of any length inside a step.
    pub attitude: Quaternion<T>,
    /// In body axes, kg m²/s.
    pub momentum: Vector3<T>,
}

impl<T: Field> State<T> {
    /// `self + rate h`: straight along the rate for `h` seconds; the length of the attitude is not restored.
    #[must_use]
    pub fn plus(&self, rate: &Rate<T>, h: T) -> Self {
        Self {
            attitude: Quaternion::from_vector(along(&self.attitude.coords, &rate.attitude.coords, &h)),
            momentum: along(&self.momentum, &rate.momentum, &h),
        }
    }
}

impl<T: Analytic> State<T> {
    /// The state, if all its numbers are finite: a check for your own steps.
    ///
    /// ```
    /// use nalgebra::{Quaternion, Vector3};
    /// use tumbling::{State, Subject};
    /// let momentum = Vector3::new(1.0, 1e300 * 1e300, 0.0);
    /// let error = State { attitude: Quaternion::identity(), momentum }.checked().unwrap_err();
    /// assert_eq!(error.subject(), Subject::MotionAfterStep);
    /// ```
    ///
    /// # Errors
    /// A number that is not finite.
    pub fn checked(self) -> Result<Self, Error> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_takes_its_own_state_up_to_the_largest_numbers() {
        let turn = UnitQuaternion::from_euler_angles(0.4, -1.1, 2.0);
        let inertia = Inertia::from_moments(1.0, 1.5, 2.0).unwrap();
        for tensor in [inertia, inertia.turned(UnitQuaternion::from_euler_angles(1.0, 0.2, -0.5)).unwrap()] {
            for momentum in [Vector3::new(f64::MAX, 0.0, 0.0), Vector3::new(1.0, 0.9, -1.1) * 1e308] {
                for size in [1.0, 1.0 - 1e-11, 0.5] {
                    let Ok(body) = Body::new(tensor, turn, &(momentum * size)) else { continue };
                    let same = body.with_state(&body.state()).unwrap();
                    let off = (same.momentum_world() * 0.25 - body.momentum_world() * 0.25).amax();
                    assert!(off <= 1e-15 * f64::MAX, "{off:e}");
                    assert!(body.omega_world().iter().chain(&body.omega_body()).all(|x| x.is_finite()));
                }
            }
        }
        let nearly = Body::new(inertia, turn, &Vector3::new(0.999 * f64::MAX, 0.0, 0.0));
        assert!(nearly.is_ok(), "{nearly:?}");
    }
}
