//! Theta functions: identities of their quotients and products, each decided in all terms of its infinite
//! sums, for every nome. That a nome belongs to its modulus follows by a limit, which is no part of this.

use crate::lattice::{Pairs, THETA_1, THETA_2, THETA_3, THETA_4, Theta};
use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::proof::Residue;
use crate::symbols::{square, variables};
use crate::tex::{Scope, Value};

proofs! {
    "exact" {
        "theta-exponents": exponents(2),
            r"In a product of two theta functions the term of $m = \frac{r + s}{2}$ and $n = \frac{r - s}{2}$ has the nome to the power $m^2 + n^2 = \tfrac{1}{2}(r^2 + s^2)$.";
            but "a third for the half": exponents(3),
        "jacobi-by-thetas": jacobi(1, THETA_1),
            r"By $P_{33} = S_{33} + S_{22}$, $P_{44} = S_{33} - S_{22}$, $P_{22} = S_{23} + S_{32}$ and $P_{11} = S_{32} - S_{23}$, products of the theta functions of these numbers, on the left of the sum and of the difference of any two arguments, on the right of twice each argument in the square of the nome, Jacobi's three functions as quotients of theta functions have $\operatorname{sn}^2 + \operatorname{cn}^2 = 1$ and $\operatorname{dn}^2 + k^2\operatorname{sn}^2 = 1$, and the rate of the first is a constant times the two others, for every nome. The constant and which nome belongs to $k$ are no part of it.";
            but "a sign in a square": jacobi(-1, THETA_1),
            but "another theta function above": jacobi(1, THETA_2),
        "attitude-by-thetas": products(ALL),
            r"For every nome and any two arguments $2 P_{44} = Q_{43} + Q_{34}$, $2 P_{11} = Q_{43} - Q_{34}$ and $2 P_{41} = Q_{12} - Q_{21}$: products of the theta functions of these numbers, on the left of the sum and of the difference of the arguments in the square of the nome, on the right of each argument. For a real first and an imaginary second argument the left sides are twice the squares of the lengths of the attitude's two numbers, and the conjugate of the first times the second; these are theta functions of the difference.";
            but "the third for the fourth": products([THETA_1, THETA_2, THETA_3, THETA_3]),
        "attitude-by-complementary-thetas": products(ALL),
            r"For every nome and any two arguments $P_{22} = S_{23} + S_{32}$, $P_{11} = S_{32} - S_{23}$ and $P_{21} = S_{14} - S_{41}$: products of the theta functions of these numbers, on the left of the sum and of the difference of the arguments, on the right of twice each argument in the square of the nome.";
            but "the theta of the direct series": products([THETA_1, THETA_4, THETA_3, THETA_4]),
        "nome-and-scale": nome(ALL),
            r"For every nome $P_{33} = S_{33} + S_{22}$, $P_{44} = S_{33} - S_{22}$, $P_{22} = S_{23} + S_{32}$, $P_{34} = S_{44} - S_{11}$ and $P_{21} = S_{14} - S_{41}$: products as in the proof attitude-by-complementary-thetas. Where the arguments are zero, these tie the values $t_2$, $t_3$ and $t_4$ of the theta functions to $T_2$, $T_3$ and $T_4$ in the square of the nome, $t_3^2 = T_3^2 + T_2^2$, $t_4^2 = T_3^2 - T_2^2$, $t_2^2 = 2 T_2 T_3$ and $t_3 t_4 = T_4^2$, and the slope $d$ of the first to $D$, $d t_2 = 2 D T_4$. So $\frac{d}{t_2 t_3 t_4} = \frac{D}{T_2 T_3 T_4}$, and Gauss's step takes one pair of squares to the other: $\tfrac{1}{2} (t_3^2 + t_4^2) = T_3^2$ and $t_3^2 t_4^2 = T_4^4$. The modulus $k = t_2^2/t_3^2$ with the complement $k' = t_4^2/t_3^2$ becomes $l = T_2^2/T_3^2$ with $l (1 + k') = 1 - k'$ and $(1 + l)^2 k^2 = 4 l$. The limit of small nomes is no part of it.";
            but "the third for the fourth": nome([THETA_1, THETA_2, THETA_3, THETA_3]),
        "imaginary-transformation": imaginary(1),
            r"With $S' = C D$, $C' = S D$ and $D' = k'^2 S C$, the rates of Jacobi's functions of an imaginary argument and the complement, where $C^2 = 1 + S^2$ and $D^2 = 1 + k'^2 S^2$, the quotients $\operatorname{sn} = S/C$, $\operatorname{cn} = 1/C$ and $\operatorname{dn} = D/C$ obey Jacobi's laws: $\operatorname{sn}' = \operatorname{cn}\operatorname{dn}$, $\operatorname{cn}' = -\operatorname{sn}\operatorname{dn}$, $\operatorname{sn}^2 + \operatorname{cn}^2 = 1$ and $\operatorname{dn}^2 + (1 - k'^2)\operatorname{sn}^2 = 1$.";
            but "the rate of a real argument": imaginary(-1),
        "half-periods": half_periods([THETA_4, THETA_1], [THETA_2, THETA_1]),
            r"By the terms of the sums: where the argument moves by half a turn, the fourth theta function is multiplied by $h_1 = 1$ and the first by $h_2 = -1$; where it moves by a quasi-period, the second by $q_1 = 1$ and the first by $q_2 = -1$, but for one factor of both; by half of that, the first becomes the fourth and the second the third, but for such a factor: their products $X = P_{41}$ with the first and $Y = P_{32}$ with the second.";
            but "the second without alternating signs": half_periods([THETA_4, THETA_2], [THETA_2, THETA_2]),
    }
}

