//! What is conserved while a body tumbles, and what is not.

use crate::equations::rates;
use crate::number::{Derivation, Fraction};
use crate::proof::{Residue, breaks, same};
use crate::symbols::{Matrix, Vector, changing, diagonal, symmetric, vector};
use crate::tex::Scope;
use num_traits::Zero;
use tumbling::dynamics::observe::energy;
use tumbling::{dynamics::euler::angular_acceleration, laws::momentum_rate};

proofs! {
    "euler" {
        "energy": power(&momentum_rate, &angular_acceleration),
            r"The energy $E = \tfrac{1}{2}\boldsymbol{\omega}\cdot\mathbf{L}$ changes at the rate $\dot{E} = \boldsymbol{\omega}\cdot\boldsymbol{\tau}$, and not at all without a torque: by the law of the momentum for every symmetric inverse tensor, by Euler's equations along principal axes for every spin.";
            but "the torque taken twice": power(&|j, l, t| momentum_rate(j, l, &(t * Fraction::from(2))), &angular_acceleration),
            but "the sign of one of Euler's equations": power(&momentum_rate, &one_sign_wrong),
        "length-of-momentum": length(&momentum_rate, &angular_acceleration),
            r"The momentum's square $S = \mathbf{L}\cdot\mathbf{L}$ changes at the rate $\dot{S} = 2\mathbf{L}\cdot\boldsymbol{\tau}$, and not at all without a torque: by the law of the momentum for every symmetric inverse tensor, by Euler's equations along principal axes for every spin.";
            but "the sign of one of Euler's equations": length(&momentum_rate, &one_sign_wrong),
            but "L x (J L) becomes L x (J L) + L": length(&|j, l, t| momentum_rate(j, l, t) + l, &angular_acceleration),
        "spin-is-not-conserved": spin(angular_acceleration),
            r"The spin's square $S = \omega\cdot\omega$ changes at the rate $S' = -2 (I_1 - I_2) (I_2 - I_3) (I_3 - I_1)\omega_1\omega_2\omega_3/(I_1 I_2 I_3)$, which is not zero for all bodies.";
            but "the law of a ball": spin(|_, w, t| angular_acceleration(&Vector::repeat(Fraction::from(1)), w, t)),
            but "a steady spin": spin(|_, _, _| Vector::zeros()),
    }
}

/// Euler's equations with the sign of one product changed.
pub(super) fn one_sign_wrong(moments: &Vector, omega: &Vector, torque: &Vector) -> Vector {
    let mut rate = angular_acceleration(moments, omega, torque);
    rate.y = &torque.y / &moments.y * Fraction::from(2) - rate.y.clone();
    rate
}

type MomentumLaw<'a> = &'a dyn Fn(&Matrix, &Vector, &Vector) -> Vector;
type SpinLaw<'a> = &'a dyn Fn(&Vector, &Vector, &Vector) -> Vector;

/// A quantity of spin and momentum and its rate, under both forms of the law.
fn changes(
    momentum_law: MomentumLaw<'_>,
    spin_law: SpinLaw<'_>,
    quantity: impl Fn(&Vector, &Vector) -> (&'static str, Fraction),
) -> Vec<Scope> {
    let torque = vector("tau");
    let case = |scope: Scope, omega: &Vector, momentum: &Vector, (changed, rate): (&str, Vector)| {
        let (name, x) = quantity(omega, momentum);
        let rate = changing(Derivation::default(), changed, &rate).of(&x);
        scope.with(&format!(r"\dot{{{name}}}"), rate.clone()).with(name, x).with(Scope::IT, rate)
    };
    let (inverse, momentum) = (symmetric("J"), vector("L"));
    let of_momentum = momentum_law(&inverse, &momentum, &torque);
    let (moments, omega) = (vector("I"), vector("omega"));
    let of_spin = spin_law(&moments, &omega, &torque);
    vec![
        case(rates::by_momentum_and(momentum_law), &(&inverse * &momentum), &momentum, ("L", of_momentum)),
        case(rates::pushed(&torque, spin_law), &omega, &(diagonal(&moments) * &omega), ("omega", of_spin)),
    ]
}

pub(crate) fn power(momentum_law: MomentumLaw<'_>, spin_law: SpinLaw<'_>) -> Vec<Scope> {
    changes(momentum_law, spin_law, |w, l| ("E", energy(w, l)))
}

fn length(momentum_law: MomentumLaw<'_>, spin_law: SpinLaw<'_>) -> Vec<Scope> {
    changes(momentum_law, spin_law, |_, l| ("S", l.dot(l)))
}

fn spin(law: impl Fn(&Vector, &Vector, &Vector) -> Vector) -> Result<Scope, Residue> {
    let (moments, omega) = (vector("I"), vector("omega"));
    let free = changing(Derivation::default(), "omega", &law(&moments, &omega, &Vector::zeros()));
    let square = omega.dot(&omega);
    let rate = free.of(&square);
    breaks("the spin's square stays", same("its rate", &rate, &Fraction::zero()))?;
    let scope = Scope::default().with_all([("S", square), ("S'", rate)]);
    Ok(scope.with_each("I", &moments).with_each(r"\omega", &omega).with(r"\omega", omega))
}
