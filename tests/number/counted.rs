//! Numbers that count what is done with them.

use tumbling::number::counted::Counted;

#[test]
fn a_counting_number_compares_by_its_value() {
    use num_traits::One;
    assert_eq!(Counted::new(1.0), Counted::one());
    assert!(Counted::new(1.0).is_one());
    assert!(Counted::new(0.5) < Counted::one());
}
