//! Motions in closed form: each put into Euler's equations, which it satisfies identically.

use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::proof::{Outcome, Residue, same, same_entries_under, vanishes};
use crate::symbols::{Vector, diagonal, square, variables, vector};
use num_traits::One;
use tumbling::dynamics::euler::angular_acceleration;
use tumbling::dynamics::observe::energy;

proofs! {
    "exact" {
        "symmetric-top": symmetric_top(angular_acceleration, 1),
            "With I1 = I2 the spin w1 = A cos, w2 = A sin, w3 constant, which circles the third axis at the rate (I3 - I1) w3 / I1, obeys Euler's equations.";
            but "the other way round": symmetric_top(angular_acceleration, -1),
        "separatrix": separatrix(angular_acceleration, 1),
            "The spin (A1 sech, w tanh, A3 sech) of w t sqrt((I2 - I1)(I3 - I2) / (I1 I3)), with A1 and A3 in closed form, obeys Euler's equations and has L² = 2 E I2, for every I1 < I2 < I3.";
            but "one amplitude with the wrong sign": separatrix(angular_acceleration, -1),
        "circling-the-largest-axis": elliptic(angular_acceleration, Side::Largest, 1),
            "The spin (A1 cn, A2 sn, A3 dn), with amplitudes, rate and parameter in closed form, obeys Euler's equations, for every I1 < I2 < I3. The rates of Jacobi's functions are put in.";
            but "the rate reversed": elliptic(angular_acceleration, Side::Largest, -1),
        "circling-the-smallest-axis": elliptic(angular_acceleration, Side::Smallest, 1),
            "The spin (A1 dn, A2 sn, A3 cn) with the two ends exchanged obeys Euler's equations, for every I1 < I2 < I3.";
            but "the rate reversed": elliptic(angular_acceleration, Side::Smallest, -1),
        "which-side": sides(1),
            "L² - 2 E I2 = I3 (I3 - I2) w3² - I1 (I2 - I1) w1²: the sum of one positive and one negative square that says which end the spin circles; likewise 2 E I3 - L² and L² - 2 E I1 are sums of \
            positive squares.";
            but "a plus between the squares": sides(-1),
    }
}

fn symmetric_top(law: impl Fn(&Vector, &Vector, &Vector) -> Vector, factor: i64) -> Outcome {
    let [i1, i3, amplitude, w3, cos, sin] = variables(["I1", "I3", "A", "omega3", "cos", "sin"]);
    let rate = (&i3 - &i1) * &w3 / &i1 * Fraction::from(factor);
    let time = Derivation::new([("cos", -(&rate * &sin)), ("sin", rate * &cos)]);
    let omega = Vector::new(&amplitude * cos, amplitude * sin, w3);
    let expected = law(&Vector::new(i1.clone(), i1, i3), &omega, &Vector::zeros());
    let circle = Relations::circle("cos", "sin");
    same_entries_under(&circle, "w'", &omega.map(|x| time.of(&x)), &expected)
}

/// Roots of the moments and of their differences, as symbols: `x1² = I1`, `p² = I2 - I1`, `q² = I3 - I2`,
/// `r² = I3 - I1`; `more` goes before them.
pub(super) fn roots(more: Vec<(&str, Polynomial)>) -> Result<Relations, Residue> {
    let (i1, p, q) = (square("x1"), square("p"), square("q"));
    let mut rules = more;
    rules.extend([("x2", &i1 + &p), ("x3", &i1 + &p + &q), ("r", p + q)]);
    Ok(Relations::new(rules)?)
}

/// The squares of the roots of the moments: the moments, in order of size.
pub(super) fn moments() -> Vector {
    Vector::from(variables(["x1", "x2", "x3"])).map(|x| x.pow(2))
}

fn separatrix(law: impl Fn(&Vector, &Vector, &Vector) -> Vector, factor: i64) -> Outcome {
    let [x1, x2, x3, p, q, r, spin, sech, tanh] =
        variables(["x1", "x2", "x3", "p", "q", "r", "Omega", "sech", "tanh"]);
    let relations = roots(vec![("sech", Polynomial::one() - square("tanh"))])?;
    let rate = &spin * &p * &q / (&x1 * &x3);
    let time = Derivation::hyperbolic(&rate);
    let a1 = &spin * &q * &x2 / (&x1 * &r) * Fraction::from(factor);
    let a3 = &spin * &p * &x2 / (&x3 * &r);
    let omega = Vector::new(a1 * &sech, &spin * tanh, a3 * sech);
    let moments = moments();
    let expected = law(&moments, &omega, &Vector::zeros());
    same_entries_under(&relations, "w'", &omega.map(|x| time.of(&x)), &expected)?;
    let momentum = diagonal(&moments) * &omega;
    let discriminant = momentum.dot(&momentum) - energy(&omega, &momentum) * &moments.y * Fraction::from(2);
    vanishes("L² - 2 E I2", &discriminant, &relations)
}

