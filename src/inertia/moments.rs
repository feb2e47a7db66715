//! Three principal moments of one body, checked once.

use super::possible::{DIAGONAL_ROUNDING_ULPS, nearest_possible, physically_possible};
use super::{Axis, Inertia};
use crate::error::{Error, Subject, positive};
use crate::number::ulp;
use core::ops::Index;
use nalgebra::Vector3;

/// Principal moments in kg m², in the order given: finite, positive, and none above the sum of the other two
/// by more than rounding (4 units in the last place of the largest).
///
/// Vectors used with them, such as a spin, are along the same three axes in the same order. For rounded
/// moments, pass a diagonal tensor to [`Inertia::within`], which finds the nearest possible one.
///
/// ```
/// use tumbling::{Axis, PrincipalMoments};
/// let book = PrincipalMoments::new(10.0 / 12.0, 13.0 / 12.0, 5.0 / 12.0)?;
/// assert_eq!(book[book.axis(Axis::Largest)], 13.0 / 12.0);
/// let error = PrincipalMoments::new(1.0, 2.0, 3.5).unwrap_err();
/// assert!(error.to_string().contains("by 0.5"));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalMoments {
    moments: Vector3<f64>,
    /// Indices of the moments, smallest first.
    order: [u8; 3],
}

impl PrincipalMoments {
    /// The moments about the first, second and third principal axis.
    ///
    /// # Errors
    /// A moment that is not finite and positive, or a largest above the sum of the others by more than
    /// rounding.
    pub fn new(first: f64, second: f64, third: f64) -> Result<Self, Error> {
        let moments = Self::ordered(Vector3::new(first, second, third))?;
        moments.possible()?;
        Ok(moments)
    }

    fn possible(&self) -> Result<(), Error> {
        let sorted = self.sorted();
        physically_possible(&sorted, DIAGONAL_ROUNDING_ULPS * ulp(sorted[2]))
    }

    /// The moments of a tensor that was checked against its own rounding: only a zero moment is refused. For
    /// a flat body, the rounding of a rotation may leave moments that [`new`](Self::new) refuses; they are
    /// replaced by the nearest that it accepts.
    pub(crate) fn of_tensor(moments: Vector3<f64>) -> Result<Self, Error> {
        let found = Self::ordered(moments)?;
        if found.possible().is_ok() { Ok(found) } else { Self::ordered(nearest_possible(&moments)) }
    }

    fn ordered(moments: Vector3<f64>) -> Result<Self, Error> {
        moments.iter().try_for_each(|&moment| positive(Subject::PrincipalMoment, moment).map(drop))?;
        Ok(Self { moments, order: ascending(&moments).map(|i| i as u8) })
    }

    /// In the order given, kg m².
    #[must_use]
    pub fn vector(&self) -> Vector3<f64> {
        self.moments
    }

    /// The smallest, kg m².
    pub(crate) fn smallest(&self) -> f64 {
        self[self.axis(Axis::Smallest)]
    }

    /// The largest, kg m².
    pub(crate) fn largest(&self) -> f64 {
        self[self.axis(Axis::Largest)]
    }

    /// Index (0, 1 or 2) of the axis with the smallest, middle or largest moment. Of two equal moments, the
    /// one given first counts as the smaller.
    #[must_use]
    pub fn axis(&self, axis: Axis) -> usize {
        usize::from(self.order[axis.index()])
    }

    /// Indices of the axes, smallest moment first.
    pub(crate) fn order(&self) -> [usize; 3] {
        self.order.map(usize::from)
    }

    /// The moments, smallest first.
    pub(crate) fn sorted(&self) -> Vector3<f64> {
        self.order().map(|i| self.moments[i]).into()
    }

    /// Index of an axis whose other two moments are equal; 0 for a sphere.
    pub(crate) fn axis_of_symmetry(&self) -> Option<usize> {
        (0..3).find(|&axis| self.moments[(axis + 1) % 3] == self.moments[(axis + 2) % 3])
    }
}

/// Indices of the components, smallest first; equal components keep their order.
pub(crate) fn ascending(v: &Vector3<f64>) -> [usize; 3] {
    let mut order = [0, 1, 2];
    for (i, j) in [(0, 1), (1, 2), (0, 1)] {
        if v[order[j]].total_cmp(&v[order[i]]).is_lt() {
            order.swap(i, j);
        }
    }
    order
}

impl Index<usize> for PrincipalMoments {
    type Output = f64;

    fn index(&self, index: usize) -> &f64 {
        &self.moments[index]
    }
}

impl TryFrom<[f64; 3]> for PrincipalMoments {
    type Error = Error;

    fn try_from([first, second, third]: [f64; 3]) -> Result<Self, Error> {
        Self::new(first, second, third)
    }
}

impl TryFrom<Vector3<f64>> for PrincipalMoments {
    type Error = Error;

    fn try_from(moments: Vector3<f64>) -> Result<Self, Error> {
        Self::new(moments.x, moments.y, moments.z)
    }
}

impl From<PrincipalMoments> for [f64; 3] {
    fn from(moments: PrincipalMoments) -> Self {
        moments.moments.into()
    }
}

/// The diagonal tensor along the principal axes.
impl From<PrincipalMoments> for Inertia {
    fn from(moments: PrincipalMoments) -> Self {
        Self { tensor: nalgebra::Matrix3::from_diagonal(&moments.moments) }
    }
}
