//! Attitudes, and what turning a body does to its tensor.

use crate::number::{Derivation, Fraction, Relations};
use crate::proof::{
    Mutant, Outcome, Proof, same_matrices_under, same_under, same_vectors, same_vectors_under,
};
use crate::symbols::{Matrix, Vector, adjugate, attitude, scalar, symmetric, vector};
use nalgebra::Quaternion;
use num_traits::{One, Zero};
use tumbling::attitude::{product, rate, rotation_matrix};
use tumbling::dynamics::observe::energy;
use tumbling::inertia::{omega_world, turned};

pub(super) const PROOFS: &[Proof] = &[
    Proof {
        name: "attitudes-are-rotations",
        part: "attitude",
        statement: "The matrix of every unit quaternion is a rotation: R R^T = 1, and its determinant is 1, so it \
                    mirrors nothing.",
        check: || rotation(rotation_matrix),
        mutants: &[
            Mutant {
                change: "one entry's sign changed",
                check: || rotation(|q| with_entry(rotation_matrix(q), 0, 1, -Fraction::one())),
            },
            Mutant { change: "mirrored", check: || rotation(|q| -rotation_matrix(q)) },
        ],
    },
    Proof {
        name: "attitudes-multiply-as-rotations",
        part: "attitude",
        statement: "The matrix of a product of quaternions is the product of their matrices, in the same order.",
        check: || products(product),
        mutants: &[Mutant { change: "the factors swapped", check: || products(|p, q| product(q, p)) }],
    },
    Proof {
        name: "attitude-rate",
        part: "attitude",
        statement: "q' = q (0, w) / 2 turns the body at the spin w: R' = R [w], and the length of q stays.",
        check: || attitude_rate(rate),
        mutants: &[
            Mutant {
                change: "the half left out",
                check: || attitude_rate(|q, w| rate(q, &w.map(|x| x * Fraction::from(2)))),
            },
            Mutant {
                change: "the spin in world axes",
                check: || {
                    attitude_rate(|q, w| {
                        let [x, y, z] = [0, 1, 2].map(|i| &w[i] / Fraction::from(2));
                        product(&Quaternion::new(Fraction::zero(), x, y, z), q)
                    })
                },
            },
        ],
    },
    Proof {
        name: "turning-back",
        part: "inertia",
        statement: "R I R^T and R I^-1 R^T are inverse to each other for every attitude and every tensor that has an inverse.",
        check: || inverse(turned),
        mutants: &[Mutant {
            change: "R^T J R in place of R J R^T",
            check: || inverse(|r, j| turned(&r.transpose(), j)),
        }],
    },
    Proof {
        name: "moments-survive-turning",
        part: "inertia",
        statement: "Turned, a tensor has the same moments about the turned axes: (R I R^T) R v = R (I v) for every v; and its trace, \
                    its second invariant and its determinant are the same.",
        check: || moments(turned),
        mutants: &[
            Mutant { change: "one R left out", check: || moments(|r, i| r * i) },
            Mutant {
                change: "R^T I R in place of R I R^T",
                check: || moments(|r, i| turned(&r.transpose(), i)),
            },
        ],
    },
    Proof {
        name: "spin-from-momentum",
        part: "inertia",
        statement: "w = R J R^T L is: take L into the body, apply J, carry the spin out; and for every tensor that has an inverse J \
                    it gives L back.",
        check: || spin(omega_world),
        mutants: &[
            Mutant {
                change: "R and R^T swapped",
                check: || spin(|r, j, l| omega_world(&r.transpose(), j, l)),
            },
            Mutant { change: "J not turned", check: || spin(|_, j, l| j * l) },
        ],
    },
    Proof {
        name: "energy-in-both-frames",
        part: "observe",
        statement: "Half of w.L is the same number in body and world axes, for every body and attitude; of one point it is m/2 |w x \
                    r|².",
        check: || energies(omega_world),
        mutants: &[Mutant { change: "the inverse not turned", check: || energies(|_, j, l| j * l) }],
    },
];

fn with_entry(mut m: Matrix, i: usize, j: usize, factor: Fraction) -> Matrix {
    m[(i, j)] *= factor;
    m
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
    same_matrices_under(&unit, "R R^T = 1", &(&r * r.transpose()), &scalar(&one))?;
    same_under(&unit, "the determinant of R", &adjugate(&r).1, &one)
}

fn products(law: impl Fn(&Quaternion<Fraction>, &Quaternion<Fraction>) -> Quaternion<Fraction>) -> Outcome {
    let (q, _) = attitude();
    let [w, x, y, z] = ["w2", "x2", "y2", "z2"].map(Fraction::variable);
    let p = Quaternion::new(w, x, y, z);
    let both = rotation_matrix(&law(&p, &q));
    same_matrices_under(&Relations::none(), "R(p q)", &both, &(rotation_matrix(&p) * rotation_matrix(&q)))
}

/// The rate of change with time, when the attitude changes by `rate` and nothing else does.
fn turning(rate: &Quaternion<Fraction>) -> Derivation {
    let c = &rate.coords;
    Derivation::new([("w", c.w.clone()), ("x", c.x.clone()), ("y", c.y.clone()), ("z", c.z.clone())])
}

fn attitude_rate(law: impl Fn(&Quaternion<Fraction>, &Vector) -> Quaternion<Fraction>) -> Outcome {
    let (q, unit) = attitude();
    let w = vector("omega");
    let time = turning(&law(&q, &w));
    let r = rotation_matrix(&q);
    same_matrices_under(&unit, "R'", &r.map(|x| time.of(&x)), &(&r * cross_matrix(&w)))?;
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
    same_matrices_under(&unit, "there and back", &(there * back), &scalar(&determinant))
}

fn moments(law: impl Fn(&Matrix, &Matrix) -> Matrix) -> Outcome {
    let (q, unit) = attitude();
    let r = rotation_matrix(&q);
    let reduced = |m: Matrix| m.map(|x| unit.reduce_fraction(&x));
    let tensor = symmetric("I");
    let v = vector("v");
    let there = reduced(law(&r, &tensor));
    same_vectors_under(&unit, "the tensor along R v", &(&there * (&r * &v)), &(&r * (&tensor * &v)))?;
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
    same_vectors("w", &law(&r, &j, &l), &in_steps)?;
    // The momentum of that spin is the momentum; the inverse is taken times the tensor's determinant.
    let tensor = symmetric("I");
    let (inverse, determinant) = adjugate(&tensor);
    let omega = law(&r, &inverse, &l).map(|x| unit.reduce_fraction(&x));
    let momentum = &r * (&tensor * (r.transpose() * omega).map(|x| unit.reduce_fraction(&x)));
    same_vectors_under(&unit, "L = R I R^T w", &momentum, &l.map(|x| x * determinant.clone()))
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
