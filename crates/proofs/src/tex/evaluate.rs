//! From a tree to its value, and from a statement to its proof.

use super::scope::Scope;
use super::tree::{Node, Relation, Statement, is_value};
use super::value::{Meaningless, Value};
use crate::number::{Fraction, Rational};
use crate::proof::vanishes;
use crate::symbols::{Matrix, Vector, quaternion};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

impl Scope {
    /// The value of an expression.
    ///
    /// # Errors
    /// A name or an operation without a meaning here, such as the dot product of a matrix.
    pub fn value(&self, node: &Node) -> Result<Value, String> {
        let both = |a: &Node, b: &Node| Ok::<_, Meaningless>((self.value(a)?, self.value(b)?));
        let value = match node {
            Node::Number(x) => Fraction::from(x.clone()).into(),
            Node::Name(name) => match self.meaning(name) {
                Some(value) => value.clone(),
                None => return Err(format!("`{name}` has no meaning here")),
            },
            Node::Sum(a, b) => both(a, b).and_then(|(a, b)| a.plus(b))?,
            Node::Difference(a, b) => both(a, b).and_then(|(a, b)| a.plus(b.negative()?))?,
            Node::Negative(a) => self.value(a)?.negative()?,
            Node::Product(a, b) => both(a, b).and_then(|(a, b)| a.times(b))?,
            Node::Dot(a, b) => both(a, b).and_then(|(a, b)| a.dot(b))?,
            Node::Cross(a, b) => both(a, b).and_then(|(a, b)| a.cross(b))?,
            Node::Quotient(a, b) => both(a, b).and_then(|(a, b)| a.over(b))?,
            Node::Power(a, n) => self.value(a)?.power(*n)?,
            Node::Transpose(a) => self.value(a)?.transpose()?,
            Node::Root(a) => self.value(a)?.root()?,
            Node::Total(a) => self.total(a)?,
            Node::Tuple(parts) => {
                tuple(parts.iter().map(|part| self.value(part)).collect::<Result<_, _>>()?)?
            }
            Node::Matrix(rows) => self.matrix(rows)?,
        };
        Ok(value.reduced(&self.relations))
    }

    fn total(&self, term: &Node) -> Result<Value, Meaningless> {
        let mut terms = self.pieces.iter().map(|piece| self.inside(piece).value(term));
        let first = terms.next().ok_or("there is nothing here to sum over")??;
        terms.try_fold(first, |sum, term| sum.plus(term?))
    }

    fn matrix(&self, rows: &[Vec<Node>]) -> Result<Value, Meaningless> {
        let entry = |node: &Node| match self.value(node)? {
            Value::Scalar(x) => Ok(x),
            _ => Err("an entry of a matrix is not a number".to_owned()),
        };
        let entries = rows.iter().flatten().map(entry).collect::<Result<Vec<_>, _>>()?;
        let shape = (rows.len(), rows.iter().map(Vec::len).max(), rows.iter().map(Vec::len).min());
        match shape {
            (3, Some(3), Some(3)) => Ok(Matrix::from_row_iterator(entries).into()),
            (3, Some(1), Some(1)) => Ok(Vector::from_iterator(entries).into()),
            _ => Err("a matrix here has three rows of one or three entries".to_owned()),
        }
    }
}

/// Whether a decimal number is the correct rounding; a whole number must be exact.
fn rounds_to(exact: &BigRational, decimal: &BigRational) -> bool {
    let ten = BigRational::from_integer(10.into());
    let mut unit = BigRational::from_integer(1.into());
    // More decimals than these are not read.
    for _ in 0..40 {
        if (decimal / &unit).is_integer() {
            let off = (exact - decimal).abs();
            let twice = &off + &off;
            return if unit.is_integer() { off.is_zero() } else { twice <= unit };
        }
        unit /= &ten;
    }
    false
}

/// Two or three numbers are a vector, in the plane or in space; a number and a vector are a quaternion.
fn tuple(parts: Vec<Value>) -> Result<Value, Meaningless> {
    match &parts[..] {
        [Value::Scalar(x), Value::Scalar(y)] => {
            Ok(Vector::new(x.clone(), y.clone(), Fraction::zero()).into())
        }
        [Value::Scalar(x), Value::Scalar(y), Value::Scalar(z)] => {
            Ok(Vector::new(x.clone(), y.clone(), z.clone()).into())
        }
        [Value::Scalar(w), Value::Vector(v)] => Ok(quaternion(w.clone(), v).into()),
        _ => {
            Err("only two or three numbers, or a number and a vector, stand in brackets with commas"
                .to_owned())
        }
    }
}

