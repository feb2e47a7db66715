//! Attitudes, and what turning a body does to its tensor.

use crate::number::{Fraction, Relations};
use crate::proof::{Outcome, same_entries, same_entries_under, same_under};
use crate::symbols::{Matrix, Vector, adjugate, attitude, scalar, symmetric, turning, vector};
use nalgebra::Quaternion;
use num_traits::{One, Zero};
use tumbling::attitude::{product, rate, rotation_matrix};
use tumbling::dynamics::observe::energy;
use tumbling::inertia::{omega_world, turned};

proofs! {
    "attitude" {
        "attitudes-are-rotations": rotation(rotation_matrix),
            "The matrix of every unit quaternion is a rotation: R R^T = 1, and its determinant is 1, so it mirrors nothing.";
            but "one entry's sign changed": rotation(|q| { let mut r = rotation_matrix(q); r[(0, 1)] *= -Fraction::one(); r }),
            but "mirrored": rotation(|q| -rotation_matrix(q)),
        "attitudes-multiply-as-rotations": products(product),
            "The matrix of a product of quaternions is the product of their matrices, in the same order.";
            but "the factors swapped": products(|p, q| product(q, p)),
        "attitude-rate": attitude_rate(rate),
            "q' = q (0, w) / 2 turns the body at the spin w: R' = R [w], and the length of q stays.";
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
            "R I R^T and R I^-1 R^T are inverse to each other for every attitude and every tensor that has an inverse.";
            but "R^T J R in place of R J R^T": inverse(|r, j| turned(&r.transpose(), j)),
        "moments-survive-turning": moments(turned),
            "Turned, a tensor has the same moments about the turned axes: (R I R^T) R v = R (I v) for every v; and its trace, its second invariant and its determinant are the same.";
            but "one R left out": moments(|r, i| r * i),
            but "R^T I R in place of R I R^T": moments(|r, i| turned(&r.transpose(), i)),
        "spin-from-momentum": spin(omega_world),
            "w = R J R^T L is: take L into the body, apply J, carry the spin out; and for every tensor that has an inverse J it gives L back.";
            but "R and R^T swapped": spin(|r, j, l| omega_world(&r.transpose(), j, l)),
            but "J not turned": spin(|_, j, l| j * l),
    }
    "observe" {
        "energy-in-both-frames": energies(omega_world),
            "Half of w.L is the same number in body and world axes, for every body and attitude; of one point it is m/2 |w x r|².";
            but "the inverse not turned": energies(|_, j, l| j * l),
    }
}

/// The matrix of the cross product: `[w] v = w x v`.
fn cross_matrix(w: &Vector) -> Matrix {
    let [x, y, z] = [0, 1, 2].map(|i| w[i].clone());
    let o = Fraction::zero;
    Matrix::new(o(), -z.clone(), y.clone(), z, o(), -x.clone(), -y, x, o())
}

fn rotation(law: impl Fn(&Quaternion<Fraction>) -> Matrix) -> Outcome {
    let (q, unit) = attitude();
    let r = law(&q);
    let one = Fraction::one();
    same_entries_under(&unit, "R R^T = 1", &(&r * r.transpose()), &scalar(&one))?;
    same_under(&unit, "the determinant of R", &adjugate(&r).1, &one)
}

fn products(law: impl Fn(&Quaternion<Fraction>, &Quaternion<Fraction>) -> Quaternion<Fraction>) -> Outcome {
    let (q, _) = attitude();
    let [w, x, y, z] = ["w2", "x2", "y2", "z2"].map(Fraction::variable);
    let p = Quaternion::new(w, x, y, z);
    let both = rotation_matrix(&law(&p, &q));
    same_entries_under(&Relations::none(), "R(p q)", &both, &(rotation_matrix(&p) * rotation_matrix(&q)))
}

