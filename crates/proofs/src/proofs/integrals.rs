//! The integrals of the closed form: Gauss's mean, Carlson's integrals by duplication and by their series,
//! and Legendre's integrals as Carlson writes them.
//!
//! Two integrals are equal if a change of variable takes one integrand and its range to the other; each claim
//! is about integrands, and no check is about the ranges. The roots in them are symbols, tied by their
//! squares or by their derivatives.

use crate::number::{Derivation, Fraction, Polynomial, Relations};
use crate::proof::{Outcome, positive, same, same_under, vanishes};
use crate::proofs::klein::{Change, Motion, motion};
use crate::symbols::{square, variables};
use num_traits::One;

proofs! {
    "exact" {
        "gauss-mean": gauss(-1, 2),
            "By u = (t - a b/t)/2, which rises with t, the integrand 1/sqrt((t² + a²)(t² + b²)) becomes that of the arithmetic and the geometric mean; for a = b = m it is 1/m by the angle of t = m tan; \
            by t = k' tan that of 1 and k' becomes Legendre's. For all a and b; the limits of the integrals are no part of it.";
            but "a plus in the change of variable": gauss(1, 2),
        "last-mean": last_mean(16),
            "Of two numbers with mean m, difference d and geometric mean g, the next mean is m - d²/(16 m), but for (m - g)²/(4 m), g being the root of m² - d²/4.";
            but "twice as much taken off": last_mean(8),
        "carlson-duplication": duplication(1, 3),
            "With s = t + XY + YZ + ZX, where X² = t + x and so on, ds/sqrt((s+x)(s+y)(s+z)) is half of dt/(XYZ), and the integrands of R_D before and after differ by the derivative of 3/(Z (Y+Z) (Z+X)). \
            Scaling and limits of the integrals are no part of it.";
            but "a product of roots the other way": duplication(-1, 3),
            but "another term taken off": duplication(1, 2),
        "carlson-series": carlson_series(24, 26),
            "The sums for R_F and R_D near three equal numbers, as the book prints them, are through the seventh order the binomial series of the integrands, integrated term by term.";
            but "a coefficient of R_F": carlson_series(22, 26),
            but "a coefficient of R_D": carlson_series(24, 28),
        "legendre-by-carlson": legendre(1, 6),
            "By t = s²/sin² - 1 Legendre's integrand becomes that of s R_F(1 - s², 1 - m s², 1), and its derivative by m that of s³ R_D(1 - s², 1, 1 - m s²)/6; cn/dn, k' sn/dn and k'/dn are the functions \
            of what is left to the quarter period; and the squares of the theta zero's functions are tied by the complementary modulus. The limits are no part of it.";
            but "the parameter's sign": legendre(-1, 6),
    }
}

fn gauss(sign: i64, halves: i64) -> Outcome {
    let [a, b, t, m] = variables(["a", "b", "t", "m"]);
    let under = |t: &Fraction, a2: &Fraction, b2: &Fraction| (t.pow(2) + a2) * (t.pow(2) + b2);
    let u = (&t + &a * &b / &t * Fraction::from(sign)) / Fraction::from(2);
    let rate = u.derivative(&"t".into());
    let mean = (&a + &b) / Fraction::from(halves);
    let after = under(&u, &mean.pow(2), &(&a * &b)) * Fraction::from(4);
    same("the integrand", &(rate.pow(2) * under(&t, &a.pow(2), &b.pow(2))), &after)?;
    positive("u rises from below all numbers to above all", &rate)?;
    // By an angle: t = b tan.
    let [sin, cos, kp] = variables(["sin", "cos", "kp"]);
    let by_angle = Derivation::new([("sin", cos.clone()), ("cos", -sin.clone())]);
    let circle = Relations::circle("cos", "sin");
    let tangent = by_angle.of(&(&m * &sin / &cos));
    same_under(&circle, "of two equal numbers", &tangent, &((&m * &sin / &cos).pow(2) / &m + &m))?;
    let t = &kp * &sin / &cos;
    let one = Fraction::one();
    let root_squared = &one - (&one - kp.pow(2)) * sin.pow(2);
    let left = by_angle.of(&t).pow(2) * root_squared;
    same_under(&circle, "the quarter period", &left, &under(&t, &one, &kp.pow(2)))
}

fn last_mean(over: i64) -> Outcome {
    // g is the geometric mean of the two: the root of m² - d²/4.
    let [m, g, d] = variables(["m", "g", "d"]);
    let four = Polynomial::from(4);
    let relations = Relations::new(vec![("d", (square("m") - square("g")) * four)])?;
    let taken = &m - d.pow(2) / (&m * Fraction::from(over));
    let next = (&m + &g) / Fraction::from(2);
    same_under(&relations, "the next mean", &(taken - next), &((&m - &g).pow(2) / (&m * Fraction::from(4))))
}