impl Statement {
    /// Proves that it holds for all values of the variables behind its names.
    ///
    /// # Errors
    /// What is left over, or why there is no meaning in it.
    pub fn prove(&self, scope: &Scope) -> Result<(), String> {
        for (left, relation, right) in self.pairs() {
            let (a, b) = (scope.value(&left.tree)?, scope.value(&right.tree)?);
            scope
                .related(relation, a, b)
                .map_err(|problem| format!("`{}` and `{}`: {problem}", left.text, right.text))?;
        }
        Ok(())
    }

    /// Proves each equality with a number, for these values of the variables: decimals must be the correct
    /// rounding, and a whole number must be exact. Returns the statement without these numbers.
    ///
    /// # Errors
    /// The value, or why there is none.
    pub fn prove_example(&self, scope: &Scope, values: &[(&str, i64)]) -> Result<Self, String> {
        let values: Vec<_> = values.iter().map(|(name, x)| (*name, Rational::from(*x))).collect();
        for (left, relation, right) in self.pairs().filter(|(_, relation, right)| is_value(*relation, right))
        {
            let (exact, printed) = match (scope.value(&left.tree)?, scope.value(&right.tree)?) {
                (Value::Scalar(a), Value::Scalar(b)) => (vec![a], vec![b]),
                (Value::Vector(a), Value::Vector(b)) => {
                    (a.iter().cloned().collect(), b.iter().cloned().collect())
                }
                _ => return Err(format!("`{}` {relation:?} `{}` has no meaning", left.text, right.text)),
            };
            for (exact, printed) in exact.iter().zip(&printed) {
                let exact = exact.at(&values);
                if !exact.value().zip(printed.as_constant()).is_some_and(|(x, y)| rounds_to(x, &y)) {
                    return Err(format!("`{}`: {exact} is not {printed}", right.text));
                }
            }
        }
        let mut others = self.others.clone();
        let numbers = others.iter().rev().take_while(|(relation, side)| is_value(*relation, side)).count();
        others.truncate(others.len() - numbers);
        Ok(Self { others, ..self.clone() })
    }

    /// Proves that all its sides are equal, for any relations between them: that a bound is attained.
    ///
    /// # Errors
    /// What is left over.
    pub fn prove_attained(&self, scope: &Scope) -> Result<(), String> {
        for (left, _, right) in self.pairs() {
            scope.related(Relation::Equal, scope.value(&left.tree)?, scope.value(&right.tree)?)?;
        }
        Ok(())
    }

    /// Proves that a bare expression has the value that the scope calls [`Scope::IT`].
    ///
    /// # Errors
    /// What is left over.
    pub fn prove_worth(&self, scope: &Scope) -> Result<(), String> {
        if !self.others.is_empty() {
            return Err("an expression without an equals sign is expected".to_owned());
        }
        let it = scope.value(&Node::Name(Scope::IT.to_owned()))?;
        scope.equal(scope.value(&self.left.tree)?, it)
    }
}

impl Scope {
    fn related(&self, relation: Relation, a: Value, b: Value) -> Result<(), String> {
        let (low, high, strict) = match relation {
            Relation::Equal => return self.equal(a, b),
            Relation::Less => (a, b, true),
            Relation::AtMost => (a, b, false),
            Relation::Greater => (b, a, true),
            Relation::AtLeast => (b, a, false),
        };
        match high.plus(low.negative()?)? {
            Value::Scalar(x) if self.is_above(&x, strict) => Ok(()),
            Value::Scalar(x) => Err(format!("the signs do not show it of {x}")),
            _ => Err("only numbers have an order".to_owned()),
        }
    }

    fn equal(&self, a: Value, b: Value) -> Result<(), String> {
        let (zero, not_negative) = a.difference(b)?;
        for x in &zero {
            vanishes("the difference", x, &self.relations).map_err(|residue| residue.to_string())?;
        }
        match not_negative {
            Some(x) if !self.is_above(&x, false) => Err(format!("a root is not below zero, and {x} may be")),
            _ => Ok(()),
        }
    }
}
