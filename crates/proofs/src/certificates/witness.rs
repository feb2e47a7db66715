//! Numbers for which a claim fails.

use super::statement::Statement;
use crate::number::{Rational, Symbol};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::BTreeMap;

/// A number, or the positive root of one.
#[derive(Debug, Clone)]
pub(super) enum Value {
    Exact(BigRational),
    Root(BigRational),
}

/// A value for each variable.
pub(super) type Point = BTreeMap<Symbol, Value>;

/// The number of points that are tried with roots that are fractions, and with any.
const TRIES: [u64; 2] = [3000, 300];

/// Values for which the squares of the closed forms have roots that are fractions; others are found by
/// trying.
const CHOSEN: [(&str, i64, i64); 7] = [
    ("x1", 672, 1),
    ("p", 104, 1),
    ("q", 153, 1),
    ("sn", 3, 5),
    ("m", 625, 1521),
    ("tanh", 3, 5),
    ("sin", 3, 5),
];

/// A point that obeys what ties the variables, where nothing is divided by zero and `refutes` holds of both
/// sides.
pub(super) fn find(s: &Statement, refutes: impl Fn(&Rational, &Rational) -> bool) -> Option<Point> {
    let mut random = Random(1);
    (0..TRIES[0])
        .find_map(|k| {
            let point = tied(s, k, &mut random, false)?;
            let value = |symbol: &Symbol| match point.get(symbol) {
                Some(Value::Exact(value)) => value.clone().into(),
                _ => Rational::new(1, 0),
            };
            let [left, right] = [&s.left, &s.right].map(|side| side.evaluate(value));
            let divisors = s.divisors.iter().all(|d| !d.evaluate(value).is_zero());
            let sound = !left.is_undefined() && !right.is_undefined() && divisors;
            (sound && refutes(&left, &right)).then_some(point)
        })
        .or_else(|| (0..TRIES[1]).find_map(|k| irrational(s, k, &mut random)))
}

/// A point with roots that are no fractions, where the sides of an equation differ by more than rounding.
fn irrational(s: &Statement, k: u64, random: &mut Random) -> Option<Point> {
    let point = tied(s, k, random, true).filter(|_| !s.positive)?;
    let value = |symbol: &Symbol| match point.get(symbol) {
        Some(Value::Exact(value)) => Rational::from(value.clone()).to_f64(),
        Some(Value::Root(square)) => Rational::from(square.clone()).to_f64().sqrt(),
        None => f64::NAN,
    };
    let [left, right] = [&s.left, &s.right].map(|side| side.evaluate(value));
    let clear = |x: f64, size: f64| x.abs() > 1e-6 * size;
    let divisors = s.divisors.iter().all(|d| clear(d.evaluate(value), 1.0));
    (divisors && clear(left - right, 1.0 + left.abs() + right.abs())).then_some(point)
}

/// Free variables chosen, the others as their squares say; `None` if one has no such root.
fn tied(s: &Statement, k: u64, random: &mut Random, any_root: bool) -> Option<Point> {
    let mut point = Point::new();
    let below = [1, 1, 2, 5, 3, 6, 9][usize::try_from(k).unwrap_or(0) % 7];
    for symbol in s.symbols.iter().filter(|symbol| s.squares.iter().all(|(tied, _)| tied != *symbol)) {
        let chosen = CHOSEN.iter().find(|(name, ..)| *name == symbol.name() && k.is_multiple_of(2));
        let n = i64::try_from(random.next() % 7 + 1).unwrap_or(1);
        let (n, d) = match (chosen, of_a_body(symbol.name())) {
            (Some((_, n, d)), _) => (*n, *d),
            (None, Some(Part::Moment)) => (4 + n % 4, 1),
            (None, Some(Part::Inverse)) => (1, 4 + n % 4),
            (None, Some(Part::Product)) => (1, 300),
            (None, None) => (n, below),
        };
        point.insert(symbol.clone(), Value::Exact(BigRational::new(n.into(), d.into())));
    }
    for (at, (symbol, square)) in s.squares.iter().rev().enumerate() {
        let value = |symbol: &Symbol| match point.get(symbol) {
            Some(Value::Exact(value)) => Some(Rational::from(value.clone())),
            _ => None,
        };
        let square = square.evaluate(value)?;
        let value = match (square.root(), square.value()) {
            // A sign is either, in turn.
            (Some(root), _) if !s.positive && square.is_one() && k >> at.min(63) & 1 == 1 => {
                Value::Exact(-root.value()?.clone())
            }
            (Some(root), _) => Value::Exact(root.value()?.clone()),
            (None, Some(square)) if any_root && square.is_positive() => Value::Root(square.clone()),
            _ => return None,
        };
        point.insert(symbol.clone(), value);
    }
    is_a_body(&point).then_some(point)
}

/// What a variable is of a body, by its name. Any three numbers from 4 to 7 are moments of a body, their
/// inverses those of one, and with products so small so are tensors.
#[derive(PartialEq)]
enum Part {
    Moment,
    Inverse,
    Product,
}

fn of_a_body(name: &str) -> Option<Part> {
    let is = |letter: &str, ends: &[&str]| ends.iter().any(|end| name.strip_suffix(end) == Some(letter));
    let (numbers, entries) = (["", "1", "2", "3"], ["_xx", "_yy", "_zz"]);
    match name {
        _ if ["_xy", "_xz", "_yz"].iter().any(|entry| name.ends_with(entry)) => Some(Part::Product),
        _ if is("J", &numbers[1..]) || is("J", &entries) => Some(Part::Inverse),
        _ if is("I", &numbers) || is("K", &numbers[1..]) || is("I", &entries) => Some(Part::Moment),
        _ => None,
    }
}

/// Whether moments that are squares of variables, or sums of them, are those of a body.
fn is_a_body(point: &Point) -> bool {
    let square = |name: &str| match point.get(&Symbol::new(name)) {
        Some(Value::Exact(value)) => Some(value * value),
        Some(Value::Root(square)) => Some(square.clone()),
        None => None,
    };
    let exact = |name: &str| match point.get(&Symbol::new(name)) {
        Some(Value::Exact(value)) => Some(value.clone()),
        _ => None,
    };
    let roots = ["x1", "x2", "x3"].map(square);
    let sums = match ["I1", "a", "b"].map(exact) {
        [Some(i), Some(a), Some(b)] if !point.contains_key(&Symbol::new("I2")) => {
            [Some(i.clone()), Some(&i + &a), Some(i + a + b)]
        }
        _ => [None, None, None],
    };
    [roots, sums].iter().all(|moments| match moments {
        [Some(a), Some(b), Some(c)] => a + b >= *c && b + c >= *a && c + a >= *b,
        _ => true,
    })
}

/// Numbers in no order, but those of every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }
}
