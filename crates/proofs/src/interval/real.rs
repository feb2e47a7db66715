//! Intervals as the numbers of the library's closed form.
//!
//! A type of its own, since the library's code multiplies by float literals, which an [`Interval`] refuses.
//! Where `f64` carries a number in two parts, here the first is one float near the number, and the second
//! encloses the rest.

use super::Interval;
use super::arithmetic::{product, safe};
use num_traits::Zero;
use tumbling::laws::{Lane, Real, Rounding, Series};

/// A real number in an interval.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(super) struct Enclosed(pub(super) Interval);

/// A float, exactly.
fn exact(x: f64) -> Enclosed {
    Enclosed(Interval { low: x, high: x })
}

/// The traits of a field, from a sum, a product, a quotient and what a float is; and arithmetic with floats.
#[macro_export]
macro_rules! field {
    ($T:ident, $exact:ident, and floats) => {
        $crate::field!($T, $exact);
        $crate::field!($T, $exact, Add add, Sub sub, Mul mul, Div div);
    };
    ($T:ident, $exact:ident) => {
        $crate::field!($T, Add add AddAssign add_assign |a, b| a.plus(b));
        $crate::field!($T, Sub sub SubAssign sub_assign |a, b| a.plus(b.minus()));
        $crate::field!($T, Mul mul MulAssign mul_assign |a, b| a.times(b));
        $crate::field!($T, Div div DivAssign div_assign |a, b| a.over(b));
        impl std::ops::Neg for $T {
            type Output = Self;
            fn neg(self) -> Self {
                self.minus()
            }
        }
        impl num_traits::Zero for $T {
            fn zero() -> Self {
                $exact(0.0)
            }
            fn is_zero(&self) -> bool {
                self.zero_for_certain()
            }
        }
        impl num_traits::One for $T {
            fn one() -> Self {
                $exact(1.0)
            }
        }
    };
    ($T:ident, $Op:ident $op:ident $Assign:ident $assign:ident |$a:ident, $b:ident| $by:expr) => {
        impl std::ops::$Op for $T {
            type Output = Self;
            fn $op(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                $by
            }
        }
        impl std::ops::$Assign for $T {
            fn $assign(&mut self, other: Self) {
                *self = std::ops::$Op::$op(*self, other);
            }
        }
    };
    ($T:ident, $exact:ident, $($Op:ident $op:ident),*) => {$(
        impl std::ops::$Op<f64> for $T {
            type Output = Self;
            fn $op(self, other: f64) -> Self {
                std::ops::$Op::$op(self, $exact(other))
            }
        }
    )*};
}

field!(Enclosed, exact, and floats);

