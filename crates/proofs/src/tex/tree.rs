//! The contents of an equation as a tree.

use crate::number::Rational;

/// An expression.
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    /// A number.
    Number(Rational),
    /// A name with all that belongs to it (bold, dot, index), without spaces: `\dot{\omega}_1`.
    Name(String),
    /// A sum.
    Sum(Box<Node>, Box<Node>),
    /// A difference.
    Difference(Box<Node>, Box<Node>),
    /// The negative.
    Negative(Box<Node>),
    /// Side by side.
    Product(Box<Node>, Box<Node>),
    /// With a dot between.
    Dot(Box<Node>, Box<Node>),
    /// With a cross between.
    Cross(Box<Node>, Box<Node>),
    /// A quotient.
    Quotient(Box<Node>, Box<Node>),
    /// A whole power.
    Power(Box<Node>, i32),
    /// The transpose.
    Transpose(Box<Node>),
    /// The square root.
    Root(Box<Node>),
    /// The sum over all pieces of a body.
    Total(Box<Node>),
    /// In brackets, with commas.
    Tuple(Vec<Node>),
    /// Row by row.
    Matrix(Vec<Vec<Node>>),
}

impl Node {
    /// Whether it is a number as written, perhaps with a minus.
    fn is_written_number(&self) -> bool {
        match self {
            Self::Number(_) => true,
            Self::Negative(a) => matches!(**a, Self::Number(_)),
            _ => false,
        }
    }

    /// Whether there is no name in it.
    #[must_use]
    pub fn is_numeric(&self) -> bool {
        match self {
            Self::Number(_) => true,
            Self::Name(_) | Self::Total(_) => false,
            Self::Sum(a, b)
            | Self::Difference(a, b)
            | Self::Product(a, b)
            | Self::Dot(a, b)
            | Self::Cross(a, b)
            | Self::Quotient(a, b) => a.is_numeric() && b.is_numeric(),
            Self::Negative(a) | Self::Power(a, _) | Self::Transpose(a) | Self::Root(a) => a.is_numeric(),
            Self::Tuple(parts) => parts.iter().all(Self::is_numeric),
            Self::Matrix(rows) => rows.iter().flatten().all(Self::is_numeric),
        }
    }
}

/// What stands between two sides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// `=`
    Equal,
    /// `<`
    Less,
    /// `\le`
    AtMost,
    /// `>`
    Greater,
    /// `\ge`
    AtLeast,
}

/// A side of an equation.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    /// What it says.
    pub tree: Node,
    /// How it is written, without spaces.
    pub text: String,
}

/// An equation or inequality, or a chain of them, or a bare expression.
#[derive(Debug, Clone, PartialEq)]
pub struct Statement {
    /// The left side.
    pub left: Side,
    /// The others, each with what stands before it; none in a bare expression.
    pub others: Vec<(Relation, Side)>,
    /// How all of it is written, without spaces and the marks of the sentence.
    pub text: String,
}

impl Statement {
    /// Each side with the next.
    pub fn pairs(&self) -> impl Iterator<Item = (&Side, Relation, &Side)> {
        let lefts = std::iter::once(&self.left).chain(self.others.iter().map(|(_, side)| side));
        lefts.zip(&self.others).map(|(left, (relation, right))| (left, *relation, right))
    }

    /// Whether it only assigns a value to a name that may have one: a small letter equal to a number, or a
    /// bold one equal to a tuple of numbers.
    #[must_use]
    pub fn gives_values(&self) -> bool {
        let Node::Name(name) = &self.left.tree else { return false };
        let letter = name.len() == 1 && name.chars().all(|c| c.is_ascii_lowercase());
        let bold = [r"\mathbf{", r"\boldsymbol{"].iter().any(|b| name.starts_with(b)) && name.ends_with('}');
        match &self.others[..] {
            [(Relation::Equal, Side { tree: Node::Tuple(parts), .. })] => {
                bold && parts.iter().all(Node::is_written_number)
            }
            [(Relation::Equal, side)] => letter && side.tree.is_written_number(),
            _ => false,
        }
    }
}

/// Whether a pair is an equality with an expression of numbers alone.
pub(crate) fn is_value(relation: Relation, right: &Side) -> bool {
    relation == Relation::Equal && right.tree.is_numeric()
}
