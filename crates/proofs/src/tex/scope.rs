//! The meanings of the names in an equation.

use super::value::Value;
use crate::number::{Fraction, Monomial, Polynomial, Relations};
use num_traits::Signed;

/// The meaning of each name, the relations of the variables, and which of them are positive.
#[derive(Debug, Clone, Default)]
pub struct Scope {
    pub(super) names: Vec<(String, Value)>,
    pub(super) pieces: Vec<Vec<(String, Value)>>,
    pub(super) relations: Relations,
    positive: Vec<String>,
}

impl Scope {
    /// The name for the value that a bare expression must have; no name in TeX is written so.
    pub const IT: &'static str = "it";

    /// With a name, as it is written in TeX without spaces. A later meaning hides an earlier one.
    #[must_use]
    pub fn with(mut self, name: &str, value: impl Into<Value>) -> Self {
        self.names.push((name.to_owned(), value.into()));
        self
    }

    /// With these numbers.
    #[must_use]
    pub fn with_all<const N: usize>(self, names: [(&str, Fraction); N]) -> Self {
        names.into_iter().fold(self, |scope, (name, x)| scope.with(name, x))
    }

    /// With variables, each under its own name.
    #[must_use]
    pub fn with_letters<const N: usize>(self, names: [&str; N]) -> Self {
        self.with_all(names.map(|name| (name, Fraction::variable(name))))
    }

    /// With the components of a vector, each under the name with its number from one on.
    #[must_use]
    pub fn with_each<'a>(self, name: &str, values: impl IntoIterator<Item = &'a Fraction>) -> Self {
        (1..).zip(values).fold(self, |scope, (n, x)| scope.with(&format!("{name}_{n}"), x.clone()))
    }

    /// With functions that are variables of the same names, of this argument: `\operatorname{sn}(u)`.
    #[must_use]
    pub(crate) fn with_functions(self, names: &[&str], argument: &str) -> Self {
        names.iter().fold(self, |scope, name| {
            scope.with(&format!(r"\operatorname{{{name}}}{argument}"), Fraction::variable(name))
        })
    }

    /// With one more piece for `\sum` to run over, where these names mean this.
    #[must_use]
    pub fn with_piece<const N: usize>(mut self, names: [(&str, Fraction); N]) -> Self {
        self.pieces.push(names.map(|(name, x)| (name.to_owned(), x.into())).to_vec());
        self
    }

    /// With the relations of its variables.
    #[must_use]
    pub fn under(mut self, relations: Relations) -> Self {
        self.relations = relations;
        self
    }

    /// With variables that are above zero.
    #[must_use]
    pub fn positive<const N: usize>(mut self, variables: [&str; N]) -> Self {
        self.positive.extend(variables.map(str::to_owned));
        self
    }

    /// The meaning of a name.
    pub(crate) fn meaning(&self, name: &str) -> Option<&Value> {
        self.names.iter().rev().find(|(known, _)| known == name).map(|(_, value)| value)
    }

    /// The names of a piece put over the others.
    pub(super) fn inside(&self, piece: &[(String, Value)]) -> Self {
        let mut scope = self.clone();
        scope.names.extend_from_slice(piece);
        scope.pieces.clear();
        scope
    }

    /// Whether the coefficients show that `x` is not below zero, and whether even above.
    fn sign_shown(&self, p: &Polynomial) -> (bool, bool) {
        let positive = |s: &str| self.positive.iter().any(|name| name == s);
        let not_negative = |m: &Monomial| m.powers().all(|(s, power)| power % 2 == 0 || positive(s.name()));
        let above = |m: &Monomial| m.powers().all(|(s, _)| positive(s.name()));
        let shown = p.terms().all(|(m, c)| c.is_positive() && not_negative(m));
        (shown, shown && p.terms().any(|(m, _)| above(m)))
    }

    /// Whether `x` is shown to be positive or, unless `strict`, zero: every term is a positive number times
    /// squares and positive variables.
    pub(super) fn is_above(&self, x: &Fraction, strict: bool) -> bool {
        let x = self.relations.reduce_fraction(x);
        let shown = |sign: i64| {
            let scaled = |p: &Polynomial| p.clone() * Polynomial::from(sign);
            let (not_negative, positive) = self.sign_shown(&scaled(x.numerator()));
            let (_, below) = self.sign_shown(&scaled(x.denominator()));
            below && if strict { positive } else { not_negative }
        };
        !x.is_undefined() && (shown(1) || shown(-1))
    }
}
