//! Steps of a record of any length, evenly from all of it; and what is rounding in them.

use crate::state::Pair;
use crate::thresholds::{CLOSELY, CLOSELY_SINGLE, FITS, FITS_FEW, FITS_FEW_FROM, FITS_SINGLE, TRIED_STEPS};

/// Pairs of rows from all of a record of any length.
#[derive(Debug)]
pub(crate) struct Sample {
    pairs: Vec<Pair>,
    every: u64,
    seen: u64,
}

impl Sample {
    pub(crate) const fn new() -> Self {
        Self { pairs: Vec::new(), every: 1, seen: 0 }
    }

    pub(crate) fn push(&mut self, pair: &Pair) {
        if self.seen.is_multiple_of(self.every) {
            if self.pairs.len() == TRIED_STEPS {
                let mut place = 0;
                self.pairs.retain(|_| {
                    place += 1;
                    place % 2 == 1
                });
                self.every *= 2;
            }
            if self.seen.is_multiple_of(self.every) {
                self.pairs.push(*pair);
            }
        }
        self.seen += 1;
    }

    pub(crate) const fn seen(&self) -> u64 {
        self.seen
    }

    pub(crate) fn pairs(&self) -> &[Pair] {
        &self.pairs
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::Row;
    use nalgebra::Vector3;

    #[test]
    fn a_sample_is_no_larger_however_long_the_record_and_from_all_of_it() {
        let mut sample = Sample::new();
        for line in 0..1_000_000 {
            let state = Row { line, t: 0.0, attitude: None, omega: Vector3::zeros(), ahead: None };
            sample.push(&Pair { from: state, to: state, h: 1.0 });
            assert!(sample.pairs().len() <= TRIED_STEPS);
        }
        assert_eq!(sample.seen(), 1_000_000);
        let lines: Vec<usize> = sample.pairs().iter().map(|pair| pair.from.line).collect();
        assert!(lines.len() > TRIED_STEPS / 4 && lines[0] == 0 && lines[lines.len() - 1] > 990_000);
        let apart: Vec<usize> = lines.windows(2).map(|x| x[1] - x[0]).collect();
        assert!(apart.iter().all(|&x| x == apart[0]), "evenly");
    }
}