fn duplication(sign: i64, thrice: i64) -> Outcome {
    let [x, y, z, t] = variables(["X", "Y", "Z", "t"]);
    let two = Fraction::from(2);
    let by_t = ["Y", "Z"].iter().fold(
        Derivation::new([("t", Fraction::one()), ("X", Fraction::one() / (&two * &x))]),
        |all, name| all.and(name, Fraction::one() / (&two * Fraction::variable(name))),
    );
    let s = &t + &x * &y + &y * &z + &z * &x * Fraction::from(sign);
    let sums = [&x + &y, &y + &z, &z + &x];
    // x = X² - t, and so on.
    same("s + x", &(&s + x.pow(2) - &t), &(&sums[0] * &sums[2]))?;
    same("s + y", &(&s + y.pow(2) - &t), &(&sums[0] * &sums[1]))?;
    same("s + z", &(&s + z.pow(2) - &t), &(&sums[1] * &sums[2]))?;
    let (product, roots) = (&sums[0] * &sums[1] * &sums[2], &x * &y * &z);
    same("the integrand of R_F", &(by_t.of(&s) / &product), &(Fraction::one() / (&two * &roots)))?;
    // Twice R_D after the duplication, and what goes before it: nothing where t is infinite.
    let taken = Fraction::from(thrice) / (&z * &sums[1] * &sums[2]);
    let before = Fraction::from(3) / (&two * z.pow(2) * &roots);
    let after = Fraction::from(3) * by_t.of(&s) / (&sums[1] * &sums[2] * &product);
    same("the integrand of R_D", &(before - after), &-by_t.of(&taken))
}

/// A coefficient, and the powers of the sums of products of two to five of the five relative distances.
type Term = (i64, i64, [u32; 4]);

/// Claims that the terms with `E_n h^n` for `E_n`, each over the integral of its power of `t`, are the
/// inverse root of the product of all `1 - h X`, `last` at most, through the seventh power. `weigh` is one
/// over that integral.
fn is_inverse_root(claim: &str, last: u32, terms: &[Term], weigh: impl Fn(u32) -> Fraction) -> Outcome {
    const ORDER: usize = 7;
    let e = variables(["E2", "E3", "E4", "E5"]);
    let h = Fraction::variable("h");
    let sized = |(n, e): (u32, &Fraction)| if n > last { Fraction::from(0) } else { e * h.pow(n) };
    let sized: Vec<Fraction> = (2..).zip(&e).map(sized).collect();
    let root = terms.iter().fold(Fraction::one(), |sum, (n, d, powers)| {
        let weight = (2..).zip(powers).map(|(n, power)| n * power).sum();
        let product = sized.iter().zip(powers).fold(Fraction::one(), |all, (e, &n)| all * e.pow(n));
        sum + product * weigh(weight) * Fraction::ratio(*n, *d)
    });
    let [e2, e3, e4, e5] = [0, 1, 2, 3].map(|n| &sized[n]);
    let all = root.pow(2) * (Fraction::one() + e2 - e3 + e4 - e5);
    let powers = all.numerator().in_powers_of(&"h".into());
    let below = Fraction::from(all.denominator().clone());
    for (n, part) in powers.into_iter().enumerate().take(ORDER + 1) {
        let part = Fraction::from(part) / &below;
        same(&format!("{claim}, power {n}"), &part, &Fraction::from(i64::from(n == 0)))?;
    }
    Ok(())
}

/// The product of all `t - X` for these distances.
fn roots(all: &[&Fraction]) -> Fraction {
    all.iter().fold(Fraction::one(), |product, x| product * (Fraction::variable("t") - *x))
}

