//! Euler's equations, from the single law that the torque is the rate of the momentum in the world.

use crate::equations::rates;
use crate::number::{Derivation, Fraction};
use crate::symbols::{Matrix, Vector, attitude, changing, diagonal, symmetric, turning, vector};
use crate::tex::Scope;
use nalgebra::{Quaternion, Vector3};
use tumbling::attitude::{rate, rotation_matrix};
use tumbling::dynamics::euler::{angular_acceleration, coupling, tensor_times_acceleration};
use tumbling::laws::momentum_rate;

proofs! {
    "euler" {
        "euler-from-constant-momentum": from_momentum(tensor_times_acceleration),
            r"Where the attitude has its own rate, the momentum in the room, $P = R I\omega$, changes by $P' - R\tau = R (I\omega' - A)$, where $A = (I\omega)\times\omega + \tau$ is the library's law. So the momentum answers to the torque exactly if Euler's equations hold. For every tensor, attitude, spin and torque.";
            but "w x (I w) for (I w) x w": from_momentum(|i, w, t| -tensor_times_acceleration(i, w, &-t)),
            but "the gyroscopic term left out": from_momentum(|_, _, t| t.clone()),
        "momentum-form": both_forms(momentum_rate),
            r"The law $\dot{\mathbf{L}} = \mathbf{L}\times (J\mathbf{L}) + \boldsymbol{\tau}$ is the same as Euler's, $I\dot{\boldsymbol{\omega}} = (I\boldsymbol{\omega})\times\boldsymbol{\omega} + \boldsymbol{\tau}$, with $\mathbf{L} = I\boldsymbol{\omega}$ and $J\mathbf{L} = \boldsymbol{\omega}$, for every tensor that has an inverse.";
            but "(J L) x L for L x (J L)": both_forms(|j, l, t| -momentum_rate(j, l, &-t)),
            but "the torque left out": both_forms(|j, l, _| momentum_rate(j, l, &Vector::zeros())),
        "principal-form": principal_form(coupling, angular_acceleration),
            r"Along principal axes each form of the law is as Euler wrote it: $I_1\dot{\omega}_1 = (I_2 - I_3)\omega_2\omega_3 + \tau_1$, $I_2\dot{\omega}_2 = (I_3 - I_1)\omega_3\omega_1 + \tau_2$, $I_3\dot{\omega}_3 = (I_1 - I_2)\omega_1\omega_2 + \tau_3$.";
            but "the sign of one equation": principal_form(|i, w| { let mut x = coupling(i, w); x.y = -x.y.clone(); x }, angular_acceleration),
            but "two moments swapped": principal_form(|i, w| coupling(&swapped(i), w), angular_acceleration),
        "spin-rate-in-both-frames": spin_rate(rate),
            r"The rate of the spin is the same seen from body and world: of $S = R\omega$ it is $S' = R\omega'$.";
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

fn from_momentum(law: impl Fn(&Matrix, &Vector, &Vector) -> Vector) -> Scope {
    let (q, unit) = attitude();
    let r = rotation_matrix(&q);
    let (tensor, w, torque) = (symmetric("I"), vector("omega"), vector("tau"));
    let (momentum, time) = (&r * (&tensor * &w), time(&rate(&q, &w)));
    Scope::default()
        .with("P'", momentum.map(|x| time.of(&x)))
        .with("P", momentum)
        .with("A", law(&tensor, &w, &torque))
        .with("R", r)
        .with("I", tensor)
        .with(r"\omega", w)
        .with(r"\omega'", vector("alpha"))
        .with(r"\tau", torque)
        .under(unit)
}

fn both_forms(law: impl Fn(&Matrix, &Vector, &Vector) -> Vector) -> Vec<Scope> {
    vec![rates::by_momentum_and(law), rates::by_spin()]
}

fn principal_form(
    coupling: impl Fn(&Vector, &Vector) -> Vector,
    law: impl Fn(&Vector, &Vector, &Vector) -> Vector,
) -> Vec<Scope> {
    let torque = vector("tau");
    vec![
        rates::pushed(&torque, law),
        rates::pushed(&torque, |i, w, t| (coupling(i, w) + t).component_div(i)),
        rates::pushed(&torque, |i, w, t| tensor_times_acceleration(&diagonal(i), w, t).component_div(i)),
    ]
}

fn spin_rate(law: impl Fn(&Quaternion<Fraction>, &Vector) -> Quaternion<Fraction>) -> Scope {
    let (q, unit) = attitude();
    let (r, w) = (rotation_matrix(&q), vector("omega"));
    let (time, spin) = (time(&law(&q, &w)), &r * &w);
    let scope = Scope::default().with("S'", spin.map(|x| time.of(&x))).with("S", spin).with("R", r);
    scope.with(r"\omega", w).with(r"\omega'", vector("alpha")).under(unit)
}
