//! Variables that are tied to each other: sine and cosine, the components of a unit quaternion.

use super::fraction::Fraction;
use super::polynomial::Polynomial;
use super::symbol::Symbol;
use num_traits::{One, Zero};
use std::fmt;

/// Rules such as `c^2 = 1 - s^2`, under which more expressions are equal.
///
/// A reduced polynomial contains each `c` only with power 0 or 1. The right side of a rule contains neither
/// its own symbol nor that of an earlier rule, so reduction ends and its result is unique: two polynomials
/// are equal under the rules exactly if they reduce to the same.
///
/// ```
/// use tumbling_proofs::{Polynomial, Relations};
/// let circle = Relations::circle("c", "s");
/// let [c, s] = ["c", "s"].map(Polynomial::variable);
/// assert_eq!(circle.reduce(&(c.pow(2) + s.pow(2))), Polynomial::from(1));
/// assert_eq!(circle.reduce(&c.pow(3)).to_string(), "-c s^2 + c");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Relations {
    squares: Vec<(Symbol, Polynomial)>,
}

/// A rule that would not end: its right side holds its own symbol or that of an earlier rule.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Circular {
    /// The symbol whose square the rule replaces.
    pub of: Symbol,
    /// The symbol that its right side must not hold.
    pub holds: Symbol,
}

impl fmt::Display for Circular {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the rule for {}^2 brings {} back", self.of, self.holds)
    }
}

impl std::error::Error for Circular {}

impl Relations {
    /// No rules.
    #[must_use]
    pub fn none() -> Self {
        Self::default()
    }

    /// These rules: the square of each symbol with what it equals.
    ///
    /// # Errors
    /// A right side that holds its own symbol or that of an earlier rule; the same symbol twice.
    pub fn new<S: Into<Symbol>>(squares: Vec<(S, Polynomial)>) -> Result<Self, Circular> {
        let squares: Vec<_> = squares.into_iter().map(|(of, right)| (of.into(), right)).collect();
        for (i, (of, right)) in squares.iter().enumerate() {
            for (holds, _) in &squares[..=i] {
                if right.degree_in(holds) > 0 {
                    return Err(Circular { of: of.clone(), holds: holds.clone() });
                }
            }
            if squares[..i].iter().any(|(earlier, _)| earlier == of) {
                return Err(Circular { of: of.clone(), holds: of.clone() });
            }
        }
        Ok(Self { squares })
    }

    /// `c^2 = 1 - s^2`: cosine and sine, or `sech` and `tanh`, or `cn` and `sn`. The names must differ.
    #[must_use]
    pub fn circle(c: &str, s: &str) -> Self {
        Self { squares: vec![(c.into(), Polynomial::one() - Polynomial::variable(s).pow(2))] }
    }

    /// `w^2 = 1 - x^2 - y^2 - z^2`: the components of a unit quaternion, `w` first. The names must differ.
    #[must_use]
    pub fn unit_quaternion([w, x, y, z]: [&str; 4]) -> Self {
        let [x, y, z] = [x, y, z].map(|name| Polynomial::variable(name).pow(2));
        Self { squares: vec![(w.into(), Polynomial::one() - x - y - z)] }
    }

    /// The reduced form of `p`; zero exactly if the rules make `p` zero.
    #[must_use]
    pub fn reduce(&self, p: &Polynomial) -> Polynomial {
        let mut reduced = p.clone();
        for (symbol, square) in &self.squares {
            if reduced.degree_in(symbol) < 2 {
                continue;
            }
            let parts = reduced.in_powers_of(symbol);
            let once = Polynomial::from(symbol.clone());
            // Horner's rule in the square, for even and odd powers apart.
            let every_other = |first: usize| {
                let chosen: Vec<_> = parts.iter().skip(first).step_by(2).collect();
                chosen.into_iter().rev().fold(Polynomial::zero(), |sum, part| sum * square + part)
            };
            reduced = every_other(0) + every_other(1) * once;
        }
        reduced
    }

    /// What is left of a fraction: numerator and denominator reduced, undefined if the latter vanishes.
    #[must_use]
    pub fn reduce_fraction(&self, x: &Fraction) -> Fraction {
        Fraction::new(self.reduce(x.numerator()), self.reduce(x.denominator()))
    }
}

/// A rate of change: what the derivative of each symbol is; the rest follows by the chain rule.
///
/// ```
/// use tumbling_proofs::{Derivation, Fraction};
/// let [c, s] = ["c", "s"].map(Fraction::variable);
/// let by_angle = Derivation::new([("c", -s.clone()), ("s", c.clone())]);
/// assert_eq!(by_angle.of(&(c.clone() * s.clone())), c.pow(2) - s.pow(2));
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Derivation {
    rates: Vec<(Symbol, Fraction)>,
}

impl Derivation {
    /// By the rates of the symbols that change; all others are constant.
    #[must_use]
    pub fn new<const N: usize>(rates: [(&str, Fraction); N]) -> Self {
        Self { rates: rates.map(|(name, rate)| (name.into(), rate)).to_vec() }
    }

    /// This with one more symbol that changes.
    #[must_use]
    pub fn and(mut self, name: &str, rate: Fraction) -> Self {
        self.rates.push((name.into(), rate));
        self
    }

    /// By the argument of Jacobi's elliptic functions with parameter `m`: `sn' = cn dn`, `cn' = -sn dn`,
    /// `dn' = -m sn cn`, each times `factor`, the rate of that argument.
    #[must_use]
    pub fn elliptic(factor: &Fraction) -> Self {
        let [sn, cn, dn, m] = ["sn", "cn", "dn", "m"].map(Fraction::variable);
        let rate = |x: &Fraction, y: &Fraction| x * y * factor.clone();
        Self::new([("sn", rate(&cn, &dn)), ("cn", -rate(&sn, &dn)), ("dn", -(m * rate(&sn, &cn)))])
    }

    /// By the argument of the hyperbolic functions: `sech' = -sech tanh`, `tanh' = sech^2`, each times
    /// `factor`, the rate of that argument.
    #[must_use]
    pub fn hyperbolic(factor: &Fraction) -> Self {
        let [sech, tanh] = ["sech", "tanh"].map(Fraction::variable);
        let falls = -(&sech * &tanh * factor.clone());
        Self::new([("sech", falls), ("tanh", &sech * &sech * factor.clone())])
    }

    /// The rate of change of `x`.
    #[must_use]
    pub fn of(&self, x: &Fraction) -> Fraction {
        let parts = self.rates.iter().map(|(symbol, rate)| x.derivative(symbol) * rate.clone());
        parts.fold(Fraction::zero(), |sum, part| sum + part)
    }
}
