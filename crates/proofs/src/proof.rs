//! A proof: a claim that is computed, and altered claims that must fail.

use crate::number::{Fraction, Relations};
pub use crate::residue::{Outcome, Residue};
use crate::tex::{Node, Scope, parse};
use nalgebra::SMatrix;
use num_traits::Zero;

/// What a proof, or an equation that is proven, says about the library.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// It runs functions of the library on symbols.
    Library,
    /// It puts formulas that are written here a second time into functions of the library, on symbols.
    Again,
    /// It runs functions of the library on exact numbers or on intervals.
    Numbers,
    /// It is mathematics alone.
    Lemma,
}

/// A claim about laws or formulas, proven by running them on symbols.
#[derive(Debug, Clone, Copy)]
pub struct Proof {
    /// Short name, with dashes.
    pub name: &'static str,
    /// What it says about the library.
    pub kind: Kind,
    /// The part of the library that it is about.
    pub part: &'static str,
    /// What the check checks, and no more, in plain words. Formulas are in TeX between dollar signs, and the
    /// check evaluates them as they are written.
    pub statement: &'static str,
    /// The meanings of the names in the formulas, in each case of the check; or what is left over if the
    /// claim fails besides its formulas.
    pub cases: fn() -> Result<Vec<Scope>, Residue>,
    /// The claim about an altered law, or an altered claim about the law: each must fail.
    pub mutants: &'static [Mutant],
}

impl Proof {
    /// The check.
    ///
    /// # Errors
    /// What is left over, if the claim is false.
    pub fn check(&self) -> Outcome {
        self.check_in(&(self.cases)()?)
    }

    /// The check, with its cases already computed.
    ///
    /// # Errors
    /// As [`check`](Self::check).
    pub fn check_in(&self, cases: &[Scope]) -> Outcome {
        formulas(self.statement).try_for_each(|tex| holds_in(cases, tex))
    }
}

/// A proof with one thing changed, which must therefore fail.
#[derive(Debug, Clone, Copy)]
pub struct Mutant {
    /// What was changed, in plain words.
    pub change: &'static str,
    /// The check, which must fail.
    pub check: fn() -> Outcome,
}

/// The data of a check for the formulas of its sentence, if there are any.
pub(crate) trait Cases {
    /// What their names mean.
    fn cases(self) -> Result<Vec<Scope>, Residue>;
}

/// What the names of a sentence mean, or what is left over.
pub(crate) type Case<S = Scope> = Result<S, Residue>;

impl Cases for Scope {
    fn cases(self) -> Result<Vec<Scope>, Residue> {
        Ok(vec![self])
    }
}

impl Cases for Vec<Scope> {
    fn cases(self) -> Result<Vec<Scope>, Residue> {
        Ok(self)
    }
}

impl<T: Cases> Cases for Result<T, Residue> {
    fn cases(self) -> Result<Vec<Scope>, Residue> {
        self.and_then(T::cases)
    }
}

/// The formulas of a sentence.
pub fn formulas(sentence: &str) -> impl Iterator<Item = &str> {
    sentence.split('$').skip(1).step_by(2)
}

/// Checks that the claim holds, and that the formulas of its sentence hold in its cases.
pub(crate) fn hold(sentence: &str, found: impl Cases) -> Outcome {
    let cases = found.cases()?;
    formulas(sentence).try_for_each(|tex| holds_in(&cases, tex))
}

/// Checks that maths in TeX holds in each of these cases that defines its names; there must be at least one.
/// A bare expression must be a name.
///
/// # Errors
/// What is left over, or why it has no meaning.
pub fn holds_in(cases: &[Scope], tex: &str) -> Outcome {
    let meaningless = |why: &str| Residue::Missing { claim: format!("`{tex}`, {why}") };
    for statement in parse(tex).map_err(|error| meaningless(&error.to_string()))? {
        let sides = || std::iter::once(&statement.left).chain(statement.others.iter().map(|(_, side)| side));
        if statement.others.is_empty() && !matches!(statement.left.tree, Node::Name(_)) {
            return Err(meaningless("which states nothing"));
        }
        let knows = |case: &&Scope| sides().all(|side| case.value(&side.tree).is_ok());
        let mut known = cases.iter().filter(knows).peekable();
        if known.peek().is_none() {
            return Err(meaningless("whose names mean something together"));
        }
        known
            .try_for_each(|case| statement.prove(case))
            .map_err(|left| Residue::Formula { tex: tex.to_owned(), left })?;
    }
    Ok(())
}

/// Checks that `x` is zero under the relations.
///
/// # Errors
/// What is left.
pub fn vanishes(claim: &str, x: &Fraction, relations: &Relations) -> Outcome {
    same_under(relations, claim, x, &Fraction::zero())
}

/// Checks that two expressions are equal for all values of their variables.
///
/// # Errors
/// Their difference.
pub fn same(claim: &str, a: &Fraction, b: &Fraction) -> Outcome {
    same_under(&Relations::none(), claim, a, b)
}

/// Checks that two expressions are equal wherever the relations hold.
///
/// # Errors
/// Their difference, reduced.
pub fn same_under(relations: &Relations, claim: &str, a: &Fraction, b: &Fraction) -> Outcome {
    let left = relations.reduce_fraction(&(a - b));
    let claim = claim.to_owned();
    match (left.is_undefined(), left.is_zero()) {
        (true, _) => Err(Residue::Undefined { claim }),
        (_, true) => Ok(()),
        (_, false) => Err(Residue::NotZero { claim, left }),
    }
}

/// Checks that two vectors or matrices are equal for all values of their variables.
///
/// # Errors
/// The first difference.
pub fn same_entries<const R: usize, const C: usize>(
    claim: &str,
    a: &SMatrix<Fraction, R, C>,
    b: &SMatrix<Fraction, R, C>,
) -> Outcome {
    same_entries_under(&Relations::none(), claim, a, b)
}

/// Checks that two vectors or matrices are equal wherever the relations hold.
///
/// # Errors
/// The first difference, reduced.
pub fn same_entries_under<const R: usize, const C: usize>(
    relations: &Relations,
    claim: &str,
    a: &SMatrix<Fraction, R, C>,
    b: &SMatrix<Fraction, R, C>,
) -> Outcome {
    let axes = ["x", "y", "z", "w"];
    for (i, row) in axes.into_iter().enumerate().take(R) {
        for (j, column) in axes.into_iter().enumerate().take(C) {
            let column = if C == 1 { "" } else { column };
            same_under(relations, &format!("{claim}, {row}{column}"), &a[(i, j)], &b[(i, j)])?;
        }
    }
    Ok(())
}

/// Checks that `x` is positive wherever all its variables are, because all its coefficients are.
///
/// # Errors
/// A coefficient of the wrong sign, or zero.
pub fn positive(claim: &str, x: &Fraction) -> Outcome {
    let signs = (x.numerator().common_sign(), x.denominator().common_sign());
    let one_sign = signs == (Some(1), Some(1));
    let claim = claim.to_owned();
    match one_sign {
        _ if x.is_undefined() => Err(Residue::Undefined { claim }),
        true => Ok(()),
        false => Err(Residue::NotOneSign { claim, quantity: x.clone() }),
    }
}

/// Checks that a check fails, as an altered law must; returns what it left over.
///
/// # Errors
/// The claim, if nothing is left over or if a division by zero occurred.
pub fn breaks(claim: &str, outcome: Outcome) -> Outcome {
    match outcome {
        Err(Residue::NotZero { .. } | Residue::NotOneSign { .. }) => Ok(()),
        Ok(()) | Err(_) => Err(Residue::Missing { claim: claim.to_owned() }),
    }
}
