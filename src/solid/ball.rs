//! A ball, full or with a round hole in its middle, down to a thin shell.

use super::*;

/// A ball, centred at the origin.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{Ball, Solid};
/// let ball = Ball::new(3.0)?;
/// assert!((ball.measure()? - 36.0 * std::f64::consts::PI).abs() < 1e-13);
/// assert_eq!(ball.with_mass(10.0)?.inertia().matrix().diagonal(), Vector3::repeat(36.0));
/// let shell = Ball::hollow(1.0, 2.0)?;
/// assert_eq!(shell.with_mass(35.0)?.inertia().matrix().diagonal(), Vector3::repeat(62.0));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// Radii of the hole and of the whole.
    sizes: [f64; 2],
}

impl Ball {
    /// A full one, from its radius, m.
    ///
    /// # Errors
    /// A radius that is not finite and positive.
    pub fn new(radius: f64) -> Result<Self, Error> {
        Ok(Self { sizes: [0.0, positive(Subject::Radius, radius)?] })
    }

    /// From the radii of the hole (0 for none) and of the whole, m. They may be equal: then it is a thin
    /// shell, which has a mass but no volume to give a density to.
    ///
    /// # Errors
    /// A radius that is not finite, an inner one below zero, an outer one not above zero, or an inner one
    /// beyond the outer.
    pub fn hollow(inner: f64, outer: f64) -> Result<Self, Error> {
        ordered(inner, outer)?;
        Ok(Self { sizes: [inner, outer] })
    }
}

impl Shape<1> for Ball {
    /// The moments of a full ball: `2/5 m r²`. Source:
    /// [LL76](crate::references), section 32, problem 2b.
    ///
    /// ```
    /// use tumbling::solid::{Ball, Shape};
    /// assert_eq!(Ball::moments(&10.0, [&3.0]).x, 36.0);
    /// ```
    fn moments<T: Field>(mass: &T, [radius]: [&T; 1]) -> Vector3<T> {
        Vector3::repeat(T::integer(2) * mass.clone() * square(radius) / T::integer(5))
    }
}

impl Shape<2> for Ball {
    /// The moments of a hollow one: `2/5 m (o⁵ - i⁵)/(o³ - i³)`, a ball minus a ball.
    ///
    /// With the factor `o - i` divided out, nothing cancels, and equal radii give the thin shell, `2/3 m r²`.
    ///
    /// ```
    /// use tumbling::solid::{Ball, Shape};
    /// assert_eq!(Ball::moments(&35.0, [&1.0, &2.0]).x, 62.0); // 2/5 * 35 * 31/7
    /// assert_eq!(Ball::moments(&3.0, [&2.0, &2.0]).x, 8.0); // 2/3 * 3 * 2^2
    /// ```
    fn moments<T: Field>(mass: &T, [inner, outer]: [&T; 2]) -> Vector3<T> {
        let (ii, io, oo) = (square(inner), inner.clone() * outer.clone(), square(outer));
        let quartic = square(&oo)
            + oo.clone() * io.clone()
            + oo.clone() * ii.clone()
            + ii.clone() * io.clone()
            + square(&ii);
        Vector3::repeat(T::integer(2) * mass.clone() * quartic / (T::integer(5) * (oo + io + ii)))
    }
}

impl Solid for Ball {
    fn measure(&self) -> Result<f64, Error> {
        let [i, o] = self.sizes.map(Extended::from);
        (four_thirds_pi() * (o - i) * (square(&o) + o * i + square(&i))).in_full(Subject::Volume)
    }

    fn with_mass(&self, mass: f64) -> Result<MassProperties, Error> {
        match self.sizes {
            [0.0, radius] => even::<Self, 1>(Vector3::zeros(), mass, [radius]),
            sizes => even::<Self, 2>(Vector3::zeros(), mass, sizes),
        }
    }
}
