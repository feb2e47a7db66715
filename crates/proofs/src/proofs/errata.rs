//! Published formulas for the free motion, each decided: `book/chapters/errata.md` says where each is from.
//!
//! The symbols are those of the notes on Celledoni et al. that Principia keeps: `m` the momentum along the
//! principal axes, `G` its length, `T` the energy, and `B_jh` the amplitudes. Here the amplitudes are made of
//! roots (`x1² = I1`, `p² = I2 - I1`, `q² = I3 - I2`, `r² = I3 - I1`) and of one free speed `z`.

use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::proof::{Mutant, Outcome, Proof, Residue, same, same_under, same_vectors_under, vanishes};
use crate::symbols::{Vector, variables, vector};
use nalgebra::Quaternion;
use num_traits::One;
use tumbling::attitude::{product, rate};
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::dynamics::observe::energy;

pub(super) const PROOFS: &[Proof] = &[
    Proof {
        name: "errata-rate-about-the-smallest-axis",
        part: "errata",
        statement: "With the momentum (s B13 dn, -B21 sn, B31 cn) of λ t, s = ±1, Euler's equations want the rate -s λ3.",
        check: || circling(Case::Smallest, -1),
        mutants: &[Mutant { change: "the rate s λ3", check: || circling(Case::Smallest, 1) }],
    },
    Proof {
        name: "errata-rate-about-the-largest-axis",
        part: "errata",
        statement: "With the momentum (B13 cn, -B23 sn, s B31 dn) of λ t, s = ±1, Euler's equations want the rate -s λ1.",
        check: || circling(Case::Largest, -1),
        mutants: &[Mutant { change: "the rate s λ1", check: || circling(Case::Largest, 1) }],
    },
    Proof {
        name: "errata-signs-on-the-separatrix",
        part: "errata",
        statement: "On the separatrix the momentum (s B13 sech, G tanh, s' B31 sech) of s s' λ2 t, with two signs of its own, obeys \
                    Euler's equations.",
        check: || separatrix([true, true]),
        mutants: &[
            Mutant { change: "one sign for both ends in the rate", check: || separatrix([true, false]) },
            Mutant { change: "a rate without signs", check: || separatrix([false, false]) },
        ],
    },
    Proof {
        name: "errata-rate-of-the-angle",
        part: "errata",
        statement: "The attitude that takes the momentum to the third axis by the shortest way and then turns by ψ about it obeys \
                    q' = q ω / 2 if ψ' = (2 T + G m3 / I3) / (G + m3).",
        check: || rate_of_the_angle(1),
        mutants: &[Mutant { change: "a minus in the numerator", check: || rate_of_the_angle(-1) }],
    },
    Proof {
        name: "errata-sign-of-the-angle",
        part: "errata",
        statement: "That rate is the derivative of G t / I3 + G I31 / (λ I1 I3) (Π - (B31 / G) (B13 / B21) arctan((B21 / B13) sd)), with \
                    -(B31 / B13)² for the characteristic of Π.",
        check: || closed_angle(-1, true),
        mutants: &[
            Mutant { change: "a plus before the arctangent", check: || closed_angle(1, true) },
            Mutant { change: "B31 not divided by G", check: || closed_angle(-1, false) },
        ],
    },
    Proof {
        name: "errata-characteristic-on-the-separatrix",
        part: "errata",
        statement: "On the separatrix G⁴ / (B21² B23²) is one, so that an integral over one minus it divides by zero.",
        check: || characteristic(true),
        mutants: &[Mutant { change: "any energy", check: || characteristic(false) }],
    },
    Proof {
        name: "errata-acceleration",
        part: "errata",
        statement: "By the derivatives of Jacobi's functions, which are put in, the rate of the spin (o1 cn, o2 sn, o3 dn) of λ t is \
                    λ (-o1 sn dn, o2 cn dn, -m o3 sn cn).",
        check: || acceleration(false),
        mutants: &[Mutant { change: "the first two exchanged", check: || acceleration(true) }],
    },
    Proof {
        name: "errata-precession",
        part: "errata",
        statement: "Along the motion, the rate M (I1 w1² + I2 w2²) / (M² - (I3 w3)²) of Euler's angle φ is (M / I3) (1 + I32 I31 / \
                    (I1 I32 + I3 I21 sn²)).",
        check: || precession(1),
        mutants: &[Mutant { change: "a minus before the quotient", check: || precession(-1) }],
    },
];

#[derive(Clone, Copy, PartialEq)]
enum Case {
    Smallest,
    Largest,
}

