//! How polynomials are written, as text and as TeX: largest terms first.

use super::monomial::Monomial;
use super::polynomial::Polynomial;
use super::rational;
use super::tex::Tex;
use num_rational::BigRational;
use num_traits::{One, Signed};
use std::fmt;

/// The terms joined by their signs, each written by `term` without its sign.
fn joined(p: &Polynomial, term: impl Fn(&Monomial, &BigRational) -> String) -> String {
    let mut text = String::new();
    for (monomial, coefficient) in p.terms() {
        text += match (text.is_empty(), coefficient.is_negative()) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        text += &term(monomial, &coefficient.abs());
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

/// `coefficient monomial`, leaving out a 1 that goes without saying.
fn with_monomial(monomial: &Monomial, coefficient: &BigRational, number: String, letters: String) -> String {
    match (monomial.is_unit(), coefficient.is_one()) {
        (true, _) => number,
        (false, true) => letters,
        (false, false) => format!("{number} {letters}"),
    }
}

impl fmt::Display for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = joined(self, |m, c| with_monomial(m, c, c.to_string(), m.to_string()));
        f.pad(&text)
    }
}

impl Tex for Polynomial {
    fn tex(&self) -> String {
        joined(self, |m, c| with_monomial(m, c, rational::tex(c), m.tex()))
    }
}
