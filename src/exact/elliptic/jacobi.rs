//! Jacobi's sn, cn and dn for one modulus, prepared once.

use super::hyperbolic::{Decay, Hyperbolic};
use super::trig::sin_cos_of_turns;
use super::trigonometric::Trigonometric;
use super::{Values, complete};
use crate::error::{Error, finite};
use crate::number::double_double::DoubleDouble;
use crate::number::functions::exp;
use core::f64::consts::PI;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Below this ratio of the quarter periods `K'/K` the imaginary transformation converges faster.
pub(crate) const TURNING_RATIO: f64 = 0.775;

/// Jacobi's three functions for one modulus, given by its complement, so that those next to the
/// separatrix, whose modulus is 1 to rounding, are told apart.
///
/// ```
/// use tumbling::exact::elliptic::Jacobi;
/// // On the separatrix: tanh and 1/cosh.
/// let limit = Jacobi::of_complement(0.0)?;
/// let at = limit.at(2.0)?;
/// assert!((at.sn - 2_f64.tanh()).abs() < 1e-15 && (at.cn * 2_f64.cosh() - 1.0).abs() < 1e-15);
/// // With no modulus: sine, cosine and 1.
/// let circle = Jacobi::of_complement(1.0)?;
/// assert!((circle.at(2.0)?.sn - 2_f64.sin()).abs() < 1e-15);
/// assert_eq!(circle.quarter_period(), std::f64::consts::FRAC_PI_2);
/// # Ok::<(), tumbling::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jacobi {
    quarter: DoubleDouble,
    form: Form,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Form {
    Trigonometric(Trigonometric),
    /// With `pi/(2K')` and the root of the complementary nome.
    Hyperbolic(Hyperbolic, f64, f64),
}

impl Jacobi {
    /// For the complementary modulus `k' = sqrt(1 - k²)`, from 0 to 1. Where `k'` is near 1 the modulus is
    /// taken from it as `sqrt((1-k')(1+k'))`.
    ///
    /// # Errors
    /// A value that is not finite, below 0 or above 1.
    pub fn of_complement(complement: f64) -> Result<Self, Error> {
        crate::error::not_negative("the complementary modulus", complement)?;
        if complement > 1.0 {
            return Err(Error::Order {
                smaller: "the complementary modulus",
                small: complement,
                larger: "1",
                large: 1.0,
            });
        }
        let modulus = ((1.0 - complement) * (1.0 + complement)).sqrt();
        let root = DoubleDouble::from(complement).sqrt();
        let quarter = if complement == 0.0 {
            DoubleDouble::from(f64::INFINITY)
        } else {
            complete::quarter_period_from_root(DoubleDouble::from(complement), root)
        };
        let other = complete::quarter_period(modulus);
        let form = if other / quarter.hi() >= TURNING_RATIO {
            Form::Trigonometric(Trigonometric::new(exp(-PI * (other / quarter.hi()))))
        } else {
            let p = exp(-0.5 * PI * (quarter.hi() / other));
            Form::Hyperbolic(Hyperbolic::new(p * p, complement, 0), PI / (2.0 * other), p)
        };
        Ok(Self { quarter, form })
    }

    /// `K`, a quarter of the period of `sn` and `cn` and half that of `dn`. Infinite on the separatrix.
    #[must_use]
    pub fn quarter_period(&self) -> f64 {
        self.quarter.hi()
    }

    /// The three functions at `u`.
    ///
    /// # Errors
    /// A `u` that is not finite.
    pub fn at(&self, u: f64) -> Result<Values, Error> {
        finite("the argument of Jacobi's functions", u)?;
        match &self.form {
            Form::Trigonometric(sums) => {
                let (sin, cos) = sin_cos_of_turns(DoubleDouble::from(u) / (self.quarter * 4.0));
                Ok(sums.at(sin, cos))
            }
            Form::Hyperbolic(sums, stretch, nome_root) => {
                let (halves, left) = (DoubleDouble::from(u) / (self.quarter * 2.0)).split();
                let infinite = self.quarter.hi().is_infinite();
                let v = if infinite { DoubleDouble::from(u) } else { self.quarter * 2.0 * left };
                let size = v.abs();
                let far = size.hi() > 0.5 * self.quarter.hi();
                let size = if far { self.quarter - size } else { size };
                let x = Decay::new(size.hi().max(0.0) * stretch, size.lo() * stretch, *nome_root);
                let values = sums.at(&x, far);
                let turn = if halves % 2.0 == 0.0 { 1.0 } else { -1.0 };
                let side = if v.hi() < 0.0 { -turn } else { turn };
                Ok(Values { sn: side * values.sn, cn: turn * values.cn, dn: values.dn })
            }
        }
    }
}
