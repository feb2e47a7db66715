//! What an expression is worth: a number, a vector, a matrix or a quaternion, in symbols.

use crate::number::{Fraction, Relations, from};
use crate::symbols::{Matrix, Vector, diagonal, inverse, quaternion};
use nalgebra::Quaternion;

/// The worth of an expression.
#[derive(Debug, Clone)]
pub enum Value {
    /// A number.
    Scalar(Fraction),
    /// A vector.
    Vector(Vector),
    /// A matrix.
    Matrix(Matrix),
    /// A quaternion.
    Quaternion(Quaternion<Fraction>),
    /// The square root of a number, not negative. Only its even powers are evaluated.
    Root(Fraction),
    /// The inverse of a matrix, not computed: another matrix equals it if their product is 1.
    Inverse(Matrix),
    /// The inverse of a matrix times a vector, not computed: another vector equals it if the matrix maps it
    /// to that vector.
    Solution(Matrix, Vector),
}

from! {
    Value, Fraction: |x| Self::Scalar(x);
    Value, Vector: |v| Self::Vector(v);
    Value, Matrix: |m| Self::Matrix(m);
    Value, Quaternion<Fraction>: |q| Self::Quaternion(q);
}

/// Why something cannot be worked out.
pub(crate) type Meaningless = String;

