//! A capsule: a cylinder capped by two half balls.

use super::*;

/// A capsule with its axis along z, centred at the origin. A cylindrical part of length 0 leaves a ball.
///
/// ```
/// use tumbling::solid::{Capsule, Solid};
/// let pill = Capsule::new(1.0, 4.0)?;
/// assert!((pill.measure()? - 16.0 / 3.0 * std::f64::consts::PI).abs() < 1e-14);
/// assert_eq!(pill.with_mass(4.0)?.inertia().matrix()[(2, 2)], 1.9);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Capsule {
    sizes: [f64; 2],
}

impl Capsule {
    /// From the radius and the length of the cylindrical part, m; the whole is `length + 2 radius` long.
    ///
    /// # Errors
    /// A radius that is not finite and positive, or a length that is not finite or below zero.
    pub fn new(radius: f64, length: f64) -> Result<Self, Error> {
        positive(Subject::Radius, radius)?;
        not_negative(Subject::Length, length)?;
        Ok(Self { sizes: [radius, length] })
    }
}

impl Shape<2> for Capsule {
    /// The moments of a capsule about its centre: a cylinder of length `l` and two half balls, axis along z.
    ///
    /// The volumes are as `3l` to `4r`, which shares out the mass. The cylinder adds `m (3r² + l²)/12` across
    /// and `m r²/2` along. The half balls together add `2/5 m r²` along; across, the parallel-axis theorem
    /// applied to each, whose centre is `3r/8` from its flat side, comes to `m (2/5 r² + 3/8 l r + l²/4)`.
    ///
    /// ```
    /// use tumbling::solid::{Capsule, Shape};
    /// use nalgebra::Vector3;
    /// // l = 4, r = 1: 3 parts cylinder, 1 part caps.
    /// let moments = Capsule::moments(&4.0, [&1.0, &4.0]);
    /// let across = 3.0 * (3.0 + 16.0) / 12.0 + (0.4 + 1.5 + 4.0);
    /// assert_eq!(moments, Vector3::new(across, across, 1.5 + 0.4));
    /// ```
    fn moments<T: Field>(mass: &T, [radius, length]: [&T; 2]) -> Vector3<T> {
        let n = T::integer;
        let (middle, caps) = (n(3) * length.clone(), n(4) * radius.clone());
        let whole = middle.clone() + caps.clone();
        let cylinder = Cylinder::moments(&(mass.clone() * middle / whole.clone()), [radius, length]);
        let caps = mass.clone() * caps / whole;
        let (rr, ll) = (square(radius), square(length));
        let lr = length.clone() * radius.clone();
        let round = n(2) * rr / n(5);
        let across = caps.clone() * (round.clone() + n(3) * lr / n(8) + ll / n(4));
        cylinder + Vector3::new(across.clone(), across, caps * round)
    }
}

solid!(Capsule, Volume, |[r, l]| {
    let stretched = Extended::from(3.0) * l + Extended::from(4.0) * r;
    Extended::from(PI) * (square(&r) * stretched) / Extended::from(3.0)
});
