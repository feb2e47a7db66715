//! Regression test: a hash of many answers of scenes is the one that is committed, since the
//! bits are meant to be the same wherever `f64` follows IEEE 754. That the answers are right is for `free.rs`
//! and `driven.rs`.

#[allow(dead_code, reason = "the library's own test uses the rest")]
#[path = "../../../../tests/common/same_bits.rs"]
mod library;
#[path = "common/same_bits.rs"]
mod scenes;

/// `.ci/same-bits` has more rounds, and builds for other machines.
#[test]
fn scenes_have_the_bits_that_are_committed() {
    let committed = include_str!("../../../../tests/data/same-bits.txt");
    if let Some(line) = committed.lines().find(|line| line.starts_with("scenes 20 ")) {
        let hash = scenes::hash(20);
        assert_eq!(format!("scenes 20 {} {:016x}", hash.numbers, hash.value()), line);
        return;
    }
    panic!("no line for 20 rounds");
}
