//! Away from the separatrix: the series of the nome, in sines and cosines.

use super::axes::Axes;
use crate::exact::cayley_klein::{DirectPair, Pair, phase_factor};
use crate::exact::elliptic::{DirectSeries, sin_cos_of_turns};
use crate::exact::kernel::Kernel;
use crate::number::double_double::DoubleDouble;
use crate::number::{Gather, Lane, gather_fields};
use nalgebra::{Quaternion, Vector3};

/// The constants of the spin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spin<T = f64> {
    pub(super) series: DirectSeries<T>,
    /// Sine and cosine of the phase `pi u/(2K)` at the start, and turns of it per unit of time.
    pub(super) start: [T; 2],
    pub(super) turns: DoubleDouble<T>,
    pub(super) amplitudes: [T; 3],
    pub(super) axes: Axes<T>,
}

/// The further constants of the attitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Attitude<T = f64> {
    pub(super) pair: DirectPair<T>,
    pub(super) start: Pair<T>,
    /// Turns of the common phase, which is half the angle about the momentum, per unit of time.
    pub(super) drift: DoubleDouble<T>,
}

gather_fields!(Spin { series, start, turns, amplitudes, axes });
gather_fields!(Attitude { pair, start, drift });

impl<T: Lane> Kernel<T> for Spin<T> {
    type Attitude = Attitude<T>;
    /// Sine and cosine.
    type Phase = [T; 2];

    #[inline(always)]
    fn phase(&self, time: T) -> [T; 2] {
        let (sin, cos) = sin_cos_of_turns(self.turns * time);
        let [sin0, cos0] = self.start;
        [sin0 * cos + cos0 * sin, cos0 * cos - sin0 * sin]
    }

    #[inline(always)]
    fn omega(&self, &[sin, cos]: &[T; 2]) -> Vector3<T> {
        self.axes.spin(&self.amplitudes, self.series.values(sin, cos))
    }

    #[inline(always)]
    fn turn(&self, attitude: &Attitude<T>, &[sin, cos]: &[T; 2], time: T) -> Quaternion<T> {
        let turned = attitude.pair.raw(sin, cos).turned(phase_factor(attitude.drift * time));
        self.axes.turn(turned.since(&attitude.start))
    }
}
