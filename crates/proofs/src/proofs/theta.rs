//! Theta functions: identities of their quotients and products, each decided in all terms of its infinite
//! sums, for every nome; the terms of both sides of Jacobi's imaginary transformation; and bounds of the
//! terms. From these follow the scale of the argument and the nome of a modulus, as the chapter on the closed
//! form shows.

use crate::lattice::{Pairs, THETA_1, THETA_2, THETA_3, THETA_4, Theta};
use crate::number::{Fraction, Polynomial, Relations};
use crate::proof::Residue;
use crate::symbols::variables;
use crate::tex::{Scope, Value};
use num_traits::One;
use tumbling::laws::{ComplementaryPair, ComplementarySeries, DirectPair, DirectSeries};

proofs! {
    "exact" {
        [Lemma] "theta-sums-converge": converge(2),
            r"With $E = 2 b n - r n^2$ for the logarithm of a bound of the term of $n$, where the nome is at most the exponential of minus $r$ and the size of the imaginary part of the argument at most $b$, and $F$ for that of the next term, $E - F > 2$ from $n = (b + 1)/r + s$ on. So from there on each bound is less than a seventh of the one before, and with a factor of four times the square of the number, as two derivatives by the argument or one by the logarithm of the nome bring it, less than four sevenths, if the number is at least one. In the second theta function at zero the powers of the nome, beside a fourth root, are whole numbers times the next ones, and $m (m + 1) > 2 m$ for $m = 1 + s$: the sum is at most twice that root over one less the square of the nome. Here $b$, $r$ and $s$ are positive.";
            but "the number itself for its square": converge(1),
        "jacobi-by-thetas": jacobi(1, THETA_1),
            r"By $P_{33} = S_{33} + S_{22}$, $P_{44} = S_{33} - S_{22}$, $P_{22} = S_{23} + S_{32}$ and $P_{11} = S_{32} - S_{23}$, products of the theta functions of these numbers, on the left of the sum and of the difference of any two arguments, on the right of twice each argument in the square of the nome, Jacobi's three functions as quotients of theta functions have $\operatorname{sn}^2 + \operatorname{cn}^2 = 1$ and $\operatorname{dn}^2 + k^2\operatorname{sn}^2 = 1$, and the rate of the first is a constant times the two others, for every nome. The constant and which nome belongs to $k$ are no part of it. The library's sums, of either series, with the factors that they leave out, are the first terms of these theta functions: $A_1 = B_1$, $A_2 = B_2$, $A_3 = B_3$ and $A_4 = B_4$.";
            but "a sign in a square": jacobi(-1, THETA_1),
            but "another theta function above": jacobi(1, THETA_2),
        "attitude-by-thetas": [vec![products(ALL)], [1, -1].map(direct_pair).into()].concat(),
            r"For every nome and any two arguments $2 P_{44} = Q_{43} + Q_{34}$, $2 P_{11} = Q_{43} - Q_{34}$ and $2 P_{41} = Q_{12} - Q_{21}$: products of the theta functions of these numbers, on the left of the sum and of the difference of the arguments in the square of the nome, on the right of each argument. For a real first and an imaginary second argument the left sides are twice the squares of the lengths of the attitude's two numbers, and the conjugate of the first times the second; these are theta functions of the difference. The library's sums of the two numbers, but for a factor, are the first terms of such theta functions, the fourth and the first: $A = B$ and $C = D$.";
            but "the third for the fourth": products([THETA_1, THETA_2, THETA_3, THETA_3]),
        "attitude-by-complementary-thetas": [vec![products(ALL)], [1, -1].map(complementary_pair).into()].concat(),
            r"For every nome and any two arguments $P_{22} = S_{23} + S_{32}$, $P_{11} = S_{32} - S_{23}$ and $P_{21} = S_{14} - S_{41}$: products of the theta functions of these numbers, on the left of the sum and of the difference of the arguments, on the right of twice each argument in the square of the nome. The library's sums of the two numbers, but for a factor, are the first terms of such theta functions, the second and the first: $A = B$ and $C = D$.";
            but "the theta of the direct series": products([THETA_1, THETA_4, THETA_3, THETA_4]),
        [Lemma] "nome-and-scale": nome(ALL, true),
            r"For every nome $P_{33} = S_{33} + S_{22}$, $P_{44} = S_{33} - S_{22}$, $P_{22} = S_{23} + S_{32}$, $P_{34} = S_{44} - S_{11}$ and $P_{21} = S_{14} - S_{41}$: products as in the proof attitude-by-complementary-thetas. Where the arguments are zero, these tie the values $t_2$, $t_3$ and $t_4$ of the theta functions to $T_2$, $T_3$ and $T_4$ in the square of the nome, $t_3^2 = T_3^2 + T_2^2$, $t_4^2 = T_3^2 - T_2^2$, $t_2^2 = 2 T_2 T_3$ and $t_3 t_4 = T_4^2$, and the slope $d$ of the first to $D$, $d t_2 = 2 D T_4$. So $\frac{d}{t_2 t_3 t_4} = \frac{D}{T_2 T_3 T_4}$, and Gauss's step takes one pair of squares to the other: $\tfrac{1}{2} (t_3^2 + t_4^2) = T_3^2$ and $t_3^2 t_4^2 = T_4^4$. The modulus $k = t_2^2/t_3^2$ with the complement $k' = t_4^2/t_3^2$ becomes $l = T_2^2/T_3^2$ with $l (1 + k') = 1 - k'$ and $(1 + l)^2 k^2 = 4 l$. As power series in the nome the squares of $t_3$ and $t_4$, and the quotient of the slope and the three values, begin with $a = 1$, $b = 1$ and $c = 1$.";
            but "the third for the fourth": nome([THETA_1, THETA_2, THETA_3, THETA_3], true),
            but "the value of the first for its slope": nome(ALL, false),
        [Lemma] "imaginary-transformation": imaginary(1),
            r"The terms of Jacobi's imaginary transformation, in two sums over all whole numbers $n$. In one each term is the exponential of $E = -\frac{\pi (v - n)^2}{t}$ over the root of $t$, in the other that of $F = \pi n (2 i v - n t)$. With dots by $t$ and primes by $v$, terms of both obey one law of heat, $4\pi (\dot{E} - \frac{1}{2 t}) = E'' + E'^2$ and $4\pi\dot{F} = F'' + F'^2$. Where $v$ moves by a half, $E_1 = E$, if the number does too, and $F_1 = F + \pi i n$; where it moves by half of a quasi-period, $E_2 = E + \pi (\tfrac{1}{4} t - i v + i n)$, and $F_2 = G + \pi (\tfrac{1}{4} t - i v)$, with the number moved by a half in $G$. So over a period, and over a quasi-period, both sums have the same factor. At argument zero and time one their terms are the same, $E_3 = F_3$. With $x = \frac{\pi u}{2 K'}$, $\phi = \frac{\pi y}{4 K'}$ and $l = -\frac{\pi K}{2 K'}$, the first exponents, less what they share, are those of the attitude's complementary sums, $A = n (x - 2 s i \phi + n l)$, in the square of the nome, and of the spin's, $B = 2 n (x + n l)$. That such sums are Fourier series, settled by their factors, is no part of it.";
            but "the quasi-period the other way": imaginary(-1),
        [Lemma] "half-periods": half_periods([THETA_4, THETA_1], [THETA_2, THETA_1]),
            r"By the terms of the sums: where the argument moves by half a turn, the fourth theta function is multiplied by $h_1 = 1$ and the first by $h_2 = -1$; where it moves by a quasi-period, the second by $q_1 = 1$ and the first by $q_2 = -1$, but for one factor of both; by half of that, the first becomes the fourth and the second the third, but for such a factor: their products $X = P_{41}$ with the first and $Y = P_{32}$ with the second.";
            but "the second without alternating signs": half_periods([THETA_4, THETA_2], [THETA_2, THETA_2]),
    }
}