const ALL: [Theta; 4] = [THETA_1, THETA_2, THETA_3, THETA_4];

/// The exponents of the sums; `over` is two.
fn exponents(over: i64) -> Scope {
    let [r, s] = variables(["r", "s"]);
    let [m, n] = [&r + &s, &r - &s].map(|x| x / Fraction::from(over));
    Scope::default().with_all([("r", r), ("s", s), ("m", m), ("n", n)])
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
    Ok(vec![products(ALL), scope.with("k", Value::Root(z2.pow(2) / z3.pow(2)))])
}

/// The products, and the values at zero that they tie to those in the square of the nome.
fn nome(thetas: [Theta; 4]) -> Result<Vec<Scope>, Residue> {
    let letters = ["t_2", "t_3", "t_4", "T_2", "T_3", "T_4", "D"];
    let [t2, t3, t4, v2, v3, v4, slope] = variables(letters);
    let [product, sum, less] = [&v2 * &v3 * Fraction::from(2), v3.pow(2) + v2.pow(2), v3.pow(2) - v2.pow(2)];
    let squares = [("T_4", &t3 * &t4), ("t_2", product), ("t_3", sum), ("t_4", less)];
    let ties = Relations::new(squares.map(|(name, x)| (name, x.numerator().clone())).into())?;
    let moduli = [("k", &t2 / &t3), ("k'", t4 / t3), ("l", v2 / v3)].map(|(name, x)| (name, x.pow(2)));
    let values = Scope::default().with_letters(letters).with_all(moduli);
    Ok(vec![products(thetas), values.with("d", slope * v4 / t2 * Fraction::from(2)).under(ties)])
}

fn imaginary(sign: i64) -> Result<Scope, Residue> {
    let ([s, c, d, k], one) = (variables(["S", "C", "D", "k'"]), Polynomial::from(1));
    let rates = [("S", &c * &d), ("C", &s * &d * Fraction::from(sign)), ("D", k.pow(2) * &s * &c)];
    let by = Derivation::new(rates);
    let quotients = [("sn", &s / &c), ("cn", Fraction::from(1) / &c), ("dn", &d / &c)];
    let quotients = quotients.map(|(name, x)| (format!(r"\operatorname{{{name}}}"), x));
    let all =
        quotients.into_iter().chain([("S", s), ("C", c), ("D", d)].map(|(name, x)| (name.to_owned(), x)));
    let scope = all
        .fold(Scope::default(), |scope, (name, x)| scope.with(&format!("{name}'"), by.of(&x)).with(&name, x));
    let laws = vec![("C", &one + square("S")), ("D", &one + square("k'") * square("S"))];
    Ok(scope.with("k'", k).under(Relations::new(laws)?))
}

fn half_periods(direct: [Theta; 2], complementary: [Theta; 2]) -> Scope {
    let moved = |f: Theta| Pairs::product(f.after_half_a_quasi_period(), f).in_symbols();
    products(ALL)
        .with_all([("X", moved(THETA_1)), ("Y", moved(THETA_2))])
        .with_each("h", &direct.map(|f| Fraction::from(f.over_a_period())))
        .with_each("q", &complementary.map(|f| Fraction::from(f.over_a_quasi_period())))
}
