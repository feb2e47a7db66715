//! A full cylinder.

use super::{MassProperties, Solid, centred, square};
use crate::error::{Error, positive};
use crate::number::Field;
use crate::number::extended::Extended;
use core::f64::consts::PI;
use nalgebra::Vector3;

/// The moments of a full cylinder about its centre: `m/12 (3r² + h²)` across, `m r²/2` along its axis, z.
/// Source: [LL76](crate::references), section 32, problem 2c.
///
/// ```
/// use nalgebra::Vector3;
/// let moments = tumbling::solid::cylinder_moments(&12.0, &2.0, &3.0);
/// assert_eq!(moments, Vector3::new(21.0, 21.0, 24.0));
/// ```
#[must_use]
pub fn cylinder_moments<T: Field>(mass: &T, radius: &T, height: &T) -> Vector3<T> {
    let rr = square(radius);
    let across = mass.clone() * (T::integer(3) * rr.clone() + square(height)) / T::integer(12);
    Vector3::new(across.clone(), across, mass.clone() * rr / T::integer(2))
}

/// A full cylinder with its axis along z, centred at the origin.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{Cylinder, Solid};
/// let can = Cylinder::new(2.0, 3.0)?;
/// assert_eq!(can.measure()?, 12.0 * std::f64::consts::PI);
/// assert_eq!(can.with_mass(12.0)?.inertia().matrix().diagonal(), Vector3::new(21.0, 21.0, 24.0));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    radius: f64,
    height: f64,
}

impl Cylinder {
    /// From radius and height, m.
    ///
    /// # Errors
    /// A size that is not finite and positive.
    pub fn new(radius: f64, height: f64) -> Result<Self, Error> {
        positive("the radius", radius)?;
        positive("the height", height)?;
        Ok(Self { radius, height })
    }
}

impl Solid for Cylinder {
    fn measure(&self) -> Result<f64, Error> {
        let (r, h) = (Extended::from(self.radius), Extended::from(self.height));
        (Extended::from(PI) * (square(&r) * h)).in_full("the volume")
    }

    fn with_mass(&self, mass: f64) -> Result<MassProperties, Error> {
        let (r, h) = (Extended::from(self.radius), Extended::from(self.height));
        centred(mass, |m| cylinder_moments(m, &r, &h))
    }
}
