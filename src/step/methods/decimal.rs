//! Constants that are no fractions, as exact decimals of 27 digits, so that one definition serves every
//! number type.

use crate::number::Analytic;

/// Three groups of nine digits behind the point, the whole part before it, and the sign.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Decimal {
    pub(crate) negative: bool,
    pub(crate) whole: u32,
    pub(crate) groups: [u32; 3],
}

impl Decimal {
    pub(crate) fn value<T: Analytic>(&self) -> T {
        let base = T::integer(1_000_000_000);
        // From the last group on, so that the small ones are not lost one by one.
        let behind =
            self.groups.iter().rev().fold(T::zero(), |sum, &group| (sum + T::integer(group)) / base.clone());
        let size = T::integer(self.whole) + behind;
        if self.negative { -size } else { size }
    }
}
