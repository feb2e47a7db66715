//! What the names mean where the book derives the exact motion: the motion whose spin and attitude are
//! proven to obey Euler's equations and `q' = q w/2`, and the series as sums of their terms, cut off here: no
//! function of the library's closed form runs.

use crate::number::{Derivation, Fraction, Relations};
use crate::proofs::klein::{Change, Motion, motion};
use crate::symbols::{Vector, changing, variables, vector};
use crate::tex::Scope;
use num_traits::{One, Zero};
use tumbling::dynamics::euler::angular_acceleration;

/// The constants of the motion and the spin, at any instant; nothing has a meaning if there is none.
pub(super) fn at_any_time() -> Scope {
    of_motion(1, false)
}

/// The motion where across, middle and circled axis follow each other the other way.
pub(super) fn in_the_other_order() -> Scope {
    of_motion(-1, false)
}

/// The motion at the saddle, where the spin across vanishes.
pub(super) fn at_the_saddle() -> Scope {
    of_motion(1, true)
}

fn of_motion(sense: i64, saddle: bool) -> Scope {
    let Ok(motion) = motion(sense, Change::None) else { return Scope::default() };
    let [one, zero, kp] = [Fraction::one(), Fraction::zero(), Fraction::variable("kp")];
    let put = |x: &Fraction| {
        if !saddle {
            return x.clone();
        }
        let values = [("cn", &zero), ("sn", &one), ("dn", &kp)];
        values.into_iter().fold(x.clone(), |x, (name, value)| x.substitute(&name.into(), value))
    };
    let [h, p, q, r, big] = variables(["h", "p", "q", "r", "Q"]);
    let Motion { moments, amplitudes, zero: [beta, gamma, delta], .. } = &motion;
    let mut scope = with_errors(Scope::default());
    let [i, omega] = [moments, &motion.omega].map(|x| motion.arranged(x, sense));
    let rates = angular_acceleration(&i, &omega, &Vector::zeros());
    let places = if sense > 0 { [1, 2, 0] } else { [2, 1, 0] };
    for (k, name) in ["X", "M", "C"].into_iter().enumerate() {
        scope = scope
            .with(&format!("I_{name}"), moments[k].clone())
            .with(&format!("A_{name}"), amplitudes[k].clone())
            .with(&format!(r"\omega_{name}"), put(&motion.omega[k]))
            .with(&format!(r"\dot{{\omega}}_{name}"), put(&rates[places[k]]));
    }
    for name in ["sn", "cn", "dn"] {
        let function = Fraction::variable(name);
        scope = scope
            .with(&format!(r"\operatorname{{{name}}}(u)"), put(&function))
            .with(&format!(r"\operatorname{{{name}}}(u_0)"), function);
    }
    let (twice, momentum) = (&motion.twice_energy, &motion.momentum);
    let circled = put(&Fraction::variable("dn")) * gamma / delta;
    let tilt =
        (&h * variables(["x2"])[0].clone() * &r / Fraction::variable("e")) / (&one + &kp * gamma / delta);
    scope
        .with_all([("d_{CX}", r.pow(2)), ("d_{CM}", q.pow(2)), ("d_{MX}", p.pow(2))])
        .with_all([("E", twice / Fraction::from(2)), ("L", momentum.clone())])
        .with_all([("D", momentum.pow(2) - twice * &moments[1]), ("P", &h * &q * &big), ("Q", big)])
        .with_all([("k", &h * &p), ("k'", kp.clone()), (r"\zeta", &kp * &amplitudes[2])])
        .with_all([("s", Fraction::from(sense)), (r"\sigma", Fraction::variable("sigma"))])
        .with_all([(r"\tau", Fraction::variable("tau")), (r"\eta", motion.rate.clone())])
        .with_all([(r"\beta", beta.clone()), (r"\gamma", gamma.clone()), (r"\delta", delta.clone())])
        .with_all([(r"\chi", circled), (r"\kappa", tilt), (r"\dot{\psi}", put(&motion.turning))])
        .with("R", &moments[1] * q.pow(2) / (&moments[0] * r.pow(2)))
        .with("S", &moments[1] * p.pow(2) / (&moments[2] * r.pow(2)))
        .with("T", &moments[0] * p.pow(2) / (&moments[2] * q.pow(2)))
        .under(motion.relations)
}

