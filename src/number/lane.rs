//! Several numbers in one value (SIMD lanes), and numbers known between bounds.

use super::{Field, Rounding};
use core::fmt::Debug;
use core::ops::{Add, Mul, Sub};
use nalgebra::{Quaternion, SVector};
use num_traits::Float;

/// A field whose numbers can be truncated sums of infinite series.
pub trait Series: Field {
    /// This sum, where the omitted terms amount to at most `rest`. `f64` and exact numbers return the sum
    /// unchanged: for `f64` the rest is below rounding, and for exact numbers the truncated sum is the
    /// formula itself. An enclosure is widened by the rest.
    ///
    /// ```
    /// use tumbling::laws::Series;
    /// assert_eq!(1.0_f64.up_to(|| unreachable!("never computed for an f64")), 1.0);
    /// ```
    #[inline(always)]
    fn up_to(self, _rest: impl FnOnce() -> Self) -> Self {
        self
    }
}

impl Series for f64 {}

/// Several `f64` that go through the same arithmetic at once, independently of each other, as in a vector
/// register of the processor. `f64` is the case of one lane.
///
/// The closed form of [free motion](crate::exact) is written over this trait and
/// [`Rounding`](crate::laws::Rounding), which a lane implements with its defaults. Every operation rounds as
/// on `f64`, so the result in a lane is the same, to the last bit, as for that `f64` alone, whatever the
/// other lanes hold. An implementation must therefore satisfy:
///
/// - `+ - * /` and [`sqrt`](Self::sqrt) of each lane equal those of `f64`, rounded once and never fused;
/// - arithmetic with an `f64` on the right is arithmetic with that number in every lane;
/// - `zero` and `one` have it in every lane.
///
/// Functions with the index of a lane are called only with indices below [`WIDTH`](Self::WIDTH).
///
/// ```
/// use tumbling::laws::Lane;
/// // Written once, for any number of bodies at once.
/// fn swapped<T: Lane>(low: T, high: T) -> [T; 2] {
///     let wrong = high.lt(low);
///     [T::select(wrong, high, low), T::select(wrong, low, high)]
/// }
/// assert_eq!(swapped(2.0, 1.0), [1.0, 2.0]);
/// ```
pub trait Lane:
    Series + Copy + Add<f64, Output = Self> + Sub<f64, Output = Self> + Mul<f64, Output = Self>
{
    /// A mask: true or false in each lane.
    type Mask: Copy + Debug;

    /// The number of lanes, at least 1. [`Batch`](crate::exact::Batch) answers this number of bodies at once.
    const WIDTH: usize;

    /// The number that `of` gives for each lane.
    fn from_lanes(of: impl FnMut(usize) -> f64) -> Self;

    /// The number in lane `k`.
    fn lane(&self, k: usize) -> f64;

    /// Whether the number is less than that of `other`, in each lane: false where either is NaN; -0 is not
    /// less than 0.
    fn lt(self, other: Self) -> Self::Mask;

    /// Whether the mask holds in any lane.
    fn any(mask: Self::Mask) -> bool;

    /// `yes` where the mask holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// The absolute value in each lane: the sign bit cleared, also of -0 and NaN.
    fn abs(self) -> Self;

    /// In each lane 1 or -1, by the sign bit: -1 for -0.
    fn sign(self) -> Self;

    /// The square root of a number that is not negative.
    fn sqrt(self) -> Self;

    /// The nearest integer, the even one of two equally near.
    fn round_ties_even(self) -> Self;

    /// `self * other - product` rounded once, where `product` is `self * other` rounded: the rounding error
    /// of the product.
    fn two_product_error(self, other: Self, product: Self) -> Self;
}

/// Three times 2^51: the last place of what it is added to counts integers.
pub(crate) const INTEGERS: f64 = 6_755_399_441_055_744.0;

/// One number in every lane.
#[inline(always)]
pub(crate) fn splat<T: Lane>(x: f64) -> T {
    T::from_lanes(|_| x)
}

impl Rounding for f64 {
    #[inline(always)]
    fn after_quarters(self, sin: Self, cos: Self) -> (Self, Self) {
        // From memory: the compiler makes a branch of an exchange, which a processor mostly guesses wrong.
        let (round, quarters) = ([sin, cos, -sin, -cos, sin], (self + INTEGERS).to_bits() as usize % 4);
        (round[quarters], round[quarters + 1])
    }
}

