//! Reads the equations of the book from their TeX, and evaluates them in symbols.
//!
//! [`parse`] turns the source into trees, for the part of TeX that the book uses, and reports where it
//! cannot. A [`Scope`] contains the meaning of each name: a number, a vector, a matrix or a quaternion of
//! fractions. Then [`Statement::prove`] decides whether the statement is true for all values of the free
//! variables.
//!
//! ```
//! use tumbling_proofs::Fraction;
//! use tumbling_proofs::tex::{Scope, parse};
//! let [a, b] = ["a", "b"].map(Fraction::variable);
//! let scope = Scope::default().with("a", a).with("b", b);
//! let proven = |tex: &str| parse(tex).unwrap()[0].prove(&scope).is_ok();
//! assert!(proven(r"(a + b)^2 - (a - b)^2 = 4\,a\,b"));
//! assert!(!proven(r"(a + b)^2 + (a - b)^2 = 4\,a\,b"));
//! assert_eq!(parse("a = b +").unwrap_err().to_string(), "expected a number, a name or a bracket at byte 7");
//! ```

mod error;
mod evaluate;
mod parse;
mod scope;
mod token;
mod tree;
mod value;

pub use error::TexError;
pub use parse::parse;
pub use scope::Scope;
pub use tree::{Node, Relation, Side, Statement};
pub use value::Value;
