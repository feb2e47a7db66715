//! The properties of a solid that the rest of the library uses: mass, centre, inertia about the centre.

use crate::error::{Error, Refusal, Subject, finite_vector, positive, representable};
use crate::inertia::{Inertia, point_mass, turned};
use crate::number::{Extended, Field, Ring};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};

/// Mass, centre and inertia tensor about the centre, over any number type: the unchecked input and output of
/// the generic laws. [`MassProperties`] is the checked form over `f64`.
#[derive(Debug, Clone, PartialEq)]
pub struct MassMoments<T: Ring> {
    /// Mass, kg.
    pub mass: T,
    /// Centre of mass, m.
    pub centre: Vector3<T>,
    /// Inertia tensor about the centre of mass, kg m².
    pub inertia: Matrix3<T>,
}

/// Several parts as one body, by the parallel-axis theorem: each part adds its own tensor and that of a
/// point with its mass at its distance from the common centre.
///
/// Positions are relative to `reference`, so that parts near each other but far from the origin lose no
/// digits; in exact arithmetic the choice of `reference` does not matter. The masses must not add up to zero.
/// Source: [LL76](crate::references), section 32.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use tumbling::solid::{MassMoments, combined};
///
/// let point = |mass, x| MassMoments { mass, centre: Vector3::new(x, 0.0, 0.0), inertia: Matrix3::zeros() };
/// let pair = combined(&[point(1.0, 0.0), point(3.0, 4.0)], &Vector3::zeros());
/// assert_eq!(pair.centre.x, 3.0);
/// assert_eq!(pair.inertia.diagonal(), Vector3::new(0.0, 12.0, 12.0)); // 1 * 3^2 + 3 * 1^2
/// ```
#[must_use]
pub fn combined<T: Field>(parts: &[MassMoments<T>], reference: &Vector3<T>) -> MassMoments<T> {
    let mut mass = T::zero();
    let mut first = Vector3::zeros();
    for part in parts {
        mass += part.mass.clone();
        first += (&part.centre - reference) * part.mass.clone();
    }
    let middle = first.map(|x| x / mass.clone());
    let mut inertia = Matrix3::zeros();
    for part in parts {
        let offset = &part.centre - reference - &middle;
        inertia += &part.inertia + point_mass(&part.mass, &offset);
    }
    MassMoments { mass, centre: reference + middle, inertia }
}

impl MassMoments<Extended> {
    /// As `f64`, if that can hold it.
    pub(crate) fn checked(&self) -> Result<MassProperties, Error> {
        let mass = self.mass.in_full(Subject::Mass)?;
        let mut centre = Vector3::zeros();
        let mut tensor = Matrix3::zeros();
        for i in 0..3 {
            centre[i] = self.centre[i].finite(Subject::CentreOfMass)?;
            tensor[(i, i)] = self.inertia[(i, i)].in_full(Subject::Moment)?;
        }
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            // A product of inertia may be of any size below the moments.
            let product = self.inertia[(i, j)].finite(Subject::Product)?;
            (tensor[(i, j)], tensor[(j, i)]) = (product, product);
        }
        Ok(MassProperties { mass, centre, inertia: Inertia::of_masses(tensor)? })
    }
}

impl From<MassProperties> for MassMoments<f64> {
    fn from(p: MassProperties) -> Self {
        Self { mass: p.mass, centre: p.centre, inertia: p.inertia.matrix() }
    }
}

impl From<MassProperties> for MassMoments<Extended> {
    fn from(p: MassProperties) -> Self {
        let (centre, tensor) = (p.centre.map(Extended::from), p.inertia.matrix());
        Self { mass: p.mass.into(), centre, inertia: tensor.map(Extended::from) }
    }
}

/// A body's mass, centre of mass, and inertia tensor about that centre, in the axes of the solid.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{Compound, Cuboid, Solid};
///
/// // Two bricks of 1 x 2 x 3, side by side along x, are one of 2 x 2 x 3.
/// let brick = Cuboid::new(1.0, 2.0, 3.0)?.with_density(2.0)?;
/// let pair = Compound::new().at(brick, &Vector3::zeros()).at(brick, &Vector3::x()).properties()?;
/// let whole = Cuboid::new(2.0, 2.0, 3.0)?.with_density(2.0)?;
/// assert_eq!(pair.mass(), 24.0);
/// assert_eq!(pair.centre(), Vector3::new(0.5, 0.0, 0.0));
/// assert_eq!(pair.inertia(), whole.inertia());
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassProperties {
    mass: f64,
    centre: Vector3<f64>,
    inertia: Inertia,
}

