//! Laws of the `tumbling` library, proven for all bodies at once.
//!
//! The library writes its laws over whatever can be added and multiplied. Here the very same functions run on
//! [`Polynomial`]s and [`Fraction`]s in named variables instead of floats: what comes out is the law itself,
//! and whether two laws agree is decided, not sampled.
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
//! [`proofs()`] lists them all. Two kinds say less. Of the closed form the library's own sums run on symbols,
//! and all of it on intervals; but the formulas of its constants, which have roots, are written here a second
//! time, and what they make is put into the library's laws. And the laws that a stepping method keeps are
//! proven of its equations, written here a second time; of its own step, of which the order is proven, they
//! are tested from two starts in exact fractions.
//!
//! A proof is about the formula in exact arithmetic: it says nothing of rounding, of overflow, or of what is
//! computed with branches and roots, which other tests must watch.
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

/// What is public for the tests of this crate alone.
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
pub use proof::{Mutant, Outcome, Proof, Residue};
pub use proofs::proofs;
