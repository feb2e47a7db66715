//! The functions of an instant of the closed form, in lanes: sine and cosine near zero, and the exponential
//! that decays.

use super::inverse_factorials;
use crate::number::lane::power_of_two;
use crate::number::{Rounding, splat};

/// Both by their own series, for angles up to an eighth of a turn. The first term left out is below 2e-19 of
/// the sum; the rest is what its largest coefficient lacks, rounded to 2^-56, and the smaller ones.
#[inline(always)]
pub(crate) fn sin_cos_near_zero<T: Rounding>(x: T) -> (T, T) {
    const S: [f64; 8] = inverse_factorials(3, 2, -1.0);
    const C: [f64; 8] = inverse_factorials(4, 2, -1.0);
    let y = x * x;
    let (y2, y4) = (y * y, (y * y) * (y * y));
    // Pairs, then pairs of pairs: the processor works on them at once.
    let series = |a: &[f64; 8]| {
        let low = (y * a[1] + a[0]) + y2 * (y * a[3] + a[2]);
        let high = (y * a[5] + a[4]) + y2 * (y * a[7] + a[6]);
        (low + y4 * high).up_to(|| splat(1.5e-17))
    };
    let sin = x - x * y * series(&S);
    let half = y * 0.5;
    let near = -half + 1.0;
    // What the subtraction rounded off goes back in.
    let cos = near + (((-near + 1.0) - half) + y2 * series(&C));
    (sin, cos)
}

/// `exp(-x)` and `exp(-x) - 1` of `x = main + rest >= 0`.
#[inline(always)]
pub(crate) fn decay<T: Rounding>(main: T, rest: T) -> [T; 2] {
    // For larger arguments the rest can be large, but it has no effect.
    let (zero, farthest) = (splat::<T>(0.0), splat::<T>(FARTHEST));
    let within = main.lt(farthest);
    let (main, rest) = (T::select(within, main, farthest), T::select(within, rest, zero));
    let (power, change) = exp_parts(-main, -rest);
    let beyond = || T::select(within, zero, splat(1e-304));
    // The exponential less 1 is exact in its small digits where the power of two is 1.
    [(power + power * change).up_to(beyond), ((power - 1.0) + power * change).up_to(beyond)]
}

/// The logarithm of 2 in two parts, the first with room for an exponent's eleven bits.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
/// Beyond this the exponential is negligible relative to any `f64`, and its square is zero.
const FARTHEST: f64 = 700.0;

/// `exp(x + rest) = power (1 + change)` with a power of two and `|change| <= 0.42`, for `|x| <= 700`.
#[inline(always)]
fn exp_parts<T: Rounding>(x: T, rest: T) -> (T, T) {
    let twos = (x * core::f64::consts::LOG2_E).nearest();
    // The two parts of the logarithm lack less than that.
    let r = (x - twos * LN_2_HIGH) + (rest - twos * LN_2_LOW).up_to(|| twos * 2e-26);
    // The series of exp(r) - 1 - r, over r²: what is left out and what the coefficients lack is below
    // 4.4e-17 for |r| <= 0.35.
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
    let series = (four(0) + r4 * (four(4) + r4 * four(8))).up_to(|| splat(4.4e-17));
    (power_of_two(twos), r + r2 * series)
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
