//! The page of the judge has words for whatever the JSON can say.

use tumbling_judge::{LawName, Outcome, Sure};

const VERDICT: &str = include_str!("../widgets/page/judge.verdict.js");
const PAGE: &str = include_str!("../widgets/page/judge.js");

/// The keys of a table `const NAME = { key: "words", "other key": "words" };` or `[["key", "words"], ...]` of a script.
fn has(script: &str, name: &str, key: &str) -> bool {
    let (_, rest) = script.split_once(&format!("const {name} = ")).unwrap();
    let (table, _) = rest.split_once(";\n").unwrap();
    table.contains(&format!("\"{key}\":"))
        || table.contains(&format!("[\"{key}\","))
        || table.split(['{', ',', '\n']).any(|part| part.trim().starts_with(&format!("{key}:")))
}

#[test]
fn every_outcome_and_every_degree_of_certainty_has_its_words() {
    for outcome in Outcome::ALL {
        assert!(has(VERDICT, "OUTCOMES", outcome.key()), "{}", outcome.key());
        assert!(has(PAGE, "parts", outcome.key()), "the count of several records: {}", outcome.key());
    }
    for sure in Sure::ALL {
        assert!(has(VERDICT, "RULES", sure.key()), "{}", sure.key());
    }
    assert!(!has(VERDICT, "OUTCOMES", "no such"));
}

#[test]
fn the_laws_that_may_have_a_limit_are_those_of_the_judge_in_its_order() {
    let keys = LawName::ALL.map(|law| format!("\"{}\"", law.key())).join(", ");
    assert!(PAGE.contains(&format!("const LAWS = [{keys}];")), "{keys}");
}
