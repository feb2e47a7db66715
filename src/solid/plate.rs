//! An ideal rectangular plate, without thickness.

use super::*;

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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThinPlate {
    sizes: [f64; 2],
}

impl ThinPlate {
    /// From its edges along x and y, m.
    ///
    /// # Errors
    /// An edge that is not finite and positive.
    pub fn new(a: f64, b: f64) -> Result<Self, Error> {
        Ok(Self { sizes: positive_sizes([(Subject::EdgeX, a), (Subject::EdgeY, b)])? })
    }
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
