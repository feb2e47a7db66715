//! What a proof is: a claim that is computed, and altered claims that must fail.

use crate::number::{Fraction, Relations, Tex};
use crate::record::{self, Entry};
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;
use std::fmt;

/// A claim about the library's laws, proven by running them on symbols.
#[derive(Debug, Clone, Copy)]
pub struct Proof {
    /// Short name, with dashes.
    pub name: &'static str,
    /// What it is about: the part of the library.
    pub part: &'static str,
    /// What the check checks, and no more, in plain words.
    pub statement: &'static str,
    /// What is left over, if the claim is false.
    pub check: fn() -> Outcome,
    /// The same claim about an altered law, or an altered claim about the law: each must fail.
    pub mutants: &'static [Mutant],
}

/// A proof with one thing changed, which must therefore fail.
#[derive(Debug, Clone, Copy)]
pub struct Mutant {
    /// What was changed, in plain words.
    pub change: &'static str,
    /// The check, which must leave something over.
    pub check: fn() -> Outcome,
}

/// Nothing left over, or what is.
pub type Outcome = Result<(), Residue>;

/// What is left over of a claim that does not hold.
#[derive(Debug, Clone)]
pub enum Residue {
    /// An identity that is none: the difference of its sides is not zero.
    NotZero {
        /// The claim, in a few words.
        claim: String,
        /// Left side minus right side.
        left: Fraction,
    },
    /// A quantity claimed to have one sign for all positive values, whose coefficients do not show it.
    NotOneSign {
        /// The claim, in a few words.
        claim: String,
        /// The quantity.
        quantity: Fraction,
    },
    /// A division by zero on the way: nothing is proven.
    Undefined {
        /// The claim, in a few words.
        claim: String,
    },
    /// Something claimed to fail, or to be found, that did not or was not.
    Missing {
        /// The claim, in a few words.
        claim: String,
    },
}

/// More terms than these are counted, not shown.
const SHOWN: usize = 8;

fn shortened(x: &Fraction) -> String {
    let count = x.numerator().len();
    if count <= SHOWN {
        return x.to_string();
    }
    let few: Vec<_> = x.to_string().split_inclusive([' ']).take(6 * SHOWN).map(str::to_owned).collect();
    format!("{}... ({count} terms)", few.concat())
}

impl fmt::Display for Residue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotZero { claim, left } => write!(f, "{claim}: leaves {}", shortened(left)),
            Self::NotOneSign { claim, quantity } => {
                write!(f, "{claim}: mixed signs in {}", shortened(quantity))
            }
            Self::Undefined { claim } => write!(f, "{claim}: divides by zero"),
            Self::Missing { claim } => write!(f, "{claim}: not so"),
        }
    }
}

impl std::error::Error for Residue {}

impl Residue {
    /// What is left over, in TeX, if that is an expression.
    #[must_use]
    pub fn tex(&self) -> Option<String> {
        match self {
            Self::NotZero { left: x, .. } | Self::NotOneSign { quantity: x, .. } => Some(x.tex()),
            Self::Undefined { .. } | Self::Missing { .. } => None,
        }
    }
}

/// That `x` is zero under the relations.
///
/// # Errors
/// What is left.
pub fn vanishes(claim: &str, x: &Fraction, relations: &Relations) -> Outcome {
    same_under(relations, claim, x, &Fraction::zero())
}

/// That two expressions are the same for all values of their variables.
///
/// # Errors
/// Their difference.
pub fn same(claim: &str, a: &Fraction, b: &Fraction) -> Outcome {
    same_under(&Relations::none(), claim, a, b)
}

/// That two expressions are the same wherever the relations hold.
///
/// # Errors
/// Their difference, reduced.
pub fn same_under(relations: &Relations, claim: &str, a: &Fraction, b: &Fraction) -> Outcome {
    let left = relations.reduce_fraction(&(a - b));
    record::equal(claim, a, b, relations, left.is_zero());
    let claim = claim.to_owned();
    match (left.is_undefined(), left.is_zero()) {
        (true, _) => Err(Residue::Undefined { claim }),
        (_, true) => Ok(()),
        (_, false) => Err(Residue::NotZero { claim, left }),
    }
}

/// That two vectors are the same for all values of their variables.
///
/// # Errors
/// The first difference.
pub fn same_vectors(claim: &str, a: &Vector3<Fraction>, b: &Vector3<Fraction>) -> Outcome {
    same_vectors_under(&Relations::none(), claim, a, b)
}

/// That two vectors are the same wherever the relations hold.
///
/// # Errors
/// The first difference, reduced.
pub fn same_vectors_under(
    relations: &Relations,
    claim: &str,
    a: &Vector3<Fraction>,
    b: &Vector3<Fraction>,
) -> Outcome {
    for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
        same_under(relations, &format!("{claim}, {axis}"), &a[i], &b[i])?;
    }
    Ok(())
}

/// That two matrices are the same wherever the relations hold.
///
/// # Errors
/// The first difference, reduced.
pub fn same_matrices_under(
    relations: &Relations,
    claim: &str,
    a: &Matrix3<Fraction>,
    b: &Matrix3<Fraction>,
) -> Outcome {
    for (i, row) in ["x", "y", "z"].into_iter().enumerate() {
        for (j, column) in ["x", "y", "z"].into_iter().enumerate() {
            same_under(relations, &format!("{claim}, {row}{column}"), &a[(i, j)], &b[(i, j)])?;
        }
    }
    Ok(())
}

/// That two matrices are the same for all values of their variables.
///
/// # Errors
/// The first difference.
pub fn same_matrices(claim: &str, a: &Matrix3<Fraction>, b: &Matrix3<Fraction>) -> Outcome {
    same_matrices_under(&Relations::none(), claim, a, b)
}

/// That `x` is above zero wherever all its variables are, since all its coefficients are.
///
/// # Errors
/// A coefficient of the wrong sign, or zero.
pub fn positive(claim: &str, x: &Fraction) -> Outcome {
    let signs = (x.numerator().common_sign(), x.denominator().common_sign());
    let one_sign = signs == (Some(1), Some(1));
    record::above_zero(claim, x, one_sign);
    let claim = claim.to_owned();
    match one_sign {
        _ if x.is_undefined() => Err(Residue::Undefined { claim }),
        true => Ok(()),
        false => Err(Residue::NotOneSign { claim, quantity: x.clone() }),
    }
}

/// That `x` is zero, or above zero wherever all its variables are.
///
/// # Errors
/// A coefficient of the wrong sign.
pub fn not_negative(claim: &str, x: &Fraction) -> Outcome {
    if x.is_zero() { Ok(()) } else { positive(claim, x) }
}

/// That a check fails, as a broken law must: what it left over.
///
/// # Errors
/// The claim, if nothing is left over or a division by zero was.
pub fn breaks(claim: &str, outcome: Outcome) -> Outcome {
    record::record(|| Entry::Broken(outcome.is_err()));
    match outcome {
        Err(Residue::NotZero { .. } | Residue::NotOneSign { .. }) => Ok(()),
        Ok(()) | Err(_) => Err(Residue::Missing { claim: claim.to_owned() }),
    }
}
