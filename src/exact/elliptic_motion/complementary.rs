//! Near the separatrix: the series of the complementary nome, in hyperbolic functions.

use super::axes::Axes;
use super::folded_argument::{Fold, FoldedArgument};
use crate::exact::cayley_klein::{ComplementaryPair, Pair, phase_factor};
use crate::exact::elliptic::ComplementarySeries;
use crate::exact::kernel::Kernel;
use crate::number::double_double::DoubleDouble;
use crate::number::{Gather, Lane, gather_fields};
use nalgebra::{Quaternion, Vector3};

/// The constants of the spin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spin<T = f64> {
    pub(super) series: ComplementarySeries<T>,
    pub(super) fold: Fold<T>,
    pub(super) amplitudes: [T; 3],
    pub(super) axes: Axes<T>,
}

/// The further constants of the attitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Attitude<T = f64> {
    pub(super) pair: ComplementaryPair<T>,
    pub(super) start: Pair<T>,
    /// Turns of the common phase, which is half the angle about the momentum, per unit of time, and what each
    /// half period of Jacobi's argument adds.
    pub(super) drift: DoubleDouble<T>,
    pub(super) step: T,
}

gather_fields!(Spin { series, fold, amplitudes, axes });
gather_fields!(Attitude { pair, start, drift, step });

impl<T: Lane> Kernel<T> for Spin<T> {
    type Attitude = Attitude<T>;
    type Phase = FoldedArgument<T>;

    #[inline(always)]
    fn phase(&self, time: T) -> FoldedArgument<T> {
        self.fold.at(time)
    }

    #[inline(always)]
    fn omega(&self, argument: &FoldedArgument<T>) -> Vector3<T> {
        self.axes.spin(&self.amplitudes, argument.values(&self.series))
    }

    #[inline(always)]
    fn turn(&self, attitude: &Attitude<T>, argument: &FoldedArgument<T>, time: T) -> Quaternion<T> {
        let steps = DoubleDouble::product(argument.halves, attitude.step);
        let turned = argument.pair(&attitude.pair).turned(phase_factor(attitude.drift * time + steps));
        self.axes.turn(turned.since(&attitude.start))
    }
}
