//! Four numbers side by side, of the crate `wide`.
//!
//! Of its operations only those that round as `f64` does: its own sine, exponential and rounding are not
//! needed, and its fused product is fused on some machines only.

use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use tumbling::number::{Lane, Series};
use wide::f64x4;

/// Four numbers side by side: a vector register where the program is built for a machine that has them (`-C
/// target-cpu=native`), a pair of shorter ones elsewhere, with the same answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FourLanes(f64x4);

macro_rules! arithmetic {
    ($Op:ident, $op:ident, $Assign:ident, $assign:ident) => {
        impl $Op for FourLanes {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: Self) -> Self {
                Self(self.0.$op(other.0))
            }
        }
        impl $Op<f64> for FourLanes {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: f64) -> Self {
                Self(self.0.$op(f64x4::splat(other)))
            }
        }
        impl $Assign for FourLanes {
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
impl Neg for FourLanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0 ^ f64x4::splat(-0.0))
    }
}

impl Zero for FourLanes {
    fn zero() -> Self {
        Self(f64x4::splat(0.0))
    }
    fn is_zero(&self) -> bool {
        self.0.to_array() == [0.0; 4]
    }
}

impl One for FourLanes {
    fn one() -> Self {
        Self(f64x4::splat(1.0))
    }
}

/// Of numbers beyond it the last place is no half.
const HALVES: f64 = 2_251_799_813_685_248.0;
/// Added to one up to [`HALVES`] it makes the last place 1.
const UNIT: f64 = 6_755_399_441_055_744.0;
/// Between these (or zero), a product and all its parts are within the range.
const SMALL: f64 = 1e-120;
const LARGE: f64 = 1e120;

impl Series for FourLanes {}

impl Lane for FourLanes {
    type Mask = f64x4;
    const WIDTH: usize = 4;

    #[inline(always)]
    fn from_lanes(of: impl FnMut(usize) -> f64) -> Self {
        Self(f64x4::new(std::array::from_fn(of)))
    }

    #[inline(always)]
    fn lane(&self, k: usize) -> f64 {
        // There are four: a number too large says the first again.
        self.0.as_array()[k % 4]
    }

    #[inline(always)]
    fn lt(self, other: Self) -> f64x4 {
        self.0.simd_lt(other.0)
    }

    #[inline(always)]
    fn any(mask: f64x4) -> bool {
        mask.any()
    }

    #[inline(always)]
    fn select(mask: f64x4, yes: Self, no: Self) -> Self {
        Self(mask.select(yes.0, no.0))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    #[inline(always)]
    fn sign(self) -> Self {
        Self((self.0 & f64x4::splat(-0.0)) | f64x4::splat(1.0))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline(always)]
    fn round_ties_even(self) -> Self {
        // Where there is an instruction for it the compiler takes that, four at once.
        let instruction = cfg!(any(target_feature = "avx", target_arch = "aarch64"));
        if !instruction && self.0.abs().simd_lt(f64x4::splat(HALVES)).all() {
            let unit = f64x4::splat(UNIT);
            // The sign goes on again: what rounds to zero from below is -0.
            return Self(((self.0 + unit) - unit) | (self.0 & f64x4::splat(-0.0)));
        }
        Self(f64x4::new(self.0.to_array().map(f64::round_ties_even)))
    }

    #[inline(always)]
    fn two_product_error(self, other: Self, product: Self) -> Self {
        if cfg!(all(target_feature = "avx", target_feature = "fma")) {
            return Self(self.0.mul_sub(other.0, product.0));
        }
        // Without the instruction: Dekker's product, exact as long as nothing leaves the range on the way.
        if !cfg!(target_arch = "aarch64") && fits(self.0) && fits(other.0) {
            let (a, b) = (split(self.0), split(other.0));
            return Self(((a[0] * b[0] - product.0) + a[0] * b[1] + a[1] * b[0]) + a[1] * b[1]);
        }
        Self::from_lanes(|k| self.lane(k).mul_add(other.lane(k), -product.lane(k)))
    }
}

#[inline(always)]
fn fits(x: f64x4) -> bool {
    let size = x.abs();
    let between = size.simd_lt(f64x4::splat(LARGE)) & size.simd_gt(f64x4::splat(SMALL));
    (between | size.simd_eq(f64x4::splat(0.0))).all()
}

/// Its upper 26 bits and the rest, Veltkamp's way.
#[inline(always)]
fn split(x: f64x4) -> [f64x4; 2] {
    let scaled = f64x4::splat(134_217_729.0) * x;
    let upper = scaled - (scaled - x);
    [upper, x - upper]
}
