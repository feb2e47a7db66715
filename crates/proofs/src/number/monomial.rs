//! A product of powers of variables: one kind of term of a polynomial.

use super::symbol::Symbol;
use std::cmp::Ordering;
use std::fmt;

/// A product of powers of symbols, such as `m a^2`; without any, the number 1.
///
/// Ordered by total degree and then by the power of the first symbol that differs: an order in which
/// `p < q` makes `p r < q r`, so that the largest term of a product is the product of the largest terms.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Monomial {
    /// Sorted by symbol, no power zero.
    powers: Vec<(Symbol, u32)>,
}

impl Monomial {
    /// The `power`-th power of `symbol`.
    #[must_use]
    pub fn power(symbol: Symbol, power: u32) -> Self {
        Self { powers: if power == 0 { Vec::new() } else { vec![(symbol, power)] } }
    }

    /// Its symbols, in order, with their powers, all above zero.
    pub fn powers(&self) -> impl Iterator<Item = (&Symbol, u32)> {
        self.powers.iter().map(|(symbol, power)| (symbol, *power))
    }

    /// The power of `symbol` in it: 0 if it does not occur.
    #[must_use]
    pub fn degree_in(&self, symbol: &Symbol) -> u32 {
        self.powers.binary_search_by(|(s, _)| s.cmp(symbol)).map_or(0, |place| self.powers[place].1)
    }

    /// The sum of all powers.
    #[must_use]
    pub fn degree(&self) -> u64 {
        self.powers().map(|(_, power)| u64::from(power)).sum()
    }

    /// Whether it is 1.
    #[must_use]
    pub fn is_unit(&self) -> bool {
        self.powers.is_empty()
    }

    /// This without `symbol`.
    #[must_use]
    pub fn without(&self, symbol: &Symbol) -> Self {
        Self { powers: self.powers.iter().filter(|(s, _)| s != symbol).cloned().collect() }
    }

    /// Their product.
    ///
    /// # Panics
    /// If a power exceeds 4 294 967 295: it stops rather than wrap around.
    #[must_use]
    #[expect(
        clippy::expect_used,
        reason = "such a power has no place here, and a wrong one would be believed"
    )]
    pub fn times(&self, other: &Self) -> Self {
        self.merge(other, |a, b| Some(a.checked_add(b).expect("a power above 4294967295")))
            .unwrap_or_default()
    }

    /// Their quotient, if there is no negative power in it.
    #[must_use]
    pub fn divided_by(&self, other: &Self) -> Option<Self> {
        self.merge(other, u32::checked_sub)
    }

    /// The largest monomial that divides both.
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        self.merge(other, |a, b| Some(a.min(b))).unwrap_or_default()
    }

    /// The smallest monomial that both divide.
    #[must_use]
    pub fn lcm(&self, other: &Self) -> Self {
        self.merge(other, |a, b| Some(a.max(b))).unwrap_or_default()
    }

    /// Combines the powers of each symbol of either.
    fn merge(&self, other: &Self, combine: impl Fn(u32, u32) -> Option<u32>) -> Option<Self> {
        let (mut a, mut b) = (self.powers.iter().peekable(), other.powers.iter().peekable());
        let mut powers = Vec::with_capacity(self.powers.len() + other.powers.len());
        loop {
            let (symbol, p, q) = match (a.peek(), b.peek()) {
                (None, None) => return Some(Self { powers }),
                (Some((s, p)), Some((t, q))) if s == t => (s.clone(), *p, *q),
                (Some((s, p)), Some((t, _))) if s < t => (s.clone(), *p, 0),
                (Some((s, p)), None) => (s.clone(), *p, 0),
                (_, Some((t, q))) => (t.clone(), 0, *q),
            };
            if p > 0 {
                a.next();
            }
            if q > 0 {
                b.next();
            }
            let power = combine(p, q)?;
            if power > 0 {
                powers.push((symbol, power));
            }
        }
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        self.degree().cmp(&other.degree()).then_with(|| {
            for ((s, p), (t, q)) in self.powers().zip(other.powers()) {
                // The earlier symbol is missing from the other one, which makes that the smaller.
                let order = t.cmp(s).then(p.cmp(&q));
                if order != Ordering::Equal {
                    return order;
                }
            }
            self.powers.len().cmp(&other.powers.len())
        })
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Display for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (symbol, power)) in self.powers().enumerate() {
            let space = if i == 0 { "" } else { " " };
            match power {
                1 => write!(f, "{space}{symbol}")?,
                _ => write!(f, "{space}{symbol}^{power}")?,
            }
        }
        Ok(())
    }
}
