//! Jacobi's functions near and on the separatrix: theta sums in hyperbolic functions, after Jacobi's
//! imaginary transformation.

use crate::number::{Gather, Lane, gather_fields, lane_power_of_two, splat};

/// A decaying exponential of the argument: `E = exp(-2x)` with `1 - E` and the square root of `E`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Decay<T = f64> {
    /// `exp(-x)`.
    pub(crate) root: T,
    /// `exp(-2x)`.
    square: T,
    /// `1 - exp(-2x)`, small where `x` is.
    pub(crate) short_of_one: T,
    /// The root of the complementary nome over `exp(-x)`: this exponential from the other end of the passage.
    pub(crate) rising: T,
}

impl<T: Lane> Decay<T> {
    /// Of `x = main + rest >= 0`, with the root of the complementary nome.
    #[inline(always)]
    pub(crate) fn new(main: T, rest: T, nome_root: T) -> Self {
        // Farther out the rest can be large and has no effect.
        let (zero, farthest) = (splat::<T>(0.0), splat::<T>(FARTHEST));
        let within = main.lt(farthest);
        let (main, rest) = (T::select(within, main, farthest), T::select(within, rest, zero));
        let (power, change) = exp_parts(-main, -rest);
        let root = power + power * change;
        // exp(-x) - 1, exact in its small digits where the power of two is 1.
        let less = (power - 1.0) + power * change;
        Self { root, square: root * root, short_of_one: -less * (less + 2.0), rising: nome_root / root }
    }
}

/// The logarithm of 2 in two parts, the first with room for an exponent's eleven bits.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
/// Beyond this the exponential is negligible relative to any `f64`, and its square is zero.
const FARTHEST: f64 = 700.0;

/// `exp(x + rest) = power (1 + change)` with a power of two and `|change| <= 0.42`, for `|x| <= 700`.
#[inline(always)]
fn exp_parts<T: Lane>(x: T, rest: T) -> (T, T) {
    let twos = (x * core::f64::consts::LOG2_E).round_ties_even();
    let r = (x - twos * LN_2_HIGH) + (rest - twos * LN_2_LOW);
    // The series of exp(r) - 1 - r, over r²: what is left out is below 1e-17 of it for |r| <= 0.35.
    let a = const {
        let mut a = [0.5; 12];
        let mut n = 1;
        while n < 12 {
            a[n] = a[n - 1] / (n + 2) as f64;
            n += 1;
        }
        a
    };
    let (r2, r4) = (r * r, (r * r) * (r * r));
    let four = |k: usize| (r * a[k + 1] + a[k]) + r2 * (r * a[k + 3] + a[k + 2]);
    let series = four(0) + r4 * (four(4) + r4 * four(8));
    (lane_power_of_two(twos), r + r2 * series)
}

/// The sums for a complementary nome `p` of at most 0.02, that is the direct nome above 0.08.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ComplementarySeries<T = f64> {
    /// Powers of `p`: the second, the fourth, the first.
    powers: [T; 3],
    /// What makes `sn`, `cn` and `dn` of the quotients: up to half the quarter period, and beyond.
    pub(super) near_flip: [T; 3],
    pub(super) near_saddle: [T; 3],
}

gather_fields!(ComplementarySeries { powers, near_flip, near_saddle });

impl ComplementarySeries {
    /// `complement` is `2^shift k'`; `cn` and `dn` come out times `2^shift` too.
    pub(crate) fn new(p: f64, complement: f64, shift: i32) -> Self {
        let p2 = p * p;
        let p4 = p2 * p2;
        let (odd, even) = (2.0 * (p + p4 * p4 * p), 1.0 + 2.0 * p4);
        let (third, fourth) = (even + odd, even - odd);
        let second = 1.0 + p2 + p2 * p4;
        let stretch = crate::number::power_of_two::times_power_of_two(1.0, shift);
        Self {
            powers: [p2, p4, p],
            // (C29)
            near_flip: [third / fourth, stretch * (second / fourth), stretch * (second / third)],
            // (C30)
            near_saddle: [
                third / fourth,
                complement * (third * third / (fourth * second)),
                complement * (third / second),
            ],
        }
    }
}

impl<T: Lane> ComplementarySeries<T> {
    /// The four sums without their first exponential: those of the odd multiples, alternating (a hyperbolic
    /// sine) and not (a cosine), then those of the even multiples, alternating and not.
    #[inline(always)]
    pub(super) fn sums(&self, x: &Decay<T>) -> [T; 4] {
        let [p2, p4, p] = self.powers;
        let (e, short_of_one, growing) = (x.square, x.short_of_one, x.rising * x.rising);
        let square = e * e;
        // exp(-x) times twice sinh and cosh of 3x is exp(2x) (1 ∓ E³), of 5x is exp(4x) (1 ∓ E⁵); differences
        // by 1 - E, which has all its digits where they are small.
        let (b, c) = (p * growing, p4 * growing * growing);
        let (cube, fourth) = (e * square, square * square);
        let quotient = e + 1.0 + square;
        // (C28)
        let sine =
            short_of_one - b * short_of_one * quotient + c * short_of_one * (quotient + (cube + fourth));
        let cosine = (e + 1.0) + b * (cube + 1.0) + c * (e * fourth + 1.0);
        // p cosh 2x = growing (1 + E²)/2 and so on; p⁴ cosh 4x, p⁹ cosh 6x.
        let first = growing + p * e;
        let second = p2 * (growing * growing + p2 * square);
        let third = p4 * p2 * (growing * growing * growing + p2 * p * cube);
        let (even, odd) = (second + 1.0, first + third);
        [sine, cosine, even - odd, even + odd]
    }

    /// `sn`, `cn`, `dn` where `x` is the argument times `pi/(2K')`, up to half the quarter period; or, at a
    /// `saddle`, what is left of it to the quarter period, so that the small ones keep their digits there.
    #[inline(always)]
    pub(crate) fn values(&self, x: &Decay<T>, saddle: T::Mask) -> [T; 3] {
        let [sine, cosine, alternating, plain] = self.sums(x);
        let [s, c, d] = [0, 1, 2].map(|n| T::select(saddle, self.near_saddle[n], self.near_flip[n]));
        let (rise, fall) =
            (T::select(saddle, x.root, splat::<T>(1.0)), T::select(saddle, splat::<T>(0.5), x.root * 2.0));
        let (first, second) = (T::select(saddle, alternating, sine), T::select(saddle, sine, alternating));
        let (third, under) = (T::select(saddle, cosine, plain), T::select(saddle, plain * x.root, cosine));
        let inverse = splat::<T>(1.0) / under;
        let fall = fall * inverse;
        [s * first * (rise * inverse), c * second * fall, d * third * fall]
    }
}

#[cfg(test)]
mod tests {
    use super::{FARTHEST, LN_2_HIGH, LN_2_LOW};
    use crate::number::functions::exp;
    use core::f64::consts::LN_2;

    #[test]
    fn the_constants_of_the_exponential_are_what_they_stand_for() {
        // The logarithm of 2 beyond its f64, with 20 digits more.
        let (beyond, own) = (2.319_046_813_846_299_6e-17, LN_2 - LN_2_HIGH);
        assert!((own - LN_2_LOW + beyond).abs() < 2e-26);
        // Eleven zeros at its end: a product with any exponent is exact.
        assert_eq!(LN_2_HIGH.to_bits() % (1 << 11), 0);
        assert!(exp(-FARTHEST) >= f64::MIN_POSITIVE && exp(-2.0 * FARTHEST) == 0.0);
    }
}
