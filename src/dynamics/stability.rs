//! What becomes of a small wobble about each principal axis, and at which rate.

use crate::error::{Error, finite, positive};
use crate::inertia::Axis;
use crate::number::Field;

/// The square of the rate at which a small wobble changes, (1/s)²: positive where it grows, negative
/// where it swings, for a spin `omega` about the axis with moment `about`, the others being `first` and
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
pub fn rate_squared<T: Field>(omega: &T, about: &T, first: &T, second: &T) -> T {
    let [w, i, a, b] = [omega, about, first, second].map(T::clone);
    w.clone() * w * ((i.clone() - a.clone()) / a) * ((b.clone() - i) / b)
}

/// What a small disturbance of a steady spin does.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Stability {
    /// It circles the axis, ever as small, at this many radians per second, seen from the body.
    Wobble {
        /// Angular frequency of the wobble, rad/s.
        rate: f64,
    },
    /// It grows as `exp(rate t)` while small: the spin will flip.
    Growth {
        /// Growth rate, 1/s.
        rate: f64,
    },
    /// It neither swings nor grows exponentially: the moment is one of an equal pair (or the body is not
    /// turning). A push then drifts steadily away, at the speed it was given.
    Neutral,
}

/// Sorted moments that are finite and positive; their order is what the axes' names mean.
fn sorted(moments: [f64; 3]) -> Result<[f64; 3], Error> {
    for moment in moments {
        positive("a principal moment", moment)?;
    }
    let mut sorted = moments;
    sorted.sort_by(f64::total_cmp);
    Ok(sorted)
}

/// The fate of a small disturbance of a steady spin `omega` (rad/s) about `axis`, for principal moments
/// in any order (kg m²).
///
/// ```
/// use tumbling::{Axis, dynamics::stability::{Stability, of_spin}};
/// let moments = [1.0, 2.0, 3.0];
/// let Stability::Growth { rate } = of_spin(moments, Axis::Middle, 10.0)? else { panic!() };
/// assert_eq!(format!("{rate:.4}"), "5.7735"); // 10 / sqrt(3)
/// assert!(matches!(of_spin(moments, Axis::Largest, 10.0)?, Stability::Wobble { .. }));
/// # Ok::<(), tumbling::Error>(())
/// ```
///
/// # Errors
/// A moment that is not finite and positive, a spin that is not finite, or a rate beyond `f64`.
pub fn of_spin(moments: [f64; 3], axis: Axis, omega: f64) -> Result<Stability, Error> {
    let sorted = sorted(moments)?;
    let speed = finite("the spin", omega)?.abs();
    let about = sorted[axis.index()];
    let [first, second] = match axis {
        Axis::Smallest => [sorted[1], sorted[2]],
        Axis::Middle => [sorted[0], sorted[2]],
        Axis::Largest => [sorted[0], sorted[1]],
    };
    // Rooted factor by factor, so that neither a tiny moment nor a tiny spin underflows.
    let relative = |other: f64| ((about - other).abs().sqrt() / other.sqrt()).abs();
    let factor = relative(first) * relative(second);
    let rate = speed * factor;
    if factor == 0.0 || speed == 0.0 {
        return Ok(Stability::Neutral);
    }
    if !rate.is_finite() || rate == 0.0 {
        return Err(Error::OutOfRange { what: "the rate of the wobble", value: rate });
    }
    Ok(match axis {
        Axis::Middle => Stability::Growth { rate },
        Axis::Smallest | Axis::Largest => Stability::Wobble { rate },
    })
}