impl MassProperties {
    /// From a mass (kg), a centre of mass (m) and the inertia tensor about that centre.
    ///
    /// # Errors
    /// A mass that is not finite and positive, or a centre that is not finite.
    pub fn new(mass: f64, centre: &Vector3<f64>, inertia: Inertia) -> Result<Self, Error> {
        positive(Subject::Mass, mass)?;
        finite_vector(Subject::CentreOfMass, centre)?;
        Ok(Self { mass, centre: *centre, inertia })
    }

    /// The mass, kg.
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// The centre of mass, m, from the origin of the solid's axes.
    #[must_use]
    pub fn centre(&self) -> Vector3<f64> {
        self.centre
    }

    /// The inertia tensor about the centre of mass, in the solid's axes.
    #[must_use]
    pub fn inertia(&self) -> Inertia {
        self.inertia
    }

    /// This body moved by `offset` (m).
    pub(super) fn moved(&self, offset: &Vector3<f64>) -> Result<Self, Error> {
        finite_vector(Subject::Offset, offset)?;
        let centre = self.centre + offset;
        representable(Subject::CentreOfMass, centre.as_slice())?;
        Ok(Self { centre, ..*self })
    }

    /// This body rotated about the origin: its centre rotates, and its tensor becomes `R I R^T`.
    ///
    /// # Errors
    /// An attitude that is not finite or not of length 1, or a result that `f64` does not hold.
    ///
    /// ```
    /// use nalgebra::{UnitQuaternion, Vector3};
    /// use tumbling::solid::{Cone, Solid};
    ///
    /// // A cone that stood on the xy plane now points along x.
    /// let quarter = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), std::f64::consts::FRAC_PI_2);
    /// let lying = Cone::new(1.0, 4.0)?.with_mass(1.0)?.turned(quarter)?;
    /// assert!((lying.centre() - Vector3::new(1.0, 0.0, 0.0)).norm() < 1e-15);
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    pub fn turned(&self, attitude: UnitQuaternion<f64>) -> Result<Self, Error> {
        let rotation = crate::attitude::matrix(attitude)?.map(Extended::from);
        let wide = MassMoments::<Extended>::from(*self);
        let m = turned(&rotation, &wide.inertia);
        // Mirrored entries differ by rounding: keep their mean.
        let inertia = (m + m.transpose()).map(|x| x / Extended::from(2.0));
        MassMoments { mass: wide.mass, centre: rotation * wide.centre, inertia }.checked()
    }

    /// The inertia tensor about `point` (m, in the solid's axes), by the parallel-axis theorem.
    ///
    /// # Errors
    /// A point that is not finite, or a moment that `f64` does not hold.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::solid::{Solid, ThinRod};
    ///
    /// // A rod about its end: m l^2 / 3.
    /// let rod = ThinRod::new(3.0)?.with_mass(2.0)?;
    /// let about_end = rod.about(&Vector3::new(0.0, 0.0, 1.5))?;
    /// assert_eq!(about_end.matrix().diagonal(), Vector3::new(6.0, 6.0, 0.0));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    pub fn about(&self, point: &Vector3<f64>) -> Result<Inertia, Error> {
        finite_vector(Subject::Point, point)?;
        let mut wide = MassMoments::<Extended>::from(*self);
        let offset = point.map(Extended::from) - wide.centre;
        wide.inertia += point_mass(&wide.mass, &offset);
        Ok(wide.checked()?.inertia)
    }
}

/// [`combined`] about the centre of the part that weighs most.
pub(crate) fn combined_about_heaviest(
    parts: &[MassMoments<Extended>],
    masses: impl Iterator<Item = f64>,
    what: Subject,
) -> Result<MassMoments<Extended>, Error> {
    let heaviest = parts.iter().zip(masses).max_by(|a, b| a.1.total_cmp(&b.1));
    let Some((part, _)) = heaviest else {
        return Err(Refusal::TooFew { what, count: 0, needed: 1 }.into());
    };
    Ok(combined(parts, &part.centre))
}
