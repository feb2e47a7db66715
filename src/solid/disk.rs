//! An ideal round disk, without thickness.

use super::*;

/// An ideal thin disk in the xy plane, centred at the origin.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{Solid, ThinDisk};
/// let disk = ThinDisk::new(2.0)?;
/// assert_eq!(disk.measure()?, 4.0 * std::f64::consts::PI);
/// assert_eq!(disk.with_mass(3.0)?.inertia().matrix().diagonal(), Vector3::new(3.0, 3.0, 6.0));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThinDisk {
    sizes: [f64; 1],
}

impl ThinDisk {
    /// From its radius, m.
    ///
    /// # Errors
    /// A radius that is not finite and positive.
    pub fn new(radius: f64) -> Result<Self, Error> {
        Ok(Self { sizes: positive_sizes([(Subject::Radius, radius)])? })
    }
}

impl Shape<1> for ThinDisk {
    /// The moments of a thin disk in the xy plane about its centre: `m r²/4` across, `m r²/2` about z.
    /// A cylinder without height: [LL76](crate::references), section 32, problem 2c.
    ///
    /// ```
    /// use tumbling::solid::{ThinDisk, Shape};
    /// use nalgebra::Vector3;
    /// assert_eq!(ThinDisk::moments(&3.0, [&2.0]), Vector3::new(3.0, 3.0, 6.0));
    /// ```
    fn moments<T: Field>(mass: &T, [radius]: [&T; 1]) -> Vector3<T> {
        let across = mass.clone() * square(radius) / T::integer(4);
        Vector3::new(across.clone(), across.clone(), across.clone() + across)
    }
}

// The area, m², so that its density is in kg/m².
solid!(ThinDisk, Area, |[radius]| Extended::from(PI) * square(&radius));
