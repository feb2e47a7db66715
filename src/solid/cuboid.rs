//! Bodies of three sizes: a box, an ellipsoid.

use super::*;

shape! {
    /// A box with edges `a` along x, `b` along y and `c` along z, centred at the origin.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::solid::{Cuboid, Solid};
    /// let brick = Cuboid::new(2.0, 1.0, 3.0)?;
    /// assert_eq!(brick.measure()?, 6.0);
    /// let moments = brick.with_density(2.0)?.inertia().matrix().diagonal();
    /// assert_eq!(moments, Vector3::new(10.0, 13.0, 5.0));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    Cuboid

    /// From the three edges, m.
    ///
    /// # Errors
    /// An edge that is not finite and positive.
    new(a: EdgeX, b: EdgeY, c: EdgeZ)
}

impl Shape<3> for Cuboid {
    /// The moments of a box about its centre: `m/12 (b² + c²)` and cyclically. Source:
    /// [LL76](crate::references), section 32, problem 2d.
    ///
    /// ```
    /// use tumbling::solid::{Cuboid, Shape};
    /// use nalgebra::Vector3;
    /// let moments = Cuboid::moments(&12.0, [&2.0, &1.0, &3.0]);
    /// assert_eq!(moments, Vector3::new(10.0, 13.0, 5.0));
    /// ```
    fn moments<T: Field>(mass: &T, sizes: [&T; 3]) -> Vector3<T> {
        across(sizes) * (mass.clone() / T::integer(12))
    }
}

solid!(Cuboid, Volume, |[a, b, c]| a * b * c);

shape! {
    /// A full ellipsoid with semi-axes `a` along x, `b` along y and `c` along z, centred at the origin.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::solid::{Ellipsoid, Solid};
    /// let egg = Ellipsoid::new(2.0, 1.0, 3.0)?;
    /// assert_eq!(egg.measure()?, 8.0 * std::f64::consts::PI);
    /// assert_eq!(egg.with_mass(5.0)?.inertia().matrix().diagonal(), Vector3::new(10.0, 13.0, 5.0));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    Ellipsoid

    /// From the three semi-axes, m.
    ///
    /// # Errors
    /// A semi-axis that is not finite and positive.
    new(a: SemiAxisX, b: SemiAxisY, c: SemiAxisZ)
}

impl Shape<3> for Ellipsoid {
    /// The moments of a full ellipsoid about its centre: `m/5 (b² + c²)` and cyclically. Source:
    /// [LL76](crate::references), section 32, problem 2f.
    ///
    /// ```
    /// use tumbling::solid::{Ellipsoid, Shape};
    /// use nalgebra::Vector3;
    /// let moments = Ellipsoid::moments(&5.0, [&2.0, &1.0, &3.0]);
    /// assert_eq!(moments, Vector3::new(10.0, 13.0, 5.0));
    /// ```
    fn moments<T: Field>(mass: &T, sizes: [&T; 3]) -> Vector3<T> {
        across(sizes) * (mass.clone() / T::integer(5))
    }
}

solid!(Ellipsoid, Volume, |[a, b, c]| four_thirds_pi() * (a * b * c));