const ALL: [Theta; 4] = [THETA_1, THETA_2, THETA_3, THETA_4];

/// The logarithms of what bounds the terms of the sums; `power` is two.
fn converge(power: u32) -> Scope {
    let ([b, r, s], one) = (variables(["b", "r", "s"]), Fraction::one());
    let n = (&b + &one) / &r + &s;
    let bound = |n: &Fraction| Fraction::from(2) * &b * n - &r * n.pow(power);
    let scope = Scope::default().with_all([("E", bound(&n)), ("F", bound(&(&n + &one))), ("n", n)]);
    let scope = scope.with_all([("m", one + &s), ("b", b), ("r", r), ("s", s)]);
    scope.positive(["b", "r", "s"])
}

/// Products of each two of four theta functions.
fn products(thetas: [Theta; 4]) -> Scope {
    let mut scope = Scope::default();
    for (f, j) in thetas.into_iter().zip(1..) {
        for (g, k) in thetas.into_iter().zip(1..) {
            let all = [
                ("P", Pairs::product(f, g)),
                ("Q", Pairs::of_the_root(f, g)),
                ("S", Pairs::of_the_square(f, g)),
            ];
            scope = all.into_iter().fold(scope, |scope, (name, pairs)| {
                scope.with(&format!("{name}_{{{j}{k}}}"), pairs.in_symbols())
            });
        }
    }
    scope
}

