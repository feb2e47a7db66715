//! Published formulas for the free motion, each decided: `book/chapters/errata.md` says where each is from.
//!
//! The symbols are those of the notes on Celledoni et al. that Principia keeps: `m` the momentum along the
//! principal axes, `G` its length, `T` the energy, and `B_jh` the amplitudes. Here the amplitudes are made of
//! roots (`x1² = I1`, `p² = I2 - I1`, `q² = I3 - I2`, `r² = I3 - I1`) and of one free speed `z`.

use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::proof::{Outcome, Residue, same, same_entries_under, same_under, vanishes};
use crate::symbols::{Vector, changing, pure, square, variables, vector};
use nalgebra::Quaternion;
use num_traits::One;
use tumbling::attitude::{product, rate};
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::dynamics::observe::energy;

proofs! {
    "errata" {
        "errata-rate-about-the-smallest-axis": circling(Side::Smallest, -1),
            "With the momentum (s B13 dn, -B21 sn, B31 cn) of λ t, s = ±1, Euler's equations want the rate -s λ3.";
            but "the rate s λ3": circling(Side::Smallest, 1),
        "errata-rate-about-the-largest-axis": circling(Side::Largest, -1),
            "With the momentum (B13 cn, -B23 sn, s B31 dn) of λ t, s = ±1, Euler's equations want the rate -s λ1.";
            but "the rate s λ1": circling(Side::Largest, 1),
        "errata-signs-on-the-separatrix": separatrix([true, true]),
            "On the separatrix the momentum (s B13 sech, G tanh, s' B31 sech) of s s' λ2 t, with two signs of its own, obeys Euler's equations.";
            but "one sign for both ends in the rate": separatrix([true, false]),
        "errata-rate-of-the-angle": rate_of_the_angle(1),
            "The attitude that takes the momentum to the third axis by the shortest way and then turns by ψ about it obeys q' = q ω / 2 if ψ' = (2 T + G m3 / I3) / (G + m3).";
            but "a minus in the numerator": rate_of_the_angle(-1),
        "errata-sign-of-the-angle": closed_angle(-1, true),
            "That rate is the derivative of G t / I3 + G I31 / (λ I1 I3) (Π - (B31 / G) (B13 / B21) arctan((B21 / B13) sd)), with -(B31 / B13)² for the characteristic of Π, and the derivatives of Π and of the arctangent put in.";
            but "a plus before the arctangent": closed_angle(1, true),
            but "B31 not divided by G": closed_angle(-1, false),
        "errata-characteristic-on-the-separatrix": characteristic(true),
            "On the separatrix G⁴ / (B21² B23²) is one, so that an integral over one minus it divides by zero.";
            but "any energy": characteristic(false),
        "errata-integral-of-tanh": integral_of_tanh(-1),
            "With a² = n, the derivative of t / (1 - n) - a artanh(a tanh) / ((1 - n) λ) is 1 / (1 - n tanh²), with that of artanh(x), x' / (1 - x²), put in.";
            but "a plus before the second term": integral_of_tanh(1),
        "errata-acceleration": acceleration(false),
            "By the derivatives of Jacobi's functions, which are put in, the rate of the spin (o1 cn, o2 sn, o3 dn) of λ t is λ (-o1 sn dn, o2 cn dn, -m o3 sn cn).";
            but "the first two exchanged": acceleration(true),
        "errata-precession": precession(1),
            "Along the motion, the rate M (I1 w1² + I2 w2²) / (M² - (I3 w3)²) of Euler's angle φ is (M / I3) (1 + I32 I31 / (I1 I32 + I3 I21 sn²)).";
            but "a minus before the quotient": precession(-1),
    }
}

/// The squares of the roots of the moments: the moments, in order of size.
fn moments() -> Vector {
    Vector::from(variables(["x1", "x2", "x3"])).map(|x| x.pow(2))
}

/// Which end the spin circles.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Smallest,
    Largest,
}

/// The roots of the moments and of their differences, the functions and the signs; `more` goes before.
fn relations(mut more: Vec<(&str, Polynomial)>) -> Result<Relations, Residue> {
    let (sn2, m, one) = (square("sn"), Polynomial::variable("m"), Polynomial::one);
    more.extend([("cn", one() - &sn2), ("dn", one() - &m * sn2), ("sech", one() - square("tanh"))]);
    more.extend([("k", m), ("s", one()), ("s'", one())]);
    let (i1, p, q) = (square("x1"), square("p"), square("q"));
    more.extend([("x2", &i1 + &p), ("x3", &i1 + &p + &q), ("r", p + q)]);
    Ok(Relations::new(more)?)
}

