//! Stability of a steady spin about each principal axis.

use crate::error::{Error, Refusal, Subject, finite};
use crate::inertia::{Axis, PrincipalMoments};
use crate::number::Field;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The square of the rate at which a small disturbance changes, (1/s)²: positive where it grows, negative
/// where it librates, for a spin `omega` about the axis with moment `about`, the others being `first` and
/// `second`.
///
/// It is `-w² (I - I_first)(I - I_second) / (I_first I_second)`: Euler's equations with the two small
/// components' product left out. Only the order of the moments decides its sign [LL76](crate::references).
///
/// ```
/// // The middle of 1, 2, 3 grows, the ends do not.
/// assert!(tumbling::dynamics::stability::rate_squared(&1.0, &2.0, &1.0, &3.0) > 0.0);
/// assert!(tumbling::dynamics::stability::rate_squared(&1.0, &1.0, &2.0, &3.0) < 0.0);
/// assert!(tumbling::dynamics::stability::rate_squared(&1.0, &3.0, &1.0, &2.0) < 0.0);
/// ```
#[must_use]
pub fn rate_squared<T: Field>(omega: &T, about: &T, first: &T, second: &T) -> T {
    let [w, i, a, b] = [omega, about, first, second].map(T::clone);
    w.clone() * w * ((i.clone() - a.clone()) / a) * ((b.clone() - i) / b)
}

/// What a small disturbance of a steady spin does.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Stability {
    /// The spin librates: it circles the axis on a small closed curve in body axes, and stays close to it.
    Libration {
        /// Angular frequency, rad/s.
        rate: f64,
    },
    /// It grows as `exp(rate t)` while small: the spin will flip.
    Growth {
        /// Growth rate, 1/s.
        rate: f64,
    },
    /// It neither librates nor grows exponentially: the moment is one of an equal pair (or the body is not
    /// turning). A disturbance then grows in proportion to time.
    Neutral,
}

/// The fate of a small disturbance of a steady spin `omega` (rad/s) about `axis`.
///
/// ```
/// use tumbling::{Axis, PrincipalMoments, dynamics::stability::{Stability, of_spin}};
/// let moments = PrincipalMoments::new(1.0, 2.0, 3.0)?;
/// let Stability::Growth { rate } = of_spin(moments, Axis::Middle, 10.0)? else { panic!() };
/// assert_eq!(format!("{rate:.4}"), "5.7735"); // 10 / sqrt(3)
/// let Stability::Libration { rate } = of_spin(moments, Axis::Smallest, 10.0)? else { panic!() };
/// assert_eq!(format!("{rate:.4}"), "5.7735"); // 10 sqrt(1/2 · 2/3)
/// # Ok::<(), tumbling::Error>(())
/// ```
///
/// # Errors
/// A spin that is not finite, or a rate beyond `f64`.
pub fn of_spin(moments: PrincipalMoments, axis: Axis, omega: f64) -> Result<Stability, Error> {
    let sorted = moments.sorted();
    let speed = finite(Subject::Spin, omega)?.abs();
    let [about, first, second] = [0, 1, 2].map(|k| sorted[(axis.index() + k) % 3]);
    // Rooted factor by factor, so that neither a tiny moment nor a tiny spin underflows.
    let relative = |other: f64| ((about - other).abs().sqrt() / other.sqrt()).abs();
    let factor = relative(first) * relative(second);
    let rate = speed * factor;
    if factor == 0.0 || speed == 0.0 {
        return Ok(Stability::Neutral);
    }
    Refusal::OutOfRange { what: Subject::DisturbanceRate, value: rate }
        .when(!rate.is_finite() || rate == 0.0)?;
    Ok(match axis {
        Axis::Middle => Stability::Growth { rate },
        Axis::Smallest | Axis::Largest => Stability::Libration { rate },
    })
}