/// Where the amplitude and the argument are too large, by a share and by an amount, the components are by the
/// two errors.
fn with_errors(scope: Scope) -> Scope {
    let [mu, lambda, sn, cn, dn] = variables(["mu", "lambda", "sn", "cn", "dn"]);
    scope.with(r"\epsilon_M", &lambda + &mu * &cn * &dn / &sn).with_all([
        (r"\epsilon_X", &lambda - &mu * sn * dn / cn),
        (r"\mu", mu),
        (r"\lambda", lambda),
    ])
}

/// Twice the cosine of `n` times an angle, from that of the angle; and the sine over that of the angle.
fn chebyshev(n: usize, cos: &Fraction) -> (Fraction, Fraction) {
    let (two, one, zero) = (Fraction::from(2), Fraction::one(), Fraction::zero());
    let (mut c, mut s) = (vec![two.clone(), &two * cos], vec![zero, one]);
    for k in 2..=n {
        c.push(&two * cos * &c[k - 1] - &c[k - 2]);
        s.push(&two * cos * &s[k - 1] - &s[k - 2]);
    }
    (c[n].clone(), s[n].clone())
}

fn alternating(n: usize) -> Fraction {
    Fraction::from(if n.is_multiple_of(2) { 1 } else { -1 })
}

/// Powers, also below zero.
fn power(x: &Fraction, n: i32) -> Fraction {
    if n < 0 { Fraction::one() / x.pow(n.unsigned_abs()) } else { x.pow(n.unsigned_abs()) }
}

/// Jacobi's theta functions to four terms each: the nome is a symbol, `c` the cosine of the doubled phase.
pub(super) fn direct() -> Scope {
    let [q, c] = variables(["q", "c"]);
    let [mut third, mut fourth] = [Fraction::one(), Fraction::one()];
    let [mut second, mut first] = [Fraction::zero(), Fraction::zero()];
    for n in 1..=3_u32 {
        let term = q.pow(n * n) * chebyshev(n as usize, &c).0;
        third += term.clone();
        fourth += term * alternating(n as usize);
    }
    for n in 0..=3_usize {
        // cos (2n+1)z over cos z, with the sign of sin (2n+1)z over sin z, from waves of the doubled phase.
        let (even, odd) = (chebyshev(n, &c).1, chebyshev(n + 1, &c).1);
        let size = q.pow((n * n + n) as u32);
        first += &size * (&odd + &even) * alternating(n);
        second += size * (odd - even);
    }
    Scope::default()
        .with_all([("q", q), ("c", c), (r"\theta_1", first), (r"\theta_2", second), (r"\theta_3", third)])
        .with(r"\theta_4", fourth)
}

/// The attitude's two theta functions: their nome is that of `direct` squared, `f` and `q/f` are the
/// exponentials of the zero.
pub(super) fn attitude() -> Scope {
    let [q, f, c, s, w, sin, cos] = variables(["q", "f", "c", "s", "w", "sin", "cos"]);
    let waves = |n: usize, sign: i64| {
        let sign = Fraction::from(sign);
        power(&q, (2 * n * n) as i32) * (power(&f, -(n as i32)) + sign * power(&f, n as i32))
    };
    // The odd ones, times the root of f and without the first power of the nome.
    let odd = |n: usize, sign: i64| {
        let sign = Fraction::from(sign);
        power(&q, (2 * n * (n + 1)) as i32) * (power(&f, -(n as i32)) + sign * power(&f, n as i32 + 1))
    };
    let (mut a_real, mut a_imaginary) = (Fraction::one(), Fraction::zero());
    for n in 1..=3 {
        let (wave, sine) = chebyshev(n, &c);
        a_real += waves(n, 1) * wave / Fraction::from(2) * alternating(n);
        a_imaginary += waves(n, -1) * sine * &w * &s * alternating(n);
    }
    let (mut b_real, mut b_imaginary) = (Fraction::zero(), Fraction::zero());
    for n in 0..=2 {
        let (even, above) = (chebyshev(n, &c).1, chebyshev(n + 1, &c).1);
        b_real += odd(n, 1) * (&above + &even) * alternating(n) * &sin;
        b_imaginary += -(odd(n, -1) * (above - even) * alternating(n) * &cos * &s);
    }
    // At z = 0, where c is one and w grows by twice z.
    let rate = (1..=3).fold(Fraction::zero(), |sum, n| {
        sum + waves(n, -1) * alternating(n) * Fraction::from(2 * n as i64) * &s
    });
    let start = (1..=3).fold(Fraction::one(), |sum, n| sum + waves(n, 1) * alternating(n));
    let mut scope = Scope::default();
    for (wide, narrow, sign) in [("h", "H", 1), ("l", "J", -1)] {
        scope = scope.with_each(wide, &[1, 2, 3].map(|n| waves(n, sign)));
        scope = scope.with_each(narrow, &[1, 2].map(|n| odd(n, sign)));
    }
    scope
        .with_all([("g", &q / &f), ("q", q), ("f", f), ("c", c), ("s", s), ("w", w), (r"\sin(z)", sin)])
        .with_all([(r"\cos(z)", cos), ("a_1", a_real), ("a_2", a_imaginary), ("b_1", b_real)])
        .with_all([("b_2", b_imaginary), (r"\rho", rate / start)])
        .under(Relations::default())
}

