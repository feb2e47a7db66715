//! What an instant of a free motion takes, by [lanes](Lane): one body is the lane of one.

use crate::number::{Gather, Lane, gather_fields, splat};
use nalgebra::{Quaternion, Vector3};

/// The constants of one kind of motion, those of the spin. What the attitude needs beyond them is kept apart,
/// since spins are also requested alone.
pub(super) trait Kernel<T: Lane> {
    /// The further constants of the attitude.
    type Attitude;
    /// What spin and attitude at one instant have in common.
    type Phase;

    /// At scaled time `time`.
    fn phase(&self, time: T) -> Self::Phase;

    /// The spin along the principal axes, rad/s.
    fn omega(&self, phase: &Self::Phase) -> Vector3<T>;

    /// The turn since the start.
    fn turn(&self, attitude: &Self::Attitude, phase: &Self::Phase, time: T) -> Quaternion<T>;
}

/// Which principal axis is taken first, which differs from body to body: the other two follow in cyclic
/// order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FirstAxis<T = f64> {
    index: T,
}

gather_fields!(FirstAxis { index });

impl<T: Lane> FirstAxis<T> {
    pub(super) fn new(axis: usize) -> Self {
        Self { index: splat([0.0, 1.0, 2.0][axis % 3]) }
    }

    /// Components given from the first axis on, in the order of the body.
    #[inline(always)]
    pub(super) fn arranged(&self, [first, second, third]: [T; 3]) -> [T; 3] {
        let (is_x, is_z) = (self.index.lt(splat::<T>(0.5)), splat::<T>(1.5).lt(self.index));
        if T::WIDTH == 1 {
            // One branch is less than six selections.
            return match (T::any(is_x), T::any(is_z)) {
                (true, _) => [first, second, third],
                (_, true) => [second, third, first],
                _ => [third, first, second],
            };
        }
        let one_of = |if_x, if_y, if_z| T::select(is_x, if_x, T::select(is_z, if_z, if_y));
        [one_of(first, third, second), one_of(second, first, third), one_of(third, second, first)]
    }
}
