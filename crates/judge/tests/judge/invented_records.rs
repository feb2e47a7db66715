//! Records invented by chance: none is named by another rule than its own, and none that fails is praised.
//! `cargo run --release -p tumbling-judge --example invented 20000` makes as many as you like.

use crate::common::invented::counted;

#[test]
fn invented_records_are_named_by_their_rule_or_among_its_equals_and_those_of_unknown_rules_by_none() {
    // Of equal steps, of times, rows and limits that look like others, and of faults below the digits.
    let known =
        "700187 4004525 4005479 4008321 4011431 4019535 91000906 129044 7203771 7208620 7211699 7211700 \
        7213897 7215798 7216016 7216920 7219238 7204734 7206389 7207137 8203108 8200747 8214116 8218934 8401598 8401985"
            .split_whitespace()
            .map(|x| (x.parse().unwrap(), true));
    let outside = [5_001_917, 5_003_241, 1_795_807_711, 7_302_663].map(|seed| (seed, false));
    for (seed, is_known) in known.chain(outside) {
        assert_eq!(counted(seed, 1, is_known, &mut std::io::sink()).unwrap()[3..5], [0, 0], "{seed}");
    }
    // The second parts have some that were once named wrongly.
    for (parts, is_known) in [([(0, 40), (60_570, 80)], true), ([(0, 10), (80_800, 50)], false)] {
        let mut list = Vec::new();
        let [a, b] = parts.map(|(first, count)| counted(first, count, is_known, &mut list).unwrap());
        let [rightly, among, not, wrongly, praised, .., misplaced]: [_; 9] =
            std::array::from_fn(|i| a[i] + b[i]);
        assert_eq!([wrongly, praised, misplaced], [0; 3], "{}", String::from_utf8_lossy(&list));
        let count: u64 = parts.iter().map(|part| part.1).sum();
        let [rightly, all, not] = [rightly, rightly + among, not].map(|x| 100 * x / count);
        assert!(if is_known { rightly >= 35 && all >= 80 } else { not >= 93 }, "{a:?} {b:?}");
    }
}
