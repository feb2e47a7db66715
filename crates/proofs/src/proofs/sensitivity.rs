//! The derivatives of the motion by its start and by the tensor, by the formulas of the sensitivities,
//! written here a second time: each obeys the library's laws to first order. How they begin is tested on the
//! library itself.

use crate::equations::variation;
use crate::number::{Derivation, Fraction};
use crate::proof::{Residue, same, same_entries};
use crate::proofs::klein::{Change, both, motion};
use crate::symbols::{Matrix, Vector, changing, diagonal, pure, symmetric, variables, vector};
use crate::tex::Scope;
use nalgebra::Quaternion;
use num_traits::{One, Zero};
use tumbling::attitude::{product, rate};
use tumbling::dynamics::euler::{angular_acceleration, tensor_times_acceleration};

proofs! {
    "exact" {
        "variational-equations": variations(1),
            r"Euler's equations to first order are (C44). For three axes in cyclic order, a change of the last moment adds at a fixed spin $F_a = -\omega_b\omega_c/I_a$, $F_b = \omega_c\omega_a/I_b$ and $F_c = -(I_a - I_b)\omega_a\omega_b/I_c^2$, and a product of inertia of the first two $G_a = (I_a + I_b - I_c)\omega_c\omega_a/(I_a I_b)$, $G_b = -(I_a + I_b - I_c)\omega_b\omega_c/(I_a I_b)$ and $G_c = (\omega_b^2 - \omega_a^2)/I_c$. For every body.";
            but "what is added with the other sign": variations(-1),
        [Again] "sensitivity-of-the-spin": both(|sense| columns(sense, 1)),
            r"The closed form's derivatives by its two constants and by the moments obey Euler's equations to first order: each has the rate $\dot{W} = F$ that the library's law gives, where that of Jacobi's argument at a fixed angle grows at the rate $J' = \eta\operatorname{sn}^2/(2\operatorname{dn}^2)$. For every body, about either axis, in either sense.";
            but "that derivative growing the other way": both(|sense| columns(sense, -1)),
        [Again] "sensitivity-of-the-attitude": attitude(1),
            r"A small turn of the attitude changes as $e' = w - \omega\times e$ with the change of the spin; so this turn crossed with the momentum, and the momentum's change, turn with the room together, the turn's part along the momentum has the rate $r = w\cdot M$, and with the change of the energy both give the turn.";
            but "e carried along the other way": attitude(-1),
        [Again] "sensitivity-by-products": products(1),
            r"A product of inertia turns two principal axes about the third by $n$, itself over the difference of their moments: the change of the spin turned so, $W = n\times\omega$, has by Euler's equations with the changed tensor, to first order, the rate $\dot{W} = n\times\dot{\omega}$.";
            but "turned the other way": products(-1),
    }
}

fn free(moments: &Vector, omega: &Vector) -> Vector {
    angular_acceleration(moments, omega, &Vector::zeros())
}

/// What a change of the tensor adds to the acceleration at a fixed spin, times the moments.
fn forced(moments: &Vector, omega: &Vector, change: &Matrix) -> Vector {
    let tensor = diagonal(moments) + change.map(|x| x * Fraction::variable("eps"));
    let law = tensor_times_acceleration(&tensor, omega, &Vector::zeros());
    law.map(|x| x.derivative(&"eps".into())) - change * free(moments, omega)
}

/// The change of a tensor by one of its entries: a moment, or a product of the two axes other than `k`.
fn entry(k: usize, product: bool) -> Matrix {
    let mut change = Matrix::zeros();
    let (i, j) = if product { ((k + 1) % 3, (k + 2) % 3) } else { (k, k) };
    change[(i, j)] = Fraction::one();
    change[(j, i)] = Fraction::one();
    change
}

fn variations(sign: i64) -> Vec<Scope> {
    let (moments, omega) = (vector("I"), vector("omega"));
    let added = |c: usize, product: bool| {
        let found = forced(&moments, &omega, &entry(c, product)).component_div(&moments);
        found * Fraction::from(sign)
    };
    let case = |c: usize| {
        let values = [
            ("I", moments.clone()),
            (r"\omega", omega.clone()),
            ("F", added(c, false)),
            ("G", added(c, true)),
        ];
        values.into_iter().fold(Scope::default(), |scope, (name, v)| {
            let axes = ["a", "b", "c"].into_iter().zip(1..);
            axes.fold(scope, |scope, (axis, n)| scope.with(&format!("{name}_{axis}"), v[(c + n) % 3].clone()))
        })
    };
    (0..3).flat_map(|axis| [variation(axis), case(axis)]).collect()
}

