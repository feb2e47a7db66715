//! Prints a line of `tests/data/same-bits.txt`: `[scenes] ROUNDS`.

fn main() {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    let of_scenes = words.first().is_some_and(|word| word == "scenes");
    let rounds = words.pop().and_then(|rounds| rounds.parse().ok()).unwrap_or(50);
    let hash = same_bits::hash(rounds, of_scenes);
    let what = if of_scenes { "scenes " } else { "" };
    println!("{what}{rounds} {} {:016x}", hash.numbers, hash.value());
}
