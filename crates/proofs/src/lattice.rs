//! Products of two theta functions as sums over pairs of indices, compared term by term.
//!
//! A theta function is the sum of `± q^(n²) exp(2 i n z)` over all integers `n`, or over all halves of odd
//! ones. In the product `f(z + w) g(z - w)` of two of one nome the term of `m` and `n` has
//! `q^(m² + n²) exp(2 i (r z + s w))` with `r = m + n` and `s = m - n`, and `m² + n² = (r² + s²)/2`. Its sign
//! depends on `2r` and `2s` modulo eight alone, so that two such sums are equal in all their infinitely many
//! terms if they agree in sixty-four.

use crate::number::Fraction;
use crate::proof::{Outcome, Residue, same};
use num_traits::{One, Zero};
use std::ops::RangeInclusive;

/// The signs repeat when twice an index moves by this.
const PERIOD: i64 = 8;

/// A theta function by its sum ([DLMF] 20.2(i)); the first is `-i` times its own.
///
/// [DLMF]: https://dlmf.nist.gov/20.2
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Theta {
    /// Whether the sum is over halves of odd numbers.
    halves: bool,
    /// Whether the signs alternate.
    alternating: bool,
}

pub(crate) const THETA_1: Theta = Theta { halves: true, alternating: true };
pub(crate) const THETA_2: Theta = Theta { halves: true, alternating: false };
pub(crate) const THETA_3: Theta = Theta { halves: false, alternating: false };
pub(crate) const THETA_4: Theta = Theta { halves: false, alternating: true };

impl Theta {
    /// The sign of the term with `twice = 2n`; zero where there is none.
    fn sign(self, twice: i64) -> i64 {
        let there = (twice.rem_euclid(2) == 1) == self.halves;
        let odd = self.alternating && twice.div_euclid(2).rem_euclid(2) == 1;
        i64::from(there) * if odd { -1 } else { 1 }
    }

    /// The terms of these `2n`, in powers of the nome and of the exponential of `2 i z`; of a sum over halves
    /// without what its terms share.
    pub(crate) fn terms(self, twice: RangeInclusive<i64>, nome: &Fraction, wave: &Fraction) -> Fraction {
        let (first, back) = (i64::from(self.halves), Fraction::one() / wave);
        twice.fold(Fraction::zero(), |sum, twice| {
            let n = (twice - first) / 2;
            let power = if n < 0 { &back } else { wave }.pow(n.unsigned_abs() as u32);
            let size = nome.pow(((twice * twice - first) / 4) as u32);
            sum + size * power * Fraction::from(self.sign(twice))
        })
    }

    /// The first coefficient at zero, as a power series in the nome, but for `q^(1/4)` of a sum over halves;
    /// for a `slope` each term counts with its frequency, `2n`.
    pub(crate) fn first(self, slope: bool) -> Fraction {
        let term = |twice: i64| self.sign(twice) * if slope { twice } else { 1 };
        Fraction::from(if self.halves { term(-1) + term(1) } else { term(0) })
    }

    /// After half of the quasi-period: `n² + n = (n + 1/2)² - 1/4`, so the indices move by a half.
    pub(crate) fn after_half_a_quasi_period(self) -> Self {
        Self { halves: !self.halves, ..self }
    }

    /// What a quasi-period multiplies it by, but for `exp(-2 i z)/q`: the indices move by one.
    pub(crate) fn over_a_quasi_period(self) -> i64 {
        self.sign(i64::from(self.halves)) * self.sign(i64::from(self.halves) + 2)
    }

    /// What it is multiplied by when `z` moves by pi.
    pub(crate) fn over_a_period(self) -> i64 {
        if self.halves { -1 } else { 1 }
    }
}

/// The coefficients of `q^((r² + s²)/2) exp(2 i (r z + s w))` by `2r` and `2s` modulo eight.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Pairs([[i64; PERIOD as usize]; PERIOD as usize]);

impl Pairs {
    fn new(coefficient: impl Fn(i64, i64) -> i64, f: Theta, g: Theta) -> Self {
        // The product of two of the first kind: (-i)².
        let sign = if f == THETA_1 && g == THETA_1 { -1 } else { 1 };
        let entry = |r: usize, s: usize| sign * coefficient(r as i64, s as i64);
        Self(std::array::from_fn(|r| std::array::from_fn(|s| entry(r, s))))
    }

    /// `f(z + w) g(z - w)`.
    pub(crate) fn product(f: Theta, g: Theta) -> Self {
        let of = |r: i64, s: i64| {
            let whole = i64::from((r + s).rem_euclid(2) == 0);
            whole * f.sign((r + s).div_euclid(2)) * g.sign((r - s).div_euclid(2))
        };
        Self::new(of, f, g)
    }

    /// `f(z) g(w)` with the root of the nome.
    pub(crate) fn of_the_root(f: Theta, g: Theta) -> Self {
        Self::new(|r, s| f.sign(r) * g.sign(s), f, g)
    }

    /// `f(2z) g(2w)` with the square of the nome.
    pub(crate) fn of_the_square(f: Theta, g: Theta) -> Self {
        let of = |r: i64, s: i64| {
            let whole = i64::from(r.rem_euclid(2) == 0 && s.rem_euclid(2) == 0);
            whole * f.sign(r.div_euclid(2)) * g.sign(s.div_euclid(2))
        };
        Self::new(of, f, g)
    }

    fn at(&self, r: i64, s: i64) -> i64 {
        self.0[r.rem_euclid(PERIOD) as usize][s.rem_euclid(PERIOD) as usize]
    }

    /// With a symbol for each of the 64 terms.
    pub(crate) fn in_symbols(&self) -> Fraction {
        let terms = self.0.iter().flatten().enumerate();
        terms.fold(Fraction::zero(), |sum, (n, x)| {
            sum + Fraction::variable(&format!("c{n}")) * Fraction::from(*x)
        })
    }

    /// The sum over `s` at `w = 0` for each `2r`, term by term of equal size: of the terms themselves, or of
    /// the terms times `s`.
    fn at_zero(&self, weighed: bool) -> Vec<[i64; 5]> {
        let sign = if weighed { -1 } else { 1 };
        let row = |r: i64| std::array::from_fn(|s| self.at(r, s as i64) + sign * self.at(r, -(s as i64)));
        (0..PERIOD).map(row).collect()
    }

    /// That `f' g - f g'` is a constant times `h k`, where the products are `f(z + w) g(z - w)` and the like:
    /// by `w` at zero the first is differentiated.
    pub(crate) fn differ_by_a_constant(claim: &str, [f, g]: [Theta; 2], [h, k]: [Theta; 2]) -> Outcome {
        let (a, b) = (Self::product(f, g).at_zero(true), Self::product(h, k).at_zero(false));
        let some = |rows: &[[i64; 5]], r: usize| rows[r].iter().any(|x| *x != 0);
        let Some(first) = (0..a.len()).find(|r| some(&a, *r) && some(&b, *r)) else {
            return Err(Residue::Missing { claim: claim.to_owned() });
        };
        let mut left = 0;
        for r in 0..a.len() {
            for (i, x) in a[r].iter().enumerate() {
                for (j, y) in b[r].iter().enumerate() {
                    left += (x * b[first][j] - y * a[first][i]).abs();
                }
            }
        }
        same(claim, &Fraction::from(left), &Fraction::zero())
    }
}
