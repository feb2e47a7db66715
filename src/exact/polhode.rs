//! The path of the spin in the body, from what is conserved alone.

use crate::dynamics::invariants::{Kind, classify};
use crate::error::{Error, Subject, finite_vector, representable};
use crate::exact::time_between_flips;
use crate::inertia::PrincipalMoments;
use crate::number::functions::hypot;
use crate::number::power_of_two::times_power_of_two;
use nalgebra::Vector3;

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
