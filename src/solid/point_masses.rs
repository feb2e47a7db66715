//! Point masses held together by nothing that weighs: the oldest picture of a rigid body.

use super::properties::combine_about_heaviest;
use super::{MassMoments, MassProperties, combined};
use crate::error::{Error, Refusal, finite_vector, positive};
use crate::number::Field;
use crate::number::extended::Extended;
use alloc::vec::Vec;
use nalgebra::{Matrix3, Vector3};

/// Mass, centre and inertia of point masses at given positions: the definition itself, `sum m (|d|² 1 - d
/// d^T)` about the common centre. The masses must not add up to zero.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// let pair = [(1.0, Vector3::new(0.0, 0.0, 0.0)), (3.0, Vector3::new(4.0, 4.0, 0.0))];
/// let body = tumbling::solid::point_masses_moments(&pair, &Vector3::zeros());
/// assert_eq!(body.centre, Vector3::new(3.0, 3.0, 0.0));
/// assert_eq!(body.inertia, Matrix3::new(12.0, -12.0, 0.0, -12.0, 12.0, 0.0, 0.0, 0.0, 24.0));
/// ```
#[must_use]
pub fn point_masses_moments<T: Field>(points: &[(T, Vector3<T>)], reference: &Vector3<T>) -> MassMoments<T> {
    combined(&as_parts(points), reference)
}

fn as_parts<T: Field>(points: &[(T, Vector3<T>)]) -> Vec<MassMoments<T>> {
    let part = |(mass, position): &(T, Vector3<T>)| MassMoments {
        mass: mass.clone(),
        centre: position.clone(),
        inertia: Matrix3::zeros(),
    };
    points.iter().map(part).collect()
}

/// Point masses at given positions. Those on one line make an ideal rod, which has one zero moment.
///
/// ```
/// use nalgebra::Vector3;
/// use tumbling::solid::PointMasses;
/// let pair = [(1.0, Vector3::new(0.0, 0.0, 0.0)), (3.0, Vector3::new(4.0, 0.0, 0.0))];
/// let dumbbell = PointMasses::new(&pair)?.properties();
/// assert_eq!(dumbbell.mass(), 4.0);
/// assert_eq!(dumbbell.centre(), Vector3::new(3.0, 0.0, 0.0));
/// assert_eq!(dumbbell.inertia().matrix().diagonal(), Vector3::new(0.0, 12.0, 12.0));
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PointMasses {
    points: Vec<(f64, Vector3<f64>)>,
    properties: MassProperties,
}

impl PointMasses {
    /// From masses (kg) and their positions (m).
    ///
    /// # Errors
    /// Fewer than two distinct positions (all in one place, they have no inertia), a mass that is not finite
    /// and positive or a position that is not finite, or a result that `f64` does not hold.
    pub fn new(points: &[(f64, Vector3<f64>)]) -> Result<Self, Error> {
        for (index, (mass, position)) in points.iter().enumerate() {
            positive("the mass", *mass)
                .and_then(|_| finite_vector("the position", position))
                .map_err(|e| e.of_part(index))?;
        }
        if !points.iter().any(|p| p.1 != points[0].1) {
            let count = points.len().min(1);
            return Err(Refusal::TooFew { what: "distinct points", count, needed: 2 }.into());
        }
        let wide: Vec<_> = points.iter().map(|(m, p)| (Extended::from(*m), p.map(Extended::from))).collect();
        let masses = points.iter().map(|p| p.0);
        let properties = combine_about_heaviest(&as_parts(&wide), masses, "points")?.checked()?;
        Ok(Self { points: points.to_vec(), properties })
    }

    /// The masses (kg) and their positions (m), as given.
    #[must_use]
    pub fn points(&self) -> &[(f64, Vector3<f64>)] {
        &self.points
    }

    /// Their mass, centre and inertia.
    #[must_use]
    pub fn properties(&self) -> MassProperties {
        self.properties
    }
}
