//! Published formulas for the free motion, each decided: `book/chapters/errata.md` says where each is from.
//!
//! The symbols are those of the notes on Celledoni et al. that Principia keeps: `m` the momentum along the
//! principal axes, `G` its length, `T` the energy, and `B_jh` the amplitudes. Here the amplitudes are made of
//! roots (`x1² = I1`, `p² = I2 - I1`, `q² = I3 - I2`, `r² = I3 - I1`) and of one free speed `z`.

use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::proof::{Outcome, Residue, same_entries_under, vanishes};
use crate::proofs::klein::{Change, Motion, motion};
use crate::symbols::{Vector, changing, pure, square, variables, vector};
use crate::tex::{Scope, Value};
use nalgebra::Quaternion;
use num_traits::One;
use tumbling::attitude::{product, rate};
use tumbling::dynamics::{euler::angular_acceleration, observe::energy};

proofs! {
    "errata" {
        [Again] "errata-rate-about-the-smallest-axis": circling(Side::Smallest, -1),
            r"With the momentum $m = (s B_{13}\operatorname{dn}, -B_{21}\operatorname{sn}, B_{31}\operatorname{cn})$, where $s^2 = 1$, Euler's equations want the argument's rate $u' = -s\lambda_3$.";
            but "the rate of the other sign": circling(Side::Smallest, 1),
        [Again] "errata-rate-about-the-largest-axis": circling(Side::Largest, -1),
            r"With the momentum $m = (B_{13}\operatorname{cn}, -B_{23}\operatorname{sn}, s B_{31}\operatorname{dn})$, where $s^2 = 1$, Euler's equations want the argument's rate $u' = -s\lambda_1$.";
            but "the rate of the other sign": circling(Side::Largest, 1),
        [Again] "errata-signs-on-the-separatrix": separatrix([true, true]),
            r"On the separatrix the momentum $m = (s B_{13}\operatorname{sech}, G\operatorname{tanh}, s' B_{31}\operatorname{sech})$, where $s^2 = 1$ and $s'^2 = 1$, obeys Euler's equations with the argument's rate $u' = s s'\lambda_2$.";
            but "one sign for both ends in the rate": separatrix([true, false]),
        [Again] "errata-rate-of-the-angle": rate_of_the_angle(1),
            r"The attitude that takes the momentum to the third axis by the shortest way and then turns about it obeys the attitude's law if the angle has the rate $\psi' = (2 T + G m_3/I_3)/(G + m_3)$.";
            but "a minus in the numerator": rate_of_the_angle(-1),
        [Again] "errata-sign-of-the-angle": closed_angle(|_| Fraction::one()),
            r"That rate, $\psi' = (2 T + G m_3/I_3)/(G + m_3)$ with the energy of that motion about the axis of the smallest moment, is $\psi' = \frac{G}{I_3} + \frac{G I_{31}}{I_1 I_3}(P - \frac{B_{31} B_{13}}{G B_{21}} A)$, with the derivatives of the integral and of the arctangent put in: $P = 1/(1 + (B_{31}/B_{13})^2\operatorname{sn}^2)$, of which the characteristic has a minus, and $A = \frac{B_{21}}{B_{13}}\operatorname{cn}/(\operatorname{dn}^2 + (B_{21}/B_{13})^2\operatorname{sn}^2)$.";
            but "a plus before the arctangent": closed_angle(|_| Fraction::from(-1)),
            but "the factor not divided by the momentum": closed_angle(Clone::clone),
        [Lemma] "errata-characteristic-on-the-separatrix": characteristic(true),
            r"On the separatrix $G^4/(B_{21}^2 B_{23}^2) = 1$, so that an integral over one minus it divides by zero.";
            but "any energy": characteristic(false),
        [Lemma] "errata-integral-of-tanh": integral_of_tanh(1),
            r"With $a^2 = n$ and $x = a\operatorname{tanh}$, where $x'$ is its rate and the derivative of the inverse of the hyperbolic tangent is put in, $\frac{1}{1 - n} - \frac{a}{(1 - n)\lambda} A = \frac{1}{1 - n\operatorname{tanh}^2}$, with $A = x'/(1 - x^2)$.";
            but "a plus before the second term": integral_of_tanh(-1),
        [Again] "errata-acceleration": acceleration(false),
            r"Of a body whose spin is the closed form's, $\omega = (o_1\operatorname{cn}, o_2\operatorname{sn}, o_3\operatorname{dn})$ along three axes in cyclic order, with its amplitudes, the square $m$ of its modulus and the rate $\lambda$ of its argument, the library's Euler's equations want $\omega' = \lambda (-o_1\operatorname{sn}\operatorname{dn}, o_2\operatorname{cn}\operatorname{dn}, -m o_3\operatorname{sn}\operatorname{cn})$.";
            but "the first two exchanged": acceleration(true),
        [Lemma] "errata-precession": precession(1),
            r"Along the motion, the rate of an angle of Euler, $\phi' = M (I_1\omega_1^2 + I_2\omega_2^2)/(M^2 - I_3^2\omega_3^2)$, is $\phi' = \frac{M}{I_3}(1 + \frac{I_{32} I_{31}}{I_1 I_{32} + I_3 I_{21}\operatorname{sn}^2})$.";
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

/// Jacobi's functions and the hyperbolic ones.
fn functions() -> Scope {
    Scope::default().with_functions(&["sn", "cn", "dn", "sech", "tanh"], "")
}

fn circling(case: Side, sign: i64) -> Result<Scope, Residue> {
    let [x1, x2, x3, p, q, r, k, z, s] = variables(["x1", "x2", "x3", "p", "q", "r", "k", "z", "s"]);
    let [sn, cn, dn] = variables(["sn", "cn", "dn"]);
    // Near is what lies between the circled axis and the middle one. The root of the discriminant that
    // gives the speed is z r far.
    let (near, far) = if case == Side::Smallest { (&p, &q) } else { (&q, &p) };
    let speed = &z * &r * far * near / (&x1 * &x2 * &x3);
    let rate = &speed * &s * Fraction::from(sign);
    let (large, small, across) = (far * &z, &k * &z * near, &x2 * &k * &z * &r);
    let middle = -(&across * sn);
    let ([b13, b31], momentum, names) = match case {
        Side::Smallest => {
            let [b13, b31] = [&x1 * large, &x3 * small];
            let momentum = Vector::new(&s * &b13 * dn, middle, &b31 * cn);
            ([b13, b31], momentum, ["B_{21}", r"\lambda_3"])
        }
        Side::Largest => {
            let [b13, b31] = [&x1 * small, &x3 * large];
            let momentum = Vector::new(&b13 * cn, middle, &s * &b31 * dn);
            ([b13, b31], momentum, ["B_{23}", r"\lambda_1"])
        }
    };
    let relations = relations(Vec::new())?;
    obeys_euler(&momentum, &Derivation::elliptic(&rate), &relations)?;
    let scope = functions().with_all([("B_{13}", b13), ("B_{31}", b31), (names[0], across)]);
    Ok(scope.with_all([("s", s), ("u'", rate), (names[1], speed)]).with("m", momentum).under(relations))
}

/// With the first sign, the second or both in the rate.
fn separatrix(in_rate: [bool; 2]) -> Result<Scope, Residue> {
    let [x1, x2, x3, p, q, r, z] = variables(["x1", "x2", "x3", "p", "q", "r", "z"]);
    let [s, t, sech, tanh] = variables(["s", "s'", "sech", "tanh"]);
    let speed = &z * &p * &q / (&x1 * &x3 * &x2.pow(2));
    let counted = [&s, &t].into_iter().zip(in_rate).filter(|(_, counts)| *counts);
    let rate = counted.fold(speed.clone(), |rate, (sign, _)| rate * sign);
    // z is the momentum's length G.
    let [b13, b31] = [&x1 * &q, &x3 * &p].map(|x| x * &z / (&x2 * &r));
    let momentum = Vector::new(&s * &b13 * &sech, &z * tanh, &t * &b31 * sech);
    let relations = relations(Vec::new())?;
    obeys_euler(&momentum, &Derivation::hyperbolic(&rate), &relations)?;
    let scope = functions().with_all([("B_{13}", b13), ("B_{31}", b31), ("G", z), ("s", s), ("s'", t)]);
    Ok(scope.with_all([("u'", rate), (r"\lambda_2", speed)]).with("m", momentum).under(relations))
}

fn rate_of_the_angle(sign: i64) -> Result<Scope, Residue> {
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
    let energy = energy(&omega, &m);
    let angle = (&energy * Fraction::from(2) + &length * &omega.z * Fraction::from(sign)) / (&length + &m.z);
    let about = pure(&Vector::new(zero(), zero(), &angle / Fraction::from(2)));
    let turned = product(&about, &way).coords;
    let left = turned + way.coords.map(|x| time.of(&x) - x * shrinks.clone()) - rate(&way, &omega).coords;
    left.iter().try_for_each(|x| vanishes("q' - q w / 2", x, &sphere))?;
    let scope = Scope::default().with_each("I", &moments).with_each("m", &m);
    Ok(scope.with_all([("G", length), ("T", energy), (r"\psi'", angle)]).under(sphere))
}

/// With the arctangent taken times this share of the momentum.
fn closed_angle(times: impl Fn(&Fraction) -> Fraction) -> Result<Scope, Residue> {
    let [x1, x2, x3, p, q, r, k, z] = variables(["x1", "x2", "x3", "p", "q", "r", "k", "z"]);
    let [g, sn, cn, dn] = variables(["G", "sn", "cn", "dn"]);
    let (b13, b31, b21) = (&x1 * &q * &z, &x3 * &k * &p * &z, &x2 * &k * &z * &r);
    let third = square("x1") + square("p") + square("q");
    let length = square("z") * (square("x1") * square("q") + third * square("p") * Polynomial::variable("m"));
    let [i1, _, i3] = moments().into();
    // The derivatives by the argument of the integral and of the arctangent of (B21 / B13) sn / dn.
    let integral = Fraction::one() / (Fraction::one() + (&b31 / &b13).pow(2) * sn.pow(2));
    let arctangent = &b21 / &b13 * &cn / (dn.pow(2) + (&b21 / &b13).pow(2) * sn.pow(2));
    let momentum = Vector::new(&b13 * dn, -(&b21 * sn), &b31 * cn);
    let twice_energy = energy(&momentum.component_div(&moments()), &momentum) * Fraction::from(2);
    let m3 = momentum.z.clone();
    let rate = (&twice_energy + &g * &m3 / &i3) / (&g + &m3);
    let scope = functions().with_all([("P", integral), ("A", arctangent * times(&g)), (r"\psi'", rate)]);
    let scope = scope.with_all([("T", twice_energy / Fraction::from(2)), ("I_{31}", r.pow(2)), ("G", g)]);
    let scope = scope.with_all([("m_3", m3), ("I_1", i1), ("I_3", i3), ("B_{13}", b13), ("B_{31}", b31)]);
    Ok(scope.with("B_{21}", b21).under(relations(vec![("G", length)])?))
}

fn characteristic(on_it: bool) -> Scope {
    let [i1, i2, i3, g, energy] = variables(["I1", "I2", "I3", "G", "T"]);
    let length2 = g.pow(2);
    let twice = if on_it { &length2 / &i2 } else { energy * Fraction::from(2) };
    let discriminant = |i: &Fraction| &length2 - &twice * i.clone();
    let amplitude = |i: &Fraction| Value::Root(&i2 * discriminant(i) / (&i2 - i));
    Scope::default().with("B_{21}", amplitude(&i1)).with("B_{23}", amplitude(&i3)).with("G", g)
}

fn integral_of_tanh(sign: i64) -> Result<Scope, Residue> {
    let [a, rate] = variables(["a", "lambda"]);
    let inner = &a * Fraction::variable("tanh");
    let grows = Derivation::hyperbolic(&rate).of(&inner) * Fraction::from(sign);
    let area = &grows / (Fraction::one() - inner.pow(2));
    let scope = functions().with_all([("x", inner), ("x'", grows), ("A", area), ("n", a.pow(2))]);
    Ok(scope.with_all([("a", a), (r"\lambda", rate)]).under(relations(Vec::new())?))
}

fn acceleration(exchanged: bool) -> Result<Scope, Residue> {
    let Motion { omega, moments, amplitudes, rate, relations, .. } = motion(1, Change::None)?;
    let omega = Vector::from(omega);
    let mut change = angular_acceleration(&Vector::from(moments), &omega, &Vector::zeros());
    if exchanged {
        change.swap_rows(0, 1);
    }
    let [x, y, z] = amplitudes;
    let [h, p, sigma] = variables(["h", "p", "sigma"]);
    let scope = functions().with_each("o", &[x, y, sigma * z]).with("m", h.pow(2) * p.pow(2));
    Ok(scope.with(r"\lambda", rate).with(r"\omega", omega).with(r"\omega'", change).under(relations))
}

fn precession(sign: i64) -> Scope {
    let [i1, i2, i3, d, sn, cn, length] = variables(["I1", "I2", "I3", "D", "sn", "cn", "M"]);
    let (i32, i31, i21) = (&i3 - &i2, &i3 - &i1, &i2 - &i1);
    // D is 2 T I3 - M².
    let first = &d / (&i1 * &i31) * cn.pow(2);
    let second = &d / (&i2 * &i32) * sn.pow(2);
    let across = i1.pow(2) * &first + i2.pow(2) * &second;
    let third = (length.pow(2) - &across) / i3.pow(2);
    let rate = &length * (&i1 * &first + &i2 * &second) / across;
    [first, second, third]
        .into_iter()
        .zip(1..)
        .fold(functions(), |scope, (square, n)| scope.with(&format!(r"\omega_{n}"), Value::Root(square)))
        .with_each("I", &[i1, i2, i3])
        .with_all([("I_{32}", i32), ("I_{31}", i31 * Fraction::from(sign)), ("I_{21}", i21)])
        .with_all([("M", length), (r"\phi'", rate)])
        .under(Relations::circle("cn", "sn"))
}
