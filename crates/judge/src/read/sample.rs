//! Steps of a record of any length, evenly from all of it.

use crate::read::Pair;
use crate::thresholds::TRIED_STEPS;

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::Row;
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
