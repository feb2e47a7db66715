//! The laws of the `tumbling` library, proven for all bodies at once.
//!
//! The library writes each law once, over whatever can be added and multiplied. Here the very same
//! functions run on [`Polynomial`]s and [`Fraction`]s in named variables instead of floats: what comes out
//! is the law itself, and whether two laws agree is decided, not sampled.
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

mod number;
mod proofs;
mod region;

pub mod equations;
pub mod proof;
pub mod symbols;
pub mod tex;

pub use num_bigint::BigInt;
pub use num_rational::BigRational;
pub use number::{
    Circular, Derivation, Fraction, Monomial, ParseError, Polynomial, Rational, Relations, Series, Symbol,
    Tex,
};
pub use proof::{Mutant, Outcome, Proof, Residue};
pub use proofs::engines::{Law, keeps};
pub use proofs::proofs;
