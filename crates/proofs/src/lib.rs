//! Laws of the `tumbling` library, proven for all bodies at once.
//!
//! The library writes its laws over anything that can be added and multiplied. Here the same functions run on
//! [`Polynomial`]s and [`Fraction`]s in named variables instead of floats. The result is the law itself, and
//! equality of two laws is decided, not sampled.
//!
//! ```
//! use tumbling::dynamics::euler::coupling;
//! use tumbling_proofs::symbols::vector;
//!
//! // Euler's equations for every body and every spin, and why they keep the energy: w . (I w') is nothing.
//! let (moments, omega) = (vector("I"), vector("omega"));
//! let torque_free = coupling(&moments, &omega);
//! assert_eq!(torque_free.x.to_string(), "I2 omega2 omega3 - I3 omega2 omega3");
//! assert_eq!(omega.dot(&torque_free).to_string(), "0");
//! ```
//!
//! [`proofs()`] lists them all, each with its [`Kind`]. Of the closed form the library's own sums run on
//! symbols, and all of it on intervals; but the formulas of its constants, which contain roots, are written
//! here a second time, and their results are substituted into the library's laws. The laws that a stepping
//! method conserves are proven for its equations, written here a second time; for its own step, whose order
//! is proven, they are tested from two starts in exact fractions. Lemmas are mathematics alone and say
//! nothing of the code.
//!
//! A proof is about the formula in exact arithmetic. It does not cover rounding, overflow, or code with
//! branches and roots; other tests must check these.
#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod certain;
mod lattice;
mod number;
mod proofs;
mod region;
mod residue;

pub mod counted;
pub mod equations;
pub mod interval;
pub mod proof;
pub mod symbols;
pub mod tex;

/// Items that are public only for the tests of this crate.
pub mod tested {
    pub use crate::interval::{paths::every_path, rounded::Rounded};
    pub use crate::proofs::{methods::TESTED, methods::cases, order::exact};
    pub use crate::region::{Region, around};
}

pub use certain::{Exact, enclosed, exactly};
pub use interval::Interval;
pub use num_bigint::BigInt;
pub use num_rational::BigRational;
pub use number::{Circular, Derivation, Fraction, Monomial, Polynomial, Rational, Relations, Series, Symbol};
pub use proof::{Kind, Mutant, Outcome, Proof, Residue};
pub use proofs::proofs;
