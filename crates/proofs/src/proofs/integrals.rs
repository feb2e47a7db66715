//! The integrals of the closed form: Gauss's mean, Carlson's integrals by duplication, and Legendre's
//! integrals as Carlson writes them.
//!
//! Two integrals are equal if a change of variable maps one integrand and its range to the other. Each claim
//! is about integrands; no check covers the ranges. The roots are symbols, related by their squares or by
//! their derivatives.

use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::proof::Residue;
use crate::proofs::klein::{Change, Motion, motion};
use crate::symbols::{square, variables};
use crate::tex::{Scope, Value};
use num_traits::One;

proofs! {
    "exact" {
        [Lemma] "gauss-mean": gauss(-1),
            r"By $u = \tfrac{1}{2}(t - a b/t)$, which rises with $u' > 0$, the integrand becomes that of the arithmetic and the geometric mean: $u'^2 (t^2 + a^2) (t^2 + b^2) = 4 (u^2 + (\frac{a + b}{2})^2) (u^2 + a b)$. For two equal numbers, by $v = m s/c$, it is one over their mean: $v' m = v^2 + m^2$. By $w = k' s/c$ it becomes Legendre's: $w'^2 (1 - (1 - k'^2) s^2) = (w^2 + 1) (w^2 + k'^2)$. Here $s$ and $c$ are an angle's sine and cosine; the limits of the integrals are no part of it.";
            but "a plus in the change of variable": gauss(1),
        [Lemma] "last-mean": last_mean(4),
            r"Of two numbers $G_1$ and $G_2$ with the mean $m = \tfrac{1}{2}(G_1 + G_2)$ and the geometric mean $g^2 = G_1 G_2$, the next mean is (C45) but for the term $r = (m - g)^2/(4 m)$.";
            but "the geometric mean nearer to the other": last_mean(8),
        [Lemma] "carlson-duplication": duplication(1, 3),
            r"With $s = t + X Y + Y Z + Z X$, where $x = X^2 - t$ and so on, the roots of the new numbers are $s + x = (X + Y) (X + Z)$, $s + y = (Y + Z) (Y + X)$ and $s + z = (Z + X) (Z + Y)$. So the integrand of the first kind is half: $\frac{s'}{(X + Y) (Y + Z) (Z + X)} = \frac{1}{2 X Y Z}$; that of the second changes by a derivative: $\frac{3}{2 X Y Z^3} - \frac{3 s'}{(X + Y) (Y + Z)^2 (Z + X)^2} = -T'$ with $T = \frac{3}{Z (Y + Z) (Z + X)}$. Scaling and limits of the integrals are no part of it.";
            but "a product of roots the other way": duplication(-1, 3),
            but "another term taken off": duplication(1, 2),
        [Lemma] "legendre-by-carlson": legendre(1),
            r"By $t = (s^2 - y^2)/y^2$, which falls from infinity as the sine $y$ rises, with $c$ for the cosine, the roots of Carlson's integrals become $t + 1 - s^2 = (s c/y)^2$, $t + 1 - k^2 s^2 = (s r/y)^2$ and $t + 1 = (s/y)^2$, where $r^2 = 1 - k^2 y^2$; with their product $P$, Legendre's integrand is that of the first, $\frac{s t'}{2 P} = \frac{1}{r}$, and its derivative by the square of $k$ that of the second, $\frac{s^3 t'}{4 P (s r/y)^2} = \frac{y^2}{2 r^3}$. Jacobi's functions $S$, $C$ and $D$ of what is left to the quarter period have $C^2 + S^2 = 1$, $D^2 + k^2 S^2 = 1$ and $S' = -C D$, and those of the theta zero $\beta^2 + \gamma^2 = 1$ and $\delta^2 + k'^2\beta^2 = 1$. The limits are no part of it.";
            but "the parameter's sign": legendre(-1),
    }
}

/// By the angle whose sine and cosine are the symbols of these names.
fn by_angle() -> Derivation {
    let [sin, cos] = variables(["sin", "cos"]);
    Derivation::new([("sin", cos), ("cos", -sin)])
}

