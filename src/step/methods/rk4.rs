//! The explicit Euler method [Eul68](crate::references) and the classical fourth-order Runge-Kutta method
//! [Kut01](crate::references), for any number type.

use crate::body::{Rate, State};
use crate::number::{Analytic, Field};
use crate::step::system::System;

/// Straight ahead along the rates at the start.
pub(crate) fn euler<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    start.plus(&system.rate(start), h.clone())
}

/// One step of `h` seconds from `start` under the law `rate`, where `plus` moves a state along a rate. Errors
/// fall as `h^4`.
///
/// The attitude's length is not restored: it drifts at the rate of the error, and shows it.
///
/// ```
/// use nalgebra::{Quaternion, Vector3};
/// use tumbling::{PrincipalMoments, step::{State, System, rk4}};
/// let system = System::free(PrincipalMoments::new(1.0, 2.0, 2.5)?)?;
/// // A steady spin of 2 rad/s about z, for 0.1 s: a turn by 0.2 rad.
/// let start = State { attitude: Quaternion::identity(), momentum: Vector3::new(0.0, 0.0, 5.0) };
/// let end = rk4(&start, 0.1, |state| system.rate(state), State::plus);
/// assert!((end.attitude.k - 0.1_f64.sin()).abs() < 1e-7);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[must_use]
pub fn rk4<S, R, T: Field>(start: &S, h: T, rate: impl Fn(&S) -> R, plus: impl Fn(&S, &R, T) -> S) -> S {
    let half = h.clone() / T::integer(2);
    let k1 = rate(start);
    let k2 = rate(&plus(start, &k1, half.clone()));
    let k3 = rate(&plus(start, &k2, half));
    let k4 = rate(&plus(start, &k3, h.clone()));
    let sixth = h.clone() / T::integer(6);
    let third = h / T::integer(3);
    let first = plus(start, &k1, sixth.clone());
    plus(&plus(&plus(&first, &k2, third.clone()), &k3, third), &k4, sixth)
}

/// One step of a body; the time goes along with the state.
pub(crate) fn step<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    let rate = |(state, time): &(State<T>, T)| system.rate_after(state, time);
    let plus =
        |(state, time): &(State<T>, T), rate: &Rate<T>, h: T| (state.plus(rate, h.clone()), time.clone() + h);
    rk4(&(start.clone(), T::zero()), h.clone(), rate, plus).0
}
