//! What becomes of a small wobble about each principal axis: its rate, and the time between flips.

use crate::double::Double;
use crate::error::{Error, finite, finite_vector, positive};
use crate::principal::Axis;
use crate::scalar::Field;
use crate::scale::{exponent, times_power_of_two};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// The square of the rate at which a small wobble changes, (1/s)²: positive where it grows, negative
/// where it swings, for a spin `omega` about the axis with moment `about`, the others being `first` and
/// `second`.
///
/// It is `-w² (I - I_first)(I - I_second) / (I_first I_second)`: Euler's equations with the two small
/// components' product left out. Only the order of the moments decides its sign [LL76](crate::references).
///
/// ```
/// // The middle of 1, 2, 3 grows, the ends do not.
/// assert!(tumbling::stability::rate_squared(&1.0, &2.0, &1.0, &3.0) > 0.0);
/// assert!(tumbling::stability::rate_squared(&1.0, &1.0, &2.0, &3.0) < 0.0);
/// assert!(tumbling::stability::rate_squared(&1.0, &3.0, &1.0, &2.0) < 0.0);
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
/// use tumbling::{Axis, stability::{Stability, of_spin}};
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

/// The time between two flips of a free body, s: half the period of its spin as seen from the body.
/// `None` where it never flips: a steady spin, two equal moments, or exactly on the separatrix.
///
/// Takes the principal moments and the spin along the same axes, in any order. A flip is when the spin
/// component along the middle axis changes sign; every free motion but those named does that, a stable
/// wobble too, where it is small and quick.
///
/// The formula is `2 K / rate` [LL76](crate::references), section 37, with the elliptic integral `K` from the arithmetic-geometric mean
/// [Gau99](crate::references). The small differences on which it hangs are taken between the given moments, never between
/// squares, so that it is right for a push of 1e-300 too.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::stability::time_between_flips;
/// let moments = Vector3::new(1.0, 2.0, 3.0);
/// let book = time_between_flips(&moments, &Vector3::new(0.0, 10.0, 0.001))?;
/// assert_eq!(format!("{:.4}", book.unwrap()), "3.4805");
/// assert_eq!(time_between_flips(&moments, &Vector3::new(0.0, 10.0, 0.0))?, None);
/// # Ok::<(), tumbling::Error>(())
/// ```
///
/// # Errors
/// A moment that is not finite and positive, a spin that is not finite, or a time beyond `f64`.
pub fn time_between_flips(moments: &Vector3<f64>, omega: &Vector3<f64>) -> Result<Option<f64>, Error> {
    for &moment in moments {
        positive("a principal moment", moment)?;
    }
    finite_vector("the spin", omega)?;
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
    // Only ratios of moments matter, and ratios of spins but for the clock: take powers of two out, so
    // that no product leaves the range, and put the largest spin high, so that the smallest stays exact.
    let heaviest = exponent(moments.max());
    let clock = exponent(omega.amax()) - 500;
    let [low, middle, high] = order.map(|i| times_power_of_two(moments[i], -heaviest));
    let [w_low, w_middle, w_high] = order.map(|i| times_power_of_two(omega[i].abs(), -clock));
    let (above, below, across) = (high - middle, middle - low, high - low);
    if above == 0.0 || below == 0.0 || (w_low == 0.0 && w_high == 0.0) {
        return Ok(None);
    }
    if w_middle == 0.0 && (w_low == 0.0 || w_high == 0.0) {
        return Ok(None);
    }
    // L² - 2 E I2, which says how far the motion is from the separatrix and on which side: a difference of
    // two terms that nearly cancel there, hence in double the precision; the small spins at a scale of their own.
    let small = exponent(w_low.max(w_high)) & !1; // even, so that it can be halved below
    let term = |moment: f64, difference: f64, w: f64| {
        let w = Double::from(times_power_of_two(w, -small));
        Double::from(moment) * Double::from(difference) * w * w
    };
    let discriminant = (term(high, above, w_high) - term(low, below, w_low)).value();
    // The axis that the spin circles (C), the other end (X), and how far each is from the middle.
    let (i_c, d_c, w_c, i_x, d_x) = if discriminant >= 0.0 {
        (high, above, w_high, low, below)
    } else {
        (low, below, w_low, high, above)
    };
    let q = ((middle * d_x).sqrt() * w_middle).hypot((i_c * across).sqrt() * w_c);
    let rate = (d_c / (middle * i_c * i_x)).sqrt() * q;
    // The modulus' complement, 0 on the separatrix: its root, since itself it can be below any f64.
    let root = ((across / d_c).sqrt() * discriminant.abs().sqrt()).sqrt() / q.sqrt();
    let root_of_complement = times_power_of_two(root, small / 2);
    if root_of_complement == 0.0 {
        return Ok(None);
    }
    let half_period = PI / (rate * mean_of_one_and_square(root_of_complement.min(1.0)));
    let time = times_power_of_two(half_period, -clock);
    if !time.is_finite() || time == 0.0 {
        return Err(Error::OutOfRange { what: "the time between flips", value: time });
    }
    Ok(Some(time))
}

/// The common limit of the arithmetic and geometric means of 1 and `root²`, for `0 < root <= 1`.
fn mean_of_one_and_square(root: f64) -> f64 {
    let (mut a, mut g) = (0.5 * (1.0 + root * root), root);
    // Each step doubles the digits, once the first few have brought 1e-162 up to where that sets in.
    while a - g > 4.0 * f64::EPSILON * a {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    0.5 * (a + g)
}