impl Value {
    fn kind(&self) -> &'static str {
        match self {
            Self::Scalar(_) => "a number",
            Self::Vector(_) | Self::Solution(..) => "a vector",
            Self::Matrix(_) | Self::Inverse(_) => "a matrix",
            Self::Quaternion(_) => "a quaternion",
            Self::Root(_) => "a root",
        }
    }

    fn refused<T>(&self, what: &str, other: &Self) -> Result<T, Meaningless> {
        Err(format!("{what} {} and {} has no meaning here", self.kind(), other.kind()))
    }

    pub(super) fn negative(self) -> Result<Self, Meaningless> {
        Value::Scalar(Fraction::from(-1)).times(self)
    }

    pub(super) fn plus(self, other: Self) -> Result<Self, Meaningless> {
        Ok(match (self, other) {
            (Self::Scalar(a), Self::Scalar(b)) => (a + b).into(),
            (Self::Vector(a), Self::Vector(b)) => (a + b).into(),
            (Self::Matrix(a), Self::Matrix(b)) => (a + b).into(),
            (Self::Quaternion(a), Self::Quaternion(b)) => Quaternion::from_vector(a.coords + b.coords).into(),
            (a, b) => return a.refused("the sum of", &b),
        })
    }

    /// Side by side.
    pub(crate) fn times(self, other: Self) -> Result<Self, Meaningless> {
        Ok(match (self.worked_out(&other), other) {
            (Self::Scalar(a), Self::Scalar(b)) => (a * b).into(),
            (Self::Scalar(a), Self::Vector(v)) | (Self::Vector(v), Self::Scalar(a)) => {
                v.map(|x| x * &a).into()
            }
            (Self::Scalar(a), Self::Matrix(m)) | (Self::Matrix(m), Self::Scalar(a)) => {
                m.map(|x| x * &a).into()
            }
            (Self::Scalar(a), Self::Quaternion(q)) | (Self::Quaternion(q), Self::Scalar(a)) => {
                Quaternion::from_vector(q.coords.map(|x| x * &a)).into()
            }
            (Self::Matrix(a), Self::Matrix(b)) => (a * b).into(),
            (Self::Matrix(a), Self::Inverse(b)) => (a * inverse(&b)).into(),
            (Self::Matrix(a), Self::Vector(v)) => (a * v).into(),
            (Self::Inverse(a), Self::Vector(v)) => Self::Solution(a, v),
            (Self::Quaternion(a), Self::Quaternion(b)) => hamilton(&a, &b).into(),
            (a, b) => return a.refused("the product of", &b),
        })
    }

    /// An inverse, computed unless a vector follows.
    fn worked_out(self, next: &Self) -> Self {
        match (self, next) {
            (Self::Inverse(m), Self::Matrix(_) | Self::Inverse(_)) => Self::Matrix(inverse(&m)),
            (value, _) => value,
        }
    }

    /// With a dot between.
    pub(super) fn dot(self, other: Self) -> Result<Self, Meaningless> {
        match (self, other) {
            (Self::Scalar(a), Self::Scalar(b)) => Ok((a * b).into()),
            (Self::Vector(a), Self::Vector(b)) => Ok(a.dot(&b).into()),
            (a, b) => a.refused("the dot product of", &b),
        }
    }

    /// With a cross between.
    pub(super) fn cross(self, other: Self) -> Result<Self, Meaningless> {
        match (self, other) {
            (Self::Scalar(a), Self::Scalar(b)) => Ok((a * b).into()),
            (Self::Vector(a), Self::Vector(b)) => Ok(a.cross(&b).into()),
            (a, b) => a.refused("the cross product of", &b),
        }
    }

    pub(super) fn over(self, other: Self) -> Result<Self, Meaningless> {
        match other {
            Self::Scalar(x) => self.times((Fraction::from(1) / x).into()),
            other => self.refused("the quotient of", &other),
        }
    }

    pub(super) fn power(self, n: i32) -> Result<Self, Meaningless> {
        let size = n.unsigned_abs();
        if let Self::Scalar(x) | Self::Root(x) = &self
            && !bearable(x, size)
        {
            return Err(format!("the power {n} of something this large is not worked out"));
        }
        Ok(match self {
            Self::Scalar(x) if n < 0 => (Fraction::from(1) / x.pow(size)).into(),
            Self::Scalar(x) => x.pow(size).into(),
            Self::Root(x) if n >= 0 && n % 2 == 0 => x.pow(size / 2).into(),
            Self::Matrix(m) if n == -1 => Self::Inverse(m),
            other if n == 1 => other,
            other => return Err(format!("the power {n} of {} has no meaning here", other.kind())),
        })
    }

    pub(super) fn transpose(self) -> Result<Self, Meaningless> {
        match self {
            Self::Matrix(m) => Ok(m.transpose().into()),
            other => Err(format!("the transpose of {} has no meaning here", other.kind())),
        }
    }

    pub(super) fn root(self) -> Result<Self, Meaningless> {
        match self {
            Self::Scalar(x) => Ok(Self::Root(x)),
            other => Err(format!("the root of {} has no meaning here", other.kind())),
        }
    }

    /// With all its parts reduced.
    pub(super) fn reduced(self, relations: &Relations) -> Self {
        if *relations == Relations::none() {
            return self;
        }
        match self {
            Self::Scalar(x) => relations.reduce_fraction(&x).into(),
            Self::Vector(v) => v.map(|x| relations.reduce_fraction(&x)).into(),
            Self::Matrix(m) => m.map(|x| relations.reduce_fraction(&x)).into(),
            Self::Quaternion(q) => {
                Quaternion::from_vector(q.coords.map(|x| relations.reduce_fraction(&x))).into()
            }
            other => other,
        }
    }

    /// What must be zero for the two to be equal, and what must then not be negative.
    pub(super) fn difference(self, other: Self) -> Result<(Vec<Fraction>, Option<Fraction>), Meaningless> {
        let zero = match (self, other) {
            (Self::Scalar(a), Self::Scalar(b)) | (Self::Root(a), Self::Root(b)) => vec![a - b],
            (Self::Root(a), Self::Scalar(b)) | (Self::Scalar(b), Self::Root(a)) => {
                return Ok((vec![a - &b * &b], Some(b)));
            }
            (Self::Vector(a), Self::Vector(b)) => (a - b).iter().cloned().collect(),
            (Self::Matrix(a), Self::Matrix(b)) | (Self::Inverse(a), Self::Inverse(b)) => {
                (a - b).iter().cloned().collect()
            }
            (Self::Quaternion(a), Self::Quaternion(b)) => (a.coords - b.coords).iter().cloned().collect(),
            (Self::Inverse(a), Self::Matrix(b)) | (Self::Matrix(b), Self::Inverse(a)) => {
                let one = diagonal(&Vector::from_element(Fraction::from(1)));
                (a * b - one).iter().cloned().collect()
            }
            // Enough, if more than is needed.
            (Self::Solution(m, v), Self::Solution(n, u)) => {
                (m - n).iter().chain((v - u).iter()).cloned().collect()
            }
            (Self::Solution(m, v), Self::Vector(u)) | (Self::Vector(u), Self::Solution(m, v)) => {
                (m * u - v).iter().cloned().collect()
            }
            (a, b) => return a.refused("to equate", &b),
        };
        Ok((zero, None))
    }
}

/// Whether a power can be computed in a short time: a text may nest powers.
fn bearable(x: &Fraction, n: u32) -> bool {
    [x.numerator(), x.denominator()].iter().all(|p| {
        let terms = u64::from(usize::BITS - p.len().leading_zeros());
        let digits = p.terms().map(|(_, c)| c.numer().bits() + c.denom().bits()).max().unwrap_or(0);
        [(p.degree(), 64), (terms, 36), (digits, 4096)]
            .iter()
            .all(|(size, most)| size * u64::from(n) <= *most)
    })
}

/// The product of quaternions by their scalar and vector parts: `(a, u)(b, v) = (ab - u.v, av + bu + u x v)`.
/// The library multiplies component by component; this is the other way, so that one checks the other.
fn hamilton(p: &Quaternion<Fraction>, q: &Quaternion<Fraction>) -> Quaternion<Fraction> {
    let parts = |q: &Quaternion<Fraction>| (q.coords.w.clone(), q.coords.xyz());
    let ((a, u), (b, v)) = (parts(p), parts(q));
    let scalar = &a * &b - u.dot(&v);
    let vector = u.cross(&v) + v.map(|x| x * &a) + u.map(|x| x * &b);
    quaternion(scalar, &vector)
}
