//! Several numbers side by side, in arrays that the compiler turns into vector instructions.
//!
//! Each operation is a loop over an array that contains only operations that round as on `f64`.

use num_traits::{One, Zero};
use std::array::from_fn;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use tumbling::laws::{Lane, Series};

/// `N` numbers side by side. `FUSED` where the machine has an instruction for the fused product sum: without
/// one it is a function of the C library, and Dekker's product is faster. The answers are the same.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub struct Lanes<const N: usize, const FUSED: bool>([f64; N]);

macro_rules! arithmetic {
    ($Op:ident, $op:ident, $Assign:ident, $assign:ident) => {
        impl<const N: usize, const FUSED: bool> $Op for Lanes<N, FUSED> {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: Self) -> Self {
                Self(from_fn(|k| self.0[k].$op(other.0[k])))
            }
        }
        impl<const N: usize, const FUSED: bool> $Op<f64> for Lanes<N, FUSED> {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: f64) -> Self {
                Self(self.0.map(|x| x.$op(other)))
            }
        }
        impl<const N: usize, const FUSED: bool> $Assign for Lanes<N, FUSED> {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                *self = self.$op(other);
            }
        }
    };
}
arithmetic!(Add, add, AddAssign, add_assign);
arithmetic!(Sub, sub, SubAssign, sub_assign);
arithmetic!(Mul, mul, MulAssign, mul_assign);
arithmetic!(Div, div, DivAssign, div_assign);

/// Functions of each number alone.
macro_rules! alone {
    ($($name:ident: $of:expr),*) => {
        $(#[inline(always)]
        fn $name(self) -> Self {
            Self(self.0.map($of))
        })*
    };
}

impl<const N: usize, const FUSED: bool> Neg for Lanes<N, FUSED> {
    type Output = Self;
    alone!(neg: |x| -x);
}

impl<const N: usize, const FUSED: bool> Zero for Lanes<N, FUSED> {
    #[inline(always)]
    fn zero() -> Self {
        Self([0.0; N])
    }
    fn is_zero(&self) -> bool {
        self.0 == [0.0; N]
    }
}

impl<const N: usize, const FUSED: bool> One for Lanes<N, FUSED> {
    #[inline(always)]
    fn one() -> Self {
        Self([1.0; N])
    }
}

impl<const N: usize, const FUSED: bool> Series for Lanes<N, FUSED> {}
impl<const N: usize, const FUSED: bool> tumbling::laws::Rounding for Lanes<N, FUSED> {}

impl<const N: usize, const FUSED: bool> Lane for Lanes<N, FUSED> {
    /// All bits of a lane or none, which is what a vector's comparison gives.
    type Mask = [u64; N];
    const WIDTH: usize = N;

    #[inline(always)]
    fn from_lanes(of: impl FnMut(usize) -> f64) -> Self {
        Self(from_fn(of))
    }

    #[inline(always)]
    fn lane(&self, k: usize) -> f64 {
        // A number too large says the first again.
        self.0[k % N]
    }

    #[inline(always)]
    fn lt(self, other: Self) -> [u64; N] {
        from_fn(|k| if self.0[k] < other.0[k] { u64::MAX } else { 0 })
    }

    #[inline(always)]
    fn any(mask: [u64; N]) -> bool {
        mask.iter().fold(0, |any, one| any | one) != 0
    }

    #[inline(always)]
    fn select(mask: [u64; N], yes: Self, no: Self) -> Self {
        Self(from_fn(|k| f64::from_bits(yes.0[k].to_bits() & mask[k] | no.0[k].to_bits() & !mask[k])))
    }

    alone!(abs: f64::abs, sqrt: f64::sqrt, round_ties_even: f64::round_ties_even);
    alone!(sign: |x| 1_f64.copysign(x));

    #[inline(always)]
    fn two_product_error(self, other: Self, product: Self) -> Self {
        if !FUSED && fits(self) && fits(other) {
            // Dekker's product, exact as long as nothing leaves the range on the way.
            let (a, b) = (split(self), split(other));
            return ((a[0] * b[0] - product) + a[0] * b[1] + a[1] * b[0]) + a[1] * b[1];
        }
        Self(from_fn(|k| self.0[k].mul_add(other.0[k], -product.0[k])))
    }
}

/// Whether a product of such numbers and all its parts are within the range.
#[inline(always)]
fn fits<const N: usize, const FUSED: bool>(x: Lanes<N, FUSED>) -> bool {
    x.abs().0.iter().fold(true, |all, x| all & ((1e-120..1e120).contains(x) | (*x == 0.0)))
}

/// Its upper 26 bits and the rest, Veltkamp's way.
#[inline(always)]
fn split<const N: usize, const FUSED: bool>(x: Lanes<N, FUSED>) -> [Lanes<N, FUSED>; 2] {
    let scaled = x * 134_217_729.0;
    let upper = scaled - (scaled - x);
    [upper, x - upper]
}