/// By the motion's constant or moment of this name, at a fixed argument at the start. `J` is the derivative
/// of Jacobi's argument by the parameter at a fixed angle, `t` the time.
fn by_parameter(name: &str, rate: &Fraction) -> Derivation {
    let [x1, x2, x3, p, q, r] = variables(["x1", "x2", "x3", "p", "q", "r"]);
    let [h, sn, cn, dn, tau] = variables(["h", "sn", "cn", "dn", "tau"]);
    let by = Derivation::new([(name, Fraction::one())]);
    let by = match name {
        "x1" => by.and("x2", &x1 / &x2).and("x3", &x1 / &x3),
        "p" => by.and("x2", &tau * &p / &x2).and("x3", &tau * &p / &x3).and("r", &p / &r),
        "q" => by.and("x3", &tau * &q / &x3).and("r", &q / &r),
        _ => by,
    };
    let m = h.pow(2) * p.pow(2);
    let shift = Fraction::variable("t") * by.of(rate) - by.of(&m) * Fraction::variable("J");
    let at_fixed_angle = by.of(&m) * sn.pow(2) / (Fraction::from(2) * &dn);
    by.and("sn", &cn * &dn * &shift)
        .and("cn", -(&sn * &dn * &shift))
        .and("dn", -(&m * &sn * &cn * &shift) - at_fixed_angle)
}

fn columns(sense: i64, sign: i64) -> Result<Vec<Scope>, Residue> {
    let motion = motion(sense, Change::None)?;
    let [sn, dn] = variables(["sn", "dn"]);
    let grows = &motion.rate * sn.pow(2) / (Fraction::from(2) * dn.pow(2)) * Fraction::from(sign);
    let time = motion.time.clone().and("t", Fraction::one()).and("J", grows.clone());
    let omega = motion.arranged(&motion.omega, sense);
    let expected = free(&motion.arranged(&motion.moments, sense), &omega);
    let by = |name: &str| {
        let by = by_parameter(name, &motion.rate);
        let scope = Scope::default().with(r"\dot{W}", omega.map(|x| time.of(&by.of(&x))));
        let scope = scope.with("F", expected.map(|x| by.of(&x))).with("J'", grows.clone());
        let scope = scope.with(r"\eta", motion.rate.clone()).with_functions(&["sn", "dn"], "");
        scope.under(motion.relations.clone())
    };
    Ok(["Q", "h", "x1", "p", "q"].map(by).into())
}

fn attitude(sign: i64) -> Result<Scope, Residue> {
    let (moments, omega, w, e) = (vector("I"), vector("omega"), vector("W"), vector("e"));
    let [real, x, y, z] = variables(["q0", "q1", "q2", "q3"]);
    let q = Quaternion::new(real, x, y, z);
    let half = |q: &Quaternion<Fraction>| q.coords.map(|x| x / Fraction::from(2));
    // Of the attitude q (1 + e/2), by both ways.
    let carried = omega.cross(&e) * Fraction::from(sign);
    let falls = &w - carried;
    let changed = Quaternion::from_vector(half(&product(&q, &pure(&e))));
    let one_way = rate(&changed, &omega).coords + rate(&q, &w).coords;
    let other = half(&product(&rate(&q, &omega), &pure(&e))) + half(&product(&q, &pure(&falls)));
    same_entries("q'", &one_way, &other)?;
    // The momentum, its change for a changed tensor too, and their rates.
    let change = symmetric("d");
    let momentum = diagonal(&moments) * &omega;
    let moved = diagonal(&moments) * &w + &change * &omega;
    let moved_rate = moved.cross(&omega) + momentum.cross(&w);
    let seen = e.cross(&momentum) + &moved;
    let rate_of_seen = falls.cross(&momentum) + e.cross(&momentum.cross(&omega)) + moved_rate;
    same_entries("in the room", &rate_of_seen, &-omega.cross(&seen))?;
    let along = falls.dot(&momentum) + e.dot(&momentum.cross(&omega));
    // The change of twice the energy, with the spin's rates by Euler's equations to first order.
    let acceleration = free(&moments, &omega);
    let moved_acceleration = moved_rate_of_spin(&moments, &change, &omega, &w);
    let twice = moved_acceleration.dot(&momentum) * Fraction::from(2)
        + w.dot(&momentum.cross(&omega)) * Fraction::from(2)
        + omega.dot(&(&change * &acceleration)) * Fraction::from(2);
    same("the energy", &twice, &Fraction::zero())?;
    let found = momentum.cross(&e.cross(&momentum)) + &momentum * e.dot(&momentum);
    same_entries("e", &found, &(&e * momentum.dot(&momentum)))?;
    let scope = Scope::default().with("e'", falls).with("e", e).with("w", w).with(r"\omega", omega);
    Ok(scope.with("M", momentum).with("r", along))
}

/// The rate of the change of the spin.
fn moved_rate_of_spin(moments: &Vector, change: &Matrix, omega: &Vector, w: &Vector) -> Vector {
    let by_spin = free(moments, omega).map(|x| changing(Derivation::default(), "omega", w).of(&x));
    by_spin + forced(moments, omega, change).component_div(moments)
}

fn products(sign: i64) -> Vec<Scope> {
    let (moments, omega) = (vector("I"), vector("omega"));
    let about = |k: usize| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let mut axis = Vector::zeros();
        axis[k] = Fraction::from(sign) / (&moments[i] - &moments[j]);
        let turned = axis.cross(&omega);
        let law = moved_rate_of_spin(&moments, &entry(k, true), &omega, &turned);
        let scope = Scope::default().with("n", axis).with("W", turned).with(r"\dot{W}", law);
        scope.with(r"\omega", omega.clone()).with(r"\dot{\omega}", free(&moments, &omega))
    };
    [0, 1, 2].map(about).into()
}
