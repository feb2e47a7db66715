//! Point masses held together by nothing that weighs: the oldest picture of a rigid body.

use super::properties::combined_about_heaviest;
use super::{MassMoments, MassProperties};
use crate::error::{Error, Refusal, Subject, finite_vector, positive};
use crate::number::extended::Extended;
use alloc::vec::Vec;
use nalgebra::{Matrix3, Vector3};

impl MassProperties {
    /// Of point masses, from each mass (kg) and position (m). Those on one line make an ideal rod, which has
    /// one zero moment.
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
    /// Fewer than two distinct positions (all in one place, they have no inertia), a mass that is not finite
    /// and positive or a position that is not finite, or a result that `f64` does not hold.
    pub fn of_points(points: &[(f64, Vector3<f64>)]) -> Result<Self, Error> {
        let mut parts = Vec::with_capacity(points.len());
        for (index, (mass, position)) in points.iter().enumerate() {
            positive(Subject::Mass, *mass)
                .and_then(|_| finite_vector(Subject::Position, position))
                .map_err(|e| e.of_part(index))?;
            let (mass, centre) = (Extended::from(*mass), position.map(Extended::from));
            parts.push(MassMoments { mass, centre, inertia: Matrix3::zeros() });
        }
        if !points.iter().any(|p| p.1 != points[0].1) {
            let count = points.len().min(1);
            return Err(Refusal::TooFew { what: Subject::DistinctPoints, count, needed: 2 }.into());
        }
        combined_about_heaviest(&parts, points.iter().map(|p| p.0), Subject::Points)?.checked()
    }
}
