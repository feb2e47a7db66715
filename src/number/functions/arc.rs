//! The angle of a point in the plane.

use super::polynomial;
use crate::number::{DoubleDouble, Lane, exponent, times_power_of_two};
use core::f64::consts::FRAC_PI_4;

/// The arctangents of 0, 1/8, ... 1, each with what its rounding lost.
const EIGHTHS: [[f64; 2]; 9] = [
    [0.0, 0.0],
    [0.124_354_994_546_761_44, -3.125_324_142_453_938_3e-18],
    [0.244_978_663_126_864_14, 1.069_875_561_873_445_1e-17],
    [0.358_770_670_270_572_25, -2.462_381_558_263_863_5e-17],
    [0.463_647_609_000_806_1, 2.269_877_745_296_168_7e-17],
    [0.558_599_315_343_562_4, -5.455_630_548_591_626_4e-18],
    [0.643_501_108_793_284_4, 1.583_478_505_144_428_6e-17],
    [0.718_829_999_621_624_5, -2.147_838_844_445_698_3e-17],
    [FRAC_PI_4, 3.061_616_997_868_383e-17],
];

/// `(atan u - u) / u³ = -1/3 + u²/5 - ...` as a series in `u²`. Up to 1/16 the first term left out is below
/// 2^-59.
const TAIL: [f64; 6] = [-1.0 / 3.0, 1.0 / 5.0, -1.0 / 7.0, 1.0 / 9.0, -1.0 / 11.0, 1.0 / 13.0];

/// The angle from the x axis to the point `(x, y)`, from -pi to pi, with the signs of zeros as IEEE 754 has
/// them.
pub(crate) fn atan2(y: f64, x: f64) -> f64 {
    if x.is_nan() || y.is_nan() {
        return f64::NAN;
    }
    let (across, along) = (y.abs(), x.abs());
    let mut angle = if across > along {
        DoubleDouble::PI * 0.5 - up_to_an_eighth(along, across)
    } else {
        up_to_an_eighth(across, along)
    };
    if x.is_sign_negative() {
        angle = DoubleDouble::PI - angle;
    }
    angle.hi().copysign(y)
}

/// The arctangent of `across / along`, neither negative, the first not larger.
fn up_to_an_eighth(across: f64, along: f64) -> DoubleDouble {
    if along.is_infinite() {
        let [angle, rest] = EIGHTHS[8];
        return if across.is_infinite() { DoubleDouble::new(angle, rest) } else { DoubleDouble::ZERO };
    }
    // As small as this, the angle is its tangent; and the zeros.
    if across <= along * 1e-20 {
        return if across == 0.0 { DoubleDouble::ZERO } else { DoubleDouble::from(across / along) };
    }
    let unit = -exponent(along);
    let [across, along] = [across, along].map(|size| times_power_of_two(size, unit));
    // atan t = atan c + atan u, with u = (t - c)/(1 + t c).
    let eighths = Lane::round_ties_even(8.0 * (across / along));
    let c = 0.125 * eighths;
    let above = DoubleDouble::from(across) - DoubleDouble::product(along, c);
    let below = DoubleDouble::from(along) + DoubleDouble::product(across, c);
    let u = above.hi() / below.hi();
    let rest = (above - below * u).hi() / below.hi();
    let square = u * u;
    let [angle, angle_rest] = EIGHTHS[eighths as usize];
    DoubleDouble::new(angle, angle_rest) + DoubleDouble::sum(u, rest + u * square * polynomial(&TAIL, square))
}
