//! The explicit Euler method [Eul68](crate::references) and the classical fourth-order Runge-Kutta method
//! [Kut01](crate::references), for any number type.

use crate::body::{State, along};
use crate::number::{Analytic, Field};
use crate::step::system::System;
use nalgebra::Vector3;

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

/// [`rk4`] under a law of the time since the start too.
pub(crate) fn rk4_in_time<S: Clone, R, T: Field>(
    start: &S,
    h: &T,
    rate: impl Fn(&S, &T) -> R,
    plus: impl Fn(&S, &R, T) -> S,
) -> S {
    let rate = |(state, time): &(S, T)| rate(state, time);
    let plus = |(state, time): &(S, T), rate: &R, h: T| (plus(state, rate, h.clone()), time.clone() + h);
    rk4(&(start.clone(), T::zero()), h.clone(), rate, plus).0
}

/// One step of a body.
pub(crate) fn step<T: Analytic>(system: &System<T>, start: &State<T>, h: &T) -> State<T> {
    rk4_in_time(start, h, |state, time| system.rate_after(state, time), State::plus)
}

/// The turn since the start of a step, by axis and angle, and a momentum; or their rates.
#[derive(Clone)]
pub(crate) struct Turning<T: nalgebra::Scalar> {
    pub(crate) turn: Vector3<T>,
    pub(crate) momentum: Vector3<T>,
}

impl<T: Analytic> Turning<T> {
    /// The start of a step from this momentum.
    pub(crate) fn from(momentum: &Vector3<T>) -> Self {
        Self { turn: Vector3::from_fn(|_, _| T::zero()), momentum: momentum.clone() }
    }

    pub(crate) fn plus(&self, rate: &Self, h: T) -> Self {
        Self { turn: along(&self.turn, &rate.turn, &h), momentum: along(&self.momentum, &rate.momentum, &h) }
    }
}
