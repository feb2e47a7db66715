//! The path of the spin in the body, from what is conserved alone.

use super::Principal;
use crate::dynamics::regime::{Kind, classify};
use crate::dynamics::stability::time_between_flips;
use crate::error::Error;
use crate::number::power_of_two::times_power_of_two;
use nalgebra::Vector3;

/// The closed curve that the spin of a free body runs along, seen from the body: how far it goes along each principal axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Polhode {
    /// The least size of the spin's component along each principal axis, rad/s.
    pub least: Vector3<f64>,
    /// The greatest, rad/s.
    pub greatest: Vector3<f64>,
    /// How long once around takes, s. None where the spin stands still, or never comes round.
    pub period: Option<f64>,
}

impl Polhode {
    pub(super) fn of(body: &Principal) -> Result<Self, Error> {
        let (moments, omega) = (body.moments, body.omega);
        let still = omega.map(f64::abs);
        match classify(moments, &omega) {
            Kind::Steady => Ok(Self { least: still, greatest: still, period: None }),
            Kind::Symmetric(axis) => {
                let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
                let across = omega[a].hypot(omega[b]);
                let (mut least, mut greatest) = (still, still);
                for side in [a, b] {
                    (least[side], greatest[side]) = (0.0, across);
                }
                let rate = omega[axis] * ((moments[axis] - moments[a]) / moments[a]);
                let period = Some(std::f64::consts::TAU / rate.abs()).filter(|period| period.is_finite());
                Ok(Self { least, greatest, period })
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
                let period = time_between_flips(moments, &omega)?.map(|half| 2.0 * half);
                Ok(Self { least, greatest, period })
            }
        }
    }
}
