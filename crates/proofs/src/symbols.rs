//! Every body at once: moments, spins, tensors and attitudes made of symbols.

use crate::number::{Derivation, Fraction, Polynomial, Relations, Series};
use nalgebra::{Matrix3, Quaternion, Vector3};
use num_traits::{One, Zero};
use tumbling::step::System;

/// Fractions in named variables.
pub type Vector = Vector3<Fraction>;
/// Fractions in named variables.
pub type Matrix = Matrix3<Fraction>;

/// The variables of these names.
#[must_use]
pub fn variables<const N: usize>(names: [&str; N]) -> [Fraction; N] {
    names.map(Fraction::variable)
}

/// The vector `(name1, name2, name3)`.
///
/// ```
/// assert_eq!(tumbling_proofs::symbols::vector("omega")[1].to_string(), "omega2");
/// ```
#[must_use]
pub fn vector(name: &str) -> Vector {
    Vector::from_fn(|i, _| Fraction::variable(&format!("{name}{}", i + 1)))
}

/// The momentum that the library gives a spin, along principal axes.
pub(crate) fn momentum(moments: &Vector, omega: &Vector) -> Vector {
    let [moments, omega] = [moments, omega].map(|v| v.map(Series::constant));
    let momentum = System::of_numbers(moments, Vec::new()).momentum(&omega);
    momentum.map(|x| x.coefficient(0).unwrap_or_else(|| Fraction::one() / Fraction::zero()))
}

/// The symmetric matrix with entries `name_xx`, `name_xy`, ...
#[must_use]
pub fn symmetric(name: &str) -> Matrix {
    Matrix::from_fn(|i, j| {
        let axes = ["x", "y", "z"];
        Fraction::variable(&format!("{name}_{}{}", axes[i.min(j)], axes[i.max(j)]))
    })
}

/// The diagonal matrix with these entries.
#[must_use]
pub fn diagonal(entries: &Vector) -> Matrix {
    Matrix::from_diagonal(entries)
}

/// The attitude `w + x i + y j + z k`, and the relation that makes it one: length 1.
#[must_use]
pub fn attitude() -> (Quaternion<Fraction>, Relations) {
    let names = ["w", "x", "y", "z"];
    let [w, x, y, z] = variables(names);
    (Quaternion::new(w, x, y, z), Relations::unit_quaternion(names))
}

/// Three moments in order of size, `I1 < I2 < I3`: `I1`, `I1 + a`, `I1 + a + b` with `a` and `b` positive.
#[must_use]
pub fn ordered_moments() -> Vector {
    let [i, a, b] = variables(["I1", "a", "b"]);
    Vector::new(i.clone(), &i + &a, i + a + b)
}

/// The matrix of cofactors, transposed, which is the inverse times the determinant; and the determinant.
#[must_use]
pub fn adjugate(m: &Matrix) -> (Matrix, Fraction) {
    let adjugate = Matrix::from_fn(|i, j| {
        let ((r, s), (p, q)) = (((j + 1) % 3, (j + 2) % 3), ((i + 1) % 3, (i + 2) % 3));
        &m[(r, p)] * &m[(s, q)] - &m[(r, q)] * &m[(s, p)]
    });
    let determinant =
        &m[(0, 0)] * &adjugate[(0, 0)] + &m[(0, 1)] * &adjugate[(1, 0)] + &m[(0, 2)] * &adjugate[(2, 0)];
    (adjugate, determinant)
}

/// The inverse, by cofactors.
pub(crate) fn inverse(m: &Matrix) -> Matrix {
    let (adjugate, determinant) = adjugate(m);
    adjugate.map(|x| x / &determinant)
}

/// The inverse of the diagonal matrix with these entries.
pub(crate) fn inverse_diagonal(entries: &Vector) -> Matrix {
    diagonal(&entries.map(|x| Fraction::one() / x))
}

/// The square of the variable of this name.
pub(crate) fn square(name: &str) -> Polynomial {
    Polynomial::variable(name).pow(2)
}

/// The quaternion of these two parts.
pub(crate) fn quaternion(real: Fraction, v: &Vector) -> Quaternion<Fraction> {
    Quaternion::new(real, v.x.clone(), v.y.clone(), v.z.clone())
}

/// The quaternion without a real part.
pub(crate) fn pure(v: &Vector) -> Quaternion<Fraction> {
    quaternion(Fraction::zero(), v)
}

/// The derivative by time, where the components of [`attitude`] have these rates.
pub(crate) fn turning(rate: &Quaternion<Fraction>) -> Derivation {
    let c = &rate.coords;
    Derivation::new([("w", c.w.clone()), ("x", c.x.clone()), ("y", c.y.clone()), ("z", c.z.clone())])
}

/// The derivative `all`, where the components of the [`vector`] of this name have these rates besides.
pub(crate) fn changing(all: Derivation, name: &str, rate: &Vector) -> Derivation {
    (0..3).fold(all, |all, i| all.and(&format!("{name}{}", i + 1), rate[i].clone()))
}
