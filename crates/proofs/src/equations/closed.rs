//! The meanings of the names where the book derives the exact motion. There are none unless the motion's spin
//! and attitude obey the library's Euler's equations and `q' = q w/2`; the series are the library's own.

use crate::number::{Derivation, Fraction, Polynomial, Relations, Series};
use crate::proofs::klein::{Motion, obeying};
use crate::symbols::{Vector, changing, variables, vector};
use crate::tex::Scope;
use num_traits::{One, Zero};
use tumbling::laws::{ComplementaryPair, ComplementarySeries, DirectPair, DirectSeries};
use tumbling::{dynamics::euler::angular_acceleration, number::Analytic};

/// The constants of the motion and the spin, at any instant; without such a motion the names have no meaning.
pub(super) fn at_any_time() -> Scope {
    at_an_instant(1, false)
}

/// The motion for the other cyclic order of the across, middle and circled axes.
pub(super) fn in_the_other_order() -> Scope {
    at_an_instant(-1, false)
}

/// The motion at the saddle, where the spin along the across axis is zero.
pub(super) fn at_the_saddle() -> Scope {
    at_an_instant(1, true)
}

fn at_an_instant(sense: i64, saddle: bool) -> Scope {
    obeying(sense).map(|motion| of_motion(motion, sense, saddle)).unwrap_or_default()
}

