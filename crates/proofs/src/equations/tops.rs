//! The meanings of the names where the book states a motion in closed form.

use crate::number::{Derivation, Fraction, Relations};
use crate::proofs::klein::obeying;
use crate::symbols::{Vector, diagonal, variables};
use crate::tex::{Scope, Value};
use num_traits::{One, Zero};
use tumbling::dynamics::euler::{angular_acceleration, coupling};

/// A body with two equal moments, its axis of symmetry the third; the rate by the library's equations.
pub(super) fn coin() -> Scope {
    let [i1, i3, w1, w2, w3] = variables(["I1", "I3", "omega1", "omega2", "omega3"]);
    let moments = Vector::new(i1.clone(), i1.clone(), i3.clone());
    let omega = Vector::new(w1.clone(), w2, w3);
    let rate = angular_acceleration(&moments, &omega, &Vector::zeros());
    let axis = Vector::new(Fraction::zero(), Fraction::zero(), Fraction::one());
    Scope::default()
        .with_all([("I_1", i1), ("I_3", i3), (r"\Omega", &rate.y / &w1)])
        .with_each(r"\omega", &omega)
        .with_each(r"\dot{\omega}", &rate)
        .with(r"\mathbf{L}", diagonal(&moments) * &omega)
        .with(r"\dot{\mathbf{e}}", omega.cross(&axis))
        .with(r"\boldsymbol{\omega}", omega)
        .with(r"\mathbf{e}", axis)
}

/// Its spin as a function of time, if it satisfies the library's equations; otherwise the names have no
/// meaning.
pub(super) fn coin_in_time() -> Scope {
    let [i1, i3, amplitude, w3, cos, sin] = variables(["I1", "I3", "a", "omega3", "cos", "sin"]);
    let rate = (&i3 - &i1) * &w3 / &i1;
    let time = Derivation::new([("cos", -(&rate * &sin)), ("sin", rate * &cos)]);
    let omega = Vector::new(&amplitude * &cos, &amplitude * &sin, w3);
    let expected = angular_acceleration(&Vector::new(i1.clone(), i1, i3), &omega, &Vector::zeros());
    if omega.map(|x| time.of(&x)) != expected {
        return Scope::default();
    }
    Scope::default()
        .with_all([("a", amplitude), (r"\cos(\phi)", cos), (r"\sin(\phi)", sin)])
        .with_each(r"\omega", omega.iter().take(2))
        .under(Relations::circle("cos", "sin"))
}

/// A top whose axis turns about the vertical at a rate `Omega` with a constant lean; the weight follows from
/// the rate of its momentum.
pub(super) fn steady_top() -> Scope {
    let [spin, sin, cos] = variables(["omega3", "sin", "cos"]);
    precessing(spin, sin, cos)
}

/// This top nearly upright, where the two possible rates for one spin are equal.
pub(super) fn sleeping_top() -> Scope {
    let [i1, i3, rate, sin] = variables(["I1", "I3", "Omega", "sin"]);
    precessing(&i1 * &rate * Fraction::from(2_i64) / &i3, sin, Fraction::one())
}

fn precessing(spin: Fraction, sin: Fraction, cos: Fraction) -> Scope {
    let length = Fraction::variable("h");
    let weight = required_torque(&spin, &sin, &cos) / (&sin * &length);
    of_top(spin, cos).with("h", length).with("W", weight)
}

fn of_top(spin: Fraction, cos: Fraction) -> Scope {
    let [i1, i3, rate] = variables(["I1", "I3", "Omega"]);
    let scope = Scope::default().with("I_1", i1).with("I_3", i3).with("P", rate);
    scope.with(r"\omega_3", spin).with(r"\cos(\theta)", cos)
}

/// The torque, about the level axis across the lean, that a steady precession requires.
fn required_torque(spin: &Fraction, sin: &Fraction, cos: &Fraction) -> Fraction {
    let [i1, i3, rate] = variables(["I1", "I3", "Omega"]);
    let moments = Vector::new(i1.clone(), i1, i3);
    // Seen from the body, whose spin beyond that about the vertical is along its axis.
    let vertical = Vector::new(-sin.clone(), Fraction::zero(), cos.clone());
    let mut omega = &vertical * rate.clone();
    omega.z = spin.clone();
    let carried = moments.component_mul(&(vertical.cross(&omega) * rate));
    (carried - coupling(&moments, &omega)).y.clone()
}

/// A small nutation about a steady precession: its second rate as a function of the lean, at constant
/// momentum about the vertical and about the axis; without meaning if the former is not constant.
pub(super) fn nodding() -> Scope {
    let [i1, i3, rate, spin] = variables(["I1", "I3", "Omega", "omega3"]);
    let [sin, cos, pull] = variables(["sin", "cos", "Wh"]);
    let along = &i3 * &spin;
    let faster = (&along - Fraction::from(2_i64) * &i1 * &rate * &cos) / (&i1 * &sin);
    let by_lean = Derivation::new([("sin", cos.clone()), ("cos", -sin.clone()), ("Omega", faster)]);
    let about_vertical = &i1 * &rate * sin.pow(2) + &along * &cos;
    if !by_lean.of(&about_vertical).is_zero() {
        return Scope::default();
    }
    let required = required_torque(&spin, &sin, &cos);
    let steady = &required / &sin;
    let square = by_lean.of(&(required - &pull * &sin)) / i1;
    of_top(spin, cos)
        .with(r"\sin(\theta)", sin)
        .with(r"\lambda", Value::Root(square.substitute(&"Wh".into(), &steady)))
        .under(Relations::circle("cos", "sin"))
}

/// The motion, with the third axis as its circled axis, if it satisfies the library's equations; otherwise
/// without meaning. Computed once.
pub(super) fn jacobi_motion() -> Scope {
    let Ok(motion) = obeying(1) else { return Scope::default() };
    let mut amplitudes = motion.amplitudes.clone();
    amplitudes[2] *= Fraction::variable("sigma");
    let scope = Scope::default().with_each("I", &motion.moments).with_each("a", &amplitudes);
    let scope = scope.with_each(r"\omega", &motion.omega).with_functions(&["sn", "cn", "dn"], "(u)");
    let [h, p] = variables(["h", "p"]);
    scope
        .with_all([("m", (h * p).pow(2)), ("p", motion.rate), ("L", motion.momentum)])
        .with("E", motion.twice_energy / Fraction::from(2))
        .under(motion.relations)
}
