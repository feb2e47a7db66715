//! The numbers of this crate against sympy's, see `data/README.md`.

use crate::reader::read;
use tumbling_proofs::{Fraction, Polynomial, Relations, Series, Symbol};

fn polynomial(text: &str) -> Polynomial {
    read(text).as_polynomial().unwrap_or_else(|| panic!("{text}: not a polynomial")).clone()
}

/// A polynomial in `h` as a power series known to `h^4`.
fn series(text: &str) -> Series<Fraction> {
    let parts = polynomial(text).in_powers_of(&Symbol::new("h"));
    Series::new(parts.into_iter().map(Fraction::from).collect(), 4)
}

fn agrees(line: &str) -> bool {
    let parts: Vec<&str> = line.split(" | ").collect();
    match parts[..] {
        ["sum", a, b, c] => polynomial(a) + polynomial(b) == polynomial(c),
        ["product", a, b, c] => polynomial(a) * polynomial(b) == polynomial(c),
        ["quotient", a, b, c] => polynomial(a).exact_quotient(&polynomial(b)) == Some(polynomial(c)),
        ["derivative", p, x, c] => polynomial(p).derivative(&x.into()) == polynomial(c),
        ["integral", p, x, a, b, c] => {
            polynomial(p).integral(&x.into(), &polynomial(a), &polynomial(b)) == polynomial(c)
        }
        ["substitute", p, x, q, c] => polynomial(p).substitute(&x.into(), &polynomial(q)) == polynomial(c),
        ["remainder", p, x, q, c] => {
            let rule = Relations::new(vec![(x, polynomial(q))]).unwrap();
            rule.reduce(&polynomial(p)) == polynomial(c)
        }
        ["fraction sum", a, b, c] => read(a) + read(b) == read(c),
        ["fraction quotient", a, b, c] => read(a) / read(b) == read(c),
        ["fraction derivative", a, x, c] => read(a).derivative(&x.into()) == read(c),
        ["series", a, b, ref c @ ..] => {
            let quotient = series(a) / series(b);
            c.len() == 5 && c.iter().enumerate().all(|(n, c)| quotient.coefficient(n) == Some(read(c)))
        }
        _ => panic!("an operation not known: {line}"),
    }
}

const TABLE: &str = include_str!("../data/sympy_tables.txt");

#[test]
fn every_operation_gives_what_sympy_gives() {
    assert_eq!(TABLE.lines().count(), 260);
    for line in TABLE.lines() {
        assert!(agrees(line), "{line}");
    }
}

#[test]
fn a_result_that_is_off_by_one_term_is_noticed() {
    for line in TABLE.lines() {
        assert!(!agrees(&format!("{line} + x^5")), "{line}");
    }
}
