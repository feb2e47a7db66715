//! Spin about each principal axis: steady, and for every body stable about two axes and not about the third.

use crate::equations::in_order;
use crate::number::Fraction;
use crate::proof::{Case, same};
use crate::symbols::{Vector, ordered_moments, variables, vector};
use crate::tex::{Scope, Value};
use nalgebra::Quaternion;
use num_traits::{One, Zero};
use tumbling::attitude::rotation_matrix;
use tumbling::dynamics::euler::{angular_acceleration, tensor_times_acceleration};
use tumbling::dynamics::stability::rate_squared;
use tumbling::inertia::point_mass;

proofs! {
    "stability" {
        "steady-spins": steady(angular_acceleration),
            r"Without torque Euler's equations leave a spin about a principal axis as it is, for every body and every axis: with every vector $\dot{\omega}\cdot v = 0$.";
            but "w1 w1 for w2 w3 in the second equation": {
                steady(|i, w, t| {
                    let mut rate = angular_acceleration(i, w, t);
                    rate.y = (&i.z - &i.x) * &w.x * &w.x / i.y.clone();
                    rate
                })
            },
        "rates-of-the-wobble": linearised(rate_squared),
            r"Linearised about each axis, Euler's equations leave the spin itself alone and drive the two small components by each other, at slopes of which the product is the library's rate squared, $p q = \lambda^2$; the other seven slopes vanish.";
            but "the sign": linearised(|w, i, a, b| -rate_squared(w, i, a, b)),
        "the-middle-axis": middle(rate_squared, 0),
            r"For every three different moments, $I_2 = I_1 + a$ and $I_3 = I_1 + a + b$ with positive letters, the library's rate squared of the linearised wobble has one sign: $r_1 < 0$, $r_2 > 0$, $r_3 < 0$.";
            but "the sign": middle(|w, i, a, b| -rate_squared(w, i, a, b), 0),
            but "the smallest axis taken for the middle one": middle(rate_squared, 2),
        "equal-moments": equal(rate_squared),
            r"About either of two axes with equal moments the square of the rate is $r_1 = r_2 = 0$, neither growth nor swing; about the third it is $r_3 < 0$, a swing.";
            but "the spin's square added": equal(|w, i, a, b| rate_squared(w, i, a, b) + w.pow(2)),
        "pulls-outward": outward(1),
            r"In a frame that turns with the body the centrifugal force on a point, $F = -m\omega\times (\omega\times r)$, twists it by $r\times F = A$, where $A = (I\omega)\times\omega$ is the right-hand side of the library's law, for every point and spin. That twists and tensors add is no part of it.";
            but "forces toward the axis": outward(-1),
        "tilts-in-the-turning-frame": tilts(1),
            r"In a frame that turns at the steady spin about one axis, Euler's equations are, for small tilts about the other two, $I_a\ddot{\alpha} = \omega^2 (I_b - I)\alpha + \omega (I_a + I_b - I)\dot{\beta}$ and $I_b\ddot{\beta} = \omega^2 (I_a - I)\beta - \omega (I_a + I_b - I)\dot{\alpha}$. The squares of their rates are the spin's with a minus, where the momentum seems to go round, and the library's: $(I_a s^2 - \omega^2 (I_b - I)) (I_b s^2 - \omega^2 (I_a - I)) + \omega^2 (I_a + I_b - I)^2 s^2 = I_a I_b (s^2 + \omega^2) (s^2 - \lambda^2)$.";
            but "no Coriolis force": tilts(0),
    }
}

type RateLaw<'a> = &'a dyn Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Fraction;

fn spin_about(axis: usize) -> Vector {
    Vector::from_fn(|i, _| if i == axis { Fraction::variable("Omega") } else { Fraction::zero() })
}

fn steady(law: impl Fn(&Vector, &Vector, &Vector) -> Vector) -> Vec<Scope> {
    let rate = |axis| law(&vector("I"), &spin_about(axis), &Vector::zeros());
    [0, 1, 2].map(|axis| Scope::default().with(r"\dot{\omega}", rate(axis)).with("v", vector("v"))).into()
}

