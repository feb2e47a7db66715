//! What stays while a body tumbles, and what does not.

use crate::number::{Derivation, Fraction, Rational};
use crate::proof::{Outcome, breaks, same};
use crate::symbols::{Matrix, Vector, changing, diagonal, symmetric, variables, vector};
use num_traits::Zero;
use tumbling::dynamics::euler::{angular_acceleration, momentum_rate};
use tumbling::dynamics::observe::energy;

proofs! {
    "euler" {
        "energy": power(momentum_rate, angular_acceleration),
            "The energy changes at the rate w.torque, and not at all without: by the law of the momentum for every symmetric J, by Euler's equations along principal axes for every spin.";
            but "the torque taken twice": power(|j, l, t| momentum_rate(j, l, &(t * Fraction::from(2))), angular_acceleration),
            but "the sign of one of Euler's equations": power(momentum_rate, one_sign_wrong),
        "length-of-momentum": length(momentum_rate, angular_acceleration),
            "|L|² changes at the rate 2 L.torque, and not at all without: by the law of the momentum for every symmetric J, by Euler's equations along principal axes for every spin.";
            but "the sign of one of Euler's equations": length(momentum_rate, one_sign_wrong),
            but "L x (J L) becomes L x (J L) + L": length(|j, l, t| momentum_rate(j, l, t) + l, angular_acceleration),
        "spin-is-not-conserved": spin(angular_acceleration),
            "|w|² changes at the rate -2 (I1 - I2)(I2 - I3)(I3 - I1) w1 w2 w3 / (I1 I2 I3), which for the moments 2, 3, 4 and the spin (1, 1, 1) \
            is -1/6, and zero for every body with two equal moments.";
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

/// Checks the rate of a quantity under both forms of the law: given spin and momentum, the quantity and the
/// rate that the torque should give it.
fn rates(
    momentum_law: MomentumLaw<'_>,
    spin_law: SpinLaw<'_>,
    quantity: impl Fn(&Vector, &Vector) -> Fraction,
    expected: impl Fn(&Vector, &Vector, &Vector) -> Fraction,
) -> Outcome {
    let torque = vector("tau");
    let (inverse, momentum) = (symmetric("J"), vector("L"));
    let omega = &inverse * &momentum;
    let rate = changing(Derivation::default(), "L", &momentum_law(&inverse, &momentum, &torque))
        .of(&quantity(&omega, &momentum));
    same("by L' = L x (J L) + torque", &rate, &expected(&omega, &momentum, &torque))?;
    let (moments, omega) = (vector("I"), vector("omega"));
    let momentum = diagonal(&moments) * &omega;
    let rate = changing(Derivation::default(), "omega", &spin_law(&moments, &omega, &torque))
        .of(&quantity(&omega, &momentum));
    same("by I w' = (I w) x w + torque", &rate, &expected(&omega, &momentum, &torque))
}

fn power(
    momentum_law: impl Fn(&Matrix, &Vector, &Vector) -> Vector,
    spin_law: impl Fn(&Vector, &Vector, &Vector) -> Vector,
) -> Outcome {
    rates(&momentum_law, &spin_law, energy, |w, _, torque| w.dot(torque))
}

fn length(
    momentum_law: impl Fn(&Matrix, &Vector, &Vector) -> Vector,
    spin_law: impl Fn(&Vector, &Vector, &Vector) -> Vector,
) -> Outcome {
    rates(&momentum_law, &spin_law, |_, l| l.dot(l), |_, l, torque| l.dot(torque) * Fraction::from(2))
}

fn spin(law: impl Fn(&Vector, &Vector, &Vector) -> Vector) -> Outcome {
    let (moments, omega) = (vector("I"), vector("omega"));
    let free = changing(Derivation::default(), "omega", &law(&moments, &omega, &Vector::zeros()));
    let rate = free.of(&omega.dot(&omega));
    breaks("|w|² stays", same("the rate of |w|²", &rate, &Fraction::zero()))?;
    let body = ["I1", "I2", "I3", "omega1", "omega2", "omega3"].into_iter().zip([2, 3, 4, 1, 1, 1]);
    let there = rate.at(&body.map(|(name, n)| (name, Rational::from(n))).collect::<Vec<_>>());
    same("of moments 2, 3, 4 and the spin (1, 1, 1)", &there.into(), &Fraction::ratio(-1, 6))?;
    let [a, b, c] = variables(["I1", "I2", "I3"]);
    let product = (&a - &b) * (&b - &c) * (&c - &a) / (a * b * c);
    let spins = &omega.x * &omega.y * &omega.z;
    same("the rate of |w|²", &rate, &(Fraction::from(-2) * product * spins))?;
    for (one, other) in [("I1", "I2"), ("I2", "I3"), ("I3", "I1")] {
        let equal = rate.substitute(&one.into(), &Fraction::variable(other));
        same("two equal moments", &equal, &Fraction::zero())?;
    }
    Ok(())
}
