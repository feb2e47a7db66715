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
mod trig;

pub(crate) use carlson::{rd, rf_of_roots};
pub(crate) use complementary::Decay;
pub use complementary::{ComplementarySeries, Parts};
pub(crate) use complete::{quarter_period, quarter_period_from_root};
pub use direct::DirectSeries;
pub(crate) use trig::sin_cos_of_turns;

/// Below this ratio of the quarter periods `K'/K` the complementary nome is the smaller, and its series
/// converges faster.
pub(crate) const NOME_RATIO: f64 = 0.775;

#[cfg(test)]
mod tests;
