//! What stays while a body tumbles, and what does not.

use crate::number::{Derivation, Fraction, Rational};
use crate::proof::{Mutant, Outcome, Proof, Residue, breaks, same};
use crate::symbols::{Matrix, Vector, diagonal, symmetric, variables, vector};
use num_traits::Zero;
use tumbling::dynamics::euler::{angular_acceleration, momentum_rate};
use tumbling::dynamics::observe::energy;

pub(super) const PROOFS: &[Proof] = &[
    Proof {
        name: "energy",
        part: "euler",
        statement: "The energy changes at the rate w.torque, and not at all without: by the law of the momentum for every symmetric \
                    J, by Euler's equations along principal axes for every spin.",
        check: || power(momentum_rate, angular_acceleration),
        mutants: &[
            Mutant {
                change: "the torque taken twice",
                check: || {
                    power(|j, l, t| momentum_rate(j, l, &(t * Fraction::from(2))), angular_acceleration)
                },
            },
            Mutant {
                change: "the sign of one of Euler's equations",
                check: || power(momentum_rate, one_sign_wrong),
            },
            Mutant {
                change: "L1' without its gyroscopic term",
                check: || {
                    power(
                        |j, l, t| {
                            let mut rate = momentum_rate(j, l, t);
                            rate.x = t.x.clone();
                            rate
                        },
                        angular_acceleration,
                    )
                },
            },
        ],
    },
    Proof {
        name: "length-of-momentum",
        part: "euler",
        statement: "|L|² changes at the rate 2 L.torque, and not at all without: by the law of the momentum for every symmetric J, \
                    by Euler's equations along principal axes for every spin.",
        check: || length(momentum_rate, angular_acceleration),
        mutants: &[
            Mutant {
                change: "the sign of one of Euler's equations",
                check: || length(momentum_rate, one_sign_wrong),
            },
            Mutant {
                change: "L x (J L) becomes L x (J L) + L",
                check: || length(|j, l, t| momentum_rate(j, l, t) + l, angular_acceleration),
            },
        ],
    },
    Proof {
        name: "spin-is-not-conserved",
        part: "euler",
        statement: "|w|² changes at the rate -2 (I1 - I2)(I2 - I3)(I3 - I1) w1 w2 w3 / (I1 I2 I3), a body and a spin for which that is not zero \
                    being found by search; it is zero for every body with two equal moments.",
        check: || spin(angular_acceleration),
        mutants: &[
            Mutant {
                change: "the law of a ball",
                check: || spin(|_, w, t| angular_acceleration(&Vector::repeat(Fraction::from(1)), w, t)),
            },
            Mutant { change: "a steady spin", check: || spin(|_, _, _| Vector::zeros()) },
        ],
    },
];

fn one_sign_wrong(moments: &Vector, omega: &Vector, torque: &Vector) -> Vector {
    let mut rate = angular_acceleration(moments, omega, torque);
    rate.y = &torque.y / &moments.y * Fraction::from(2) - rate.y.clone();
    rate
}

/// The rate of change, where the vector `name` changes by `rate`.
fn time(name: &str, rate: &Vector) -> Derivation {
    let step = |all: Derivation, i: usize| all.and(&format!("{name}{}", i + 1), rate[i].clone());
    (0..3).fold(Derivation::default(), step)
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
    let rate = time("L", &momentum_law(&inverse, &momentum, &torque)).of(&quantity(&omega, &momentum));
    same("by L' = L x (J L) + torque", &rate, &expected(&omega, &momentum, &torque))?;
    let (moments, omega) = (vector("I"), vector("omega"));
    let momentum = diagonal(&moments) * &omega;
    let rate = time("omega", &spin_law(&moments, &omega, &torque)).of(&quantity(&omega, &momentum));
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
    let free = time("omega", &law(&moments, &omega, &Vector::zeros()));
    let rate = free.of(&omega.dot(&omega));
    breaks("|w|² stays", same("the rate of |w|²", &rate, &Fraction::zero()))?;
    search(&rate)?;
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

/// Looks through bodies of small whole moments that obey the triangle inequality, and small whole spins, for
/// one at which `rate` is not zero.
fn search(rate: &Fraction) -> Outcome {
    let small = |n: i64| Rational::from(n);
    for case in 0..5_i64.pow(6) {
        let digit = |place: u32| case / 5_i64.pow(place) % 5;
        let [a, b, c] = [0, 1, 2].map(|place| digit(place) + 1);
        if a + b < c || b + c < a || c + a < b {
            continue;
        }
        let [x, y, z] = [3, 4, 5].map(digit);
        let names = ["I1", "I2", "I3", "omega1", "omega2", "omega3"];
        let values = [a, b, c, x, y, z].map(small);
        let here: Vec<_> = names.into_iter().zip(values).collect();
        let value = rate.at(&here);
        if !value.is_undefined() && !value.is_zero() {
            return Ok(());
        }
    }
    Err(Residue::Missing { claim: "a body and a spin whose |w| changes".to_owned() })
}
