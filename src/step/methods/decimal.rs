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

/// The root of 3.
pub(crate) const ROOT_OF_3: Decimal =
    Decimal { negative: false, whole: 1, groups: [732_050_807, 568_877_293, 527_446_341] };

/// The root of 15.
pub(crate) const ROOT_OF_15: Decimal =
    Decimal { negative: false, whole: 3, groups: [872_983_346, 207_416_885, 179_265_399] };

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;

    #[test]
    fn the_roots_have_squares_that_are_whole_to_their_last_digit() {
        for (root, square) in [(ROOT_OF_3, 3), (ROOT_OF_15, 15)] {
            let billion = BigInt::from(1_000_000_000);
            let digits = root.groups.iter().fold(BigInt::from(root.whole), |n, &g| n * &billion + g);
            let wanted = BigInt::from(square) * billion.pow(6);
            assert!(digits.clone() * &digits <= wanted);
            assert!((digits.clone() + 1) * (digits + 1) > wanted);
        }
        assert_eq!(ROOT_OF_3.value::<f64>(), 3.0_f64.sqrt());
        assert_eq!(ROOT_OF_15.value::<f64>(), 15.0_f64.sqrt());
    }
}
