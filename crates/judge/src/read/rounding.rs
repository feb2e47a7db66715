//! How exact the numbers of a record are, by the digits that are written, and what is rounding in its steps.

use crate::read::{Raw, median};
use crate::thresholds::*;

/// The rounding of a record's numbers: of attitudes and of vectors each on their own, and the larger of both.
/// Attitudes that turn vectors (`in_world`) to the body do so by angles, which are off by twice as much.
pub(crate) fn rounding(probe: &[Raw], in_world: bool) -> f64 {
    let vector = median(&mut probe.iter().map(|raw| raw.vector.norm()).filter(|size| *size > 0.0));
    let moves = [
        probe.windows(2).any(|two| two[0].attitude != two[1].attitude),
        probe.windows(2).any(|two| two[0].vector != two[1].vector),
    ];
    // Numbers that stay as they are may fit any precision.
    let all_stay = moves == [false; 2];
    let groups = [(0, 1.0), (1, vector)].into_iter().filter(|(group, _)| moves[*group] || all_stay);
    // Single precision is known by its size, which stays.
    let own = |(group, size)| match rounding_of(probe, group, size, all_stay) {
        own if in_world && group == 0 && own != f64::from(f32::EPSILON) => 2.0 * own,
        own => own,
    };
    groups.map(own).fold(f64::EPSILON, f64::max)
}

/// The rounding of the attitudes' numbers.
pub(crate) fn of_attitudes(probe: &[Raw]) -> f64 {
    rounding_of(probe, 0, 1.0, false).max(f64::EPSILON)
}

/// The rounding of numbers that have this number of digits, or that single precision holds.
fn rounding_of(probe: &[Raw], group: usize, size: f64, stays: bool) -> f64 {
    let all = probe.iter().map(|raw| raw.exact[group]);
    let digits = all.clone().map(|exact| exact.digits).max().unwrap_or(MOST_DIGITS).min(MOST_DIGITS);
    // Few digits may be all there are where nothing moves: 0.5 has one.
    if stays && digits < FEWEST_DIGITS {
        return 0.0;
    }
    // The first digit of an attitude's numbers stands for tenths.
    let first = i32::from(group == 1);
    let bits = all.clone().map(|exact| exact.bits).max().unwrap_or(u32::MAX);
    let last = 10.0_f64.powi(first - i32::try_from(digits).unwrap_or(17));
    let of_digits = if digits >= DIGITS_OF_DOUBLE { 0.0 } else { last };
    let of_bits = match bits {
        ..=BITS_OF_HALF if digits >= FEWEST_DIGITS && !stays => HALF,
        ..=BITS_OF_SINGLE if digits > DIGITS_OF_SINGLE => f64::from(f32::EPSILON),
        _ => 0.0,
    };
    // Numbers with a fixed number of places after the point have fewer digits where they are small.
    let place = all.map(|exact| exact.place).fold(f64::INFINITY, f64::min);
    let of_place = if place < size && size.is_finite() { place / size } else { 0.0 };
    of_digits.max(of_bits).max(of_place)
}

/// The rounding of a record's numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Floor {
    /// Of the spins, relative to them.
    pub size: f64,
    /// Of the attitudes, relative to 1.
    pub attitude: f64,
    /// Whether it is of a few decimal digits, fewer than single precision has.
    pub few: bool,
    /// Whether it is that of single precision.
    pub single: bool,
}

impl Floor {
    /// Whether an engine's own rounding is far below it: the digits are fewer than single precision has, or
    /// more, and fewer than double precision has.
    pub(crate) fn is_of_writing(self) -> bool {
        self.few || (FITS_FEW_FROM..BELOW_SINGLE).contains(&self.size)
    }

    /// How far half of a rule's own steps are from the record's, and 95 in 100, where nothing multiplies the
    /// rounding.
    pub(crate) fn closely(self) -> [f64; 2] {
        self.units(CLOSELY_SINGLE, CLOSELY)
    }

    /// How far half of a rule's own steps may be from the record's, and how far 95 in 100, with what a step
    /// that multiplies the rounding makes of it. A few decimal digits are off by half a one of the last place
    /// and not more, and of what they leave open a wrong rule may be all.
    pub(crate) fn limits(self) -> [f64; 2] {
        self.units(FITS_SINGLE, FITS)
    }

    fn units(self, of_single: [f64; 2], of_double: [f64; 2]) -> [f64; 2] {
        let units = match self.single {
            true => of_single,
            false if self.size > FITS_FEW_FROM => FITS_FEW,
            false => of_double,
        };
        units.map(|units| units * self.size)
    }
}

/// How many digits from the first that is not zero, before an exponent.
pub(crate) fn significant(field: &str) -> u32 {
    let digits = field.split(['e', 'E']).next().unwrap_or_default().chars().filter(char::is_ascii_digit);
    digits.skip_while(|digit| *digit == '0').count() as u32
}

/// How many bits of a number's binary digits are significant.
pub(crate) const fn significant_bits(x: f64) -> u32 {
    // The first one is not written.
    let rest = u64::BITS - (x.to_bits() << 12).trailing_zeros();
    if x == 0.0 { 0 } else { 1 + rest }
}

/// What a one is worth in the last place: 0.001 in 1.250, 1e-9 in 1.5e-8.
pub(crate) fn last_place(field: &str) -> f64 {
    let (number, exponent) = field.split_once(['e', 'E']).unwrap_or((field, "0"));
    let places = number.split_once('.').map_or(0, |(_, after)| after.len());
    let exponent: i32 = exponent.parse().unwrap_or(0);
    10.0_f64.powi(exponent.saturating_sub(i32::try_from(places).unwrap_or(i32::MAX)))
}
