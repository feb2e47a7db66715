//! Spin and attitude at an instant: away from the separatrix by the series of the nome, near it by that of
//! the complementary nome.

use super::range_reduction::{Passage, ReducedArgument, Reduction};
use crate::attitude::unit;
use crate::exact::cayley_klein::{ComplementaryPair, DirectPair, Pair};
use crate::exact::elementary::{Axes, Kernel};
use crate::exact::elliptic::{Angle, ComplementarySeries, DirectSeries};
use crate::number::{DoubleDouble, Gather, Rounding, gather_fields};
use nalgebra::{Quaternion, Vector3};

/// The constants of the spin by the series of the nome, in sines and cosines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DirectSpin<T = f64> {
    pub(super) series: DirectSeries<T>,
    /// Sine and cosine of the phase `pi u/(2K)` at the start, and quarter turns of it per unit of time.
    pub(super) start: [T; 2],
    pub(super) quarters: DoubleDouble<T>,
    pub(super) amplitudes: [T; 3],
    pub(super) axes: Axes<T>,
}

/// The further constants of the attitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DirectAttitude<T = f64> {
    pub(super) pair: DirectPair<T>,
    pub(super) start: Pair<T>,
    /// Quarter turns of the common phase, which is half the angle about the momentum, per unit of time.
    pub(super) drift: DoubleDouble<T>,
}

gather_fields!(DirectSpin { series, start, quarters, amplitudes, axes });
gather_fields!(DirectAttitude { pair, start, drift });

impl<T: Rounding> Kernel<T> for DirectSpin<T> {
    type Attitude = DirectAttitude<T>;
    type Reduced = Angle<T>;
    /// Sine and cosine.
    type Phase = [T; 2];

    #[inline(always)]
    fn reduced(&self, time: T) -> Angle<T> {
        Angle::of_quarters(self.quarters.times_loosely(time))
    }

    #[inline(always)]
    fn phase(&self, angle: &Angle<T>) -> [T; 2] {
        let (sin, cos) = angle.sin_cos();
        let [sin0, cos0] = self.start;
        [sin0 * cos + cos0 * sin, cos0 * cos - sin0 * sin]
    }

    #[inline(always)]
    fn omega(&self, &[sin, cos]: &[T; 2]) -> Vector3<T> {
        self.axes.spin(&self.amplitudes, self.series.values(sin, cos))
    }

    #[inline(always)]
    fn drift(&self, attitude: &DirectAttitude<T>, _: &[T; 2], time: T) -> Angle<T> {
        Angle::of_quarters(attitude.drift.times_loosely(time))
    }

    #[inline(always)]
    fn parts(&self, of: &DirectAttitude<T>, &[sin, cos]: &[T; 2], (s, c): (T, T)) -> [T; 4] {
        of.pair.raw(sin, cos).turned([c, s]).since(&of.start)
    }

    #[inline(always)]
    fn turn_of(&self, parts: [T; 4]) -> Quaternion<T> {
        self.axes.turn(parts)
    }
}

/// The constants of the spin by the series of the complementary nome, in hyperbolic functions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ComplementarySpin<T = f64> {
    pub(super) series: ComplementarySeries<T>,
    pub(super) reduction: Reduction<T>,
    pub(super) amplitudes: [T; 3],
    pub(super) axes: Axes<T>,
}

/// The further constants of the attitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ComplementaryAttitude<T = f64> {
    pub(super) pair: ComplementaryPair<T>,
    pub(super) start: Pair<T>,
    /// Quarter turns of the common phase, which is half the angle about the momentum, per unit of time, and
    /// those that each half period of Jacobi's argument adds.
    pub(super) drift: DoubleDouble<T>,
    pub(super) step: T,
}

gather_fields!(ComplementarySpin { series, reduction, amplitudes, axes });
gather_fields!(ComplementaryAttitude { pair, start, drift, step });

impl<T: Rounding> Kernel<T> for ComplementarySpin<T> {
    type Attitude = ComplementaryAttitude<T>;
    type Reduced = Passage<T>;
    type Phase = ReducedArgument<T>;

    #[inline(always)]
    fn reduced(&self, time: T) -> Passage<T> {
        self.reduction.at(time)
    }

    #[inline(always)]
    fn phase(&self, passage: &Passage<T>) -> ReducedArgument<T> {
        self.reduction.reduced(*passage)
    }

    #[inline(always)]
    fn omega(&self, argument: &ReducedArgument<T>) -> Vector3<T> {
        self.axes.spin(&self.amplitudes, argument.values(&self.series))
    }

    #[inline(always)]
    fn drift(&self, of: &ComplementaryAttitude<T>, at: &ReducedArgument<T>, time: T) -> Angle<T> {
        let steps = at.passage.halves * of.step;
        Angle::of_quarters(of.drift.times_loosely(time).plus(steps))
    }

    #[inline(always)]
    fn parts(&self, of: &ComplementaryAttitude<T>, at: &ReducedArgument<T>, (sin, cos): (T, T)) -> [T; 4] {
        at.pair(&of.pair).turned([cos, sin]).since(&of.start)
    }

    #[inline(always)]
    fn turn_of(&self, parts: [T; 4]) -> Quaternion<T> {
        self.axes.turn(parts)
    }
}

impl<T: Rounding> Axes<T> {
    /// The spin from its amplitudes (across, middle, circled) and Jacobi's functions.
    #[inline(always)]
    pub(super) fn spin(&self, amplitudes: &[T; 3], [sn, cn, dn]: [T; 3]) -> Vector3<T> {
        // (C7)
        self.arranged([amplitudes[0] * cn, amplitudes[1] * sn, amplitudes[2] * dn]).into()
    }

    /// The turn since the start, from its real part and those along the circled axis and the two that `b`
    /// takes for the next: where across, middle and circled are not in cyclic order, the last and the
    /// opposite of the next.
    #[inline(always)]
    pub(super) fn turn(&self, [real, circled, across, middle]: [T; 4]) -> Quaternion<T> {
        let unit = unit(Quaternion::new(real, self.sense * across, middle, circled)).coords;
        let [x, y, z] = self.arranged([unit.x, unit.y, unit.z]);
        Quaternion::new(unit.w, x, y, z)
    }
}
