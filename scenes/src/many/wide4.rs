//! Four numbers side by side, of the crate `wide`.

use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use tumbling::scalar::Lane;
use wide::{CmpLt, f64x4};

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Four(f64x4);

macro_rules! arithmetic {
    ($Op:ident, $op:ident, $Assign:ident, $assign:ident) => {
        impl $Op for Four {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: Self) -> Self {
                Self(self.0.$op(other.0))
            }
        }
        impl $Op<f64> for Four {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: f64) -> Self {
                Self(self.0.$op(f64x4::splat(other)))
            }
        }
        impl $Assign for Four {
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
impl Neg for Four {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0 ^ f64x4::splat(-0.0))
    }
}
impl Zero for Four {
    fn zero() -> Self {
        Self(f64x4::splat(0.0))
    }
    fn is_zero(&self) -> bool {
        self.0.to_array() == [0.0; 4]
    }
}
impl One for Four {
    fn one() -> Self {
        Self(f64x4::splat(1.0))
    }
}
impl Lane for Four {
    type Mask = f64x4;
    const WIDTH: usize = 4;
    #[inline(always)]
    fn of_lanes(of: impl FnMut(usize) -> f64) -> Self {
        Self(f64x4::new(std::array::from_fn(of)))
    }
    #[inline(always)]
    fn lane(&self, k: usize) -> f64 {
        self.0.as_array()[k]
    }
    #[inline(always)]
    fn below(self, other: Self) -> f64x4 {
        self.0.simd_lt(other.0)
    }
    #[inline(always)]
    fn any(mask: f64x4) -> bool {
        mask.any()
    }
    #[inline(always)]
    fn choose(mask: f64x4, yes: Self, no: Self) -> Self {
        Self(mask.select(yes.0, no.0))
    }
    #[inline(always)]
    fn size(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn sign(self) -> Self {
        Self((self.0 & f64x4::splat(-0.0)) | f64x4::splat(1.0))
    }
    #[inline(always)]
    fn root(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(always)]
    fn whole(self) -> Self {
        if cfg!(target_feature = "avx") {
            return Self(f64x4::new(self.0.to_array().map(f64::round_ties_even)));
        }
        let unit = f64x4::splat(6_755_399_441_055_744.0);
        if self.0.abs().simd_lt(f64x4::splat(2_251_799_813_685_248.0)).all() {
            let sign = self.0 & f64x4::splat(-0.0);
            return Self(((self.0 + unit) - unit) | sign);
        }
        Self(f64x4::new(self.0.to_array().map(f64::round_ties_even)))
    }
    #[inline(always)]
    fn left_off(self, other: Self, product: Self) -> Self {
        if cfg!(all(target_feature = "avx", target_feature = "fma")) {
            return Self(self.0.mul_sub(other.0, product.0));
        }
        let zero = f64x4::splat(0.0);
        let fits = |x: f64x4| {
            let size = x.abs();
            ((size.simd_lt(f64x4::splat(2e120)) & size.simd_gt(f64x4::splat(1e-120))) | size.simd_eq(zero)).all()
        };
        if fits(self.0) && fits(other.0) {
            let split = |x: f64x4| {
                let scaled = f64x4::splat(134_217_729.0) * x;
                let upper = scaled - (scaled - x);
                [upper, x - upper]
            };
            let (a, b) = (split(self.0), split(other.0));
            return Self(((a[0] * b[0] - product.0) + a[0] * b[1] + a[1] * b[0]) + a[1] * b[1]);
        }
        Self(f64x4::new(std::array::from_fn(|k| self.lane(k).mul_add(other.lane(k), -product.lane(k)))))
    }
    #[inline(always)]
    fn power_of_two(self) -> Self {
        let shifted = self.0 + f64x4::splat(4_503_599_627_370_496.0 + 1023.0);
        Self(f64x4::new(shifted.to_array().map(|x| f64::from_bits(x.to_bits() << 52))))
    }
}