/// The roots of the moments and of their differences, the functions and the sign `s`; `more` goes before.
fn relations(more: Vec<(&str, Polynomial)>) -> Result<Relations, Residue> {
    let square = |name: &str| Polynomial::variable(name).pow(2);
    let (sn2, m) = (square("sn"), Polynomial::variable("m"));
    let mut rules: Vec<_> = more.into_iter().map(|(name, value)| (name.into(), value)).collect();
    rules.extend([
        ("cn".into(), Polynomial::one() - &sn2),
        ("dn".into(), Polynomial::one() - &m * sn2),
        ("sech".into(), Polynomial::one() - square("tanh")),
        ("k".into(), m),
        ("s".into(), Polynomial::one()),
        ("s'".into(), Polynomial::one()),
        ("x2".into(), square("x1") + square("p")),
        ("x3".into(), square("x1") + square("p") + square("q")),
        ("r".into(), square("p") + square("q")),
    ]);
    Relations::new(rules).map_err(|rule| Residue::Missing { claim: rule.to_string() })
}

fn moments() -> Vector {
    Vector::from(variables(["x1", "x2", "x3"])).map(|x| x.pow(2))
}

/// That the momentum, whose symbols change at these rates, obeys the library's Euler's equations.
fn obeys_euler(momentum: &Vector, time: &Derivation, relations: &Relations) -> Outcome {
    let moments = moments();
    let omega = momentum.component_div(&moments);
    let expected = angular_acceleration(&moments, &omega, &Vector::zeros());
    same_vectors_under(relations, "w'", &omega.map(|x| time.of(&x)), &expected)
}

fn circling(case: Case, sign: i64) -> Outcome {
    let [x1, x2, x3, p, q, r, k, z, s] = variables(["x1", "x2", "x3", "p", "q", "r", "k", "z", "s"]);
    let [sn, cn, dn] = variables(["sn", "cn", "dn"]);
    // Near is what lies between the circled axis and the middle one. The root of the discriminant that
    // gives the speed is z r far.
    let (near, far) = if case == Case::Smallest { (&p, &q) } else { (&q, &p) };
    let rate = &z * &r * far * near / (&x1 * &x2 * &x3) * &s * Fraction::from(sign);
    let small = &k * &z * near;
    let middle = -(&x2 * &k * &z * &r * sn);
    let momentum = match case {
        Case::Smallest => Vector::new(&s * &x1 * far * &z * dn, middle, &x3 * small * cn),
        Case::Largest => Vector::new(&x1 * small * cn, middle, &s * &x3 * far * &z * dn),
    };
    obeys_euler(&momentum, &Derivation::elliptic(&rate), &relations(Vec::new())?)
}

/// With the first sign, the second or both in the rate.
fn separatrix(in_rate: [bool; 2]) -> Outcome {
    let [x1, x2, x3, p, q, r, z, sech, tanh] =
        variables(["x1", "x2", "x3", "p", "q", "r", "z", "sech", "tanh"]);
    let signs = variables(["s", "s'"]);
    let mut rate = &z * &p * &q / (&x1 * &x3 * &x2.pow(2));
    for (sign, counts) in signs.iter().zip(in_rate) {
        rate = if counts { rate * sign.clone() } else { rate };
    }
    let [s, t] = signs;
    // z is the momentum's length G.
    let momentum =
        Vector::new(s * &x1 * &q * &z / (&x2 * &r) * &sech, &z * tanh, t * &x3 * &p * &z / (&x2 * &r) * sech);
    obeys_euler(&momentum, &Derivation::hyperbolic(&rate), &relations(Vec::new())?)
}

fn rate_of_the_angle(sign: i64) -> Outcome {
    let (moments, m) = (vector("I"), vector("m"));
    let length = Fraction::variable("G");
    let square = |name: &str| Polynomial::variable(name).pow(2);
    let sphere = Relations::new(vec![("G".into(), square("m1") + square("m2") + square("m3"))]);
    let sphere = sphere.map_err(|rule| Residue::Missing { claim: rule.to_string() })?;
    let omega = m.component_div(&moments);
    let change = m.cross(&omega);
    let time =
        Derivation::new([("m1", change.x.clone()), ("m2", change.y.clone()), ("m3", change.z.clone())]);
    let zero = || Fraction::from(0);
    // The shortest way from m to the third axis, of length² N = 2 G (G + m3).
    let way = Quaternion::new(&length + &m.z, m.y.clone(), -m.x.clone(), zero());
    let shrinks = &change.z / ((&length + &m.z) * Fraction::from(2));
    let twice_energy = energy(&omega, &m) * Fraction::from(2);
    let angle = (twice_energy + &length * &omega.z * Fraction::from(sign)) / (&length + &m.z);
    let about = Quaternion::new(zero(), zero(), zero(), angle / Fraction::from(2));
    let turned = product(&about, &way).coords;
    let left = turned + way.coords.map(|x| time.of(&x) - x * shrinks.clone()) - rate(&way, &omega).coords;
    left.iter().try_for_each(|x| vanishes("q' - q w / 2", x, &sphere))
}