impl Enclosed {
    fn plus(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
    fn times(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
    fn over(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
    fn minus(self) -> Self {
        Self(-self.0)
    }
    fn zero_for_certain(&self) -> bool {
        self.0.is_zero()
    }

    /// A float near its middle.
    fn middle(self) -> f64 {
        let (low, half) = (self.0.low, 0.5 * self.0.width());
        let middle = if half.is_infinite() { 0.5 * low + 0.5 * self.0.high } else { low + half };
        if middle.is_infinite() { 0.0 } else { middle }
    }
}

/// The value that is the same in all lanes, of one number between bounds.
macro_rules! one_lane {
    ($exact:ident) => {
        type Mask = bool;
        const WIDTH: usize = 1;
        fn from_lanes(mut of: impl FnMut(usize) -> f64) -> Self {
            $exact(of(0))
        }
        fn any(mask: bool) -> bool {
            mask
        }
        fn select(mask: bool, yes: Self, no: Self) -> Self {
            if mask { yes } else { no }
        }
    };
    () => {
        fn nearest(self) -> Self {
            self.round_ties_even()
        }
        fn finite(self) -> bool {
            true
        }
    };
}
pub(super) use one_lane;

impl Series for Enclosed {
    fn up_to(self, rest: impl FnOnce() -> Self) -> Self {
        let rest = rest().0.abs();
        if rest.high < f64::INFINITY { Self(self.0 + rest.hull(-rest)) } else { Self(self.0 + Interval::ALL) }
    }
}

impl Lane for Enclosed {
    one_lane!(exact);
    fn lane(&self, _: usize) -> f64 {
        self.middle()
    }
    fn lt(self, other: Self) -> bool {
        self.middle() < other.middle()
    }
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    fn sign(self) -> Self {
        exact(1_f64.copysign(self.middle()))
    }
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    fn round_ties_even(self) -> Self {
        exact(self.middle().round_ties_even())
    }
    fn two_product_error(self, other: Self, product: Self) -> Self {
        self * other - product
    }
}

impl Rounding for Enclosed {
    one_lane!();
    fn sum_in_two(self, other: Self) -> [Self; 2] {
        let [a, b] = [self.middle(), other.middle()];
        let [larger, smaller] = if a.abs() < b.abs() { [other, self] } else { [self, other] };
        [exact(a + b), (larger - (a + b)) + smaller]
    }
    fn quick_sum_in_two(self, other: Self) -> [Self; 2] {
        self.sum_in_two(other)
    }
    fn product_in_two(self, other: Self) -> [Self; 2] {
        let [a, b] = [self.middle(), other.middle()];
        let (near, error, _) = product(a, b);
        if near != 0.0 && !safe(near) {
            let whole = self * other;
            return [exact(whole.middle()), whole - whole.middle()];
        }
        let [da, db] = [self - a, other - b];
        [exact(near), da * db + (da * b + db * a) + error]
    }
    fn in_one(high: Self, low: Self) -> [Self; 2] {
        [high + low, Self::zero()]
    }
    fn near(self) -> Self {
        exact(self.middle())
    }
    fn not_below_zero(self) -> Self {
        self
    }
    fn sin_cos_of_quarter(self) -> (Self, Self) {
        (Self(Interval::PI) * 0.5 * self).sin_cos()
    }
    fn after_quarters(self, sin: Self, cos: Self) -> (Self, Self) {
        [(sin, cos), (cos, -sin), (-sin, -cos), (-cos, sin)][self.middle().rem_euclid(4.0) as usize]
    }
    fn decay(self, rest: Self) -> [Self; 2] {
        (-(self + rest)).exp_and_exp_m1().into()
    }
}

impl Real for Enclosed {
    fn pi_in_two() -> [Self; 2] {
        const REST: f64 = 1.224_646_799_147_353_2e-16;
        let rest = Interval { low: REST.next_down(), high: REST.next_up() };
        [exact(std::f64::consts::PI), Self(rest)]
    }
    fn times_power_of_two(self, exponent: i32) -> Self {
        let half = exponent / 2;
        let factors = [half, exponent - half].map(|e| exact(2_f64.powi(e)));
        self * factors[0] * factors[1]
    }
    fn exponent(self) -> i32 {
        let middle = self.middle().abs();
        if middle == 0.0 { 0 } else { middle.log2().floor() as i32 }
    }
    fn exp_and_exp_m1(self) -> (Self, Self) {
        let (power, less) = self.0.exp_and_exp_m1();
        (Self(power), Self(less))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self(sine), Self(cosine))
    }
    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0))
    }
    fn hypot(self, other: Self) -> Self {
        Self((self.0.square() + other.0.square()).sqrt())
    }
    fn at_most_one(self) -> Self {
        Self(self.0.clamped(f64::NEG_INFINITY, 1.0))
    }
    fn with_sign(self, of: Self) -> Self {
        let size = self.0.abs();
        Self(match of.0 {
            Interval { low, .. } if low >= 0.0 => size,
            Interval { high, .. } if high <= 0.0 => -size,
            _ => size.hull(-size),
        })
    }
    fn of_one_sign(self) -> Self {
        if self.0.low < 0.0 && self.0.high > 0.0 { Self(Interval::ALL) } else { self }
    }
    fn but_for_rounding(self) -> Self {
        Self::zero()
    }
    fn has_all_digits(self) -> bool {
        self.0.low > f64::MIN_POSITIVE
    }
}
