//! The period of the spin, and its path in the body, from what stays the same in the motion alone.

use super::elliptic::quarter_period_from_root;
use crate::dynamics::invariants::{Asymmetric, Kind, classify};
use crate::error::{Error, Refusal, Subject, finite_vector, representable};
use crate::inertia::PrincipalMoments;
use crate::number::double_double::DoubleDouble;
use crate::number::functions::hypot;
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
    Refusal::OutOfRange { what, value }.when(!value.is_finite() || value <= 0.0).map(|()| value)
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

/// The extent of the closed curve that the spin of a free body runs along in body axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Polhode {
    /// The smallest magnitude of the spin's component along each principal axis, rad/s.
    pub least: Vector3<f64>,
    /// The largest, rad/s.
    pub greatest: Vector3<f64>,
    /// The period, s. None where the spin is constant, or on the separatrix, where it never returns.
    pub period: Option<f64>,
}

impl Polhode {
    /// For principal moments (kg m²) and a spin (rad/s) along the same axes at any instant of the motion.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::{PrincipalMoments, exact::Polhode};
    /// // A spin about the middle axis, with a push along the third: on the way it nears both others.
    /// let polhode = Polhode::new(PrincipalMoments::new(1.0, 2.0, 2.5)?, &Vector3::new(0.0, 5.0, 0.1))?;
    /// assert!((polhode.least - Vector3::new(0.0, 0.0, 0.1)).norm() < 1e-15);
    /// // C (C - A) w3² there is what C (C - A) w3² + B (B - A) w2² is at the start.
    /// assert!((polhode.greatest.z - (0.01 + 50.0 / 3.75_f64).sqrt()).abs() < 1e-15);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// A spin that is not finite, or one so great that it grows beyond `f64` on its way, or a period beyond
    /// `f64`.
    pub fn new(moments: PrincipalMoments, omega: &Vector3<f64>) -> Result<Self, Error> {
        finite_vector(Subject::Spin, omega)?;
        let still = omega.map(f64::abs);
        let polhode = match classify(moments, omega) {
            Kind::Steady => Self { least: still, greatest: still, period: None },
            Kind::Symmetric(axis) => {
                let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
                let across = hypot(omega[a], omega[b]);
                let (mut least, mut greatest) = (still, still);
                for across_axis in [a, b] {
                    (least[across_axis], greatest[across_axis]) = (0.0, across);
                }
                let rate = omega[axis] * ((moments[axis] - moments[a]) / moments[a]);
                let period = Some(core::f64::consts::TAU / rate.abs()).filter(|period| period.is_finite());
                Self { least, greatest, period }
            }
            Kind::Asymmetric(motion) => {
                let [across, middle, around] =
                    motion.amplitudes(0).map(|size| times_power_of_two(size.hi(), motion.clock));
                let (mut least, mut greatest) = (Vector3::zeros(), Vector3::zeros());
                greatest[motion.across] = across;
                greatest[motion.middle] = middle;
                greatest[motion.around] = around;
                // Zero on the separatrix.
                least[motion.around] = around * motion.complement(0).hi();
                let period = time_between_flips(moments, omega)?.map(|half| 2.0 * half);
                Self { least, greatest, period }
            }
        };
        representable(Subject::GreatestSpin, polhode.greatest.as_slice())?;
        representable(Subject::Period, polhode.period.as_slice())?;
        Ok(polhode)
    }
}
