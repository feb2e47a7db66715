//! Numbers that are more than numbers: exact fractions, polynomials, power series.

mod calculus;
pub(crate) mod expression;
mod fraction;
mod functions;
mod monomial;
mod ops;
mod parse;
mod polynomial;
mod print;
mod rational;
mod relations;
mod series;
mod symbol;
mod tex;

pub use fraction::Fraction;
pub use monomial::Monomial;
pub use parse::ParseError;
pub use polynomial::Polynomial;
pub use rational::Rational;
pub use relations::{Circular, Derivation, Relations};
pub use series::Series;
pub use symbol::Symbol;
pub use tex::Tex;
