//! Records invented by chance: none is named by another rule than its own, and none that fails is praised.
//! `cargo run --release -p tumbling-judge --example invented 20000` makes as many as you like.

use crate::common::invented::{Invented, Named, praise};

/// How many of this number of records are named rightly, among equals, not, and wrongly.
fn counted(seeds: std::ops::Range<u64>, is_known: bool) -> [u32; 4] {
    let mut counts = [0; 4];
    for seed in seeds {
        let record = Invented::of(seed, is_known);
        // An attitude that turns too far from row to row is refused.
        let Ok(verdict) = record.judged() else { continue };
        let named = record.named(&verdict);
        assert_ne!(named, Named::Wrongly, "{seed}: {}\n{verdict}", record.what);
        assert_eq!(praise(&verdict), None, "{seed}: {}\n{verdict}", record.what);
        counts[named as usize] += 1;
    }
    counts
}

#[test]
fn most_invented_records_are_named_by_their_rule_or_among_its_equals_and_none_by_another() {
    let [rightly, among_equals, not, _] = counted(0..200, true);
    assert!(rightly >= 70 && rightly + among_equals >= 160 && not <= 40, "{rightly} {among_equals} {not}");
}

#[test]
fn invented_records_of_rules_that_are_not_known_are_named_by_none() {
    assert!(counted(0..80, false)[2] >= 75);
}
