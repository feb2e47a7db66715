//! A full ball.

use super::{MassProperties, Solid, centred, cube, square};
use crate::error::{Error, positive};
use crate::number::Field;
use crate::number::extended::Extended;
use core::f64::consts::PI;
use nalgebra::Vector3;

/// The moment of a ball about any axis through its centre: `2/5 m r²`. Source:
/// [LL76](crate::references), section 32, problem 2b.
///
/// ```
/// assert_eq!(tumbling::solid::ball_moment(&10.0, &3.0), 36.0);
/// ```
#[must_use]
pub fn ball_moment<T: Field>(mass: &T, radius: &T) -> T {
    T::integer(2) * mass.clone() * square(radius) / T::integer(5)
}

/// A full ball, centred at the origin.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{Ball, Solid};
/// let ball = Ball::new(3.0)?;
/// assert!((ball.measure()? - 36.0 * std::f64::consts::PI).abs() < 1e-13);
/// assert_eq!(ball.with_mass(10.0)?.inertia().matrix().diagonal(), Vector3::repeat(36.0));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    radius: f64,
}

impl Ball {
    /// From its radius, m.
    ///
    /// # Errors
    /// A radius that is not finite and positive.
    pub fn new(radius: f64) -> Result<Self, Error> {
        Ok(Self { radius: positive("the radius", radius)? })
    }
}

impl Solid for Ball {
    fn measure(&self) -> Result<f64, Error> {
        let four_thirds_pi = Extended::from(4.0) * Extended::from(PI) / Extended::from(3.0);
        (four_thirds_pi * cube(&Extended::from(self.radius))).in_full("the volume")
    }

    fn with_mass(&self, mass: f64) -> Result<MassProperties, Error> {
        let r = Extended::from(self.radius);
        centred(mass, |m| Vector3::repeat(ball_moment(m, &r)))
    }
}
