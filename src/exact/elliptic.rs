//! Elliptic functions on the complementary modulus, as free motion needs them.
//!
//! The modulus of a nearly perfect middle-axis spin is 1 to the last bit of any `f64`; what distinguishes one
//! such spin from another is the complement `k' = sqrt(1 - k²)`, which can be 1e-300. So everything here is
//! given `k'`, and never forms it. `sn`, `cn` and `dn` come from four-term theta sums
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

/// Below this ratio of the quarter periods `K'/K` the complementary nome is the smaller, and its series
/// converges faster.
pub(crate) const NOME_RATIO: f64 = 0.775;

/// Sine and cosine of an angle of `turns` whole turns: no division by the circle's constant, in which digits
/// would be lost.
///
/// Quarter turns are taken off first, exactly, so that a phase of 1e9 turns costs what a small one does, and
/// what is left keeps all its digits.
#[inline(always)]
pub(crate) fn sin_cos_of_turns<T: Rounding>(turns: DoubleDouble<T>) -> (T, T) {
    let (_, quarters, left) = turns.times_exact(splat(4.0)).whole_and_rest();
    let (sin, cos) = left.hi().sin_cos_of_quarter();
    quarters.after_quarters(sin, cos)
}

#[cfg(test)]
mod tests;