/// Which end the spin circles.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Side {
    Smallest,
    Largest,
}

/// A motion off the separatrix, in Jacobi's functions.
pub(crate) struct EllipticMotion {
    /// What ties the symbols.
    pub(crate) relations: Relations,
    /// In order of size.
    pub(crate) moments: Vector,
    /// The factor of each function.
    pub(crate) amplitudes: Vector,
    /// The rate of their argument.
    pub(crate) rate: Fraction,
    /// The spin.
    pub(crate) omega: Vector,
}

/// The one that circles the axis of the largest moment, if the library's Euler's equations hold along it.
///
/// # Errors
/// What is left over.
pub(crate) fn about_the_largest_axis() -> Result<EllipticMotion, Residue> {
    elliptic(angular_acceleration, Side::Largest, 1)?;
    elliptic_motion(Side::Largest, 1)
}

fn elliptic(law: impl Fn(&Vector, &Vector, &Vector) -> Vector, side: Side, factor: i64) -> Outcome {
    let motion = elliptic_motion(side, factor)?;
    let time = Derivation::elliptic(&motion.rate);
    let expected = law(&motion.moments, &motion.omega, &Vector::zeros());
    same_entries_under(&motion.relations, "w'", &motion.omega.map(|x| time.of(&x)), &expected)
}

/// Symbols: `Q` is free and says how fast; `k` is the modulus, `k² = m`.
fn elliptic_motion(side: Side, factor: i64) -> Result<EllipticMotion, Residue> {
    let [x1, x2, x3, p, q, r, k, big, sn, cn, dn] =
        variables(["x1", "x2", "x3", "p", "q", "r", "k", "Q", "sn", "cn", "dn"]);
    let (sn2, m) = (square("sn"), Polynomial::variable("m"));
    let relations =
        roots(vec![("cn", Polynomial::one() - &sn2), ("dn", Polynomial::one() - &m * sn2), ("k", m)])?;
    // Between the circled axis and the middle, and between the middle and the other end.
    let (near, far) = if side == Side::Largest { (&q, &p) } else { (&p, &q) };
    let small = &k * &big * near / far;
    let rate = near * &big / (&x1 * &x2 * &x3) * Fraction::from(factor);
    let (end, circled) = if side == Side::Largest { (&x1, &x3) } else { (&x3, &x1) };
    let (across, along) = ((&small / (end * &r), cn), (&big / (circled * &r), dn));
    let middle = (&small / (&x2 * near), sn);
    let parts = if side == Side::Largest { [across, middle, along] } else { [along, middle, across] };
    let amplitudes = Vector::from(parts.each_ref().map(|(amplitude, _)| amplitude.clone()));
    let omega = Vector::from(parts.map(|(amplitude, function)| amplitude * function));
    Ok(EllipticMotion { relations, moments: moments(), amplitudes, rate, omega })
}

fn sides(sign: i64) -> Outcome {
    let (moments, omega) = (vector("I"), vector("omega"));
    let momentum = diagonal(&moments) * &omega;
    let twice_energy = energy(&omega, &momentum) * Fraction::from(2);
    let square = momentum.dot(&momentum);
    let term = |i: usize, j: usize, k: usize| &moments[i] * (&moments[j] - &moments[k]) * omega[i].pow(2);
    let two_terms = term(2, 2, 1) - term(0, 1, 0) * Fraction::from(sign);
    same("L² - 2 E I2", &(&square - &twice_energy * &moments.y), &two_terms)?;
    same("2 E I3 - L²", &(&twice_energy * &moments.z - &square), &(term(0, 2, 0) + term(1, 2, 1)))?;
    same("L² - 2 E I1", &(square - twice_energy * &moments.x), &(term(1, 1, 0) + term(2, 2, 0)))
}
