//! Prints the line of `tests/data/same-bits.txt` for a number of rounds.

fn main() {
    let rounds = std::env::args().nth(1).and_then(|rounds| rounds.parse().ok()).unwrap_or(50);
    let hash = same_bits::hash(rounds);
    println!("{rounds} {} {:016x}", hash.numbers, hash.value());
}
