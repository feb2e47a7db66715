//! Number words: `twice`, `a twentieth`, `three axes`, `the third line`.
//!
//! Each must be in a phrase of the section's code, as numbers must, or in `words.toml` with the word after
//! it.

use regex::Regex;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::LazyLock;

/// A number word.
#[derive(Debug, Clone)]
pub struct Word {
    /// Its bytes.
    pub at: Range<usize>,
    /// The number, for a fraction its denominator; `None` for words such as `half` that have no single
    /// number.
    value: Option<f64>,
}

impl Word {
    /// Whether the word means this number; a fraction may stand for its value or for a division by its
    /// denominator.
    pub fn says(&self, number: f64) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs();
        self.value.is_some_and(|value| near(value, number) || near(value * number, 1.0))
    }
}

static WORD: LazyLock<Regex> = LazyLock::new(|| Regex::new("[A-Za-z][A-Za-z-]*").unwrap());
static COUNTED: LazyLock<Regex> = LazyLock::new(|| Regex::new(r"^ [\p{Alphabetic}-]+").unwrap());

const CARDINALS: &str = "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen \
    sixteen seventeen eighteen nineteen twenty";
const TENS: &str = "twenty thirty forty fifty sixty seventy eighty ninety";
const OTHERS: &str = "hundred 1e2 thousand 1e3 million 1e6 billion 1e9 fifth 5 tenth 10 twentieth 20 twenty-fifth 25 \
    fiftieth 50 hundredth 1e2 thousandth 1e3 millionth 1e6 billionth 1e9 twice 2 thrice 3 twofold 2 tenfold 10 \
    hundredfold 100";
const POWERS: [&str; 4] = ["hundred", "thousand", "million", "billion"];
/// Ordinals, and words without a single number.
const ORDER: &str = "first second third thirds fourth sixth seventh eighth ninth sixteenth half halves quarter quarters \
    once ones double doubled triple dozen";

/// The value of each word of these lists, if it has one, and whether its plural counts too. A table, since
/// every word of the book is looked up.
static KNOWN: LazyLock<HashMap<&str, (Option<f64>, bool)>> = LazyLock::new(|| {
    let order = ORDER.split_whitespace().map(|word| (word, (None, false)));
    let tens = TENS.split(' ').zip((20..).step_by(10));
    let plain = CARDINALS.split_whitespace().zip(0..).chain(tens);
    let others: Vec<_> = OTHERS.split_whitespace().collect();
    let parts = others.as_chunks().0.iter().map(|[word, number]| (*word, (number.parse().ok(), true)));
    order.chain(plain.map(|(word, n)| (word, (Some(f64::from(n)), false)))).chain(parts).collect()
});

/// The value of a number word, if it has a single one.
fn value(word: &str) -> Option<Option<f64>> {
    let known = |word: &str| KNOWN.get(word).map(|known| known.0);
    let plural = || word.strip_suffix('s').and_then(|one| KNOWN.get(one)).filter(|known| known.1);
    let joined = || {
        let tens = |ten: &str| known(ten)?.filter(|_| TENS.split(' ').any(|x| x == ten));
        let both = |(a, b)| Some(tens(a)? + known(b)?.filter(|n| *n < 10.0)?);
        let sum = word.split_once('-').and_then(both);
        word.split('-').any(|part| KNOWN.contains_key(part)).then_some(sum)
    };
    known(word).or_else(|| plural().map(|known| known.0)).or_else(joined)
}

/// The number words of this text.
pub fn words(text: &str) -> Vec<Word> {
    let mut found: Vec<Word> = Vec::new();
    let mut before = String::new();
    for place in WORD.find_iter(text) {
        let word = place.as_str().to_lowercase();
        // `a second` and `per second` are a unit.
        let unit = word == "second" && ["a", "each", "every", "per"].contains(&before.as_str());
        if let (false, Some(own)) = (unit, value(&word)) {
            match found.last_mut() {
                // `ten thousand`
                Some(Word { at, value }) if POWERS.contains(&&*word) && at.end + 1 == place.start() => {
                    at.end = place.end();
                    *value = value.zip(own).map(|(a, b)| a * b);
                }
                _ => found.push(Word { at: place.range(), value: own }),
            }
        }
        before = word;
    }
    found
}

/// A number word with the word after it, in lower case: the counted thing.
pub fn counted(text: &str, at: &Range<usize>) -> String {
    let after = COUNTED.find(&text[at.end..]).map_or(0, |word| word.len());
    text[at.start..at.end + after].to_lowercase()
}
