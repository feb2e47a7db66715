//! An `f64` with a larger range: the same 53 bits of significand, and an exponent that does not overflow in
//! practice.
//!
//! A body may be 1e-100 m across, and its inertia is proportional to the fifth power of that. The formulas
//! for solids run on this number type, so that no intermediate value overflows or underflows; only the result
//! must fit an `f64`. While it does, every operation rounds exactly as `f64` does.

use crate::error::{Error, Refusal, Subject, representable};
use crate::number::{exponent, times_power_of_two};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};

/// `significand * 2^exponent`, with `1 <= |significand| < 2`, or zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extended {
    significand: f64,
    exponent: i32,
}

impl Extended {
    fn normal(significand: f64, scale: i32) -> Self {
        if significand == 0.0 {
            return Self { significand: 0.0, exponent: 0 };
        }
        let e = exponent(significand);
        Self { significand: times_power_of_two(significand, -e), exponent: scale + e }
    }

    /// The nearest `f64`: infinite, subnormal or zero where the range ends.
    pub(crate) fn nearest(self) -> f64 {
        times_power_of_two(self.significand, self.exponent)
    }

    /// As an `f64` that is finite.
    pub(crate) fn finite(self, what: Subject) -> Result<f64, Error> {
        let value = self.nearest();
        representable(what, &[value]).map(|()| value)
    }

    /// As an `f64` that has all its digits: a subnormal number has lost some, a vanished one all.
    pub(crate) fn in_full(self, what: Subject) -> Result<f64, Error> {
        let value = self.finite(what)?;
        let whole = self.significand == 0.0 || value.is_normal();
        if whole { Ok(value) } else { Err(Refusal::OutOfRange { what, value }.into()) }
    }

    pub(crate) fn abs(self) -> Self {
        Self { significand: self.significand.abs(), ..self }
    }

    pub(crate) fn is_positive(self) -> bool {
        self.significand > 0.0
    }
}

impl From<f64> for Extended {
    fn from(x: f64) -> Self {
        Self::normal(x, 0)
    }
}

impl Add for Extended {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if other.significand == 0.0 {
            return self;
        }
        if self.significand == 0.0 {
            return other;
        }
        let (large, small) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let aligned = times_power_of_two(small.significand, small.exponent - large.exponent);
        Self::normal(large.significand + aligned, large.exponent)
    }
}

impl Neg for Extended {
    type Output = Self;
    fn neg(self) -> Self {
        Self { significand: -self.significand, ..self }
    }
}

impl Sub for Extended {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Extended {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::normal(self.significand * other.significand, self.exponent + other.exponent)
    }
}

impl Div for Extended {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self::normal(self.significand / other.significand, self.exponent - other.exponent)
    }
}

macro_rules! assign {
    ($($Trait:ident $function:ident $operator:tt),*) => {$(
        impl $Trait for Extended {
            fn $function(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /);

impl Zero for Extended {
    fn zero() -> Self {
        Self::from(0.0)
    }
    fn is_zero(&self) -> bool {
        self.significand == 0.0
    }
}

impl One for Extended {
    fn one() -> Self {
        Self::from(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ErrorKind;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn inside_the_range_of_f64_every_operation_rounds_as_f64_does(
            a in -1e100_f64..1e100, b in -1e100_f64..1e100, s in -200_i32..200,
        ) {
            let b = times_power_of_two(b, s);
            let (wa, wb) = (Extended::from(a), Extended::from(b));
            prop_assert_eq!((wa + wb).nearest(), a + b);
            prop_assert_eq!((wa - wb).nearest(), a - b);
            prop_assert_eq!((wa * wb).nearest(), a * b);
            if b != 0.0 {
                prop_assert_eq!((wa / wb).nearest(), a / b);
            }
        }
    }

    #[test]
    fn a_product_may_leave_the_range_of_f64_and_come_back() {
        let huge = Extended::from(1.5e300);
        let tiny = Extended::from(5e-324);
        assert_eq!((huge * huge * huge / huge / huge).nearest(), 1.5e300);
        assert_eq!((tiny * tiny * huge / tiny / huge).nearest(), 5e-324);
        assert_eq!((huge * huge).nearest(), f64::INFINITY);
    }

    #[test]
    fn what_f64_cannot_hold_in_full_is_refused_and_an_exact_zero_is_not() {
        let tiny = Extended::from(1e-200);
        let kind = |number: Extended| number.in_full(Subject::Mass).map_err(|error| error.kind());
        assert_eq!(kind(tiny * tiny), Err(ErrorKind::Unrepresentable));
        assert_eq!(kind(tiny * Extended::from(1e-110)), Err(ErrorKind::Unrepresentable));
        assert_eq!((tiny - tiny).in_full(Subject::Mass), Ok(0.0));
    }
}
