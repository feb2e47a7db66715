//! An ideal rod, without thickness.

use super::*;

/// An ideal thin rod along z, centred at the origin. Its moment about its own axis is zero, so that alone it
/// has no [inverse](crate::Inertia::inverse); it may be part of a [`Compound`](super::Compound).
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{Solid, ThinRod};
/// let rod = ThinRod::new(3.0)?.with_mass(4.0)?;
/// assert_eq!(rod.inertia().matrix().diagonal(), Vector3::new(3.0, 3.0, 0.0));
/// assert!(rod.inertia().inverse().is_err());
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThinRod {
    sizes: [f64; 1],
}

impl ThinRod {
    /// From its length, m.
    ///
    /// # Errors
    /// A length that is not finite and positive.
    pub fn new(length: f64) -> Result<Self, Error> {
        Ok(Self { sizes: positive_sizes([(Subject::Length, length)])? })
    }
}

impl Shape<1> for ThinRod {
    /// The moments of a thin rod along z about its centre: `m l²/12` across, nothing along. Source:
    /// [LL76](crate::references), section 32, problem 2a.
    ///
    /// ```
    /// use tumbling::solid::{ThinRod, Shape};
    /// use nalgebra::Vector3;
    /// assert_eq!(ThinRod::moments(&4.0, [&3.0]), Vector3::new(3.0, 3.0, 0.0));
    /// ```
    fn moments<T: Field>(mass: &T, [length]: [&T; 1]) -> Vector3<T> {
        let across = mass.clone() * square(length) / T::integer(12);
        Vector3::new(across.clone(), across, T::zero())
    }
}

impl Solid for ThinRod {
    /// The length, m, so that its density is in kg/m.
    fn measure(&self) -> Result<f64, Error> {
        Ok(self.sizes[0])
    }
    fn with_mass(&self, mass: f64) -> Result<MassProperties, Error> {
        even::<Self, _>(Vector3::zeros(), mass, self.sizes)
    }
}
