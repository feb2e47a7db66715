//! Ideal bodies without thickness: a round disk, a rectangular plate, a rod.

use super::*;

shape! {
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
    ThinDisk

    /// From its radius, m.
    ///
    /// # Errors
    /// A radius that is not finite and positive.
    new(radius: Radius)
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

shape! {
    /// An ideal thin plate in the xy plane, `a` along x and `b` along y, centred at the origin.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::solid::{Solid, ThinPlate};
    /// let plate = ThinPlate::new(2.0, 3.0)?;
    /// assert_eq!(plate.measure()?, 6.0);
    /// let two_per_square_metre = plate.with_density(2.0)?;
    /// assert_eq!(two_per_square_metre.inertia().matrix().diagonal(), Vector3::new(9.0, 4.0, 13.0));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ThinPlate

    /// From its edges along x and y, m.
    ///
    /// # Errors
    /// An edge that is not finite and positive.
    new(a: EdgeX, b: EdgeY)
}

impl Shape<2> for ThinPlate {
    /// The moments of a thin plate in the xy plane about its centre: `m b²/12`, `m a²/12`, and their sum
    /// about z, as for everything flat. A box without thickness: [LL76](crate::references), section 32,
    /// problem 2d.
    ///
    /// ```
    /// use tumbling::solid::{ThinPlate, Shape};
    /// use nalgebra::Vector3;
    /// assert_eq!(ThinPlate::moments(&12.0, [&2.0, &3.0]), Vector3::new(9.0, 4.0, 13.0));
    /// ```
    fn moments<T: Field>(mass: &T, [a, b]: [&T; 2]) -> Vector3<T> {
        let about = |edge: &T| mass.clone() * square(edge) / T::integer(12);
        let (x, y) = (about(b), about(a));
        Vector3::new(x.clone(), y.clone(), x + y)
    }
}

// The area, m², so that its density is in kg/m².
solid!(ThinPlate, Area, |[a, b]| a * b);

shape! {
    /// An ideal thin rod along z, centred at the origin. Its moment about its own axis is zero, so a rod
    /// alone has no [inverse](crate::Inertia::inverse); it may be part of a [`Compound`](super::Compound).
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::solid::{Solid, ThinRod};
    /// let rod = ThinRod::new(3.0)?.with_mass(4.0)?;
    /// assert_eq!(rod.inertia().matrix().diagonal(), Vector3::new(3.0, 3.0, 0.0));
    /// assert!(rod.inertia().inverse().is_err());
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ThinRod

    /// From its length, m.
    ///
    /// # Errors
    /// A length that is not finite and positive.
    new(length: Length)
}

impl Shape<1> for ThinRod {
    /// The moments of a thin rod along z about its centre: `m l²/12` across, zero along. Source:
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

// The length, m, so that its density is in kg/m.
solid!(ThinRod, Length, |[length]| length);
