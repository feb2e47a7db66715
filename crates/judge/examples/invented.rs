//! Judges invented records by the thousand, and counts how their rules are named:
//! `cargo run --release -p tumbling-judge --example invented 20000`. With `outside` behind the number they
//! are of rules that the judge does not know; with a seed behind it they begin there, and one record is
//! printed with its verdict.

#[path = "../tests/judge/common/invented/mod.rs"]
mod invented;

fn main() -> std::io::Result<()> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let mut numbers = words.iter().filter_map(|word| word.parse::<u64>().ok());
    let (count, first) = (numbers.next().unwrap_or(1000), numbers.next().unwrap_or(0));
    let is_known = !words.iter().any(|word| word == "outside");
    let counts = invented::counted(first, count, is_known, &mut std::io::stdout().lock())?;
    println!("rightly, among equals, not, wrongly, praised although failed, refused: {:?}", &counts[..6]);
    println!("place of damping rightly, not, wrongly: {:?}", &counts[6..]);
    Ok(())
}
