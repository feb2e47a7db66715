//! Regression test: a hash of many answers must equal the committed one, since the bits are meant to be the
//! same wherever `f64` follows IEEE 754. The tests of the modules check that the answers are right.

use crate::common::same_bits;

/// `.ci/same-bits` has more rounds, and builds for other machines.
#[test]
fn many_answers_have_the_bits_that_are_committed() {
    let committed = include_str!("data/same-bits.txt");
    if let Some(line) = committed.lines().find(|line| line.starts_with("50 ")) {
        let hash = same_bits::hash(50);
        assert_eq!(format!("50 {} {:016x}", hash.numbers, hash.value()), line);
        return;
    }
    panic!("no line for 50 rounds");
}
