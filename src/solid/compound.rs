//! Bodies of several parts: compounds, placed and turned and held rigidly together, and point masses.

use super::properties::combined_about_heaviest;
use super::{MassMoments, MassProperties};
use crate::error::{Error, Refusal, Subject, finite_vector, positive};
use crate::number::Extended;
use alloc::vec::Vec;
use nalgebra::{Matrix3, Vector3};

/// A body made of parts, each put in its place.
///
/// Parts may touch or overlap; where they overlap, the masses add.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::{Ball, Compound, Solid, ThinRod};
///
/// // A dumbbell: a light rod along z and two balls on its ends.
/// let rod = ThinRod::new(6.0)?.with_mass(1.0)?;
/// let ball = Ball::new(0.5)?.with_mass(10.0)?;
/// let dumbbell = Compound::new()
///     .at(rod, &Vector3::zeros())
///     .at(ball, &Vector3::new(0.0, 0.0, 3.0))
///     .at(ball, &Vector3::new(0.0, 0.0, -3.0))
///     .properties()?;
/// assert_eq!(dumbbell.mass(), 21.0);
/// // About x: the rod's 3, and for each ball its own 1 and its 10 * 3^2.
/// assert_eq!(dumbbell.inertia().matrix().diagonal(), Vector3::new(185.0, 185.0, 2.0));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Compound {
    parts: Vec<(MassProperties, Vector3<f64>)>,
}

impl Compound {
    /// A compound without parts, to which [`at`](Self::at) adds them.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a part with its own origin at `position` (m). To rotate a part, call
    /// [`turned`](MassProperties::turned) on it first; it rotates about that origin.
    #[must_use]
    pub fn at(mut self, part: MassProperties, position: &Vector3<f64>) -> Self {
        self.parts.push((part, *position));
        self
    }

    /// The whole's mass, centre and inertia, by the parallel-axis theorem. Distances are taken from the
    /// heaviest part, so that a body far from the origin keeps its digits.
    ///
    /// # Errors
    /// No parts; a position that is not finite, with the part's number; or a result that `f64` does not hold.
    pub fn properties(&self) -> Result<MassProperties, Error> {
        let mut placed = Vec::with_capacity(self.parts.len());
        for (index, (part, position)) in self.parts.iter().enumerate() {
            placed.push(part.moved(position).map_err(|e| e.of_part(index))?);
        }
        let wide: Vec<_> = placed.iter().map(|&part| MassMoments::from(part)).collect();
        combined_about_heaviest(&wide, placed.iter().map(MassProperties::mass), Subject::Parts)?.checked()
    }
}

impl MassProperties {
    /// The mass properties of point masses, from each mass (kg) and position (m). Points on one line form an
    /// ideal rod, which has one zero moment.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use tumbling::MassProperties;
    /// let pair = [(1.0, Vector3::new(0.0, 0.0, 0.0)), (3.0, Vector3::new(4.0, 0.0, 0.0))];
    /// let dumbbell = MassProperties::of_points(&pair)?;
    /// assert_eq!(dumbbell.mass(), 4.0);
    /// assert_eq!(dumbbell.centre(), Vector3::new(3.0, 0.0, 0.0));
    /// assert_eq!(dumbbell.inertia().matrix().diagonal(), Vector3::new(0.0, 12.0, 12.0));
    /// # Ok::<(), tumbling::Error>(())
    /// ```
    ///
    /// # Errors
    /// Fewer than two distinct positions (points in one place have no inertia), a mass that is not finite and
    /// positive or a position that is not finite, or a result that `f64` does not hold.
    pub fn of_points(points: &[(f64, Vector3<f64>)]) -> Result<Self, Error> {
        let mut parts = Vec::with_capacity(points.len());
        for (index, (mass, position)) in points.iter().enumerate() {
            positive(Subject::Mass, *mass)
                .and_then(|_| finite_vector(Subject::Position, position))
                .map_err(|e| e.of_part(index))?;
            let (mass, centre) = (Extended::from(*mass), position.map(Extended::from));
            parts.push(MassMoments { mass, centre, inertia: Matrix3::zeros() });
        }
        let (count, distinct) = (points.len().min(1), points.iter().any(|p| p.1 != points[0].1));
        Refusal::TooFew { what: Subject::DistinctPoints, count, needed: 2 }.when(!distinct)?;
        combined_about_heaviest(&parts, points.iter().map(|p| p.0), Subject::Points)?.checked()
    }
}
