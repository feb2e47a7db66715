//! What answers many bodies at once.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::fmt::Debug;
use tumbling::Error;
use tumbling::exact::{Batch, FreeMotion, Instant};
use tumbling::number::Lane;

/// Motions prepared to be answered side by side: a [`Batch`] of spins alone or with attitudes, in the lanes
/// of a number type.
pub trait Solver: Debug + Clone + Send + Sync {
    /// The answer for one body at one instant.
    type Answer: Debug + Copy + PartialEq + Send + Sync;

    /// The answer for a body that was refused: NaN throughout.
    const REFUSED: Self::Answer;

    /// For these motions.
    #[must_use]
    fn of(motions: &[FreeMotion]) -> Self;

    /// `put` gets the number of the time, that of the body, and the answer.
    ///
    /// # Errors
    /// A time that is not finite.
    fn each(&self, times: &[f64], put: impl FnMut(usize, usize, Self::Answer)) -> Result<(), Error>;
}

const NAN: Vector3<f64> = Vector3::new(f64::NAN, f64::NAN, f64::NAN);

impl<T: Lane + Send + Sync> Solver for Batch<T> {
    type Answer = Instant;
    const REFUSED: Instant = Instant {
        omega: NAN,
        attitude: UnitQuaternion::new_unchecked(Quaternion::new(f64::NAN, f64::NAN, f64::NAN, f64::NAN)),
    };

    fn of(motions: &[FreeMotion]) -> Self {
        Self::new(motions)
    }
    #[inline]
    fn each(&self, times: &[f64], put: impl FnMut(usize, usize, Instant)) -> Result<(), Error> {
        Self::each(self, times, put)
    }
}

impl<T: Lane + Send + Sync> Solver for Batch<T, Vector3<f64>> {
    type Answer = Vector3<f64>;
    const REFUSED: Vector3<f64> = NAN;

    fn of(motions: &[FreeMotion]) -> Self {
        Self::new(motions)
    }
    #[inline]
    fn each(&self, times: &[f64], put: impl FnMut(usize, usize, Vector3<f64>)) -> Result<(), Error> {
        Self::each(self, times, put)
    }
}