fn jacobi(sign: i64, above: Theta) -> Result<Vec<Scope>, Residue> {
    Pairs::differ_by_a_constant("sn'", [above, THETA_4], [THETA_2, THETA_3])?;
    // With A and B the third and second at w, U and V at z, of the squared nome and twice the argument.
    let [a, b, u, v] = variables(["A", "B", "U", "V"]);
    let squares = |u: &Fraction, v: &Fraction| {
        [&b * u - &a * v, &a * v + &b * u, &a * u + &b * v, &a * u - &b * v * Fraction::from(sign)]
    };
    let ([t1, t2, t3, t4], [_, z2, z3, z4]) = (squares(&u, &v), squares(&a, &b));
    let (sn, cn, dn) = (&z3 / &z2 * &t1 / &t4, &z4 / &z2 * &t2 / &t4, &z4 / &z3 * &t3 / &t4);
    let squares = [("sn", sn), ("cn", cn), ("dn", dn)].into_iter();
    let scope = squares.fold(Scope::default(), |scope, (name, square)| {
        scope.with(&format!(r"\operatorname{{{name}}}"), Value::Root(square))
    });
    Ok([vec![products(ALL), scope.with("k", Value::Root(z2.pow(2) / z3.pow(2)))], spin_sums().into()]
        .concat())
}

/// The library's sums for the spin with the factors that they leave out, of which all terms of a sum share
/// one, and the first terms of the theta functions; `y` is the exponential of `2 i z`.
fn spin_sums() -> [Scope; 2] {
    let ([q, y], one) = (variables(["q", "y"]), Fraction::one());
    let (back, two) = (&one / &y, Fraction::from(2));
    let [third, fourth, second, first] = DirectSeries::new(q.clone()).thetas((&y + &back) / two);
    let direct = [first * (&one - &back), second * (&one + &back), third, fourth];
    let series = ComplementarySeries::new(q.clone(), one.clone(), one.clone());
    let [first, second, fourth, third] = series.sums(back.clone(), one - back, &q * &y);
    [(direct, 7), ([first, second, third, fourth], 6)].map(|(sums, most)| {
        let terms = ALL.map(|theta| theta.terms(-most..=most, &q, &y));
        Scope::default().with_each("A", &sums).with_each("B", &terms)
    })
}

/// The library's sums for the attitude, likewise, where the order of the axes has this sign.
fn direct_pair(sense: i64) -> Scope {
    let ([q, f, y], one) = (variables(["q", "f", "y"]), Fraction::one());
    let half = |x: Fraction| x / Fraction::from(2);
    let pair = DirectPair::new(q.clone(), [f.clone(), &f - &one], &q / &f, Fraction::from(sense));
    // What has a sine in it is taken times i.
    let doubled = [half(&y + &one / &y), half(&y - &one / &y)];
    let [re, im, sine, cosine] = pair.sums(doubled, [half(&one - &one / &y), half(&one + &one / &y)]);
    let (wave, factor) = if sense > 0 { (y / f, one) } else { (y * &f, f) };
    let [fourth, first] = [THETA_4, THETA_1].map(|theta| theta.terms(-6..=6, &q.pow(2), &wave));
    Scope::default().with_all([("A", re + im), ("B", fourth), ("C", sine - cosine), ("D", first * factor)])
}

/// The same of the complementary sums; `w` is the exponential of minus the zero's angle times i.
fn complementary_pair(sense: i64) -> Scope {
    let [p, e, w] = variables(["p", "e", "w"]);
    let back = Fraction::one() / &w;
    let wave = |n, sign: i64| (back.pow(n) + w.pow(n) * Fraction::from(sign)) / Fraction::from(2);
    let waves = [1, -1].map(|sign| [1, 3, 5, 7, 9].map(|n| wave(n, sign)));
    let pair = ComplementaryPair::new(p.clone(), waves, Fraction::from(sense));
    let [a_1, a_2, b_1, b_2] = pair.sums(e.clone(), p.pow(2) / &e);
    let lead = if sense > 0 { w } else { back };
    let [second, first] =
        [THETA_2, THETA_1].map(|theta| theta.terms(-8..=9, &p, &(lead.pow(2) / &e)) * &lead);
    Scope::default().with_all([("A", a_1 + a_2), ("B", second), ("C", b_1 + b_2), ("D", first)])
}

