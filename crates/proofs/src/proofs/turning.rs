//! Attitudes, and what turning a body does to its tensor.

use crate::number::Fraction;
use crate::proof::{Residue, same_under};
use crate::symbols::{Matrix, Vector, adjugate, attitude, symmetric, turning, vector};
use crate::tex::Scope;
use nalgebra::Quaternion;
use num_traits::{One, Zero};
use tumbling::attitude::{product, rate, rotation_matrix};
use tumbling::dynamics::observe::energy;
use tumbling::inertia::{omega_world, turned};

proofs! {
    "attitude" {
        "attitudes-are-rotations": rotation(rotation_matrix),
            r"The matrix of every unit quaternion is a rotation: $R R^T v = v$ for every vector, and its determinant is $d = 1$, so it mirrors nothing.";
            but "one entry's sign changed": rotation(|q| { let mut r = rotation_matrix(q); r[(0, 1)] *= -Fraction::one(); r }),
            but "mirrored": rotation(|q| -rotation_matrix(q)),
        "attitudes-multiply-as-rotations": products(product),
            r"The matrix of a product of quaternions is the product of their matrices, in the same order, $R = A B$.";
            but "the factors swapped": products(|p, q| product(q, p)),
        "attitude-rate": attitude_rate(rate),
            r"With $q' = \tfrac{1}{2} q (0, \omega)$ the body turns at this spin, $R' v = R (\omega\times v)$ for every vector, and the length of the quaternion stays, $l' = 0$ for its square.";
            but "the half left out": attitude_rate(|q, w| rate(q, &w.map(|x| x * Fraction::from(2)))),
            but "the spin in world axes": {
                    attitude_rate(|q, w| {
                        let [x, y, z] = [0, 1, 2].map(|i| &w[i] / Fraction::from(2));
                        product(&Quaternion::new(Fraction::zero(), x, y, z), q)
                    })
                },
    }
    "inertia" {
        "turning-back": inverse(turned),
            r"For every attitude and every tensor that has an inverse, $A = R I R^T$ and $B = R J R^T$ are inverse to each other as $I$ and $J$ are, up to the determinant: $I J v = d v$ and $A B v = d v$.";
            but "R^T J R in place of R J R^T": inverse(|r, j| turned(&r.transpose(), j)),
        "moments-survive-turning": moments(turned),
            r"Turned, a tensor has the same moments about the turned axes: for $A = R I R^T$ and every vector $A R v = R I v$; and its trace, its second invariant and its determinant are the same.";
            but "one R left out": moments(|r, i| r * i),
            but "R^T I R in place of R I R^T": moments(|r, i| turned(&r.transpose(), i)),
        "spin-from-momentum": spin(omega_world),
            r"The spin is $\omega = R J R^T L$: take the momentum into the body, apply the inverse, carry the spin out. For every tensor that has an inverse this gives the momentum back, up to the determinant: $R I R^T\omega = d L$.";
            but "R and R^T swapped": spin(|r, j, l| omega_world(&r.transpose(), j, l)),
            but "J not turned": spin(|_, j, l| j * l),
    }
    "observe" {
        "energy-in-both-frames": energies(omega_world),
            r"The energy is the same number in body and world axes, $E = \tfrac{1}{2} (J R^T L)\cdot (R^T L)$, for every body and attitude; of one point it is $E = \tfrac{1}{2} m (\omega\times r)\cdot (\omega\times r)$.";
            but "the inverse not turned": energies(|_, j, l| j * l),
    }
}

fn rotation(law: impl Fn(&Quaternion<Fraction>) -> Matrix) -> Scope {
    let (q, unit) = attitude();
    let r = law(&q);
    Scope::default().with("d", adjugate(&r).1).with("R", r).with("v", vector("v")).under(unit)
}

fn products(law: impl Fn(&Quaternion<Fraction>, &Quaternion<Fraction>) -> Quaternion<Fraction>) -> Scope {
    let (q, _) = attitude();
    let [w, x, y, z] = ["w2", "x2", "y2", "z2"].map(Fraction::variable);
    let p = Quaternion::new(w, x, y, z);
    let scope = Scope::default().with("A", rotation_matrix(&p)).with("B", rotation_matrix(&q));
    scope.with("R", rotation_matrix(&law(&p, &q)))
}

fn attitude_rate(law: impl Fn(&Quaternion<Fraction>, &Vector) -> Quaternion<Fraction>) -> Scope {
    let (q, unit) = attitude();
    let (w, r) = (vector("omega"), rotation_matrix(&q));
    let change = law(&q, &w);
    let time = turning(&change);
    let lengthens = time.of(&q.coords.dot(&q.coords));
    let scope = Scope::default().with("R'", r.map(|x| time.of(&x))).with("R", r).with("l'", lengthens);
    scope.with("q", q).with("q'", change).with(r"\omega", w).with("v", vector("v")).under(unit)
}

fn inverse(law: impl Fn(&Matrix, &Matrix) -> Matrix) -> Scope {
    let (q, unit) = attitude();
    let (r, tensor) = (rotation_matrix(&q), symmetric("I"));
    // The inverse, times the determinant of the tensor.
    let (inverse, determinant) = adjugate(&tensor);
    let scope = Scope::default().with("A", turned(&r, &tensor)).with("B", law(&r, &inverse)).with("R", r);
    scope.with("I", tensor).with("J", inverse).with("d", determinant).with("v", vector("v")).under(unit)
}

fn moments(law: impl Fn(&Matrix, &Matrix) -> Matrix) -> Result<Scope, Residue> {
    let (q, unit) = attitude();
    let r = rotation_matrix(&q);
    let reduced = |m: Matrix| m.map(|x| unit.reduce_fraction(&x));
    let tensor = symmetric("I");
    let v = vector("v");
    let there = reduced(law(&r, &tensor));
    same_under(&unit, "the trace", &there.trace(), &tensor.trace())?;
    let (minors, determinant) = adjugate(&there);
    let (own_minors, own_determinant) = adjugate(&tensor);
    same_under(&unit, "the second invariant", &minors.trace(), &own_minors.trace())?;
    same_under(&unit, "the determinant", &determinant, &own_determinant)?;
    Ok(Scope::default().with("A", there).with("R", r).with("I", tensor).with("v", v).under(unit))
}

fn spin(law: impl Fn(&Matrix, &Matrix, &Vector) -> Vector) -> Vec<Scope> {
    let (q, unit) = attitude();
    let (r, tensor, l) = (rotation_matrix(&q), symmetric("I"), vector("L"));
    let (inverse, determinant) = adjugate(&tensor);
    let with = |j: Matrix| {
        let scope = Scope::default().with(r"\omega", law(&r, &j, &l)).with("R", r.clone());
        scope.with("L", l.clone()).with("J", j).under(unit.clone())
    };
    vec![with(symmetric("J")), with(inverse).with("I", tensor).with("d", determinant)]
}

fn energies(law: impl Fn(&Matrix, &Matrix, &Vector) -> Vector) -> Vec<Scope> {
    let (q, _) = attitude();
    let (r, j, l) = (rotation_matrix(&q), symmetric("J"), vector("L"));
    let in_world = energy(&law(&r, &j, &l), &l);
    let body = Scope::default().with("E", in_world).with("R", r).with("J", j).with("L", l);
    let (m, w, at) = (Fraction::variable("m"), vector("omega"), vector("r"));
    let of_point = energy(&w, &(tumbling::inertia::point_mass(&m, &at) * &w));
    vec![body, Scope::default().with("E", of_point).with("m", m).with(r"\omega", w).with("r", at)]
}
