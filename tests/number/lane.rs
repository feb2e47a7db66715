//! `f64` as a lane of one, against exact fractions.

use crate::common::exact;
use proptest::prelude::*;
use tumbling::laws::Lane;

proptest! {
    #[test]
    fn a_product_and_its_error_are_the_product_exactly(x in -1e100..1e100_f64, y in -1e100..1e100_f64) {
        let product = x * y;
        let error = x.two_product_error(y, product);
        prop_assert_eq!(exact(product) + exact(error), exact(x) * exact(y));
    }
}

#[test]
fn signs_of_zeros_and_ties_are_those_of_the_standard() {
    assert_eq!([0.0, -0.0, 2.5, -3.0].map(Lane::sign), [1.0, -1.0, 1.0, -1.0]);
    assert_eq!([0.5, 1.5, -2.5, 3e300].map(Lane::round_ties_even), [0.0, 2.0, -2.0, 3e300]);
    assert!(!f64::NAN.lt(1.0) && !1.0.lt(f64::NAN));
}
