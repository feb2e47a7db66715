//! The classical fourth-order Runge-Kutta method [Kut01](crate::references), for any number type.

use crate::body::State;
use crate::number::Field;
use crate::step::method::{About, Keeps};

pub(crate) const ABOUT: About =
    About { name: "Runge-Kutta 4", order: 4, implicit: false, keeps: Keeps::NOTHING, source: "Kut01" };

/// One step of length `h` (s) from `start` under the law `rate`. Errors fall as `h^4`.
///
/// The attitude's length is not restored here: it drifts at the rate of the error, and shows it.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// use tumbling::step::{State, rk4};
/// let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.0, 0.0, 2.0) };
/// // A steady spin of 2 rad/s about z, for 0.1 s: a turn by 0.2 rad.
/// let law = |m: &State<f64>| State {
///     attitude: tumbling::body::attitude::rate(&m.attitude, &m.momentum),
///     momentum: Vector3::zeros(),
/// };
/// let end = rk4(&start, &0.1, law);
/// assert!((end.attitude.k - 0.1_f64.sin()).abs() < 1e-7);
/// ```
pub fn rk4<T: Field>(start: &State<T>, h: &T, rate: impl Fn(&State<T>) -> State<T>) -> State<T> {
    in_time(start, h, |state, _| rate(state))
}

/// The same for a law that also depends on the time since the start of the step.
pub(crate) fn in_time<T: Field>(
    start: &State<T>,
    h: &T,
    rate: impl Fn(&State<T>, &T) -> State<T>,
) -> State<T> {
    let half = h.clone() / T::integer(2);
    let k1 = rate(start, &T::zero());
    let k2 = rate(&start.plus(&k1, &half), &half);
    let k3 = rate(&start.plus(&k2, &half), &half);
    let k4 = rate(&start.plus(&k3, h), h);
    let sixth = h.clone() / T::integer(6);
    let third = h.clone() / T::integer(3);
    start.plus(&k1, &sixth).plus(&k2, &third).plus(&k3, &third).plus(&k4, &sixth)
}