fn attitude_rate(law: impl Fn(&Quaternion<Fraction>, &Vector) -> Quaternion<Fraction>) -> Outcome {
    let (q, unit) = attitude();
    let w = vector("omega");
    let time = turning(&law(&q, &w));
    let r = rotation_matrix(&q);
    same_entries_under(&unit, "R'", &r.map(|x| time.of(&x)), &(&r * cross_matrix(&w)))?;
    let square = q.coords.dot(&q.coords);
    same_under(&unit, "the rate of |q|²", &time.of(&square), &Fraction::zero())
}

fn inverse(law: impl Fn(&Matrix, &Matrix) -> Matrix) -> Outcome {
    let (q, unit) = attitude();
    let r = rotation_matrix(&q);
    let reduced = |m: Matrix| m.map(|x| unit.reduce_fraction(&x));
    // The inverse, times the determinant of the tensor.
    let tensor = symmetric("I");
    let (inverse, determinant) = adjugate(&tensor);
    let (there, back) = (reduced(turned(&r, &tensor)), reduced(law(&r, &inverse)));
    same_entries_under(&unit, "there and back", &(there * back), &scalar(&determinant))
}

fn moments(law: impl Fn(&Matrix, &Matrix) -> Matrix) -> Outcome {
    let (q, unit) = attitude();
    let r = rotation_matrix(&q);
    let reduced = |m: Matrix| m.map(|x| unit.reduce_fraction(&x));
    let tensor = symmetric("I");
    let v = vector("v");
    let there = reduced(law(&r, &tensor));
    same_entries_under(&unit, "the tensor along R v", &(&there * (&r * &v)), &(&r * (&tensor * &v)))?;
    same_under(&unit, "the trace", &there.trace(), &tensor.trace())?;
    let (minors, determinant) = adjugate(&there);
    let (own_minors, own_determinant) = adjugate(&tensor);
    same_under(&unit, "the second invariant", &minors.trace(), &own_minors.trace())?;
    same_under(&unit, "the determinant", &determinant, &own_determinant)
}

fn spin(law: impl Fn(&Matrix, &Matrix, &Vector) -> Vector) -> Outcome {
    let (q, unit) = attitude();
    let r = rotation_matrix(&q);
    let (j, l) = (symmetric("J"), vector("L"));
    let in_steps = &r * (&j * (r.transpose() * &l));
    same_entries("w", &law(&r, &j, &l), &in_steps)?;
    // The momentum of that spin is the momentum; the inverse is taken times the tensor's determinant.
    let tensor = symmetric("I");
    let (inverse, determinant) = adjugate(&tensor);
    let omega = law(&r, &inverse, &l).map(|x| unit.reduce_fraction(&x));
    let momentum = &r * (&tensor * (r.transpose() * omega).map(|x| unit.reduce_fraction(&x)));
    same_entries_under(&unit, "L = R I R^T w", &momentum, &l.map(|x| x * determinant.clone()))
}

fn energies(law: impl Fn(&Matrix, &Matrix, &Vector) -> Vector) -> Outcome {
    let (q, _) = attitude();
    let r = rotation_matrix(&q);
    let (j, l) = (symmetric("J"), vector("L"));
    let l_body = r.transpose() * &l;
    let in_world = energy(&law(&r, &j, &l), &l);
    same_under(&Relations::none(), "half of w.L", &in_world, &energy(&(&j * &l_body), &l_body))?;
    // And it is what each point's speed adds up to: m/2 |w x r|².
    let (m, w, at) = (Fraction::variable("m"), vector("omega"), vector("r"));
    let speed = w.cross(&at);
    let momentum = tumbling::inertia::point_mass(&m, &at) * &w;
    let kinetic = m * speed.dot(&speed) / Fraction::from(2);
    same_under(&Relations::none(), "the kinetic energy of a point", &energy(&w, &momentum), &kinetic)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_matrix_of_a_cross_product_is_one() {
        let (w, v) = (vector("omega"), vector("v"));
        assert_eq!(cross_matrix(&w) * &v, w.cross(&v));
        assert_eq!(cross_matrix(&Vector::zeros()), Matrix::zeros());
    }
}