fn carlson_series(square_of_first: i64, fifth_of_second: i64) -> Outcome {
    let [a, b, t] = variables(["a", "b", "t"]);
    let whole = Fraction::from;
    // Of R_F: three distances from the mean, which sum to zero.
    let c = -(&a + &b);
    let (e2, e3) = (&a * &b - c.pow(2), &a * &b * &c);
    same("three distances", &roots(&[&a, &b, &c]), &(t.pow(3) + &e2 * &t - e3))?;
    let first: [Term; 7] = [
        (-1, 10, [1, 0, 0, 0]),
        (1, 14, [0, 1, 0, 0]),
        (1, square_of_first, [2, 0, 0, 0]),
        (-3, 44, [1, 1, 0, 0]),
        (-5, 208, [3, 0, 0, 0]),
        (3, 104, [0, 2, 0, 0]),
        (1, 16, [2, 1, 0, 0]),
    ];
    // Half the integral of t^(-3/2 - n) from 1 on is 1/(2n + 1).
    is_inverse_root("R_F", 3, &first, |n| whole(i64::from(2 * n + 1)))?;
    // Of R_D: the third distance counts three times.
    let c = -(&a + &b) / whole(3);
    let (ab, c2) = (&a * &b, c.pow(2));
    let e2 = &ab - whole(6) * &c2;
    let e3 = (whole(3) * &ab - whole(8) * &c2) * &c;
    let e4 = whole(3) * (&ab - &c2) * &c2;
    let e5 = &ab * &c2 * &c;
    let polynomial = t.pow(5) + e2 * t.pow(3) - e3 * t.pow(2) + e4 * &t - e5;
    same("five distances", &roots(&[&a, &b, &c, &c, &c]), &polynomial)?;
    let second: [Term; 12] = [
        (-3, 14, [1, 0, 0, 0]),
        (1, 6, [0, 1, 0, 0]),
        (9, 88, [2, 0, 0, 0]),
        (-3, 22, [0, 0, 1, 0]),
        (-9, 52, [1, 1, 0, 0]),
        (3, fifth_of_second, [0, 0, 0, 1]),
        (-1, 16, [3, 0, 0, 0]),
        (3, 40, [0, 2, 0, 0]),
        (3, 20, [1, 0, 1, 0]),
        (45, 272, [2, 1, 0, 0]),
        (-9, 68, [0, 1, 1, 0]),
        (-9, 68, [1, 0, 0, 1]),
    ];
    // Three halves of the integral of t^(-5/2 - n) from 1 on is 3/(2n + 3).
    is_inverse_root("R_D", 5, &second, |n| Fraction::ratio(i64::from(2 * n + 3), 3))
}

fn legendre(sign: i64, over: i64) -> Outcome {
    let [s, m, sin, cos, rate] = variables(["s", "m", "sin", "cos", "Delta"]);
    let (one, two) = (Fraction::one(), Fraction::from(2));
    let parameter = Polynomial::variable("m");
    let relations = Relations::new(vec![
        ("cos", Polynomial::one() - square("sin")),
        ("Delta", Polynomial::one() - &parameter * square("sin")),
    ])?;
    // From t = 0 at the angle with the sine s on to infinity at the angle zero.
    let t = s.pow(2) / sin.pow(2) - &one;
    let falls = -Derivation::new([("sin", cos.clone())]).of(&t);
    let under = [&one - s.pow(2), &one - &m * s.pow(2) * Fraction::from(sign), one.clone()];
    let roots = [&s * &cos / &sin, &s * &rate / &sin, &s / &sin];
    for ((under, root), of) in under.iter().zip(&roots).zip(["x", "y", "z"]) {
        same_under(&relations, &format!("t + {of}"), &(&t + under), &root.pow(2))?;
    }
    let product = &roots[0] * &roots[1] * &roots[2];
    let first = &s * &falls / (&two * &product);
    same_under(&relations, "the argument", &first, &(&one / &rate))?;
    let second =
        s.pow(3) / Fraction::from(over) * Fraction::ratio(3, 2) * &falls / (roots[1].pow(2) * &product);
    let by_parameter = Derivation::new([("Delta", -(sin.pow(2) / (&two * &rate)))]);
    same_under(&relations, "its derivative", &second, &by_parameter.of(&(&one / &rate)))?;
    // What is left to the quarter period: cn/dn, k' sn/dn and k'/dn are its three functions.
    let [sn, cn, dn, kp] = variables(["sn", "cn", "dn", "kp"]);
    let jacobi = Relations::new(vec![
        ("cn", Polynomial::one() - square("sn")),
        ("dn", Polynomial::one() - &parameter * square("sn")),
        ("kp", Polynomial::one() - parameter),
    ])?;
    let (far, fall) = (&cn / &dn, [&kp * &sn / &dn, &kp / &dn]);
    same_under(&jacobi, "the cosine of what is left", &fall[0].pow(2), &(&one - far.pow(2)))?;
    same_under(&jacobi, "its dn", &fall[1].pow(2), &(&one - &m * far.pow(2)))?;
    let by_argument = Derivation::elliptic(&one);
    same_under(&jacobi, "its rate", &by_argument.of(&far), &-(&fall[0] * &fall[1]))?;
    // The theta zero.
    let Motion { relations, zero: [beta, gamma, delta], .. } = motion(1, Change::None)?;
    let complement = beta.pow(2) * Fraction::variable("kp").pow(2);
    vanishes("the zero's cosine", &(beta.pow(2) + gamma.pow(2) - &one), &relations)?;
    vanishes("the zero's dn", &(delta.pow(2) + complement - one), &relations)
}
