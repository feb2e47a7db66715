//! Euler's equations, from the one law that world momentum answers to the torque.

use crate::number::{Derivation, Fraction};
use crate::proof::{Mutant, Outcome, Proof, same_vectors, same_vectors_under};
use crate::symbols::{Matrix, Vector, adjugate, attitude, diagonal, symmetric, vector};
use nalgebra::{Quaternion, Vector3};
use tumbling::attitude::{rate, rotation_matrix};
use tumbling::dynamics::euler::{angular_acceleration, coupling, momentum_rate, tensor_times_acceleration};

pub(super) const PROOFS: &[Proof] = &[
    Proof {
        name: "euler-from-constant-momentum",
        part: "euler",
        statement: "Differentiate R I w, with R' as the attitude's own rate: it equals the world's torque exactly if \
                    I w' = (I w) x w + torque. For every tensor, attitude, spin and torque.",
        check: || from_momentum(tensor_times_acceleration),
        mutants: &[
            Mutant {
                change: "w x (I w) for (I w) x w",
                check: || from_momentum(|i, w, t| -tensor_times_acceleration(i, w, &-t)),
            },
            Mutant { change: "the gyroscopic term left out", check: || from_momentum(|_, _, t| t.clone()) },
            Mutant {
                change: "the torque's sign",
                check: || from_momentum(|i, w, t| tensor_times_acceleration(i, w, &-t)),
            },
        ],
    },
    Proof {
        name: "momentum-form",
        part: "euler",
        statement: "L' = L x (J L) + torque is the same law as I w' = (I w) x w + torque, with L = I w and J I = 1, for every tensor \
                    that has an inverse.",
        check: || both_forms(momentum_rate),
        mutants: &[
            Mutant {
                change: "(J L) x L for L x (J L)",
                check: || both_forms(|j, l, t| -momentum_rate(j, l, &-t)),
            },
            Mutant {
                change: "the torque left out",
                check: || both_forms(|j, l, _| momentum_rate(j, l, &Vector::zeros())),
            },
        ],
    },
    Proof {
        name: "principal-form",
        part: "euler",
        statement: "Along principal axes the law is I1 w1' = (I2 - I3) w2 w3 + torque1 and so on round, as Euler wrote it.",
        check: || principal_form(coupling, angular_acceleration),
        mutants: &[
            Mutant {
                change: "the sign of one equation",
                check: || {
                    principal_form(|i, w| coupling(i, w).component_mul(&signs(1)), angular_acceleration)
                },
            },
            Mutant {
                change: "two moments swapped",
                check: || principal_form(|i, w| coupling(&swapped(i), w), angular_acceleration),
            },
            Mutant {
                change: "the torque not divided by the moments",
                check: || {
                    principal_form(coupling, |i, w, t| angular_acceleration(i, w, &Vector::zeros()) + t)
                },
            },
        ],
    },
    Proof {
        name: "spin-rate-in-both-frames",
        part: "euler",
        statement: "The rate of the spin is the same seen from body and world: (R w)' = R w', since w x w = 0.",
        check: || spin_rate(rate),
        mutants: &[Mutant {
            change: "the attitude turning about a fixed axis in place of the spin",
            check: || spin_rate(|q, _| rate(q, &vector("e"))),
        }],
    },
];

/// Plus, but minus at `axis`.
fn signs(axis: usize) -> Vector {
    Vector::from_fn(|i, _| Fraction::from(if i == axis { -1 } else { 1 }))
}

fn swapped(v: &Vector) -> Vector {
    Vector3::new(v.y.clone(), v.x.clone(), v.z.clone())
}

/// The rate of change with time where the attitude changes by `q_rate` and the spin `omega` by `alpha`.
fn time(q_rate: &Quaternion<Fraction>) -> Derivation {
    let (alpha, q_rate) = (vector("alpha"), &q_rate.coords);
    ["w", "x", "y", "z"]
        .into_iter()
        .zip([q_rate.w.clone(), q_rate.x.clone(), q_rate.y.clone(), q_rate.z.clone()])
        .chain(["omega1", "omega2", "omega3"].into_iter().zip(alpha.iter().cloned()))
        .fold(Derivation::default(), |all, (name, rate)| all.and(name, rate))
}

fn from_momentum(law: impl Fn(&Matrix, &Vector, &Vector) -> Vector) -> Outcome {
    let (q, unit) = attitude();
    let r = rotation_matrix(&q);
    let (tensor, w, alpha, torque) = (symmetric("I"), vector("omega"), vector("alpha"), vector("tau"));
    let momentum = &r * (&tensor * &w);
    let time = time(&rate(&q, &w));
    let momentum_rate = momentum.map(|x| time.of(&x));
    // (R I w)' - R torque = R (I w' - law): one vanishes exactly if the other does.
    let left = momentum_rate - &r * &torque;
    let right = &r * (&tensor * alpha - law(&tensor, &w, &torque));
    same_vectors_under(&unit, "the rate of R I w", &left, &right)
}

fn both_forms(law: impl Fn(&Matrix, &Vector, &Vector) -> Vector) -> Outcome {
    let (tensor, w, torque) = (symmetric("I"), vector("omega"), vector("tau"));
    let (adjugate, determinant) = adjugate(&tensor);
    let inverse = adjugate.map(|x| x / determinant.clone());
    let rate = law(&inverse, &(&tensor * &w), &torque);
    same_vectors("L'", &rate, &tensor_times_acceleration(&tensor, &w, &torque))
}

fn principal_form(
    coupling: impl Fn(&Vector, &Vector) -> Vector,
    law: impl Fn(&Vector, &Vector, &Vector) -> Vector,
) -> Outcome {
    let (moments, w, torque) = (vector("I"), vector("omega"), vector("tau"));
    let right = tensor_times_acceleration(&diagonal(&moments), &w, &torque);
    same_vectors("the coupling", &(coupling(&moments, &w) + &torque), &right)?;
    same_vectors("I w'", &law(&moments, &w, &torque).component_mul(&moments), &right)
}

fn spin_rate(law: impl Fn(&Quaternion<Fraction>, &Vector) -> Quaternion<Fraction>) -> Outcome {
    let (q, unit) = attitude();
    let r = rotation_matrix(&q);
    let (w, alpha) = (vector("omega"), vector("alpha"));
    let time = time(&law(&q, &w));
    same_vectors_under(&unit, "the rate of R w", &(&r * &w).map(|x| time.of(&x)), &(&r * alpha))
}