/// The products, and the values at zero that they tie to those in the square of the nome; of the first the
/// slope, or as a mutant the value.
fn nome(thetas: [Theta; 4], slope: bool) -> Result<Vec<Scope>, Residue> {
    let letters = ["t_2", "t_3", "t_4", "T_2", "T_3", "T_4", "D"];
    let [t2, t3, t4, v2, v3, v4, d] = variables(letters);
    let [product, sum, less] = [&v2 * &v3 * Fraction::from(2), v3.pow(2) + v2.pow(2), v3.pow(2) - v2.pow(2)];
    let squares = [("T_4", &t3 * &t4), ("t_2", product), ("t_3", sum), ("t_4", less)];
    let ties = Relations::new(squares.map(|(name, x)| (name, x.numerator().clone())).into())?;
    let moduli = [("k", &t2 / &t3), ("k'", t4 / t3), ("l", v2 / v3)].map(|(name, x)| (name, x.pow(2)));
    let [second, third, fourth] = [THETA_2, THETA_3, THETA_4].map(|f| f.first(false));
    let begin =
        [("b", fourth.pow(2)), ("a", third.pow(2)), ("c", THETA_1.first(slope) / second / third / fourth)];
    let values = Scope::default().with_letters(letters).with_all(moduli).with_all(begin);
    Ok(vec![products(thetas), values.with("d", d * v4 / t2 * Fraction::from(2)).under(ties)])
}

/// The exponents of the terms of both sides, and where the argument moves; `up` is one.
fn imaginary(up: i64) -> Result<Scope, Residue> {
    let letters = [r"\pi", "i", "t", "v", "n", "u", "y", "s", "K", "K'"];
    let ([pi, i, t, v, n, u, y, s, k, l], [none, one, two]) =
        (variables(letters), [0, 1, 2].map(Fraction::from));
    let heat = |[v, t, n]: [&Fraction; 3]| -(&pi * (v - n).pow(2) / t);
    let wave = |[v, t, n]: [&Fraction; 3]| &pi * n * (&two * &i * v - n * t);
    let mut scope = Scope::default().with_letters(letters);
    for (name, x) in [("E", heat([&v, &t, &n])), ("F", wave([&v, &t, &n]))] {
        let [by_t, slope] = ["t", "v"].map(|name| x.derivative(&name.into()));
        scope = scope.with(&format!("{name}''"), slope.derivative(&"v".into())).with(name, x);
        scope = scope.with(&format!("{name}'"), slope).with(&format!(r"\dot{{{name}}}"), by_t);
    }
    let half = &one / &two;
    let (more, right, up) = (&n + &half, &v + &half, &v + &i * &t * &half * Fraction::from(up));
    scope = scope.with_each("E", &[heat([&right, &t, &more]), heat([&up, &t, &n]), heat([&none, &one, &n])]);
    scope = scope.with_each("F", &[wave([&right, &t, &n]), wave([&up, &t, &n]), wave([&none, &one, &n])]);
    let less = |v: &Fraction, t: &Fraction| heat([v, t, &n]) - heat([v, t, &none]);
    let attitude = less(&((&u - s * &i * &y) / (&two * &k)), &(&two * &l / &k));
    let spin = less(&(&u / (&two * &k)), &(&l / &k));
    let of_half = |x: &Fraction| &pi * x / (&two * &l);
    scope = scope.with_all([("x", of_half(&u)), (r"\phi", of_half(&y) / &two), ("l", -of_half(&k))]);
    scope = scope.with_all([("G", wave([&v, &t, &more])), ("A", attitude), ("B", spin)]);
    Ok(scope.under(Relations::new(vec![("i", Polynomial::from(-1))])?))
}

fn half_periods(direct: [Theta; 2], complementary: [Theta; 2]) -> Scope {
    let moved = |f: Theta| Pairs::product(f.after_half_a_quasi_period(), f).in_symbols();
    products(ALL)
        .with_all([("X", moved(THETA_1)), ("Y", moved(THETA_2))])
        .with_each("h", &direct.map(|f| Fraction::from(f.over_a_period())))
        .with_each("q", &complementary.map(|f| Fraction::from(f.over_a_quasi_period())))
}
