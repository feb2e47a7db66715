//! Elliptic functions on the complementary modulus, as free motion needs them.
//!
//! The modulus of a nearly perfect middle-axis spin rounds to 1 in `f64`; such spins differ from each other
//! in the complement `k' = sqrt(1 - k²)`, which can be 1e-300. So all functions here accept `k'` as an
//! argument and never compute it from `k`. `sn`, `cn` and `dn` come from four-term theta sums
//! ([DLMF](crate::references), chapter 20): in sines and cosines by the nome or, near the separatrix, in
//! hyperbolic functions by the complementary nome.

mod carlson;
mod complementary;
mod complete;
mod direct;

pub(crate) use carlson::{rd, rf_of_roots};
pub(crate) use complementary::Decay;
pub use complementary::{ComplementarySeries, Parts};
pub(crate) use complete::{quarter_period, quarter_period_from_root};
pub use direct::DirectSeries;

use crate::number::{DoubleDouble, Rounding, splat};

/// Below this ratio of the quarter periods `K'/K` the complementary series is taken. On either side the terms
/// that the sums keep reach rounding.
pub(crate) const NOME_RATIO: f64 = 0.775;

/// Sine and cosine of an angle given in turns. This avoids a division by 2 pi, which would lose digits.
///
/// Quarter turns are subtracted first, exactly, so that a phase of 1e9 turns costs the same as a small one
/// and the remainder keeps all its digits.
#[inline(always)]
pub(crate) fn sin_cos_of_turns<T: Rounding>(turns: DoubleDouble<T>) -> (T, T) {
    Angle::of_turns(turns).sin_cos()
}

/// An angle as a whole number of quarter turns (modulo four) and the rest of one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Angle<T> {
    quarters: T,
    rest: T,
}

impl<T: Rounding> Angle<T> {
    #[inline(always)]
    pub(crate) fn of_turns(turns: DoubleDouble<T>) -> Self {
        Self::of_quarters(turns.times_exact(splat(4.0)))
    }

    #[inline(always)]
    pub(crate) fn of_quarters(quarters: DoubleDouble<T>) -> Self {
        let (_, quarters, rest) = quarters.whole_and_rest();
        Self { quarters, rest: rest.hi() }
    }

    #[inline(always)]
    pub(crate) fn sin_cos(self) -> (T, T) {
        let (sin, cos) = self.rest.sin_cos_of_quarter();
        self.quarters.after_quarters(sin, cos)
    }
}

#[cfg(test)]
mod tests;
