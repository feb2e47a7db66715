//! Sine and cosine, of every `f64`: an angle beyond an eighth of a turn less its quarter turns, by Payne and
//! Hanek's reduction.

use super::{inverse_factorials, polynomial};
use crate::number::{DoubleDouble, exponent, times_power_of_two};
use core::f64::consts::FRAC_PI_4;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// `(1 - sin x / x) / x²` as a series in `x²`. Up to an eighth of a turn the first term left out is below
/// 2^-66.
const SINE: [f64; 8] = inverse_factorials(3, 2, -1.0);

/// `(cos x - 1 + x²/2) / x⁴` as one.
const COSINE: [f64; 8] = inverse_factorials(4, 2, -1.0);

/// Sine and cosine of an angle in radians; NaN of one that is not finite.
#[inline]
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    let size = x.abs();
    if size <= FRAC_PI_4 {
        // So small an angle is its own sine; zero keeps its sign.
        return if size < 1e-8 { (x, 1.0) } else { near_zero(x, 0.0) };
    }
    if size.is_finite() { beyond(x) } else { (f64::NAN, f64::NAN) }
}

/// `cos(r)` and `sin(r)/r` of the root `r` of a number; NaN below zero.
#[inline]
pub(crate) fn cos_sinc_of_root(square: f64) -> (f64, f64) {
    if (0.0..=0.6).contains(&square) {
        return (cosine(square, 0.0), 1.0 - square * polynomial(&SINE, square));
    }
    let root = square.sqrt();
    let (sine, cosine) = sin_cos(root);
    (cosine, sine / root)
}

/// Both of an angle up to an eighth of a turn, given with what its rounding lost.
#[inline(always)]
fn near_zero(angle: f64, rest: f64) -> (f64, f64) {
    let square = angle * angle;
    let moved = rest * (1.0 - 0.5 * square);
    (angle + (moved - angle * square * polynomial(&SINE, square)), cosine(square, angle * rest))
}

/// The cosine of an angle with this square, less `moved`.
#[inline(always)]
fn cosine(square: f64, moved: f64) -> f64 {
    let half = 0.5 * square;
    let near = 1.0 - half;
    // What the subtraction rounded off goes back in.
    near + (((1.0 - near) - half) + (square * square * polynomial(&COSINE, square) - moved))
}

/// Sine and cosine of a finite angle beyond an eighth of a turn.
fn beyond(x: f64) -> (f64, f64) {
    let (quadrant, left) = quarters(x.abs());
    let (sin, cos) = near_zero(left.hi(), left.lo());
    let (sin, cos) = match quadrant % 4 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    };
    (if x < 0.0 { -sin } else { sin }, cos)
}

/// The bits of `2/pi`, after 64 zeros.
const TWO_OVER_PI: [u64; 21] = [
    0,
    0xa2f9_836e_4e44_1529,
    0xfc27_57d1_f534_ddc0,
    0xdb62_9599_3c43_9041,
    0xfe51_63ab_debb_c561,
    0xb724_6e3a_424d_d2e0,
    0x0649_2eea_09d1_921c,
    0xfe1d_eb1c_b129_a73e,
    0xe882_35f5_2ebb_4484,
    0xe99c_7026_b45f_7e41,
    0x3991_d639_8353_39f4,
    0x9c84_5f8b_bdf9_283b,
    0x1ff8_97ff_de05_980f,
    0xef2f_118b_5a0a_6d1f,
    0x6d36_7ecf_27cb_09b7,
    0x4f46_3f66_9e5f_ea2d,
    0x7527_bac7_ebe5_f17b,
    0x3d07_39f7_8a52_92ea,
    0x6bfb_5fb1_1f8d_5d08,
    0x5603_3046_fc7b_6bab,
    0xf0cf_bc20_9af4_361d,
];

/// The nearest number of quarter turns (modulo 4) of a finite angle of at least a quarter radian, and the
/// angle that is left: at most an eighth of a turn.
///
/// The angle is an integer times a power of two. Of `2/pi` times that power only 192 bits matter: those
/// before make whole turns, those after less than 2^-137 quarter turns, and no `f64` is nearer to a multiple
/// than 2^-62.
fn quarters(angle: f64) -> (u64, DoubleDouble) {
    const INTEGER: u64 = 1 << 52;
    let power = exponent(angle) - 52;
    let integer = (angle.to_bits() & (INTEGER - 1)) | INTEGER;
    // From the bit that, times the power, counts two quarter turns.
    let first = (62 + power).unsigned_abs() as usize;
    let window = [2, 1, 0].map(|k| bits_from(first + 64 * k));
    let (mut product, mut carry) = ([0_u64; 3], 0_u128);
    for (digit, part) in product.iter_mut().zip(window) {
        let sum = u128::from(integer) * u128::from(part) + carry;
        (*digit, carry) = (sum as u64, sum >> 64);
    }
    let [low, middle, high] = product;
    let quadrant = high.wrapping_add(1 << 61) >> 62;
    let left = [high.wrapping_sub(quadrant << 62), middle, low];
    let negative = left[0] >> 63 == 1;
    let size = from_bits(if negative { negated(left) } else { left }) * (DoubleDouble::PI * 0.5);
    (quadrant, if negative { -size } else { size })
}

/// 64 bits of the table from bit number `first`.
fn bits_from(first: usize) -> u64 {
    let (word, bit) = (first / 64, first % 64);
    let [high, low] = [word, word + 1].map(|k| u128::from(TWO_OVER_PI.get(k).copied().unwrap_or(0)));
    ((high << 64 | low) >> (64 - bit)) as u64
}

/// The two's complement of an integer of 192 bits, the highest first.
fn negated([high, middle, low]: [u64; 3]) -> [u64; 3] {
    let (low, carry) = (!low).overflowing_add(1);
    let (middle, carry) = (!middle).overflowing_add(u64::from(carry));
    [(!high).wrapping_add(u64::from(carry)), middle, low]
}

/// An integer of 192 bits, the highest first, in parts of 2^190: its first 117 bits from the first one that
/// is set.
fn from_bits([high, middle, low]: [u64; 3]) -> DoubleDouble {
    let first = u128::from(high) << 64 | u128::from(middle);
    let zeros = first.leading_zeros().min(127);
    let follows = if zeros < 64 { u128::from(low) >> (64 - zeros) } else { u128::from(low) << (zeros - 64) };
    let bits = first << zeros | follows;
    let power = 2 - zeros.cast_signed();
    DoubleDouble::sum(
        times_power_of_two((bits >> 75) as f64, power - 53),
        times_power_of_two((bits >> 11) as u64 as f64, power - 117),
    )
}
