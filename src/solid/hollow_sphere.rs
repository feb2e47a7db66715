//! A ball with a round hole in its middle, down to a thin shell.

use super::{MassProperties, Solid, centred, square};
use crate::error::{Error, Refusal, not_negative, positive};
use crate::number::Field;
use crate::number::extended::Extended;
use core::f64::consts::PI;
use nalgebra::Vector3;

/// The moment of a hollow sphere: `2/5 m (o⁵ - i⁵)/(o³ - i³)`, a ball minus a ball.
///
/// With the factor `o - i` divided out, nothing cancels, and equal radii give the thin shell, `2/3 m r²`.
///
/// ```
/// use tumbling::solid::hollow_sphere_moment;
/// assert_eq!(hollow_sphere_moment(&35.0, &1.0, &2.0), 62.0); // 2/5 * 35 * 31/7
/// assert_eq!(hollow_sphere_moment(&3.0, &2.0, &2.0), 8.0); // 2/3 * 3 * 2^2
/// ```
#[must_use]
pub fn hollow_sphere_moment<T: Field>(mass: &T, inner: &T, outer: &T) -> T {
    let (ii, io, oo) = (square(inner), inner.clone() * outer.clone(), square(outer));
    let quartic = square(&oo)
        + oo.clone() * io.clone()
        + oo.clone() * ii.clone()
        + ii.clone() * io.clone()
        + square(&ii);
    T::integer(2) * mass.clone() * quartic / (T::integer(5) * (oo + io + ii))
}

/// A hollow sphere, centred at the origin. Its radii may be equal: then it is a thin shell, which has a
/// mass but no volume to give a density to.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{HollowSphere, Solid};
/// let shell = HollowSphere::new(1.0, 2.0)?;
/// let moments = shell.with_mass(35.0)?.inertia().matrix().diagonal();
/// assert_eq!(moments, Vector3::repeat(62.0));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HollowSphere {
    inner: f64,
    outer: f64,
}

impl HollowSphere {
    /// From the radii of the hole (0 for none) and of the whole, m.
    ///
    /// # Errors
    /// A radius that is not finite, an inner one below zero, an outer one not above zero, or an inner one
    /// beyond the outer.
    pub fn new(inner: f64, outer: f64) -> Result<Self, Error> {
        not_negative("the inner radius", inner)?;
        positive("the outer radius", outer)?;
        ordered(inner, outer)?;
        Ok(Self { inner, outer })
    }
}

impl Solid for HollowSphere {
    fn measure(&self) -> Result<f64, Error> {
        let (i, o) = (Extended::from(self.inner), Extended::from(self.outer));
        let four_thirds_pi = Extended::from(4.0) * Extended::from(PI) / Extended::from(3.0);
        (four_thirds_pi * (o - i) * (square(&o) + o * i + square(&i))).in_full("the volume")
    }

    fn with_mass(&self, mass: f64) -> Result<MassProperties, Error> {
        let (i, o) = (Extended::from(self.inner), Extended::from(self.outer));
        centred(mass, |m| Vector3::repeat(hollow_sphere_moment(m, &i, &o)))
    }
}

/// That a hole's radius is no larger than that of the whole.
pub(super) fn ordered(inner: f64, outer: f64) -> Result<(), Error> {
    if inner <= outer {
        return Ok(());
    }
    let (smaller, larger) = ("the inner radius", "the outer radius");
    Err(Refusal::Order { smaller, small: inner, larger, large: outer }.into())
}
