//! Theta functions: identities of their quotients and products, each decided in all terms of its infinite
//! sums, for every nome. Which nome belongs to which modulus and period is not decided here.

use crate::lattice::{Pairs, THETA_1, THETA_2, THETA_3, THETA_4, Theta, exponents};
use crate::number::Fraction;
use crate::proof::{Outcome, same};
use crate::symbols::variables;

proofs! {
    "exact" {
        "theta-exponents": exponents(2),
            "In a product of two theta functions the term of m = (r + s)/2 and n = (r - s)/2 has the nome to m² + n² = (r² + s²)/2; and (n + 1/2)² and (n + 1)² are what half a quasi-period and a whole \
            one make of n².";
            but "a third for the half": exponents(3),
        "jacobi-by-thetas": jacobi(1, THETA_1),
            "With sn, cn and dn as quotients of theta functions, sn² + cn² = 1 and dn² + k² sn² = 1, and sn' is a constant times cn dn, for every nome. The constant, the period and which nome belongs to \
            k are no part of it.";
            but "a sign in a square": jacobi(-1, THETA_1),
            but "another theta function above": jacobi(1, THETA_2),
        "attitude-by-thetas": direct_pair(1),
            "For every nome, every z and every w: 2 theta4(z + w) theta4(z - w) = theta4(z) theta3(w) + theta3(z) theta4(w), 2 theta1(z + w) theta1(z - w) is their difference, and 2 theta4(z + w) \
            theta1(z - w) = theta1(z) theta2(w) - theta2(z) theta1(w), with the square of the nome on the left. For a real z and an imaginary w the left sides are twice a conj(a), b conj(b) and conj(a) \
            b, of a = theta4(z - w) and b = theta1(z - w).";
            but "a plus between the two products": direct_pair(-1),
        "attitude-by-complementary-thetas": complementary_pair(THETA_2),
            "For every nome, every z and every w: theta2(z + w) theta2(z - w) = theta2(2z) theta3(2w) + theta3(2z) theta2(2w), theta1(z + w) theta1(z - w) = theta3(2z) theta2(2w) - theta2(2z) theta3(2w), \
            and theta2(z + w) theta1(z - w) = theta1(2z) theta4(2w) - theta4(2z) theta1(2w), with the square of the nome on the right.";
            but "the theta of the direct series": complementary_pair(THETA_4),
        "half-periods": half_periods([THETA_4, THETA_1], [THETA_2, THETA_1]),
            "By the signs of the terms: where z moves by pi, theta4 stays and theta1 changes its sign; where it moves by a quasi-period, theta2 stays and theta1 changes its sign, but for the factor \
            exp(-2 i z)/q of both; by half of that, theta1 becomes theta4 and theta2 theta3, but for such a factor.";
            but "b without alternating signs": half_periods([THETA_4, THETA_2], [THETA_2, THETA_2]),
    }
}

fn jacobi(sign: i64, above: Theta) -> Outcome {
    let product = |f, g| Pairs::product(f, g);
    let square = Pairs::of_the_square;
    // With A and B the third and second at w, U and V at z, of the squared nome and twice the argument.
    let (ua, vb) = (square(THETA_3, THETA_3), square(THETA_2, THETA_2));
    let (va, ub) = (square(THETA_2, THETA_3), square(THETA_3, THETA_2));
    Pairs::same("theta3²", &product(THETA_3, THETA_3), &ua.plus(1, &vb))?;
    Pairs::same("theta4²", &product(THETA_4, THETA_4), &ua.plus(-1, &vb))?;
    Pairs::same("theta2²", &product(THETA_2, THETA_2), &va.plus(1, &ub))?;
    Pairs::same("theta1²", &product(THETA_1, THETA_1), &ub.plus(-1, &va))?;
    let [a, b, u, v] = variables(["A", "B", "U", "V"]);
    let squares = |u: &Fraction, v: &Fraction| {
        [&b * u - &a * v, &a * v + &b * u, &a * u + &b * v, &a * u - &b * v * Fraction::from(sign)]
    };
    let ([t1, t2, t3, t4], [_, z2, z3, z4]) = (squares(&u, &v), squares(&a, &b));
    let one = Fraction::from(1);
    let (sn, cn, dn) = (&z3 / &z2 * &t1 / &t4, &z4 / &z2 * &t2 / &t4, &z4 / &z3 * &t3 / &t4);
    same("sn² + cn²", &(&sn + &cn), &one)?;
    let parameter = z2.pow(2) / z3.pow(2);
    same("dn² + k² sn²", &(dn + parameter * sn), &one)?;
    Pairs::differ_by_a_constant("sn'", &product(above, THETA_4), &product(THETA_2, THETA_3))
}

fn direct_pair(sign: i64) -> Outcome {
    let root = Pairs::of_the_root;
    let twice = |f, g| {
        let product = Pairs::product(f, g);
        product.plus(1, &product)
    };
    let (third, fourth) = (root(THETA_3, THETA_4), root(THETA_4, THETA_3));
    Pairs::same("a conj(a)", &twice(THETA_4, THETA_4), &fourth.plus(1, &third))?;
    Pairs::same("b conj(b)", &twice(THETA_1, THETA_1), &fourth.plus(-sign, &third))?;
    let (first, second) = (root(THETA_1, THETA_2), root(THETA_2, THETA_1));
    Pairs::same("conj(a) b", &twice(THETA_4, THETA_1), &first.plus(-1, &second))
}

fn complementary_pair(a: Theta) -> Outcome {
    let square = Pairs::of_the_square;
    let (ub, va) = (square(THETA_3, THETA_2), square(THETA_2, THETA_3));
    Pairs::same("a conj(a)", &Pairs::product(a, a), &va.plus(1, &ub))?;
    Pairs::same("b conj(b)", &Pairs::product(THETA_1, THETA_1), &ub.plus(-1, &va))?;
    let (first, fourth) = (square(THETA_1, THETA_4), square(THETA_4, THETA_1));
    Pairs::same("conj(a) b", &Pairs::product(a, THETA_1), &first.plus(-1, &fourth))
}

fn half_periods(direct: [Theta; 2], complementary: [Theta; 2]) -> Outcome {
    let signs = |claim: &str, [a, b]: [i64; 2]| {
        same(&format!("{claim}, a"), &Fraction::from(a), &Fraction::from(1))?;
        same(&format!("{claim}, b"), &Fraction::from(b), &Fraction::from(-1))
    };
    signs("half a period", direct.map(Theta::over_a_period))?;
    signs("the same, complementary", complementary.map(Theta::over_a_quasi_period))?;
    let exchanged = |claim: &str, f: Theta, g: Theta| {
        Pairs::same(claim, &Pairs::product(f.after_half_a_quasi_period(), f), &Pairs::product(g, f))
    };
    exchanged("theta1 and theta4", THETA_1, THETA_4)?;
    exchanged("theta2 and theta3", THETA_2, THETA_3)
}
