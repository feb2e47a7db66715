//! Numbers side by side, as plain arrays: the compiler puts them into whatever vector registers the machine has.

use num_traits::{One, Zero};
use std::array::from_fn;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use tumbling::scalar::Lane;

/// `N` numbers side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub struct Lanes<const N: usize>([f64; N]);

/// Yes (all bits) or no in each of `N` lanes.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
pub struct Mask<const N: usize>([u64; N]);

impl<const N: usize> Lanes<N> {
    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        Self(self.0.map(f))
    }

    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(from_fn(|k| f(self.0[k], other.0[k])))
    }

    #[inline(always)]
    fn all(self, f: impl Fn(f64) -> bool) -> bool {
        self.0.into_iter().fold(true, |all, x| all & f(x))
    }
}

macro_rules! arithmetic {
    ($Op:ident, $op:ident, $Assign:ident, $assign:ident) => {
        impl<const N: usize> $Op for Lanes<N> {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: Self) -> Self {
                self.with(other, f64::$op)
            }
        }
        impl<const N: usize> $Op<f64> for Lanes<N> {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: f64) -> Self {
                self.each(|x| x.$op(other))
            }
        }
        impl<const N: usize> $Assign for Lanes<N> {
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

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|x| -x)
    }
}

impl<const N: usize> Zero for Lanes<N> {
    fn zero() -> Self {
        Self([0.0; N])
    }
    fn is_zero(&self) -> bool {
        self.all(|x| x == 0.0)
    }
}

impl<const N: usize> One for Lanes<N> {
    fn one() -> Self {
        Self([1.0; N])
    }
}

impl<const N: usize> Lane for Lanes<N> {
    type Mask = Mask<N>;
    const WIDTH: usize = N;

    #[inline(always)]
    fn of_lanes(of: impl FnMut(usize) -> f64) -> Self {
        Self(from_fn(of))
    }

    #[inline(always)]
    fn lane(&self, k: usize) -> f64 {
        self.0[k]
    }

    #[inline(always)]
    fn below(self, other: Self) -> Mask<N> {
        Mask(from_fn(|k| if self.0[k] < other.0[k] { u64::MAX } else { 0 }))
    }

    #[inline(always)]
    fn any(mask: Mask<N>) -> bool {
        mask.0.into_iter().fold(0, |any, bits| any | bits) != 0
    }

    #[inline(always)]
    fn choose(mask: Mask<N>, yes: Self, no: Self) -> Self {
        Self(from_fn(|k| f64::from_bits((yes.0[k].to_bits() & mask.0[k]) | (no.0[k].to_bits() & !mask.0[k]))))
    }

    #[inline(always)]
    fn size(self) -> Self {
        self.each(f64::abs)
    }

    #[inline(always)]
    fn sign(self) -> Self {
        self.each(|x| 1_f64.copysign(x))
    }

    #[inline(always)]
    fn root(self) -> Self {
        self.each(f64::sqrt)
    }

    #[inline(always)]
    fn whole(self) -> Self {
        if cfg!(any(target_feature = "sse4.1", target_arch = "aarch64")) {
            return self.each(f64::round_ties_even);
        }
        // Up to 2^51 the sum's last place is the unit; numbers beyond 2^52 are whole.
        const UNIT: f64 = 6_755_399_441_055_744.0;
        if self.all(|x| x.abs() <= 2_251_799_813_685_248.0) {
            // The sign goes on again: what rounds to zero from below is -0.
            return self.each(|x| ((x + UNIT) - UNIT).copysign(x));
        }
        self.each(f64::round_ties_even)
    }

    #[inline(always)]
    fn left_off(self, other: Self, product: Self) -> Self {
        if cfg!(any(target_feature = "fma", target_arch = "aarch64")) {
            return Self(from_fn(|k| self.0[k].mul_add(other.0[k], -product.0[k])));
        }
        // Without the instruction: Dekker's product, exact as long as nothing leaves the range on the way.
        let fits = |x: f64| x == 0.0 || (SMALL..LARGE).contains(&x.abs());
        if self.all(fits) && other.all(fits) {
            return Self(from_fn(|k| {
                let (a, b) = (split(self.0[k]), split(other.0[k]));
                ((a[0] * b[0] - product.0[k]) + a[0] * b[1] + a[1] * b[0]) + a[1] * b[1]
            }));
        }
        Self(from_fn(|k| self.0[k].mul_add(other.0[k], -product.0[k])))
    }

    #[inline(always)]
    fn power_of_two(self) -> Self {
        self.each(f64::power_of_two)
    }
}

/// 2^-400 and 2^400.
const SMALL: f64 = f64::from_bits((1023 - 400) << 52);
const LARGE: f64 = f64::from_bits((1023 + 400) << 52);

/// Its upper 26 bits and the rest, Veltkamp's way.
#[inline(always)]
fn split(x: f64) -> [f64; 2] {
    let scaled = 134_217_729.0 * x;
    let upper = scaled - (scaled - x);
    [upper, x - upper]
}
