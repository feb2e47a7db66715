//! The page of the judge knows its laws, and no other word of it.

use tumbling_judge::LawName;

const PAGE: &str = include_str!("../widgets/page/judge.js");

#[test]
fn the_laws_that_may_have_a_limit_are_those_of_the_judge_in_its_order() {
    let keys = LawName::ALL.map(|law| format!("\"{}\"", law.key())).join(", ");
    assert!(PAGE.contains(&format!("const LAWS = [{keys}];")), "{keys}");
}
