//! Laws on any kind of number that are public only for proofs: `crates/proofs` runs these same functions on
//! algebraic symbols, and the closed form on intervals. The other laws that it runs are in their own modules.
//! A vector type that answers for several bodies at once implements three traits of this module: [`Lane`]
//! and, with their defaults, [`Series`] and [`Rounding`].

pub use crate::body::rate::Rate;
pub use crate::exact::series::{
    ClosedForm, ComplementaryPair, ComplementarySeries, DirectPair, DirectSeries, Parts,
};
pub use crate::number::lane::{Lane, Series};
pub use crate::number::real::Real;
pub use crate::number::rounding::Rounding;
pub use crate::solid::mesh::{mesh_moments, tetrahedron_moments};
pub use crate::step::position_stage::turn::{change_of_spin, conserving_rate, conserving_turn};
pub use crate::step::system::{altered, rests_of_gauss};

use crate::number::Ring;
use nalgebra::{Matrix3, Vector3};

/// The rate of body-frame momentum, N m: `L' = L x (J L) + torque`, with `J` the inverse tensor in any body
/// axes. It has no division, so it is a polynomial in its arguments. Source: [Arn66](crate::references).
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// let inverse = Matrix3::from_diagonal(&Vector3::new(3, 2, 1));
/// let rate = tumbling::laws::momentum_rate(&inverse, &Vector3::new(0, 1, 1), &Vector3::zeros());
/// assert_eq!(rate, Vector3::new(-1, 0, 0));
/// ```
#[must_use]
pub fn momentum_rate<T: Ring>(
    inverse: &Matrix3<T>,
    momentum: &Vector3<T>,
    torque: &Vector3<T>,
) -> Vector3<T> {
    momentum.cross(&(inverse * momentum)) + torque
}
