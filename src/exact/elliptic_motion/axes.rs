//! Which principal axis is which, that differs from body to body.

use crate::attitude::unit;
use crate::exact::kernel::FirstAxis;
use crate::number::{Gather, Lane, gather_fields, splat};
use nalgebra::{Quaternion, Vector3};

/// The places of the circled axis, the middle one and the one across.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axes<T = f64> {
    circled: FirstAxis<T>,
    /// Above zero where across, middle and circled follow each other in cyclic order.
    sense: T,
}

gather_fields!(Axes { circled, sense });

impl<T: Lane> Axes<T> {
    /// Of the indices across, middle, circled.
    pub(super) fn new([across, middle, circled]: [usize; 3]) -> Self {
        let cyclic = (across + 1) % 3 == middle;
        Self { circled: FirstAxis::new(circled), sense: splat(if cyclic { 1.0 } else { -1.0 }) }
    }

    /// The spin from its amplitudes (across, middle, circled) and Jacobi's functions.
    #[inline(always)]
    pub(super) fn spin(&self, amplitudes: &[T; 3], [sn, cn, dn]: [T; 3]) -> Vector3<T> {
        // (C7)
        let (across, middle) = (amplitudes[0] * cn, amplitudes[1] * sn);
        let cyclic = splat::<T>(0.0).lt(self.sense);
        let (next, last) = (T::select(cyclic, across, middle), T::select(cyclic, middle, across));
        self.circled.arranged([amplitudes[2] * dn, next, last]).into()
    }

    /// The turn since the start, from its real part and those along the circled axis and the next two.
    #[inline(always)]
    pub(super) fn turn(&self, [real, i, j, k]: [T; 4]) -> Quaternion<T> {
        let [x, y, z] = self.circled.arranged([i, j, k]);
        unit(Quaternion::new(real, x, y, z))
    }
}