fn gauss(sign: i64) -> Scope {
    let [a, b, t, m, sin, cos, kp] = variables(["a", "b", "t", "m", "sin", "cos", "kp"]);
    let u = (&t + &a * &b / &t * Fraction::from(sign)) / Fraction::from(2);
    let [v, w] = [&m, &kp].map(|x| x * &sin / &cos);
    let [rises, v_rate, w_rate] = [u.derivative(&"t".into()), by_angle().of(&v), by_angle().of(&w)];
    Scope::default()
        .with_all([("a", a), ("b", b), ("t", t), ("m", m), ("k'", kp), ("s", sin), ("c", cos)])
        .with_all([("u", u), ("v", v), ("w", w), ("u'", rises), ("v'", v_rate), ("w'", w_rate)])
        .under(Relations::circle("cos", "sin"))
        .positive(["a", "b", "t"])
}

/// The difference of the numbers has the square of the mean less that of the geometric mean, times `times`.
fn last_mean(times: i64) -> Result<Scope, Residue> {
    let [m, g, d] = variables(["m", "g", "d"]);
    let relations = Relations::new(vec![("d", (square("m") - square("g")) * Polynomial::from(times))])?;
    let half = &d / Fraction::from(2);
    let rest = (&m - &g).pow(2) / (&m * Fraction::from(4));
    let next = (&m + &g) / Fraction::from(2);
    let scope = Scope::default().with_all([("G_1", &m + &half), ("G_2", &m - half), ("G", next + &rest)]);
    Ok(scope.with_all([("m", m), ("g", g), ("r", rest)]).under(relations))
}

fn duplication(sign: i64, thrice: i64) -> Scope {
    let [x, y, z, t] = variables(["X", "Y", "Z", "t"]);
    let two = Fraction::from(2);
    let by_t = ["X", "Y", "Z"].iter().fold(Derivation::new([("t", Fraction::one())]), |all, name| {
        all.and(name, Fraction::one() / (&two * Fraction::variable(name)))
    });
    let s = &t + &x * &y + &y * &z + &z * &x * Fraction::from(sign);
    // Nothing where t is infinite.
    let taken = Fraction::from(thrice) / (&z * (&y + &z) * (&z + &x));
    Scope::default()
        .with_all([("s'", by_t.of(&s)), ("s", s), ("T'", by_t.of(&taken)), ("T", taken)])
        .with_all([("x", x.pow(2) - &t), ("y", y.pow(2) - &t), ("z", z.pow(2) - &t)])
        .with_all([("X", x), ("Y", y), ("Z", z), ("t", t)])
}

fn legendre(sign: i64) -> Result<Vec<Scope>, Residue> {
    let [s, m, sin, cos, rate] = variables(["s", "m", "sin", "cos", "Delta"]);
    let (one, parameter) = (Fraction::one(), Polynomial::variable("m"));
    let k = |sign: i64| Value::Root(&m * Fraction::from(sign));
    let relations = Relations::new(vec![
        ("cos", Polynomial::one() - square("sin")),
        ("Delta", Polynomial::one() - &parameter * square("sin")),
    ])?;
    // From t = 0 at the angle with the sine s on to infinity at the angle zero.
    let t = s.pow(2) / sin.pow(2) - &one;
    let falls = -Derivation::new([("sin", cos.clone())]).of(&t);
    let product = s.pow(3) * &cos * &rate / sin.pow(3);
    let integrand = Scope::default().with_all([("s", s), ("t", t), ("t'", falls), ("P", product)]);
    let integrand = integrand.with_all([("y", sin), ("c", cos), ("r", rate)]).with("k", k(sign));
    // What is left to the quarter period: cn/dn, k' sn/dn and k'/dn are its three functions.
    let [sn, cn, dn, kp] = variables(["sn", "cn", "dn", "kp"]);
    let jacobi = Relations::new(vec![
        ("cn", Polynomial::one() - square("sn")),
        ("dn", Polynomial::one() - &parameter * square("sn")),
        ("kp", Polynomial::one() - parameter),
    ])?;
    let far = &cn / &dn;
    let left = Scope::default().with("S'", Derivation::elliptic(&one).of(&far)).with("k", k(1));
    let left = left.with_all([("S", far), ("C", &kp * &sn / &dn), ("D", &kp / &dn)]).under(jacobi);
    let Motion { relations: of_motion, zero: [b, c, d], .. } = motion(1, Change::None)?;
    let zero = Scope::default().with_all([(r"\beta", b), (r"\gamma", c), (r"\delta", d), ("k'", kp)]);
    Ok(vec![integrand.under(relations), left, zero.under(of_motion)])
}