/// The constants of a motion and its spin, at any instant or at the saddle.
pub(crate) fn of_motion(motion: Motion, sense: i64, saddle: bool) -> Scope {
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
    let names = ["sn", "cn", "dn"];
    for name in names {
        scope = scope.with(&format!(r"\operatorname{{{name}}}(u)"), put(&Fraction::variable(name)));
    }
    scope = scope.with_functions(&names, "(u_0)");
    let (twice, momentum) = (&motion.twice_energy, &motion.momentum);
    let circled = put(&Fraction::variable("dn")) * gamma / delta;
    let [x2, e] = variables(["x2", "e"]);
    let tilt = &h * x2 * &r / e / (&one + &kp * gamma / delta);
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

/// Where the amplitude has a relative error and the argument an absolute one, the components have both
/// errors.
fn with_errors(scope: Scope) -> Scope {
    let [mu, lambda, sn, cn, dn] = variables(["mu", "lambda", "sn", "cn", "dn"]);
    scope.with(r"\epsilon_M", &lambda + &mu * &cn * &dn / &sn).with_all([
        (r"\epsilon_X", &lambda - &mu * sn * dn / cn),
        (r"\mu", mu),
        (r"\lambda", lambda),
    ])
}

/// Jacobi's theta functions by the sums of the library: the nome is a symbol, `c` the cosine of the doubled
/// phase.
pub(super) fn direct() -> Scope {
    let [q, c] = variables(["q", "c"]);
    let [third, fourth, second, first] = DirectSeries::new(q.clone()).thetas(c.clone());
    Scope::default()
        .with_all([("q", q), ("c", c), (r"\theta_1", first), (r"\theta_2", second), (r"\theta_3", third)])
        .with(r"\theta_4", fourth)
}

/// Jacobi's functions by the quotients of the library, of theta functions that are symbols.
pub(super) fn direct_quotients() -> Scope {
    let series = DirectSeries::new(Fraction::variable("q"));
    let [t1, t2, t3, t4, sin, cos] = variables(["t1", "t2", "t3", "t4", "sin", "cos"]);
    let thetas = [&t3, &t4, &t2, &t1].map(Fraction::clone);
    let values = series.quotients(thetas, [sin.clone(), cos.clone()]);
    let [n3, n4, n2, _] = series.thetas(Fraction::one());
    with_jacobi(values).with_each(r"\theta", &[t1, t2, t3, t4]).with_all([
        ("n_2", n2),
        ("n_3", n3),
        ("n_4", n4),
        (r"\sin(z)", sin),
        (r"\cos(z)", cos),
    ])
}

fn with_jacobi([sn, cn, dn]: [Fraction; 3]) -> Scope {
    let functions = [(r"\operatorname{sn}", sn), (r"\operatorname{cn}", cn), (r"\operatorname{dn}", dn)];
    Scope::default().with_all(functions)
}

/// The attitude's two theta functions by the sums of the library: their nome is that of `direct` squared, `f`
/// and `q/f` are the exponentials of the zero.
pub(super) fn attitude() -> Scope {
    let [q, f, c, s, w, sin, cos] = variables(["q", "f", "c", "s", "w", "sin", "cos"]);
    let (less, g) = (&f - Fraction::one(), &q / &f);
    let [h, l] = DirectPair::waves(&q, &f, &g);
    let [[_, odd_h @ ..], [_, odd_l @ ..]] = DirectPair::odd_waves(&q, [&f, &less], &g);
    let pair = DirectPair::new(q.clone(), [f.clone(), less], g.clone(), s.clone());
    let [a_1, a_2, b_1, b_2] = pair.sums([c.clone(), w.clone()], [sin.clone(), cos.clone()]);
    Scope::default()
        .with_each("h", &h)
        .with_each("l", &l)
        .with_each("H", &odd_h)
        .with_each("J", &odd_l)
        .with_all([("g", g), ("q", q), ("f", f), ("c", c), ("s", s), ("w", w), (r"\sin(z)", sin)])
        .with_all([(r"\cos(z)", cos), ("a_1", a_1), ("a_2", a_2), ("b_1", b_1), ("b_2", b_2)])
        .with(r"\rho", pair.turning_at_zero())
}

/// The complementary sums of the library, without their first exponentials, and Jacobi's functions by their
/// quotients next to the flip.
pub(super) fn complementary() -> Scope {
    by_complementary_sums(0)
}

/// The same next to the saddle.
pub(super) fn complementary_at_the_saddle() -> Scope {
    by_complementary_sums(1)
}

fn by_complementary_sums(side: usize) -> Scope {
    let [e, other, complement] = variables(["e", "V", "kp"]);
    let (v, one) = (e.pow(2), Fraction::one());
    let nome = &v * &other;
    let [m_2, m_3, m_4] = ComplementarySeries::constants(nome.clone());
    let series = ComplementarySeries::new(nome.clone(), complement.clone(), one.clone());
    let [first, second, fourth, third] = series.sums(v.clone(), &one - &v, other.clone());
    let sums = [&first, &second, &fourth, &third].map(Fraction::clone);
    let [flip, saddle] = series.parts(e.clone(), sums);
    with_jacobi(if side == 0 { flip } else { saddle }.quotients())
        .with_all([("m_2", m_2), ("m_3", m_3), ("m_4", m_4), ("q'", nome), ("v", v), ("e", e)])
        .with_all([("V", other), ("k'", complement), (r"\theta'_1", first), (r"\theta'_2", second)])
        .with_all([(r"\theta'_3", third), (r"\theta'_4", fourth)])
}

/// The attitude's two numbers in hyperbolic functions by the sums of the library, from their growing and
/// falling exponentials.
pub(super) fn complementary_attitude() -> Scope {
    let [p, e, s] = variables(["p", "e", "s"]);
    let r = p.pow(2) / &e;
    let waves = ["U", "Y"].map(|wave| [1, 3, 5, 7, 9].map(|n| Fraction::variable(&format!("{wave}{n}"))));
    let pair = ComplementaryPair::new(p.clone(), waves.clone(), s.clone());
    let [a_1, a_2, b_1, b_2] = pair.sums(e.clone(), r.clone());
    let scope = ["U", "Y"].iter().zip(waves).fold(Scope::default(), |scope, (name, waves)| {
        let odd = [1, 3, 5, 7, 9].into_iter().zip(waves);
        odd.fold(scope, |scope, (n, wave)| scope.with(&format!("{name}_{n}"), wave))
    });
    scope
        .with_all([("p", p), ("e", e), ("r", r), ("s", s), ("a_1", a_1), ("a_2", a_2), ("b_1", b_1)])
        .with("b_2", b_2)
}

/// The steady rate of the common phase, where the phase of the series is zero and dn is one; `rho` is the
/// rate of the angle of `a` by that phase.
pub(super) fn drift() -> Scope {
    let Ok(motion) = obeying(1) else { return Scope::default() };
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

/// The drift at the saddle, by the library's sum for how fast the angle of `a` turns there.
pub(super) fn drift_at_the_saddle() -> Scope {
    let [psi, s, pi, eta, other, p] = variables(["psi", "s", "pi", "eta", "K'", "p"]);
    let [sin, cos] = variables(["sin", "cos"]);
    let waves = ComplementaryPair::waves(sin.clone(), cos.clone());
    let pair = ComplementaryPair::new(p.clone(), waves, s.clone());
    let (two, mut scope) = (Fraction::from(2), Scope::default());
    // Cosines and sines of the even multiples, each from the one before.
    let doubled = [cos.pow(2) - sin.pow(2), &two * &sin * &cos];
    let mut wave = [Fraction::one(), Fraction::zero()];
    for n in 1..=4 {
        let [c, s] = &wave;
        wave = [c * &doubled[0] - s * &doubled[1], s * &doubled[0] + c * &doubled[1]];
        scope = scope.with(&format!("U_{}", 2 * n), wave[0].clone());
        scope = scope.with(&format!("Y_{}", 2 * n), wave[1].clone());
    }
    let one = || Polynomial::from(1);
    let circle = ("sin", one() - Polynomial::variable("cos").pow(2));
    let sense = ("s", one());
    scope
        .with(r"\nu", &psi / &two - &pi * &eta / (two * &other) * pair.turning_at_saddle())
        .with_all([(r"\dot{\psi}", psi), ("s", s), (r"\pi", pi), (r"\eta", eta), ("K'", other), ("p", p)])
        .under(Relations::new(vec![circle, sense]).unwrap_or_default())
}

/// A change of the spin, by the library's equations to first order; the axes counted from this one on.
pub(crate) fn variation(axis: usize) -> Scope {
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
pub(super) fn carlson(count: usize, first: i64) -> Scope {
    let (mut scope, mut square) = (Scope::default(), vec![Fraction::one(), Fraction::zero()]);
    for n in 2..=count {
        let sum = Fraction::variable(&format!("B{n}"));
        scope = scope.with(&format!("B_{n}"), sum.clone());
        square.push(if n % 2 == 0 { sum } else { -sum });
    }
    square.resize(8, Fraction::zero());
    let series = Series::one() / Series::new(square, 7).sqrt();
    let integrated = (0..8_u8).fold(Fraction::zero(), |sum, n| {
        let power = series.coefficient(n.into()).unwrap_or(Fraction::ratio(1, 0));
        sum + power * Fraction::ratio(first, 2 * i64::from(n) + first)
    });
    scope.with(if count == 3 { "r_F" } else { "r_D" }, integrated)
}
