//! The period of the spin, from what stays the same in the motion.

use super::elliptic::quarter_period_from_root;
use crate::dynamics::invariants::{Asymmetric, Kind, classify};
use crate::error::{Error, Refusal, Subject, finite_vector};
use crate::inertia::PrincipalMoments;
use crate::number::double_double::DoubleDouble;
use crate::number::power_of_two::times_power_of_two;
use crate::number::{Real, splat};
use nalgebra::Vector3;

/// `K`, a quarter of the period in Jacobi's argument; infinite on the separatrix.
pub(super) fn quarter_period<T: Real>(motion: &Asymmetric<T>) -> DoubleDouble<T> {
    if motion.separatrix {
        return DoubleDouble::from(splat::<T>(f64::INFINITY));
    }
    quarter_period_from_root(motion.complement(0), motion.root_of_complement())
}

/// A length of time that is above zero, in scaled units, in seconds.
pub(super) fn seconds(what: Subject, scaled: f64, exponent: i32) -> Result<f64, Error> {
    let value = times_power_of_two(scaled, -exponent);
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(Refusal::OutOfRange { what, value }.into()) }
}

/// The time between two flips of a free body, s: half the period of its spin in body axes.
/// `None` where it never flips: a steady spin, two equal moments, or exactly on the separatrix.
///
/// The spin (rad/s) is along the principal axes. A flip is when the spin component along the middle axis
/// changes sign; every free motion but those named does that, a stable libration too, where it is small and
/// quick. From a start with that component exactly zero, which is a flip at time 0, it is the time of the
/// first flip after the start.
///
/// The formula is `2 K / rate` [LL76](crate::references), section 37, with the elliptic integral `K` from the
/// arithmetic-geometric mean [Gau99](crate::references). The small differences on which it depends are taken
/// between the given moments, never between squares, so that it is right for a push of 1e-300 too.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::{PrincipalMoments, exact::time_between_flips};
/// let moments = PrincipalMoments::new(1.0, 2.0, 3.0)?;
/// let book = time_between_flips(moments, &Vector3::new(0.0, 10.0, 0.001))?;
/// assert_eq!(format!("{:.4}", book.unwrap()), "3.4805");
/// assert_eq!(time_between_flips(moments, &Vector3::new(0.0, 10.0, 0.0))?, None);
/// # Ok::<(), tumbling::Error>(())
/// ```
///
/// # Errors
/// A spin that is not finite, or a time beyond `f64`.
pub fn time_between_flips(moments: PrincipalMoments, omega: &Vector3<f64>) -> Result<Option<f64>, Error> {
    finite_vector(Subject::Spin, omega)?;
    let Kind::Asymmetric(motion) = classify(moments, omega) else {
        return Ok(None);
    };
    if motion.separatrix {
        return Ok(None);
    }
    // (C36)
    let half_period = quarter_period(&motion) * 2.0 / motion.rate();
    seconds(Subject::TimeBetweenFlips, half_period.hi(), motion.clock).map(Some)
}
