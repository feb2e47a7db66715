//! Euler's equations, from the one law that world momentum answers to the torque.

use crate::number::{Derivation, Fraction};
use crate::proof::{Outcome, same_entries, same_entries_under};
use crate::symbols::{Matrix, Vector, attitude, changing, diagonal, inverse, symmetric, turning, vector};
use nalgebra::{Quaternion, Vector3};
use tumbling::attitude::{rate, rotation_matrix};
use tumbling::dynamics::euler::{angular_acceleration, coupling, momentum_rate, tensor_times_acceleration};

proofs! {
    "euler" {
        "euler-from-constant-momentum": from_momentum(tensor_times_acceleration),
            "Differentiate R I w, with R' as the attitude's own rate: it equals the world's torque exactly if I w' = (I w) x w + torque. For every tensor, attitude, spin and torque.";
            but "w x (I w) for (I w) x w": from_momentum(|i, w, t| -tensor_times_acceleration(i, w, &-t)),
            but "the gyroscopic term left out": from_momentum(|_, _, t| t.clone()),
        "momentum-form": both_forms(momentum_rate),
            "L' = L x (J L) + torque is the same law as I w' = (I w) x w + torque, with L = I w and J I = 1, for every tensor that has an inverse.";
            but "(J L) x L for L x (J L)": both_forms(|j, l, t| -momentum_rate(j, l, &-t)),
            but "the torque left out": both_forms(|j, l, _| momentum_rate(j, l, &Vector::zeros())),
        "principal-form": principal_form(coupling, angular_acceleration),
            "Along principal axes the law is I1 w1' = (I2 - I3) w2 w3 + torque1 and so on round, as Euler wrote it.";
            but "the sign of one equation": principal_form(|i, w| { let mut x = coupling(i, w); x.y = -x.y.clone(); x }, angular_acceleration),
            but "two moments swapped": principal_form(|i, w| coupling(&swapped(i), w), angular_acceleration),
        "spin-rate-in-both-frames": spin_rate(rate),
            "The rate of the spin is the same seen from body and world: (R w)' = R w', since w x w = 0.";
            but "the attitude turning about a fixed axis in place of the spin": spin_rate(|q, _| rate(q, &vector("e"))),
    }
}

fn swapped(v: &Vector) -> Vector {
    Vector3::new(v.y.clone(), v.x.clone(), v.z.clone())
}

/// The rate of change with time where the attitude changes by `rate` and the spin by `alpha`.
fn time(rate: &Quaternion<Fraction>) -> Derivation {
    changing(turning(rate), "omega", &vector("alpha"))
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
    same_entries_under(&unit, "the rate of R I w", &left, &right)
}

fn both_forms(law: impl Fn(&Matrix, &Vector, &Vector) -> Vector) -> Outcome {
    let (tensor, w, torque) = (symmetric("I"), vector("omega"), vector("tau"));
    let rate = law(&inverse(&tensor), &(&tensor * &w), &torque);
    same_entries("L'", &rate, &tensor_times_acceleration(&tensor, &w, &torque))
}

fn principal_form(
    coupling: impl Fn(&Vector, &Vector) -> Vector,
    law: impl Fn(&Vector, &Vector, &Vector) -> Vector,
) -> Outcome {
    let (moments, w, torque) = (vector("I"), vector("omega"), vector("tau"));
    let right = tensor_times_acceleration(&diagonal(&moments), &w, &torque);
    same_entries("the coupling", &(coupling(&moments, &w) + &torque), &right)?;
    same_entries("I w'", &law(&moments, &w, &torque).component_mul(&moments), &right)
}

fn spin_rate(law: impl Fn(&Quaternion<Fraction>, &Vector) -> Quaternion<Fraction>) -> Outcome {
    let (q, unit) = attitude();
    let r = rotation_matrix(&q);
    let (w, alpha) = (vector("omega"), vector("alpha"));
    let time = time(&law(&q, &w));
    same_entries_under(&unit, "the rate of R w", &(&r * &w).map(|x| time.of(&x)), &(&r * alpha))
}