/// The complementary sums, without their first exponentials.
pub(super) fn complementary() -> Scope {
    let [v, other] = variables(["v", "V"]);
    let nome = &v * &other;
    let even = |sign: i64| {
        (1..=3_i32).fold(Fraction::one(), |sum, n| {
            let sign = if n % 2 == 1 { Fraction::from(sign) } else { Fraction::one() };
            // The nome to n², times exp(2nx) = v^-n and its inverse.
            sum + power(&nome, n * n) * (power(&v, -n) + power(&v, n)) * sign
        })
    };
    let odd = |sign: i64| {
        (0..=2_i32).fold(Fraction::zero(), |sum, n| {
            let alternates = if n % 2 == 1 && sign < 0 { -1 } else { 1 };
            let pair = Fraction::one() + Fraction::from(sign) * power(&v, 2 * n + 1);
            sum + power(&nome, n * n + n) * power(&v, -n) * pair * Fraction::from(alternates)
        })
    };
    let squares = |sign: i64| {
        (1..=3_i64).fold(Fraction::one(), |sum, n| {
            let size = nome.pow((n * n) as u32) * Fraction::from(2);
            sum + if n % 2 == 1 { size * Fraction::from(sign) } else { size }
        })
    };
    Scope::default()
        .with("m_2", (0..=2).fold(Fraction::zero(), |sum, n: u32| sum + nome.pow(n * n + n)))
        .with_all([("m_3", squares(1)), ("m_4", squares(-1)), ("q'", nome.clone()), ("v", v.clone())])
        .with_all([("V", other), (r"\theta'_1", odd(-1)), (r"\theta'_2", odd(1)), (r"\theta'_3", even(1))])
        .with(r"\theta'_4", even(-1))
}

/// The attitude's two numbers in hyperbolic functions, from their growing and falling exponentials.
pub(super) fn complementary_attitude() -> Scope {
    let [p, e, s] = variables(["p", "e", "s"]);
    let r = p.pow(2) / &e;
    let mut scope = Scope::default();
    let mut sums = [Fraction::zero(), Fraction::zero(), Fraction::zero(), Fraction::zero()];
    for n in 0..=4_i32 {
        let [c, d] = ["U", "Y"].map(|name| Fraction::variable(&format!("{name}{}", 2 * n + 1)));
        // exp((2n+1)x/2) and its inverse, times exp(-x/2).
        let grows = power(&p, n * n + n) * power(&e, -n);
        let falls = if n < 4 { power(&p, n * n + n) * power(&e, n + 1) } else { Fraction::zero() };
        let sign = alternating(n as usize);
        sums[0] += &c * (&grows + &falls);
        sums[1] += -(&d * (&grows - &falls)) * &s;
        sums[2] += &c * (&grows - &falls) * &sign;
        sums[3] += -(&d * (&grows + &falls)) * &s * sign;
        scope = scope.with(&format!("U_{}", 2 * n + 1), c).with(&format!("Y_{}", 2 * n + 1), d);
    }
    let [a_1, a_2, b_1, b_2] = sums;
    scope
        .with_all([("p", p), ("e", e), ("r", r), ("s", s), ("a_1", a_1), ("a_2", a_2), ("b_1", b_1)])
        .with("b_2", b_2)
}

