//! What is read off a sampled motion.

use tumbling::dynamics::observe::sign_changes;

#[test]
fn a_sample_of_exactly_zero_is_where_the_sign_changes() {
    assert_eq!(sign_changes([(0.0, 1.0), (1.0, 0.0), (1.1, -1.0)]), [1.0]);
    assert_eq!(sign_changes([(0.0, -1.0), (1.0, 0.0), (2.0, 0.0), (3.0, 4.0)]), [2.0]);
    // Touching zero and turning back is no change.
    assert!(sign_changes([(0.0, 1.0), (1.0, 0.0), (2.0, 1.0)]).is_empty());
    assert!(sign_changes([(0.0, 0.0), (1.0, 1.0)]).is_empty());
}

#[test]
fn changes_between_the_ends_of_the_range_are_where_the_straight_line_has_them() {
    assert_eq!(sign_changes([(0.0, 1e308), (1.0, -1e308)]), [0.5]);
    assert_eq!(sign_changes([(-1e308, 1.0), (1e308, -1.0)]), [0.0]);
    assert_eq!(sign_changes([(0.0, 1e-300), (1.0, f64::NAN), (2.0, -3e-300)]), [0.5]);
}
