//! The classical fourth-order Runge-Kutta method [Kut01](crate::references), for any number type.

use super::method::{About, Keeps};
use crate::error::Error;
use crate::scalar::{Analytic, Field};
use nalgebra::{Quaternion, Vector3};

pub(super) const ABOUT: About =
    About { name: "Runge-Kutta 4", order: 4, implicit: false, keeps: Keeps::NOTHING, source: "Kut01" };

/// What a stepper moves: an attitude, and a vector that the attitude's rate depends on. For a
/// [`Method`](super::Method) that is the angular momentum in body axes; for an [`Engine`](super::Engine) momentum or spin in
/// the world. Also the rates of both.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion<T: nalgebra::Scalar> {
    /// Body to world; of length 1 where a body stands, of any length inside a step.
    pub attitude: Quaternion<T>,
    /// The vector carried along.
    pub vector: Vector3<T>,
}

impl<T: Field> Motion<T> {
    /// `self + other * factor`.
    pub(super) fn plus(&self, other: &Self, factor: &T) -> Self {
        let along = |x: &T, y: T| x.clone() + y * factor.clone();
        Self {
            attitude: Quaternion::from_vector(
                self.attitude.coords.zip_map(&other.attitude.coords, |x, y| along(&x, y)),
            ),
            vector: self.vector.zip_map(&other.vector, |x, y| along(&x, y)),
        }
    }
}

impl<T: Analytic> Motion<T> {
    /// The motion, if all its numbers are finite.
    pub(crate) fn whole(self) -> Result<Self, Error> {
        let size = self.attitude.coords.iter().chain(&self.vector).map(Analytic::size).sum::<f64>();
        if size.is_finite() {
            Ok(self)
        } else {
            Err(Error::OutOfRange { what: "the motion after a step", value: size })
        }
    }
}

/// One step of length `h` (s) from `start` under the law `rate`. Errors fall as `h^4`.
///
/// The attitude's length is not restored here: it drifts at the rate of the error, and shows it.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// use tumbling::step::{Motion, rk4};
/// let start = Motion { attitude: Quaternion::identity(), vector: Vector3::new(0.0, 0.0, 2.0) };
/// // A steady spin of 2 rad/s about z, for 0.1 s: a turn by 0.2 rad.
/// let law = |m: &Motion<f64>| Motion {
///     attitude: tumbling::attitude::rate(&m.attitude, &m.vector),
///     vector: Vector3::zeros(),
/// };
/// let end = rk4(&start, &0.1, law);
/// assert!((end.attitude.k - 0.1_f64.sin()).abs() < 1e-7);
/// ```
pub fn rk4<T: Field>(start: &Motion<T>, h: &T, rate: impl Fn(&Motion<T>) -> Motion<T>) -> Motion<T> {
    let half = h.clone() / T::integer(2);
    let k1 = rate(start);
    let k2 = rate(&start.plus(&k1, &half));
    let k3 = rate(&start.plus(&k2, &half));
    let k4 = rate(&start.plus(&k3, h));
    let sixth = h.clone() / T::integer(6);
    let third = h.clone() / T::integer(3);
    start.plus(&k1, &sixth).plus(&k2, &third).plus(&k3, &third).plus(&k4, &sixth)
}
