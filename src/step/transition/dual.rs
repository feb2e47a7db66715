//! Numbers that carry their derivatives in six directions.

use crate::number::Analytic;
use crate::number::functions;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{FromPrimitive, One, Zero};

/// A number with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dual {
    pub(crate) value: f64,
    pub(crate) slopes: [f64; 6],
}

impl From<f64> for Dual {
    fn from(value: f64) -> Self {
        Self { value, slopes: [0.0; 6] }
    }
}

impl Dual {
    /// A function of it, by the function's value and derivative.
    fn by(&self, value: f64, slope: f64) -> Self {
        Self { value, slopes: self.slopes.map(|x| x * slope) }
    }
}

impl Add for Dual {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let slopes = core::array::from_fn(|i| self.slopes[i] + other.slopes[i]);
        Self { value: self.value + other.value, slopes }
    }
}

impl AddAssign for Dual {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = self.add(other);
    }
}

impl Sub for Dual {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let slopes = core::array::from_fn(|i| self.slopes[i] - other.slopes[i]);
        Self { value: self.value - other.value, slopes }
    }
}

impl SubAssign for Dual {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = self.sub(other);
    }
}

#[allow(clippy::suspicious_arithmetic_impl, reason = "the rules of products and quotients")]
impl Mul for Dual {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.value, other.value);
        let slopes = core::array::from_fn(|i| self.slopes[i] * b + a * other.slopes[i]);
        Self { value: a * b, slopes }
    }
}

impl MulAssign for Dual {
    #[inline(always)]
    fn mul_assign(&mut self, other: Self) {
        *self = self.mul(other);
    }
}

#[allow(clippy::suspicious_arithmetic_impl, reason = "the rules of products and quotients")]
impl Div for Dual {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let slopes = core::array::from_fn(|i| (self.slopes[i] - value * other.slopes[i]) / other.value);
        Self { value, slopes }
    }
}

impl DivAssign for Dual {
    #[inline(always)]
    fn div_assign(&mut self, other: Self) {
        *self = self.div(other);
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, slopes: self.slopes.map(|x| -x) }
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

/// Its size is that of the value: an adaptive run measures each column of slopes by itself.
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
        let slope = if s.abs() < 1e-2 {
            -1.0 / 6.0 + s * (1.0 / 60.0 - s * (1.0 / 1680.0 - s / 90_720.0))
        } else {
            (cosine - sinc) / (2.0 * s)
        };
        (self.by(cosine, -0.5 * sinc), self.by(sinc, slope))
    }
    fn size(&self) -> f64 {
        self.value.abs()
    }
    fn rounding() -> f64 {
        f64::EPSILON
    }
}
