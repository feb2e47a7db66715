//! Round bodies: balls and cylinders, full or with a hole, a cone, a capsule.

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
    /// A full ball, from its radius, m.
    ///
    /// # Errors
    /// A radius that is not finite and positive.
    pub fn new(radius: f64) -> Result<Self, Error> {
        Ok(Self { sizes: [0.0, positive(Subject::Radius, radius)?] })
    }

    /// From the inner radius (0 for a full ball) and the outer radius, m. Equal radii give a thin shell: it
    /// has no volume, so its mass cannot be given by a density.
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
    /// A full cylinder, from radius and height, m.
    ///
    /// # Errors
    /// A size that is not finite and positive.
    pub fn new(radius: f64, height: f64) -> Result<Self, Error> {
        positive(Subject::Radius, radius)?;
        Self::hollow(0.0, radius, height)
    }

    /// A tube, from the inner radius (0 for a full cylinder), the outer radius and the height, m. Equal radii
    /// give a thin tube: it has no volume, so its mass cannot be given by a density.
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

shape! {
    /// A full cone: its base in the plane z = 0 around the origin, its tip at `z = height`. Its centre of
    /// mass is a quarter of the way up.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::solid::{Cone, Solid};
    /// let cone = Cone::new(1.0, 4.0)?.with_mass(80.0)?;
    /// assert_eq!(cone.centre(), Vector3::new(0.0, 0.0, 1.0));
    /// assert_eq!(cone.inertia().matrix().diagonal(), Vector3::new(60.0, 60.0, 24.0));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    Cone

    /// From the radius of its base and its height, m.
    ///
    /// # Errors
    /// A size that is not finite and positive.
    new(radius: Radius, height: Height)
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

/// A capsule with its axis along z, centred at the origin. With a cylindrical part of length 0 it is a ball.
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
