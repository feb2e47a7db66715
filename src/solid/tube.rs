//! A tube: a cylinder with a round hole along its axis.

use super::hollow_sphere::ordered;
use super::{MassProperties, Solid, centred, square};
use crate::error::{Error, not_negative, positive};
use crate::number::Field;
use crate::number::extended::Extended;
use core::f64::consts::PI;
use nalgebra::Vector3;

/// The moments of a tube about its centre: `m/12 (3(i² + o²) + h²)` across, `m/2 (i² + o²)` along its
/// axis, z. It is a cylinder minus a cylinder, with the factor `o² - i²` divided out, so nothing cancels.
///
/// ```
/// use nalgebra::Vector3;
/// let moments = tumbling::solid::tube_moments(&12.0, &1.0, &2.0, &3.0);
/// assert_eq!(moments, Vector3::new(24.0, 24.0, 30.0));
/// ```
#[must_use]
pub fn tube_moments<T: Field>(mass: &T, inner: &T, outer: &T, height: &T) -> Vector3<T> {
    let radii = square(inner) + square(outer);
    let across = mass.clone() * (T::integer(3) * radii.clone() + square(height)) / T::integer(12);
    Vector3::new(across.clone(), across, mass.clone() * radii / T::integer(2))
}

/// A tube with its axis along z, centred at the origin. Its radii may be equal: then it is thin, and has a
/// mass but no volume to give a density to.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{Solid, Tube};
/// let ring = Tube::new(1.0, 2.0, 3.0)?;
/// assert_eq!(ring.measure()?, 9.0 * std::f64::consts::PI);
/// assert_eq!(ring.with_mass(12.0)?.inertia().matrix().diagonal(), Vector3::new(24.0, 24.0, 30.0));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tube {
    inner: f64,
    outer: f64,
    height: f64,
}

impl Tube {
    /// From the radii of the hole (0 for none) and of the whole, and the height, m.
    ///
    /// # Errors
    /// A size that is not finite, an inner radius below zero, another size not above zero, or an inner
    /// radius beyond the outer.
    pub fn new(inner: f64, outer: f64, height: f64) -> Result<Self, Error> {
        not_negative("the inner radius", inner)?;
        positive("the outer radius", outer)?;
        positive("the height", height)?;
        ordered(inner, outer)?;
        Ok(Self { inner, outer, height })
    }
}

impl Solid for Tube {
    fn measure(&self) -> Result<f64, Error> {
        let [i, o, h] = [self.inner, self.outer, self.height].map(Extended::from);
        (Extended::from(PI) * ((o - i) * (o + i) * h)).in_full("the volume")
    }

    fn with_mass(&self, mass: f64) -> Result<MassProperties, Error> {
        let [i, o, h] = [self.inner, self.outer, self.height].map(Extended::from);
        centred(mass, |m| tube_moments(m, &i, &o, &h))
    }
}