fn linearised(law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Fraction) -> Case<Vec<Scope>> {
    let (moments, omega) = (vector("I"), vector("omega"));
    let rate = angular_acceleration(&moments, &omega, &Vector::zeros());
    let about = |axis: usize| {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let steady = spin_about(axis);
        // The derivative of component `row` of the rate by component `column` of the spin, at the steady
        // spin.
        let slope = |row: usize, column: usize| {
            let slope = rate[row].derivative(&format!("omega{}", column + 1).as_str().into());
            (0..3).fold(slope, |x, i| x.substitute(&format!("omega{}", i + 1).as_str().into(), &steady[i]))
        };
        for (row, column) in [(axis, 0), (axis, 1), (axis, 2), (j, axis), (k, axis), (j, j), (k, k)] {
            same("a slope that should vanish", &slope(row, column), &Fraction::zero())?;
        }
        let squared = law(&Fraction::variable("Omega"), &moments[axis], &moments[j], &moments[k]);
        let scope = Scope::default().with_all([("p", slope(j, k)), ("q", slope(k, j))]);
        Ok(scope.with(r"\lambda", Value::Root(squared)))
    };
    (0..3).map(about).collect()
}

/// The square of the rate about an axis.
fn rate_about(law: RateLaw<'_>, moments: &Vector, axis: usize) -> Fraction {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    law(&Fraction::variable("Omega"), &moments[axis], &moments[j], &moments[k])
}

/// With the axes counted from this one on.
fn middle(law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Fraction, first: usize) -> Scope {
    let rates = [0, 1, 2].map(|n| rate_about(&law, &ordered_moments(), (first + n) % 3));
    in_order().with_each("r", &rates).positive(["I1", "a", "b", "Omega"])
}

fn equal(law: impl Fn(&Fraction, &Fraction, &Fraction, &Fraction) -> Fraction) -> Vec<Scope> {
    let [i, a] = variables(["I1", "a"]);
    let case = |pair: &Fraction, lone: &Fraction| {
        let rates = [0, 1, 2].map(|k| rate_about(&law, &[pair, pair, lone].map(Fraction::clone).into(), k));
        Scope::default().with_each("r", &rates).positive(["I1", "a", "Omega"])
    };
    vec![case(&i, &(&i + &a)), case(&(&i + &a), &i)]
}

/// The twist of the force that points away from the axis, or, with `sign` -1, toward it.
fn outward(sign: i64) -> Scope {
    let (m, r, w) = (Fraction::variable("m"), vector("r"), vector("omega"));
    let force = -w.cross(&w.cross(&r)) * (m.clone() * Fraction::from(sign));
    let tensor = point_mass(&m, &r);
    let right = tensor_times_acceleration(&tensor, &w, &Vector::zeros());
    let scope = Scope::default().with("F", force).with("A", right).with("I", tensor).with("m", m);
    scope.with("r", r).with(r"\omega", w)
}

/// With the third axis for the steady one; the Coriolis force is taken `coriolis` times.
fn tilts(coriolis: i64) -> Scope {
    let [w, e, s] = variables(["omega", "e", "s"]);
    let (i, tilt, rate) = (vector("I"), [1, 2].map(|k| Fraction::variable(&format!("t{k}"))), vector("r"));
    let half = |x: &Fraction| e.clone() * x / Fraction::from(2);
    let q = Quaternion::new(Fraction::one(), half(&tilt[0]), half(&tilt[1]), Fraction::zero());
    let across = Vector::new(e.clone() * &rate.x, e.clone() * &rate.y, Fraction::zero());
    let steady = Vector::new(Fraction::zero(), Fraction::zero(), w.clone());
    let spin = rotation_matrix(&q).transpose() * steady + across;
    // To first order in the tilts. The spin's rate is the tilts' second rates and what their first ones add.
    let slope = |x: &Fraction| x.derivative(&"e".into()).substitute(&"e".into(), &Fraction::zero());
    let [x, y, _] = angular_acceleration(&i, &spin, &Vector::zeros()).map(|x| slope(&x)).into();
    let [a, b] = [x + w.clone() * &rate.y, y - w.clone() * &rate.x];
    let times = |x: Fraction| x * Fraction::from(coriolis);
    let squared = rate_squared(&w, &i.z, &i.x, &i.y);
    let [i_a, i_b, i] = i.into();
    let ([alpha, beta], [alpha_rate, beta_rate, _]) = (tilt, rate.map(times).into());
    Scope::default()
        .with_all([(r"\alpha", alpha), (r"\beta", beta), (r"\dot{\alpha}", alpha_rate)])
        .with_all([(r"\dot{\beta}", beta_rate), (r"\ddot{\alpha}", a), (r"\ddot{\beta}", b)])
        .with_all([("I_a", i_a), ("I_b", i_b), ("I", i), (r"\omega", w), ("s", s)])
        .with(r"\lambda", Value::Root(squared))
}
