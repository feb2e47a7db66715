//! Numbers that carry their derivatives in six directions.

use crate::number::Analytic;
use crate::number::functions;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{FromPrimitive, One, Zero};

/// A number with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dual {
    pub(crate) value: f64,
    pub(crate) derivatives: [f64; 6],
}

impl From<f64> for Dual {
    fn from(value: f64) -> Self {
        Self { value, derivatives: [0.0; 6] }
    }
}

impl Dual {
    /// A function of it, by the function's value and derivative.
    fn by(&self, value: f64, derivative: f64) -> Self {
        Self { value, derivatives: self.derivatives.map(|x| x * derivative) }
    }
}

/// Operators, each by the value of its result and by one of the derivatives.
macro_rules! operators {
    ($($name:ident, $method:ident, $assign:ident, $method_assign:ident:
        |$a:ident, $b:ident, $i:ident| $value:expr, $derivative:expr;)*) => {$(
        #[allow(clippy::suspicious_arithmetic_impl, reason = "the rules of products and quotients")]
        impl $name for Dual {
            type Output = Self;
            #[inline(always)]
            fn $method(self, $b: Self) -> Self {
                let $a = self;
                Self { value: $value, derivatives: core::array::from_fn(|$i| $derivative) }
            }
        }

        impl $assign for Dual {
            #[inline(always)]
            fn $method_assign(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    )*};
}

operators! {
    Add, add, AddAssign, add_assign: |a, b, i| a.value + b.value, a.derivatives[i] + b.derivatives[i];
    Sub, sub, SubAssign, sub_assign: |a, b, i| a.value - b.value, a.derivatives[i] - b.derivatives[i];
    Mul, mul, MulAssign, mul_assign: |a, b, i| a.value * b.value,
        a.derivatives[i] * b.value + a.value * b.derivatives[i];
    Div, div, DivAssign, div_assign: |a, b, i| a.value / b.value,
        (a.derivatives[i] - a.value / b.value * b.derivatives[i]) / b.value;
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, derivatives: self.derivatives.map(|x| -x) }
    }
}

impl Zero for Dual {
    fn zero() -> Self {
        Self::from(0.0)
    }
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl One for Dual {
    fn one() -> Self {
        Self::from(1.0)
    }
}

impl FromPrimitive for Dual {
    fn from_i64(n: i64) -> Option<Self> {
        f64::from_i64(n).map(Self::from)
    }
    fn from_u64(n: u64) -> Option<Self> {
        f64::from_u64(n).map(Self::from)
    }
    fn from_f64(x: f64) -> Option<Self> {
        Some(Self::from(x))
    }
}

/// Its size is that of the value: an adaptive run measures each column of derivatives by itself.
impl Analytic for Dual {
    fn sqrt(&self) -> Self {
        let root = Analytic::sqrt(&self.value);
        self.by(root, 0.5 / root)
    }
    fn sin_cos(&self) -> (Self, Self) {
        let (sine, cosine) = functions::sin_cos(self.value);
        (self.by(sine, cosine), self.by(cosine, -sine))
    }
    fn exp(&self) -> Self {
        let value = functions::exp(self.value);
        self.by(value, value)
    }
    fn cos_sinc_of_root(&self) -> (Self, Self) {
        let (cosine, sinc) = functions::cos_sinc_of_root(self.value);
        // Of the root's square `s`: the cosine falls by half the sinc, and the sinc by (sinc - cosine) / 2s,
        // of which the first terms are left where it cancels.
        let s = self.value;
        let derivative = if s.abs() < 1e-2 {
            -1.0 / 6.0 + s * (1.0 / 60.0 - s * (1.0 / 1680.0 - s / 90_720.0))
        } else {
            (cosine - sinc) / (2.0 * s)
        };
        (self.by(cosine, -0.5 * sinc), self.by(sinc, derivative))
    }
    fn size(&self) -> f64 {
        self.value.abs()
    }
    fn rounding() -> f64 {
        f64::EPSILON
    }
}
