//! Judges invented records by the thousand, and counts how their rules are named:
//! `cargo run --release -p tumbling-judge --example invented 20000`. With `outside` behind the number they
//! are of rules that the judge does not know; with a seed behind it they begin there, and one record is
//! printed with its verdict.

#[path = "../tests/judge/common/invented.rs"]
mod invented;

use invented::{Invented, Named, praise};
use std::io::Write as _;

fn main() -> std::io::Result<()> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let mut numbers = words.iter().filter_map(|word| word.parse::<u64>().ok());
    let (count, first) = (numbers.next().unwrap_or(1000), numbers.next().unwrap_or(0));
    let is_known = !words.iter().any(|word| word == "outside");
    let mut out = std::io::stdout().lock();
    let (mut counts, mut praised, mut refused) = ([0_u64; 4], 0_u64, 0_u64);
    for seed in first..first.saturating_add(count) {
        let record = Invented::of(seed, is_known);
        let verdict = match record.judged() {
            Ok(verdict) => verdict,
            Err(why) => {
                writeln!(out, "{seed} refused: {why}: {}", record.what)?;
                refused += 1;
                continue;
            }
        };
        let (named, praise) = (record.named(&verdict), praise(&verdict));
        counts[named as usize] += 1;
        praised += u64::from(praise.is_some());
        if count == 1 {
            writeln!(out, "{}\n{}\n{named:?}\n{verdict}", record.text, record.what)?;
        } else if named == Named::Wrongly || named == Named::Not && is_known || praise.is_some() {
            let rule = verdict.diagnosis.map_or(String::new(), |found| {
                format!("{}: {} ({})", found.confidence.key(), found.best.rule.name(), found.alike.len())
            });
            writeln!(out, "{seed} {named:?} {praise:?}: {}\n    {rule}", record.what)?;
        }
    }
    let [rightly, among, not, wrongly] = counts;
    writeln!(
        out,
        "{rightly} rightly, {among} among equals, {not} not, {wrongly} wrongly; praised beside a failure {praised}; refused {refused}"
    )
}
