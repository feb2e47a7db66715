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

use crate::number::double_double::DoubleDouble;
use crate::number::{Lane, splat};

/// Below this ratio of the quarter periods `K'/K` the complementary nome is the smaller, and its series
/// converges faster.
pub(crate) const NOME_RATIO: f64 = 0.775;

/// Sine and cosine of an angle of `turns` whole turns: no division by the circle's constant, in which digits
/// would be lost.
///
/// Whole and quarter turns are taken off first, exactly, so that a phase of 1e9 turns costs what a small one
/// does, and what is left keeps all its digits.
#[inline(always)]
pub(crate) fn sin_cos_of_turns<T: Lane>(turns: DoubleDouble<T>) -> (T, T) {
    let (_, part) = turns.split();
    let [quarters, left] = (part * 4.0).whole_and_left();
    let (sin, cos) = (left * 0.25).sin_cos_of_part();
    // Quarters from -2 to 2: an odd one exchanges the two, and each then has its half of the circle below
    // zero.
    let size = quarters.abs();
    let odd = (size - 1.0).abs().lt(splat::<T>(0.5));
    let (s, c) = (T::select(odd, cos, sin), T::select(odd, sin, cos));
    let opposite = splat::<T>(1.5).lt(size);
    let sin_sign = T::select(quarters.lt(splat::<T>(-0.5)), splat::<T>(-1.0), splat::<T>(1.0));
    let cos_sign = T::select(splat::<T>(0.5).lt(quarters), splat::<T>(-1.0), splat::<T>(1.0));
    let signed = |sign, x| T::select(opposite, splat(-1.0), sign) * x;
    (signed(sin_sign, s), signed(cos_sign, c))
}

#[cfg(test)]
mod tests;