fn closed_angle(sign: i64, divided: bool) -> Outcome {
    let [x1, x2, x3, p, q, r, k, z] = variables(["x1", "x2", "x3", "p", "q", "r", "k", "z"]);
    let [g, sn, cn, dn] = variables(["G", "sn", "cn", "dn"]);
    let (b13, b31, b21) = (&x1 * &q * &z, &x3 * &k * &p * &z, &x2 * &k * &z * &r);
    let poly = |name: &str| Polynomial::variable(name).pow(2);
    let third = poly("x1") + poly("p") + poly("q");
    let length = poly("z") * (poly("x1") * poly("q") + third * poly("p") * Polynomial::variable("m"));
    let relations = relations(vec![("G", length)])?;
    let [i1, _, i3] = moments().into();
    // The derivatives by the argument of Π and of the arctangent of (B21 / B13) sn / dn.
    let integral = Fraction::one() / (Fraction::one() + (&b31 / &b13).pow(2) * sn.pow(2));
    let arctangent = &b21 / &b13 * cn.clone() / (dn.pow(2) + (&b21 / &b13).pow(2) * sn.pow(2));
    let factor = &b31 * &b13 / &b21 * Fraction::from(sign);
    let factor = if divided { factor / g.clone() } else { factor };
    let closed = &g / &i3 + &g * &r.pow(2) / (&i1 * &i3) * (integral + factor * arctangent);
    // The rate, with 2 T from the motion where sn is zero.
    let twice_energy = b13.pow(2) / i1 + b31.pow(2) / i3.clone();
    let m3 = &b31 * cn;
    let expected = (twice_energy + &g * &m3 / i3) / (&g + m3);
    same_under(&relations, "the angle's rate", &closed, &expected)
}

fn characteristic(on_it: bool) -> Outcome {
    let [i1, i2, i3, g, energy] = variables(["I1", "I2", "I3", "G", "T"]);
    let square = g.pow(2);
    let twice = if on_it { &square / &i2 } else { energy * Fraction::from(2) };
    let discriminant = |i: &Fraction| &square - &twice * i.clone();
    let b21 = &i2 * discriminant(&i1) / (&i2 - &i1);
    let b23 = &i2 * discriminant(&i3) / (&i2 - &i3);
    same("the characteristic", &(square.pow(2) / (b21 * b23)), &Fraction::one())
}

fn acceleration(exchanged: bool) -> Outcome {
    let [a, b, c, m, rate, sn, cn, dn] = variables(["o1", "o2", "o3", "m", "lambda", "sn", "cn", "dn"]);
    let time = Derivation::elliptic(&rate);
    let omega = Vector::new(&a * &cn, &b * &sn, &c * &dn);
    let (falls, rises) = (-(&sn * &dn), &cn * &dn);
    let (first, second) = if exchanged { (rises, falls) } else { (falls, rises) };
    let said = Vector::new(a * first, b * second, -(c * m * sn * cn)).map(|x| x * rate.clone());
    same_vectors_under(&Relations::elliptic(), "w'", &omega.map(|x| time.of(&x)), &said)
}

fn precession(sign: i64) -> Outcome {
    let [i1, i2, i3, d, sn, cn, length] = variables(["I1", "I2", "I3", "D", "sn", "cn", "M"]);
    let (i32, i31, i21) = (&i3 - &i2, &i3 - &i1, &i2 - &i1);
    // D is 2 T I3 - M².
    let first = &d / (&i1 * &i31) * cn.pow(2);
    let second = &d / (&i2 * &i32) * sn.pow(2);
    let numerator = &i1 * first.clone() + &i2 * second.clone();
    let expected = &length * numerator / (i1.pow(2) * first + i2.pow(2) * second);
    let quotient = &i32 * &i31 / (&i1 * &i32 + &i3 * i21 * sn.pow(2));
    let said = &length / &i3 * (Fraction::one() + quotient * Fraction::from(sign));
    same_under(&Relations::circle("cn", "sn"), "the rate of the angle", &said, &expected)
}
