//! How exact the numbers of a record are, and what is rounding in its steps.

use crate::read::{Raw, median};
use crate::thresholds::{
    CLOSELY, CLOSELY_SINGLE, DIGITS_OF_DOUBLE, DIGITS_OF_SINGLE, FEWEST_DIGITS, FITS, FITS_FEW,
    FITS_FEW_FROM, FITS_SINGLE, MOST_DIGITS,
};

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

/// The rounding of a record's numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Floor {
    /// Relative to 1.
    pub size: f64,
    /// Whether it is of a few decimal digits, fewer than single precision has.
    pub few: bool,
    /// Whether it is that of single precision.
    pub single: bool,
}

impl Floor {
    /// One number for all digits, another for few.
    pub(crate) const fn either<T: Copy>(self, all: T, few: T) -> T {
        if self.few { few } else { all }
    }

    /// Whether every step is a rule's, except for rounding and what a step that multiplies it makes of it:
    /// half of them are within `median`, 95 in 100 within `percentile_95`. A few decimal digits are off by
    /// half a one of the last place and not more, and of what they leave open a wrong rule may be all.
    pub(crate) fn fits(self, median: f64, percentile_95: f64) -> bool {
        let [half, nearly_all] = self.limits();
        median <= half && percentile_95 <= nearly_all
    }

    /// How far half of a rule's own steps are from the record's, and 95 in 100, where nothing multiplies the
    /// rounding.
    pub(crate) fn closely(self) -> [f64; 2] {
        let units = match self.single {
            true => CLOSELY_SINGLE,
            false if self.size > FITS_FEW_FROM => FITS_FEW,
            false => CLOSELY,
        };
        units.map(|units| units * self.size)
    }

    /// How far half of a rule's own steps may be from the record's, and how far 95 in 100.
    pub(crate) fn limits(self) -> [f64; 2] {
        let units = match self.single {
            true => FITS_SINGLE,
            false if self.size > FITS_FEW_FROM => FITS_FEW,
            false => FITS,
        };
        units.map(|units| units * self.size)
    }
}
