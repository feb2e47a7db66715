//! Euler's equations: how spin and momentum change in body axes.
//!
//! They are written component by component, as in textbooks, for any number type. All vectors here are in the
//! body frame. Source: [Eul65](crate::references).

use crate::number::{Field, Ring};
use nalgebra::{Matrix3, Vector3};

/// The right-hand sides `(I2 - I3) w2 w3, (I3 - I1) w3 w1, (I1 - I2) w1 w2`, in N m: the values of `I w'`
/// without a torque, along principal axes in the order of `moments`.
///
/// ```
/// use nalgebra::Vector3;
/// let coupling = tumbling::dynamics::euler::coupling(&Vector3::new(2, 3, 4), &Vector3::new(1, 10, 100));
/// assert_eq!(coupling, Vector3::new(-1000, 200, -10));
/// ```
#[must_use]
pub fn coupling<T: Ring>(moments: &Vector3<T>, omega: &Vector3<T>) -> Vector3<T> {
    let term = |i: usize, j: usize| {
        (moments[i].clone() - moments[j].clone()) * (omega[i].clone() * omega[j].clone())
    };
    Vector3::new(term(1, 2), term(2, 0), term(0, 1))
}

/// Angular acceleration `w'` along principal axes, rad/s²: `I1 w1' = (I2 - I3) w2 w3 + torque1` and
/// cyclically, divided by the moments (kg m²), for a spin in rad/s and a torque in N m along the same axes.
///
/// ```
/// use nalgebra::Vector3;
/// let (moments, omega) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.0, 1.0, 2.0));
/// let free = tumbling::dynamics::euler::angular_acceleration(&moments, &omega, &Vector3::zeros());
/// assert_eq!(free, Vector3::new(-2.0, 0.0, 0.0));
/// let torque = Vector3::new(2.0, 0.0, 3.0);
/// let pushed = tumbling::dynamics::euler::angular_acceleration(&moments, &omega, &torque);
/// assert_eq!(pushed, Vector3::new(0.0, 0.0, 1.0));
/// ```
#[must_use]
pub fn angular_acceleration<T: Field>(
    moments: &Vector3<T>,
    omega: &Vector3<T>,
    torque: &Vector3<T>,
) -> Vector3<T> {
    (coupling(moments, omega) + torque).component_div(moments)
}

/// Euler's equations with the spin as the unknown, in any body axes: `I w' = (I w) x w + torque`, N m.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// let tensor = Matrix3::from_diagonal(&Vector3::new(2, 3, 4));
/// let omega = Vector3::new(1, 10, 100);
/// let rate = tumbling::dynamics::euler::tensor_times_acceleration(&tensor, &omega, &Vector3::zeros());
/// assert_eq!(rate, Vector3::new(-1000, 200, -10));
/// ```
#[must_use]
pub fn tensor_times_acceleration<T: Ring>(
    tensor: &Matrix3<T>,
    omega: &Vector3<T>,
    torque: &Vector3<T>,
) -> Vector3<T> {
    (tensor * omega).cross(omega) + torque
}
