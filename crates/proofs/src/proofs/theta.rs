//! Theta functions: identities of their quotients and products, each decided in all terms of its infinite
//! sums, for every nome. Which nome belongs to which modulus and period is not decided here.

use crate::lattice::{Pairs, THETA_1, THETA_2, THETA_3, THETA_4, Theta};
use crate::number::Fraction;
use crate::proof::Residue;
use crate::symbols::variables;
use crate::tex::{Scope, Value};

proofs! {
    "exact" {
        "theta-exponents": exponents(2),
            r"In a product of two theta functions the term of $m = \frac{r + s}{2}$ and $n = \frac{r - s}{2}$ has the nome to the power $m^2 + n^2 = \tfrac{1}{2}(r^2 + s^2)$.";
            but "a third for the half": exponents(3),
        "jacobi-by-thetas": jacobi(1, THETA_1),
            r"With Jacobi's three functions as quotients of theta functions, $\operatorname{sn}^2 + \operatorname{cn}^2 = 1$ and $\operatorname{dn}^2 + k^2\operatorname{sn}^2 = 1$, and the rate of the first is a constant times the two others, for every nome. The constant, the period and which nome belongs to $k$ are no part of it.";
            but "a sign in a square": jacobi(-1, THETA_1),
            but "another theta function above": jacobi(1, THETA_2),
        "attitude-by-thetas": products([THETA_1, THETA_2, THETA_3, THETA_4]),
            r"For every nome and any two arguments $2 P_{44} = Q_{43} + Q_{34}$, $2 P_{11} = Q_{43} - Q_{34}$ and $2 P_{41} = Q_{12} - Q_{21}$: products of the theta functions of these numbers, on the left of the sum and of the difference of the arguments in the square of the nome, on the right of each argument. For a real first and an imaginary second argument the left sides are twice the squares of the lengths of the attitude's two numbers, and the conjugate of the first times the second; these are theta functions of the difference.";
            but "the third for the fourth": products([THETA_1, THETA_2, THETA_3, THETA_3]),
        "attitude-by-complementary-thetas": products([THETA_1, THETA_2, THETA_3, THETA_4]),
            r"For every nome and any two arguments $P_{22} = S_{23} + S_{32}$, $P_{11} = S_{32} - S_{23}$ and $P_{21} = S_{14} - S_{41}$: products of the theta functions of these numbers, on the left of the sum and of the difference of the arguments, on the right of twice each argument in the square of the nome.";
            but "the theta of the direct series": products([THETA_1, THETA_4, THETA_3, THETA_4]),
        "half-periods": half_periods([THETA_4, THETA_1], [THETA_2, THETA_1]),
            r"By the terms of the sums: where the argument moves by half a turn, the fourth theta function is multiplied by $h_1 = 1$ and the first by $h_2 = -1$; where it moves by a quasi-period, the second by $q_1 = 1$ and the first by $q_2 = -1$, but for one factor of both; by half of that, the first becomes the fourth and the second the third, but for such a factor.";
            but "the second without alternating signs": half_periods([THETA_4, THETA_2], [THETA_2, THETA_2]),
    }
}

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

fn jacobi(sign: i64, above: Theta) -> Result<Scope, Residue> {
    let product = |f, g| Pairs::product(f, g);
    let square = Pairs::of_the_square;
    // With A and B the third and second at w, U and V at z, of the squared nome and twice the argument.
    let (ua, vb) = (square(THETA_3, THETA_3), square(THETA_2, THETA_2));
    let (va, ub) = (square(THETA_2, THETA_3), square(THETA_3, THETA_2));
    Pairs::same("theta3²", &product(THETA_3, THETA_3), &ua.plus(1, &vb))?;
    Pairs::same("theta4²", &product(THETA_4, THETA_4), &ua.plus(-1, &vb))?;
    Pairs::same("theta2²", &product(THETA_2, THETA_2), &va.plus(1, &ub))?;
    Pairs::same("theta1²", &product(THETA_1, THETA_1), &ub.plus(-1, &va))?;
    Pairs::differ_by_a_constant("sn'", &product(above, THETA_4), &product(THETA_2, THETA_3))?;
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
    Ok(scope.with("k", Value::Root(z2.pow(2) / z3.pow(2))))
}

fn half_periods(direct: [Theta; 2], complementary: [Theta; 2]) -> Result<Scope, Residue> {
    let exchanged = |claim: &str, f: Theta, g: Theta| {
        Pairs::same(claim, &Pairs::product(f.after_half_a_quasi_period(), f), &Pairs::product(g, f))
    };
    exchanged("theta1 and theta4", THETA_1, THETA_4)?;
    exchanged("theta2 and theta3", THETA_2, THETA_3)?;
    let scope = Scope::default().with_each("h", &direct.map(|f| Fraction::from(f.over_a_period())));
    Ok(scope.with_each("q", &complementary.map(|f| Fraction::from(f.over_a_quasi_period()))))
}