impl Lane for f64 {
    type Mask = bool;
    const WIDTH: usize = 1;

    #[inline(always)]
    fn from_lanes(mut of: impl FnMut(usize) -> f64) -> Self {
        of(0)
    }

    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        *self
    }

    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }

    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn sign(self) -> Self {
        1_f64.copysign(self)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Float::sqrt(self)
    }

    #[inline(always)]
    fn round_ties_even(self) -> Self {
        // Where the machine has an instruction for it.
        #[cfg(all(
            feature = "std",
            any(target_arch = "wasm32", target_arch = "aarch64", target_feature = "sse4.1")
        ))]
        return self.round_ties_even();
        // Elsewhere a sum that large rounds the fraction off, in a third of the time of the C library's
        // function.
        #[cfg(not(all(
            feature = "std",
            any(target_arch = "wasm32", target_arch = "aarch64", target_feature = "sse4.1")
        )))]
        {
            // 2^52: from here on numbers have no fraction.
            const LARGE: f64 = 4_503_599_627_370_496.0;
            if self.abs() < LARGE { ((self.abs() + LARGE) - LARGE).copysign(self) } else { self }
        }
    }

    #[inline(always)]
    fn two_product_error(self, other: Self, product: Self) -> Self {
        Float::mul_add(self, other, -product)
    }
}

/// Two to this power in each lane: an integer from -1022 to 1023.
#[inline(always)]
pub(crate) fn power_of_two<T: Lane>(power: T) -> T {
    // The exponent's bits are the last of a number that large.
    const SHIFT: f64 = 4_503_599_627_370_496.0 + 1023.0;
    T::from_lanes(|k| f64::from_bits((power.lane(k) + SHIFT).to_bits() << 52))
}

/// Lanes from as many single numbers: of one, or of all those of a structure.
pub(crate) trait Gather {
    /// What each lane is taken from.
    type One;

    /// The parts `of` each of `from`, one a lane. Where there are fewer of these than lanes the last is
    /// repeated: no lane depends on the others.
    fn gather<S>(from: &[S], of: impl Fn(&S) -> &Self::One) -> Self;
}

impl<T: Lane> Gather for T {
    type One = f64;
    fn gather<S>(from: &[S], of: impl Fn(&S) -> &f64) -> Self {
        T::from_lanes(|k| from.get(k).or(from.last()).map_or(0.0, |s| *of(s)))
    }
}

impl<G: Gather, const N: usize> Gather for [G; N] {
    type One = [G::One; N];
    fn gather<S>(from: &[S], of: impl Fn(&S) -> &[G::One; N]) -> Self {
        core::array::from_fn(|n| G::gather(from, |s| &of(s)[n]))
    }
}

impl<T: Lane, const N: usize> Gather for SVector<T, N> {
    type One = SVector<f64, N>;
    fn gather<S>(from: &[S], of: impl Fn(&S) -> &Self::One) -> Self {
        Self::from_fn(|n, _| T::gather(from, |s| &of(s)[n]))
    }
}

impl<T: Lane> Gather for Quaternion<T> {
    type One = Quaternion<f64>;
    fn gather<S>(from: &[S], of: impl Fn(&S) -> &Quaternion<f64>) -> Self {
        Quaternion::from_vector(Gather::gather(from, |s| &of(s).coords))
    }
}

/// Gathers a structure that is generic over its lanes, field by field.
macro_rules! gather_fields {
    ($Name:ident { $($field:ident),* }) => {
        impl<T: $crate::number::Lane> Gather for $Name<T> {
            type One = $Name<f64>;
            fn gather<S>(from: &[S], of: impl Fn(&S) -> &Self::One) -> Self {
                Self { $($field: Gather::gather(from, |s| &of(s).$field)),* }
            }
        }
    };
}
pub(crate) use gather_fields;

#[cfg(test)]
mod tests {
    use super::power_of_two;

    #[test]
    fn powers_of_two_are_exact_over_the_whole_range() {
        for n in [-1022, -1, 0, 1, 1023] {
            assert_eq!(power_of_two(f64::from(n)), 2_f64.powi(n));
        }
    }
}
