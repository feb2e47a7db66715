//! Prints a line of `tests/data/same-bits.txt`: `[scenes] ROUNDS`.

mod hashes;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let rounds = words.last().and_then(|word| word.parse().ok()).expect("what is given: [scenes] ROUNDS");
    let hash = hashes::hash(rounds, words[0] == "scenes");
    println!("{} {} {:016x}", words.join(" "), hash.numbers, hash.value());
}
