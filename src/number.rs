//! The operations that a number type needs so that the laws of rotation can run on it.
//!
//! The laws are written once, over [`Ring`] (add, subtract, multiply) wherever they are polynomials and over
//! [`Field`] where they need a division. Every type with this arithmetic implements them: `f64` and `f32`,
//! exact rationals, dual numbers, or a number that counts what a formula costs. Code that branches on a size
//! or takes a root is written for `f64`, or over [`Lane`], several `f64` at once.

mod double_double;
mod extended;
pub(crate) mod functions;
pub(crate) mod lane;
mod power_of_two;
pub(crate) mod quadrature;
pub(crate) mod real;
pub(crate) mod rounding;

pub(crate) use double_double::{DoubleDouble, difference_of_products, exact_products, exact_sum};
pub(crate) use extended::Extended;
pub(crate) use lane::{Gather, INTEGERS, Lane, Series, gather_fields, splat};
pub(crate) use power_of_two::{exponent, times_power_of_two, ulp};
pub(crate) use real::Real;
pub(crate) use rounding::Rounding;

use core::any::Any;
use core::ops::Neg;
use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Scalar};
use num_traits::{Float, One, Zero};

/// A commutative ring: add, subtract, multiply, with 0 and 1. It is implemented for every type that has these
/// operations.
///
/// ```
/// use tumbling::number::Ring;
/// assert_eq!(f64::integer(12), 12.0);
/// assert_eq!(f32::integer(0), 0.0);
/// ```
pub trait Ring:
    Scalar + Zero + One + ClosedAddAssign + ClosedSubAssign + ClosedMulAssign + Neg<Output = Self>
{
    /// The integer `n` in this ring, by doubling and adding 1; exact if the ring contains `n`.
    #[inline]
    fn integer(n: u32) -> Self {
        // The compiler knows which type it is, and keeps one of the two branches.
        if let Some(float) = (&f64::from(n) as &dyn Any).downcast_ref::<Self>() {
            return float.clone();
        }
        let mut sum = Self::zero();
        for bit in (0..u32::BITS - n.leading_zeros()).rev() {
            sum += sum.clone();
            if n >> bit & 1 == 1 {
                sum += Self::one();
            }
        }
        sum
    }
}

impl<T> Ring for T where
    T: Scalar + Zero + One + ClosedAddAssign + ClosedSubAssign + ClosedMulAssign + Neg<Output = T>
{
}

/// A ring with division (by anything but zero). It is implemented for every type that has these operations.
pub trait Field: Ring + ClosedDivAssign {}

impl<T: Ring + ClosedDivAssign> Field for T {}

/// A field with the functions that steppers need besides arithmetic. Implemented for `f64` and `f32`, with
/// the same bits where these follow IEEE 754; other crates may implement it for their own types. Power series
/// implement it: a step that runs on them shows its order.
pub trait Analytic: Field {
    /// The square root; where there is none, the type's value for "undefined".
    fn sqrt(&self) -> Self;

    /// Sine and cosine of an angle in radians.
    fn sin_cos(&self) -> (Self, Self);

    /// The exponential.
    fn exp(&self) -> Self;

    /// `cos(r)` and `sin(r)/r` of the root `r` of this number, both smooth where it is zero. The exponential
    /// map from rotation vectors to quaternions needs them.
    ///
    /// ```
    /// use tumbling::number::Analytic;
    /// let (cosine, sinc) = 4.0_f64.cos_sinc_of_root();
    /// assert!((cosine - 2.0_f64.cos()).abs() < 1e-15 && (sinc - 2.0_f64.sin() / 2.0).abs() < 1e-15);
    /// assert_eq!(0.0_f64.cos_sinc_of_root(), (1.0, 1.0));
    /// ```
    fn cos_sinc_of_root(&self) -> (Self, Self);

    /// Its size, used to decide whether an iteration still changes: the absolute value of a number; for a
    /// power series, any measure that decreases as its lowest power rises, and is 0 only for zero. NaN if
    /// undefined.
    fn size(&self) -> f64;

    /// Changes below this, relative to the size, are rounding: the type's machine epsilon, 0 for exact
    /// numbers.
    fn rounding() -> f64;
}

/// The functions of `f32` are those of `f64`, rounded.
macro_rules! analytic {
    ($($Float:ident),*) => {$(
        impl Analytic for $Float {
            fn sqrt(&self) -> Self {
                Float::sqrt(*self)
            }
            fn sin_cos(&self) -> (Self, Self) {
                let (sine, cosine) = functions::sin_cos(f64::from(*self));
                (sine as Self, cosine as Self)
            }
            fn exp(&self) -> Self {
                functions::exp(f64::from(*self)) as Self
            }
            fn cos_sinc_of_root(&self) -> (Self, Self) {
                let (cosine, sinc) = functions::cos_sinc_of_root(f64::from(*self));
                (cosine as Self, sinc as Self)
            }
            fn size(&self) -> f64 {
                f64::from(self.abs())
            }
            fn rounding() -> f64 {
                f64::from($Float::EPSILON)
            }
        }
    )*};
}
analytic!(f64, f32);
