//! What can be wanted of many bodies.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::fmt::Debug;
use tumbling::Error;
use tumbling::exact::{Batch, FreeMotion, Instant, Spins};
use tumbling::number::Lane;

/// What is wanted of every body, with what it takes prepared: [`Spins`] or a [`Batch`] of spins with attitudes, in as many lanes
/// as a number type has.
pub trait Want: Debug + Clone + Send + Sync {
    /// What comes out for one body at one instant.
    type Answer: Debug + Copy + PartialEq + Send + Sync;

    /// What stands in the place of an answer where a body was refused: NaN throughout.
    const REFUSED: Self::Answer;

    /// For these motions.
    #[must_use]
    fn of(motions: &[FreeMotion]) -> Self;

    /// Bytes held.
    #[must_use]
    fn bytes(&self) -> usize;

    /// `put` gets the number of the time, that of the body, and what came out.
    ///
    /// # Errors
    /// A time that is not finite.
    fn each(&self, times: &[f64], put: impl FnMut(usize, usize, Self::Answer)) -> Result<(), Error>;
}

const NAN: Vector3<f64> = Vector3::new(f64::NAN, f64::NAN, f64::NAN);

impl<T: Lane + Send + Sync> Want for Batch<T> {
    type Answer = Instant;
    const REFUSED: Instant = Instant {
        omega: NAN,
        attitude: UnitQuaternion::new_unchecked(Quaternion::new(f64::NAN, f64::NAN, f64::NAN, f64::NAN)),
    };

    fn of(motions: &[FreeMotion]) -> Self {
        Self::new(motions)
    }
    fn bytes(&self) -> usize {
        Self::bytes(self)
    }
    #[inline]
    fn each(&self, times: &[f64], put: impl FnMut(usize, usize, Instant)) -> Result<(), Error> {
        Self::each(self, times, put)
    }
}

impl<T: Lane + Send + Sync> Want for Spins<T> {
    type Answer = Vector3<f64>;
    const REFUSED: Vector3<f64> = NAN;

    fn of(motions: &[FreeMotion]) -> Self {
        Self::new(motions)
    }
    fn bytes(&self) -> usize {
        Self::bytes(self)
    }
    #[inline]
    fn each(&self, times: &[f64], put: impl FnMut(usize, usize, Vector3<f64>)) -> Result<(), Error> {
        Self::each(self, times, put)
    }
}
