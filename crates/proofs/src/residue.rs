//! The result of a check: nothing, or what is left over.

use crate::number::{Circular, Fraction};
use std::fmt;

/// Nothing is left over, or something is.
pub type Outcome = Result<(), Residue>;

/// What is left over of a claim that does not hold.
#[derive(Debug, Clone)]
pub enum Residue {
    /// An identity that fails: the difference of its sides is not zero.
    NotZero {
        /// The claim, in a few words.
        claim: String,
        /// Left side minus right side.
        left: Fraction,
    },
    /// A formula of a sentence that fails for what was checked.
    Formula {
        /// As it stands there.
        tex: String,
        /// What is left over.
        left: String,
    },
    /// A quantity claimed to have one sign for all positive values, whose coefficients do not show it.
    NotOneSign {
        /// The claim, in a few words.
        claim: String,
        /// The quantity.
        quantity: Fraction,
    },
    /// A division by zero occurred: nothing is proven.
    Undefined {
        /// The claim, in a few words.
        claim: String,
    },
    /// Something that should have failed or been found, and was not.
    Missing {
        /// The claim, in a few words.
        claim: String,
    },
}

/// If there are more terms than this, only their number is shown.
const SHOWN: usize = 8;

fn shortened(x: &Fraction) -> String {
    let (count, text) = (x.numerator().len(), x.to_string());
    let few: String = text.split_inclusive([' ']).take(6 * SHOWN).collect();
    if count > SHOWN { format!("{few}... ({count} terms)") } else { text }
}

impl fmt::Display for Residue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotZero { claim, left } => write!(f, "{claim}: leaves {}", shortened(left)),
            Self::Formula { tex, left } => write!(f, "`{tex}`: {left}"),
            Self::NotOneSign { claim, quantity } => {
                write!(f, "{claim}: mixed signs in {}", shortened(quantity))
            }
            Self::Undefined { claim } => write!(f, "{claim}: divides by zero"),
            Self::Missing { claim } => write!(f, "{claim}: not so"),
        }
    }
}

impl std::error::Error for Residue {}

/// Relations that are none leave nothing to be proven.
impl From<Circular> for Residue {
    fn from(rule: Circular) -> Self {
        Self::Missing { claim: rule.to_string() }
    }
}