/// That the momentum, whose symbols change at these rates, obeys the library's Euler's equations.
fn obeys_euler(momentum: &Vector, time: &Derivation, relations: &Relations) -> Outcome {
    let moments = moments();
    let omega = momentum.component_div(&moments);
    let expected = angular_acceleration(&moments, &omega, &Vector::zeros());
    same_entries_under(relations, "w'", &omega.map(|x| time.of(&x)), &expected)
}

fn circling(case: Side, sign: i64) -> Outcome {
    let [x1, x2, x3, p, q, r, k, z, s] = variables(["x1", "x2", "x3", "p", "q", "r", "k", "z", "s"]);
    let [sn, cn, dn] = variables(["sn", "cn", "dn"]);
    // Near is what lies between the circled axis and the middle one. The root of the discriminant that
    // gives the speed is z r far.
    let (near, far) = if case == Side::Smallest { (&p, &q) } else { (&q, &p) };
    let rate = &z * &r * far * near / (&x1 * &x2 * &x3) * &s * Fraction::from(sign);
    let small = &k * &z * near;
    let middle = -(&x2 * &k * &z * &r * sn);
    let momentum = match case {
        Side::Smallest => Vector::new(&s * &x1 * far * &z * dn, middle, &x3 * small * cn),
        Side::Largest => Vector::new(&x1 * small * cn, middle, &s * &x3 * far * &z * dn),
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
    let sphere = Relations::new(vec![("G", square("m1") + square("m2") + square("m3"))])?;
    let omega = m.component_div(&moments);
    let change = m.cross(&omega);
    let time = changing(Derivation::default(), "m", &change);
    let zero = || Fraction::from(0);
    // The shortest way from m to the third axis, of length² N = 2 G (G + m3).
    let way = Quaternion::new(&length + &m.z, m.y.clone(), -m.x.clone(), zero());
    let shrinks = &change.z / ((&length + &m.z) * Fraction::from(2));
    let twice_energy = energy(&omega, &m) * Fraction::from(2);
    let angle = (twice_energy + &length * &omega.z * Fraction::from(sign)) / (&length + &m.z);
    let about = pure(&Vector::new(zero(), zero(), angle / Fraction::from(2)));
    let turned = product(&about, &way).coords;
    let left = turned + way.coords.map(|x| time.of(&x) - x * shrinks.clone()) - rate(&way, &omega).coords;
    left.iter().try_for_each(|x| vanishes("q' - q w / 2", x, &sphere))
}

fn closed_angle(sign: i64, divided: bool) -> Outcome {
    let [x1, x2, x3, p, q, r, k, z] = variables(["x1", "x2", "x3", "p", "q", "r", "k", "z"]);
    let [g, sn, cn, dn] = variables(["G", "sn", "cn", "dn"]);
    let (b13, b31, b21) = (&x1 * &q * &z, &x3 * &k * &p * &z, &x2 * &k * &z * &r);
    let third = square("x1") + square("p") + square("q");
    let length = square("z") * (square("x1") * square("q") + third * square("p") * Polynomial::variable("m"));
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
    let length2 = g.pow(2);
    let twice = if on_it { &length2 / &i2 } else { energy * Fraction::from(2) };
    let discriminant = |i: &Fraction| &length2 - &twice * i.clone();
    let b21 = &i2 * discriminant(&i1) / (&i2 - &i1);
    let b23 = &i2 * discriminant(&i3) / (&i2 - &i3);
    same("the characteristic", &(length2.pow(2) / (b21 * b23)), &Fraction::one())
}

fn integral_of_tanh(sign: i64) -> Outcome {
    let [a, rate, tanh] = variables(["a", "lambda", "tanh"]);
    let one = Fraction::one();
    let (inner, rest) = (&a * tanh, &one - a.pow(2));
    let area = Derivation::hyperbolic(&rate).of(&inner) / (&one - inner.pow(2));
    let said = &one / &rest + a * area * Fraction::from(sign) / (rest * rate);
    same_under(&relations(Vec::new())?, "the derivative", &said, &(&one / (&one - inner.pow(2))))
}

fn acceleration(exchanged: bool) -> Outcome {
    let [a, b, c, m, rate, sn, cn, dn] = variables(["o1", "o2", "o3", "m", "lambda", "sn", "cn", "dn"]);
    let time = Derivation::elliptic(&rate);
    let omega = Vector::new(&a * &cn, &b * &sn, &c * &dn);
    let (falls, rises) = (-(&sn * &dn), &cn * &dn);
    let (first, second) = if exchanged { (rises, falls) } else { (falls, rises) };
    let said = Vector::new(a * first, b * second, -(c * m * sn * cn)).map(|x| x * rate.clone());
    same_entries_under(&Relations::elliptic(), "w'", &omega.map(|x| time.of(&x)), &said)
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
