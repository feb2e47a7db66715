//! Elliptic functions on the complementary modulus, as free motion needs them.
//!
//! The modulus of a nearly perfect middle-axis spin is 1 to the last bit of any `f64`; what tells one such
//! spin from another is the complement `k' = sqrt(1 - k²)`, which can be 1e-300. So everything here is given
//! `k'`, and never forms it. [`Jacobi`] has `sn`, `cn` and `dn` by four-term theta sums ([DLMF](crate::references), chapter 20),
//! in sines and cosines or, near the separatrix, in hyperbolic functions.

mod carlson;
mod complete;
mod hyperbolic;
mod jacobi;
mod trig;
mod trigonometric;

pub use jacobi::Jacobi;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

pub(crate) use carlson::{rd, rf_of_roots};
pub(crate) use complete::{quarter_period, quarter_period_from_root};
pub(crate) use hyperbolic::{Decay, Hyperbolic};
pub(crate) use jacobi::TURNING_RATIO;
pub(crate) use trig::sin_cos_of_turns;
pub(crate) use trigonometric::Trigonometric;

use crate::error::{Error, not_negative};

/// Jacobi's three functions at one argument: `sn² + cn² = 1` and `dn² + k² sn² = 1`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Values {
    /// The sine of the amplitude.
    pub sn: f64,
    /// The cosine of the amplitude.
    pub cn: f64,
    /// The rate of the amplitude.
    pub dn: f64,
}

impl Values {
    fn of([sn, cn, dn]: [f64; 3]) -> Self {
        Self { sn, cn, dn }
    }
}

/// Carlson's `R_F(x, y, z)`, half the integral of `1/sqrt((t+x)(t+y)(t+z))` over positive `t` [Car95](crate::references).
///
/// ```
/// let value = tumbling::exact::elliptic::carlson_rf(1.0, 1.0, 4.0)?;
/// assert!((value - 2_f64.acosh() / 3_f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), tumbling::Error>(())
/// ```
///
/// # Errors
/// A number that is not finite or below zero, or more than one zero.
pub fn carlson_rf(x: f64, y: f64, z: f64) -> Result<f64, Error> {
    for number in [x, y, z] {
        not_negative("an argument of R_F", number)?;
    }
    // Homogeneous of degree -1/2: bring the largest near 1.
    let half = crate::number::power_of_two::exponent(x.max(y).max(z)) / 2;
    let root = |a: f64| crate::number::power_of_two::times_power_of_two(a, -2 * half).sqrt();
    let scaled = rf_of_roots(root(x), root(y), root(z));
    let value = crate::number::power_of_two::times_power_of_two(scaled, -half);
    if value.is_finite() { Ok(value) } else { Err(Error::OutOfRange { what: "R_F", value }) }
}
