//! A full cone.

use super::*;

/// A full cone: its base in the plane z = 0 around the origin, its tip at `z = height`. Its centre of mass
/// is a quarter of the way up.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{Cone, Solid};
/// let cone = Cone::new(1.0, 4.0)?.with_mass(80.0)?;
/// assert_eq!(cone.centre(), Vector3::new(0.0, 0.0, 1.0));
/// assert_eq!(cone.inertia().matrix().diagonal(), Vector3::new(60.0, 60.0, 24.0));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    sizes: [f64; 2],
}

impl Cone {
    /// From the radius of its base and its height, m.
    ///
    /// # Errors
    /// A size that is not finite and positive.
    pub fn new(radius: f64, height: f64) -> Result<Self, Error> {
        Ok(Self { sizes: positive_sizes([(Subject::Radius, radius), (Subject::Height, height)])? })
    }
}

impl Shape<2> for Cone {
    /// The moments of a full cone about its centre of mass: `3/80 m (4r² + h²)` across, `3/10 m r²` along its
    /// axis, z. Source:
    /// [LL76](crate::references), section 32, problem 2e.
    ///
    /// ```
    /// use tumbling::solid::{Cone, Shape};
    /// use nalgebra::Vector3;
    /// let moments = Cone::moments(&80.0, [&1.0, &4.0]);
    /// assert_eq!(moments, Vector3::new(60.0, 60.0, 24.0));
    /// ```
    fn moments<T: Field>(mass: &T, [radius, height]: [&T; 2]) -> Vector3<T> {
        let rr = square(radius);
        let three_m = T::integer(3) * mass.clone();
        let across = three_m.clone() * (T::integer(4) * rr.clone() + square(height)) / T::integer(80);
        Vector3::new(across.clone(), across, three_m * rr / T::integer(10))
    }
}

solid!(Cone, Volume, |[r, h]| Extended::from(PI) * (square(&r) * h) / Extended::from(3.0), |[_, height]| {
    Vector3::new(Extended::zero(), Extended::zero(), height / Extended::from(4.0))
});
