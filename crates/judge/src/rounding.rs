//! How exact the numbers of a record are.

use crate::source::Raw;
use crate::state::median;
use crate::thresholds::{DIGITS_OF_DOUBLE, DIGITS_OF_SINGLE, FEWEST_DIGITS, MOST_DIGITS};

/// The rounding of numbers that have this number of digits, or that single precision holds.
pub(crate) fn rounding(probe: &[Raw]) -> f64 {
    let digits = probe.iter().map(|raw| raw.digits).max().unwrap_or(MOST_DIGITS).min(MOST_DIGITS);
    let single = probe.iter().all(|raw| raw.single) && digits > DIGITS_OF_SINGLE;
    let of_digits =
        if digits >= DIGITS_OF_DOUBLE { 0.0 } else { 10.0_f64.powi(1 - i32::try_from(digits).unwrap_or(17)) };
    // Few digits may be all there are: 0.5 has one. A record of such numbers alone does not move.
    let of_digits = if digits < FEWEST_DIGITS { 0.0 } else { of_digits };
    let of_single = if single { f64::from(f32::EPSILON) } else { 0.0 };
    // Numbers with a fixed number of places after the point have fewer digits where they are small.
    let place = probe.iter().map(|raw| raw.place).fold(f64::INFINITY, f64::min);
    let size = median(probe.iter().map(|raw| raw.vector.norm()).filter(|size| *size > 0.0));
    let of_place = if digits < FEWEST_DIGITS
        || place.partial_cmp(&size) != Some(std::cmp::Ordering::Less)
        || size.is_infinite()
    {
        0.0
    } else {
        place / size
    };
    f64::EPSILON.max(of_digits).max(of_single).max(of_place)
}
