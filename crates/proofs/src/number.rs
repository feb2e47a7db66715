//! Numbers that are more than numbers: exact fractions, polynomials, power series.

mod calculus;
mod fraction;
mod functions;
mod monomial;
mod ops;
mod polynomial;
mod rational;
mod relations;
mod series;
mod symbol;

pub use fraction::Fraction;
pub use monomial::Monomial;
pub(crate) use ops::from;
pub use polynomial::Polynomial;
pub use rational::Rational;
pub use relations::{Circular, Derivation, Relations};
pub use series::Series;
pub use symbol::Symbol;
