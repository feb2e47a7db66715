//! A cylinder, full or with a round hole along its axis.

use super::*;

/// A cylinder with its axis along z, centred at the origin.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{Cylinder, Solid};
/// let can = Cylinder::new(2.0, 3.0)?;
/// assert_eq!(can.measure()?, 12.0 * std::f64::consts::PI);
/// assert_eq!(can.with_mass(12.0)?.inertia().matrix().diagonal(), Vector3::new(21.0, 21.0, 24.0));
/// let ring = Cylinder::hollow(1.0, 2.0, 3.0)?;
/// assert_eq!(ring.measure()?, 9.0 * std::f64::consts::PI);
/// assert_eq!(ring.with_mass(12.0)?.inertia().matrix().diagonal(), Vector3::new(24.0, 24.0, 30.0));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    /// Radii of the hole and of the whole, height.
    sizes: [f64; 3],
}

impl Cylinder {
    /// A full one, from radius and height, m.
    ///
    /// # Errors
    /// A size that is not finite and positive.
    pub fn new(radius: f64, height: f64) -> Result<Self, Error> {
        positive(Subject::Radius, radius)?;
        Self::hollow(0.0, radius, height)
    }

    /// A tube, from the radii of the hole (0 for none) and of the whole, and the height, m. The radii may be
    /// equal: then it is thin, and has a mass but no volume to give a density to.
    ///
    /// # Errors
    /// A size that is not finite, an inner radius below zero, another size not above zero, or an inner
    /// radius beyond the outer.
    pub fn hollow(inner: f64, outer: f64, height: f64) -> Result<Self, Error> {
        ordered(inner, outer)?;
        positive(Subject::Height, height)?;
        Ok(Self { sizes: [inner, outer, height] })
    }
}

impl Shape<2> for Cylinder {
    /// The moments of a full cylinder: `m/12 (3r² + h²)` across, `m r²/2` along its axis, z.
    /// Source: [LL76](crate::references), section 32, problem 2c.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::solid::{Cylinder, Shape};
    /// assert_eq!(Cylinder::moments(&12.0, [&2.0, &3.0]), Vector3::new(21.0, 21.0, 24.0));
    /// ```
    fn moments<T: Field>(mass: &T, [radius, height]: [&T; 2]) -> Vector3<T> {
        Self::moments(mass, [&T::zero(), radius, height])
    }
}

impl Shape<3> for Cylinder {
    /// The moments of a tube: `m/12 (3(i² + o²) + h²)` across, `m/2 (i² + o²)` along its axis, z. It is a
    /// cylinder minus a cylinder, with the factor `o² - i²` divided out, so nothing cancels.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::solid::{Cylinder, Shape};
    /// assert_eq!(Cylinder::moments(&12.0, [&1.0, &2.0, &3.0]), Vector3::new(24.0, 24.0, 30.0));
    /// ```
    fn moments<T: Field>(mass: &T, [inner, outer, height]: [&T; 3]) -> Vector3<T> {
        let radii = square(inner) + square(outer);
        let across = mass.clone() * (T::integer(3) * radii.clone() + square(height)) / T::integer(12);
        Vector3::new(across.clone(), across, mass.clone() * radii / T::integer(2))
    }
}

solid!(Cylinder, Volume, |[i, o, h]| Extended::from(PI) * ((o - i) * (o + i) * h));