/// The steady rate of the common phase, where the phase of the series is zero and dn is one; `rho` is the
/// rate of the angle of `a` by that phase.
pub(super) fn drift() -> Scope {
    let Ok(motion) = motion(1, Change::None) else { return Scope::default() };
    let [pi, quarter, rho] = variables(["pi", "K", "rho"]);
    let two = Fraction::from(2);
    let values = [("cn", Fraction::one()), ("sn", Fraction::zero()), ("dn", Fraction::one())];
    let about = values.iter().fold(motion.turning, |x, (name, value)| x.substitute(&(*name).into(), value));
    Scope::default()
        .with(r"\nu", about / &two - &pi * &motion.rate / (&two * &quarter) * &rho)
        .with_all([(r"\sigma", Fraction::variable("sigma")), ("E", motion.twice_energy / two)])
        .with_all([("L", motion.momentum), ("A_C", motion.amplitudes[2].clone())])
        .with_all([("I_C", motion.moments[2].clone()), (r"\eta", motion.rate), (r"\pi", pi)])
        .with_all([("K", quarter), (r"\rho", rho)])
        .under(motion.relations)
}

/// The drift at the saddle: `a` is there, but for a steady factor, the sum of all `p^(n²) exp(-n x)` with
/// the angle of `-2 s n phi`, and `x` is zero.
pub(super) fn drift_at_the_saddle() -> Scope {
    let [psi, s, pi, eta, other, p] = variables(["psi", "s", "pi", "eta", "K'", "p"]);
    let (mut real, mut turned, mut scope) = (Fraction::one(), Fraction::zero(), Scope::default());
    for n in 1..=4_i64 {
        let size = p.pow((n * n) as u32) * Fraction::from(2);
        let [cos, sin] = ["U", "Y"].map(|wave| Fraction::variable(&format!("{wave}{}", 2 * n)));
        real += &size * &cos;
        turned += -(&s * size * &sin * Fraction::from(n));
        scope = scope.with(&format!("U_{}", 2 * n), cos).with(&format!("Y_{}", 2 * n), sin);
    }
    let two = Fraction::from(2);
    scope.with(r"\nu", &psi / &two - &pi * &eta / (two * &other) * turned / real).with_all([
        (r"\dot{\psi}", psi),
        ("s", s),
        (r"\pi", pi),
        (r"\eta", eta),
        ("K'", other),
        ("p", p),
    ])
}

/// Flips: the argument at the start is the one that is zero at the time of a flip.
pub(super) fn flips() -> Scope {
    let [count, quarter, eta, nu, t] = variables(["N", "K", "eta", "nu", "t"]);
    let two = Fraction::from(2);
    let half_period = &two * &quarter / &eta;
    Scope::default()
        .with_all([("u_0", &two * &count * &quarter - &eta * &t), ("t_N", t)])
        .with_all([(r"\upsilon", two * &nu * half_period), ("N", count), ("K", quarter), (r"\eta", eta)])
        .with(r"\nu", nu)
}

/// A change of the spin, by the library's equations to first order; the axes counted from this one on.
pub(super) fn variation(axis: usize) -> Scope {
    let (moments, omega, change) = (vector("I"), vector("omega"), vector("W"));
    let rate = angular_acceleration(&moments, &omega, &Vector::zeros());
    let moved = |x: &Fraction| changing(Derivation::default(), "omega", &change).of(x);
    let from_axis = |v: &Vector| [0, 1, 2].map(|n| v[(axis + n) % 3].clone());
    Scope::default()
        .with_each("I", &from_axis(&moments))
        .with_each("W", &from_axis(&change))
        .with_each(r"\omega", &from_axis(&omega))
        .with(r"\dot{W}_1", moved(&rate[axis]))
}

/// Carlson's series for `count` numbers, whose integrand falls with the power `first/2` of their mean: the
/// inverse root of `1 + E_2 h² - E_3 h³ + ...` with each power of `h` integrated, to the seventh.
pub(super) fn carlson(count: u32, first: i64) -> Scope {
    let mut scope = Scope::default();
    let mut rest = Fraction::zero();
    for n in 2..=count {
        let sum = Fraction::variable(&format!("B{n}"));
        rest += &sum * Fraction::variable("h").pow(n) * alternating(n as usize);
        scope = scope.with(&format!("B_{n}"), sum);
    }
    // The binomial series of the power -1/2.
    let (mut term, mut sum) = (Fraction::one(), Fraction::zero());
    for k in 0..=3 {
        sum += term.clone();
        term *= &rest * Fraction::ratio(-(2 * k + 1), 2 * k + 2);
    }
    let parts = sum.numerator().in_powers_of(&"h".into());
    let below = Fraction::from(sum.denominator().clone());
    let integrated = (0..).zip(parts).take(8).fold(Fraction::zero(), |sum, (n, part)| {
        sum + Fraction::from(part) / &below * Fraction::ratio(first, 2 * n + first)
    });
    scope.with(if count == 3 { "r_F" } else { "r_D" }, integrated)
}
